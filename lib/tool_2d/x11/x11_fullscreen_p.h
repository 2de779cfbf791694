// SPDX-License-Identifier: MIT
// x11_fullscreen: a window that covers the whole screen.
#ifndef L3D_TOOL_2D_X11_X11_FULLSCREEN_P_H
#define L3D_TOOL_2D_X11_X11_FULLSCREEN_P_H

#include "tool_2d/x11/x11_window_p.h"

#include <chrono>

namespace l3d_detail {

/// Covers the screen with a window, and gives it back its old place.
///
/// A window manager that knows how is asked to; otherwise the window is moved and resized. While
/// it covers the screen, a pointer that rests is hidden.
/// Lives:   borrows the window.
class x11_fullscreen {
public:
    using clock = std::chrono::steady_clock;

    explicit x11_fullscreen(x11_window& window) : window_(window) {}

    bool is_on() const { return on_; }

    /// Cost:    a round trip or three.
    void set(bool on);

    /// Looks at an event: did the pointer move, or the manager change its mind?
    void take(const XEvent& event);

    /// Hides the pointer if it has not moved for two seconds. To be called now and then.
    void rest(clock::time_point now);

private:
    /// The atoms, which few windows ever need.
    struct names {
        Atom state = 0;
        Atom fullscreen = 0;
        Atom supported = 0;
    };

    void intern_names();
    bool has(Window window, Atom list, Atom wanted) const;
    void ask_manager(bool on) const;
    void cover();
    void set_on(bool on);
    void show_pointer();

    x11_window& window_;
    names names_;
    bool on_ = false;
    XWindowAttributes before_{}; ///< where the window was
    bool pointer_hidden_ = false;
    clock::time_point pointer_moved_;
};

} // namespace l3d_detail

#endif
