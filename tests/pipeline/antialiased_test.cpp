// SPDX-License-Identifier: MIT
// Anti-aliased pictures against the exact ones: every pixel within its bound, from all sides.
#include "../dice/scene.h"
#include "shown_models.h"
#include "words_of.h"

#include "pipeline/pipeline_afd.h"
#include "raster/error_map.h"
#include "raster/rasterizer_factory_sw.h"
#include "reference/box_image.h"
#include "reference/box_verdict.h"
#include "reference/views.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

using dice_tests::scene;
using pipeline_tests::shown_model;

constexpr double tolerances[] = {0.25, 0.05, 0.02};

/// A picture beside the exact one, with and without anti-aliasing.
void expect_within_bounds(const shown_model& shown, std::size_t view, l3d_size size) {
    const scene s(shown.patches, shown.views[view], size);
    const reference::box_image exact(s.patches, s.eye, s.picture(), reference::project_light);
    l3d_patch_scene world;
    world.add(s.model, s.placement);
    for (const double tolerance : tolerances)
        for (const bool antialias : {false, true}) {
            l3d_afd_settings settings;
            settings.tolerance = tolerance;
            settings.antialias = antialias;
            settings.error_map = true;
            settings.light = {reference::project_light.x, reference::project_light.y,
                              reference::project_light.z};
            l3d_pipeline_afd pipeline(l3d_memory_canvas(size), world, s.camera, settings);
            pipeline.draw_event();
            std::vector<double> levels;
            for (const std::uint32_t word : words_of(pipeline.screen().pixels()))
                levels.push_back(word & 0xff);
            std::vector<float> bounds;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x)
                    bounds.push_back(pipeline.error_map()->at(x, y));
            const reference::box_verdict verdict = reference::judge_boxes(levels, exact, bounds);
            const l3d_frame_report report = pipeline.report();
            std::printf("%-8s %2zu, %.2f px, %s: %ld shown, %ld edges, %.1f %% judged; levels rms "
                        "%.2f, of edges %.2f, largest %.0f at (%d, %d); coverage %.3f, colour "
                        "%.2f; %ld exceptions\n",
                        shown.name.c_str(), view, tolerance, antialias ? "smooth" : "sharp ",
                        static_cast<long>(verdict.shown), static_cast<long>(verdict.edges),
                        100 * verdict.judged_share(), verdict.rms, verdict.edge_rms,
                        verdict.largest, verdict.largest_x, verdict.largest_y,
                        report.coverage_bound, report.color_bound,
                        static_cast<long>(verdict.exceptions));
            EXPECT_EQ(verdict.exceptions, 0);
            EXPECT_EQ(verdict.judged, verdict.pixels);
        }
}

void expect_all_within_bounds(l3d_size size, std::size_t step) {
    for (const shown_model& each : pipeline_tests::shown_models())
        for (std::size_t view = 0; view < 12; view += step)
            expect_within_bounds(each, view, size);
}

/// View 0 of each model.
TEST(antialiased, pictures_are_within_their_bounds) {
    expect_all_within_bounds({56, 42}, 12);
}

/// Two minutes: twelve views of four models.
TEST(antialiased, DISABLED_pictures_are_within_their_bounds_from_twelve_sides) {
    expect_all_within_bounds({80, 60}, 1);
}

} // namespace
