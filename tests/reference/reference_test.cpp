// SPDX-License-Identifier: MIT
// The exact picture against surfaces whose picture is known, and against brute force.
#include "reference/exact.h"
#include "reference/dense_image.h"
#include "reference/random_patches.h"
#include "reference/region.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace reference {
namespace {

constexpr camera oblique{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
constexpr picture_size small{157, 118};

vec3 sum(const vec3& a, double s, const vec3& b, double t, const vec3& c) {
    return {a.x + s * b.x + t * c.x, a.y + s * b.y + t * c.y, a.z + s * b.z + t * c.z};
}

/// origin + u along_u + v along_v: the control points of a linear function are its values.
patch plane(const vec3& origin, const vec3& along_u, const vec3& along_v) {
    patch result;
    for (std::size_t k = 0; k < 16; ++k)
        result.points[k] = sum(origin, static_cast<double>(k % 4) / 3, along_u,
                               static_cast<double>(k / 4) / 3, along_v);
    return result;
}

TEST(exact_point, plane_under_an_axis_aligned_camera) {
    const camera view{{3, 2, 9}, {3, 2, 1}, {0, 1, 0}, 60, 0.5};
    const patch surface = plane({1, 1, 4}, {4, 0, 1}, {0.5, 2, 0});
    const surface_point at = exact_point(surface, view, {300, 200}, 0.25L, 0.75L);
    // World (1 + 1 + 0.375, 1 + 1.5, 4 + 0.25); w = 9 - 4.25; focal = 100 / tan 30 degrees.
    const double focal = 100 * std::sqrt(3.0);
    EXPECT_NEAR(static_cast<double>(at.w), 4.75, 1e-15);
    EXPECT_NEAR(static_cast<double>(at.x), 150 + focal * (2.375 - 3) / 4.75, 1e-12);
    EXPECT_NEAR(static_cast<double>(at.y), 100 - focal * (2.5 - 2) / 4.75, 1e-12);
    // (4, 0, 1) x (0.5, 2, 0) = (-2, 0.5, 8).
    const double length = std::sqrt(4 + 0.25 + 64);
    EXPECT_NEAR(at.normal.x, -2 / length, 1e-15);
    EXPECT_NEAR(at.normal.y, 0.5 / length, 1e-15);
    EXPECT_NEAR(at.normal.z, 8 / length, 1e-15);
}

TEST(exact_point, one_control_point_weighs_as_its_bernstein_polynomial) {
    patch surface;
    surface.points[4 * 2 + 1] = {7, -3, 11}; // row 2 along v, column 1 along u
    const surface_point at = exact_point(surface, oblique, small, 1.0L / 3, 0.5L);
    const double weight = 4.0 / 9 * 3.0 / 8; // 3 u (1 - u)^2 and 3 v^2 (1 - v)
    EXPECT_NEAR(at.world.x, 7 * weight, 1e-14);
    EXPECT_NEAR(at.world.y, -3 * weight, 1e-14);
    EXPECT_NEAR(at.world.z, 11 * weight, 1e-14);
}

TEST(exact_point, normal_of_a_collapsed_edge_is_the_limit) {
    patch surface = plane({1, 2, -1}, {3, 0, 0.5}, {0, 2, 1});
    for (std::size_t k = 1; k < 4; ++k)
        surface.points[k] = surface.points[0];
    const vec3 inside = exact_point(surface, oblique, small, 0.3L, 0.4L).normal;
    const vec3 edge = exact_point(surface, oblique, small, 0.3L, 0.0L).normal;
    EXPECT_NEAR(edge.x, inside.x, 1e-9);
    EXPECT_NEAR(edge.y, inside.y, 1e-9);
    EXPECT_NEAR(edge.z, inside.z, 1e-9);
}

TEST(camera_frame, unproject_is_the_inverse_of_project) {
    const camera_frame frame(oblique, small);
    const vec3 world = frame.unproject(33.25, 91.5, 4.75);
    const homogeneous_point h = frame.project({world.x, world.y, world.z});
    EXPECT_NEAR(static_cast<double>(h.x / h.w), 33.25, 1e-12);
    EXPECT_NEAR(static_cast<double>(h.y / h.w), 91.5, 1e-12);
    EXPECT_NEAR(static_cast<double>(h.w), 4.75, 1e-14);
}

/// z = xx x^2 + xy x y + yy y^2 + zero over x0..x1, y0..y1; u runs along x, v along y.
struct paraboloid {
    double x0, x1, y0, y1, xx, xy, yy, zero;

    /// Control points are the function's polar form at 3 - i times the low and i times the high
    /// end.
    patch as_patch() const {
        const auto mean = [](double a, double b, int i) { return ((3 - i) * a + i * b) / 3; };
        const auto mean_product = [](double a, double b, int i) {
            const double t[3] = {i > 2 ? b : a, i > 1 ? b : a, i > 0 ? b : a};
            return (t[0] * t[1] + t[1] * t[2] + t[2] * t[0]) / 3;
        };
        patch result;
        for (int v = 0; v < 4; ++v)
            for (int u = 0; u < 4; ++u) {
                const double x = mean(x0, x1, u), y = mean(y0, y1, v);
                result.points[static_cast<std::size_t>(4 * v + u)] = {
                    x, y,
                    xx * mean_product(x0, x1, u) + xy * x * y + yy * mean_product(y0, y1, v) +
                        zero};
            }
        return result;
    }
};

struct known_pixel {
    int layers = 0;
    double w = std::numeric_limits<double>::infinity();
    bool doubtful = false; ///< a decision closer than rounding can take it
};

/// The ray eye + w d meets the paraboloid where a quadratic in w vanishes.
known_pixel look(const paraboloid& s, const camera& view, const camera_frame& frame, int px,
                 int py) {
    const vec3 one = frame.unproject(px + 0.5, py + 0.5, 1);
    const vec3 d{one.x - view.eye.x, one.y - view.eye.y, one.z - view.eye.z}, e = view.eye;
    const double a = s.xx * d.x * d.x + s.xy * d.x * d.y + s.yy * d.y * d.y;
    const double b =
        2 * s.xx * e.x * d.x + s.xy * (e.x * d.y + e.y * d.x) + 2 * s.yy * e.y * d.y - d.z;
    const double c = s.xx * e.x * e.x + s.xy * e.x * e.y + s.yy * e.y * e.y + s.zero - e.z;
    const double discriminant = b * b - 4 * a * c;
    known_pixel result;
    result.doubtful = std::abs(discriminant) < 1e-9 * b * b;
    if (discriminant < 0)
        return result;
    const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;
    for (const double w : {q / a, c / q}) {
        const double u = (e.x + w * d.x - s.x0) / (s.x1 - s.x0);
        const double v = (e.y + w * d.y - s.y0) / (s.y1 - s.y0);
        const double inside = std::min({u, 1 - u, v, 1 - v, w / view.near - 1});
        result.doubtful |= std::abs(inside) < 1e-9;
        if (inside >= 0) {
            ++result.layers;
            result.w = std::min(result.w, w);
        }
    }
    return result;
}

TEST(exact_image, paraboloids_agree_with_the_solved_quadratic_at_every_pixel) {
    const paraboloid surfaces[] = {
        {-1.3, 1.9, -1.1, 1.4, 0.31, 0.12, 0.22, -0.7}, // one layer
        {-1.7, 1.2, -1.5, 1.6, 2.3, -0.4, 1.7, -2.1},   // deep bowl: two layers and a silhouette
        {-1.2, 1.1, -1.6, 1.9, -1.9, 0.3, 1.3, 0.4},    // saddle
        {-2.6, 3.9, -2.2, 4.1, 0.2, 0.1, 0.4, -0.5},    // reaches behind the eye
    };
    const camera_frame frame(oblique, small);
    std::int64_t several = 0, covered = 0;
    for (const paraboloid& surface : surfaces) {
        const patch patches[] = {surface.as_patch()};
        const exact_image image(patches, oblique, small);
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                const known_pixel known = look(surface, oblique, frame, x, y);
                ASSERT_FALSE(known.doubtful) << x << ' ' << y;
                // Points on a seam of pieces count twice: at least, and the same if none.
                ASSERT_GE(image.layers(x, y), known.layers) << x << ' ' << y;
                ASSERT_EQ(image.covered(x, y), known.layers > 0) << x << ' ' << y;
                covered += known.layers > 0;
                several += known.layers > 1;
                const double w = image.at(x, y).w; // infinite where nothing is
                ASSERT_TRUE(w == known.w || std::abs(w - known.w) < 1e-10) << x << ' ' << y;
            }
    }
    EXPECT_GT(covered, 10000);
    EXPECT_GT(several, 500);
}

TEST(exact_image, every_sample_lies_on_its_patch_and_under_its_pixel_centre) {
    for (const auto kind : {patch_kind::moderate, patch_kind::thin, patch_kind::folded,
                            patch_kind::coincident, patch_kind::stiff}) {
        const std::uint64_t seed = 411 + static_cast<std::uint64_t>(kind);
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const auto patches = random_patches(seed, kind, 40, oblique, small);
        const exact_image image(patches, oblique, small);
        const camera_frame frame(oblique, small);
        std::int64_t covered = 0;
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                const exact_sample& sample = image.at(x, y);
                if (!sample.covered())
                    continue;
                ++covered;
                const auto at = exact_point(patches[static_cast<std::size_t>(sample.patch)], frame,
                                            sample.u, sample.v);
                ASSERT_NEAR(static_cast<double>(at.x), x + 0.5, 2e-9);
                ASSERT_NEAR(static_cast<double>(at.y), y + 0.5, 2e-9);
                ASSERT_NEAR(static_cast<double>(at.w), sample.w, 1e-9 * sample.w);
            }
        EXPECT_GT(covered, 500);
    }
}

/// 2000 cells along a patch of 100 px leave a chord error of 6 * 100 * 2 / (8 * 2000^2) = 4e-5 px
/// (two directions; twice that where w changes by 20 %).
constexpr int dense_cells = 2000;
constexpr double dense_px = 2e-4;

TEST(exact_image, agrees_with_two_thousand_squared_samples_of_each_patch) {
    for (const auto kind : {patch_kind::moderate, patch_kind::folded, patch_kind::coincident,
                            patch_kind::stiff, patch_kind::thin}) {
        const std::uint64_t seed = 97 + static_cast<std::uint64_t>(kind);
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        const auto patches = random_patches(seed, kind, 2, oblique, small);
        const exact_image image(patches, oblique, small);
        const exact_region region(patches, oblique, small);
        const dense_image dense(patches, oblique, small, dense_cells);
        for (int y = 0; y < small.height; ++y)
            for (int x = 0; x < small.width; ++x) {
                SCOPED_TRACE(testing::Message() << x << ' ' << y);
                if (!image.covered(x, y) && !dense.covered(x, y))
                    continue;
                if (!image.covered(x, y)) {
                    EXPECT_LT(region.distance_to_exact_surface(x + 0.5, y + 0.5), dense_px);
                } else if (!dense.covered(x, y)) {
                    EXPECT_LT(region.distance_to_uncovered(x + 0.5, y + 0.5).upper, dense_px);
                } else {
                    EXPECT_NEAR(dense.inverse_w(x, y) * image.at(x, y).w, 1, 2e-4);
                }
            }
    }
}

TEST(exact_image, lambert_of_a_plane_is_one_grey_whichever_way_its_normal_points) {
    const camera view{{1, 2, 7}, {1, 2, 0}, {0, 1, 0}, 45, 0.1};
    for (const double turn : {1.0, -1.0}) {
        const patch patches[] = {plane({-40, -40 * turn, 1}, {80, 0, 0}, {0, 80 * turn, 0})};
        const exact_image image(patches, view, {31, 22});
        ASSERT_NEAR(image.at(5, 9).normal.z, turn, 1e-15);
        // The light stands at cosine 0.6: 255 (0.1 + 0.54).
        for (const unsigned char grey : image.lambert({2.4, 0, 1.8}))
            ASSERT_EQ(grey, 163);
        for (const unsigned char grey : image.lambert({2.4, 0, -1.8}))
            ASSERT_EQ(grey, 26);
    }
}

} // namespace
} // namespace reference
