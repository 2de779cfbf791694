// SPDX-License-Identifier: MIT
// The certified bounds of image error against errors sampled on random rational surfaces.
#include "random_nets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace {

using namespace random_nets;

/// A cell of the surface by its corners, at s to the right and t down: what is drawn there.
struct cell {
    point a, b, c, d; ///< (0, 0), (1, 0), (0, 1), (1, 1)

    point bilinear(double s, double t) const { return mixed(mixed(a, b, s), mixed(c, d, s), t); }

    /// Four triangles around the centre that has the mean homogeneous coordinates.
    point fan(double s, double t) const {
        const point centre = (a + b + c + d) * 0.25;
        // Towards the nearest side: t, 1 - t, s or 1 - s is its distance, at most 1/2.
        const double nearest = std::min({t, 1 - t, s, 1 - s});
        const double along = nearest == t || nearest == 1 - t ? s : t;
        const auto on = [&](const point& p, const point& q) {
            return p * (1 - along - nearest) + q * (along - nearest) + centre * (2 * nearest);
        };
        if (nearest == t)
            return on(a, b);
        if (nearest == 1 - t)
            return on(c, d);
        return nearest == s ? on(a, c) : on(b, d);
    }

    /// Two triangles that meet along b c, or along a d.
    point triangles(double s, double t, bool along_bc) const {
        if (along_bc)
            return s + t <= 1 ? a + (b - a) * s + (c - a) * t
                              : d + (c - d) * (1 - s) + (b - d) * (1 - t);
        return s >= t ? a + (b - a) * s + (d - b) * t : a + (c - a) * t + (d - c) * s;
    }
};

/// The three ways to draw a cell.
enum class drawn { whole, fan, triangles };

/// Errors of a patch in n by m cells, each sampled at 4 by 4 points; calls visit(exact, drawn).
template <class Visit>
void sample(const l3d_image_patch& patch, int n, int m, drawn how, bool along_bc, Visit visit) {
    const auto grid = [&](int i, int j) {
        return patch.evaluate(static_cast<double>(i) / n, static_cast<double>(j) / m);
    };
    constexpr std::array<double, 4> inside{0.1, 0.35, 0.5, 0.8};
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const cell here{grid(i, j), grid(i + 1, j), grid(i, j + 1), grid(i + 1, j + 1)};
            for (const double s : inside)
                for (const double t : inside) {
                    const point approximate = how == drawn::whole ? here.bilinear(s, t)
                                              : how == drawn::fan ? here.fan(s, t)
                                                                  : here.triangles(s, t, along_bc);
                    visit(patch.evaluate((i + s) / n, (j + t) / m), approximate);
                }
        }
}

/// Largest distance in the image, of what is drawn inside `visible`.
double image_error(const l3d_image_patch& patch, int n, int m, drawn how, bool along_bc,
                   const l3d_image_box& visible) {
    double worst = 0;
    sample(patch, n, m, how, along_bc, [&](const point& exact, const point& approximate) {
        const pixel drawn_at = projected(approximate);
        if (holds(visible, drawn_at))
            worst = std::max(worst, distance(projected(exact), drawn_at));
    });
    return worst;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

void print(const char* what, kind k, const std::vector<double>& ratios) {
    std::printf("    %-9s %-9s measured / bound: median %.2f, most %.3f of %zu\n", what, name(k),
                median(ratios), *std::max_element(ratios.begin(), ratios.end()), ratios.size());
}

/// How far chords through n + 1 points, balanced but for the ends, are off the curve.
double balanced_error(const l3d_image_curve& curve, int n, const l3d_image_box& visible) {
    const l3d_image_curve moved = l3d_balanced(curve, n);
    const auto vertex = [&](int i) {
        return (i == 0 || i == n ? curve : moved).evaluate(static_cast<double>(i) / n);
    };
    double worst = 0;
    for (int i = 0; i < n; ++i)
        for (int k = 0; k <= 32; ++k) {
            const double t = k / 32.0;
            const pixel chord = projected(mixed(vertex(i), vertex(i + 1), t));
            if (holds(visible, chord))
                worst = std::max(worst, distance(chord, projected(curve.evaluate((i + t) / n))));
        }
    return worst;
}

TEST(step_bound, balanced_chords_err_to_both_sides_alike) {
    // f'' = (0, 600) pixels everywhere.
    const l3d_image_curve parabola{{{{30, 40, 1}, {80, 40, 1}, {130, 140, 1}, {180, 340, 1}}}};
    for (const int n : {2, 3, 7}) {
        const double bound = l3d_balanced_error(n) * l3d_second_bound_of(parabola, window, 1);
        EXPECT_NEAR(bound, 600 * 0.0857864 / (n * n), 1e-4);
        const double worst = balanced_error(parabola, n, window);
        EXPECT_LE(worst, bound * (1 + 1e-12));
        EXPECT_GE(worst, bound * 0.999); // reached at all vertices inside
    }
    EXPECT_EQ(l3d_balanced(parabola, 1).points, parabola.points);

    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (const kind k : kinds) {
        std::vector<double> ratios;
        for (int round = 0; round < 400; ++round) {
            const auto curve = random_curve(random, k);
            const int n = random.up_to(16);
            const l3d_image_box hull = l3d_image_box_of(curve.points);
            const double least = l3d_depth_range_of(curve.points).least;
            // As far as the bound says that balance moves vertices out of the hull.
            const double reach =
                l3d_second_bound_of(curve, hull.grown(hull.width() + hull.height()), least);
            const l3d_image_box visible = hull.grown(reach / 8 / (n * n)).intersected(window);
            if (visible.empty() || reach > 8 * n * n * (hull.width() + hull.height()))
                continue;
            const double bound = l3d_balanced_error(n) * l3d_second_bound_of(curve, visible, least);
            const double worst = balanced_error(curve, n, visible);
            ASSERT_LE(worst, bound + 1e-9) << name(k) << ", " << n << " steps";
            ratios.push_back(worst / bound);
        }
        print("balanced", k, ratios);
        EXPECT_GE(median(ratios), k == kind::deep ? 0.05 : 0.3);
    }
}

TEST(step_bound, of_mixed_derivatives_are_kept) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (int round = 0; round < 200; ++round) {
        l3d_image_patch patch = random_patch(random, kind::moderate);
        for (point& p : patch.points)
            p = {p[0] / p[2], p[1] / p[2], 1};
        const l3d_mixed_bounds bounds = l3d_mixed_bounds_of(patch, window, 1);
        const auto second = [](const l3d_image_curve& f,
                               double t) { // f'' = 6 (lerp of differences)
            const auto& p = f.points;
            const point first = p[0] - p[1] * 2.0 + p[2], last = p[1] - p[2] * 2.0 + p[3];
            return (first + (last - first) * t) * 6.0;
        };
        const double u = random.within(0, 1), v = random.within(0, 1);
        l3d_image_curve uu, vv;
        for (std::size_t i = 0; i < 4; ++i) {
            uu.points[i] = second(patch.row(static_cast<int>(i)), u);
            vv.points[i] = second(patch.column(static_cast<int>(i)), v);
        }
        const auto slope = [](const l3d_image_curve& f, double t) { // of a cubic
            const auto d = f.derivative();
            return d[0] * ((1 - t) * (1 - t)) + d[1] * (2 * t * (1 - t)) + d[2] * (t * t);
        };
        const auto length = [](const point& d) { return std::hypot(d[0], d[1]); };
        EXPECT_LE(length(slope(uu, v)), bounds.uuv * (1 + 1e-12));
        EXPECT_LE(length(slope(vv, u)), bounds.uvv * (1 + 1e-12));
        EXPECT_LE(length(second(uu, v)), bounds.uuvv * (1 + 1e-12));
        EXPECT_GT(length(slope(uu, v)) + length(slope(vv, u)), 0);
    }
}

TEST(step_bound, of_a_chord_is_kept_and_tight) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (const kind k : kinds) {
        std::vector<double> ratios;
        for (int round = 0; round < 400; ++round) {
            const auto curve = random_curve(random, k);
            const auto visible = l3d_image_box_of(curve.points).intersected(window);
            if (visible.empty())
                continue;
            const int n = random.up_to(16);
            const double bound =
                l3d_second_bound_of(curve, visible, l3d_depth_range_of(curve.points).least) /
                (8.0 * n * n);
            double worst = 0;
            for (int i = 0; i < n; ++i) {
                const point a = curve.evaluate(static_cast<double>(i) / n);
                const point b = curve.evaluate(static_cast<double>(i + 1) / n);
                for (const double t : {0.1, 0.3, 0.5, 0.7, 0.9}) {
                    const pixel chord = projected(mixed(a, b, t));
                    if (holds(visible, chord))
                        worst = std::max(worst,
                                         distance(chord, projected(curve.evaluate((i + t) / n))));
                }
            }
            ASSERT_LE(worst, bound + 1e-9) << name(k) << ", " << n << " steps";
            ratios.push_back(worst / bound);
        }
        print("chord", k, ratios);
        EXPECT_GE(median(ratios), k == kind::deep ? 0.1 : 0.3);
        EXPECT_GE(*std::max_element(ratios.begin(), ratios.end()), 0.85);
    }
}

TEST(step_bound, of_quads_fans_and_triangles_is_kept_and_tight) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    for (const drawn how : {drawn::whole, drawn::fan, drawn::triangles})
        for (const kind k : kinds) {
            oracle::random_values random(seed);
            std::vector<double> ratios;
            for (int round = 0; round < 200; ++round) {
                const auto patch = random_patch(random, k);
                const auto visible = l3d_image_box_of(patch.points).intersected(window);
                const int n = random.up_to(12), m = random.up_to(12);
                const bool along_bc = random.up_to(2) == 1;
                if (visible.empty())
                    continue;
                const l3d_second_bounds second =
                    l3d_second_bounds_of(patch, visible, l3d_depth_range_of(patch.points).least);
                // The mixed term is no part of the error of a quad that is drawn whole.
                l3d_second_bounds unmixed = second;
                unmixed.uv = 0;
                const double bound = how == drawn::whole ? unmixed.quad_error(n, m)
                                     : how == drawn::fan ? second.quad_error(n, m)
                                                         : second.triangle_error(n, m);
                const double worst = image_error(patch, n, m, how, along_bc, visible);
                ASSERT_LE(worst, bound + 1e-9) << name(k) << ", " << n << " by " << m;
                ratios.push_back(worst / bound);
            }
            print(how == drawn::whole ? "quad"
                  : how == drawn::fan ? "fan"
                                      : "triangles",
                  k, ratios);
            if (k != kind::deep) { // whose greatest bend and least w lie far apart
                EXPECT_GE(median(ratios), 0.3);
            }
        }
}

/// Where second derivatives are the same everywhere the bound leaves nothing to chance.
TEST(step_bound, is_reached_by_a_parabolic_cylinder_and_by_a_saddle) {
    l3d_image_patch cylinder, saddle;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const double u = c / 3.0, v = r / 3.0;
            // Bernstein coefficients of t^2 are 0, 0, 1/3, 1.
            const double square = c * (c - 1) / 6.0;
            cylinder.at(r, c) = point{90 * u - 50, 70 * v + 30 * square - 80, 1} * 4.0;
            saddle.at(r, c) = point{90 * u - 50, 70 * v - 60 * u * v - 80, 1} * 4.0;
        }
    const auto ratio = [](const l3d_image_patch& patch, drawn how) {
        const auto bounds = l3d_second_bounds_of(patch, window, 4);
        const double bound =
            how == drawn::triangles ? bounds.triangle_error(5, 3) : bounds.quad_error(5, 3);
        return image_error(patch, 5, 3, how, true, window) / bound;
    };
    EXPECT_NEAR(ratio(cylinder, drawn::whole), 1, 1e-12); // 60 / (8 * 25)
    EXPECT_NEAR(ratio(cylinder, drawn::triangles), 1, 1e-12);
    EXPECT_NEAR(ratio(saddle, drawn::triangles), 1, 1e-12); // 60 / (4 * 15), on the diagonal
    EXPECT_LT(ratio(saddle, drawn::whole), 1e-12);
    EXPECT_GT(ratio(saddle, drawn::fan), 0.8); // 60 / (16 * 15) at s = 1/2, t = 1/4
}

TEST(step_bound, of_depth_is_kept) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (const kind k : kinds) {
        std::vector<double> ratios;
        for (int round = 0; round < 100; ++round) {
            const auto patch = random_patch(random, k);
            const int n = random.up_to(10), m = random.up_to(10);
            const double bound = l3d_depth_bounds_of(patch).triangle_error(n, m);
            double worst = 0;
            sample(patch, n, m, drawn::triangles, round % 2 == 0,
                   [&](const point& exact, const point& approximate) {
                       worst = std::max(worst, std::abs(exact[2] - approximate[2]));
                   });
            ASSERT_LE(worst, bound + 1e-12);
            ratios.push_back(worst / bound);

            const auto edge = patch.column(0);
            const double chord = l3d_depth_bound_of(edge) / (8.0 * n * n);
            for (int i = 0; i < n; ++i) {
                const double low = edge.evaluate(static_cast<double>(i) / n)[2];
                const double high = edge.evaluate(static_cast<double>(i + 1) / n)[2];
                ASSERT_LE(std::abs(edge.evaluate((i + 0.5) / n)[2] - (low + high) / 2),
                          chord + 1e-12);
            }
        }
        print("depth", k, ratios);
        EXPECT_GE(median(ratios), 0.25);
    }
}

TEST(step_bound, of_a_displaced_vertex_is_kept_and_tight) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    double worst = 0;
    for (int round = 0; round < 20000; ++round) {
        const double reach = random.within(1, 600);
        const double w = random.within(0.5, 9);
        const double e_xy = random.within(0, 0.3), e_w = w * random.within(0, 0.2);
        const auto either = [&](double e) { return random.up_to(2) == 1 ? e : -e; };
        const point h = point{either(reach), random.within(-reach, reach), 1} * w;
        const point off = h + point{either(e_xy), either(e_xy), either(e_w)};
        const double bound = l3d_vertex_error(e_xy, e_w, reach, w);
        const double error = distance(projected(h), projected(off));
        ASSERT_LE(error, bound * (1 + 1e-12) + 1e-12);
        worst = std::max(worst, error / bound);
    }
    EXPECT_GT(worst, 0.99);
}

} // namespace
