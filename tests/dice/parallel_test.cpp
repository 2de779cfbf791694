// SPDX-License-Identifier: MIT
// Parallel projections: places, depths and shades are within their bounds, as in perspective.
#include "certificate.h"
#include "surface_certificate.h"

#include "reference/random_numbers.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <utility>

namespace dice_tests {
namespace {

using reference::random_numbers;

template <class T> class parallel_projection : public ::testing::Test {};

TYPED_TEST_SUITE(parallel_projection, number_types, type_names);

/// The room that a measured shade leaves for rounding to a whole level, which is not measured.
constexpr double rounding = 0.5;

/// Ratios of what was measured to the bounds of each frame.
template <class T> class judged_scenes {
public:
    void check(const scene& s, double tolerance, std::size_t every) {
        certificate places(s.eye, s.size);
        surface_certificate surfaces(s);
        places.measure_every(every);
        surfaces.measure_every(every);
        const l3d_dice_counts counts =
            dicer_.dice(s, tolerance, [&](std::size_t i, diced pieces, double bound) {
                places.next(s.patches[i]);
                places.draw(pieces, bound);
                surfaces.next(i);
                surfaces.draw(pieces);
            });
        const double shade = counts.shade_bound - rounding;
        const bool kept = places.violations == 0 && places.largest <= counts.bound_px &&
                          surfaces.depth.measured <= counts.depth_bound_px &&
                          (surfaces.shade.measured == 0 || surfaces.shade.measured <= shade);
        violations_ += !kept;
        if (violations_ < 4) {
            EXPECT_TRUE(kept) << places.largest << " px of " << counts.bound_px << ", depth "
                              << surfaces.depth.measured << " of " << counts.depth_bound_px
                              << ", shade " << surfaces.shade.measured << " of " << shade;
        }
        ++scenes_;
        within_ += std::max(counts.bound_px, counts.depth_bound_px) <= tolerance + 0.001;
        in_lanes_ += counts.in_lanes;
        pieces_ += counts.pieces;
        samples_ += surfaces.samples;
        for (const auto& [measured, bound] : {std::pair(places.largest, counts.bound_px),
                                              {surfaces.depth.measured, counts.depth_bound_px}})
            if (std::isfinite(bound) && bound > 0)
                ratio_ = std::max(ratio_, measured / bound);
    }

    ~judged_scenes() {
        std::printf("%-10s %ld scenes, %ld within the tolerance, %ld of %ld pieces in lanes, %ld "
                    "samples, %ld violations, largest measured / bound %.3f\n",
                    name_of<T>(), scenes_, within_, static_cast<long>(in_lanes_),
                    static_cast<long>(pieces_), static_cast<long>(samples_), violations_, ratio_);
    }

    long scenes() const { return scenes_; }
    long within() const { return within_; }
    std::int64_t in_lanes() const { return in_lanes_; }

private:
    scene_dicer<T> dicer_;
    long scenes_ = 0, within_ = 0, violations_ = 0;
    std::int64_t in_lanes_ = 0, pieces_ = 0, samples_ = 0;
    double ratio_ = 0;
};

reference::camera parallel(reference::camera eye) {
    eye.parallel = true;
    return eye;
}

TYPED_TEST(parallel_projection, of_the_teapot_holds_in_every_view) {
    judged_scenes<TypeParam> all;
    for (const reference::view& view : reference::project_views())
        for (const double tolerance : {1.0, 0.25, 0.05}) {
            SCOPED_TRACE(testing::Message() << view.name << " tolerance " << tolerance);
            scene s{reference::load_bpt_plain("data/teapot.bpt"), parallel(view.eye), {320, 240}};
            s.shade_tolerance = 2;
            all.check(s, tolerance, thorough ? 7 : 31);
        }
    EXPECT_EQ(all.within(), all.scenes());
    if (way_of<TypeParam>::way == l3d_dice_way::lanes) {
        EXPECT_GT(all.in_lanes(), 400);
    }
}

/// A patch or two of any kind, seen from anywhere and in any size.
scene random_scene(std::uint64_t seed) {
    random_numbers random(seed);
    reference::camera eye;
    eye.parallel = true;
    const auto any = [&](double reach) { return random.between(-reach, reach); };
    eye.eye = {any(6), any(6), random.between(1, 8)};
    eye.target = {any(1), any(1), any(0.9)};
    eye.up = {any(0.3), 1, any(0.3)};
    eye.fov_degrees = random.of_any_size(1, 120);
    eye.near = random.of_any_size(0.01, 1);
    const auto& kinds = reference::patch_kinds;
    scene s{reference::random_patches(random.next(), kinds[random.below(std::size(kinds))].first, 2,
                                      eye, {odd.width, odd.height}),
            eye, odd};
    s.shade_tolerance = random.of_any_size(1, 8);
    return s;
}

template <class T> void check_random(std::uint64_t first, std::uint64_t count) {
    judged_scenes<T> all;
    for (std::uint64_t seed = first; seed < first + count; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        all.check(random_scene(seed), random_numbers(seed).of_any_size(0.03, 2), 61);
    }
}

TYPED_TEST(parallel_projection, of_random_patches_holds) {
    check_random<TypeParam>(1, thorough ? 60 : 10);
}

TYPED_TEST(parallel_projection, DISABLED_of_ten_thousand_random_scenes_holds) {
    check_random<TypeParam>(1000, 10'000);
}

} // namespace
} // namespace dice_tests
