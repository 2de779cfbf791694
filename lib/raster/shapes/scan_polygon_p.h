// SPDX-License-Identifier: MIT
// scan_polygon: finds the pixels of a convex polygon, a span a row, by the rule of all shapes.
#ifndef L3D_RASTER_SHAPES_SCAN_POLYGON_P_H
#define L3D_RASTER_SHAPES_SCAN_POLYGON_P_H

#include "raster/shapes/scan_edge_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// A range of rows, top <= row < bottom.
struct scan_rows {
    std::int32_t top = 0, bottom = 0;
};

/// The first column of a span, and the column after its last. The span is empty if the first number
/// is not less than the second.
using scan_ends = std::array<std::int32_t, 2>;

/// Converts convex polygons to spans. A pixel belongs to a polygon if its centre is inside, or on a
/// left or top edge.
///
/// A row is covered if its centre lies in [highest corner, lowest corner). A pixel of the row is
/// covered if its centre lies in [left edge, right edge). Both ends of the row's span are exact.
/// Lives: the spans of one polygon stay until the next convert.
class scan_polygon {
public:
    /// Sets the rows in which spans are found.
    /// Cost: allocates only when there are more rows than before.
    void set_rows(scan_rows kept) {
        kept_ = kept;
        const auto count = static_cast<std::size_t>(std::max(kept.bottom - kept.top, 0));
        if (spans_.size() < count)
            spans_.resize(count);
    }

    /// Finds the spans of a polygon, and returns its rows.
    ///
    /// Shape:   at least three corners, in order, scan_points or far_points; `clockwise` as seen on
    ///          the screen (the area with y down is positive).
    /// Expects: convex. If the polygon is not convex, some pixels are wrong, but no row is
    ///          undefined: a closed outline crosses every row downwards as often as upwards.
    template <class Point, std::size_t Extent>
    scan_rows convert(std::span<const Point, Extent> corners, bool clockwise) {
        scan_rows rows{kept_.bottom, kept_.top};
        Point from = corners.back();
        for (const Point to : corners) {
            const bool down = from.y < to.y;
            const std::size_t side = down == clockwise ? right : left;
            add_edge(down ? from : to, down ? to : from, side, rows);
            from = to;
        }
        return rows;
    }

    /// The first column of a row's span; last() is the column after the span's last. Neither is
    /// clipped, and first may be >= last.
    std::int32_t first(std::int32_t row) const { return span_of(row)[left]; }
    std::int32_t last(std::int32_t row) const { return span_of(row)[right]; }

    /// The spans of `rows`. Expects: rows that convert() returned.
    std::span<const scan_ends> ends(scan_rows rows) const {
        return {&span_of(rows.top), static_cast<std::size_t>(rows.bottom - rows.top)};
    }

private:
    static constexpr std::size_t left = 0, right = 1;

    std::size_t index(std::int32_t row) const { return static_cast<std::size_t>(row - kept_.top); }
    const scan_ends& span_of(std::int32_t row) const { return spans_[index(row)]; }

    template <class Point>
    void add_edge(Point upper, Point lower, std::size_t side, scan_rows& rows) {
        const std::int32_t top = std::max(first_centre(upper.y), kept_.top);
        const std::int32_t bottom = std::min(first_centre(lower.y), kept_.bottom);
        if (top >= bottom)
            return;
        rows.top = std::min(rows.top, top);
        rows.bottom = std::max(rows.bottom, bottom);
        auto edge = make_edge(upper, lower, top);
        for (std::int32_t row = top; row < bottom; ++row) {
            spans_[index(row)][side] = edge.column();
            edge.step();
        }
    }

    scan_rows kept_;
    std::vector<scan_ends> spans_;
};

} // namespace l3d_detail

#endif
