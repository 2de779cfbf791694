// SPDX-License-Identifier: MIT
// x11_sync: keeps a window manager from resizing the window faster than we can draw it.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_SYNC_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_SYNC_P_H

#include "tool_2d/x11/x11_window_p.h"

#include <X11/extensions/sync.h>

namespace l3d_detail {

/// Keeps a window manager from resizing the window faster than we draw, by _NET_WM_SYNC_REQUEST.
///
/// The manager names a number, gives the window a size, and waits until a counter in the server has
/// the number. We set the counter right after the first picture of that size, since the server does
/// both in this order.
/// Lives:   borrows the window; the server frees the counter at the end of the connection.
class x11_sync {
public:
    /// Offers the protocol to the window manager, if there is one and the server has the extension.
    /// Expects: the window is not on the screen yet.
    /// Cost:    two round trips if there is a manager.
    explicit x11_sync(const x11_window& window);

    /// Takes note of an event that brings a number from the manager, or the size that follows it.
    void take(const XEvent& event);

    /// Notes that the window has a picture of this size.
    void shown(l3d_size size);

private:
    enum class step { idle, asked, sized };

    const x11_window& window_;
    Atom protocol_ = 0; ///< the protocol's name, as X numbers it; 0: it is not offered
    XSyncCounter counter_ = 0;
    XSyncValue number_{};
    l3d_size size_{};
    step step_ = step::idle;
};

} // namespace l3d_detail

#endif
