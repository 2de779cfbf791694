// SPDX-License-Identifier: MIT
// path_scan: finds the coverage of pixels by a path, row by row.
#ifndef L3D_RASTER_PATHS_PATH_SCAN_P_H
#define L3D_RASTER_PATHS_PATH_SCAN_P_H

#include "raster/paths/band_cells_p.h"
#include "raster/paths/convex_fill_p.h"
#include "raster/paths/covered_span_p.h"
#include "raster/paths/flat_curve_p.h"
#include "raster/paths/path.h"
#include "raster/paths/path_chains_p.h"
#include "raster/paths/row_areas_p.h"
#include "raster/paths/span_writer_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Turns paths into spans of covered pixels. The coverage is exact except for rounding, and for the
/// distance of chords from curves.
///
/// If an outline of two chains is near no other outline, the area between its chains is filled,
/// many rows at once. All other outlines go to band_cells, band by band.
/// Cost:    a few operations for each pixel that an edge passes, and an eighth of an operation for
///          each pixel of the outlines' box. Allocates when a path has more edges or spans than
///          ever before.
class path_scan {
public:
    /// A request to draw a path.
    struct order {
        const l3d_path& path;
        l3d_winding inside;
        const l3d_path* clip; ///< only pixels inside of this path are covered; null: no limit
        l3d_winding clip_inside;
        l3d_pixel_box box; ///< the box that is filled, a part of the picture
        double full;       ///< value of a pixel that is covered wholly, at most 255
    };

    /// Finds the spans of a path, in any order and without overlap. Pixels that are not covered
    /// have no span.
    /// Lives:   until the next call.
    std::span<const covered_span> convert(const order& wanted);

    /// The values of the columns before and after the middles of spans; covered_span::values is an
    /// index of this array. Behind a span's values, as many more values may be read as a vector has
    /// 32-bit lanes.
    const std::uint8_t* values() const { return writer_.values().data(); }

private:
    /// The largest number of lanes in span_kernels' vectors.
    static constexpr std::size_t most_lanes = 16;

    void take_outlines(const l3d_path& path, std::uint8_t layer);
    void add_pairs();
    void add_pair(const chain& a, const chain& b);
    void add_pair_row(std::int32_t row, const row_piece& one, const row_piece& other);
    void add_borders(std::int32_t row, const row_piece& left, const row_piece& right);
    void add_crossing(std::int32_t row, const row_piece& one, const row_piece& other);
    void add_border(const row_piece& piece, int sign);
    double add_values(std::int32_t row, double left, double right, double covered);
    void add_bands();

    l3d_pixel_box box_{};
    std::int32_t width_ = 0, height_ = 0;
    fill_rules rules_;
    path_chains chains_;
    flat_room flat_room_;
    std::vector<row_edge> edges_;
    row_areas areas_;
    band_cells cells_;
    std::vector<const path_chains::outline*> active_;
    std::array<side_block, 2> blocks_;
    span_writer writer_;
};

/// The order by which l3d_rasterizer_2d::draw_path draws into a picture.
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
