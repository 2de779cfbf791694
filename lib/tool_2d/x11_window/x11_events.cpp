// SPDX-License-Identifier: MIT
// x11_events: turns X's events of keys, the pointer and the window into ours.
#include "tool_2d/x11_window/x11_events_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

#include <X11/XKBlib.h>
#include <X11/Xutil.h>
#include <X11/keysym.h>

namespace l3d_detail {
namespace {

/// The value in held_ for a key that is not told to the program.
constexpr int untold = -1;

bool is_fullscreen_key(const XKeyEvent& event, KeySym keysym, int key) {
    return keysym == XK_F11 || (key == l3d_key_return && (event.state & Mod1Mask) != 0);
}

void take_modifiers(unsigned state, l3d_event& event) {
    event.shift = (state & ShiftMask) != 0;
    event.control = (state & ControlMask) != 0;
    event.alt = (state & Mod1Mask) != 0;
    event.logo = (state & Mod4Mask) != 0;
}

int held_button(unsigned state) {
    if ((state & Button1Mask) != 0)
        return 1;
    if ((state & Button2Mask) != 0)
        return 2;
    return (state & Button3Mask) != 0 ? 3 : 0;
}

} // namespace

void x11_events::take(XEvent& event) {
    if (keyboard_echo_.take(event))
        return read_keyboard();
    if (event.type == MappingNotify && !keyboard_echo_.is_awaited())
        keyboard_is_due_ = true;
    if (waits_for_keyboard(event))
        waiting_.push_back(event);
    else
        take_now(event);
}

/// Whether an event has to wait for the keymap, so that the user's events keep their order.
bool x11_events::waits_for_keyboard(const XEvent& event) const {
    switch (event.type) {
    case MappingNotify:
        return true;
    case KeyPress:
    case KeyRelease:
    case ButtonPress:
    case ButtonRelease:
    case MotionNotify:
    case FocusIn:
    case FocusOut:
        return !waiting_.empty();
    default:
        return false;
    }
}

void x11_events::take_now(XEvent& event) {
    switch (event.type) {
    case KeyPress:
        return take_press(event.xkey);
    case KeyRelease:
        return take_release(event.xkey);
    case FocusIn:
    case FocusOut:
        return take_focus(event.xfocus);
    case ButtonPress:
        return take_button(event.xbutton, l3d_event_type::button_press);
    case ButtonRelease:
        return take_button(event.xbutton, l3d_event_type::button_release);
    case MotionNotify:
        return take_motion(event.xmotion);
    case ClientMessage:
        return take_message(event.xclient);
    case ConfigureNotify:
        return take_size(event.xconfigure);
    case Expose:
        if (event.xexpose.count != 0)
            return;
        exposed_ = exposure_is_due_ = true;
        covered_ = false;
        return look();
    case VisibilityNotify:
        covered_ = event.xvisibility.state == VisibilityFullyObscured;
        return look();
    case MapNotify:
        mapped_ = true;
        unmapped_ = false;
        return look();
    case UnmapNotify:
        unmapped_ = true;
        return look();
    case DestroyNotify:
        return push({.type = l3d_event_type::close});
    case MappingNotify:
        XRefreshKeyboardMapping(&event.xmapping);
        return;
    default:
        return;
    }
}

void x11_events::want_keyboard() {
    if (!std::exchange(keyboard_was_wanted_, true))
        keyboard_is_due_ = true;
}

void x11_events::look_after() {
    if (!keyboard_is_due_ || window_.connection().lost() || !window_.connection().wait_writable({}))
        return;
    keyboard_is_due_ = false;
    keyboard_echo_.ask();
}

void x11_events::read_keyboard() {
    if (window_.connection().lost())
        return;
    // Without this, a held key looks like one that is pressed again and again.
    XkbSetDetectableAutoRepeat(window_.display(), True, nullptr);
    for (XEvent& event : std::exchange(waiting_, {})) {
        if (window_.connection().lost())
            return;
        take_now(event);
    }
    if (!window_.connection().lost())
        XkbKeycodeToKeysym(window_.display(), 0, 0, 0);
}

bool x11_events::next(l3d_event& event) {
    if (queue_.empty())
        return false;
    event = queue_.front();
    queue_.pop_front();
    return true;
}

/// Adds an event and removes earlier events of these types, since the latest event is enough.
void x11_events::push_instead_of(std::initializer_list<l3d_event_type> types,
                                 const l3d_event& event) {
    std::erase_if(queue_, [types](const l3d_event& earlier) {
        return std::ranges::find(types, earlier.type) != types.end();
    });
    push(event);
}

/// Tells of a change of the window's visibility. When the window can be seen again, a server that
/// kept the covered pixels sends no expose event.
void x11_events::look() {
    const bool hidden = covered_ || unmapped_ || away_;
    constexpr auto hide = l3d_event_type::hide, reveal = l3d_event_type::reveal;
    if (std::exchange(hidden_, hidden) != hidden)
        push_instead_of({hide, reveal}, {.type = hidden ? hide : reveal});
    if (!hidden && std::exchange(exposure_is_due_, false))
        push_instead_of({l3d_event_type::expose, hide, reveal}, {.type = l3d_event_type::expose});
}

/// Takes a new size. Only the server itself tells of new sizes. Events that other clients send tell
/// of places; the size in these events may be anything.
void x11_events::take_size(const XConfigureEvent& event) {
    if (event.send_event == 0) {
        size_ = window_.ours({event.width, event.height});
        pointer_.set_size({event.width, event.height});
    }
    tell_size();
}

/// The server's time, as a number that does not overflow. X counts milliseconds in 32 bits, which
/// overflow after 49.7 days. Programs may send events without a time.
std::chrono::milliseconds x11_events::since_start(Time time) {
    const auto now = static_cast<std::uint32_t>(time);
    if (time_.count() == 0)
        time_ = std::chrono::milliseconds(now);
    else if (now != CurrentTime)
        time_ += std::chrono::milliseconds(
            static_cast<std::int32_t>(now - static_cast<std::uint32_t>(time_.count())));
    return time_;
}

/// Begins an event with the fields that all events of a user have.
template <class Event> l3d_event x11_events::at(const Event& event) {
    l3d_event ours{.x = window_.ours(event.x), .y = window_.ours(event.y)};
    ours.time = since_start(event.time);
    take_modifiers(event.state, ours);
    return ours;
}

/// Takes a change of the keyboard's focus. Events about the focus that follows the pointer do not
/// count.
void x11_events::take_focus(const XFocusChangeEvent& event) {
    if (event.detail == NotifyPointer || event.detail == NotifyInferior)
        return;
    pointer_.set_focus(event.type == FocusIn);
    if (event.type == FocusOut)
        release_all();
}

void x11_events::take_press(XKeyEvent& event) {
    const int key = key_of(event);
    int& held = held_.at(event.keycode & 255);
    if (is_fullscreen_key(event, XLookupKeysym(&event, 0), key)) {
        if (std::exchange(held, untold) == 0)
            push({.type = l3d_event_type::fullscreen});
        return;
    }
    l3d_event press = at(event);
    press.type = l3d_event_type::key_press;
    press.key = key;
    press.text = text_.typed(event);
    if (key == 0 && press.text.empty())
        return;
    press.repeat = std::exchange(held, key == 0 ? untold : key) != 0;
    push(press);
}

/// Releases the key that was pressed, whatever modifiers are held at its release.
void x11_events::take_release(const XKeyEvent& event) {
    if (is_autorepeat(event))
        return;
    const int key = std::exchange(held_.at(event.keycode & 255), 0);
    if (key == 0 || key == untold)
        return;
    l3d_event release = at(event);
    release.type = l3d_event_type::key_release;
    release.key = key;
    push(release);
}

/// Releases all held keys, as without the keyboard's focus we do not hear of their releases.
void x11_events::release_all() {
    for (int& held : held_)
        if (const int key = std::exchange(held, 0); key != 0 && key != untold) {
            l3d_event release{.type = l3d_event_type::key_release, .key = key};
            release.time = time_;
            push(release);
        }
}

/// Whether a release belongs to a repeated press. Servers without detectable autorepeat give both
/// the release and the next press the same time.
bool x11_events::is_autorepeat(const XKeyEvent& release) const {
    if (XEventsQueued(window_.display(), QueuedAfterReading) == 0)
        return false;
    XEvent next;
    XPeekEvent(window_.display(), &next);
    return next.type == KeyPress && next.xkey.keycode == release.keycode &&
           next.xkey.time == release.time;
}

void x11_events::take_button(const XButtonEvent& event, l3d_event_type type) {
    // X has no wheel: a notch is a click of button 4 or 5. Higher numbers are sideways wheels.
    l3d_event ours = at(event);
    ours.type = type;
    const bool is_press = type == l3d_event_type::button_press;
    if (event.button == Button4 || event.button == Button5) {
        // For each full notch of a fine wheel, the server also makes a click at the same time.
        if (is_press && (turned_at_ == 0 || event.time != turned_at_))
            push_turn(ours, event.button == Button4 ? 1 : -1);
    } else if (event.button <= Button3) {
        ours.button = static_cast<int>(event.button);
        ours.clicks = is_press ? clicks_of(event) : 0;
        push(ours);
    }
}

void x11_events::take_turn(const XMotionEvent& place, double notches) {
    const l3d_event ours = at(place);
    turned_at_ = place.time;
    push_turn(ours, notches);
}

void x11_events::push_turn(l3d_event event, double notches) {
    event.type = l3d_event_type::wheel;
    event.turn = notches;
    turned_ += notches;
    // Ten tenths of a notch count as one despite rounding.
    constexpr double nothing = 1e-6;
    event.notches = static_cast<int>(turned_ + std::copysign(nothing, turned_));
    turned_ -= event.notches;
    push(event);
}

/// The number of clicks that a press ends, 1 or 2, by the server's clock. Desktops take clicks
/// within 400 ms and 4 pixels for a double click. A third click begins anew.
int x11_events::clicks_of(const XButtonEvent& press) {
    constexpr Time soon = 400;
    constexpr int near = 4;
    const bool is_second =
        press.button == last_press_.button && press.time - last_press_.time <= soon &&
        std::abs(press.x - last_press_.x) <= near && std::abs(press.y - last_press_.y) <= near;
    last_press_ = is_second ? XButtonEvent{} : press;
    return is_second ? 2 : 1;
}

void x11_events::take_motion(const XMotionEvent& event) {
    const auto way = pointer_.way_of(event);
    const int button = held_button(event.state);
    if (!way || (button == 0 && pointer_.how() == l3d_pointer::dragged))
        return;
    l3d_event motion = at(event);
    motion.type = l3d_event_type::pointer_motion;
    motion.button = button;
    motion.right = way->right;
    motion.down = way->down;
    if (!queue_.empty() && queue_.back().type == motion.type &&
        queue_.back().button == motion.button) {
        motion.right += queue_.back().right;
        motion.down += queue_.back().down;
        queue_.back() = motion;
    } else {
        push(motion);
    }
}

bool x11_events::has_close() {
    const auto is_close = [](const l3d_event& event) {
        return event.type == l3d_event_type::close || event.type == l3d_event_type::display_lost;
    };
    if (std::ranges::any_of(queue_, is_close))
        return true;
    // Xlib shows the waiting events to a function that may choose one. This one only looks, and
    // chooses none.
    struct question {
        Window window;
        Atom message, protocol;
        bool found;
    } close{window_.id(), window_.atoms().wm_protocols, window_.atoms().wm_delete_window, false};
    const auto look = [](Display*, XEvent* event, XPointer context) -> Bool {
        question& asked = *reinterpret_cast<question*>(context);
        // A manager that ends takes its own window with it, whose events come here, too.
        asked.found |= event->type == DestroyNotify && event->xany.window == asked.window;
        asked.found |= event->type == ClientMessage && event->xclient.format == 32 &&
                       event->xclient.message_type == asked.message &&
                       static_cast<Atom>(event->xclient.data.l[0]) == asked.protocol;
        return False;
    };
    XEvent none;
    XCheckIfEvent(window_.display(), &none, look, reinterpret_cast<XPointer>(&close));
    return close.found;
}

void x11_events::take_message(XClientMessageEvent& event) {
    const auto& atoms = window_.atoms();
    if (event.message_type != atoms.wm_protocols || event.format != 32)
        return;
    const auto protocol = static_cast<Atom>(event.data.l[0]);
    if (protocol == atoms.wm_delete_window) {
        push({.type = l3d_event_type::close});
    } else if (protocol == atoms.net_wm_ping) {
        // The same event, sent back to the root, tells that the program is alive.
        const auto root = window_.connection().root();
        event.window = root;
        XSendEvent(window_.display(), root, False,
                   SubstructureNotifyMask | SubstructureRedirectMask,
                   reinterpret_cast<XEvent*>(&event));
    }
}

} // namespace l3d_detail
