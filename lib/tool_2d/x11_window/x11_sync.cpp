// SPDX-License-Identifier: MIT
// x11_sync: keeps one counter of the SYNC extension.
#include "tool_2d/x11_window/x11_sync_p.h"

#include <array>

#include <X11/Xatom.h>

namespace l3d_detail {
namespace {

Bool query_sync(Display* display) {
    int first_event = 0, first_error = 0;
    return XSyncQueryExtension(display, &first_event, &first_error);
}

} // namespace

x11_sync::x11_sync(const x11_window& window) : window_(window) {
    Display* display = window.display();
    int major = 0, minor = 0;
    if (!window.was_managed() || !window.connection().has(query_sync) ||
        XSyncInitialize(display, &major, &minor) == 0)
        return;
    constexpr std::array names{"_NET_WM_SYNC_REQUEST", "_NET_WM_SYNC_REQUEST_COUNTER"};
    std::array<Atom, names.size()> atoms{};
    XInternAtoms(display, const_cast<char**>(names.data()), static_cast<int>(names.size()), False,
                 atoms.data());
    protocol_ = atoms[0];
    XSyncIntToValue(&number_, 0);
    counter_ = XSyncCreateCounter(display, number_);
    window.set_property(atoms[1], XA_CARDINAL, 32, &counter_, 1);
    XChangeProperty(display, window.id(), window.atoms().wm_protocols, XA_ATOM, 32, PropModeAppend,
                    reinterpret_cast<const unsigned char*>(&protocol_), 1);
}

void x11_sync::take(const XEvent& event) {
    if (protocol_ == 0)
        return;
    const auto& message = event.xclient;
    if (event.type == ClientMessage && message.message_type == window_.atoms().wm_protocols &&
        message.format == 32 && static_cast<Atom>(message.data.l[0]) == protocol_) {
        XSyncIntsToValue(&number_, static_cast<unsigned>(message.data.l[2]),
                         static_cast<int>(message.data.l[3]));
        step_ = step::asked;
    } else if (event.type == ConfigureNotify && step_ != step::idle) {
        size_ = window_.ours({event.xconfigure.width, event.xconfigure.height});
        step_ = step::sized;
    }
}

void x11_sync::shown(l3d_size size) {
    if (step_ != step::sized || !(size == size_))
        return;
    step_ = step::idle;
    XSyncSetCounter(window_.display(), counter_, number_);
}

} // namespace l3d_detail
