// SPDX-License-Identifier: MIT
// x11_icon: the picture that desktops show for a window.
#ifndef L3D_TOOL_2D_X11_WINDOW_X11_ICON_P_H
#define L3D_TOOL_2D_X11_WINDOW_X11_ICON_P_H

#include <vector>

namespace l3d_detail {

/// Width, height, and 0xAARRGGBB for each pixel from the top left on, as _NET_WM_ICON has them.
/// Source: Extended Window Manager Hints, 1.3.
std::vector<long> x11_icon();

} // namespace l3d_detail

#endif
