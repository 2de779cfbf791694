// SPDX-License-Identifier: MIT
// Fog before polygons: each pixel by the exact distance of what a pick meets there.
#include "effort.h"
#include "hard_edged.h"
#include "words_of.h"

#include "geom/polygon_shapes.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/rasterizer_factory.h"
#include "base/error.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

constexpr l3d_size size{131, 97};
constexpr l3d_fog fog{.from = 4.9F, .to = 6.5F, .color = 0x4060a0};

/// Compares a fogged picture with the clear one of the same polygons, before a gradient.
template <class Pipeline, class... More>
void expect_each_pixel_faded(const l3d_polygon_settings& settings, l3d_projection projection,
                             const More&... more) {
    l3d_camera camera;
    camera.eye = {3.1, 2.3, 4.2};
    camera.projection = projection;
    const l3d_polygon_model model(l3d_sphere_mesh(24, 12));
    l3d_polygon_settings foggy = settings;
    foggy.fog = fog;
    Pipeline clear(l3d_memory_canvas(size), model, camera, settings, more...);
    Pipeline faded(l3d_memory_canvas(size), model, camera, foggy, more...);
    clear.draw_event();
    faded.draw_event();
    const auto before = words_of(clear.screen().pixels()),
               after = words_of(faded.screen().pixels());
    int judged = 0, changed = 0, off = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const auto i = static_cast<std::size_t>(y * size.width + x);
            const auto at = faded.pick(x + 0.5, y + 0.5);
            if (!at) {
                off += before[i] != after[i]; // the background stays
                continue;
            }
            ++judged;
            const double share = std::clamp(
                (at->depth - double{fog.from}) / (double{fog.to} - double{fog.from}), 0.0, 1.0);
            for (const int shift : {0, 8, 16}) {
                const double own = before[i] >> shift & 255, to = *fog.color >> shift & 255;
                const double shown = after[i] >> shift & 255;
                // The amount, both products and the clear level are whole numbers.
                off += std::abs(shown - (own + share * (to - own))) > 2.5;
                changed += shown != own;
            }
        }
    EXPECT_GT(judged, 1500);
    EXPECT_GT(changed, judged);
    EXPECT_LE(off, judged / 200); // vertices lie on sub-pixels, so edges may be a pixel off
}

TEST(polygon_fog, fades_each_pixel_by_its_exact_distance) {
    for (const l3d_shade shade : {l3d_shade::flat, l3d_shade::lambert, l3d_shade::gouraud})
        for (const auto& [highlight, projection] :
             {std::pair(0x000000U, l3d_projection::perspective),
              {0xffffffU, l3d_projection::perspective},
              {0x000000U, l3d_projection::parallel}}) {
            if (!thorough && (shade == l3d_shade::gouraud) != (highlight != 0))
                continue;
            l3d_polygon_settings settings = hard_edged_polygons();
            settings.shade = shade;
            settings.background = l3d_background::gradient();
            settings.material = l3d_material{.color = 0xc06020, .highlight = highlight};
            expect_each_pixel_faded<l3d_pipeline_zbuffer>(settings, projection,
                                                          l3d_rasterizer_factory_sw());
            expect_each_pixel_faded<l3d_pipeline_zsort>(settings, projection);
        }
}

TEST(polygon_fog, is_drawn_by_processors_where_gl_has_none) {
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.fog = fog;
    const auto words = [&](const l3d_rasterizer_factory& factory) {
        l3d_camera camera;
        camera.eye = {3.1, 2.3, 4.2};
        l3d_pipeline_zbuffer pipeline(l3d_memory_canvas(size),
                                      l3d_polygon_model(l3d_sphere_mesh(24, 12)), camera, settings,
                                      factory);
        pipeline.draw_event();
        return words_of(pipeline.screen().pixels());
    };
    try {
        EXPECT_EQ(words(l3d_rasterizer_factory_mesa()), words(l3d_rasterizer_factory_sw()));
    } catch (const l3d_error&) { // no GL here
    }
}

TEST(polygon_fog, changes_no_bit_before_it_begins) {
    l3d_camera camera;
    camera.eye = {3.1, 2.3, 4.2};
    const auto words = [&](const l3d_fog& of) {
        l3d_polygon_settings settings = hard_edged_polygons();
        settings.shade = l3d_shade::lambert;
        settings.fog = of;
        l3d_pipeline_zsort pipeline(l3d_memory_canvas(size),
                                    l3d_polygon_model(l3d_sphere_mesh(24, 12)), camera, settings);
        pipeline.draw_event();
        return words_of(pipeline.screen().pixels());
    };
    EXPECT_EQ(words({}), words({.from = 50, .to = 60, .color = 0}));
}

} // namespace
