// SPDX-License-Identifier: MIT
// l3d_detail::is_empty: whether a picture shows its background alone.
#ifndef L3D_PIPELINE_EMPTY_PICTURE_P_H
#define L3D_PIPELINE_EMPTY_PICTURE_P_H

#include "raster/background.h"

#include <algorithm>
#include <cstdint>

namespace l3d_detail {

/// Whether all pixels of a picture show the background, so that a viewer can say why nothing is
/// seen. Cost: linear in pixels.
inline bool is_empty(const l3d_pixels& picture, const l3d_background& background) {
    for (int y = 0; y < picture.height; ++y)
        if (std::ranges::any_of(picture.row(y), [word = background.word(y, picture.height)](
                                                    std::uint32_t pixel) { return pixel != word; }))
            return false;
    return true;
}

} // namespace l3d_detail

#endif
