// SPDX-License-Identifier: MIT
// The one place that knows Xlib's buffer.
#include "tool_2d/x11_window/x11_room_p.h"

#include <X11/Xlibint.h> // after all others: it has macros of common names

namespace l3d_detail {

void make_x11_room(Display* display) {
    display->bufptr = display->buffer;
    // Without the connection, Xlib takes its buffer for empty. It has at least this size.
    if (display->bufmax == display->buffer)
        display->bufmax = display->buffer + BUFSIZE;
}

} // namespace l3d_detail
