// SPDX-License-Identifier: MIT
// x11_visual: which of the display's pixel formats a window is made with.
#ifndef L3D_TOOL_2D_X11_VISUAL_P_H
#define L3D_TOOL_2D_X11_VISUAL_P_H

#include "tool_2d/screen_info.h"
#include "tool_2d/x11_connection_p.h"

#include <optional>
#include <string>

namespace l3d_detail {

/// A TrueColor visual and what its pixels look like.
/// Lives:   the Visual is the connection's.
struct x11_visual {
    Visual* visual = nullptr;
    l3d_pixel_layout layout;
};

/// The screen's default visual if it is a TrueColor one that we can convert to, else the best.
/// Errors:  nothing, with one line in `why` that gives the default's class, depth and masks.
std::optional<x11_visual> choose_x11_visual(const x11_connection& connection, std::string& why);

} // namespace l3d_detail

#endif
