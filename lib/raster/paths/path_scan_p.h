// SPDX-License-Identifier: MIT
// path_scan: the coverage of pixels by a path, row by row, where its edges are.
#ifndef L3D_RASTER_PATHS_PATH_SCAN_P_H
#define L3D_RASTER_PATHS_PATH_SCAN_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/flat_curve_p.h"
#include "raster/paths/path.h"
#include "raster/paths/path_chains_p.h"
#include "raster/paths/row_areas_p.h"
#include "raster/paths/row_cells_p.h"
#include "raster/paths/convex_fill_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Turns paths into spans. They are exact except for rounding, and for the distance of chords from
/// curves.
///
/// Chains are cut into pieces, one for each row of pixels. Pieces whose columns meet form a
/// cluster. As outlines are closed and consecutive pieces meet, windings do not change down the row
/// between two clusters. So pixels there are covered wholly or not at all. The same holds for a gap
/// between pieces within a cluster.
///
/// A run is the part of a cluster between two gaps. Mostly it is a single piece, or two that only
/// meet where an outline turns. All other runs go to row_areas::add_cluster.
/// Cost:    a few operations for each edge and row, and some more for each row and piece. Clusters
///          take time linear in their columns, and columns between them take none. Allocates when a
///          path has more edges or spans than ever before.
class path_scan {
public:
    /// A request to draw a path.
    struct order {
        const l3d_path& path;
        l3d_winding inside;
        const l3d_path* clip; ///< null: the whole box
        l3d_winding clip_inside;
        l3d_pixel_box box; ///< a part of the picture
        double full;       ///< value of a pixel that is covered wholly, at most 255
    };

    /// Finds the spans of a path, in any order and without overlap. Pixels that are not covered
    /// have none.
    /// Lives:   until the next call.
    std::span<const covered_span> convert(const order& wanted);

    /// The values of columns that have a value each. After a span's values, as many more may be
    /// read as a vector has 32-bit lanes.
    const std::uint8_t* values() const { return values_.data(); }

private:
    static constexpr std::size_t most_lanes = 16; ///< lanes of span_kernels' vectors

    /// The piece of a chain in the present row.
    struct place {
        double left, right;
        std::uint32_t chain;

        bool operator<(const place& other) const {
            return left != other.left ? left < other.left : right < other.right;
        }
    };

    /// The first and the last column that a cluster reaches.
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
    void add_crowd(std::int32_t row, std::span<const place> places, const windings& left);
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
    std::vector<place> places_; ///< the pieces of the row, from left to right
    std::vector<place> begun_, merged_;
    std::vector<row_edge> edges_;
    bool bordered_ = false; ///< whether the cluster has a border
    row_areas areas_;
    std::vector<place> crowd_;
    std::vector<l3d_point_2d> way_; ///< the corners of a piece
    row_cells cells_;
    std::array<side_block, 2> blocks_;
    kept_list<covered_span> spans_;
    kept_list<std::uint8_t> values_;
};

/// The request that l3d_rasterizer_2d::draw_path makes, for a picture.
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
