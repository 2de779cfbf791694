// SPDX-License-Identifier: MIT
// l3d_forward_difference: a polynomial held as forward differences and walked by additions.
#ifndef L3D_GEOM_FORWARD_DIFFERENCE_H
#define L3D_GEOM_FORWARD_DIFFERENCE_H

#include "geom/real.h"

#include <array>
#include <cassert>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

template <std::floating_point T> constexpr T divided(T value, int divisor) {
    return value / static_cast<T>(divisor);
}

/// One narrow division: dividing by l3d_fixed(divisor) would take a wide one.
template <class S, int F, l3d_overflow O>
constexpr l3d_fixed<S, F, O> divided(l3d_fixed<S, F, O> value, int divisor) {
    return l3d_fixed<S, F, O>::from_raw(
        static_cast<S>(divided_to_nearest(std::int64_t{value.raw()}, std::int64_t{divisor})));
}

} // namespace l3d_detail

/// A polynomial of one variable as its value and its forward differences at a step h.
///
/// Shape:   d[k] is the k-th forward difference at the current parameter; d[0] the value.
/// Units:   those of the control values; the step is 1 / steps of the parameter.
/// Cost:    `Degree` additions a step, no multiplication.
/// Source:  Newton's forward differences; step, halve and double as the operators E, L and its
///          inverse of Lien, Shantz, Pratt, Adaptive Forward Differencing for Rendering Curves
///          and Surfaces, SIGGRAPH 1987, here derived again from f(t + h), f(t + h/2), f(t + 2h).
template <class T, int Degree> struct l3d_forward_difference {
    static_assert(Degree == 3, "halve and double are written for cubics");
    std::array<T, Degree + 1> d;

    /// The polynomial with Bernstein coefficients b, at t = 0, to be walked in `steps` steps.
    ///
    /// With c1, c2, c3 the power coefficients divided by n, n^2, n^3:
    ///   f(h) - f(0) = c1 + c2 + c3;  second difference 2 c2 + 6 c3;  third 6 c3.
    /// Expects: steps >= 1. Wide arithmetic throughout, one rounding to T per register.
    template <class Wide>
    static l3d_forward_difference build(const std::array<Wide, 4>& b, int steps) {
        assert(steps >= 1);
        const auto over_n = [steps](Wide value) { return l3d_detail::divided(value, steps); };
        const Wide first = b[1] - b[0], second = b[2] - b[1], third = b[3] - b[2];
        const Wide bend = second - first;
        const Wide twist = (third - second) - bend;
        const Wide c1 = over_n(thrice(first));
        const Wide c2 = over_n(over_n(thrice(bend)));
        const Wide c3 = over_n(over_n(over_n(twist)));
        const Wide d2 = over_n(over_n(thrice(bend + bend)));
        const Wide d3 = over_n(over_n(over_n(thrice(twist + twist))));
        using traits = l3d_real_traits<T>;
        return {{traits::from_wide(b[0]), traits::from_wide(c1 + c2 + c3),
                 traits::from_wide(d2 + d3), traits::from_wide(d3)}};
    }

    T value() const { return d[0]; }

    /// Goes on by one step.
    void step() {
        d[0] = d[0] + d[1];
        d[1] = d[1] + d[2];
        d[2] = d[2] + d[3];
    }

    /// Halves the step. With the binomial operator E^(1/2) = (1 + D)^(1/2):
    ///   D' = D/2 - D^2/8 + D^3/16,  D'^2 = D^2/4 - D^3/8,  D'^3 = D^3/8.
    /// Expects: every register in range. (Steps are linear modulo 2^bits: for them only the values
    /// that are used must fit.)
    void halve() {
        const T half_third = halved(d[3]);
        d[2] = halved(halved(d[2] - half_third));
        d[3] = halved(halved(half_third));
        d[1] = halved(d[1] - d[2]);
    }

    /// Doubles the step, the inverse of halve: D' = 2 D + D^2, squared and cubed.
    void double_step() {
        d[1] = d[1] + d[1] + d[2];
        d[3] = twice(twice(twice(d[3])));
        d[2] = twice(twice(d[2])) + halved(d[3]);
    }

private:
    static T halved(T value) { return l3d_midpoint(value, T(0)); }
    static T twice(T value) { return value + value; }
    template <class Wide> static Wide thrice(Wide value) { return value + value + value; }
};

/// A bound on the error of a cubic after at most n forward difference steps, in the control
/// values' units.
///
/// With |b| <= p, first, second and third differences of b at most b1, b2, b3, the registers
/// are at most D3 = 6 b3 / n^3, D2 = 6 b2 / n^2 + D3, D1 = 3 b1 / n + 2 D2. A register's
/// initial error e_k reaches the value C(n, k) fold. Floating point adds u |register| at each
/// of the n, C(n, 2), C(n, 3) additions that follow; fixed point additions are exact and the
/// initial errors are a few half ulps: dividing once, twice or three times by n >= 2 is off by at
/// most 1, 1 + 1/2, 1 + 1/2 + 1/4 half ulps, so that d1 = c1 + c2 + c3 is off by 4.25, d2 by
/// 1.5 + 1.75 = 3.25 and d3 by 1.75.
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
    // Differences of control values cancel: their rounding is relative to p. In units of u p the
    // three differences are off by at most 2, 8, 24; so c1, c2, c3 by 18/n, 60/n^2, 48/n^3, their
    // sum by 12/n + 24/n^2 + 8/n^3 more, d2 and d3 by 120/n^2 and 336/n^3, their sum by 24/n^2 +
    // 48/n^3 more. Times n, C(n, 2), C(n, 3) that is most for n = 1, where it is 170.
    const double u_wide = l3d_real_traits<typename l3d_real_traits<T>::wide>::unit_roundoff;
    const double cancelling = 170 * u_wide * p;
    return u * (initial + adding) + cancelling +
           half_ulp * (1 + 4.25 * steps + 3.25 * pairs + 1.75 * triples);
}

#endif
