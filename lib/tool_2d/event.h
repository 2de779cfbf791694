// SPDX-License-Identifier: MIT
// l3d_event and l3d_event_source: what happens to a window, without any window system's header.
#ifndef L3D_TOOL_2D_EVENT_H
#define L3D_TOOL_2D_EVENT_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <chrono>
#include <string>

/// Keys that have no printable character. The number of a printable key is its ASCII code.
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
    l3d_key_f1, ///< F1; F2 to F10 have the next numbers, F11 is the event `fullscreen`
    l3d_key_insert = l3d_key_f1 + 10,
    l3d_key_shift,   ///< either Shift key, alone; only l3d_pipeline::any_event tells of it
    l3d_key_control, ///< either Control key, told as l3d_key_shift is
    l3d_key_alt,     ///< either Alt key, told as l3d_key_shift is
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
    /// The pointer moved while a button was held, or at any time if l3d_screen::set_pointer asked
    /// for all motion.
    pointer_motion,
    /// The wheel turned.
    wheel,
    /// The picture has a new size, or l3d_screen::text_scale has changed.
    resize,
    /// A visible part of the window lost its picture. The picture has to be shown again.
    expose,
    /// Nothing of the window can be seen until the next expose or reveal.
    hide,
    /// Part of the window can be seen again. If that part lost its picture, expose follows.
    reveal,
    /// The user wants the window to cover the whole display, or to cover it no longer: F11,
    /// Alt+Enter.
    fullscreen,
    /// The user wants the program to end, or somebody destroyed the window.
    close,
    /// The display went away; nothing can be shown any more.
    display_lost,
};

/// One event. Fields that do not belong to the type are zero.
struct L3D_PUBLIC l3d_event {
    /// The kind of event.
    l3d_event_type type{};
    /// key_*: the key's ASCII code or l3d_key. A press that only types text, such as a letter of
    /// another script, has 0, and no release follows it.
    int key = 0;
    /// button_*: 1 left, 2 middle, 3 right. pointer_motion: the button that is held, 0 for none.
    int button = 0;
    /// key_*, button_*, pointer_motion, wheel: the pointer's column, in pixels.
    int x = 0;
    /// key_*, button_*, pointer_motion, wheel: the pointer's row, in pixels.
    int y = 0;
    /// resize: the new size of the picture.
    l3d_size size{};
    /// wheel: how far the wheel turned, in notches; positive away from the user. Fine wheels and
    /// touchpads turn by parts of a notch.
    double turn = 0;
    /// wheel: the whole notches that this turn completes, for programs that count steps. The number
    /// is 0 while a fine wheel is on its way to the next notch.
    int notches = 0;
    /// button_press: 2 for the second press of a double click, else 1.
    int clicks = 0;
    /// key_*, button_*, pointer_motion, wheel: whether Shift was held just before the event.
    bool shift = false;
    /// key_*, button_*, pointer_motion, wheel: whether Ctrl was held just before the event.
    bool control = false;
    /// key_*, button_*, pointer_motion, wheel: whether Alt was held just before the event.
    bool alt = false;
    /// key_*, button_*, pointer_motion, wheel: whether the key with the sign of a system or a maker
    /// was held just before the event.
    bool logo = false;
    /// key_press: whether the key was down already, and repeats.
    bool repeat = false;
    /// key_press: the text that the key types, in UTF-8. The text is empty with Ctrl, Alt or the
    /// logo key, and for keys that type nothing. A dead key types nothing itself, but changes the
    /// text of the next key.
    std::string text{};
    /// pointer_motion: how far a held pointer has moved to the right since the last pointer_motion;
    /// 0 if the pointer is not held. Units: pixels.
    double right = 0;
    /// pointer_motion: how far a held pointer has moved down since the last pointer_motion; 0 if
    /// the pointer is not held. Units: pixels.
    double down = 0;
    /// key_*, button_*, pointer_motion, wheel: the time of the event by the display's clock, whose
    /// zero is an arbitrary moment.
    std::chrono::milliseconds time{};
};

/// A source of events, such as a screen, from which a dispatcher takes events.
class L3D_PUBLIC l3d_event_source {
public:
    l3d_event_source() = default;
    l3d_event_source(const l3d_event_source&) = delete;
    l3d_event_source& operator=(const l3d_event_source&) = delete;
    virtual ~l3d_event_source() = default;

    /// Takes the next pending event without waiting; false if there is none.
    bool next_event(l3d_event& event) { return do_next_event(event); }

    /// Sleeps until an event is pending or the time is over, whichever is first. The sleep may end
    /// earlier. The sleep also ends when data can be read from the file descriptor `waker`; -1
    /// stands for no file.
    void wait(std::chrono::nanoseconds longest, int waker = -1) { do_wait(longest, waker); }

private:
    virtual bool do_next_event(l3d_event& event) = 0;
    virtual void do_wait(std::chrono::nanoseconds longest, int waker) = 0;
};

#endif
