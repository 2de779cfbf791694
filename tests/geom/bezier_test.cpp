// SPDX-License-Identifier: MIT
// l3d_bezier_curve and l3d_bezier_patch against their definition in long double.
#include "geom/bezier_oracle.h"
#include "geom/bezier_patch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <type_traits>

namespace {

using oracle::real;

constexpr std::uint64_t seed = 20260117;
constexpr double largest = 300; // magnitude of control values
constexpr int rounds = 40;

template <class T> class bezier : public testing::Test {
protected:
    using traits = l3d_real_traits<T>;

    /// Rounding of `levels` interpolations in a row of values up to `size`. Each adds 2 u size for
    /// the difference, 2 u size for the product, and u size for the sum. In fixed point it adds
    /// half an ulp.
    static double rounding(int levels, double size = largest) {
        return levels * (5 * traits::unit_roundoff * size + traits::half_ulp);
    }

    /// Far from the origin in x, in y around it, small in z; all on a 2^-10 grid, which every
    /// type holds exactly.
    l3d_vector<T, 3> point() { return {value(120, 299), value(-250, 170), value(-1.5, 2.25)}; }

    l3d_bezier_curve<T, 3> curve() { return {{point(), point(), point(), point()}}; }

    l3d_bezier_patch<T, 3> patch() {
        l3d_bezier_patch<T, 3> result;
        for (auto& p : result.points)
            p = point();
        return result;
    }

    /// A multiple of 1/64, so that no type rounds it.
    T parameter() { return value(0, 1, 6); }

    T value(double low, double high, int fraction_bits = 10) {
        return l3d_from_double<T>(random.on_grid(low, high, fraction_bits));
    }

    oracle::random_values random{seed};

private:
    testing::ScopedTrace trace_{__FILE__, __LINE__, "seed " + std::to_string(seed)};
};

using numbers =
    testing::Types<float, double, l3d_fixed<std::int32_t, 16>, l3d_fixed<std::int64_t, 32>>;
TYPED_TEST_SUITE(bezier, numbers);

double in_double(auto value) {
    return l3d_to_double(value);
}

template <class T, int N>
void expect_near(const l3d_vector<T, N>& a, const l3d_vector<T, N>& b, double tolerance) {
    for (int k = 0; k < N; ++k)
        EXPECT_NEAR(in_double(a[k]), in_double(b[k]), tolerance) << "component " << k;
}

TYPED_TEST(bezier, curve_is_the_cubic_of_its_control_points) {
    using T = TypeParam;
    for (int round = 0; round < rounds; ++round) {
        const auto curve = this->curve();
        EXPECT_EQ(curve.evaluate(T(0)), curve.points[0]);
        for (int i = 0; i < 9; ++i) {
            const T t = this->parameter();
            const auto p = curve.evaluate(t);
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(in_double(p[k]),
                            double(oracle::cubic(oracle::component(curve, k), in_double(t)).value),
                            this->rounding(3));
        }
    }
}

TYPED_TEST(bezier, patch_is_the_bicubic_of_its_control_points) {
    for (int round = 0; round < rounds; ++round) {
        const auto patch = this->patch();
        const auto u = this->parameter(), v = this->parameter();
        const auto p = patch.evaluate(u, v);
        const auto across = patch.transposed().evaluate(v, u);
        const auto by_u = patch.derivative_u(u, v), by_v = patch.derivative_v(u, v);
        for (int k = 0; k < 3; ++k) {
            const auto exact =
                oracle::bicubic(oracle::component(patch, k), in_double(u), in_double(v));
            EXPECT_NEAR(in_double(p[k]), double(exact.value), this->rounding(6));
            EXPECT_NEAR(in_double(across[k]), double(exact.value), this->rounding(6));
            // Three times the difference of two values evaluated in 3 levels, then 2 levels of
            // values up to 6 * largest.
            const double tolerance = 6 * this->rounding(4) + this->rounding(2, 6 * largest);
            EXPECT_NEAR(in_double(by_u[k]), double(exact.by_u), tolerance);
            EXPECT_NEAR(in_double(by_v[k]), double(exact.by_v), tolerance);
        }
    }
}

/// A convex hull is the intersection of the half-spaces that hold all control points.
TYPED_TEST(bezier, points_lie_in_the_convex_hull_and_the_bounds) {
    for (int round = 0; round < rounds; ++round) {
        const auto patch = this->patch();
        const auto [least, most] = patch.bounds();
        for (int i = 0; i < 9; ++i) {
            const auto u = this->parameter(), v = this->parameter();
            const auto p = patch.evaluate(u, v);
            double direction[3];
            for (double& component : direction)
                component = this->random.within(-1, 1);
            const auto height = [&](const auto& q) {
                double sum = 0;
                for (int k = 0; k < 3; ++k)
                    sum += direction[k] * in_double(q[k]);
                return sum;
            };
            double highest = height(patch.points[0]);
            for (const auto& q : patch.points)
                highest = std::max(highest, height(q));
            EXPECT_LE(height(p), highest + 3 * this->rounding(6));
            for (int k = 0; k < 3; ++k) {
                EXPECT_GE(in_double(p[k]), in_double(least[k]) - this->rounding(6));
                EXPECT_LE(in_double(p[k]), in_double(most[k]) + this->rounding(6));
            }
        }
    }
}

TYPED_TEST(bezier, bounds_are_the_extremes_of_the_control_points) {
    const auto patch = this->patch();
    const auto [least, most] = patch.bounds();
    for (int k = 0; k < 3; ++k) {
        const auto by_k = [k](const auto& a, const auto& b) {
            return in_double(a[k]) < in_double(b[k]);
        };
        const auto [low, high] =
            std::minmax_element(patch.points.begin(), patch.points.end(), by_k);
        EXPECT_EQ(least[k], (*low)[k]);
        EXPECT_EQ(most[k], (*high)[k]);
    }
}

TYPED_TEST(bezier, halves_of_a_curve_are_the_same_curve) {
    using T = TypeParam;
    for (int round = 0; round < rounds; ++round) {
        const auto curve = this->curve();
        const auto [low, high] = curve.split();
        const T t = this->parameter(), half = l3d_midpoint(t, T(0));
        // Three midpoints in a row, three levels each to evaluate.
        const double tolerance = this->rounding(9);
        expect_near<T, 3>(low.evaluate(t), curve.evaluate(half), tolerance);
        expect_near<T, 3>(high.evaluate(t), curve.evaluate(half + l3d_midpoint(T(1), T(0))),
                          tolerance);
        EXPECT_EQ(low.points[0], curve.points[0]);
        EXPECT_EQ(low.points[3], high.points[0]);
        EXPECT_EQ(high.points[3], curve.points[3]);
    }
}

TYPED_TEST(bezier, halves_of_a_patch_are_the_same_patch) {
    using T = TypeParam;
    const T one_half = l3d_midpoint(T(1), T(0));
    for (int round = 0; round < rounds; ++round) {
        const auto patch = this->patch();
        const T u = this->parameter(), v = this->parameter();
        const T half_u = l3d_midpoint(u, T(0)), half_v = l3d_midpoint(v, T(0));
        const double tolerance = this->rounding(15); // 3 midpoints, 6 levels on each side
        const auto [left, right] = patch.split_u();
        expect_near<T, 3>(left.evaluate(u, v), patch.evaluate(half_u, v), tolerance);
        expect_near<T, 3>(right.evaluate(u, v), patch.evaluate(half_u + one_half, v), tolerance);
        const auto [low, high] = patch.split_v();
        expect_near<T, 3>(low.evaluate(u, v), patch.evaluate(u, half_v), tolerance);
        expect_near<T, 3>(high.evaluate(u, v), patch.evaluate(u, half_v + one_half), tolerance);
    }
}

/// Two patches that run along a common edge in opposite directions cut it into the same bits.
TYPED_TEST(bezier, halves_of_the_reversed_curve_are_the_reversed_halves_bit_for_bit) {
    using T = TypeParam;
    int rounded = 0;
    for (int round = 0; round < 2000; ++round) {
        l3d_bezier_curve<T, 3> curve;
        for (auto& p : curve.points)
            for (int k = 0; k < 3; ++k)
                p[k] = l3d_from_double<T>(this->random.within(-250, 170));
        auto [low, high] = curve.split();
        auto [reversed_high, reversed_low] = curve.reversed().split();
        // Once more, where the last bits of the operands are full.
        for (int deeper = 0; deeper < 2; ++deeper) {
            EXPECT_EQ(low.points, reversed_low.reversed().points);
            EXPECT_EQ(high.points, reversed_high.reversed().points);
            low = low.split().second;
            reversed_low = reversed_low.split().first;
            high = high.split().first;
            reversed_high = reversed_high.split().second;
        }
        const auto& p = curve.points;
        const double twice = in_double(p[0][0]) + in_double(p[1][0]);
        rounded += in_double(l3d_midpoint(p[0][0], p[1][0])) * 2 != twice;
    }
    if (!std::is_same_v<T, double>) { // whose midpoint is what `twice` is compared with
        EXPECT_GT(rounded, 200) << "the midpoints hardly ever round: the test would prove nothing";
    }
}

/// A cubic's central difference is its derivative plus h^2 times its cubic coefficient, exactly.
TYPED_TEST(bezier, derivatives_are_the_limits_of_central_differences) {
    using T = TypeParam;
    constexpr double h = 0.125;
    const T step = l3d_from_double<T>(h);
    for (int round = 0; round < rounds; ++round) {
        const auto patch = this->patch();
        const T u = this->value(h, 1 - h, 6), v = this->value(h, 1 - h, 6);
        const auto by_u = patch.derivative_u(u, v);
        const auto after = patch.evaluate(u + step, v), before = patch.evaluate(u - step, v);
        const auto along = patch.transposed().curve_at_u(v).points;
        for (int k = 0; k < 3; ++k) {
            const double difference = (in_double(after[k]) - in_double(before[k])) / (2 * h);
            const double cubic = in_double(along[3][k]) - in_double(along[0][k]) +
                                 3 * (in_double(along[1][k]) - in_double(along[2][k]));
            EXPECT_NEAR(in_double(by_u[k]), difference - h * h * cubic,
                        this->rounding(6) / h + 8 * this->rounding(4) +
                            this->rounding(2, 6 * largest));
        }
    }
}

TYPED_TEST(bezier, derivative_of_a_curve_is_the_quadratic_of_its_differences) {
    using T = TypeParam;
    const auto curve = this->curve();
    const auto slopes = curve.derivative();
    for (int k = 0; k < 3; ++k) {
        const auto b = oracle::component(curve, k);
        const double tolerance = this->rounding(2, 6 * largest);
        EXPECT_NEAR(in_double(slopes[0][k]), double(oracle::cubic(b, 0).slope), tolerance);
        EXPECT_NEAR(in_double(slopes[2][k]), double(oracle::cubic(b, 1).slope), tolerance);
        EXPECT_NEAR(
            (in_double(slopes[0][k]) + 2 * in_double(slopes[1][k]) + in_double(slopes[2][k])) / 4,
            double(oracle::cubic(b, 0.5L).slope), tolerance);
    }
    const T last = curve.reversed().derivative()[0][1];
    EXPECT_NEAR(in_double(last), -in_double(slopes[2][1]), this->rounding(2, 6 * largest));
}

/// A quarter of a circle as a rational cubic: (x, y, w) of its control points.
/// Source: the conic (1, 0, 1), sqrt(1/2) (1, 1, 1), (0, 1, 1) raised by one degree.
constexpr double quarter[4][3] = {{1, 0, 1},
                                  {0.8047378541243650, 0.4714045207910317, 0.8047378541243650},
                                  {0.4714045207910317, 0.8047378541243650, 0.8047378541243650},
                                  {0, 1, 1}};

/// The relative rounding of the constants above and of their evaluation, as of a length near 1.
template <class T> double circle_tolerance() {
    return 60 * l3d_real_traits<T>::unit_roundoff + 0x1p-52 + 30 * l3d_real_traits<T>::half_ulp;
}

template <class T> class rational_bezier : public testing::Test {};
using wide_numbers = testing::Types<float, double, l3d_fixed<std::int64_t, 32>>;
TYPED_TEST_SUITE(rational_bezier, wide_numbers);

TYPED_TEST(rational_bezier, quarter_circle_has_its_exact_radius) {
    using T = TypeParam;
    constexpr double x0 = 3.25, y0 = -1.75, radius = 2.5;
    l3d_bezier_curve<T, 3> arc;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto [x, y, w] = quarter[i];
        arc.points[i] = {l3d_from_double<T>(radius * x + x0 * w),
                         l3d_from_double<T>(radius * y + y0 * w), l3d_from_double<T>(w)};
    }
    for (int i = 0; i <= 64; ++i) {
        const auto p = l3d_projected<T, 3>(arc.evaluate(l3d_from_double<T>(i / 64.0)));
        EXPECT_NEAR(std::hypot(in_double(p[0]) - x0, in_double(p[1]) - y0), radius,
                    8 * circle_tolerance<T>());
    }
}

/// A quarter of a torus: a quarter circle turned by a quarter. Its centre is off the origin.
template <class T> l3d_bezier_patch<T, 4> torus(double centre, double small, double lift) {
    l3d_bezier_patch<T, 4> patch;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            const auto [out, up, w] = quarter[r];
            const auto [cosine, sine, turn] = quarter[c];
            const double distance = centre * w + small * out;
            patch.at(r, c) = {
                l3d_from_double<T>(distance * cosine), l3d_from_double<T>(distance * sine),
                l3d_from_double<T>((small * up + lift * w) * turn), l3d_from_double<T>(w * turn)};
        }
    return patch;
}

TYPED_TEST(rational_bezier, quarter_torus_and_its_derivatives_are_exact) {
    using T = TypeParam;
    constexpr double centre = 2.75, small = 1.25, lift = -0.5;
    const auto patch = torus<T>(centre, small, lift);
    const double tolerance = 8 * circle_tolerance<T>();
    for (int i = 0; i <= 8; ++i)
        for (int j = 0; j <= 8; ++j) {
            const T u = l3d_from_double<T>(i / 8.0), v = l3d_from_double<T>(j / 8.0);
            const auto p = l3d_projected<T, 4>(patch.evaluate(u, v));
            const double x = in_double(p[0]), y = in_double(p[1]), z = in_double(p[2]) - lift;
            const double out = std::hypot(x, y) - centre;
            EXPECT_NEAR(std::hypot(out, z), small, tolerance);
            // The surface turns about the z axis along u and about the small circle along v.
            const auto [by_u, by_v] = l3d_rational_derivatives<T, 4>(patch, u, v);
            const double turn = std::hypot(in_double(by_u[0]), in_double(by_u[1]));
            // Slowest at the ends, where it is sqrt(2) times the radius.
            EXPECT_GT(turn, 1.41 * (out + centre));
            EXPECT_NEAR(in_double(by_u[0]) * x + in_double(by_u[1]) * y, 0, 40 * tolerance);
            EXPECT_NEAR(in_double(by_u[2]), 0, 10 * tolerance);
            const double outwards =
                (in_double(by_v[0]) * x + in_double(by_v[1]) * y) / (out + centre);
            EXPECT_GT(std::hypot(outwards, in_double(by_v[2])), 1.41 * small);
            EXPECT_NEAR(outwards * out + in_double(by_v[2]) * z, 0, 40 * tolerance);
            EXPECT_NEAR(in_double(by_v[0]) * y - in_double(by_v[1]) * x, 0, 40 * tolerance);
        }
}

TEST(rational_bezier_in_double, derivatives_are_the_limits_of_central_differences) {
    const auto patch = torus<double>(2.75, 1.25, -0.5);
    constexpr double h = 1e-3;
    for (const double u : {0.125, 0.4, 0.85})
        for (const double v : {0.2, 0.55, 0.9}) {
            const auto [by_u, by_v] = l3d_rational_derivatives<double, 4>(patch, u, v);
            const auto at = [&](double du, double dv) {
                return l3d_projected<double, 4>(patch.evaluate(u + du, v + dv));
            };
            // Error h^4 / 30 of the fifth derivative, some 1e3 here.
            const auto in_u =
                ((at(h, 0) - at(-h, 0)) * 8.0 - (at(2 * h, 0) - at(-2 * h, 0))) / (12 * h);
            const auto in_v =
                ((at(0, h) - at(0, -h)) * 8.0 - (at(0, 2 * h) - at(0, -2 * h))) / (12 * h);
            expect_near<double, 3>(by_u, in_u, 1e-10);
            expect_near<double, 3>(by_v, in_v, 1e-10);
        }
}

/// With weight 1 everywhere a rational patch is the plain one.
TEST(rational_bezier_in_double, weight_one_changes_nothing) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    l3d_bezier_patch<double, 3> plain;
    l3d_bezier_patch<double, 4> rational;
    for (std::size_t i = 0; i < 16; ++i) {
        plain.points[i] = {random.within(2, 9), random.within(-4, 1), random.within(7, 8)};
        const auto& p = plain.points[i];
        rational.points[i] = {p[0], p[1], p[2], 1};
    }
    const auto [by_u, by_v] = l3d_rational_derivatives<double, 4>(rational, 0.3, 0.8);
    expect_near<double, 3>(l3d_projected<double, 4>(rational.evaluate(0.3, 0.8)),
                           plain.evaluate(0.3, 0.8), 1e-14);
    expect_near<double, 3>(by_u, plain.derivative_u(0.3, 0.8), 1e-13);
    expect_near<double, 3>(by_v, plain.derivative_v(0.3, 0.8), 1e-13);
}

TEST(bezier_conversion, keeps_the_place_of_every_control_point) {
    l3d_bezier_patch<double, 3> patch;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            patch.at(r, c) = {10 + r, 20 - c, 0.25 * r * c};
    const auto fixed = l3d_converted<l3d_fixed<std::int32_t, 16>>(patch);
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            expect_near<double, 3>(l3d_converted<double>(fixed).at(r, c), patch.at(r, c), 0);
            EXPECT_EQ(patch.row(r).points[static_cast<std::size_t>(c)], patch.at(r, c));
            EXPECT_EQ(patch.column(c).points[static_cast<std::size_t>(r)], patch.at(r, c));
        }
}

} // namespace
