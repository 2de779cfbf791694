// SPDX-License-Identifier: MIT
// l3d_forward_difference: a polynomial held as forward differences and walked by additions, with
// equal or adaptive steps, in whole numbers too.
#ifndef L3D_GEOM_FORWARD_DIFFERENCE_H
#define L3D_GEOM_FORWARD_DIFFERENCE_H

#include "base/public.h"
#include "geom/real.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <utility>

/// A polynomial of one variable, for walks along it by additions alone. It is held as its value and
/// its forward differences for a step h.
///
/// Shape:   d[0] is the value at the current parameter, d[k] the k-th forward difference there.
/// Units:   those of the control values. The parameter runs from 0 to 1, so h is 1 / steps.
/// Cost:    `Degree` additions a step, no multiplication.
/// Source:  Newton's forward differences. step, halve and double_step are the operators E, L and
///          the inverse of L in Lien, Shantz, Pratt, Adaptive Forward Differencing for Rendering
///          Curves and Surfaces, SIGGRAPH 1987. The operators are derived again here from f(t + h),
///          f(t + h/2), f(t + 2h).
template <class T, int Degree> struct l3d_forward_difference {
    static_assert(Degree == 3, "halve and double are written for cubics");
    std::array<T, Degree + 1> d; ///< the value, then the differences of orders 1 to Degree

    /// Prepares a walk in `steps` steps from t = 0, for a polynomial with Bernstein coefficients b.
    ///
    /// Let c1, c2, c3 be the power coefficients divided by n, n^2, n^3, where n is the number of
    /// steps. The first difference is f(h) - f(0) = c1 + c2 + c3, the second 2 c2 + 6 c3, and the
    /// third 6 c3. The differences are computed in double, and each is rounded to T once.
    /// Expects: steps >= 1.
    static l3d_forward_difference build(const std::array<double, 4>& b, int steps) {
        assert(steps >= 1);
        const double n = steps;
        const double first = b[1] - b[0], second = b[2] - b[1], third = b[3] - b[2];
        const double bend = second - first;
        const double twist = (third - second) - bend;
        const double c1 = 3 * first / n;
        const double c2 = 3 * bend / n / n;
        const double c3 = twist / n / n / n;
        const double d2 = 6 * bend / n / n;
        const double d3 = 6 * twist / n / n / n;
        return {{l3d_from_double<T>(b[0]), l3d_from_double<T>(c1 + c2 + c3),
                 l3d_from_double<T>(d2 + d3), l3d_from_double<T>(d3)}};
    }

    /// The value at the current parameter.
    T value() const { return d[0]; }

    /// Goes on by one step.
    void step() {
        d[0] = d[0] + d[1];
        d[1] = d[1] + d[2];
        d[2] = d[2] + d[3];
    }

    /// Halves the step. The difference operator D' of the new step follows from the operator D of
    /// the old step: 1 + D' = (1 + D)^(1/2). Powers above D^3 vanish, so
    ///     D' = D/2 - D^2/8 + D^3/16,  D'^2 = D^2/4 - D^3/8,  D'^3 = D^3/8.
    /// Expects: every difference is in range. (step() alone needs less: additions are exact modulo
    ///          2^bits, so only the values that are used must be in range.)
    void halve() {
        const T half_third = halved(d[3]);
        d[2] = halved(halved(d[2] - half_third));
        d[3] = halved(halved(half_third));
        d[1] = halved(d[1] - d[2]);
    }

    /// Doubles the step, and so undoes halve(). The new first difference is D' = 2 D + D^2. Its
    /// square and cube give the other two differences; powers above D^3 vanish.
    void double_step() {
        d[1] = d[1] + d[1] + d[2];
        d[3] = twice(twice(twice(d[3])));
        d[2] = twice(twice(d[2])) + halved(d[3]);
    }

private:
    static T halved(T value) { return l3d_midpoint(value, T(0)); }
    static T twice(T value) { return value + value; }
};

/// A bound of the error of a cubic after at most n steps by forward differences. Units: those of
/// the control values.
///
/// The control values are at most p in magnitude; their first, second and third differences are at
/// most b1, b2, b3. Then the forward differences are at most D3 = 6 b3 / n^3, D2 = 6 b2 / n^2 + D3
/// and D1 = 3 b1 / n + 2 D2. An initial error of the k-th difference counts C(n, k) times in the
/// value. Floating point adds u |difference| at each of the n, C(n, 2), C(n, 3) additions that
/// follow. Fixed point additions are exact, and every initial error is half an ulp.
/// Source: running error analysis (Wilkinson, Rounding Errors in Algebraic Processes, 1963).
template <class T>
double l3d_forward_difference_error(int n, double p, double b1, double b2, double b3) {
    const double u = l3d_real_traits<T>::unit_roundoff;
    const double half_ulp = l3d_real_traits<T>::half_ulp;
    const double steps = n;
    const double pairs = steps * (steps - 1) / 2;
    const double triples = pairs * (steps - 2) / 3;
    const double d3 = 6 * b3 / (steps * steps * steps);
    const double d2 = 6 * b2 / (steps * steps) + d3;
    const double d1 = 3 * b1 / steps + 2 * d2;
    const double initial = p + steps * d1 + pairs * d2 + triples * d3;
    const double adding = steps * p + pairs * d1 + triples * d2;
    // Differences of control values cancel: their rounding is relative to p. In units of u p, the
    // three differences err by at most 2, 8, 24. So c1, c2, c3 err by 18/n, 60/n^2, 48/n^3, and
    // their sum by 12/n + 24/n^2 + 8/n^3 more. d2 and d3 err by 120/n^2 and 336/n^3, their sum by
    // 24/n^2 + 48/n^3 more. These errors, times n, C(n, 2), C(n, 3), are largest for n = 1, where
    // they are 170.
    const double cancelling = 170 * l3d_real_traits<double>::unit_roundoff * p;
    return u * (initial + adding) + cancelling + half_ulp * (1 + steps + pairs + triples);
}

/// Counts the work of an adaptive walk along a curve, for programs that show these numbers.
struct l3d_step_counts {
    std::int64_t steps = 0;     ///< steps taken, each of three additions a coordinate
    std::int64_t halvings = 0;  ///< halvings of the step
    std::int64_t doublings = 0; ///< doublings of the step
};

/// Walks along a curve to its end. The walk halves a step that would move a coordinate by more than
/// a pixel. It doubles the step where the next step would move every coordinate by at most half a
/// pixel, if steps of twice the length still end at the curve's end.
///
/// The walk is exact if T is fixed point with g + 3 finest fraction bits, and control values are
/// multiples of 2^-g.
/// Shape:   `curve` has one polynomial for each coordinate, at its beginning, with a step of
///          2^-first. The function calls visit(at, level, curve) at the beginning and after each
///          step. The parameter is then at / 2^finest, and the step is 2^-level.
/// Units:   `pixel` is the size of a pixel in the units of the coordinates.
/// Expects: 0 <= first <= finest <= 30; all differences in range. Steps of 2^-finest may be longer
///          than a pixel.
/// Source:  Lien, Shantz, Pratt, Adaptive Forward Differencing for Rendering Curves and Surfaces,
///          SIGGRAPH 1987.
template <class T, std::size_t Coordinates, class Visit>
l3d_step_counts l3d_walk_adaptively(std::array<l3d_forward_difference<T, 3>, Coordinates> curve,
                                    int first, int finest, T pixel, const Visit& visit) {
    assert(0 <= first && first <= finest && finest <= 30);
    const auto moves_more_than = [&](T length) {
        for (const auto& of : curve)
            if (of.d[1] > length || of.d[1] < -length)
                return true;
        return false;
    };
    const T half = l3d_midpoint(pixel, T(0));
    const std::int64_t end = std::int64_t{1} << finest;
    int level = first;
    l3d_step_counts counts;
    visit(std::int64_t{0}, level, curve);
    for (std::int64_t at = 0; at < end;) {
        for (; level < finest && moves_more_than(pixel); ++level, ++counts.halvings)
            for (auto& of : curve)
                of.halve();
        for (auto& of : curve)
            of.step();
        at += end >> level;
        ++counts.steps;
        visit(at, level, curve);
        if (level > 0 && at < end && at % (2 * (end >> level)) == 0 && !moves_more_than(half)) {
            for (auto& of : curve)
                of.double_step();
            --level;
            ++counts.doublings;
        }
    }
    return counts;
}

/// A cubic Bezier polynomial with whole control values, for walks without rounding. A split or a
/// walk that doubles the number of steps also multiplies the values by 8. So every difference is a
/// whole number. The level counts these doublings.
///
/// Units:   the true values are the stored ones divided by 8^level.
/// Expects: control values of at most 2^24 in magnitude at level 0, and levels up to most_level.
/// Source:  Klassen: Exact Integer Hybrid Subdivision and Forward Differencing of Cubics, ACM
///          Transactions on Graphics 13 (1994). The caller chooses where to split.
class L3D_PUBLIC l3d_integer_cubic {
public:
    /// The largest level. Values have 24 + 3 * 12 = 60 bits at this level, and differences have no
    /// more.
    static constexpr int most_level = 12;

    /// A cubic by its control values, at level 0.
    explicit l3d_integer_cubic(const std::array<std::int64_t, 4>& control) : control_(control) {}

    /// The number of times that values were multiplied by 8.
    int level() const { return level_; }

    /// Both halves of the cubic, each with a level that is larger by 1.
    std::pair<l3d_integer_cubic, l3d_integer_cubic> split() const {
        assert(level_ < most_level);
        const auto& [a, b, c, d] = control_;
        const std::int64_t first = 4 * (a + b), last = 4 * (c + d);
        const std::int64_t left = 2 * (a + 2 * b + c), right = 2 * (b + 2 * c + d);
        const std::int64_t middle = a + 3 * (b + c) + d;
        return {l3d_integer_cubic({8 * a, first, left, middle}, level_ + 1),
                l3d_integer_cubic({middle, right, last, 8 * d}, level_ + 1)};
    }

    /// Calls visit(value) for 2^doublings + 1 values along the cubic, both ends included. Each
    /// value is the true one times 8^(level() + doublings), and takes three additions from the
    /// value before.
    template <class Visitor> void walk(int doublings, const Visitor& visit) const {
        assert(doublings >= 0 && level_ + doublings <= most_level);
        const auto& [a, b, c, d] = control_;
        // With steps of h = 1 / n, the powers of the parameter weigh n^3, n^2, n and 1 of 8^level.
        const std::int64_t n = std::int64_t{1} << doublings;
        const std::int64_t first = 3 * (b - a) * n * n, second = 3 * (a - 2 * b + c) * n;
        const std::int64_t third = d - a + 3 * (b - c);
        std::int64_t value = a * n * n * n, by = first + second + third;
        std::int64_t grows = 2 * second + 6 * third;
        const std::int64_t always = 6 * third;
        visit(value);
        for (std::int64_t i = 0; i < n; ++i) {
            value += by;
            by += grows;
            grows += always;
            visit(value);
        }
    }

    /// Calls visit for the same values as walk(halvings + doublings), but halves the cubic
    /// `halvings` times first and walks each piece. The ends where pieces meet are visited once.
    template <class Visitor>
    void walk_halved(int halvings, int doublings, const Visitor& visit) const {
        bool is_first = true;
        walk_pieces(halvings, doublings, is_first, visit);
    }

private:
    l3d_integer_cubic(const std::array<std::int64_t, 4>& control, int level)
        : control_(control), level_(level) {}

    template <class Visitor>
    void walk_pieces(int halvings, int doublings, bool& is_first, const Visitor& visit) const {
        if (halvings > 0) {
            const auto [left, right] = split();
            left.walk_pieces(halvings - 1, doublings, is_first, visit);
            right.walk_pieces(halvings - 1, doublings, is_first, visit);
            return;
        }
        bool is_shared = !is_first;
        is_first = false;
        walk(doublings, [&](std::int64_t value) {
            if (!is_shared)
                visit(value);
            is_shared = false;
        });
    }

    std::array<std::int64_t, 4> control_;
    int level_ = 0;
};

#endif
