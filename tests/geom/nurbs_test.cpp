// SPDX-License-Identifier: MIT
// NURBS curves, surfaces and shapes against the definition of B-splines in exact rationals.
#include "base/error.h"
#include "geom/nurbs_surface.h"
#include "rational_oracle.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace {

using exact = boost::multiprecision::cpp_rational;
using vector = l3d_vector<double, 3>;

/// The B-splines of a direction that are not 0 at t, and their derivatives, by Cox and de Boor;
/// 0 / 0 is 0. Spans are closed below, but above at the end of the domain.
struct basis {
    std::size_t first; ///< B-spline
    std::vector<exact> value, slope;

    basis(const l3d_bspline_direction& d, double at) {
        const auto degree = static_cast<std::size_t>(d.degree);
        std::size_t span = degree;
        for (std::size_t i = span; i < d.points(); ++i)
            if (d.knots[i] < d.knots[i + 1] && d.knots[i] <= at)
                span = i;
        first = span - degree;
        const auto from = d.knots.begin() + static_cast<std::ptrdiff_t>(first);
        const std::vector<exact> knots(from, from + 2 * d.degree + 2);
        const exact t = at;
        const auto over = [](const exact& a, const exact& b) {
            return a == 0 ? exact(0) : exact(a / b);
        };
        std::vector<exact> n(2 * degree + 1, 0);
        n[degree] = 1;
        for (std::size_t p = 1; p <= degree; ++p) {
            if (p == degree)
                for (std::size_t i = 0; i <= degree; ++i)
                    slope.push_back(p * (over(n[i], knots[i + p] - knots[i]) -
                                         over(n[i + 1], knots[i + p + 1] - knots[i + 1])));
            for (std::size_t i = degree - p; i <= degree; ++i)
                n[i] = over((t - knots[i]) * n[i], knots[i + p] - knots[i]) +
                       over((knots[i + p + 1] - t) * n[i + 1], knots[i + p + 1] - knots[i + 1]);
        }
        value.assign(n.begin(), n.begin() + d.degree + 1);
    }
};

struct exact_jet {
    std::array<double, 3> place{}, by_u{}, by_v{};

    exact_jet(const l3d_nurbs_surface& s, double u, double v) {
        const basis in_u(s.u(), u), in_v(s.v(), v);
        std::array<std::array<exact, 4>, 3> sums;
        for (std::size_t r = 0; r < in_v.value.size(); ++r) {
            std::array<exact, 4> row, by_u_of_row;
            for (std::size_t c = 0; c < in_u.value.size(); ++c) {
                const std::size_t i = (in_v.first + r) * s.u().points() + in_u.first + c;
                const exact w = s.weights().empty() ? 1.0 : s.weights()[i];
                for (int k = 0; k < 4; ++k) {
                    const exact of = k < 3 ? exact(w * exact(s.points()[i][k])) : w;
                    row[static_cast<std::size_t>(k)] += in_u.value[c] * of;
                    by_u_of_row[static_cast<std::size_t>(k)] += in_u.slope[c] * of;
                }
            }
            for (std::size_t k = 0; k < 4; ++k) {
                sums[0][k] += row[k] * in_v.value[r];
                sums[1][k] += by_u_of_row[k] * in_v.value[r];
                sums[2][k] += row[k] * in_v.slope[r];
            }
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const exact at = sums[0][k] / sums[0][3];
            place[k] = static_cast<double>(at);
            by_u[k] = static_cast<double>(exact((sums[1][k] - at * sums[1][3]) / sums[0][3]));
            by_v[k] = static_cast<double>(exact((sums[2][k] - at * sums[2][3]) / sums[0][3]));
        }
    }
};

/// Knots with multiplicities up to the degree; clamped, periodic, or neither.
l3d_bspline_direction random_direction(std::mt19937& random, int most_degree) {
    const int degree = 1 + static_cast<int>(random() % static_cast<unsigned>(most_degree));
    const auto n = static_cast<std::size_t>(degree);
    if (random() % 3 == 0)
        return l3d_bspline_direction::periodic(degree, 2 * n + 1 + random() % 4);
    l3d_bspline_direction d{degree, {}, 0, 0};
    const bool is_clamped = random() % 2 == 0;
    double at = -1;
    const auto add = [&](std::size_t times) {
        d.knots.insert(d.knots.end(), times, at);
        at += std::array{0.125, 1.0, 0.75}[random() % 3];
    };
    for (std::size_t i = 0; i < (is_clamped ? 1 : n + 1); ++i)
        add(is_clamped ? n + 1 : 1);
    d.from = d.knots[n];
    for (std::size_t spans = random() % 4; spans > 0; --spans)
        add(1 + random() % n);
    d.to = at;
    for (std::size_t i = 0; i < (is_clamped ? 1 : n + 1); ++i)
        add(is_clamped ? n + 1 : 1);
    return d;
}

l3d_nurbs_surface random_surface(std::mt19937& random, int most_degree) {
    // Few bits make exact rationals fast.
    const auto any = [](std::mt19937& r) { return static_cast<int>(r() % 513) / 256.0 - 1; };
    const l3d_bspline_direction u = random_direction(random, most_degree);
    const l3d_bspline_direction v = random_direction(random, most_degree);
    std::vector<vector> points;
    std::vector<double> weights;
    const bool is_rational = random() % 3 != 0;
    for (std::size_t i = 0; i < u.points() * v.points(); ++i) {
        points.push_back({any(random), any(random), any(random)});
        if (is_rational)
            weights.push_back(std::exp2(std::round(4 * any(random))));
    }
    return {u, v, points, weights};
}

double place_in(const l3d_bspline_direction& d, std::mt19937& random) {
    const double knot = std::clamp(d.knots[random() % d.knots.size()], d.from, d.to);
    if (random() % 3 == 0)
        return knot; // at the ends and at multiple knots, too
    const double at = std::uniform_real_distribution<double>(d.from, d.to)(random);
    return std::clamp(std::round(at * 512) / 512, d.from, d.to);
}

double off(const std::array<double, 3>& a, const vector& b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

/// Compares four places of each of so many surfaces.
void compare_with_exact_rationals(int surfaces) {
    std::mt19937 random(52);
    double worst = 0, worst_slope = 0;
    int at_ends = 0, at_multiple = 0;
    for (int trial = 0; trial < surfaces; ++trial) {
        const l3d_nurbs_surface s = random_surface(random, trial % 20 == 0 ? 15 : 4);
        for (int i = 0; i < 4; ++i) {
            const double u = place_in(s.u(), random), v = place_in(s.v(), random);
            const exact_jet e(s, u, v);
            const l3d_surface_derivatives d = s.derivatives(u, v);
            worst = std::max({worst, off(e.place, d.place), off(e.place, s.evaluate(u, v))});
            const double size = 1 + l3d_length(d.by_u) + l3d_length(d.by_v);
            worst_slope =
                std::max({worst_slope, off(e.by_u, d.by_u) / size, off(e.by_v, d.by_v) / size});
            const bool is_end = u == s.u().from || u == s.u().to;
            at_ends += is_end;
            at_multiple += !is_end && std::ranges::count(s.u().knots, u) > 1;
        }
    }
    std::printf("%d places, %d at ends of u, %d at multiple knots: off by %.2g, derivatives by "
                "%.2g of their size\n",
                4 * surfaces, at_ends, at_multiple, worst, worst_slope);
    EXPECT_LT(worst, 1e-13);
    EXPECT_LT(worst_slope, 1e-12);
    EXPECT_GT(20 * std::min(at_ends, 5 * at_multiple), 4 * surfaces);
}

std::string why_not(const std::function<void()>& make) {
    try {
        make();
    } catch (const l3d_error& error) {
        EXPECT_EQ(error.code(), l3d_exit::bad_input);
        return error.what();
    }
    return "nothing";
}

} // namespace

TEST(nurbs, places_and_derivatives_are_those_of_exact_rationals) {
    compare_with_exact_rationals(200);
}

TEST(nurbs, places_and_derivatives_are_those_of_exact_rationals_at_100000_places) {
    compare_with_exact_rationals(25'000);
}

TEST(nurbs, second_derivatives_are_differences_of_first_ones) {
    std::mt19937 random(53);
    for (int trial = 0; trial < 100; ++trial) {
        const l3d_nurbs_surface s = random_surface(random, 5);
        const double h = 1e-6, u = s.u().from + 0.37 * (s.u().to - s.u().from) + 1e-5;
        const double v = s.v().from + 0.61 * (s.v().to - s.v().from) + 1e-5;
        const l3d_surface_derivatives at = s.derivatives(u, v), right = s.derivatives(u + h, v);
        const l3d_surface_derivatives left = s.derivatives(u - h, v), up = s.derivatives(u, v + h);
        const l3d_surface_derivatives down = s.derivatives(u, v - h);
        const double size = 1 + l3d_length(at.by_uu) + l3d_length(at.by_uv) + l3d_length(at.by_vv);
        EXPECT_LT(l3d_length((right.by_u - left.by_u) / (2 * h) - at.by_uu), 1e-3 * size);
        EXPECT_LT(l3d_length((up.by_u - down.by_u) / (2 * h) - at.by_uv), 1e-3 * size);
        EXPECT_LT(l3d_length((up.by_v - down.by_v) / (2 * h) - at.by_vv), 1e-3 * size);
    }
}

TEST(nurbs, pieces_and_inserted_knots_leave_the_surface_as_it_is) {
    std::mt19937 random(54);
    for (int trial = 0; trial < 200; ++trial) {
        const l3d_nurbs_surface s = random_surface(random, 6);
        const double u = s.u().from + 0.3137 * (s.u().to - s.u().from);
        const double v = s.v().from + 0.7111 * (s.v().to - s.v().from);
        const l3d_nurbs_surface more =
            s.with_knot_u(u).with_knot_v(v).with_knot_u(0.5 * (s.u().from + u));
        EXPECT_EQ(more.u().points(), s.u().points() + 2);
        EXPECT_EQ(more.v().points(), s.v().points() + 1);
        const std::vector<l3d_patch_points> pieces = s.pieces();
        ASSERT_EQ(pieces.size(), s.u().segments() * s.v().segments());
        for (int i = 0; i < 5; ++i) {
            const double a = place_in(s.u(), random), b = place_in(s.v(), random);
            EXPECT_LT(l3d_length(more.evaluate(a, b) - s.evaluate(a, b)), 1e-12);
        }
        const oracle::rational_jet corner(pieces.front(), 0, 0), end(pieces.back(), 1, 1);
        const vector first = s.evaluate(s.u().from, s.v().from);
        const vector last = s.evaluate(s.u().to, s.v().to);
        EXPECT_LT(oracle::distance(corner.place, {first[0], first[1], first[2]}), 1e-12L);
        EXPECT_LT(oracle::distance(end.place, {last[0], last[1], last[2]}), 1e-12L);
    }
}

TEST(nurbs, periodic_curves_close_smoothly) {
    std::vector<vector> points{{1, 0, 0}, {0, 1, 0}, {-1, 0, 1}, {0, -1, 0}};
    for (int i = 0; i < 3; ++i)
        points.push_back(points[static_cast<std::size_t>(i)]);
    const l3d_nurbs_curve c(l3d_bspline_direction::periodic(3, points.size()), points);
    const l3d_curve_jet begin = c.derivatives(0), end = c.derivatives(1);
    EXPECT_LT(l3d_length(begin.place - end.place), 1e-15);
    EXPECT_LT(l3d_length(begin.first - end.first), 1e-13);
    EXPECT_LT(l3d_length(begin.second - end.second), 1e-11);
    const l3d_nurbs_curve more = c.with_knot(0.3).with_knot(0.3);
    EXPECT_LT(l3d_length(more.evaluate(0.31) - c.evaluate(0.31)), 1e-15);
}

TEST(nurbs, refuses_what_is_no_surface_and_says_why) {
    const l3d_bspline_direction line = l3d_bspline_direction::clamped(1, 2);
    const std::vector<vector> square{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    const auto of = [&](const l3d_bspline_direction& u, std::vector<vector> points,
                        std::vector<double> weights) {
        return why_not([&] { l3d_nurbs_surface(u, line, std::move(points), std::move(weights)); });
    };
    EXPECT_EQ(of(line, square, {}), "nothing");
    EXPECT_EQ(of({16, {}, 0, 1}, square, {}), "surface: along u: degree 16 is not from 1 to 15");
    EXPECT_EQ(of({1, {0, 0, 1}, 0, 1}, square, {}),
              "surface: along u: 3 knots are fewer than twice the degree and 2");
    EXPECT_EQ(of({1, {0, 1, 0, 1}, 0, 1}, square, {}),
              "surface: along u: knot 3 is less than the one before");
    EXPECT_EQ(of({1, {0, 0, 1, std::nan("")}, 0, 1}, square, {}),
              "surface: along u: knot 4 is not finite, or beyond 1e12");
    EXPECT_EQ(of({1, {0, 0, 1, 1, 2, 2}, 0, 2}, square, {}),
              "surface: along u: knot 4 is there more often than the degree");
    EXPECT_EQ(
        of({1, {0, 0, 1, 1}, 0, 2}, square, {}),
        "surface: along u: the range of the parameter is empty, or the knots do not cover it");
    EXPECT_EQ(of(line, {square[0]}, {}), "surface: 1 control points; the knots ask for 4");
    EXPECT_EQ(of(line, square, {1, 1}), "surface: 2 weights for 4 control points");
    EXPECT_EQ(of(line, square, {1, 1, 0, 1}),
              "surface: control point 3 has the weight 0.000000, which is not from 1e-100 to "
              "1e12");
    EXPECT_EQ(of(line, {{0, 0, 0}, {1e13, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {}),
              "surface: control point 2 is not finite, or beyond 1e12");
    const l3d_nurbs_curve curve = l3d_nurbs_curve::polyline({square[0], square[1], square[3]});
    EXPECT_EQ(why_not([&] { static_cast<void>(curve.with_knot(0.5)); }),
              "curve: knot 0.500000 is there as often as the degree says");
    EXPECT_EQ(why_not([&] { static_cast<void>(curve.with_knot(1)); }),
              "curve: knot 1.000000 is outside of the range of the parameter");
    EXPECT_EQ(why_not([&] { static_cast<void>(l3d_ruled(curve, l3d_nurbs_curve::circle(1))); }),
              "ruled surface: the curves differ in their degrees or ranges");
}

TEST(nurbs_shapes, have_their_closed_forms) {
    std::mt19937 random(55);
    for (const std::string_view name : l3d_exact_shape_names())
        for (const auto shape = l3d_exact_shape(name); const l3d_nurbs_surface& s : *shape)
            for (int i = 0; i < 200; ++i) {
                const l3d_surface_derivatives d =
                    s.derivatives(place_in(s.u(), random), place_in(s.v(), random));
                const double x = d.place[0], y = d.place[1], z = d.place[2];
                const double r = std::hypot(x, z);
                const vector out = l3d_cross(d.by_u, d.by_v);
                double away = 0, side = 0;
                if (name == "sphere") {
                    away = std::hypot(r, y) - 1;
                    side = l3d_dot(out, d.place);
                } else if (name == "torus") {
                    away = std::hypot(r - 1, y) - 0.4;
                    side = l3d_dot(out, d.place - vector{x / r, 0.0, z / r});
                } else if (name == "disc") {
                    away = y;
                    side = out[1];
                } else if (name == "cylinder") {
                    away = std::max(r, std::abs(y)) - 1;
                    side = l3d_dot(out, std::abs(y) < 1 ? vector{x, 0.0, z} : vector{0.0, y, 0.0});
                } else {
                    away = y == -1 ? std::max(0.0, r - 1) : 2 * r + y - 1;
                    const double beside = l3d_dot(out, vector{2 * x, r, 2 * z});
                    side = y == -1 ? std::max(-out[1], beside) : beside;
                }
                EXPECT_NEAR(away, 0, 1e-15 * 8) << name;
                EXPECT_GE(side, -1e-12) << name;
            }
    EXPECT_FALSE(l3d_exact_shape("cube"));
}

TEST(nurbs_shapes, move_and_join_curves) {
    const l3d_nurbs_curve circle = l3d_nurbs_curve::circle(2);
    const l3d_nurbs_surface tube = l3d_extruded(circle, {0.0, 0.0, 3.0});
    const l3d_nurbs_surface cone = l3d_ruled(circle.with_knot(0.5), l3d_nurbs_curve::circle(1));
    for (double u = 0; u <= 4; u += 0.1) {
        EXPECT_LT(l3d_length(tube.evaluate(u, 0.5) - circle.evaluate(u) - vector{0.0, 0.0, 1.5}),
                  1e-14);
        EXPECT_NEAR(l3d_length(cone.evaluate(u, 1)), 1, 1e-14);
        EXPECT_NEAR(l3d_length(cone.evaluate(u, 0)), 2, 1e-14);
    }
}

TEST(nurbs_shapes, pipes_keep_their_tolerance) {
    const l3d_nurbs_curve curve(l3d_bspline_direction::clamped(3, 5),
                                {{0, 0, 0}, {2, 0, 0}, {2, 2, 1}, {0, 2, 3}, {0, 0, 4}});
    for (const double tolerance : {1e-2, 1e-5, 1e-8}) {
        const l3d_pipe pipe = l3d_pipe_along(curve, 0.25, tolerance);
        EXPECT_LE(pipe.measured, tolerance);
        for (double v = 0; v <= 1; v += 1.0 / 64) {
            const l3d_curve_jet at = curve.derivatives(v);
            for (double u = 0; u <= 4; u += 0.25) {
                const vector from = pipe.surface.evaluate(u, v) - at.place;
                EXPECT_NEAR(l3d_length(from), 0.25, 2 * tolerance);
                EXPECT_NEAR(l3d_dot(from, l3d_normalized(at.first)), 0, 2 * tolerance);
            }
        }
    }
    EXPECT_EQ(why_not([&] { l3d_pipe_along(curve, 1, 1e-18); }).substr(0, 6), "pipe: ");
}
