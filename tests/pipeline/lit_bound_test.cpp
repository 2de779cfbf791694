// SPDX-License-Identifier: MIT
// What a frame promises of its lit colours, against Blinn's rule at the exact points of each pixel.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "scene/camera_shading.h"
#include "scene/lit_shade_bound.h"
#include "scene/patch_scene.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace {

using dice_tests::scene;
using vector = l3d_camera::vector;

l3d_material shining(int sharpness) {
    return {.color = 0x803020, .highlight = 0xffffff, .sharpness = sharpness};
}

/// The first light is beside the camera, the second one on the other side.
l3d_afd_settings two_lights() {
    l3d_afd_settings settings = hard_edged();
    settings.light = {0.4, 0.8, 0.45};
    settings.lighting.color = {0.8F, 0.9F, 0.6F};
    settings.lighting.add({-1, 0.3, 0.6}, {0.3F, 0.1F, 0.9F});
    return settings;
}

/// The exact channels of a point that is seen.
std::array<double, 3> exact_channels(const l3d_pick& at, const vector& eye,
                                     const l3d_material& material,
                                     const l3d_afd_settings& settings) {
    const vector to_eye = l3d_normalized(eye - at.point);
    const l3d_lighting& lighting = settings.lighting;
    std::array<double, 3> result{};
    for (std::size_t c = 0; c < 3; ++c) {
        const auto part = [&](std::uint32_t color) {
            return static_cast<double>(color >> (16 - 8 * c) & 255);
        };
        double level = part(material.color) * double{lighting.ambient[c]};
        const auto add = [&](const vector& to_light, double strength) {
            const double facing = l3d_dot(at.normal, to_light);
            if (!(facing > 0))
                return;
            const double peak = l3d_dot(at.normal, l3d_normalized(to_light + to_eye));
            level += strength *
                     (0.9 * part(material.color) * facing +
                      part(material.highlight) * std::pow(std::max(0.0, peak), material.sharpness));
        };
        add(l3d_normalized(settings.light), double{lighting.color[c]});
        for (std::size_t i = 0; i < lighting.count; ++i) {
            const auto& d = lighting.lights[i].direction;
            add({double{d[0]}, double{d[1]}, double{d[2]}}, double{lighting.lights[i].color[c]});
        }
        result[c] = std::min(level, 255.0);
    }
    return result;
}

/// What pixels inside surfaces are off.
struct found {
    std::size_t seen = 0, judged = 0, exceptions = 0;
    double most = 0;
};

/// A drawn pixel stands for an exact point within the bound of places: for one of five, here.
/// Pixels of which one of these shows nothing or another sheet are at edges and are not judged.
found judge(const scene& s, const l3d_patch_scene& world, const l3d_material& material,
            const l3d_afd_settings& settings, const std::vector<std::uint32_t>& words,
            const l3d_dice_counts& counts) {
    const l3d_pick_view view{.camera = s.camera, .size = s.size, .one_sided = false};
    const double b = counts.bound_px;
    const std::array<std::array<double, 2>, 5> places{{{0, 0}, {b, 0}, {-b, 0}, {0, b}, {0, -b}}};
    found result;
    for (int y = 0; y < s.size.height; ++y)
        for (int x = 0; x < s.size.width; ++x) {
            double off = std::numeric_limits<double>::infinity();
            bool inside = true, seen = false;
            vector first;
            const std::uint32_t word = words[static_cast<std::size_t>(y * s.size.width + x)];
            for (const auto& [dx, dy] : places) {
                const std::optional<l3d_pick> at =
                    l3d_pick_at(world, view, x + 0.5 + dx, y + 0.5 + dy);
                if (!at || !at->is_proven) {
                    inside = false;
                    break;
                }
                if (!seen)
                    first = at->normal;
                seen = true;
                // Another sheet, or nearly an outline.
                const vector to_eye = l3d_normalized(s.camera.eye - at->point);
                if (l3d_dot(first, at->normal) < 0.9 || l3d_dot(at->normal, to_eye) < 0.1)
                    inside = false;
                const auto exact = exact_channels(*at, s.camera.eye, material, settings);
                double worst = 0;
                for (std::size_t c = 0; c < 3; ++c)
                    worst =
                        std::max(worst, std::abs(double(word >> (16 - 8 * c) & 255) - exact[c]));
                off = std::min(off, worst);
            }
            result.seen += seen;
            if (!inside)
                continue;
            ++result.judged;
            result.most = std::max(result.most, off);
            result.exceptions += !(off <= counts.shade_bound);
        }
    return result;
}

TEST(lit_bound, holds_in_each_pixel_inside_surfaces) {
    constexpr l3d_size size{72, 54};
    const scene dome(reference::load_bpt_plain("tests/data/dome.bpt"),
                     {{0.1, 0.2, 13.94}, {0, 0, 0}, {0.1, 1, 0}, 38, 0.1}, size);
    const scene bumps(reference::load_bpt_plain("tests/data/bump3.bpt"),
                      {{1, 2, 4}, {0, 0, 0}, {0, 1, 0}, 38, 0.1}, size);
    const scene teapot = dice_tests::teapot(reference::project_view("full"), size);
    for (const auto& [name, s] : {std::pair{"dome", &dome}, {"bumps", &bumps}, {"teapot", &teapot}})
        for (const int sharpness : {5, 50})
            for (const double tolerance : {0.25, 0.02}) {
                l3d_patch_scene world;
                world.add(s->model, s->placement);
                const l3d_material material = shining(sharpness);
                world.paint(0, material);
                l3d_afd_settings settings = two_lights();
                settings.tolerance = tolerance;
                l3d_pipeline_afd pipeline(l3d_memory_canvas(size), world, s->camera, settings);
                pipeline.draw_event();
                const l3d_dice_counts& counts = pipeline.report().dice;
                const found all = judge(*s, world, material, settings,
                                        words_of(pipeline.screen().pixels()), counts);
                std::printf("%s, k = %d, %.2f px: bound %.2f, most %.2f, %zu of %zu pixels "
                            "judged, %zu beyond; %lld of %lld quads unproven\n",
                            name, sharpness, tolerance, counts.shade_bound, all.most, all.judged,
                            all.seen, all.exceptions, static_cast<long long>(counts.unproven_quads),
                            static_cast<long long>(pipeline.report().surface.quads));
                EXPECT_LT(counts.shade_bound, 255);
                EXPECT_GT(2 * all.judged, all.seen);
                // Only unproven quads may be farther off; finer steps leave hardly any.
                EXPECT_LE(all.exceptions, tolerance < 0.1 ? 0 : all.judged / 500)
                    << name << ", sharpness " << sharpness;
            }
}

TEST(lit_bound, has_all_of_a_highlight_that_begins_at_once_where_a_light_sets) {
    const l3d_camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}};
    const std::array<l3d_material, 1> materials{shining(20)};
    const auto bound = [&](const vector& light) {
        return l3d_lit_shade_bound(l3d_camera_shading(camera, {40, 30}, l3d_shade::lambert, light),
                                   materials, {40, 30}, {.normal = 1e-3, .way = 1e-4});
    };
    EXPECT_LT(bound({0.3, 0.3, 1}), 2);
    EXPECT_GT(bound({0, 0.1, -1}), 200);
    EXPECT_LE(bound({0, 0, -1}), 256);
}

TEST(lit_bound, grows_with_what_normals_are_off) {
    const l3d_camera camera{.eye = {0, 0, 5}, .target = {0, 0, 0}};
    const std::array<l3d_material, 1> materials{shining(50)};
    const l3d_shading shading =
        l3d_camera_shading(camera, {40, 30}, l3d_shade::lambert, {0.3, 0.3, 1});
    const auto bound = [&](double normal) {
        return l3d_lit_shade_bound(shading, materials, {40, 30}, {.normal = normal, .way = 0});
    };
    // 0.61 sqrt(50) 255 levels a radian, and 0.9 * 128 of scattered light.
    EXPECT_NEAR(bound(2e-3) - bound(1e-3), (0.61 * std::sqrt(50) * 255 + 115) * 1e-3, 0.02);
}

} // namespace
