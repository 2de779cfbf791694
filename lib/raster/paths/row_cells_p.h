// SPDX-License-Identifier: MIT
// row_cells: the areas of pixels of a row in which very many edges lie.
#ifndef L3D_RASTER_PATHS_ROW_CELLS_P_H
#define L3D_RASTER_PATHS_ROW_CELLS_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/pixel_area_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Finds the covered area of each pixel of a row that edges reach, pixel by pixel.
///
/// Each edge adds its signed area to the pixels that it passes. Their sum is the integral of the
/// winding number. Where an outline passes a pixel once, and nothing else does, windings there take
/// two values that follow each other, so the integral tells the area. All other pixels go to
/// pixel_area.
/// Cost:    linear in the edges' pixels, and in those that pixel_area takes.
class row_cells {
public:
    /// Sets the columns to 0 to width - 1, and removes all edges.
    void begin(std::int32_t width);

    /// Adds an edge in the direction of its outline. `begin` tells where it comes from: `continues`
    /// if the edge added last leads to its first place.
    /// Units:   x in pixels, y from 0 to 1 down the row.
    void add(const l3d_point_2d& from, const l3d_point_2d& to, std::uint8_t layer,
             cell_begin begin);

    /// Adds the differences of areas from column to column to `sums`, which has a place for each
    /// column and two more. `left` are the windings on the left of all edges, whose places are 0.
    void add_to(double* sums, const windings& left, const fill_rules& rules);

private:
    enum way : std::uint8_t { up = 1, down = 2, to_left = 4, to_right = 8 };
    static constexpr std::uint32_t nowhere = ~0U;

    /// The pixel that the present outline has reached, the number of its edges there, and the
    /// directions in which they run, as bits of `way`.
    struct stay {
        std::uint32_t pixel = nowhere, edges = 0;
        std::uint8_t ways = 0;
    };

    void add_cell(edge_cell cell, cell_begin begin, std::uint8_t ways);
    void link_shared();

    std::array<std::vector<double>, 2> sums_; ///< signed areas; 0 between rows
    std::vector<std::uint8_t> visits_;        ///< for each column 0, 1, or 2 for more
    std::vector<std::uint32_t> heads_, links_;
    kept_list<edge_cell> list_;
    stay stay_;
    std::uint32_t first_ = nowhere, last_ = 0; ///< the columns that edges reach
    pixel_area pixel_;
};

} // namespace l3d_detail

#endif
