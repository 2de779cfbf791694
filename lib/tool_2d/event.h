// SPDX-License-Identifier: MIT
// l3d_event and l3d_event_source: what happens to a window, without any window system's header.
#ifndef L3D_TOOL_2D_EVENT_H
#define L3D_TOOL_2D_EVENT_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <chrono>
#include <string>

/// Keys that have no printable character. Printable keys are their ASCII code.
enum l3d_key : int {
    l3d_key_backspace = 8,
    l3d_key_tab = 9,
    l3d_key_return = 13,
    l3d_key_escape = 27,
    l3d_key_delete = 127,
    l3d_key_left = 0x100,
    l3d_key_right,
    l3d_key_up,
    l3d_key_down,
    l3d_key_page_up,
    l3d_key_page_down,
    l3d_key_home,
    l3d_key_end,
    l3d_key_f1, ///< up to l3d_key_f1 + 9; F11 is the event `fullscreen`
    l3d_key_insert = l3d_key_f1 + 10,
    l3d_key_shift,   ///< either of them, alone; only l3d_pipeline::any_event tells of it
    l3d_key_control, ///< likewise
    l3d_key_alt,     ///< likewise
};

/// The things that can happen to a window.
enum class L3D_PUBLIC l3d_event_type {
    /// A key went down.
    key_press,
    /// A key came up.
    key_release,
    /// A button of the mouse went down.
    button_press,
    /// A button of the mouse came up.
    button_release,
    /// The pointer has moved, with a button held unless l3d_screen::set_pointer asked for more.
    pointer_motion,
    /// The wheel turned.
    wheel,
    /// The picture, or l3d_screen::text_scale, has another size now.
    resize,
    /// Part of the window can be seen and lost its picture: it has to be shown again.
    expose,
    /// Nothing of the window can be seen until the next expose or reveal.
    hide,
    /// Part of the window can be seen again. If it lost its picture, expose follows.
    reveal,
    /// The user wants the whole display, or no longer: F11, Alt+Enter.
    fullscreen,
    /// The user wants the end, or somebody destroyed the window.
    close,
    /// The display went away; nothing can be shown any more.
    display_lost,
};

/// One event. Fields that do not belong to the type are zero.
struct L3D_PUBLIC l3d_event {
    /// The kind of event.
    l3d_event_type type{};
    /// key_*: the key's ASCII code or l3d_key. 0 for a key that only types, as a letter of another
    /// script may; it comes without a release.
    int key = 0;
    /// button_*: 1 left, 2 middle, 3 right. pointer_motion: the button that is held, 0 for none.
    int button = 0;
    /// key_*, button_*, pointer_motion, wheel: the pointer's column, in pixels.
    int x = 0;
    /// The pointer's row, for the same types.
    int y = 0;
    /// resize: the new size.
    l3d_size size{};
    /// wheel: its turn in notches, positive away from the user. Fine wheels and touchpads turn by
    /// parts of a notch.
    double turn = 0;
    /// wheel: the notches that are full now, for programs that count whole steps; 0 while a fine
    /// wheel is on its way to the next.
    int notches = 0;
    /// button_press: 2 if another one came shortly before at the same place, else 1.
    int clicks = 0;
    /// key_*, button_*, pointer_motion, wheel: the key Shift was held before.
    bool shift = false;
    /// The key Ctrl was held, for the same types.
    bool control = false;
    /// The key Alt was held, for the same types.
    bool alt = false;
    /// The key with the sign of a system or a maker was held, for the same types.
    bool logo = false;
    /// key_press: the key was down already, and repeats.
    bool repeat = false;
    /// key_press: the text that it types, in UTF-8; empty for keys that type nothing, and with
    /// Ctrl, Alt or the logo. A dead key types nothing itself, and changes the next one's text.
    std::string text{};
    /// pointer_motion: how far a held pointer has moved to the right since the last such event;
    /// 0 if the pointer is not held. Units: pixels.
    double right = 0;
    /// pointer_motion: the held pointer's way downwards, likewise.
    double down = 0;
    /// key_*, button_*, pointer_motion, wheel: when it happened, since some moment of the display.
    std::chrono::milliseconds time{};
};

/// A thing that a dispatcher pulls events from.
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
