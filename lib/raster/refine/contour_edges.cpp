// SPDX-License-Identifier: MIT
// contour_edges: finds the turns of quads in lanes, 64 quads to a word of bits.
#include "raster/refine/contour_edges_p.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "raster/refine/contour_edges.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/lane_integers-inl.h"
#include "raster/parallel/simd_dispatch_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// Finds how the quads of a row turn, from column `begin` to `end`. Quad c has bit c % 64 of word c
/// / 64. Differences and products are exact for quads up to 16 pixels, and rounded for larger ones.
/// Every caller gets the same answer.
/// Expects: begin is a multiple of 64, and the words are 0.
void turns_of_row(const l3d_micro_grid& grid, int row, int begin, int end, std::uint64_t* right,
                  std::uint64_t* folded) {
    const ints d;
    const floats df;
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    for (int column = begin; column < end; column += static_cast<int>(lanes)) {
        const std::size_t at = grid.index(row, column);
        const std::array<std::size_t, 4> corner{at, at + 1, at + pitch + 1, at + pitch};
        int_vec x[4], y[4];
        for (std::size_t i = 0; i < 4; ++i) {
            x[i] = load_from(grid.x, corner[i]);
            y[i] = load_from(grid.y, corner[i]);
        }
        float_vec dx[4], dy[4];
        for (std::size_t i = 0; i < 4; ++i) {
            dx[i] = hn::ConvertTo(df, hn::Sub(x[(i + 1) % 4], x[i]));
            dy[i] = hn::ConvertTo(df, hn::Sub(y[(i + 1) % 4], y[i]));
        }
        float_vec least = hn::Zero(df), most = hn::Zero(df);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t next = (i + 1) % 4;
            const float_vec turn = hn::Sub(hn::Mul(dx[i], dy[next]), hn::Mul(dy[i], dx[next]));
            least = hn::Min(least, turn);
            most = hn::Max(most, turn);
        }
        const int_mask any_right = hn::RebindMask(d, hn::Gt(most, hn::Zero(df)));
        const int_mask any_left = hn::RebindMask(d, hn::Lt(least, hn::Zero(df)));
        right[column / 64] |= bits_of(hn::AndNot(any_left, any_right)) << (column % 64);
        folded[column / 64] |= bits_of(hn::And(any_left, any_right)) << (column % 64);
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {

L3D_SIMD_TABLE(turns_of_row);

namespace {

constexpr int word_bits = 64;

bool has(const std::uint64_t* bits, int column) {
    return (bits[column / word_bits] >> (column % word_bits) & 1) != 0;
}

/// The sides of a quad, in the order of quad_corners.
enum side : std::size_t { upper, right_side, lower, left_side };

} // namespace

std::span<const contour_edge> contour_edges::find(const band_list& list, const band_item& item,
                                                  std::int32_t top, std::int32_t bottom) {
    edges_.clear();
    const grid_cells& cells = item.cells;
    if (cells.row_begin >= cells.row_end)
        return edges_;
    const l3d_micro_grid& grid = item.part->grid;
    const auto words = static_cast<std::size_t>((grid.columns + word_bits - 1) / word_bits);
    const int begin = std::max(cells.column_begin - 1, 0) / word_bits * word_bits;
    const auto fill = [&](std::vector<std::uint64_t>& of, int row) {
        of.assign(2 * words, 0);
        if (row >= 0)
            L3D_SIMD_CALL(turns_of_row)
        (grid, row, begin, cells.column_end, of.data(), of.data() + words);
    };
    int filled = -1; // the row whose turns are in here_
    for (int row = cells.row_begin; row < cells.row_end; ++row) {
        // The quads may cover centres of the rows `reached`, and reach one more row on either side.
        const band_rows& reached = list.rows(item)[row - cells.row_begin];
        if (reached.top - 1 >= bottom || reached.bottom + 1 <= top)
            continue;
        if (row > 0 && filled == row - 1)
            above_.swap(here_);
        else
            fill(above_, row - 1);
        fill(here_, row);
        filled = row;
        add_row(*item.part, cells, row);
    }
    return edges_;
}

void contour_edges::add_row(const l3d_surface_part& part, const grid_cells& cells, int row) {
    const l3d_micro_grid& grid = part.grid;
    const std::size_t words = here_.size() / 2;
    const std::uint64_t *const right = here_.data(), *const folded = right + words;
    const std::uint64_t *const right_above = above_.data(), *const folded_above =
                                                                right_above + words;
    const auto turns = [&](int of_row, int column, std::size_t side) {
        const bool is_here = of_row == row;
        if (!has(is_here ? folded : folded_above, column))
            return has(is_here ? right : right_above, column);
        const quad_corners v = corners_of(grid, grid.index(of_row, column));
        return piece_turns_right(v, projective_centre(v, grid.is_parallel), side);
    };
    for (int word = cells.column_begin / word_bits; word * word_bits < cells.column_end; ++word) {
        const auto w = static_cast<std::size_t>(word);
        const std::uint64_t inside =
            l3d_pixel_bits::within(word, cells.column_begin, cells.column_end);
        const std::uint64_t any_folded = folded[w] | folded_above[w];
        std::uint64_t level = row > 0 ? (right[w] ^ right_above[w]) | any_folded : 0;
        for (level &= inside; level != 0; level &= level - 1) {
            const int column = word * word_bits + std::countr_zero(level);
            const std::size_t p = grid.index(row, column);
            if (grid.is_cut(p) || grid.is_cut(grid.index(row - 1, column)))
                continue;
            add_between(grid.vertex(p), grid.vertex(p + 1), turns(row, column, upper),
                        turns(row - 1, column, lower));
        }
        const auto moved = [&](const std::uint64_t* of) {
            return of[w] << 1 | (w > 0 ? of[w - 1] >> (word_bits - 1) : 0);
        };
        std::uint64_t upright = (right[w] ^ moved(right)) | folded[w] | moved(folded);
        if (word == 0)
            upright &= ~std::uint64_t{1};
        for (upright &= inside; upright != 0; upright &= upright - 1) {
            const int column = word * word_bits + std::countr_zero(upright);
            const std::size_t p = grid.index(row, column);
            if (grid.is_cut(p) || grid.is_cut(p - 1))
                continue;
            add_between(grid.vertex(p + static_cast<std::size_t>(grid.pitch)), grid.vertex(p),
                        turns(row, column, left_side), turns(row, column - 1, right_side));
        }
        for (std::uint64_t some = folded[w] & inside; some != 0; some &= some - 1)
            if (const int column = word * word_bits + std::countr_zero(some);
                !grid.is_cut(grid.index(row, column)))
                add_spokes(grid, row, column);
    }
}

/// Adds the edge between two vertices if the polygon on exactly one of its sides turns to the
/// right.
void contour_edges::add_between(const l3d_micro_vertex& from, const l3d_micro_vertex& to,
                                bool right_turns, bool left_turns) {
    const float nearest = std::max(from.inv_w, to.inv_w);
    if (right_turns && !left_turns)
        edges_.push_back({position(from), position(to), nearest});
    else if (left_turns && !right_turns)
        edges_.push_back({position(to), position(from), nearest});
}

/// Adds the edges between the pieces of a folded quad. The edge from the centre to a corner lies
/// between the pieces of the two sides that meet in this corner.
void contour_edges::add_spokes(const l3d_micro_grid& grid, int row, int column) {
    const quad_corners v = corners_of(grid, grid.index(row, column));
    const l3d_micro_vertex centre = projective_centre(v, grid.is_parallel);
    for (std::size_t i = 0; i < v.size(); ++i)
        add_between(centre, v[i], piece_turns_right(v, centre, i),
                    piece_turns_right(v, centre, (i + 3) % v.size()));
}

} // namespace l3d_detail
#endif
