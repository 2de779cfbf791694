// SPDX-License-Identifier: MIT
// path_scan: the coverage of pixels by a path, row by row, where its edges are.
#ifndef L3D_RASTER_PATHS_PATH_SCAN_P_H
#define L3D_RASTER_PATHS_PATH_SCAN_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/flat_curve_p.h"
#include "raster/paths/path.h"
#include "raster/paths/path_chains_p.h"
#include "raster/paths/row_areas_p.h"
#include "raster/paths/convex_fill_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Turns paths into spans, exactly but for the distance of chords from curves and for rounding.
///
/// Pieces of chains in one row whose columns meet form a cluster. Outlines are closed, and pieces
/// that follow each other meet. So windings do not change down the row between two clusters, and
/// pixels there are covered wholly or not at all. The same holds for a gap between pieces within a
/// cluster. A run lies between two gaps: mostly a single piece, or two that only meet where an
/// outline turns. The others go to row_areas::add_cluster.
/// Cost:    a few operations for each edge and row; for each row and piece, some more; linear in
///          the columns of clusters; nothing for columns between them. Allocates when a path has
///          more edges or spans than ever before.
class path_scan {
public:
    /// A request to draw a path.
    struct order {
        const l3d_path& path;
        l3d_winding inside;
        const l3d_path* clip; ///< null: all of the box
        l3d_winding clip_inside;
        l3d_pixel_box box; ///< in the picture
        double full;       ///< the value of a pixel that is covered wholly: at most 255
    };

    /// The spans in any order, without overlap. Those that are not covered
    /// are left out.
    /// Lives:   until the next call.
    std::span<const covered_span> convert(const order& wanted);

    /// The values of columns that have their own. Beyond a span's values, as many more may be read
    /// as a vector has lanes of 32 bits.
    const std::uint8_t* values() const { return values_.data(); }

private:
    static constexpr std::size_t most_lanes = 16; ///< lanes of span_kernels' vectors

    /// A chain's piece in the row.
    struct place {
        double left, right;
        std::uint32_t chain;

        bool operator<(const place& other) const {
            return left != other.left ? left < other.left : right < other.right;
        }
    };

    /// First and last column.
    struct reached_columns {
        std::int32_t first, last;
    };

    void take_outlines(const l3d_path& path, std::uint8_t layer);
    void add_pairs();
    void add_pair(chain& a, chain& b);
    void add_pair_row(std::int32_t row, const chain& a, const chain& b);
    void add_borders(std::int32_t row, const row_piece& left_piece, const row_piece& right_piece);
    void add_all();
    void begin_row(std::int32_t row);
    void add_row(std::int32_t row);
    void add_cluster(std::int32_t row, std::span<const place> places, windings& w);
    void add_through(const row_piece& piece, windings& w);
    void add_run(std::int32_t row, std::span<const place> places, bool overlap, windings& w);
    bool add_meeting(std::span<const place> places, const windings& left);
    void add_border(const row_piece& piece, int sign);
    place place_of(const chain& c) {
        return {c.piece().left, c.piece().right,
                static_cast<std::uint32_t>(&c - chains_.chains().data())};
    }
    const row_piece& piece_of(const place& p) { return chains_.chains()[p.chain].piece(); }
    void add_span(std::int32_t row, std::int32_t first, std::int32_t end);
    bool ends_at(std::int32_t row, std::int32_t column);
    std::uint8_t* add_values(std::int32_t row, const reached_columns& columns);
    double run_up(const reached_columns& columns, double covered, std::uint8_t* value);
    double add_values(std::int32_t row, const reached_columns& columns, double covered);
    void add_solid(std::int32_t row, std::int32_t first, std::int32_t end, int value);
    std::uint8_t value_of(double covered) const {
        return static_cast<std::uint8_t>(std::clamp(covered, 0.0, 1.0) * full_ + 0.5);
    }

    l3d_pixel_box box_{};
    std::int32_t width_ = 0, height_ = 0;
    double full_ = 255;
    int full_value_ = 255;
    fill_rules rules_;
    path_chains chains_;
    flat_room flat_room_;
    std::vector<place> places_; ///< places of the row, from left to right
    std::vector<place> begun_, merged_;
    std::vector<row_edge> edges_;
    bool bordered_ = false; ///< the cluster has a border
    row_areas areas_;
    std::array<side_block, 2> blocks_;
    kept_list<covered_span> spans_;
    kept_list<std::uint8_t> values_;
};

/// The order for l3d_rasterizer_2d::draw_path, in a picture.
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
