// SPDX-License-Identifier: MIT
// decoded_jpeg: the picture of a JPEG file; and a check that readers of pictures share.
#ifndef L3D_TOOL_2D_JPEG_IMAGE_P_H
#define L3D_TOOL_2D_JPEG_IMAGE_P_H

#include "tool_2d/image.h"

#include <cstdint>
#include <string>

namespace l3d_detail {

/// Refuses a picture that is too large.
/// Errors:  l3d_error(bad_input) that names the path, if width * height exceeds `most_pixels`.
void check_image_size(const std::string& path, std::int64_t width, std::int64_t height,
                      std::int64_t most_pixels);

/// The picture of a JPEG file's bytes, grey or in colour, as l3d_read_image gives it.
/// Errors:  l3d_error(bad_input) that names the path and the reason, also for what the decoder only
///          warns of: bytes that are missing or damaged.
l3d_image decoded_jpeg(const std::string& bytes, const std::string& path, std::int64_t most_pixels);

} // namespace l3d_detail

#endif
