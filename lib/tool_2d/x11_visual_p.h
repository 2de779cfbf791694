// SPDX-License-Identifier: MIT
// x11_visual: which of the display's pixel formats a window is made with.
#ifndef L3D_TOOL_2D_X11_VISUAL_P_H
#define L3D_TOOL_2D_X11_VISUAL_P_H

#include "tool_2d/screen_info.h"
#include "tool_2d/x11_connection_p.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace l3d_detail {

/// One format of the display's pixels.
/// Lives:   the Visual is the connection's.
struct x11_visual {
    Visual* visual = nullptr;
    int color_class = 0; ///< StaticGray .. DirectColor
    l3d_pixel_layout layout;
};

/// All that the screen offers, of whatever class.
std::vector<x11_visual> offered_x11_visuals(const x11_connection& connection);

/// The preferred visual if it is a TrueColor one that we can convert to, else the best such.
/// Errors:  nothing, with one line in `why` that gives the preferred one's class, depth and masks.
std::optional<x11_visual> choose_x11_visual(std::span<const x11_visual> offered,
                                            const Visual* preferred, std::string& why);

/// The choice among all that the screen offers; its default is preferred. Errors: likewise.
std::optional<x11_visual> choose_x11_visual(const x11_connection& connection, std::string& why);

} // namespace l3d_detail

#endif
