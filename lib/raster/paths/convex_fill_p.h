// SPDX-License-Identifier: MIT
// convex_fill: fills the area between two chains of edges, many rows at once.
#ifndef L3D_RASTER_PATHS_CONVEX_FILL_P_H
#define L3D_RASTER_PATHS_CONVEX_FILL_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/path_chains_p.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// A chain, one side of an area, laid out in a block of neighbouring rows of pixels. Each lane is a
/// row.
/// Units:   pixels; row r from y = r to r + 1.
struct side_block {
    static constexpr std::size_t rows = 8;
    /// The limit of rows in a straight block: cover_rows has a bit for each row.
    static constexpr std::size_t most_straight_rows = 32;
    static constexpr std::size_t most_corners = 24;
    using lanes = std::array<double, rows>;

    /// In each row, the chain's x at the row's top, or at the chain's beginning if this is in the
    /// row.
    alignas(64) lanes enters;
    /// In each row, the chain's x at the row's bottom, or at the chain's end if this is in the row.
    lanes leaves;
    /// In each row, the number of corners between `enters` and `leaves`.
    lanes corners;
    /// The coordinates of the chain's corners in each row. Element i has each row's i-th corner
    /// from the top.
    std::array<lanes, most_corners> x, y;
    /// For each row, a pointer to the chain's first corner in the row.
    std::array<const l3d_point_2d*, rows> first;
    /// The limit of corners in a row that is filled in lanes. Rows with more corners are left to
    /// slower code, as all lanes wait for the lane with the most corners.
    double few_corners;
    /// If `straight` is true, the chain is this edge in all rows, and the members above have no
    /// meaning.
    straight_edge edge;
    bool straight;
};

/// Walks down a chain, and lays it out in blocks of rows.
class side_walk {
public:
    /// Begins at the top of a chain. Expects: the chain has not entered a row yet.
    side_walk(const chain& of, const l3d_point_2d* corners);

    /// The heights at which the chain begins and ends. Horizontal edges at the chain's ends are
    /// left out, as they bound no area.
    double begin() const { return begin_; }
    double end() const { return (behind_ - step_)->y; }

    /// The number of rows from `row` on that an edge crosses without a corner, up to the row of the
    /// next corner or the chain's end.
    /// Expects: the walk has reached `row`.
    std::size_t straight_rows(std::int32_t row) const;

    /// Lays out `count` rows from `row` on, and walks to their end.
    /// Expects: the walk has reached `row`; the rows fit into a block, or are straight, and are not
    ///          beyond the chain's end.
    void lay_out(std::int32_t row, std::size_t count, side_block& block);

    /// The x of the place that the walk has reached.
    double x() const { return x_; }

    /// The part of the chain in a row of a block.
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

/// Two chains in the same rows, the left one first, and the place in the picture of the spans
/// between them.
struct side_pair {
    std::array<const side_block*, 2> blocks;
    /// The heights between which both chains run.
    double begin, end;
    /// The first row, and the number of rows. There are more rows than in a block only if both
    /// chains are straight.
    std::int32_t row;
    std::size_t count;
    /// The visible columns are 0 to width - 1.
    std::int32_t width;
    /// Offsets that are added to columns and rows of spans.
    std::int32_t x, y;
    /// The value of a pixel that is covered wholly.
    double full;
};

/// Memory for spans and their values.
struct pair_spans {
    static constexpr std::size_t most_values = 64; ///< the limit of values in a row of a span

    covered_span* spans;  ///< room for one span in each row
    std::uint8_t* values; ///< room for most_values in each row
    /// The index of the first element of `values` in the list of all values, for
    /// covered_span::values.
    std::size_t values_before;
    std::size_t span_count = 0, value_count = 0;
};

/// Finds the spans between two chains, row by row. It leaves out rows in which the chains cross,
/// and rows in which a chain has many corners or reaches across many columns. Returns a bit for
/// each row, which is 1 if the row was left out.
/// Expects: x >= 0.
std::uint32_t cover_rows(const side_pair& pair, pair_spans& result);

} // namespace l3d_detail

#endif
