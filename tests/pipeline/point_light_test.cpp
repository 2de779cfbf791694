// SPDX-License-Identifier: MIT
// Lights at places: each pixel by the exact point and normal that a pick finds.
#include "hard_edged.h"
#include "words_of.h"

#include "geom/polygon_shapes.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/rasterizer_factory.h"
#include "scene/patch_scene.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace {

using vector = l3d_camera::vector;

constexpr l3d_size size{121, 91};
constexpr l3d_material clay{.color = 0xd0a080};

l3d_camera above() {
    l3d_camera camera;
    camera.eye = {3.1, 2.3, 4.2};
    camera.target = {0.1, 0, 0};
    return camera;
}

/// Nothing far away gives light. One light fades with distance, the other does not.
l3d_lighting two_points() {
    l3d_lighting lighting;
    lighting.color = {0, 0, 0};
    lighting.add_point({{1.5, 1.2, 1.4}, 1.5F, {1, 0.9F, 0.6F}});
    lighting.add_point({{-2, 3, 2}, 0, {0.1F, 0.2F, 0.4F}});
    return lighting;
}

double channel(const l3d_lighting& lighting, const vector& point, const vector& normal,
               std::size_t i) {
    double light = double{lighting.ambient[i]};
    for (std::size_t k = 0; k < lighting.point_count; ++k) {
        const l3d_point_light& of = lighting.points[k];
        const vector way = of.position - point;
        const double distance = l3d_length(way), reach = double{of.reach};
        light += 0.9 * std::max(0.0, l3d_dot(normal, way) / distance) * double{of.color[i]} *
                 (reach > 0 ? reach * reach / (distance * distance) : 1);
    }
    return std::min(255.0, light * (clay.color >> (16 - 8 * i) & 255));
}

/// What is seen at a place of the picture, or nothing.
struct seen_point {
    vector point, normal;
};

/// Counts pixels that are more than `most` levels off. Where neighbours show other normals, there
/// are edges, and the nearest sample may be on either side.
template <class SeenAt>
void expect_as_the_rule_says(const std::vector<std::uint32_t>& words, const SeenAt& seen_at,
                             double most) {
    int judged = 0, off = 0, bright = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::optional<seen_point> seen = seen_at(x + 0.5, y + 0.5);
            bool inside = seen.has_value();
            for (const double aside : {-0.7, 0.7})
                for (const bool along_x : {false, true}) {
                    const auto near =
                        seen_at(x + 0.5 + (along_x ? aside : 0), y + 0.5 + (along_x ? 0 : aside));
                    inside = inside && near && l3d_dot(near->normal, seen->normal) > 0.9999;
                }
            if (!inside)
                continue;
            ++judged;
            const std::uint32_t word = words[static_cast<std::size_t>(y * size.width + x)];
            for (std::size_t i = 0; i < 3; ++i) {
                const double exact = channel(two_points(), seen->point, seen->normal, i);
                off += std::abs((word >> (16 - 8 * i) & 255) - exact) > most;
                bright += exact > 150;
            }
        }
    EXPECT_GT(judged, 700);
    EXPECT_GT(bright, 100);
    EXPECT_LE(off, judged / 200);
}

template <class Pipeline> void expect_polygons_as_the_rule_says() {
    for (const l3d_projection projection : {l3d_projection::perspective, l3d_projection::parallel})
        for (const bool antialias : {false, true}) {
            SCOPED_TRACE(testing::Message() << int(projection) << antialias);
            l3d_polygon_settings settings = hard_edged_polygons();
            l3d_camera from = above();
            from.projection = projection;
            settings.antialias = antialias;
            settings.lighting = two_points();
            settings.headlight = false;
            settings.material = clay;
            Pipeline pipeline(l3d_memory_canvas(size), l3d_polygon_model(l3d_sphere_mesh(12, 8)),
                              from, settings);
            pipeline.draw_event();
            expect_as_the_rule_says(
                words_of(pipeline.screen().pixels()),
                [&](double x, double y) -> std::optional<seen_point> {
                    const auto at = pipeline.pick(x, y);
                    if (!at)
                        return {};
                    return seen_point{at->point, at->normal};
                },
                2);
        }
}

TEST(point_light, is_on_polygons_as_the_rule_says) {
    expect_polygons_as_the_rule_says<l3d_pipeline_zbuffer>();
}

TEST(point_light, is_on_sorted_polygons_as_the_rule_says) {
    expect_polygons_as_the_rule_says<l3d_pipeline_zsort>();
}

TEST(point_light, is_on_patches_as_the_rule_says_and_has_no_bound_of_shades) {
    l3d_patch_scene scene(l3d_patch_model::teapot());
    scene.paint(0, clay);
    l3d_camera camera = above();
    camera.eye = {2.2, 5.1, 6.4};
    camera.target = {0.1, 1.3, 0};
    l3d_afd_settings settings = hard_edged();
    settings.lighting = two_points();
    settings.lighting.points[0].position = {1.5, 4, 3};
    settings.lighting.points[0].reach = 2.5F;
    settings.headlight = false;
    settings.tolerance = 0.05;
    settings.error_map = true;
    l3d_pipeline_afd pipeline(l3d_memory_canvas(size), scene, camera, settings);
    pipeline.draw_event();
    EXPECT_TRUE(std::isinf(pipeline.report().dice.shade_bound));
    EXPECT_LT(pipeline.report().dice.bound_px, 0.06);
    EXPECT_EQ(pipeline.error_map(), nullptr);
    const std::vector<std::uint32_t> words = words_of(pipeline.screen().pixels());
    const l3d_pick_view view{.camera = camera, .size = size, .one_sided = false};
    int judged = 0, off = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const std::optional<l3d_pick> at = l3d_pick_at(scene, view, x + 0.5, y + 0.5);
            if (!at || !at->is_proven ||
                l3d_dot(at->normal, l3d_normalized(camera.eye - at->point)) < 0.3)
                continue;
            ++judged;
            for (std::size_t i = 0; i < 3; ++i)
                off +=
                    std::abs((words[static_cast<std::size_t>(y * size.width + x)] >> (16 - 8 * i) &
                              255) -
                             channel(settings.lighting, at->point, at->normal, i)) > 6;
        }
    EXPECT_GT(judged, 1500);
    EXPECT_LE(off, judged / 50); // outlines and creases
}

} // namespace
