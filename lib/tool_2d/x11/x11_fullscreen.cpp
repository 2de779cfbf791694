// SPDX-License-Identifier: MIT
// x11_fullscreen: with a window manager and without one; the pointer.
#include "tool_2d/x11/x11_fullscreen_p.h"

#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <utility>

#include <X11/Xatom.h>

namespace l3d_detail {
namespace {

constexpr std::chrono::seconds longest_rest{2};

struct x11_freer {
    void operator()(unsigned char* memory) const { XFree(memory); }
};

/// A cursor without any pixel. The server keeps it while a window uses it.
void define_empty_cursor(Display* display, Window window) {
    const char no_bits = 0;
    const Pixmap shape = XCreateBitmapFromData(display, window, &no_bits, 1, 1);
    XColor black{};
    const Cursor cursor = XCreatePixmapCursor(display, shape, shape, &black, &black, 0, 0);
    XFreePixmap(display, shape);
    XDefineCursor(display, window, cursor);
    XFreeCursor(display, cursor);
}

} // namespace

void x11_fullscreen::intern_names() {
    if (names_.state != 0)
        return;
    constexpr std::array texts{"_NET_WM_STATE", "_NET_WM_STATE_FULLSCREEN", "_NET_SUPPORTED"};
    std::array<Atom, texts.size()> atoms{};
    XInternAtoms(window_.display(), const_cast<char**>(texts.data()),
                 static_cast<int>(texts.size()), False, atoms.data());
    names_ = {atoms[0], atoms[1], atoms[2]};
}

/// Whether a property that is a list of atoms holds this one.
bool x11_fullscreen::has(Window window, Atom list, Atom wanted) const {
    constexpr long longest = 1024; // The standard has about a hundred names.
    Atom type = 0;
    int format = 0;
    unsigned long count = 0, after = 0;
    unsigned char* data = nullptr;
    if (XGetWindowProperty(window_.display(), window, list, 0, longest, False, XA_ATOM, &type,
                           &format, &count, &after, &data) != Success)
        return false;
    const std::unique_ptr<unsigned char, x11_freer> owner(data);
    if (format != 32)
        return false;
    const std::span atoms(reinterpret_cast<const Atom*>(data), count);
    return std::ranges::find(atoms, wanted) != atoms.end();
}

void x11_fullscreen::set(bool on) {
    if (on == on_ || window_.connection().lost())
        return;
    intern_names();
    const bool by_manager = window_.is_managed() &&
                            has(window_.connection().root(), names_.supported, names_.fullscreen);
    if (by_manager)
        ask_manager(on);
    else if (on)
        cover();
    else
        XMoveResizeWindow(window_.display(), window_.id(), before_.x, before_.y,
                          static_cast<unsigned>(before_.width),
                          static_cast<unsigned>(before_.height));
    set_on(on);
}

void x11_fullscreen::ask_manager(bool on) const {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window_.id();
    event.xclient.message_type = names_.state;
    event.xclient.format = 32;
    event.xclient.data.l[0] = on ? 1 : 0; // add, remove
    event.xclient.data.l[1] = static_cast<long>(names_.fullscreen);
    event.xclient.data.l[3] = 1; // from an application
    XSendEvent(window_.display(), window_.connection().root(), False,
               SubstructureRedirectMask | SubstructureNotifyMask, &event);
}

void x11_fullscreen::cover() {
    Display* display = window_.display();
    XWindowAttributes root{};
    if (XGetWindowAttributes(display, window_.id(), &before_) == 0 ||
        XGetWindowAttributes(display, window_.connection().root(), &root) == 0)
        return;
    XMoveResizeWindow(display, window_.id(), 0, 0, static_cast<unsigned>(root.width),
                      static_cast<unsigned>(root.height));
    XRaiseWindow(display, window_.id());
}

void x11_fullscreen::set_on(bool on) {
    if (std::exchange(on_, on) == on)
        return;
    window_.watch_pointer(on);
    show_pointer();
}

void x11_fullscreen::take(const XEvent& event) {
    if (event.type == MotionNotify || event.type == ButtonPress)
        show_pointer();
    if (event.type == PropertyNotify && names_.state != 0 && event.xproperty.atom == names_.state)
        set_on(has(window_.id(), names_.state, names_.fullscreen));
}

void x11_fullscreen::show_pointer() {
    pointer_moved_ = clock::now();
    if (std::exchange(pointer_hidden_, false))
        XUndefineCursor(window_.display(), window_.id());
}

void x11_fullscreen::rest(clock::time_point now) {
    if (!on_ || pointer_hidden_ || now - pointer_moved_ < longest_rest)
        return;
    pointer_hidden_ = true;
    define_empty_cursor(window_.display(), window_.id());
}

} // namespace l3d_detail
