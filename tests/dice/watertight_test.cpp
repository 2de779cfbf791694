// SPDX-License-Identifier: MIT
// No pixel is left out between patches, pieces and the near plane.
#include "nasty.h"
#include "picture.h"
#include "scene.h"

#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>

namespace dice_tests {
namespace {

template <class T> class watertight : public ::testing::Test {};
TYPED_TEST_SUITE(watertight, number_types, type_names);

/// Pixels to fill in a test: `usual`, or what L3D_TEST_PIXELS says, shared by the number types.
std::int64_t pixels_to_fill(std::int64_t usual) {
    const char* more = std::getenv("L3D_TEST_PIXELS");
    return more ? std::atoll(more) / 3 : thorough ? usual : usual / 8;
}

/// A k x k tiling of a picture, how it is looked at, and how exactly it is drawn.
struct tiling_case {
    l3d_size size;
    int k = 1;
    double fold = 0, depth = 0, tolerance = 1;
    reference::camera tiled_for = oblique, seen_by = oblique;
};

/// Size of a picture.
l3d_size any_size(random_numbers& random) {
    const int width = static_cast<int>(random.between(150, 500));
    return {width, static_cast<int>(random.between(120, 400))};
}

/// Draws the tilings of seeds 1, 2, ... that `any_case` makes until enough pixels are filled, and
/// expects none to be left out.
template <class Number, class Any>
l3d_dice_counts fill(const char* name, std::int64_t enough, const Any& any_case) {
    l3d_dice_counts sum;
    std::int64_t pixels = 0, uncovered = 0;
    std::uint64_t seed = 1;
    for (; pixels < enough; ++seed) {
        random_numbers random(seed);
        const tiling_case c = any_case(random);
        const scene s(
            random_tiling(seed, c.k, c.fold, c.depth, c.tiled_for, {c.size.width, c.size.height}),
            c.seen_by, c.size);
        picture drawn(c.size);
        const l3d_dice_counts counts = dice<Number>(s, c.tolerance, drawn);
        EXPECT_EQ(drawn.uncovered(), 0)
            << name << ", seed " << seed << ": " << c.k << " x " << c.k << " patches, fold "
            << c.fold << ", depth " << c.depth << ", fov " << c.seen_by.fov_degrees
            << ", tolerance " << c.tolerance;
        pixels += std::int64_t{c.size.width} * c.size.height;
        uncovered += drawn.uncovered();
        sum.pieces += counts.pieces;
        sum.drawn += counts.drawn;
        sum.clipped += counts.clipped;
    }
    std::printf("%-6s %s: %ld of %ld pixels uncovered; %ld patches in %ld pieces, %ld clipped, "
                "seeds 1 to %ld\n",
                name_of<Number>(), name, static_cast<long>(uncovered), static_cast<long>(pixels),
                static_cast<long>(sum.drawn), static_cast<long>(sum.pieces),
                static_cast<long>(sum.clipped), static_cast<long>(seed - 1));
    return sum;
}

TYPED_TEST(watertight, random_tilings_cover_every_pixel) {
    fill<TypeParam>("tilings", pixels_to_fill(7'000'000), [](random_numbers& random) {
        tiling_case c{any_size(random)};
        c.k = static_cast<int>(random.of_any_size(1, 12.99));
        c.fold = random.between(0, 2);
        c.depth = random.between(0, 4);
        c.tolerance = random.of_any_size(0.05, 4);
        return c;
    });
}

/// The middle of a tiling seen through a long lens: patches reach far beyond the window, some need
/// cutting where their neighbours do not.
TYPED_TEST(watertight, zoomed_tilings_whose_patches_are_cut_cover_every_pixel) {
    const auto zoomed = [](random_numbers& random) {
        tiling_case c{any_size(random)};
        c.tiled_for.fov_degrees = 70;
        c.seen_by.fov_degrees = random.of_any_size(0.02, 30);
        c.k = static_cast<int>(random.of_any_size(1, 8.99));
        c.fold = random.between(0, 1.5);
        c.depth = random.between(0, 4);
        c.tolerance = random.of_any_size(0.02, 4);
        return c;
    };
    const l3d_dice_counts sum =
        fill<TypeParam>("zoomed tilings", pixels_to_fill(4'000'000), zoomed);
    if (!sanitized) { // too few tilings to count on one that is cut
        EXPECT_GT(sum.pieces, sum.drawn);
    }
}

/// Finer than vertices can be placed, so that patches need more than 32 steps a strip.
TYPED_TEST(watertight, tilings_cut_again_and_again_cover_every_pixel) {
    const auto fine = [](random_numbers& random) {
        tiling_case c{any_size(random)};
        c.k = static_cast<int>(random.between(1, 3.99));
        c.tolerance = random.of_any_size(0.0005, 0.005);
        c.fold = random.between(0, 2);
        c.depth = random.between(0, 4);
        return c;
    };
    const l3d_dice_counts sum = fill<TypeParam>("cut tilings", pixels_to_fill(400'000), fine);
    EXPECT_GT(sum.pieces, 3 * sum.drawn);
}

/// k x k patches over |x|, |z| <= 40 with control points moved within the plane y = 0, and up and
/// down by at most `bump`.
std::vector<reference::patch> ground(random_numbers& random, int k, double bump) {
    constexpr double half = 40;
    const std::size_t side = 3 * static_cast<std::size_t>(k) + 1;
    std::vector<reference::vec3> lattice(side * side);
    const double cell = 2 * half / static_cast<double>(side - 1);
    for (std::size_t j = 0; j < side; ++j)
        for (std::size_t i = 0; i < side; ++i) {
            const bool rim = i == 0 || j == 0 || i + 1 == side || j + 1 == side;
            const double move = rim ? 0 : 0.4 * cell;
            lattice[j * side + i] = {
                cell * static_cast<double>(i) - half + random.between(-move, move),
                random.between(-bump, bump),
                cell * static_cast<double>(j) - half + random.between(-move, move)};
        }
    std::vector<reference::patch> result(static_cast<std::size_t>(k * k));
    for (std::size_t p = 0; p < result.size(); ++p)
        for (std::size_t n = 0; n < 16; ++n)
            result[p].points[n] = lattice[(3 * (p / static_cast<std::size_t>(k)) + n / 4) * side +
                                          3 * (p % static_cast<std::size_t>(k)) + n % 4];
    return result;
}

/// A camera over the ground, looking anywhere but up.
reference::camera over_ground(random_numbers& random, double height) {
    const double x = random.between(-9, 9), z = random.between(-9, 9);
    return {{x, height, z},
            {x + random.between(-10, 10), random.between(-12, 0.99 * height), z + 11},
            {0.1, 1, 0.05},
            random.between(20, 90),
            height * random.of_any_size(0.1, 5)};
}

/// The ray through a pixel meets the flat ground well inside its rim and beyond the near plane.
bool shows_flat_ground(const reference::camera_frame& frame, const reference::camera& view, int x,
                       int y) {
    const reference::vec3 far = frame.unproject(x + 0.5, y + 0.5, 1);
    const double fall = view.eye.y - far.y;
    if (fall <= 0)
        return false;
    const double w = view.eye.y / fall;
    const double at_x = view.eye.x + w * (far.x - view.eye.x);
    const double at_z = view.eye.z + w * (far.z - view.eye.z);
    // One 1000th of w is more than a tolerance's worth beside the line where the plane is cut.
    return std::abs(at_x) < 39 && std::abs(at_z) < 39 && w > view.near * 1.001;
}

TYPED_TEST(watertight, flat_ground_through_the_near_plane_is_covered_to_the_horizon) {
    std::int64_t pixels = 0, uncovered = 0, clipped = 0;
    const std::uint64_t scenes = thorough ? 24 : 6;
    for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
        random_numbers random(seed);
        const int k = static_cast<int>(random.of_any_size(1, 9.99));
        const reference::camera view = over_ground(random, random.of_any_size(0.01, 8));
        const scene s(ground(random, k, 0), view, {317, 241});
        const double tolerance = random.of_any_size(0.05, 2);
        picture drawn(s.size);
        const l3d_dice_counts counts = dice<TypeParam>(s, tolerance, drawn);
        const reference::camera_frame frame(view, s.picture());
        std::int64_t here = 0;
        for (int y = 0; y < s.size.height; ++y)
            for (int x = 0; x < s.size.width; ++x)
                if (shows_flat_ground(frame, view, x, y)) {
                    ++pixels;
                    here += !drawn.covered(x, y);
                }
        EXPECT_EQ(here, 0) << "seed " << seed << ", " << k << " x " << k << " patches, tolerance "
                           << tolerance;
        uncovered += here;
        clipped += counts.clipped;
    }
    EXPECT_GT(clipped, 0);
    EXPECT_GT(pixels, 1000);
    std::printf("%-6s flat ground: %ld of %ld pixels uncovered; %ld pieces clipped\n",
                name_of<TypeParam>(), static_cast<long>(uncovered), static_cast<long>(pixels),
                static_cast<long>(clipped));
}

TYPED_TEST(watertight, hilly_ground_through_the_near_plane_has_no_hole) {
    std::int64_t covered = 0, holes = 0, clipped = 0;
    const std::uint64_t scenes = thorough ? 3 : 1;
    for (std::uint64_t seed = 1; seed <= scenes; ++seed) {
        random_numbers random(seed);
        const reference::camera view = over_ground(random, random.of_any_size(0.3, 4));
        const scene s(ground(random, 4, 3), view, {151, 113});
        const reference::exact_image exact(s.patches, view, s.picture());
        picture drawn(s.size);
        const l3d_dice_counts counts = dice<TypeParam>(s, 0.1, drawn);
        for (int y = 1; y + 1 < s.size.height; ++y)
            for (int x = 1; x + 1 < s.size.width; ++x) {
                bool inside = true;
                for (int n = 0; n < 9; ++n)
                    inside = inside && exact.covered(x - 1 + n % 3, y - 1 + n / 3);
                covered += inside;
                holes += inside && !drawn.covered(x, y);
            }
        clipped += counts.clipped;
        EXPECT_EQ(holes, 0) << "seed " << seed;
    }
    EXPECT_GT(clipped, 0);
    std::printf("%-6s hilly ground: %ld of %ld pixels are holes; %ld pieces clipped\n",
                name_of<TypeParam>(), static_cast<long>(holes), static_cast<long>(covered),
                static_cast<long>(clipped));
}

} // namespace
} // namespace dice_tests
