// SPDX-License-Identifier: MIT
// x11_scale: how many of the display's pixels one of ours takes.
#ifndef L3D_TOOL_2D_X11_X11_SCALE_P_H
#define L3D_TOOL_2D_X11_X11_SCALE_P_H

#include "tool_2d/screen.h"
#include "tool_2d/x11/x11_connection_p.h"

namespace l3d_detail {

/// X counts places in a window in 16 bits with sign.
inline constexpr int largest_x11_side = 32767;

/// The scale that the request names; else what the display's resources ask for, as far as the
/// window then stays one that X can make.
/// Cost:    none; Xlib has read the resources when it opened the display.
/// Source:  GLFW takes Xft.dpi in units of 96, like the toolkits that the user's settings are for.
int x11_scale(const x11_connection& connection, const l3d_screen_request& request);

/// The display's dots an inch as the user has set them, in units of 96; at least 1, and no more
/// than l3d_largest_scale. Cost: as x11_scale.
double x11_fineness(const x11_connection& connection);

} // namespace l3d_detail

#endif
