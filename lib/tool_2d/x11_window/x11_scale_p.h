// SPDX-License-Identifier: MIT
// x11_scale: the display's pixels, ours, and the size of letters.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_SCALE_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_SCALE_P_H

#include "tool_2d/screen.h"
#include "tool_2d/x11/x11_connection_p.h"

namespace l3d_detail {

/// X counts places in a window in 16 bits with sign.
inline constexpr int largest_x11_side = 32767;

/// The scale that the request names; else a pixel of ours is one of the display's.
inline int x11_scale(const l3d_screen_request& request) {
    return request.scale == 0 ? 1 : request.scale;
}

/// The size of the picture: the requested one if a scale is requested, too. Else it is larger by
/// the display's fineness, so that the window has its usual size for people's eyes, within X's
/// limits.
/// Cost:    none; Xlib has read the resources when it opened the display.
/// Source:  GLFW takes Xft.dpi in units of 96, like the toolkits that the user's settings are for.
l3d_size x11_picture_size(const x11_connection& connection, const l3d_screen_request& request);

/// The display's dots an inch as the user has set them, in units of 96; at least 1, and no more
/// than l3d_largest_scale. Cost: as x11_picture_size.
double x11_fineness(const x11_connection& connection);

/// The fineness by a text of resources, and by dots an inch.
double x11_fineness_of(const char* resources);
double x11_fineness_of_dpi(double dpi);

} // namespace l3d_detail

#endif
