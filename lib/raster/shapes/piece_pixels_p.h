// SPDX-License-Identifier: MIT
// The pixels of a painter's piece: its spans, cut where planes meet, and those of its sides.
#ifndef L3D_RASTER_SHAPES_PIECE_PIXELS_P_H
#define L3D_RASTER_SHAPES_PIECE_PIXELS_P_H

#include "raster/shapes/attribute_plane_p.h"
#include "raster/lines/line_cover_p.h"
#include "raster/zsort/painter.h"
#include "raster/shapes/plane_cut_p.h"
#include "raster/shapes/scan_polygon_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Adds the cuts of a piece to `out`. Each cut gets the plane of the cut triangle and the plane of
/// the triangle that cuts.
inline void add_cuts(const l3d_painter_piece& piece,
                     std::span<const l3d_painter_triangle> triangles,
                     std::span<const l3d_painter_cut> cuts, std::vector<plane_cut>& out) {
    for (std::uint32_t c = piece.cut; c != l3d_painter_cut::last; c = cuts[c].next)
        out.push_back({l3d_picture_plane(triangles[piece.triangle].v),
                       l3d_picture_plane(triangles[cuts[c].splitter].v), cuts[c].in_front});
}

inline std::array<scan_point, 3> places_of(const std::array<l3d_micro_vertex, 3>& v) {
    return {{{v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}}};
}

/// Calls visit(row, start, columns) for the rows of a triangle, clipped to a picture's width and to
/// cuts. Rows without columns are left out. The walk ends if visit returns false. `start` is the
/// uncut triangle's first column in the row; it may be left of the picture.
template <class Visit>
void visit_rows(scan_polygon& scan, const std::array<l3d_micro_vertex, 3>& v,
                std::span<const plane_cut> cuts, int width, const Visit& visit) {
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

/// Calls visit(x, y, coverage, inv_w) for pixels on the sides of a triangle. Only sides that are
/// drawn as lines count, and only pixels that all cuts keep.
template <class Visit>
void visit_sides(const l3d_painter_triangle& of, std::span<const plane_cut> cuts, l3d_size size,
                 bool smooth, const Visit& visit) {
    for (std::size_t k = 0; k < of.v.size(); ++k) {
        if (!(of.sides >> k & 1))
            continue;
        const l3d_micro_vertex &a = of.v[k], &b = of.v[(k + 1) % 3];
        const double from = a.inv_w, change = double{b.inv_w} - from;
        visit_side(a, b, size, smooth, [&](int x, int y, double along, int coverage) {
            if (std::ranges::all_of(cuts, [&](const plane_cut& cut) { return cut.keeps(x, y); }))
                visit(x, y, coverage, from + along * change);
        });
    }
}

} // namespace l3d_detail

#endif
