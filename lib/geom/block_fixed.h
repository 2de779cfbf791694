// SPDX-License-Identifier: MIT
// Block-scaled fixed point: 32-bit integers of a common size share one exponent.
#ifndef L3D_GEOM_BLOCK_FIXED_H
#define L3D_GEOM_BLOCK_FIXED_H

#include <algorithm>
#include <cmath>

/// The number of fraction bits with which 32-bit integers hold the forward differences of cubics.
/// Control values, of magnitude `largest` at most, are then below 2^29.
///
/// Differences are sums of values with binomial weights. The first difference is a sum of two
/// values, so it is below 2^30, and the second is below 2^31. The third is only used after three
/// steps or more. There, the third is at most 6 / 27 of a third difference of control values, 6 /
/// 27 * 8 * 2^29 < 2^30. Additions wrap around. So a number out of range does not spoil later
/// numbers that are in range.
/// Expects: largest >= 0, finite.
inline int l3d_block_fraction_bits(double largest) {
    constexpr int value_bits = 29;
    int exponent = 0; // largest < 2^exponent
    std::frexp(largest, &exponent);
    // 2^200 and its reciprocal are far from the ends of a double's range, also when squared.
    return std::clamp(value_bits - exponent, -200, 200);
}

/// A bound of the round-off when a cubic is walked by forward differences, in at most n steps. The
/// value and its three differences are rounded once, to `fraction_bits` bits f, and additions are
/// exact. So the bound is 2^-(f + 1) S(n), with S(n) = 1 + n + C(n, 2) + C(n, 3).
inline double l3d_block_walk_error(int fraction_bits, int n) {
    const double steps = n;
    const double pairs = steps * (steps - 1) / 2, triples = pairs * (steps - 2) / 3;
    return std::ldexp(1 + steps + pairs + triples, -(fraction_bits + 1));
}

#endif
