// SPDX-License-Identifier: MIT
// Where the error sits, as a picture.
#ifndef L3D_APPS_TEAPOT_AFD_ERROR_PICTURE_H
#define L3D_APPS_TEAPOT_AFD_ERROR_PICTURE_H

#include "reference/measure.h"
#include <l3d/pixels.h>

#include <string>

/// Writes a picture that shows the error in each pixel by colours: from green for 0, over yellow,
/// to red for `largest` pixels or more. Holes are magenta, and pixels that were not compared are
/// black. A legend tells the scale.
///
/// Errors: l3d_error(failure) that names the file.
void write_error_picture(const std::string& file, const reference::error_map& errors, l3d_size size,
                         double largest);

#endif
