// SPDX-License-Identifier: MIT
// Pictures with smooth edges beside the mean of 8 x 8 times the pixels.
#ifndef L3D_TESTS_PIPELINE_BESIDE_LARGER_H
#define L3D_TESTS_PIPELINE_BESIDE_LARGER_H

#include "pipeline/pipeline_afd.h"
#include "raster/color/srgb_light.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace pipeline_tests {

/// How many pixels are farther than `levels` from the mean light of 8 x 8 times the pixels without
/// smooth edges.
/// Shape: greys_of(size, smooth) gives the grey of each pixel, row by row.
template <class GreysOf> int pixels_far_off(const GreysOf& greys_of, l3d_size size, int levels) {
    constexpr int times = 8;
    const std::vector<int> smooth = greys_of(size, true);
    const std::vector<int> large = greys_of({times * size.width, times * size.height}, false);
    int result = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            double light = 0;
            for (int row = times * y; row < times * (y + 1); ++row)
                for (int column = times * x; column < times * (x + 1); ++column)
                    light += l3d_light_of_level(
                        large[static_cast<std::size_t>(row * times * size.width + column)]);
            const double exact = l3d_level_of_light(light / (times * times));
            const int drawn = smooth[static_cast<std::size_t>(y * size.width + x)];
            result += std::abs(drawn - exact) > levels;
        }
    return result;
}

/// The greys that a pipeline has drawn, row by row.
inline std::vector<int> greys_drawn(l3d_pipeline_afd& pipeline) {
    std::vector<int> result;
    const auto pixels = pipeline.screen().pixels();
    for (int y = 0; y < pixels.height; ++y)
        for (const std::uint32_t word : pixels.row(y))
            result.push_back(static_cast<int>(word & 255));
    return result;
}

} // namespace pipeline_tests

#endif
