// SPDX-License-Identifier: MIT
// Anti-aliased pictures against the exact ones: every pixel within its bound, from all sides.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "shown_models.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "raster/depth_buffer.h"
#include "raster/rasterizer_factory.h"
#include "reference/box_image.h"
#include "reference/box_verdict.h"
#include "reference/random_numbers.h"
#include "reference/views.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace {

using dice_tests::scene;
using pipeline_tests::shown_model;

constexpr double tolerances[] = {0.25, 0.05, 0.02};

/// Pictures beside the exact one, with and without anti-aliasing. Returns the root mean square at
/// edges of the first one that has it. Units: levels.
double expect_within_bounds(const std::string& name, const scene& s,
                            std::span<const double> tolerances_px) {
    const reference::box_image exact(s.patches, s.eye, s.picture(), reference::project_light);
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    std::optional<double> edge_rms;
    for (const double tolerance : tolerances_px)
        for (const bool antialias : {false, true}) {
            l3d_afd_settings settings = hard_edged();
            settings.tolerance = tolerance;
            settings.antialias = antialias;
            settings.error_map = true;
            settings.light = {reference::project_light.x, reference::project_light.y,
                              reference::project_light.z};
            l3d_pipeline_afd pipeline(l3d_memory_canvas(s.size), world, s.camera, settings);
            pipeline.draw_event();
            std::vector<double> levels;
            for (const std::uint32_t word : words_of(pipeline.screen().pixels()))
                levels.push_back(word & 0xff);
            std::vector<float> bounds;
            for (int y = 0; y < s.size.height; ++y)
                for (int x = 0; x < s.size.width; ++x)
                    bounds.push_back(pipeline.error_map()->at(x, y));
            const reference::box_verdict verdict = reference::judge_boxes(levels, exact, bounds);
            const l3d_frame_report report = pipeline.report();
            std::printf("%s, %.3f px, %s: %ld shown, %ld edges, %.1f %% judged; levels rms "
                        "%.2f, of edges %.2f, largest %.0f at (%d, %d); coverage %.3f, colour "
                        "%.2f; %ld exceptions\n",
                        name.c_str(), tolerance, antialias ? "smooth" : "sharp ",
                        static_cast<long>(verdict.shown), static_cast<long>(verdict.edges),
                        100 * verdict.judged_share(), verdict.rms, verdict.edge_rms,
                        verdict.largest, verdict.largest_x, verdict.largest_y,
                        report.coverage_bound, report.color_bound,
                        static_cast<long>(verdict.exceptions));
            EXPECT_EQ(verdict.exceptions, 0) << name;
            EXPECT_EQ(verdict.judged, verdict.pixels) << name;
            if (antialias && !edge_rms)
                edge_rms = verdict.edge_rms;
        }
    return edge_rms.value();
}

/// What `expect_within_bounds` returns of each picture.
std::vector<double> expect_all_within_bounds(l3d_size size, std::size_t step) {
    std::vector<double> edge_rms;
    for (const shown_model& each : pipeline_tests::shown_models())
        for (std::size_t view = 0; view < 12; view += step)
            edge_rms.push_back(expect_within_bounds(each.name + ' ' + std::to_string(view),
                                                    scene(each.patches, each.views[view], size),
                                                    tolerances));
    return edge_rms;
}

/// View 0 of each model. Outlines are finer than the tolerance: where the dicer takes no finer
/// steps there, their levels are off by 4.66 and 3.06. Limits are 1.2 times what was measured: 3.20
/// and 1.77.
TEST(antialiased, pictures_are_within_their_bounds) {
    const std::vector<double> edge_rms = expect_all_within_bounds({56, 42}, 12);
    EXPECT_LT(edge_rms.at(0), 3.84);
    EXPECT_LT(edge_rms.at(3), 2.12);
}

/// Two minutes: twelve views of four models.
TEST(antialiased, DISABLED_pictures_are_within_their_bounds_from_twelve_sides) {
    expect_all_within_bounds({80, 60}, 1);
}

/// A camera that looks somewhere near a model: from inside or far away, through any lens, and with
/// its head on one side.
reference::camera random_camera(const reference::camera& usual, reference::random_numbers& random) {
    const auto around = [&](const reference::vec3& middle, double size) -> reference::vec3 {
        return {middle.x + size * random.between(-1, 1), middle.y + size * random.between(-1, 1),
                middle.z + size * random.between(-1, 1)};
    };
    const double distance = std::hypot(usual.eye.x - usual.target.x, usual.eye.y - usual.target.y,
                                       usual.eye.z - usual.target.z);
    return {around(usual.target, distance * random.of_any_size(0.06, 30)),
            around(usual.target, 0.3 * distance), around({}, 1), random.of_any_size(1, 160),
            random.of_any_size(1e-3, 1)};
}

void expect_random_cameras_within_bounds(std::uint64_t first, std::uint64_t end) {
    const auto models = pipeline_tests::shown_models();
    constexpr double any_tolerance[] = {1, 0.25, 0.05, 0.02, 0.013};
    for (std::uint64_t seed = first; seed < end; ++seed) {
        reference::random_numbers random(seed);
        const shown_model& shown = models[random.below(models.size())];
        const reference::camera eye = random_camera(shown.views[random.below(12)], random);
        const l3d_size size{1 + static_cast<int>(random.below(64)),
                            1 + static_cast<int>(random.below(48))};
        const double tolerance = any_tolerance[random.below(std::size(any_tolerance))];
        expect_within_bounds("seed " + std::to_string(seed) + ", " + shown.name,
                             scene(shown.patches, eye, size), {&tolerance, 1});
    }
}

TEST(antialiased, pictures_of_random_cameras_are_within_their_bounds) {
    expect_random_cameras_within_bounds(0, 8);
}

/// Eight minutes: 4000 pictures.
TEST(antialiased, DISABLED_pictures_of_two_thousand_random_cameras_are_within_their_bounds) {
    expect_random_cameras_within_bounds(0, 2000);
}

} // namespace
