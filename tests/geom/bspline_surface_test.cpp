// SPDX-License-Identifier: MIT
// Bezier patches of B-spline surfaces against the definition of B-splines.
#include "geom/nurbs_surface.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using point = std::array<double, 3>;

/// N_{i,n}(t) by Cox and de Boor's recursion; 0 / 0 is 0. Spans are closed below, but above at the
/// end of the domain, `last`.
long double basis(const std::vector<double>& knots, std::size_t i, int n, double t, double last) {
    if (n == 0)
        return (t < last ? knots[i] <= t && t < knots[i + 1] : knots[i] < t && t <= knots[i + 1]);
    const auto width = static_cast<std::size_t>(n);
    const auto part = [&](std::size_t from, std::size_t to, long double numerator, std::size_t of) {
        const long double whole = static_cast<long double>(knots[to]) - knots[from];
        return whole > 0 ? numerator / whole * basis(knots, of, n - 1, t, last) : 0;
    };
    return part(i, i + width, static_cast<long double>(t) - knots[i], i) +
           part(i + 1, i + width + 1, static_cast<long double>(knots[i + width + 1]) - t, i + 1);
}

point on_spline(const l3d_bspline_direction& u, const l3d_bspline_direction& v,
                const std::vector<point>& points, double s, double t) {
    long double sum[3] = {};
    for (std::size_t row = 0; row < v.points(); ++row)
        for (std::size_t column = 0; column < u.points(); ++column) {
            const long double weight = basis(u.knots, column, u.degree, s, u.knots[u.points()]) *
                                       basis(v.knots, row, v.degree, t, v.knots[v.points()]);
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += weight * points[row * u.points() + column][k];
        }
    return {static_cast<double>(sum[0]), static_cast<double>(sum[1]), static_cast<double>(sum[2])};
}

point on_patch(const l3d_patch_points& patch, double s, double t) {
    const auto bernstein = [](int n, int i, double x) {
        double choose = 1;
        for (int k = 1; k <= i; ++k)
            choose = choose * (n - k + 1) / k;
        return choose * std::pow(x, i) * std::pow(1 - x, n - i);
    };
    point sum{};
    for (int row = 0; row <= patch.degree_v; ++row)
        for (int column = 0; column <= patch.degree_u; ++column) {
            const double weight =
                bernstein(patch.degree_u, column, s) * bernstein(patch.degree_v, row, t);
            const auto index = static_cast<std::size_t>(row * (patch.degree_u + 1) + column);
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += weight * patch.points[index][k];
        }
    return sum;
}

/// Knots with every multiplicity up to the degree, and a range that may begin between knots.
l3d_bspline_direction random_direction(std::mt19937& random, int degree) {
    l3d_bspline_direction d{degree, {}, 0, 0};
    double knot = 1.25;
    for (int i = 0; i < 4 * degree + 4; ++i) {
        const auto same = std::count(d.knots.begin(), d.knots.end(), knot);
        if (same >= degree || random() % 3 == 0)
            knot += 0.5 + static_cast<double>(random() % 7) / 3;
        d.knots.push_back(knot);
    }
    const double first = d.knots[static_cast<std::size_t>(degree)];
    const double last = d.knots[d.points()];
    d.from = random() % 2 ? first : 0.75 * first + 0.25 * last;
    d.to = random() % 2 ? last : 0.25 * first + 0.75 * last;
    return d;
}

std::vector<point> random_points(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> number(1, 9);
    std::vector<point> points(count);
    for (point& p : points)
        p = {number(random), number(random), number(random)};
    return points;
}

/// Where the wanted spans begin and end.
std::vector<double> breaks(const l3d_bspline_direction& d) {
    std::vector<double> result{d.from};
    for (const double knot : d.knots)
        if (knot > result.back() && knot < d.to)
            result.push_back(knot);
    result.push_back(d.to);
    return result;
}

TEST(bspline_surface, patches_are_the_surface) {
    constexpr unsigned seed = 5772;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int i = 0; i < 60; ++i) {
        const l3d_bspline_direction u = random_direction(random, 1 + i % 4);
        const l3d_bspline_direction v = random_direction(random, 1 + i / 4 % 5);
        const std::vector<point> points = random_points(random, u.points() * v.points());
        const auto patches = l3d_bezier_patches(u, v, points);
        const std::vector<double> us = breaks(u);
        const std::vector<double> vs = breaks(v);
        ASSERT_EQ(u.segments(), us.size() - 1);
        ASSERT_EQ(patches.size(), (us.size() - 1) * (vs.size() - 1));
        for (std::size_t n = 0; n < patches.size(); ++n) {
            const std::size_t column = n % (us.size() - 1);
            const std::size_t row = n / (us.size() - 1);
            for (const double x : {0.0, 0.3, 0.9})
                for (const double y : {0.1, 0.5, 1.0}) {
                    const double s = us[column] + x * (us[column + 1] - us[column]);
                    const double t = vs[row] + y * (vs[row + 1] - vs[row]);
                    const point expected = on_spline(u, v, points, s, t);
                    const point got = on_patch(patches[n], x, y);
                    for (std::size_t k = 0; k < 3; ++k)
                        ASSERT_NEAR(got[k], expected[k], 1e-12 * 9) << i << " patch " << n;
                }
        }
    }
}

TEST(bspline_surface, neighbours_share_their_boundary_bit_for_bit) {
    std::mt19937 random(1729);
    for (int i = 0; i < 40; ++i) {
        const l3d_bspline_direction u = random_direction(random, 3);
        const l3d_bspline_direction v = random_direction(random, 2);
        const auto patches =
            l3d_bezier_patches(u, v, random_points(random, u.points() * v.points()));
        const std::size_t across = u.segments();
        for (std::size_t n = 0; n < patches.size(); ++n) {
            const bool has_right = n % across + 1 < across;
            for (std::size_t row = 0; has_right && row < 3; ++row)
                ASSERT_EQ(patches[n].points[4 * row + 3], patches[n + 1].points[4 * row]);
            const bool has_next = n + across < patches.size();
            for (std::size_t column = 0; has_next && column < 4; ++column)
                ASSERT_EQ(patches[n].points[8 + column], patches[n + across].points[column]);
        }
    }
}

TEST(bspline_surface, bezier_points_stay_as_they_are) {
    std::mt19937 random(41);
    const l3d_bspline_direction u{3, {1, 1, 1, 1, 1.7, 1.7, 1.7, 5, 5, 5, 5}, 1, 5};
    const l3d_bspline_direction v{2, {0, 0, 0, 1, 1, 1}, 0, 1};
    const std::vector<point> points = random_points(random, std::size_t{7} * 3);
    const auto patches = l3d_bezier_patches(u, v, points);
    ASSERT_EQ(patches.size(), 2u);
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 4; ++column) {
            EXPECT_EQ(patches[0].points[4 * row + column], points[7 * row + column]);
            EXPECT_EQ(patches[1].points[4 * row + column], points[7 * row + column + 3]);
        }
}

TEST(bspline_surface, a_uniform_cubic_has_its_well_known_bezier_points) {
    // Along u: (p0 + 4 p1 + p2) / 6, (2 p1 + p2) / 3, (p1 + 2 p2) / 3, (p1 + 4 p2 + p3) / 6.
    const l3d_bspline_direction u{3, {0, 1, 2, 3, 4, 5, 6, 7}, 3, 4};
    const l3d_bspline_direction v{1, {0, 0, 1, 1}, 0, 1};
    const std::vector<point> points{{6, 12, 1},  {18, 6, 1},  {30, 24, 1}, {48, 12, 1},
                                    {12, 24, 2}, {36, 12, 2}, {60, 48, 2}, {96, 24, 2}};
    const auto patches = l3d_bezier_patches(u, v, points);
    ASSERT_EQ(patches.size(), 1u);
    const std::vector<point> expected{{18, 10, 1}, {22, 12, 1}, {26, 18, 1}, {31, 19, 1},
                                      {36, 20, 2}, {44, 24, 2}, {52, 36, 2}, {62, 38, 2}};
    EXPECT_EQ(patches[0].points, expected);
}

} // namespace
