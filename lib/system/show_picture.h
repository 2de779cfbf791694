// SPDX-License-Identifier: MIT
// l3d_show_picture: a window for programs that have a picture and no pipeline.
#ifndef L3D_SYSTEM_SHOW_PICTURE_H
#define L3D_SYSTEM_SHOW_PICTURE_H

#include "base/public.h"
#include "tool_2d/pixels.h"

#include <string>

/// Shows a finished picture until the user closes its window or presses q or Escape. The picture
/// fills as much of the window as its shape allows. L3D_BACKEND names the back-end; without it the
/// first that can serve is taken. Where nobody would see it, it is written to `name`.png, and a
/// line on stderr says so.
///
/// Shape:   `name` is the window's title and a file's name without its end.
/// Returns: the exit code that main should return.
/// Errors:  none: each becomes a line on stderr and an exit code, as for l3d_program::run.
/// Expects: a picture of 1 to l3d_largest_side pixels in both directions.
L3D_PUBLIC int l3d_show_picture(const l3d_pixels& picture, const std::string& name = "picture");

#endif
