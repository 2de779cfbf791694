// SPDX-License-Identifier: MIT
// The error bound that every frame carries, against the exact surface.
#include "certificate.h"
#include "nasty.h"
#include "scene.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace dice_tests {
namespace {

template <class T> class bound_of : public ::testing::Test {};

TYPED_TEST_SUITE(bound_of, number_types, type_names);

/// Dices and measures; what must hold in every frame.
template <class T>
void measure(const scene& s, double tolerance, certificate& result, l3d_dice_counts& counts) {
    counts = scene_dicer<T>().dice(s, tolerance, [&](std::size_t i, diced pieces, double bound) {
        result.next(s.patches[i]);
        result.draw(pieces, bound);
    });
    EXPECT_EQ(result.violations, 0)
        << "worst at u " << result.worst_u << " v " << result.worst_v << ", in a "
        << (result.worst_is_grid ? "grid" : "triangle") << ": measured " << result.worst_measured
        << " px, bound " << result.worst_bound << " px, of " << result.samples << " samples";
    EXPECT_LE(result.largest, counts.bound_px);
    EXPECT_LE(result.largest_promise, counts.bound_px);
}

TYPED_TEST(bound_of, the_teapot_holds_in_every_view_size_and_tolerance) {
    for (const reference::view& view : reference::project_views())
        for (const l3d_size size : {l3d_size{320, 240}, {1024, 768}, {1920, 1080}})
            for (const double tolerance : {1.0, 0.5, 0.25, 0.1, 0.05}) {
                if (sanitized && (size.width > 320 || tolerance < 0.25))
                    continue;
                SCOPED_TRACE(testing::Message() << view.name << " " << size.width << "x"
                                                << size.height << " tolerance " << tolerance);
                const scene s = teapot(view, size);
                certificate result(s.eye, size);
                result.measure_every(size.width > 320 ? 7 : 2);
                l3d_dice_counts counts;
                measure<TypeParam>(s, tolerance, result, counts);
                EXPECT_LE(counts.bound_px, tolerance);
                EXPECT_GT(result.samples, 100);
                std::printf("%-6s %-8.*s %4dx%-4d tolerance %.2f: bound %.4f, measured max %.4f "
                            "mean %.4f px, %ld samples\n",
                            name_of<TypeParam>(), static_cast<int>(view.name.size()),
                            view.name.data(), size.width, size.height, tolerance, counts.bound_px,
                            result.largest, result.mean(), static_cast<long>(result.samples));
            }
}

/// The common part of random scenes: a seed to find them again, and a summary.
template <class T> class random_scenes {
public:
    explicit random_scenes(const char* what) : what_(what) {}

    ~random_scenes() {
        std::printf("%-6s %-10s %ld patches, %ld pieces (%ld clipped), %ld samples: worst measured "
                    "/ bound %.3f (seed %lu, "
                    "tolerance %.3f)\n",
                    name_of<T>(), what_, patches_, pieces, clipped, samples_, worst_, worst_seed_,
                    worst_tolerance_);
    }

    void check(std::uint64_t seed, const scene& s, double tolerance, bool attainable = true) {
        SCOPED_TRACE(testing::Message() << what_ << " seed " << seed << " tolerance " << tolerance);
        certificate result(s.eye, s.size);
        result.measure_every(thorough ? 5 : 50);
        l3d_dice_counts counts;
        measure<T>(s, tolerance, result, counts);
        if (attainable) {
            EXPECT_LE(counts.bound_px, tolerance);
        }
        patches_ += static_cast<long>(s.patches.size());
        samples_ += static_cast<long>(result.samples);
        pieces += static_cast<long>(counts.pieces);
        clipped += static_cast<long>(counts.clipped);
        if (result.worst_ratio > worst_) {
            worst_ = result.worst_ratio;
            worst_seed_ = seed;
            worst_tolerance_ = tolerance;
        }
    }

    long pieces = 0, clipped = 0;

private:
    const char* what_;
    long patches_ = 0, samples_ = 0;
    double worst_ = 0, worst_tolerance_ = 0;
    unsigned long worst_seed_ = 0;
};

TEST(certificate, evaluates_as_exactly_as_the_reference_does) {
    const reference::camera_frame frame(oblique, {odd.width, odd.height});
    random_numbers random(3);
    for (const auto kind : {nasty_kind::crossing, nasty_kind::spear, nasty_kind::wide})
        for (const reference::patch& surface :
             nasty_patches(5, kind, 20, oblique, {odd.width, odd.height})) {
            const reference::net net = make_net(surface, frame);
            const double u = random.between(0, 1), v = random.between(0, 1);
            const reference::hpoint quick = value_of(net, u, v);
            const reference::homogeneous_point exact = exact_homogeneous(surface, frame, u, v);
            EXPECT_NEAR(quick.x, static_cast<double>(exact.x), 1e-9);
            EXPECT_NEAR(quick.y, static_cast<double>(exact.y), 1e-9);
            EXPECT_NEAR(quick.w, static_cast<double>(exact.w), 1e-12);
        }
}

TYPED_TEST(bound_of, random_patches_of_every_kind_hold) {
    const std::uint64_t scenes = thorough ? 20 : 10;
    constexpr int patches = 20;
    for (const auto& [kind, name] : reference::patch_kinds) {
        random_scenes<TypeParam> all(name);
        for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
            const double tolerance = random_numbers(seed).of_any_size(0.03, 2);
            all.check(seed,
                      {random_patches(seed, kind, patches, oblique, {odd.width, odd.height}),
                       oblique, odd},
                      tolerance);
        }
    }
}

/// Tolerances finer than vertices can be placed: not kept, but the bound says what is.
TYPED_TEST(bound_of, patches_cut_again_and_again_hold) {
    const std::uint64_t scenes = thorough ? 2 : 1;
    constexpr int patches = 3;
    random_scenes<TypeParam> all("cut");
    for (std::uint64_t seed = 1; seed <= scenes; ++seed)
        all.check(seed,
                  {random_patches(seed, reference::patch_kind::folded, patches, oblique,
                                  {odd.width, odd.height}),
                   oblique, odd},
                  random_numbers(seed).of_any_size(0.001, 0.005), false);
    EXPECT_GT(all.pieces, 3 * scenes * patches);
}

TYPED_TEST(bound_of, patches_around_the_eye_and_far_from_the_window_hold) {
    const std::uint64_t scenes = thorough ? 20 : 10;
    constexpr int patches = 5;
    for (const auto& [kind, name] : nasty_kinds) {
        random_scenes<TypeParam> all(name);
        for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
            const double tolerance = random_numbers(seed).of_any_size(0.03, 2);
            all.check(seed,
                      {nasty_patches(seed, kind, patches, oblique, {odd.width, odd.height}),
                       oblique, odd},
                      tolerance);
        }
    }
}

/// At any budget of a frame, a coarsely drawn patch has a larger bound, or none, but a true one.
TYPED_TEST(bound_of, frames_that_may_cost_little_hold) {
    const std::uint64_t scenes = thorough ? 20 : 5;
    constexpr int patches = 5;
    for (const nasty_kind kind :
         {nasty_kind::around_eye, nasty_kind::crossing, nasty_kind::deep, nasty_kind::wide}) {
        random_scenes<TypeParam> all("cheap");
        for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
            random_numbers random(seed);
            scene s(nasty_patches(seed, kind, patches, oblique, {odd.width, odd.height}), oblique,
                    odd);
            s.most_samples = static_cast<std::int64_t>(random.of_any_size(100, 300'000));
            all.check(seed, s, random.of_any_size(0.03, 2), false);
        }
    }
}

} // namespace
} // namespace dice_tests
