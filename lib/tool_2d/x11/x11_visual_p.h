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

/// Chooses the visual that shows our colours best without disturbing other windows.
///
/// Usable are TrueColor and DirectColor with 8, 16, 24 or 32 bits per pixel. So are colormaps of 16
/// to 4096 cells with 8 or 16 bits. A visual is good if each of its masks has five bits or more.
///
/// The function takes the preferred visual if this is good, else the best visual if that is good.
/// If none is good, the function keeps the preferred visual, since another colormap would spoil the
/// colours of other windows. If the preferred visual is unusable, the function takes the best one.
///
/// The best visual has no alpha. Ties go to the most bits in the poorest channel, counted up to 8.
/// Further ties go to TrueColor, whose colormap needs no writing, then to the greatest depth.
/// Errors:  nothing, with one line in `why`: class, depth and masks of the preferred one, and the
///          formats that would serve.
std::optional<x11_visual> choose_x11_visual(std::span<const x11_visual> offered,
                                            const Visual* preferred, std::string& why);

/// Chooses among all visuals that the screen offers, and prefers its default.
/// Errors:  as the function above, which chooses among given visuals.
std::optional<x11_visual> choose_x11_visual(const x11_connection& connection, std::string& why);

} // namespace l3d_detail

#endif
