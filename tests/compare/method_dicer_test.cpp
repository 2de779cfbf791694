// SPDX-License-Identifier: MIT
// The methods that adaptive forward differencing is compared with: their bounds hold, and they
// leave no pixel out between patches.
#include "dice/certificate.h"
#include "dice/nasty.h"
#include "dice/picture.h"
#include "dice/scene.h"

#include "compare/dicers/fd_dicer.h"
#include "compare/method_patches.h"
#include "compare/dicers/micropolygon_dicer.h"
#include "compare/dicers/subdivision_dicer.h"
#include "scene/culling/visibility.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace dice_tests {
namespace {

/// A dicer under a name.
template <class Dicer> struct named {
    const char* name;
    Dicer dicer;
    bool closes = true; ///< no pixel is left out between patches of any steps
};

const std::tuple all_dicers{
    named<l3d_fd_dicer>{"fd_float", l3d_fd_dicer(l3d_arithmetic::float_32)},
    named<l3d_fd_dicer>{"fd_double", l3d_fd_dicer(l3d_arithmetic::float_64)},
    named<l3d_fd_dicer>{"fd_16_16", l3d_fd_dicer(l3d_arithmetic::fixed_16_16)},
    named<l3d_fd_dicer>{"fd_block", l3d_fd_dicer(l3d_arithmetic::block_32)},
    named<l3d_fd_dicer>{"fd_32_32", l3d_fd_dicer(l3d_arithmetic::fixed_32_32)},
    named<l3d_subdivision_dicer>{"subdivision", l3d_subdivision_dicer()},
    named<l3d_micropolygon_dicer>{"micropolygons", l3d_micropolygon_dicer()},
};

/// Hands what a dicer makes of every ordinary patch to sink.draw(pieces, frame_bound).
template <class Dicer, class Sink>
l3d_dice_counts dice_by(Dicer dicer, const scene& s, double tolerance, Sink& sink) {
    l3d_patch_scene world(s.model);
    const l3d_image_transform to_image(s.camera, s.size, world);
    const l3d_dice_view view = to_image.view(tolerance);
    l3d_piece_pool pieces = l3d_piece_pool::with_parameters();
    l3d_dice_counts counts;
    for (std::size_t i = 0; i < s.model.patches().size(); ++i) {
        const l3d_image_patch net = l3d_placed_net(to_image.matrix(), s.model.patches()[i]);
        if (l3d_left_out(net, view, counts) || !l3d_needs_no_clipping(net, view))
            continue;
        ++counts.drawn;
        pieces.clear();
        dicer.dice(net, s.model.normals(i), view, pieces, counts);
        if constexpr (requires { sink.next(s.patches[i]); })
            sink.next(s.patches[i]);
        sink.draw(pieces.used(), counts.bound_px);
    }
    return counts;
}

template <class Visit> void for_dicers(Visit visit) {
    std::apply([&](const auto&... each) { (visit(each), ...); }, all_dicers);
}

TEST(method_dicer, holds_its_bound_on_the_teapot) {
    for (const char* view : {"full", "closeup", "top"})
        for_dicers([&](const auto& method) {
            const scene s = teapot(reference::project_view(view), {641, 479});
            certificate measured(s.eye, s.size);
            measured.measure_every(method.name == std::string("micropolygons") ? 37 : 3);
            const l3d_dice_counts counts = dice_by(method.dicer, s, 0.25, measured);
            EXPECT_EQ(measured.violations, 0)
                << method.name << ' ' << view << ": " << measured.worst_measured << " px at ("
                << measured.worst_u << ", " << measured.worst_v << "), bound "
                << measured.worst_bound;
            EXPECT_GT(measured.samples, 1000);
            std::printf(
                "%-15s %-8s bound %8.4f px, most %8.4f, mean %7.4f, measured / bound %.2f\n",
                method.name, view, counts.bound_px, measured.largest, measured.mean(),
                measured.worst_ratio);
        });
}

TEST(method_dicer, holds_its_bound_on_random_patches) {
    const std::uint64_t seeds = thorough ? 25 : 3;
    const reference::camera eye{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
    for_dicers([&](const auto& method) {
        std::int64_t samples = 0, violations = 0;
        double worst = 0;
        for (const auto kind : {reference::patch_kind::moderate, reference::patch_kind::thin,
                                reference::patch_kind::folded, reference::patch_kind::coincident})
            for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
                const scene s(reference::random_patches(seed, kind, 3, eye, {317, 241}), eye,
                              {317, 241});
                certificate measured(s.eye, s.size);
                measured.measure_every(method.name == std::string("micropolygons") ? 37 : 1);
                dice_by(method.dicer, s, 0.3, measured);
                samples += measured.samples;
                violations += measured.violations;
                worst = std::max(worst, measured.worst_ratio);
                EXPECT_EQ(measured.violations, 0)
                    << method.name << ", kind " << static_cast<int>(kind) << ", seed " << seed
                    << ": " << measured.worst_measured << " px at (" << measured.worst_u << ", "
                    << measured.worst_v << "), bound " << measured.worst_bound;
            }
        EXPECT_GT(samples, 1000);
        std::printf("%-15s %8ld samples, %ld violations, measured / bound at most %.2f\n",
                    method.name, static_cast<long>(samples), static_cast<long>(violations), worst);
    });
}

TEST(method_dicer, leaves_no_pixel_out_of_tilings) {
    const reference::camera oblique{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
    for_dicers([&](const auto& method) {
        std::int64_t pixels = 0, uncovered = 0;
        for (std::uint64_t seed = 1; seed <= (thorough ? 12 : 2); ++seed) {
            random_numbers random(seed);
            const l3d_size size{static_cast<int>(random.between(100, 300)),
                                static_cast<int>(random.between(90, 240))};
            const int k = static_cast<int>(random.of_any_size(1, 8.99));
            const double fold = random.between(0, 1.5), depth = random.between(0, 3);
            const double tolerance = random.of_any_size(0.05, 2);
            const scene s(random_tiling(seed, k, fold, depth, oblique, {size.width, size.height}),
                          oblique, size);
            picture drawn(size, s.camera);
            dice_by(method.dicer, s, tolerance, drawn);
            EXPECT_EQ(drawn.uncovered(), 0)
                << method.name << ", seed " << seed << ": " << k << " x " << k << " patches, fold "
                << fold << ", depth " << depth << ", tolerance " << tolerance;
            pixels += std::int64_t{size.width} * size.height;
            uncovered += drawn.uncovered();
        }
        std::printf("%-15s tilings: %ld of %ld pixels uncovered\n", method.name,
                    static_cast<long>(uncovered), static_cast<long>(pixels));
    });
}

} // namespace
} // namespace dice_tests
