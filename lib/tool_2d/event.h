// SPDX-License-Identifier: MIT
// l3d_event and l3d_event_source: what happens to a window, without any window system's header.
#ifndef L3D_TOOL_2D_EVENT_H
#define L3D_TOOL_2D_EVENT_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <chrono>

/// Keys that have no printable character. Printable keys are their ASCII code.
enum l3d_key : int {
    l3d_key_backspace = 8,
    l3d_key_tab = 9,
    l3d_key_return = 13,
    l3d_key_escape = 27,
    l3d_key_left = 0x100,
    l3d_key_right,
    l3d_key_up,
    l3d_key_down,
    l3d_key_page_up,
    l3d_key_page_down,
    l3d_key_home,
    l3d_key_end,
    l3d_key_f1, ///< up to l3d_key_f1 + 9; F11 is the event `fullscreen`
};

/// The things that can happen to a window.
enum class L3D_PUBLIC l3d_event_type {
    key_press,      ///< a key went down
    key_release,    ///< a key came up
    button_press,   ///< a button of the mouse went down
    button_release, ///< a button of the mouse came up
    pointer_motion, ///< the pointer has moved
    wheel,          ///< the wheel turned by one notch
    resize,         ///< the picture, or l3d_screen::text_scale, has another size now
    expose,       ///< part of the window can be seen and lost its picture: it has to be shown again
    hide,         ///< nothing of the window can be seen until the next expose or reveal
    reveal,       ///< part of the window can be seen again; if it lost its picture, expose follows
    fullscreen,   ///< the user wants the whole display, or no longer: F11, Alt+Enter
    close,        ///< the user wants the end, or somebody destroyed the window
    display_lost, ///< the display went away; nothing can be shown any more
};

/// One event. Fields that do not belong to the type are zero.
struct L3D_PUBLIC l3d_event {
    l3d_event_type type{}; ///< what happened
    int key = 0;           ///< key_*: ASCII code or l3d_key
    int button = 0;        ///< button_*: 1 left, 2 middle, 3 right; pointer_motion: the button held
    int x = 0, y = 0;      ///< key_*, button_*, pointer_motion, wheel: the pointer, in pixels
    l3d_size size{};       ///< resize
    int notches = 0;       ///< wheel: +1 away from the user, -1 towards
    int clicks = 0; ///< button_press: 2 if it followed another one soon at the same place, else 1
    bool shift = false;   ///< key_press, button_*, pointer_motion, wheel: the key Shift was held
    bool control = false; ///< the same for the key Ctrl
    bool alt = false;     ///< the same for the key Alt
    bool logo = false;    ///< the same for the key with the sign of a system or a maker
};

/// A thing a dispatcher can pull events from (the book's marker class, given its two calls).
class L3D_PUBLIC l3d_event_source {
public:
    l3d_event_source() = default;
    l3d_event_source(const l3d_event_source&) = delete;
    l3d_event_source& operator=(const l3d_event_source&) = delete;
    virtual ~l3d_event_source() = default;

    /// Takes the next pending event without waiting; false if there is none.
    bool next_event(l3d_event& event) { return do_next_event(event); }

    /// Sleeps until an event is pending or the time is over, whichever is first. It may wake up
    /// earlier. Something to read in the file `waker` wakes it, too, unless that is -1.
    void wait(std::chrono::nanoseconds longest, int waker = -1) { do_wait(longest, waker); }

private:
    virtual bool do_next_event(l3d_event& event) = 0;
    virtual void do_wait(std::chrono::nanoseconds longest, int waker) = 0;
};

#endif
