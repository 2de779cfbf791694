// SPDX-License-Identifier: MIT
// x11_window: attributes and properties.
#include "tool_2d/x11_window_p.h"

#include <array>
#include <cassert>

#include <unistd.h>

#include <X11/XKBlib.h>
#include <X11/Xatom.h>
#include <X11/Xutil.h>

namespace l3d_detail {
namespace {

x11_atoms intern_atoms(Display* display) {
    constexpr std::array names{"WM_PROTOCOLS", "WM_DELETE_WINDOW", "_NET_WM_PING", "_NET_WM_PID",
                               "_NET_WM_NAME", "UTF8_STRING",      "_L3D_PUT_DONE"};
    std::array<Atom, names.size()> atoms{};
    XInternAtoms(display, const_cast<char**>(names.data()), static_cast<int>(names.size()), False,
                 atoms.data());
    return {atoms[0], atoms[1], atoms[2], atoms[3], atoms[4], atoms[5], atoms[6]};
}

/// One property that is an array of bytes or of longs, whatever X calls it.
void set_property(const x11_window& window, Atom name, Atom type, int format, const void* data,
                  std::size_t count) {
    XChangeProperty(window.display(), window.id(), name, type, format, PropModeReplace,
                    static_cast<const unsigned char*>(data), static_cast<int>(count));
}

} // namespace

std::unique_ptr<x11_window> x11_window::open(std::unique_ptr<x11_connection> connection,
                                             const x11_visual& visual,
                                             const l3d_screen_request& request, std::string& why) {
    assert(request.size.width >= 1 && request.size.height >= 1);
    std::unique_ptr<x11_window> window(new x11_window(std::move(connection), visual));
    x11_error_trap trap(window->connection());
    window->create(request.size);
    window->set_names(request);
    window->set_protocols();
    const int error = trap.sync();
    if (window->connection().lost()) {
        why = "the X server went away";
        return nullptr;
    }
    if (error != 0) {
        why = "the X server does not make a window of " + std::to_string(request.size.width) + "x" +
              std::to_string(request.size.height);
        return nullptr;
    }
    return window;
}

x11_window::x11_window(std::unique_ptr<x11_connection> connection, const x11_visual& visual)
    : connection_(std::move(connection)), visual_(visual), info_(visual.layout),
      atoms_(intern_atoms(display())) {
    // Without this a held key looks like one that is pressed again and again.
    XkbSetDetectableAutoRepeat(display(), True, nullptr);
}

x11_window::~x11_window() {
    // Xlib's own record of the context is freed even if the server is gone.
    XFreeGC(display(), graphics_);
    XDestroyWindow(display(), window_);
    XFreeColormap(display(), colormap_);
}

void x11_window::create(l3d_size size) {
    const auto root = connection_->root();
    colormap_ = XCreateColormap(display(), root, visual(), AllocNone);
    XSetWindowAttributes attributes{};
    attributes.colormap = colormap_;
    // Not inherited: a parent of another depth has no pixel for the border.
    attributes.border_pixel = 0;
    attributes.background_pixel = info_.to_display(0);
    // What is drawn stays when the window grows, so that only new parts turn black.
    attributes.bit_gravity = NorthWestGravity;
    attributes.event_mask = KeyPressMask | KeyReleaseMask | ButtonPressMask | ButtonReleaseMask |
                            Button1MotionMask | Button2MotionMask | Button3MotionMask |
                            StructureNotifyMask | ExposureMask;
    window_ = XCreateWindow(
        display(), root, 0, 0, static_cast<unsigned>(size.width),
        static_cast<unsigned>(size.height), 0, visual_.layout.depth, InputOutput, visual(),
        CWColormap | CWBorderPixel | CWBackPixel | CWBitGravity | CWEventMask, &attributes);
    graphics_ = XCreateGC(display(), window_, 0, nullptr);
}

void x11_window::set_names(const l3d_screen_request& request) {
    XSizeHints size{};
    size.flags = PSize | PMinSize;
    size.width = request.size.width;
    size.height = request.size.height;
    size.min_width = 1;
    size.min_height = 1;
    XWMHints hints{};
    hints.flags = InputHint | StateHint;
    hints.input = True;
    hints.initial_state = NormalState;
    std::string instance = "l3d", class_name = "L3d";
    XClassHint names{instance.data(), class_name.data()};
    // Writes WM_CLIENT_MACHINE too, without which the process number means nothing.
    Xutf8SetWMProperties(display(), window_, request.title.c_str(), request.title.c_str(), nullptr,
                         0, &size, &hints, &names);
    set_property(*this, atoms_.net_wm_name, atoms_.utf8_string, 8, request.title.data(),
                 request.title.size());
    const long process = getpid();
    set_property(*this, atoms_.net_wm_pid, XA_CARDINAL, 32, &process, 1);
}

void x11_window::set_protocols() {
    std::array protocols{atoms_.wm_delete_window, atoms_.net_wm_ping};
    XSetWMProtocols(display(), window_, protocols.data(), static_cast<int>(protocols.size()));
}

void x11_window::focus_if_unmanaged() {
    // A window manager is who redirects the root's children; only one client can.
    XWindowAttributes root{};
    if (XGetWindowAttributes(display(), connection_->root(), &root) != 0 &&
        (root.all_event_masks & SubstructureRedirectMask) == 0)
        XSetInputFocus(display(), window_, RevertToParent, CurrentTime);
}

} // namespace l3d_detail
