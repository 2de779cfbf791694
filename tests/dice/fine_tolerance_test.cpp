// SPDX-License-Identifier: MIT
// Tolerances of hundredths of a pixel: kept, and diced the fast way.
#include "certificate.h"
#include "nasty.h"
#include "scene.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace dice_tests {
namespace {

/// The finest tolerance that is kept: some 0.0075 of it is what snapping takes.
constexpr double finest_kept = 0.01;

struct nowhere {
    void draw(diced, double) {}
};

template <class T> l3d_dice_counts counts_of(const scene& s, double tolerance) {
    nowhere sink;
    return dice<T>(s, tolerance, sink);
}

template <class T> class in_lanes : public ::testing::Test {};
TYPED_TEST_SUITE(in_lanes, product_types, type_names);

/// One strip of more than 32 steps, or one walk too long for a float, made a patch slow.
TYPED_TEST(in_lanes, is_all_of_what_is_in_front_at_any_tolerance) {
    const auto check = [](const scene& s, double tolerance) {
        const l3d_dice_counts counts = counts_of<TypeParam>(s, tolerance);
        EXPECT_EQ(counts.in_lanes, counts.pieces) << tolerance;
        std::printf("%-6s %4dx%-4d tolerance %.3f: %ld of %ld pieces in lanes, %ld vertices\n",
                    name_of<TypeParam>(), s.size.width, s.size.height, tolerance,
                    static_cast<long>(counts.in_lanes), static_cast<long>(counts.pieces),
                    static_cast<long>(counts.samples));
        return counts.pieces;
    };
    for (const char* name : {"full", "top"}) {
        SCOPED_TRACE(name);
        const reference::view& view = reference::project_view(name);
        for (const double tolerance : {0.5, 0.05, 0.03, 0.02, 0.015, 0.01, 0.005})
            check(teapot(view, {1024, 768}), tolerance);
        EXPECT_GT(check(teapot(view, {1024, 768}), 0.002), 3 * 28); // most are cut
        check(teapot(view, {3840, 2160}), 0.1);
    }
}

/// Pieces of a patch that is cut at the near plane are ordinary but for those at the plane.
TYPED_TEST(in_lanes, are_pieces_of_clipped_patches_that_need_no_clipping) {
    const l3d_dice_counts counts =
        counts_of<TypeParam>(teapot(reference::project_view("near_cut"), {640, 481}), 0.1);
    EXPECT_GT(counts.clipped, 0);
    EXPECT_EQ(counts.in_lanes, counts.pieces - counts.clipped);
}

/// Without this, a patch would lose in pieces what it saves as a whole.
TEST(in_lanes, fills_pieces_well) {
    for (const double tolerance : {0.01, 0.005}) {
        const scene s = teapot(reference::project_view("full"), {1024, 768});
        const l3d_dice_counts counts = counts_of<float>(s, tolerance);
        // Halves of more than 128 steps have more than 64; the other way they have half as many on
        // the average.
        EXPECT_GT(counts.samples, 64 * 32 * counts.pieces) << tolerance;
    }
}

template <class T> class fine_tolerance : public ::testing::Test {};
TYPED_TEST_SUITE(fine_tolerance, number_types, type_names);

TYPED_TEST(fine_tolerance, is_kept_down_to_a_hundredth) {
    for (const char* name : {"full", "closeup", "top", "tiny", "grazing"})
        for (const l3d_size size : {l3d_size{320, 240}, {1024, 768}})
            for (const double tolerance : {0.05, 0.03, 0.02, 0.015, 0.012, finest_kept}) {
                if (sanitized && size.width > 320)
                    continue;
                const scene s = teapot(reference::project_view(name), size);
                EXPECT_LE(counts_of<TypeParam>(s, tolerance).bound_px, tolerance)
                    << name << " " << size.width << " x " << size.height;
            }
}

/// A frame is honest about what sub-pixels are too coarse for.
TYPED_TEST(fine_tolerance, is_told_where_it_is_not_kept) {
    const scene s = teapot(reference::project_view("full"), odd);
    for (const double tolerance : {0.005, 0.001}) {
        certificate result(s.eye, s.size);
        result.measure_every(thorough ? 101 : 501);
        const auto counts =
            scene_dicer<TypeParam>().dice(s, tolerance, [&](std::size_t i, diced pieces, double b) {
                result.next(s.patches[i]);
                result.draw(pieces, b);
            });
        EXPECT_EQ(result.violations, 0);
        EXPECT_LE(result.largest, counts.bound_px);
        EXPECT_GT(counts.bound_px, tolerance);
        EXPECT_LT(counts.bound_px, finest_kept);
    }
}

TYPED_TEST(fine_tolerance, of_random_patches_holds) {
    using reference::patch_kind;
    double worst = 0;
    std::int64_t pieces = 0, drawn = 0, fast = 0;
    for (const patch_kind kind : {patch_kind::moderate, patch_kind::thin, patch_kind::folded,
                                  patch_kind::coincident, patch_kind::stiff})
        for (std::uint64_t seed = 1; seed <= (thorough ? 8 : 1); ++seed) {
            const double tolerance = random_numbers(seed).of_any_size(finest_kept, 0.03);
            SCOPED_TRACE(testing::Message() << "seed " << seed << " tolerance " << tolerance);
            const scene s(random_patches(seed, kind, 6, oblique, {odd.width, odd.height}), oblique,
                          odd);
            certificate result(s.eye, s.size);
            result.measure_every(thorough ? 31 : 501);
            const auto counts = scene_dicer<TypeParam>().dice(
                s, tolerance, [&](std::size_t i, diced of_patch, double b) {
                    result.next(s.patches[i]);
                    result.draw(of_patch, b);
                });
            EXPECT_EQ(result.violations, 0);
            EXPECT_LE(counts.bound_px, tolerance);
            worst = std::max(worst, result.worst_ratio);
            pieces += counts.pieces;
            drawn += counts.drawn;
            fast += counts.in_lanes;
        }
    std::printf("%-10s %ld patches in %ld pieces, %ld in lanes: worst measured / bound %.3f\n",
                name_of<TypeParam>(), static_cast<long>(drawn), static_cast<long>(pieces),
                static_cast<long>(fast), worst);
    EXPECT_GT(pieces, drawn);
}

} // namespace
} // namespace dice_tests
