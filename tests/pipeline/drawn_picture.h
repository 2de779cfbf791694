// SPDX-License-Identifier: MIT
// A scene's picture by a whole pipeline.
#ifndef L3D_TESTS_PIPELINE_DRAWN_PICTURE_H
#define L3D_TESTS_PIPELINE_DRAWN_PICTURE_H

#include "../dice/scene.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"
#include "raster/pixel_bits.h"

#include <cstdint>
#include <limits>
#include <vector>

namespace pipeline_tests {

struct picture {
    std::vector<std::uint32_t> words;
    std::vector<float> distances; ///< along the view axis, infinite where nothing is; if asked for
    l3d_frame_report report;
    l3d_pixel_bits outlines; ///< if asked for
};

inline picture drawn(const dice_tests::scene& s, const l3d_patch_scene& world,
                     const l3d_afd_settings& settings) {
    l3d_pipeline_afd pipeline(l3d_memory_canvas(s.size), world, s.camera, settings);
    pipeline.draw_event();
    picture result{words_of(pipeline.screen().pixels()), {}, pipeline.report(), {}};
    if (pipeline.outlines())
        result.outlines = *pipeline.outlines();
    for (int y = 0; settings.depth && y < s.size.height; ++y)
        for (const float inv_w : pipeline.depth().row(y))
            result.distances.push_back(inv_w > 0 ? 1 / inv_w
                                                 : std::numeric_limits<float>::infinity());
    return result;
}

} // namespace pipeline_tests

#endif
