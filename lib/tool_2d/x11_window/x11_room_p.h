// SPDX-License-Identifier: MIT
// Room for a request that Xlib writes although its server is gone.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_ROOM_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_ROOM_P_H

#include <X11/Xlib.h>

namespace l3d_detail {

/// Empties Xlib's buffer, which nobody will read.
///
/// Xlib may find its server gone when it makes room for a request. libX11 1.8 then has no place for
/// it, says so on stderr, and has extensions write to a null pointer. So the room is made here. The
/// first request after one of XCB's is the usual case, since each library takes the connection from
/// the other.
/// Expects: Xlib has just called the handler of broken connections for this display.
void make_x11_room(Display* display);

} // namespace l3d_detail

#endif
