// SPDX-License-Identifier: MIT
// l3d_interval: a number that is known by bounds alone.
#ifndef L3D_SCENE_PICKS_INTERVAL_H
#define L3D_SCENE_PICKS_INTERVAL_H

#include <algorithm>
#include <cmath>
#include <limits>

/// An interval: all numbers from `low` to `high`. The result of an operation holds the results for
/// all numbers of its operands. For this, the ends of results are rounded outwards by one floating
/// point number.
struct l3d_interval {
    double low = 0, high = 0;

    static l3d_interval around(double middle, double radius) {
        return outwards(middle - radius, middle + radius);
    }

    double middle() const { return low / 2 + high / 2; }
    /// The distance from middle(), which is rounded, to the farther end.
    double radius() const {
        return std::nextafter(std::max(high - middle(), middle() - low), infinite);
    }
    bool holds_zero() const { return low <= 0 && high >= 0; }

    friend l3d_interval operator+(const l3d_interval& a, const l3d_interval& b) {
        return outwards(a.low + b.low, a.high + b.high);
    }
    friend l3d_interval operator-(const l3d_interval& a, const l3d_interval& b) {
        return outwards(a.low - b.high, a.high - b.low);
    }
    friend l3d_interval operator*(const l3d_interval& a, const l3d_interval& b) {
        const auto [least, most] =
            std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
        return outwards(least, most);
    }
    /// Expects: the divisor does not hold zero.
    friend l3d_interval operator/(const l3d_interval& a, const l3d_interval& b) {
        const auto [least, most] =
            std::minmax({a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high});
        return outwards(least, most);
    }

    /// The squares of the interval's numbers: tighter than the product of the interval with itself.
    l3d_interval squared() const {
        const double a = std::abs(low), b = std::abs(high);
        const l3d_interval result =
            outwards(std::min(a, b) * std::min(a, b), std::max(a, b) * std::max(a, b));
        return {holds_zero() ? 0 : std::max(result.low, 0.0), result.high};
    }
    /// Expects: nothing below zero.
    l3d_interval root() const {
        const l3d_interval result = outwards(std::sqrt(low), std::sqrt(high));
        return {std::max(result.low, 0.0), result.high};
    }

private:
    static constexpr double infinite = std::numeric_limits<double>::infinity();

    static l3d_interval outwards(double low, double high) {
        return {std::nextafter(low, -infinite), std::nextafter(high, infinite)};
    }
};

#endif
