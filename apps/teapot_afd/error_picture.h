// SPDX-License-Identifier: MIT
// Where the error sits, as a picture.
#ifndef L3D_APPS_TEAPOT_AFD_ERROR_PICTURE_H
#define L3D_APPS_TEAPOT_AFD_ERROR_PICTURE_H

#include "reference/measure.h"
#include <l3d/pixels.h>

#include <string>

/// Green where the error is 0, over yellow, to red where it is `largest` pixels or more; magenta
/// where there is a hole, black where nothing is compared. A legend in pixels is drawn in.
///
/// Errors: l3d_error(failure) that names the file.
void write_error_picture(const std::string& file, const reference::error_map& errors, l3d_size size,
                         double largest);

#endif
