// SPDX-License-Identifier: MIT
// plane_cut: the pixels of a triangle in which its plane is in front of another one, or behind it.
#ifndef L3D_RASTER_SHAPES_PLANE_CUT_P_H
#define L3D_RASTER_SHAPES_PLANE_CUT_P_H

#include "raster/surface_part.h"
#include "raster/shapes/picture_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// A range of columns [begin, end).
struct columns {
    std::int32_t begin, end;
};

/// A cut of a triangle along the line where its plane meets another triangle's plane. The cut keeps
/// the part of the triangle in front of the other plane, or the part behind.
struct plane_cut {
    l3d_picture_plane own, other;
    bool in_front;

    bool keeps(int column, int row) const {
        return (own.at_pixel(column, row) >= other.at_pixel(column, row)) == in_front;
    }

    /// The columns of `of`, in this row, that the cut keeps. `start` is the uncut triangle's first
    /// column in the row; it may be left of the picture. Both pieces of a triangle end at the same
    /// column, as this depends only on both planes and on `start`.
    columns kept(columns of, std::int32_t start, std::int32_t row) const {
        const double nearer = own.at_pixel(start, row) - other.at_pixel(start, row);
        const double step = (own.along_x - other.along_x) * l3d_subpixel_one;
        if (step == 0)
            return (nearer >= 0) == in_front ? of : columns{of.begin, of.begin};
        const double root = start - nearer / step;
        // The first column in front, if the front is to the right; else the first column behind.
        const double first = step > 0 ? std::ceil(root) : std::floor(root) + 1;
        const auto at = static_cast<std::int32_t>(
            std::clamp(first, static_cast<double>(of.begin), static_cast<double>(of.end)));
        return (step > 0) == in_front ? columns{at, of.end} : columns{of.begin, at};
    }
};

/// The columns of `span`, in this row, that all cuts keep. `start` is the uncut triangle's first
/// column in the row; it may be left of the picture.
inline columns kept_by(std::span<const plane_cut> cuts, columns span, std::int32_t start,
                       std::int32_t row) {
    for (const plane_cut& cut : cuts) {
        if (span.begin >= span.end)
            break;
        span = cut.kept(span, start, row);
    }
    return span;
}

/// A triangle of which cuts keep a part.
struct cut_triangle {
    std::array<l3d_micro_vertex, 3> v;
    std::uint32_t material = 0; ///< the triangle's material, as in l3d_surface_part
    /// The triangle's cuts, as a range of indices in a list of cuts.
    std::size_t first_cut = 0, behind_cut = 0;
};

} // namespace l3d_detail

#endif
