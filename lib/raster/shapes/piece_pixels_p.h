// SPDX-License-Identifier: MIT
// The pixels of a painter's piece: its spans, cut where planes meet, and those of its sides.
#ifndef L3D_RASTER_SHAPES_PIECE_PIXELS_P_H
#define L3D_RASTER_SHAPES_PIECE_PIXELS_P_H

#include "raster/shapes/attribute_plane_p.h"
#include "raster/lines/line_cover_p.h"
#include "raster/zsort/painter.h"
#include "raster/shapes/picture_plane.h"
#include "raster/shapes/scan_polygon_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Columns [begin, end).
struct columns {
    std::int32_t begin, end;
};

/// A cut with the planes it is between.
struct placed_cut {
    l3d_picture_plane own, other;
    bool in_front;

    bool keeps(int column, int row) const {
        return (own.at_pixel(column, row) >= other.at_pixel(column, row)) == in_front;
    }

    /// The data that are kept of a row. Both sides of a cut find the same end of it: it depends on
    /// the two planes and on where the whole triangle's row begins.
    columns kept(columns of, std::int32_t start, std::int32_t row) const {
        const double nearer = own.at_pixel(start, row) - other.at_pixel(start, row);
        const double step = (own.along_x - other.along_x) * l3d_subpixel_one;
        if (step == 0)
            return (nearer >= 0) == in_front ? of : columns{of.begin, of.begin};
        const double root = start - nearer / step;
        // The first column in front where the front is to the right, or the first behind.
        const double first = step > 0 ? std::ceil(root) : std::floor(root) + 1;
        const auto at = static_cast<std::int32_t>(
            std::clamp(first, static_cast<double>(of.begin), static_cast<double>(of.end)));
        return (step > 0) == in_front ? columns{at, of.end} : columns{of.begin, at};
    }
};

/// All cuts of a piece. Lives: the result is in `out`.
inline void place_cuts(const l3d_painter_piece& piece,
                       std::span<const l3d_painter_triangle> triangles,
                       std::span<const l3d_painter_cut> cuts, std::vector<placed_cut>& out) {
    out.clear();
    for (std::uint32_t c = piece.cut; c != l3d_painter_cut::last; c = cuts[c].next)
        out.push_back({l3d_picture_plane(triangles[piece.triangle].v),
                       l3d_picture_plane(triangles[cuts[c].splitter].v), cuts[c].in_front});
}

/// The columns that all cuts keep of a row that begins at `start`.
inline columns kept_by(std::span<const placed_cut> cuts, columns span, std::int32_t start,
                       std::int32_t row) {
    for (const placed_cut& cut : cuts) {
        if (span.begin >= span.end)
            break;
        span = cut.kept(span, start, row);
    }
    return span;
}

inline std::array<scan_point, 3> places_of(const std::array<l3d_micro_vertex, 3>& v) {
    return {{{v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}}};
}

/// Calls visit(row, start, columns) for the rows of a triangle in which cuts leave it pixels of a
/// picture of that width, until it says false. `start` is where the whole triangle's row begins.
template <class Visit>
void visit_rows(scan_polygon& scan, const std::array<l3d_micro_vertex, 3>& v,
                std::span<const placed_cut> cuts, int width, const Visit& visit) {
    const std::array<scan_point, 3> points = places_of(v);
    const std::int64_t area2 = cross(points[1] - points[0], points[2] - points[0]);
    if (area2 == 0)
        return;
    const scan_rows rows = scan.convert(std::span<const scan_point, 3>(points), area2 > 0);
    if (rows.top >= rows.bottom)
        return;
    for (std::int32_t row = rows.top; row < rows.bottom; ++row) {
        const std::int32_t start = scan.first(row);
        const columns span =
            kept_by(cuts, {std::max(start, 0), std::min(scan.last(row), width)}, start, row);
        if (span.begin < span.end && !visit(row, start, span))
            return;
    }
}

/// Calls visit(x, y, coverage, inv_w) for the pixels of those sides of a triangle that are drawn as
/// lines, as far as cuts keep them.
template <class Visit>
void visit_sides(const l3d_painter_triangle& of, std::span<const placed_cut> cuts, l3d_size size,
                 bool smooth, const Visit& visit) {
    for (std::size_t k = 0; k < of.v.size(); ++k) {
        if (!(of.sides >> k & 1))
            continue;
        const l3d_micro_vertex &a = of.v[k], &b = of.v[(k + 1) % 3];
        const double from = a.inv_w, change = double{b.inv_w} - from;
        visit_side(a, b, size, smooth, [&](int x, int y, double along, int coverage) {
            if (std::ranges::all_of(cuts, [&](const placed_cut& cut) { return cut.keeps(x, y); }))
                visit(x, y, coverage, from + along * change);
        });
    }
}

} // namespace l3d_detail

#endif
