// SPDX-License-Identifier: MIT
// coverage: which samples of a pixel lie on one side of lines.
#ifndef L3D_RASTER_REFINE_COVERAGE_P_H
#define L3D_RASTER_REFINE_COVERAGE_P_H

#include "raster/refine/sample_pattern_p.h"
#include "raster/shapes/attribute_plane_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A bit for each sample of a pixel: word[column / 2], bit 32 (column % 2) + row.
struct coverage {
    std::array<std::uint64_t, 4> word{};

    static coverage all() {
        constexpr std::uint64_t ones = ~std::uint64_t{0};
        return {{ones, ones, ones, ones}};
    }

    bool empty() const { return (word[0] | word[1] | word[2] | word[3]) == 0; }
    bool full() const { return (word[0] & word[1] & word[2] & word[3]) == ~std::uint64_t{0}; }

    friend coverage operator&(const coverage& a, const coverage& b) {
        return {{a.word[0] & b.word[0], a.word[1] & b.word[1], a.word[2] & b.word[2],
                 a.word[3] & b.word[3]}};
    }
    friend coverage operator|(const coverage& a, const coverage& b) {
        return {{a.word[0] | b.word[0], a.word[1] | b.word[1], a.word[2] | b.word[2],
                 a.word[3] | b.word[3]}};
    }
    coverage without(const coverage& other) const {
        return {{word[0] & ~other.word[0], word[1] & ~other.word[1], word[2] & ~other.word[2],
                 word[3] & ~other.word[3]}};
    }
};

/// The line through two corners of a polygon, seen from a pixel: V = at + x of_x + y of_y at the
/// place (x, y) in 1/512 pixel. A place is inside if V >= 0.
///
/// The polygons on both sides of an edge have V and -V - 1, so each sample is inside of exactly one
/// of them. Edges longer than 64 pixels are rounded, in the same way on both sides.
struct pixel_line {
    std::int32_t at = 0, of_x = 0, of_y = 0;

    /// The pixel's corner. Units: 1/256 pixel. Expects: the inside is on the right of the way from
    /// one corner to the next, seen in the picture; |corners| <= 2^23.
    static pixel_line between(scan_point from, scan_point to, scan_point pixel);

    /// All samples of the pixel are inside.
    bool holds_all() const { return at + std::min(of_x, 0) * last + std::min(of_y, 0) * last >= 0; }
    /// None is.
    bool holds_none() const { return at + std::max(of_x, 0) * last + std::max(of_y, 0) * last < 0; }

    static constexpr std::int32_t last = sample_pattern::pixel;
};

/// A number that is linear over a pixel. Units: places in 1/512 pixel from its corner.
struct pixel_plane {
    double at = 0, of_x = 0, of_y = 0;

    friend pixel_plane operator-(const pixel_plane& a, const pixel_plane& b) {
        return {a.at - b.at, a.of_x - b.of_x, a.of_y - b.of_y};
    }
};

/// The number of samples, and the sums of their places. Units: 1/512 pixel.
struct coverage_moments {
    std::int32_t count = 0, x = 0, y = 0;
};

/// The samples inside of all lines. Expects: at most four.
coverage covered_by(const pixel_line* lines, std::size_t count);

/// The samples at which the number is greater than 0.
coverage above_zero(const pixel_plane& plane);

/// Places are those of a regular grid, which sums over many samples hardly differ from.
coverage_moments moments_of(const coverage& samples);

} // namespace l3d_detail

#endif
