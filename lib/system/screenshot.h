// SPDX-License-Identifier: MIT
// l3d_save_screenshot: the picture as a new file in the current folder.
#ifndef L3D_SYSTEM_SCREENSHOT_H
#define L3D_SYSTEM_SCREENSHOT_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <string>

/// Writes l3d-0001.png, or the first such name that is free, and never over an existing file.
/// Returns a line that says where it is, or why it could not be done: a full disk must not end a
/// program.
L3D_PUBLIC std::string l3d_save_screenshot(const l3d_pixels& pixels);

#endif
