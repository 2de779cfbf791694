// SPDX-License-Identifier: MIT
// x11_events: turns X events into l3d_events.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_EVENTS_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_EVENTS_P_H

#include "tool_2d/event.h"
#include "tool_2d/x11_window/x11_echo_p.h"
#include "tool_2d/x11_window/x11_pointer_p.h"
#include "tool_2d/x11_window/x11_keys_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <array>
#include <deque>
#include <initializer_list>
#include <vector>

namespace l3d_detail {

/// Translates the events of one window and keeps them until they are asked for.
///
/// It keeps only the latest of some events: the size, the window's visibility, a lost picture, and
/// the pointer's place until something else happens. Every key whose press is reported is also
/// reported as released, when the window loses the keyboard at the latest.
///
/// Xlib reads the keymap when it looks up the first key, and after each change. Xlib then waits for
/// the server, and does not notice a first signal. So the keymap is read right after an answer of
/// the server, and later events of the user wait for this answer.
class x11_events {
public:
    /// `size` is the window's first size.
    x11_events(const x11_window& window, l3d_size size, x11_pointer& pointer)
        : window_(window), size_(size), pointer_(pointer), keyboard_echo_(window) {}

    /// Translates one event. A ping of the window manager is answered here.
    void take(XEvent& event);

    /// Has the keymap read early, so that the first key need not wait. Call it after the first
    /// picture.
    void want_keyboard();

    /// Asks for an answer of the server if the keymap has to be read. Call it now and then.
    void look_after();

    /// Notes that a fine wheel turned with the pointer at this place.
    void take_turn(const XMotionEvent& place, double notches);

    /// Adds the last event of all: the server is gone.
    void take_display_lost() { push({.type = l3d_event_type::display_lost}); }

    /// Notes whether the window is out of sight for a reason that its events do not tell.
    void set_away(bool away) {
        away_ = away;
        look();
    }

    /// Tells the size again, although it has not changed.
    void tell_size() {
        push_instead_of({l3d_event_type::resize}, {.type = l3d_event_type::resize, .size = size_});
    }

    bool empty() const { return queue_.empty(); }

    /// Whether the oldest event is about fullscreen: the event `fullscreen`, or the key Escape,
    /// whose action depends on whether the window covers the screen. Expects: !empty().
    bool is_about_fullscreen() const {
        const l3d_event& oldest = queue_.front();
        return oldest.type == l3d_event_type::fullscreen ||
               (oldest.type == l3d_event_type::key_press && oldest.key == l3d_key_escape);
    }

    /// Whether a waiting event, here or at Xlib, asks for the window to be closed. No event is
    /// taken.
    bool has_close();

    /// Takes the oldest event; false if there is none.
    bool next(l3d_event& event);

    bool is_mapped() const { return mapped_; }
    bool was_exposed() const { return exposed_; }

private:
    void push(const l3d_event& event) { queue_.push_back(event); }
    void push_instead_of(std::initializer_list<l3d_event_type> types, const l3d_event& event);
    void look();
    void take_now(XEvent& event);
    bool waits_for_keyboard(const XEvent& event) const;
    void read_keyboard();
    void take_size(const XConfigureEvent& event);
    void take_press(XKeyEvent& event);
    void take_release(const XKeyEvent& event);
    void take_focus(const XFocusChangeEvent& event);
    void release_all();
    void take_button(const XButtonEvent& event, l3d_event_type type);
    void push_turn(l3d_event event, double notches);
    int clicks_of(const XButtonEvent& press);
    void take_motion(const XMotionEvent& event);
    std::chrono::milliseconds since_start(Time time);
    template <class Event> l3d_event at(const Event& event);
    void take_message(XClientMessageEvent& event);
    bool is_autorepeat(const XKeyEvent& release) const;

    const x11_window& window_;
    l3d_size size_; ///< the window's size, as the server told it
    x11_pointer& pointer_;
    x11_text text_;
    std::deque<l3d_event> queue_;
    bool mapped_ = false, exposed_ = false;
    x11_echo keyboard_echo_; ///< its answer says that the keyboard can be read
    bool keyboard_is_due_ = false, keyboard_was_wanted_ = false;
    std::vector<XEvent> waiting_; ///< events that wait for the keymap: its change, and all after it
    bool covered_ = false, unmapped_ = false, away_ = false;
    Time turned_at_ = 0;           ///< time at which a fine wheel last turned
    double turned_ = 0;            ///< notches that the wheel turned since its last full notch
    bool hidden_ = false;          ///< whether the program was last told of hide
    bool exposure_is_due_ = false; ///< expose is told as soon as the window can be seen
    /// For each key code, the key whose press was told; 0: the key is up.
    std::array<int, 256> held_{};
    std::chrono::milliseconds time_{}; ///< time of the last event that had one; 0: none had
    XButtonEvent last_press_{}; ///< the last press, which may become a double click; button 0: none
};

} // namespace l3d_detail

#endif
