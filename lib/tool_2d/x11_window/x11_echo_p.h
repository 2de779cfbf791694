// SPDX-License-Identifier: MIT
// x11_echo: a question to the server whose answer is an event.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_ECHO_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_ECHO_P_H

#include "tool_2d/x11/x11_window_p.h"

#include <cstdint>

#include <X11/Xatom.h>

namespace l3d_detail {

/// Tells when the server has done all earlier requests.
///
/// We send an event to our own window. The server works in order, so the event comes back after all
/// earlier requests are done. Nobody waits for this event, unlike for a reply.
class x11_echo {
public:
    explicit x11_echo(const x11_window& window) : window_(window) {}

    /// Asks the server for an answer, and forgets an earlier question. Nothing is sent before Xlib
    /// next flushes.
    void ask() {
        if (window_.connection().lost())
            return;
        // Where others have sent requests beside Xlib, it finds out here that the server is gone.
        serial_ = XNextRequest(window_.display());
        if (window_.connection().lost())
            return;
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = window_.id();
        event.xclient.message_type = XA_INTEGER;
        event.xclient.format = 32;
        event.xclient.data.l[0] = name();
        XSendEvent(window_.display(), window_.id(), False, NoEventMask, &event);
    }

    bool is_awaited() const { return serial_ != 0; }

    /// The number of the request that asked.
    unsigned long serial() const { return serial_; }

    /// True if the event is the answer to the latest question.
    bool take(const XEvent& event) {
        if (!is_awaited() || event.type != ClientMessage ||
            event.xclient.message_type != XA_INTEGER || event.xclient.data.l[0] != name())
            return false;
        serial_ = 0;
        return true;
    }

private:
    /// The name by which our answer differs from answers to another x11_echo. An event has room for
    /// 32 bits, with a sign.
    long name() const { return static_cast<std::int32_t>(serial_); }

    const x11_window& window_;
    unsigned long serial_ = 0; ///< number of the request that asked; 0: nothing was asked
};

} // namespace l3d_detail

#endif
