// SPDX-License-Identifier: MIT
// x11_fullscreen: covers the screen, with or without a window manager, and hides a resting pointer.
#include "tool_2d/x11_window/x11_fullscreen_p.h"

#include <algorithm>
#include <utility>

namespace l3d_detail {
namespace {

constexpr std::chrono::seconds longest_rest{2};
// The longest wait for a manager to act, which takes it some pictures. Meanwhile, keys count as if
// it had acted.
constexpr std::chrono::seconds longest_grant{1};

} // namespace

bool x11_fullscreen::is_on() const {
    if (wanted_)
        return *wanted_;
    return awaited_ && clock::now() < awaited_until_ ? *awaited_ : on_;
}

void x11_fullscreen::set(bool on) {
    if (on == is_on() || window_.connection().lost())
        return;
    wanted_ = on;
    state_.ask();
}

void x11_fullscreen::follow() {
    if (window_.connection().lost())
        return;
    const x11_facts& facts = state_.facts();
    const bool is_granted = facts.grants_fullscreen;
    if (is_granted && covers_) {
        // The window gets its usual place back, which the manager is to remember.
        uncover();
        wanted_ = wanted_.value_or(true);
    } else if (granted_ && !is_granted) {
        covers_ = on_;
    }
    granted_ = is_granted;
    if (wanted_ && !state_.is_asking())
        act(*std::exchange(wanted_, std::nullopt));
    const bool on = is_granted ? facts.fullscreen : covers_;
    if (!is_granted || awaited_ == on)
        awaited_.reset();
    if (std::exchange(on_, on) == on)
        return;
    window_.watch_pointer(x11_window::watcher::fullscreen, on);
    show_pointer();
}

void x11_fullscreen::act(bool on) {
    if (granted_)
        ask_manager(on);
    else if (on && !covers_)
        cover();
    else if (!on && covers_)
        uncover();
}

void x11_fullscreen::ask_manager(bool on) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window_.id();
    event.xclient.message_type = state_.atom(x11_wm_facts::net_wm_state);
    event.xclient.format = 32;
    event.xclient.data.l[0] = on ? 1 : 0; // 1 adds the state, 0 removes it
    event.xclient.data.l[1] = static_cast<long>(state_.atom(x11_wm_facts::net_wm_state_fullscreen));
    event.xclient.data.l[3] = 1; // the request comes from an application
    XSendEvent(window_.display(), window_.connection().root(), False,
               SubstructureRedirectMask | SubstructureNotifyMask, &event);
    awaited_ = on;
    awaited_until_ = clock::now() + longest_grant;
}

/// The monitor that holds the window's middle, or else the first one.
l3d_pixel_box x11_fullscreen::monitor() const {
    const auto& monitors = state_.facts().monitors;
    if (monitors.empty())
        return {0, 0, DisplayWidth(window_.display(), window_.connection().screen()),
                DisplayHeight(window_.display(), window_.connection().screen())};
    const int x = place_.left + (place_.right - place_.left) / 2;
    const int y = place_.top + (place_.bottom - place_.top) / 2;
    const auto found = std::ranges::find_if(monitors, [x, y](const l3d_pixel_box& box) {
        return x >= box.left && x < box.right && y >= box.top && y < box.bottom;
    });
    return found == monitors.end() ? monitors.front() : *found;
}

void x11_fullscreen::move(const l3d_pixel_box& place) const {
    XMoveResizeWindow(window_.display(), window_.id(), place.left, place.top,
                      static_cast<unsigned>(place.right - place.left),
                      static_cast<unsigned>(place.bottom - place.top));
}

void x11_fullscreen::cover() {
    asked_ = monitor();
    covers_ = true;
    is_corrected_ = false;
    move(asked_);
    XRaiseWindow(window_.display(), window_.id());
}

void x11_fullscreen::uncover() {
    covers_ = false;
    move(place_);
}

/// Takes the window's place. Events of the server tell places in the parent, which may be a frame.
/// Events of managers tell places on the screen.
void x11_fullscreen::take_place(const XConfigureEvent& event) {
    const bool is_on_screen = event.send_event != 0 || !state_.facts().managed;
    if (covers_) {
        // A manager's frame shifts the window by the widths of its left and upper borders.
        const int right = event.x - asked_.left, down = event.y - asked_.top;
        if (event.send_event == 0 || (right == 0 && down == 0) ||
            std::exchange(is_corrected_, true))
            return;
        move({asked_.left - right, asked_.top - down, asked_.right - right, asked_.bottom - down});
        return;
    }
    // A window that is about to cover the screen has its new size before any other news of that.
    const l3d_pixel_box whole = monitor();
    if (on_ || !is_on_screen ||
        (event.width == whole.right - whole.left && event.height == whole.bottom - whole.top))
        return;
    const bool is_real = event.send_event == 0;
    const int width = is_real ? event.width : place_.right - place_.left;
    const int height = is_real ? event.height : place_.bottom - place_.top;
    place_ = {event.x, event.y, event.x + width, event.y + height};
}

void x11_fullscreen::take(const XEvent& event) {
    if (event.type == MotionNotify || event.type == ButtonPress)
        show_pointer();
    if (event.type == ConfigureNotify)
        take_place(event.xconfigure);
}

void x11_fullscreen::show_pointer() {
    pointer_moved_ = clock::now();
    if (std::exchange(pointer_hidden_, false))
        XUndefineCursor(window_.display(), window_.id());
}

void x11_fullscreen::rest(clock::time_point now) {
    if (!on_ || pointer_hidden_ || window_.connection().lost() ||
        now - pointer_moved_ < longest_rest)
        return;
    pointer_hidden_ = true;
    const Cursor cursor = window_.make_empty_cursor();
    XDefineCursor(window_.display(), window_.id(), cursor);
    XFreeCursor(window_.display(), cursor); // the server keeps it while the window uses it
}

x11_fullscreen::clock::time_point x11_fullscreen::next_rest() const {
    return on_ && !pointer_hidden_ ? pointer_moved_ + longest_rest : clock::time_point::max();
}

} // namespace l3d_detail
