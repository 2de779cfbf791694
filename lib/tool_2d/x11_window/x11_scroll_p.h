// SPDX-License-Identifier: MIT
// x11_scroll: wheels and touchpads that turn by less than a notch.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_SCROLL_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_SCROLL_P_H

#include "tool_2d/x11_window/x11_echo_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include <xcb/xinput.h>

namespace l3d_detail {

/// A turn of a fine wheel.
struct x11_turn {
    XMotionEvent motion; ///< the pointer's place, time and modifiers, as in an event of X
    double notches = 0;  ///< notches away from the user; 0: only the pointer moved
};

/// The fine wheels of a display, by XInput 2.1.
///
/// X counts how far each wheel has turned since it was plugged in. We ask for these numbers after
/// the first picture, and listen only if there is a fine wheel. From then on the server tells each
/// motion of the pointer over the window. Without the extension nothing changes, and wheels are
/// buttons 4 and 5.
/// Lives:   the window outlives the object.
/// Cost:    nothing waits for an answer; requests are sent only while the connection has room.
class x11_scroll {
public:
    explicit x11_scroll(const x11_window& window);

    /// Asks the server about wheels, step by step. Call it now and then once there is a picture.
    void look_after();

    /// Returns the motion or turn that an event tells of; nothing if the event tells of neither.
    std::optional<x11_turn> take(XEvent& event);

private:
    enum class stage { unasked, searching, asking, watching };

    /// A wheel's name: the wheel's device, and the wheel's number in this device.
    using name = std::pair<std::uint16_t, std::uint16_t>;
    struct wheel {
        double increment = 0; ///< the length of a notch; 0: the axis is no wheel
        /// The wheel's position; nothing after the pointer was elsewhere.
        std::optional<double> last;
    };

    void proceed();
    void ask();
    void hear();
    void select(std::uint8_t mask);
    void add_wheels(const xcb_input_xi_device_info_t& device);
    x11_turn take_motion(const xcb_input_motion_event_t& event);

    const x11_window& window_;
    xcb_connection_t* xcb_;
    x11_echo echo_;
    stage stage_ = stage::unasked;
    bool is_due_ = true;
    std::uint8_t opcode_ = 0; ///< the extension's number; 0: the server has no such extension
    xcb_input_xi_query_device_cookie_t devices_{};
    std::uint8_t mask_ = 0; ///< the events that we listen to
    std::map<name, wheel> wheels_;
};

} // namespace l3d_detail

#endif
