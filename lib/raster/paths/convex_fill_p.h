// SPDX-License-Identifier: MIT
// convex_fill: the area between two chains of edges, many rows at once.
#ifndef L3D_RASTER_PATHS_CONVEX_FILL_P_H
#define L3D_RASTER_PATHS_CONVEX_FILL_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/path_chains_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A chain in neighbouring rows of pixels, a lane a row.
/// Units:   pixels; row r from y = r to r + 1.
struct side_block {
    static constexpr std::size_t rows = 8;
    /// The limit of rows in a straight block: cover_rows has a bit for each row.
    static constexpr std::size_t most_straight_rows = 32;
    static constexpr std::size_t most_corners = 24;
    using lanes = std::array<double, rows>;

    /// x at the row's top, or where the chain begins.
    alignas(64) lanes enters;
    /// x at the row's bottom, or where the chain ends.
    lanes leaves;
    /// The number of corners between `enters` and `leaves`.
    lanes corners;
    /// The corners, from top to bottom.
    std::array<lanes, most_corners> x, y;
    /// The first corner of each row.
    std::array<const l3d_point_2d*, rows> first;
    /// Rows with more corners are left to others: all lanes wait for the one with the most.
    double few_corners;
    /// If `straight`, the chain is this edge in all rows, and nothing else counts.
    straight_edge edge;
    bool straight;
};

/// Goes down a chain, and lays it out in blocks.
class side_walk {
public:
    /// Expects: the chain has not entered a row yet.
    side_walk(const chain& of, const l3d_point_2d* corners);

    /// The heights where the chain begins and ends. Level edges at its ends are left out, for they
    /// bound no area.
    double begin() const { return begin_; }
    double end() const { return (behind_ - step_)->y; }

    /// The number of rows from `row` on before the row of the chain's next corner, or to its end.
    /// Expects: the walk has gone to `row`.
    std::size_t straight_rows(std::int32_t row) const;

    /// Lays out `count` rows from `row` on, and goes to their end.
    /// Expects: the walk has gone to `row`; no more rows than a block has, than are straight, or
    ///          than are left.
    void lay_out(std::int32_t row, std::size_t count, side_block& block);

    /// x at the place that the walk has gone to.
    double x() const { return x_; }

    /// The chain's piece in a row of a block.
    row_piece piece_of(const side_block& block, std::int32_t row, std::size_t lane) const;

private:
    void skip_level();
    bool lay_out_straight(double end, side_block& block);
    double edge_at(double y);

    const chain& chain_;
    std::ptrdiff_t step_;
    const l3d_point_2d *next_, *behind_;
    double x_, y_, begin_;
    straight_edge edge_;
    const l3d_point_2d* edge_end_ = nullptr;
};

/// Two chains in the same rows, the left one first, and the way their area is drawn.
struct side_pair {
    std::array<const side_block*, 2> blocks;
    /// The heights where both begin and end.
    double begin, end;
    /// The first row, and the number of rows: more than a block's only if both chains are straight.
    std::int32_t row;
    std::size_t count;
    /// The visible columns are 0 to width - 1.
    std::int32_t width;
    /// Offsets that are added to the columns and rows of spans.
    std::int32_t x, y;
    /// The value of a pixel that is covered wholly.
    double full;
};

/// Memory that spans and their values are written to.
struct pair_spans {
    static constexpr std::size_t most_values = 64; ///< values of a row

    covered_span* spans;       ///< has room for one for each row
    std::uint8_t* values;      ///< has room for most_values for each row
    std::size_t values_before; ///< the place of the first value
    std::size_t span_count = 0, value_count = 0;
};

/// Finds the spans of rows in which the chains do not cross, and neither goes across many columns
/// nor has many corners. Gives the other rows, as bits.
/// Expects: x >= 0.
std::uint32_t cover_rows(const side_pair& pair, pair_spans& result);

} // namespace l3d_detail

#endif
