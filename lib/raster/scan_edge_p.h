// SPDX-License-Identifier: MIT
// scan_edge: where a polygon's edge crosses the rows of pixel centres, exactly.
#ifndef L3D_RASTER_SCAN_EDGE_P_H
#define L3D_RASTER_SCAN_EDGE_P_H

#include "raster/micro_grid.h"

#include <cassert>
#include <cmath>
#include <cstdint>

namespace l3d_detail {

/// A corner of a polygon. Units: 1/256 pixel, |x|, |y| <= scan_limit.
struct scan_point {
    std::int32_t x = 0, y = 0;
};

/// A numerator below is then at most (2^29 + 2^7) 2^30 + 2^30 2^30 < 2^61, inside 64 bits.
inline constexpr std::int32_t scan_limit = 1 << 29;

/// Index of the first pixel whose centre is not before a position: ceil((position - 128) / 256).
constexpr std::int32_t first_centre(std::int32_t position) {
    return (position + l3d_subpixel_one / 2 - 1) >> l3d_subpixel_bits;
}

/// Walks an edge from its upper to its lower end, one row of pixel centres per step.
///
/// On each row it gives the first column whose centre is on the edge or right of it. That number
/// depends on the two end points only, so two polygons that share the edge divide the row between
/// them without gap and without overlap.
/// Expects: upper.y < lower.y, and row's centre on the edge.
/// Cost:    one (floating-point) division for each edge; additions and a carry for each row.
/// Source:  integer digital differential analyser: quotient and remainder, both exact.
class scan_edge {
public:
    scan_edge(scan_point upper, scan_point lower, std::int32_t row) {
        const std::int64_t dx = std::int64_t{lower.x} - upper.x;
        const std::int64_t dy = std::int64_t{lower.y} - upper.y;
        assert(dy > 0);
        const std::int64_t down = l3d_subpixel_one * std::int64_t{row} + half_pixel - upper.y;
        const double inverse = 1.0 / static_cast<double>(dy);

        // column = ceil(n / d) = floor((n + d - 1) / d)
        denominator_ = l3d_subpixel_one * dy;
        const quotient start =
            floor_quotient((upper.x - half_pixel) * dy + dx * down + denominator_ - 1, denominator_,
                           inverse / l3d_subpixel_one);
        column_ = start.whole;
        rest_ = start.rest;

        // One row further n grows by 256 dx: by the same quotient as dx / dy, the rest 256 fold.
        const quotient step = floor_quotient(dx, dy, inverse);
        column_step_ = step.whole;
        rest_step_ = l3d_subpixel_one * step.rest;
    }

    std::int32_t column() const { return static_cast<std::int32_t>(column_); }

    void step() {
        column_ += column_step_;
        rest_ += rest_step_ - denominator_;
        const std::int64_t no_carry = rest_ >> 63;
        column_ += 1 + no_carry;
        rest_ += no_carry & denominator_;
    }

private:
    static constexpr std::int64_t half_pixel = l3d_subpixel_one / 2;

    struct quotient {
        std::int64_t whole, rest;
    };

    /// floor(n / d) and the rest in [0, d), exactly.
    ///
    /// |n / d| <= 2^30, so the double quotient is wrong by less than 2^30 * 2^-51 = 2^-21 and its
    /// nearest integer is the floor or one more; the integer rest tells which.
    static quotient floor_quotient(std::int64_t n, std::int64_t d, double inverse) {
        std::int64_t whole = std::lrint(static_cast<double>(n) * inverse);
        std::int64_t rest = n - whole * d;
        const std::int64_t too_far = rest >> 63;
        whole += too_far;
        rest += too_far & d;
        return {whole, rest};
    }

    std::int64_t column_, column_step_;
    std::int64_t rest_, rest_step_;
    std::int64_t denominator_;
};

} // namespace l3d_detail

#endif
