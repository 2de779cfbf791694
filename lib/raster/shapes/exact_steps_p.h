// SPDX-License-Identifier: MIT
// exact_steps: steps a quotient without rounding. Lines and edges of polygons are built on it.
#ifndef L3D_RASTER_SHAPES_EXACT_STEPS_P_H
#define L3D_RASTER_SHAPES_EXACT_STEPS_P_H

#include <algorithm>
#include <cassert>
#include <cstdint>

namespace l3d_detail {

/// An integer that holds the product of two differences of coordinates. Each difference is up to
/// 2^39 units of 1/256 pixel.
__extension__ typedef __int128 wide_integer;

/// The quotient n / d, rounded down. Expects: d > 0.
constexpr wide_integer floor_quotient(wide_integer n, wide_integer d) {
    return n / d - (n % d < 0 ? 1 : 0);
}
constexpr wide_integer ceil_quotient(wide_integer n, wide_integer d) {
    return n / d + (n % d > 0 ? 1 : 0);
}

/// A range of whole numbers, first <= i <= last; empty if first > last.
struct whole_range {
    wide_integer first, last;
};

/// The numbers i of a range for which low <= slope i <= high.
constexpr whole_range where_within(whole_range among, wide_integer slope, wide_integer low,
                                   wide_integer high) {
    if (slope == 0)
        return low <= 0 && 0 <= high ? among : whole_range{0, -1};
    if (slope < 0)
        return where_within(among, -slope, -high, -low);
    return {std::max(among.first, ceil_quotient(low, slope)),
            std::min(among.last, floor_quotient(high, slope))};
}

/// Steps through the numbers (n + i s) / d for i = 0, 1, 2..., and gives the floor and the
/// remainder of each number.
///
/// Expects: 0 < d < 2^62; every floor that is asked for fits 62 bits.
/// Cost:    two divisions to set up, three additions and a comparison for each step.
class exact_steps {
public:
    exact_steps(wide_integer n, wide_integer s, std::int64_t d)
        : floor_(static_cast<std::int64_t>(floor_quotient(n, d))),
          rest_(static_cast<std::int64_t>(n - wide_integer{floor_} * d)),
          floor_step_(static_cast<std::int64_t>(floor_quotient(s, d))),
          rest_step_(static_cast<std::int64_t>(s - wide_integer{floor_step_} * d)),
          denominator_(d) {
        assert(d > 0 && d < std::int64_t{1} << 62);
    }

    std::int64_t floor() const { return floor_; }
    /// The remainder: the present number is floor() + rest() / denominator().
    std::int64_t rest() const { return rest_; }
    std::int64_t denominator() const { return denominator_; }

    void step() {
        floor_ += floor_step_;
        rest_ += rest_step_;
        const bool carry = rest_ >= denominator_;
        floor_ += carry;
        rest_ -= carry ? denominator_ : 0;
    }

private:
    std::int64_t floor_, rest_, floor_step_, rest_step_, denominator_;
};

} // namespace l3d_detail

#endif
