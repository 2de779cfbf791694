// SPDX-License-Identifier: MIT
// band_cells: finds the areas of pixels in a band of rows, from the signed areas of edges.
#ifndef L3D_RASTER_PATHS_BAND_CELLS_P_H
#define L3D_RASTER_PATHS_BAND_CELLS_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/path_chains_p.h"
#include "raster/paths/pixel_area_p.h"
#include "raster/paths/span_writer_p.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Finds the covered area of each pixel in a band of rows.
///
/// Each edge adds its signed area to the pixels that it passes. In a pixel, the sum of these areas
/// is the integral of the winding number. If a single outline passes a pixel once, the winding
/// number has two consecutive values in the pixel, so the integral tells the area. A pixel that
/// outlines pass more often is surely covered if the sum is large. Otherwise pixel_area finds its
/// area.
/// Cost:    linear in the pixels that edges pass, and in the band's pixels, an eighth of an
///          operation each. Allocates when a band is larger, or has more edges, than ever before.
class band_cells {
public:
    /// Sets the pixels that outlines reach, and the fill rules. Expects: the box is not empty; its
    /// first row and column are at least 0.
    void begin(const l3d_pixel_box& reached, const fill_rules& rules);

    /// The number of rows that a band may have.
    std::int32_t rows() const { return rows_; }

    /// Begins a band without edges: rows top <= row < bottom.
    /// Expects: at most rows(), and within the box.
    void begin_band(std::int32_t top, std::int32_t bottom);

    /// Adds the edges of an outline from corner to corner, as far as they reach into the band.
    /// `all` is the array of all outlines' corners, and `blocks` the array of all outlines' blocks.
    /// Expects: `all` stays until write() has returned.
    void add(const path_chains::outline& outline, const l3d_point_2d* all,
             const path_chains::block* blocks);

    /// Writes the spans of the band, and removes all edges.
    void write(span_writer& to);

private:
    /// The number of pixels whose values of coverage are found together.
    static constexpr std::size_t group = 8;
    /// The sums over all edges in a pixel. The edges add to the winding number. `cover` is the
    /// integral of the added number along the pixel's right side, and `area` its integral over the
    /// pixel. `visits` counts how often outlines pass the pixel.
    struct cell {
        double cover = 0, area = 0;
        std::uint32_t visits = 0;
        std::uint32_t last = 0; ///< index in records_ of the edge that was added last; 0 for none
    };
    struct walk;

    void write_row(std::int32_t row, span_writer& to);
    void find_sums(std::size_t at, std::size_t end, double& cover);
    void find_exact(std::size_t at, double* sums);
    void find_clipped(std::size_t at, std::size_t end, std::array<double, 2>& cover);
    double exact(std::size_t at, std::uint32_t visits, const std::array<double, 2>& sums);

    fill_rules rules_;
    std::int32_t left_ = 0, right_ = 0, rows_ = 0, top_ = 0, bottom_ = 0;
    std::size_t stride_ = 0; ///< the number of cells in a row, a multiple of `group`
    std::array<std::vector<cell>, 2> cells_;
    kept_list<edge_record> records_;
    /// For each row, a bit for each group of pixels: whether edges pass it.
    std::vector<std::uint64_t> groups_;
    std::size_t words_ = 0;    ///< the number of words that a row takes in groups_
    std::vector<double> sums_; ///< the integrals, or the areas, of a run of pixels
    const l3d_point_2d* corners_ = nullptr;
    pixel_area pixel_;
};

} // namespace l3d_detail

#endif
