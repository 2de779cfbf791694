// SPDX-License-Identifier: MIT
// Smooth edges of what is thinner than a pixel, beside the mean of 8 x 8 times the pixels.
#include "pipeline/pipeline_afd.h"
#include "raster/srgb_light.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace {

/// The greys of a teapot that fills the picture.
std::vector<int> greys(l3d_size size, bool smooth) {
    l3d_afd_settings settings;
    settings.threads = 1;
    settings.antialias = smooth;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), l3d_patch_model::teapot(),
                              {.eye = {3.2, 3.6, 7.4}, .target = {0.2, 1.3, 0}}, settings);
    pipeline.frame_all();
    pipeline.draw_event();
    std::vector<int> result;
    for (int y = 0; y < size.height; ++y)
        for (const std::uint32_t word : pipeline.screen().pixels().row(y))
            result.push_back(static_cast<int>(word & 255));
    return result;
}

/// Below the body a bright rim, half a pixel wide, lies between a dark side and the background.
TEST(thin_rim, is_no_row_of_beads) {
    constexpr int width = 320, height = 240, times = 8;
    const std::vector<int> smooth = greys({width, height}, true),
                           large = greys({times * width, times * height}, false);
    int far_off = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double light = 0;
            for (int row = times * y; row < times * (y + 1); ++row)
                for (int column = times * x; column < times * (x + 1); ++column)
                    light += l3d_light_of_level(
                        large[static_cast<std::size_t>(row * times * width + column)]);
            const double exact = l3d_level_of_light(light / (times * times));
            far_off += std::abs(smooth[static_cast<std::size_t>(y * width + x)] - exact) > 30;
        }
    // What was measured: 17, and 51 where the dark side's levels are taken for the rim's.
    EXPECT_LE(far_off, 25);
}

} // namespace
