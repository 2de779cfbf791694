// SPDX-License-Identifier: MIT
// x11_events: keys, pointer, window.
#include "tool_2d/x11_events_p.h"

#include <algorithm>
#include <array>
#include <utility>

#include <X11/Xutil.h>
#include <X11/keysym.h>

namespace l3d_detail {
namespace {

constexpr std::array<std::pair<KeySym, int>, 22> named_keys{{
    {XK_BackSpace, l3d_key_backspace},
    {XK_Tab, l3d_key_tab},
    {XK_Return, l3d_key_return},
    {XK_KP_Enter, l3d_key_return},
    {XK_Escape, l3d_key_escape},
    {XK_Left, l3d_key_left},
    {XK_Right, l3d_key_right},
    {XK_Up, l3d_key_up},
    {XK_Down, l3d_key_down},
    {XK_Page_Up, l3d_key_page_up},
    {XK_Page_Down, l3d_key_page_down},
    {XK_Home, l3d_key_home},
    {XK_End, l3d_key_end},
    {XK_KP_Left, l3d_key_left},
    {XK_KP_Right, l3d_key_right},
    {XK_KP_Up, l3d_key_up},
    {XK_KP_Down, l3d_key_down},
    {XK_KP_Page_Up, l3d_key_page_up},
    {XK_KP_Page_Down, l3d_key_page_down},
    {XK_KP_Home, l3d_key_home},
    {XK_KP_End, l3d_key_end},
    {XK_ISO_Left_Tab, l3d_key_tab},
}};

/// The key of a keysym, 0 if it is none of ours.
int key_of_keysym(KeySym keysym) {
    const auto* named = std::ranges::find(named_keys, keysym, &std::pair<KeySym, int>::first);
    if (named != named_keys.end())
        return named->second;
    if (keysym >= XK_F1 && keysym <= XK_F11)
        return l3d_key_f1 + static_cast<int>(keysym - XK_F1);
    // X numbers the characters of ASCII as ASCII does.
    return keysym >= ' ' && keysym <= '~' ? static_cast<int>(keysym) : 0;
}

/// The key of an event: by its own group and level, and if that gives no ASCII character, as on
/// a Cyrillic layout, by the first group that does.
int key_of(XKeyEvent& event) {
    std::array<char, 8> text{};
    KeySym keysym = NoSymbol;
    const int length = XLookupString(&event, text.data(), text.size(), &keysym, nullptr);
    if (const int key = key_of_keysym(keysym); key != 0)
        return key;
    // The digits and signs of the number pad have keysyms of their own, but plain text.
    if (length == 1 && text[0] >= ' ' && text[0] <= '~')
        return text[0];
    // Xlib numbers symbols by group and level: 0 and 1 are the plain and shifted first group.
    const int shifted = (event.state & ShiftMask) != 0 ? 1 : 0;
    for (const int index : {shifted, 2 + shifted}) {
        if (const int key = key_of_keysym(XLookupKeysym(&event, index)); key != 0)
            return key;
    }
    return 0;
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
    switch (event.type) {
    case KeyPress:
        return take_key(event.xkey, l3d_event_type::key_press);
    case KeyRelease:
        return take_key(event.xkey, l3d_event_type::key_release);
    case ButtonPress:
        return take_button(event.xbutton, l3d_event_type::button_press);
    case ButtonRelease:
        return take_button(event.xbutton, l3d_event_type::button_release);
    case MotionNotify:
        return take_motion(event.xmotion);
    case ClientMessage:
        return take_message(event.xclient);
    case ConfigureNotify:
        return replace_or_push({.type = l3d_event_type::resize,
                                .size = {event.xconfigure.width, event.xconfigure.height}});
    case Expose:
        if (event.xexpose.count == 0) {
            exposed_ = true;
            replace_or_push({.type = l3d_event_type::expose});
        }
        return;
    case MapNotify:
        mapped_ = true;
        return;
    case DestroyNotify:
        return push({.type = l3d_event_type::close});
    case MappingNotify:
        XRefreshKeyboardMapping(&event.xmapping);
        return;
    default:
        return;
    }
}

bool x11_events::next(l3d_event& event) {
    if (queue_.empty())
        return false;
    event = queue_.front();
    queue_.pop_front();
    return true;
}

/// One event of this type is enough, with the latest contents.
void x11_events::replace_or_push(const l3d_event& event) {
    const auto earlier = std::ranges::find(queue_, event.type, &l3d_event::type);
    if (earlier != queue_.end())
        *earlier = event;
    else
        push(event);
}

void x11_events::take_key(XKeyEvent& event, l3d_event_type type) {
    if (type == l3d_event_type::key_release && is_autorepeat(event))
        return;
    if (const int key = key_of(event); key != 0)
        push({.type = type, .key = key, .x = event.x, .y = event.y});
}

/// Servers without detectable autorepeat send a release with each repeated press, at one time.
bool x11_events::is_autorepeat(const XKeyEvent& release) const {
    if (XEventsQueued(window_.display(), QueuedAlready) == 0)
        return false;
    XEvent next;
    XPeekEvent(window_.display(), &next);
    return next.type == KeyPress && next.xkey.keycode == release.keycode &&
           next.xkey.time == release.time;
}

void x11_events::take_button(const XButtonEvent& event, l3d_event_type type) {
    // X has no wheel: a notch is a click of button 4 or 5. Above these are sideways wheels.
    if (event.button == Button4 || event.button == Button5) {
        if (type == l3d_event_type::button_press)
            push({.type = l3d_event_type::wheel, .y = event.button == Button4 ? 1 : -1});
    } else if (event.button <= Button3) {
        push({.type = type, .button = static_cast<int>(event.button), .x = event.x, .y = event.y});
    }
}

void x11_events::take_motion(const XMotionEvent& event) {
    const l3d_event motion{.type = l3d_event_type::pointer_motion,
                           .button = held_button(event.state),
                           .x = event.x,
                           .y = event.y};
    if (!queue_.empty() && queue_.back().type == motion.type &&
        queue_.back().button == motion.button)
        queue_.back() = motion;
    else
        push(motion);
}

void x11_events::take_message(XClientMessageEvent& event) {
    const auto& atoms = window_.atoms();
    if (event.message_type != atoms.wm_protocols || event.format != 32)
        return;
    const auto protocol = static_cast<Atom>(event.data.l[0]);
    if (protocol == atoms.wm_delete_window) {
        push({.type = l3d_event_type::close});
    } else if (protocol == atoms.net_wm_ping) {
        // Sent back to the root it says that we are alive.
        const auto root = window_.connection().root();
        event.window = root;
        XSendEvent(window_.display(), root, False,
                   SubstructureNotifyMask | SubstructureRedirectMask,
                   reinterpret_cast<XEvent*>(&event));
    }
}

} // namespace l3d_detail
