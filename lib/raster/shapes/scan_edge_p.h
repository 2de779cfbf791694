// SPDX-License-Identifier: MIT
// scan_edge: the exact crossings of a polygon's edge with the rows of pixel centres.
#ifndef L3D_RASTER_SHAPES_SCAN_EDGE_P_H
#define L3D_RASTER_SHAPES_SCAN_EDGE_P_H

#include "raster/pixel_centres.h"
#include "raster/shapes/exact_steps_p.h"
#include "raster/surface_part.h"

#include <cassert>
#include <cstdint>

namespace l3d_detail {

/// A corner of a polygon near the picture. Units: 1/256 pixel, |x|, |y| <= scan_limit.
struct scan_point {
    std::int32_t x = 0, y = 0;
};

inline constexpr std::int32_t scan_limit = 1 << 23;

/// A corner of a polygon near the picture or far from it. Units: 1/256 pixel, |x|, |y| <=
/// far_limit: 2^30 pixels.
struct far_point {
    std::int64_t x = 0, y = 0;
};

inline constexpr std::int64_t far_limit = std::int64_t{1} << 38;

/// An edge from its upper to its lower end, stepped from one row of pixel centres to the next.
///
/// In each row it gives the first column whose centre is on the edge or right of it. This column
/// depends only on the two end points, so two polygons that share the edge divide the row without
/// gap and without overlap.
/// Expects: upper.y < lower.y. The row's centre lies between the edge's ends; for line() alone, any
///          row in the picture will do.
/// Cost:    one division for each edge; one addition and one product for each row.
///
/// The column is exact, though computed in double. With D = 256 dy it is ceil(n / D) = floor(m /
/// 2D) for whole n and odd m = 2n + 2D - 1. Every m is below 2^51, and so exact. m / 2D + 2^16 is
/// below 2^17, so two roundings to 2^-53 change it by less than 2^-35. And m / 2D is at least 1 /
/// 2D >= 2^-33 away from any whole number.
class scan_edge {
public:
    scan_edge(scan_point upper, scan_point lower, std::int32_t row) {
        const std::int64_t dx = std::int64_t{lower.x} - upper.x;
        const std::int64_t dy = std::int64_t{lower.y} - upper.y;
        assert(dy > 0);
        const std::int64_t down = pixel * row + half_pixel - upper.y;
        const std::int64_t twice_d = 2 * pixel * dy;
        const std::int64_t n = (upper.x - half_pixel) * dy + dx * down;
        m_ = static_cast<double>(2 * n + twice_d - 1 + offset * twice_d);
        m_per_row_ = static_cast<double>(2 * pixel * dx);
        inverse_ = 1.0 / static_cast<double>(twice_d);
    }

    std::int32_t column() const { return static_cast<std::int32_t>(m_ * inverse_) - offset; }

    void step() { m_ += m_per_row_; }

    /// An offset that makes columns positive, so that truncation rounds down. Columns begin at
    /// -2^15.
    static constexpr std::int32_t offset = 1 << 16;

private:
    static constexpr std::int64_t pixel = l3d_subpixel_one, half_pixel = pixel / 2;

    double m_, m_per_row_, inverse_;
};

/// The columns of a scan_edge for corners at any distance, and the edge's distance from the
/// samples.
///
/// With D = 256 dy <= 2^47 the column is ceil(n / D) = floor((n + D - 1) / D); n is below 2^79.
/// Expects: as scan_edge.
/// Cost:    two divisions for each edge; three additions and a comparison for each row.
class exact_edge {
public:
    exact_edge(far_point upper, far_point lower, std::int32_t row)
        : steps_(first_numerator(upper, lower, row),
                 wide_integer{l3d_subpixel_one} * (lower.x - upper.x), denominator(upper, lower)) {
        assert(upper.y < lower.y);
    }

    std::int32_t column() const { return static_cast<std::int32_t>(steps_.floor()); }

    /// The distance from the edge to the sample on its right.
    /// Units: pixels, in [0, 1).
    double beyond() const {
        return static_cast<double>(steps_.denominator() - 1 - steps_.rest()) /
               static_cast<double>(steps_.denominator());
    }

    /// The distance from the sample on the edge's left to the edge: 1 - beyond(), without loss of
    /// digits.
    double short_of() const {
        return static_cast<double>(steps_.rest() + 1) / static_cast<double>(steps_.denominator());
    }

    void step() { steps_.step(); }

private:
    static std::int64_t denominator(far_point upper, far_point lower) {
        return l3d_subpixel_one * (lower.y - upper.y);
    }
    static wide_integer first_numerator(far_point upper, far_point lower, std::int32_t row) {
        constexpr std::int64_t half_pixel = l3d_subpixel_one / 2;
        const std::int64_t down = std::int64_t{l3d_subpixel_one} * row + half_pixel - upper.y;
        return wide_integer{upper.x - half_pixel} * (lower.y - upper.y) +
               wide_integer{lower.x - upper.x} * down + denominator(upper, lower) - 1;
    }

    exact_steps steps_;
};

inline scan_edge make_edge(scan_point upper, scan_point lower, std::int32_t row) {
    return {upper, lower, row};
}
inline exact_edge make_edge(far_point upper, far_point lower, std::int32_t row) {
    return {upper, lower, row};
}

} // namespace l3d_detail

#endif
