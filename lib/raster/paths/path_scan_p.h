// SPDX-License-Identifier: MIT
// path_scan: how much of each pixel a path covers, row by row, where its edges are.
#ifndef L3D_RASTER_PATHS_PATH_SCAN_P_H
#define L3D_RASTER_PATHS_PATH_SCAN_P_H

#include "raster/paths/convex_rows_p.h"
#include "raster/paths/path.h"
#include "raster/paths/row_pieces_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Columns first <= column < last of a row, and how much of each is covered.
struct covered_span {
    std::int32_t row, first, last;
    std::int32_t value; ///< of all columns; -1: values_of has one for each
    std::size_t values; ///< where they begin
};

/// Turns paths into spans, exactly but for the distance of chords from curves and for rounding.
///
/// Pieces of edges in one row whose columns meet form a cluster. Outlines are closed, and pieces
/// that follow each other meet. So windings do not change down the row between two clusters, and
/// what lies there is covered all or not at all. Most clusters are one chain of edges from the
/// row's top to its bottom. The others go to row_areas::add_cluster. A single convex outline needs
/// no clusters: convex_rows draws it.
/// Cost:    for each row, a few divisions for each edge that is in it; linear in the columns of
///          clusters; nothing for columns between them. Allocates when a path has more edges or
///          spans than ever before.
class path_scan {
public:
    /// What is to be drawn of a path.
    struct order {
        const l3d_path& path;
        l3d_winding inside;
        const l3d_path* clip; ///< null: all of the box
        l3d_winding clip_inside;
        l3d_pixel_box box; ///< in the picture
        double full;       ///< the value of a pixel that is covered wholly: at most 255
    };

    /// The spans from top to bottom and left to right, without overlap. Those that are not covered
    /// are left out.
    /// Lives:   until the next call.
    std::span<const covered_span> convert(const order& wanted);

    /// The values of a span whose value is -1. As many may be read beyond its end as a vector has
    /// lanes of 32 bits.
    const std::uint8_t* values_of(const covered_span& span) const {
        return values_.data() + span.values;
    }

private:
    static constexpr std::size_t most_lanes = 16; ///< of span_kernels' vectors

    struct edge {
        double x0, y0, x1, y1, slope; ///< y0 < y1, or a level one
        std::int32_t top, bottom;     ///< rows top <= row < bottom
        std::int8_t direction;
        std::uint8_t layer;

        row_piece piece_in(std::int32_t row, std::size_t index) const;
    };

    void take_corners(const l3d_path& path);
    void add_convex();
    void add_convex_row(std::int32_t row, const reached_columns& left,
                        const reached_columns& right);
    void add_edges(std::uint8_t layer);
    void add_rows();
    void add_edge(l3d_point_2d from, l3d_point_2d to, std::uint8_t layer);
    void add_within(double x0, double y0, double x1, double y1, int direction, std::uint8_t layer);
    void sort_edges(std::int32_t rows);
    void begin_row(std::int32_t row);
    void sort_pieces(std::size_t added);
    void add_row(std::int32_t row);
    windings add_cluster(std::int32_t row, std::span<const row_piece> pieces, std::int32_t last,
                         const windings& left);
    std::uint8_t* add_values(std::int32_t row, const reached_columns& columns);
    double run_up(const reached_columns& columns, double covered, std::uint8_t* value);
    double add_values(std::int32_t row, const reached_columns& columns, double covered);
    void add_solid(std::int32_t row, std::int32_t first, std::int32_t end, int value);
    std::uint8_t value_of(double covered) const {
        return static_cast<std::uint8_t>(std::clamp(covered, 0.0, 1.0) * full_ + 0.5);
    }

    l3d_pixel_box box_{};
    std::int32_t width_ = 0, height_ = 0;
    std::int32_t top_ = 0; ///< the first row with an edge
    double full_ = 255;
    int full_value_ = 255;
    fill_rules rules_;
    std::vector<l3d_point_2d> corners_; ///< of all outlines, one after the other
    std::vector<std::size_t> ends_;     ///< where each outline's corners end
    convex_rows convex_;
    std::vector<edge> edges_;
    std::vector<std::size_t> order_;  ///< edges by their top rows
    std::vector<std::size_t> begins_; ///< of each row, the first place in order_
    std::vector<row_piece> pieces_;   ///< of the row, by their first columns
    std::vector<row_piece> ordered_;
    std::vector<std::uint64_t> keys_; ///< first columns and places
    row_areas areas_;
    std::vector<covered_span> spans_;
    std::vector<std::uint8_t> values_;
};

/// What l3d_rasterizer_2d::draw_path asks for, in a picture.
inline path_scan::order order_of(const l3d_path& path, const l3d_fill& fill,
                                 const l3d_pixel_box& picture) {
    return {path,
            fill.inside,
            fill.clip,
            fill.clip_inside,
            fill.box.intersected(picture),
            255 * std::clamp(fill.alpha, 0.0, 1.0)};
}

} // namespace l3d_detail

#endif
