// SPDX-License-Identifier: MIT
// png_levels: the levels of a PNG file, with all of their bits.
#ifndef L3D_TOOL_2D_PNG_LEVELS_P_H
#define L3D_TOOL_2D_PNG_LEVELS_P_H

#include "tool_2d/pixels.h"

#include <cstdint>
#include <string>
#include <vector>

namespace l3d_detail {

/// A picture as numbers, such as heights.
struct png_levels {
    l3d_size size;
    std::vector<double> means; ///< for each pixel, the mean of red, green and blue; white is 1
};

/// Decodes a PNG file's bytes into the levels that are stored, without regard to alpha and gamma.
/// Errors:  l3d_error(bad_input) that names the path and the reason, as l3d_decoded_image.
png_levels decoded_png_levels(const std::string& bytes, const std::string& path,
                              std::int64_t most_pixels);

} // namespace l3d_detail

#endif
