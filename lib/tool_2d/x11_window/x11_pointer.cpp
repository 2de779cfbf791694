// SPDX-License-Identifier: MIT
// x11_pointer: grabs the pointer, and tells its motion by differences of places.
#include "tool_2d/x11_window/x11_pointer_p.h"

#include <algorithm>
#include <cstdlib>
#include <cstdint>

#include <X11/Xlib-xcb.h>

namespace l3d_detail {
namespace {

// The time between two tries to grab the pointer. A manager holds it while keys switch windows, and
// soon lets it go.
constexpr std::chrono::milliseconds between_tries{100};

} // namespace

x11_pointer::x11_pointer(x11_window& window, l3d_size native)
    : window_(window), xcb_(XGetXCBConnection(window.display())), echo_(window), size_(native) {}

x11_pointer::~x11_pointer() {
    if (cursor_ != 0 && !window_.connection().lost())
        XFreeCursor(window_.display(), cursor_);
}

void x11_pointer::set(l3d_pointer how) {
    if (std::exchange(how_, how) == how || window_.connection().lost())
        return;
    window_.watch_pointer(x11_window::watcher::program, how == l3d_pointer::followed);
    if (!wants_it())
        release();
}

void x11_pointer::set_focus(bool has_focus) {
    has_focus_ = has_focus;
    if (!wants_it())
        release();
}

void x11_pointer::release() {
    last_.reset();
    leap_ = 0;
    if (std::exchange(is_held_, false) && !window_.connection().lost())
        XUngrabPointer(window_.display(), CurrentTime);
}

void x11_pointer::look_after() {
    if (!wants_it() || is_held_ || echo_.is_awaited() || window_.connection().lost() ||
        clock::now() < next_try_ || !window_.connection().wait_writable({}))
        return;
    if (cursor_ == 0)
        cursor_ = window_.make_empty_cursor();
    XFlush(window_.display()); // the request for the cursor must come first
    constexpr std::uint32_t events = ButtonPressMask | ButtonReleaseMask | PointerMotionMask;
    const auto window = static_cast<xcb_window_t>(window_.id());
    asked_ = xcb_grab_pointer(xcb_, 0, window, static_cast<std::uint16_t>(events),
                              XCB_GRAB_MODE_ASYNC, XCB_GRAB_MODE_ASYNC, window,
                              static_cast<xcb_cursor_t>(cursor_), XCB_CURRENT_TIME);
    echo_.ask();
}

/// Takes an echo, which comes after the server's answer about the grab.
bool x11_pointer::take(const XEvent& event) {
    if (!echo_.take(event))
        return false;
    const unique_reply<xcb_grab_pointer_reply_t> reply(
        xcb_grab_pointer_reply(xcb_, asked_, nullptr));
    is_held_ = reply && reply->status == XCB_GRAB_STATUS_SUCCESS;
    if (!is_held_)
        next_try_ = clock::now() + between_tries;
    else if (wants_it())
        put_back();
    else
        release();
    return true;
}

void x11_pointer::put_back() {
    leap_ = XNextRequest(window_.display());
    XWarpPointer(window_.display(), None, window_.id(), 0, 0, 0, 0, middle().x, middle().y);
}

/// Whether the pointer was already put to the middle when it was at this place. An earlier motion
/// may carry the number of the request for that, so the distance decides.
bool x11_pointer::has_leapt_to(const place& now) const {
    const auto distance = [&now](const place& from) {
        return std::max(std::abs(now.x - from.x), std::abs(now.y - from.y));
    };
    const int here = distance(middle());
    return last_ ? here < distance(*last_) : here <= std::min(size_.width, size_.height) / 4;
}

std::optional<x11_way> x11_pointer::way_of(const XMotionEvent& event) {
    if (!is_held_)
        return x11_way{};
    const place now{event.x, event.y};
    if (leap_ != 0 && event.serial >= leap_ && has_leapt_to(now)) {
        leap_ = 0;
        last_ = middle();
    }
    if (!last_)
        return std::nullopt;
    const double scale = window_.scale();
    const x11_way way{(now.x - last_->x) / scale, (now.y - last_->y) / scale};
    last_ = now;
    const int reach = std::min(size_.width, size_.height) / 4;
    if (leap_ == 0 && std::max(std::abs(now.x - middle().x), std::abs(now.y - middle().y)) > reach)
        put_back();
    return way.right == 0 && way.down == 0 ? std::nullopt : std::optional(way);
}

} // namespace l3d_detail
