// SPDX-License-Identifier: MIT
// x11_resolution: the size of pictures and letters on a fine display.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_RESOLUTION_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_RESOLUTION_P_H

#include "tool_2d/screen.h"
#include "tool_2d/x11/x11_connection_p.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace l3d_detail {

/// The largest side of a window: X counts places in it in 16 bits with sign.
inline constexpr int largest_x11_side = 32767;

/// The scale that the request names, else 1.
inline int x11_scale(const l3d_screen_request& request) {
    return request.scale == 0 ? 1 : request.scale;
}

/// The size of the picture, in our pixels. If the request names a scale, this is the requested
/// size. Otherwise the requested size is multiplied by the display's fineness, within X's limits.
/// So people see the window as large as on a usual display.
/// Cost:    none; Xlib has read the resources when it opened the display.
/// Source:  GLFW takes Xft.dpi in units of 96, like the toolkits that the user's settings are for.
l3d_size x11_picture_size(const x11_connection& connection, const l3d_screen_request& request);

/// The display's dots an inch as the user has set them, in units of 96; at least 1, and no more
/// than l3d_largest_scale.
/// Cost:    as x11_picture_size.
double x11_fineness(const x11_connection& connection);

/// The fineness that the text of an XSETTINGS manager gives, else the display's resources.
double x11_fineness(std::string_view settings, std::string_view resources);

/// The setting Xft/DPI in the text of an XSETTINGS manager, in dots an inch. Nothing if the text
/// has no such setting, or is not whole.
/// Source:  the XSETTINGS protocol of freedesktop.org: numbers in the writer's order of bytes, each
///          setting with type, name, serial and value, padded to words; dots in units of 1/1024.
std::optional<double> xsettings_dpi(std::string_view text);

} // namespace l3d_detail

#endif
