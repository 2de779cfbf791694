// SPDX-License-Identifier: MIT
// x11_screen: a window whose pixels programs draw.
#ifndef L3D_TOOL_2D_X11_X11_SCREEN_P_H
#define L3D_TOOL_2D_X11_X11_SCREEN_P_H

#include "tool_2d/screen.h"
#include "tool_2d/x11/x11_window_p.h"

#include <memory>
#include <string>

namespace l3d_detail {

/// Puts the window on the screen and waits until the server wants it drawn.
///
/// Shape:   `size` of the picture; `no_shm` is why memory shall not be shared, empty: it shall;
///          `sparing` is whether pictures that travel do so as make_x11_image_sparing has it.
/// Errors:  std::bad_alloc.
/// Cost:    returns after two seconds at the latest.
std::unique_ptr<l3d_screen> open_x11_screen(std::unique_ptr<x11_window> window, l3d_size size,
                                            std::string no_shm, bool sparing);

} // namespace l3d_detail

#endif
