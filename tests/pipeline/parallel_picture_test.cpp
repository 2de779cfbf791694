// SPDX-License-Identifier: MIT
// Whole frames of patches in parallel projection, against the exact picture and picks.
#include "hard_edged.h"
#include "../dice/scene.h"
#include "scene/bodies.h"
#include "still_studio.h"

#include "base/error.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/surface_method.h"
#include "raster/pixel_bits.h"
#include "reference/measure.h"
#include "reference/random_numbers.h"
#include "reference/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace {

using dice_tests::scene;
using still_tests::tester;
using picture = std::vector<std::uint32_t>;

constexpr l3d_size size{203, 149};

scene parallel_teapot(const char* view) {
    reference::camera eye = reference::project_view(view).eye;
    eye.parallel = true;
    return {reference::load_bpt_plain("data/teapot.bpt"), eye, size};
}

l3d_afd_settings with_depth() {
    l3d_afd_settings settings = hard_edged();
    settings.depth = true;
    return settings;
}

int differing(const picture& a, const picture& b) {
    int count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        count += a[i] != b[i];
    return count;
}

TEST(parallel_picture, is_within_its_bounds_of_the_exact_one) {
    constexpr double judges = 0.004; // what the exact renderer may be off
    for (const char* view : {"full", "closeup", "top"}) {
        SCOPED_TRACE(view);
        const scene s = parallel_teapot(view);
        const reference::exact_image exact(s.patches, s.eye, s.picture());
        const reference::exact_region region(s.patches, s.eye, s.picture());
        tester program(s.model, s.camera, with_depth());
        program.draw_event();
        const l3d_frame_report report = program.report();
        EXPECT_LE(report.dice.bound_px, 0.25);
        const reference::error_map errors =
            reference::map_errors(program.distances(), exact, region, 60);
        double outline = 0, depth = 0;
        for (std::size_t i = 0; i < errors.depth.size(); ++i) {
            outline = std::fmax(outline, static_cast<double>(errors.outline[i]));
            depth = std::fmax(depth, static_cast<double>(errors.depth[i]));
        }
        std::printf("%-8s outline %.3f px of %.3f, depth %.3f px of %.3f\n", view, outline,
                    report.dice.bound_px, depth, report.dice.depth_bound_px);
        EXPECT_LE(outline, report.dice.bound_px + judges);
        EXPECT_LE(depth, report.dice.bound_px + report.dice.depth_bound_px + judges);
        EXPECT_GT(errors.depth_share(), 0.8);
        EXPECT_EQ(std::count(errors.holes.begin(), errors.holes.end(), true), 0);
    }
}

TEST(parallel_picture, picks_find_what_the_exact_picture_shows) {
    const scene s = parallel_teapot("full");
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    tester program(s.model, s.camera, with_depth());
    int found = 0;
    for (int y = 3; y < size.height; y += 7)
        for (int x = 3; x < size.width; x += 7) {
            const auto pick = program.pick(x + 0.5, y + 0.5);
            ASSERT_EQ(pick.has_value(), exact.covered(x, y)) << x << ", " << y;
            if (!pick || !pick->is_proven)
                continue;
            ++found;
            EXPECT_EQ(static_cast<int>(pick->patch), exact.at(x, y).patch);
            EXPECT_NEAR(pick->depth, exact.at(x, y).w, 1e-6);
            EXPECT_NEAR(s.camera.depth_of(pick->point), pick->depth, 1e-6);
        }
    EXPECT_GT(found, 100);
}

/// Only the distance of the target decides on sizes, and nothing is behind the eye.
TEST(parallel_picture, is_the_same_from_anywhere_along_the_line_of_sight) {
    const scene s = parallel_teapot("full");
    tester usual(s.model, s.camera, with_depth());
    usual.draw_event();
    l3d_camera inside = s.camera;
    inside.move(s.camera.axes().forward * 7.0);
    tester moved(s.model, inside, with_depth());
    moved.draw_event();
    EXPECT_LE(differing(usual.words(), moved.words()), size.width * size.height / 500);
    EXPECT_GT(l3d_covered(moved.depth()), 5000);
}

TEST(parallel_picture, is_the_same_by_any_threads_and_with_all_that_is_left_out) {
    reference::random_numbers random(3);
    reference::camera eye{{2.5, 3.1, 6.3}, {0.1, 0, 0}, {0.1, 1, 0.05}, 30, 0.2};
    eye.parallel = true;
    const scene s{dice_tests::random_body(random, dice_tests::body_kind::bent), eye, size};
    l3d_afd_settings settings = hard_edged();
    tester one(s.model, s.camera, settings);
    one.draw_event();
    settings.threads = 3;
    tester three(s.model, s.camera, settings);
    three.draw_event();
    EXPECT_EQ(one.words(), three.words());
    settings.keep.backs = settings.keep.hidden = settings.keep.centreless = true;
    tester all(s.model, s.camera, settings);
    all.draw_event();
    EXPECT_EQ(one.words(), all.words()) << "what is left out is not seen";
    EXPECT_GT(one.report().dice.backfacing + one.report().dice.back_blocks, 0);
}

/// Where slits and surfaces are equally near, the one drawn first is seen. Triangles that are left
/// out must not change which one that is.
TEST(parallel_picture, is_the_same_without_triangles_that_hold_no_centre) {
    std::int64_t less = 0;
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        reference::random_numbers random(seed);
        constexpr int across = 4; // bent patches that share their sides
        constexpr std::size_t points = 3 * across + 1;
        std::vector<reference::vec3> net;
        const double bent = random.between(0.1, 0.6);
        for (std::size_t i = 0; i < points * points; ++i)
            net.push_back({4.0 * static_cast<double>(i % points) / (points - 1) - 2,
                           random.between(-bent, bent),
                           3.0 * static_cast<double>(i / points) / (points - 1) - 1.5});
        std::vector<reference::patch> patches;
        for (std::size_t v = 0; v < across; ++v)
            for (std::size_t u = 0; u < across; ++u) {
                reference::patch& p = patches.emplace_back();
                for (std::size_t i = 0; i < 16; ++i)
                    p.points[i] = net[(3 * v + i / 4) * points + 3 * u + i % 4];
            }
        reference::camera eye{
            {random.between(-4, 4), random.between(1, 4), 6.3}, {0.1, 0, 0}, {0, 1, 0}, 40, 0.2};
        eye.parallel = seed % 2 == 0;
        const scene s{patches, eye, size};
        l3d_afd_settings settings = hard_edged();
        settings.tolerance = random.of_any_size(0.1, 1.5);
        tester few(s.model, s.camera, settings);
        few.draw_event();
        settings.keep.centreless = true;
        tester many(s.model, s.camera, settings);
        many.draw_event();
        EXPECT_EQ(few.words(), many.words());
        less += many.report().surface.quads - few.report().surface.quads;
    }
    EXPECT_GT(less, 4000);
}

/// Pixels of smooth edges show all that lies in them, so backs that begin where a front ends show
/// there, too, within the bound of the outline. Fronts hide them everywhere else. It is the same in
/// perspective. Rules that leave out other things change no pixel.
TEST(parallel_picture, with_smooth_edges_shows_backs_at_outlines_alone) {
    reference::random_numbers random(3);
    int differ = 0;
    for (int body = 0; body < 5; ++body) {
        const auto patches = dice_tests::random_body(random, dice_tests::body_kind::bent);
        for (const bool is_parallel : {false, true}) {
            reference::camera eye{{2.5, 3.1, 6.3}, {0.1, 0, 0}, {0.1, 1, 0.05}, 30, 0.2};
            eye.parallel = is_parallel;
            const scene s{patches, eye, size};
            l3d_afd_settings settings;
            tester usual(s.model, s.camera, settings);
            usual.draw_event();
            settings.keep = l3d_kept_work::all();
            settings.keep.backs = settings.keep.unit_normals = false;
            tester more(s.model, s.camera, settings);
            more.draw_event();
            EXPECT_EQ(usual.words(), more.words()) << "what is hidden or outside is not seen";
            settings.keep.backs = true;
            tester all(s.model, s.camera, settings);
            all.draw_event();
            const picture less = usual.words(), whole = all.words();
            const reference::exact_region region(s.patches, s.eye, s.picture());
            const double reach = usual.report().dice.bound_px + std::sqrt(0.5); // half a diagonal
            for (std::size_t i = 0; i < less.size(); ++i) {
                if (less[i] == whole[i])
                    continue;
                ++differ;
                const auto x = static_cast<int>(i % size.width),
                           y = static_cast<int>(i / size.width);
                EXPECT_LE(region.distance_to_outline(x + 0.5, y + 0.5), reach) << x << ' ' << y;
            }
        }
    }
    EXPECT_GT(differ, 0) << "else this tests nothing";
    EXPECT_LT(differ, 100);
}

TEST(parallel_picture, fades_into_fog_by_the_distance) {
    const scene s = parallel_teapot("full");
    l3d_afd_settings settings = with_depth();
    tester clear(s.model, s.camera, settings);
    clear.draw_event();
    settings.fog = {.from = 6.5F, .to = 10, .color = 0x4060a0};
    tester fogged(s.model, s.camera, settings);
    fogged.draw_event();
    const std::vector<float> distances = fogged.distances();
    const picture before = clear.words(), after = fogged.words();
    int faded = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (std::isinf(distances[i]))
            continue;
        const double amount = std::clamp((double{distances[i]} - 6.5) / (10 - 6.5), 0.0, 1.0);
        for (const int shift : {0, 8, 16}) {
            const double was = before[i] >> shift & 255, fog = 0x4060a0U >> shift & 255;
            ASSERT_NEAR(after[i] >> shift & 255, was + amount * (fog - was), 1.51) << i;
        }
        faded += amount > 0.1;
    }
    EXPECT_GT(faded, 1000);
}

/// The colour of a pixel is that of the curvature which a pick finds there.
TEST(parallel_picture, inspections_find_the_exact_place_of_each_pixel) {
    const scene s = parallel_teapot("full");
    l3d_afd_settings settings = hard_edged();
    settings.shade = l3d_shade::gaussian;
    settings.inspection.scale = 2;
    tester program(s.model, s.camera, settings);
    program.draw_event();
    const picture words = program.words();
    int same = 0, judged = 0;
    for (int y = 3; y < size.height; y += 7)
        for (int x = 3; x < size.width; x += 7) {
            const auto pick = program.pick(x + 0.5, y + 0.5);
            const std::uint32_t word = words[static_cast<std::size_t>(y * size.width + x)];
            if (!pick || !pick->is_proven || word == 0)
                continue;
            ++judged;
            const std::uint32_t exact =
                l3d_inspection_color(settings.shade, pick->gaussian, settings.inspection.scale);
            bool near = true;
            for (const int shift : {0, 8, 16})
                near = near && std::abs(static_cast<int>(word >> shift & 255) -
                                        static_cast<int>(exact >> shift & 255)) <= 2;
            same += near;
        }
    EXPECT_GT(judged, 100);
    EXPECT_GE(same, judged - judged / 50);
}

TEST(parallel_picture, outlines_are_where_covered_and_uncovered_pixels_meet) {
    const scene s = parallel_teapot("full");
    l3d_afd_settings settings = with_depth();
    settings.outlines = true;
    tester program(s.model, s.camera, settings);
    program.draw_event();
    const reference::exact_image exact(s.patches, s.eye, s.picture());
    const std::vector<float> distances = program.distances();
    int missed = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const bool is = std::isfinite(distances[static_cast<std::size_t>(y * size.width + x)]);
            missed += is != exact.covered(x, y) && !program.outlines()->has(x, y);
        }
    EXPECT_EQ(missed, 0);
    EXPECT_LT(program.report().outline_pixels, size.width * size.height / 5);
}

/// Methods that use what is left of 1 / w cannot do it, and are refused by name.
TEST(parallel_picture, of_a_method_that_draws_perspective_alone_is_refused) {
    const scene s = parallel_teapot("full");
    l3d_afd_settings settings = hard_edged();
    settings.method = {"plain", [](const l3d_rasterizer_factory&, l3d_workers&) {
                           return std::unique_ptr<l3d_surface_method>();
                       }};
    EXPECT_EQ(l3d_afd_complaint(s.camera, size, settings),
              "parallel projection: plain draws perspective alone");
}

} // namespace
