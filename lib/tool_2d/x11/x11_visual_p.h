// SPDX-License-Identifier: MIT
// x11_visual: the choice of the display's pixel format for a window.
#ifndef L3D_TOOL_2D_X11_X11_VISUAL_P_H
#define L3D_TOOL_2D_X11_X11_VISUAL_P_H

#include "tool_2d/screen_info.h"
#include "tool_2d/x11/x11_connection_p.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace l3d_detail {

/// One format of the display's pixels.
/// Lives:   the Visual is the connection's.
struct x11_visual {
    Visual* visual = nullptr;
    l3d_pixel_layout layout;
    int cells = 0; ///< entries of its colormap; if there are masks, of the largest channel
};

/// The formats that the screen offers, of all classes.
std::vector<x11_visual> offered_x11_visuals(const x11_connection& connection);

/// The visual that shows our colours best without disturbing others.
///
/// Served are TrueColor and DirectColor with 8, 16, 24 or 32 bits per pixel, and colormaps of 16 to
/// 4096 cells with 8 or 16. The preferred one is taken if it has masks of five bits or more, since
/// it loses nothing, or nearly nothing. Else the best that has such masks is taken. If none has, it
/// is the preferred one again. On a display so poor all visuals are likely to share one map, and
/// one of our own would spoil the colours of other windows. The best has no alpha; then the most
/// bits in its poorest channel, up to our eight; then no map that must be written; then the most
/// bits.
/// Errors: nothing, with one line in `why`: class, depth and masks of the preferred one, and the
///         formats that would serve.
std::optional<x11_visual> choose_x11_visual(std::span<const x11_visual> offered,
                                            const Visual* preferred, std::string& why);

/// The choice among all that the screen offers; its default is preferred. Errors: likewise.
std::optional<x11_visual> choose_x11_visual(const x11_connection& connection, std::string& why);

} // namespace l3d_detail

#endif
