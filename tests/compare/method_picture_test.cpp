// SPDX-License-Identifier: MIT
// Whole pictures of every method against the exact one.
#include "hard_edged.h"
#include "dice/scene.h"

#include "compare/method_choice.h"
#include "pipeline/pipeline_afd.h"
#include "raster/rasterizer_factory.h"
#include "reference/exact.h"
#include "reference/measure.h"
#include "reference/region.h"
#include "base/error.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dice_tests {
namespace {

constexpr l3d_size size{233, 171};

/// How far off a method may be, in pixels, and how many pixels it may leave out.
struct expectation {
    const char* method;
    double outline, depth; ///< largest
    int holes;
    bool certified;
    int failures = 0; ///< at most
};

/// `afd` and its like keep 0.25 px in the picture; along the line of sight nothing is promised, and
/// the point that is drawn is up to 0.297 px from the exact tangent plane. A cell of 1/256 of the
/// teapot is 0.8 pixels here, its diagonal 1.4. Where iterations fail, and in cracks, the surface
/// behind is seen.
constexpr expectation expectations[] = {
    {"afd", 0.26, 0.35, 0, true},
    {"fd", 0.26, 0.26, 0, true},
    {"subdivision", 0.26, 0.35, 0, true},
    {"tessellation:64", 0.26, 0.05, 0, true},
    {"micropolygons:2", 0.05, 0.1, 0, true},
    {"micropolygons:4", 0.05, 0.1, 0, true},
    {"kept:2", 0.05, 0.1, 0, false},
    {"isocurves:2", 1.0, 0.75, 0, false},
    {"scanline", 0.05, 0.1, 0, false},
    {"whitted", 0.3, 30, 0, false, 40},
    {"blinn", 8, 120, 5, false, 400},
    {"lane-carpenter", 0.3, 40, 0, false},
    {"voxels:256", 1.5, 1.5, 5, false},
    {"mesa", 0.3, 0.26, 0, false},
};

l3d_afd_settings settings_of(const std::string& method, int threads) {
    l3d_afd_settings settings = hard_edged();
    std::string why;
    settings.method = l3d_method_choice::from_name(method, why).value().factory();
    settings.depth = true;
    settings.threads = threads;
    return settings;
}

TEST(method_picture, is_like_the_exact_one) {
    const scene s = teapot(reference::project_view("full"), size);
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    const reference::exact_region region(s.patches, s.eye, s.picture());
    for (const expectation& expected : expectations) {
        std::optional<l3d_pipeline_afd> pipeline;
        try {
            pipeline.emplace(l3d_memory_canvas(size), s.model, s.camera,
                             settings_of(expected.method, 1));
        } catch (const l3d_error& error) {
            std::printf("%-15s left out: %s\n", expected.method, error.what());
            continue;
        }
        pipeline->draw_event();
        const reference::error_map errors =
            reference::map_errors(l3d_distances(pipeline->depth()), exact, region, 60);
        double outline = 0, depth = 0;
        for (std::size_t i = 0; i < errors.depth.size(); ++i) {
            outline = std::fmax(outline, static_cast<double>(errors.outline[i]));
            depth = std::fmax(depth, static_cast<double>(errors.depth[i]));
        }
        const auto holes = std::count(errors.holes.begin(), errors.holes.end(), true);
        const l3d_frame_report report = pipeline->report();
        std::printf("%-15s outline %.3f px, depth %.3f px, of %.1f %%, %ld holes, %ld failures\n",
                    expected.method, outline, depth, 100 * errors.depth_share(),
                    static_cast<long>(holes), static_cast<long>(report.dice.failures));
        EXPECT_LE(outline, expected.outline) << expected.method;
        EXPECT_LE(depth, expected.depth) << expected.method;
        // 11.3 % of what is covered is at outlines and jumps.
        EXPECT_GT(errors.depth_share(), 0.88) << expected.method;
        EXPECT_LE(holes, expected.holes) << expected.method;
        EXPECT_EQ(std::isfinite(report.dice.bound_px), expected.certified) << expected.method;
        EXPECT_EQ(settings_of(expected.method, 1).method.has_bound(), expected.certified)
            << expected.method;
        EXPECT_LE(report.dice.failures, expected.failures) << expected.method;
        EXPECT_EQ(report.dice.failures > 0, expected.failures > 0) << expected.method;
        EXPECT_EQ(report.method, expected.method);
    }
}

/// Those that draw parallel projections do so as exactly; the others are refused by name.
TEST(method_picture, in_parallel_projection_is_like_the_exact_one_or_refused) {
    reference::camera eye = reference::project_view("full").eye;
    eye.parallel = true;
    const scene s{reference::load_bpt_plain("data/teapot.bpt"), eye, size};
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    const reference::exact_region region(s.patches, s.eye, s.picture());
    int drawn = 0, refused = 0;
    for (const expectation& expected : expectations) {
        const l3d_afd_settings settings = settings_of(expected.method, 1);
        const std::string why = l3d_afd_complaint(s.camera, size, settings);
        if (!settings.method.draws_parallel()) {
            EXPECT_NE(why.find(settings.method.name()), std::string::npos) << why;
            ++refused;
            continue;
        }
        ASSERT_EQ(why, "");
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), s.model, s.camera, settings);
        pipeline.draw_event();
        const reference::error_map errors =
            reference::map_errors(pipeline.distances(), exact, region, 60);
        double outline = 0, depth = 0;
        for (std::size_t i = 0; i < errors.depth.size(); ++i) {
            outline = std::fmax(outline, static_cast<double>(errors.outline[i]));
            depth = std::fmax(depth, static_cast<double>(errors.depth[i]));
        }
        std::printf("%-15s outline %.3f px, depth %.3f px\n", expected.method, outline, depth);
        // Limits are those of the perspective view; this one differs by a tenth at most.
        EXPECT_LE(outline, std::max(1.1 * expected.outline, 0.3)) << expected.method;
        EXPECT_LE(depth, std::max(1.1 * expected.depth, 0.3)) << expected.method;
        ++drawn;
    }
    EXPECT_GE(drawn, 6);
    EXPECT_GE(refused, 5);
}

/// Methods that clip polygons clip as exactly as the bound says, where there is one.
TEST(method_picture, a_tessellations_outline_is_within_its_bound) {
    int bounds = 0;
    for (const char* name : {"full", "closeup", "top", "near_cut"}) {
        const scene s = teapot(reference::project_view(name), size);
        const reference::exact_image exact(s.patches, s.eye, s.picture());
        const reference::exact_region region(s.patches, s.eye, s.picture());
        for (const char* method : {"tessellation:4", "tessellation:16", "tessellation:64"}) {
            l3d_pipeline_afd pipeline(l3d_memory_canvas(size), s.model, s.camera,
                                      settings_of(method, 2));
            pipeline.draw_event();
            const reference::error_map errors =
                reference::map_errors(l3d_distances(pipeline.depth()), exact, region, 60);
            double outline = 0;
            for (const float each : errors.outline)
                outline = std::fmax(outline, static_cast<double>(each));
            const double bound = pipeline.report().dice.bound_px;
            EXPECT_LE(outline, bound) << name << ' ' << method;
            bounds += std::isfinite(bound);
            std::printf("%-9s %-16s outline %.3f px, bound %.3f px\n", name, method, outline,
                        bound);
        }
    }
    EXPECT_GE(bounds, 10);
}

TEST(method_picture, is_the_same_for_any_number_of_threads_and_in_the_next_frame) {
    const scene s = teapot(reference::project_view("near_cut"), size);
    for (const expectation& each : expectations) {
        if (each.method == std::string("mesa"))
            continue; // what GL does with its threads is not ours
        std::uint64_t hashes[2] = {};
        for (const int threads : {1, 2}) {
            l3d_pipeline_afd pipeline(l3d_memory_canvas(size), s.model, s.camera,
                                      settings_of(each.method, threads));
            pipeline.draw_event();
            const std::uint64_t first = pipeline.report().hash;
            pipeline.draw_event();
            EXPECT_EQ(pipeline.report().hash, first) << each.method;
            hashes[threads - 1] = first;
        }
        EXPECT_EQ(hashes[0], hashes[1]) << each.method;
    }
}

/// A method must not take the data that it keeps of a model for those of the next, which may come
/// to the same memory.
TEST(method_picture, of_models_that_come_and_go_is_that_of_a_new_program) {
    const scene s = teapot(reference::project_view("full"), size);
    const auto part = [&](std::size_t frame) {
        const auto first = s.model.patches().begin() + static_cast<std::ptrdiff_t>(7 * frame);
        return l3d_patch_model(std::vector(first, first + 7));
    };
    for (const char* method : {"tessellation:8", "voxels:32", "kept:1", "mesa"}) {
        std::optional<l3d_pipeline_afd> pipeline;
        try {
            pipeline.emplace(l3d_memory_canvas(size), part(0), s.camera, settings_of(method, 1));
        } catch (const l3d_error& error) {
            std::printf("%-15s left out: %s\n", method, error.what());
            continue;
        }
        for (std::size_t frame = 0; frame < 4; ++frame) {
            pipeline->scene().clear();
            pipeline->scene().add(part(frame));
            pipeline->draw_event();
            l3d_pipeline_afd fresh(l3d_memory_canvas(size), part(frame), s.camera,
                                   settings_of(method, 1));
            fresh.draw_event();
            EXPECT_EQ(pipeline->report().hash, fresh.report().hash) << method << ' ' << frame;
        }
    }
}

/// Counting reads every pixel's depth, so it is left out unless somebody reports it.
TEST(method_picture, counts_covered_pixels_only_for_who_asks) {
    const scene s = teapot(reference::project_view("full"), size);
    for (const char* method : {"afd", "fd", "tessellation", "scanline", "voxels:32", "mesa"}) {
        SCOPED_TRACE(method);
        const auto drawn = [&](bool depth, bool counted) {
            l3d_afd_settings settings = settings_of(method, 1);
            settings.depth = depth;
            settings.count_pixels = counted;
            auto pipeline = std::make_unique<l3d_pipeline_afd>(l3d_memory_canvas(size), s.model,
                                                               s.camera, settings);
            pipeline->draw_event();
            return pipeline;
        };
        const auto with_depth = drawn(true, true), counted = drawn(false, true);
        const l3d_frame_report report = counted->report();
        EXPECT_GT(report.surface.covered, 1000);
        EXPECT_EQ(report.surface.covered, l3d_covered(with_depth->depth()));
        EXPECT_EQ(with_depth->report().surface.covered, report.surface.covered);
        const l3d_frame_report quiet = drawn(false, false)->report();
        EXPECT_EQ(quiet.surface.covered, l3d_surface_counts::none_counted);
        EXPECT_EQ(quiet.hash, report.hash);
    }
}

TEST(method_choice, is_read_as_it_is_written) {
    std::string why;
    for (const char* name :
         {"afd", "fd", "fd:12", "isocurves:3", "subdivision", "tessellation:16", "micropolygons:1",
          "scanline", "whitted", "blinn", "lane-carpenter", "voxels:256", "mesa"})
        EXPECT_EQ(l3d_method_choice::from_name(name, why).value().name(), name);
    EXPECT_EQ(l3d_method_choice::from_name("voxels", why).value().resolution, 256);
    EXPECT_EQ(l3d_method_choice::from_name("micropolygons", why).value().resolution, 2);
    for (const char* name :
         {"", "AFD", "afd:2", "tessellation:", "tessellation:0", "tessellation:193",
          "tessellation:8x", "tessellation:-4", "isocurves:17", "voxels:7"})
        EXPECT_FALSE(l3d_method_choice::from_name(name, why)) << name;
    EXPECT_EQ(why, "'voxels:7' needs a number from 8 to 1024");
}

} // namespace
} // namespace dice_tests
