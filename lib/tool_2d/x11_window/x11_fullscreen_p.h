// SPDX-License-Identifier: MIT
// x11_fullscreen: a window that covers the whole screen.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_FULLSCREEN_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_FULLSCREEN_P_H

#include "tool_2d/x11_window/x11_wm_facts_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <chrono>
#include <optional>

namespace l3d_detail {

/// Covers the screen with a window, or gives the window its old place back.
///
/// If there is a window manager that can cover the screen, the class asks this manager. Otherwise
/// the window covers the monitor that it is on. The state that the manager reports counts, whoever
/// asked for this state. A new manager takes over, and a manager that ends leaves the window as it
/// is. While the window covers the screen, a resting pointer is hidden.
/// Lives:   borrows window and state.
class x11_fullscreen {
public:
    using clock = std::chrono::steady_clock;

    /// `native` is the size that the window was made with.
    x11_fullscreen(x11_window& window, x11_wm_facts& state, l3d_size native)
        : window_(window), state_(state), place_{0, 0, native.width, native.height} {}

    /// Whether the window covers the screen, or will once all requests are done.
    bool is_on() const;

    /// Asks for the window to cover the screen, or to cover it no longer. The change begins as soon
    /// as the window's state is known.
    void set(bool on);

    /// Takes note of an event about our window, if the pointer or the window has moved.
    void take(const XEvent& event);

    /// Follows the window's state, which may have changed.
    void follow();

    /// Hides the pointer if it has not moved for two seconds. Call it now and then.
    void rest(clock::time_point now);

    /// The time at which rest() has something to do; never, if the pointer need not be hidden.
    clock::time_point next_rest() const;

private:
    void act(bool on);
    void ask_manager(bool on);
    void cover();
    void uncover();
    void move(const l3d_pixel_box& place) const;
    l3d_pixel_box monitor() const;
    void take_place(const XConfigureEvent& event);
    void show_pointer();

    x11_window& window_;
    x11_wm_facts& state_;

    /// The state that set() asked for, until it is reached.
    std::optional<bool> wanted_;

    /// The request to the manager, and the time until which we wait for its answer. A manager may
    /// refuse without telling.
    std::optional<bool> awaited_;
    clock::time_point awaited_until_;

    /// Whether the window covers the screen.
    bool on_ = false;

    /// Whether a manager made the window cover the screen, or would do so, at our last look.
    bool granted_ = false;

    /// Whether we made the window cover the screen ourselves.
    bool covers_ = false;

    /// The window's place when it does not cover the screen.
    l3d_pixel_box place_;

    /// The place that covers the screen.
    l3d_pixel_box asked_{};

    /// Whether asked_ was corrected by the offset of a manager's frame.
    bool is_corrected_ = false;

    bool pointer_hidden_ = false;
    clock::time_point pointer_moved_;
};

} // namespace l3d_detail

#endif
