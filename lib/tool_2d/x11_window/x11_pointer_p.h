// SPDX-License-Identifier: MIT
// x11_pointer: the motion that a program hears of, and a pointer that it holds.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_POINTER_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_POINTER_P_H

#include "tool_2d/screen.h"
#include "tool_2d/x11_window/x11_echo_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <chrono>
#include <optional>

#include <xcb/xcb.h>

namespace l3d_detail {

/// How far the pointer moved to the right and down. Units: pixels of the program.
struct x11_way {
    double right = 0, down = 0;
};

/// Holds the pointer for a program that wants it, as long as the window has the keyboard.
///
/// A held pointer is put back to the window's middle whenever it comes far from the middle, so that
/// it can move without end. X tells only places. The program gets the differences of places,
/// without the leaps back. Holding also works on servers over a network or nested in others.
/// Lives:   borrows the window.
/// Cost:    nothing waits for an answer; a leap every quarter of a window.
class x11_pointer {
public:
    using clock = std::chrono::steady_clock;

    /// `native` is the size that the window was made with.
    x11_pointer(x11_window& window, l3d_size native);
    x11_pointer(const x11_pointer&) = delete;
    x11_pointer& operator=(const x11_pointer&) = delete;
    ~x11_pointer();

    /// Chooses the motion that the program hears of.
    void set(l3d_pointer how);
    l3d_pointer how() const { return how_; }

    /// Notes whether the window has the keyboard.
    void set_focus(bool has_focus);

    /// Notes the window's size. Units: display pixels.
    void set_size(l3d_size native) { size_ = native; }

    /// Asks the server to hold the pointer if this is due. Call it now and then.
    void look_after();

    /// True if the event was the server's answer to a request of look_after().
    bool take(const XEvent& event);

    /// How far this event moved a held pointer. Zero if the pointer is not held. `nullopt` if a
    /// held pointer did not move, was only put back, or has no known earlier place.
    std::optional<x11_way> way_of(const XMotionEvent& event);

private:
    struct place {
        int x, y;
    };

    place middle() const { return {size_.width / 2, size_.height / 2}; }
    bool wants_it() const { return how_ == l3d_pointer::held && has_focus_; }
    void release();
    void put_back();
    bool has_leapt_to(const place& now) const;

    x11_window& window_;
    xcb_connection_t* xcb_;
    x11_echo echo_;
    l3d_pointer how_ = l3d_pointer::dragged;
    l3d_size size_;
    Cursor cursor_ = 0; ///< a cursor without a pixel; 0 until it is needed
    bool has_focus_ = false;
    bool is_held_ = false;
    xcb_grab_pointer_cookie_t asked_{};
    clock::time_point next_try_{};
    /// The request that put the pointer back; 0: the pointer has arrived.
    unsigned long leap_ = 0;
    std::optional<place> last_; ///< a held pointer's last place; nothing before its first motion
};

} // namespace l3d_detail

#endif
