// SPDX-License-Identifier: MIT
// band_fragments: boxes of polygons against bits of pixels.
#include "raster/refine/band_fragments_p.h"

#include "raster/surfaces/pixel_box_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace l3d_detail {

namespace {

/// A box of so many columns is paired whole. Polygons with wider ones are asked in each row how far
/// they reach: a needle from corner to corner would else have a million pairs.
constexpr std::int32_t most_paired_whole = 32;

/// The squares that a polygon may reach into in a row of pixels.
/// Crossings of its sides with the row's ends are rounded, so they are 1/256 pixel farther out.
l3d_pixel_box reached_in_row(std::span<const l3d_micro_vertex> corners, std::int32_t row) {
    // What lies on the end of the row before reaches into this one (squares_in).
    const double top = l3d_subpixel_one * double(row) - 1, bottom = top + l3d_subpixel_one + 1;
    double left = std::numeric_limits<double>::infinity(), right = -left;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const l3d_micro_vertex &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if (std::max(a.y, b.y) < top || std::min(a.y, b.y) > bottom)
            continue;
        const double x = a.x, y = a.y, dx = b.x - x, dy = b.y - y;
        for (const double end : {top, bottom}) {
            const double part = dy != 0 ? std::clamp((end - y) / dy, 0.0, 1.0) : end == top;
            left = std::min(left, x + part * dx);
            right = std::max(right, x + part * dx);
        }
    }
    if (left > right)
        return {};
    l3d_pixel_box result = squares_in({static_cast<std::int32_t>(std::floor(left)) - 1, 0,
                                       static_cast<std::int32_t>(std::ceil(right)) + 1, 0});
    result.top = row;
    result.bottom = row + 1;
    return result;
}

} // namespace

std::int64_t fragment_polygon::area2() const {
    const scan_point first{x[2] - x[0], y[2] - y[0]}, second{x[3] - x[1], y[3] - y[1]};
    return cross(first, second);
}

void band_fragments::begin(const pixel_bits& bits, const drawn_depth& depth, std::int32_t width,
                           std::int32_t top, std::int32_t bottom) {
    bits_ = &bits;
    band_ = {0, top, width, bottom};
    pixels_.clear();
    farthest_.clear();
    before_.clear();
    polygons_.clear();
    pairs_.clear();
    for (std::int32_t y = top; y < bottom; ++y)
        for (std::size_t w = 0; w < bits.row_words(); ++w) {
            before_.push_back(static_cast<std::uint32_t>(pixels_.size()));
            for (std::uint64_t left = bits.row(y)[w]; left != 0; left &= left - 1)
                pixels_.push_back({static_cast<std::int32_t>(w) * pixel_bits::word_pixels +
                                       std::countr_zero(left),
                                   y});
        }
    for (const pixel& p : pixels_)
        farthest_.push_back(depth.farthest(p.x, p.y));
}

std::uint32_t band_fragments::first_in(std::int32_t word, std::int32_t y) const {
    return before_[static_cast<std::size_t>(y - band_.top) * bits_->row_words() +
                   static_cast<std::size_t>(word)];
}

/// Rows of quads that reach no marked pixel are left out, then columns that no row has a mark in.
void band_fragments::add(const band_list& list, const band_item& item, bool levels) {
    marked_ = bits_->bounds(item.box.intersected(band_));
    if (marked_.empty())
        return;
    add_triangles(*item.part, item.triangle_begin, item.triangle_end);
    columns_.assign(bits_->row_words(), 0);
    const std::int32_t first = marked_.left / pixel_bits::word_pixels;
    const std::int32_t last = (marked_.right - 1) / pixel_bits::word_pixels;
    for (int row = item.cells.row_begin; row < item.cells.row_end; ++row) {
        // Rows are told by the centres that they may cover: one more on either side is reached.
        const band_rows& reached = list.rows(item)[row - item.cells.row_begin];
        const std::int32_t top = std::max(reached.top - 1, marked_.top);
        const std::int32_t bottom = std::min(reached.bottom + 1, marked_.bottom);
        if (top >= bottom)
            continue;
        std::uint64_t any = 0;
        for (std::int32_t w = first; w <= last; ++w) {
            std::uint64_t columns = 0;
            for (std::int32_t y = top; y < bottom; ++y)
                columns |= bits_->row(y)[w];
            columns &= pixel_bits::within(w, marked_.left, marked_.right);
            columns_[static_cast<std::size_t>(w)] = columns;
            any |= columns;
        }
        if (any != 0)
            add_row(*item.part, item.cells, row, levels);
    }
}

void band_fragments::add_row(const l3d_surface_part& part, const grid_cells& cells, int row,
                             bool levels) {
    const l3d_micro_grid& grid = part.grid;
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    const std::size_t first = grid.index(row, cells.column_begin);
    /// The least and the most of a number at the two vertices of a column.
    const auto range_at = [&](const std::vector<std::int32_t>& of, std::size_t at) {
        return std::pair(std::min(of[at], of[at + pitch]), std::max(of[at], of[at + pitch]));
    };
    auto [left, right] = range_at(grid.x, first);
    const std::size_t quads = static_cast<std::size_t>(cells.column_end - cells.column_begin);
    for (std::size_t p00 = first; p00 < first + quads; ++p00) {
        const auto [next_left, next_right] = range_at(grid.x, p00 + 1);
        const l3d_pixel_box wide =
            squares_in({std::min(left, next_left), 0, std::max(right, next_right), 0});
        left = next_left;
        right = next_right;
        if (wide.right <= marked_.left || wide.left >= marked_.right ||
            !has_column(std::max(wide.left, marked_.left), std::min(wide.right, marked_.right)))
            continue;
        const auto [top, bottom] = range_at(grid.y, p00);
        const auto [next_top, next_bottom] = range_at(grid.y, p00 + 1);
        const l3d_pixel_box high =
            squares_in({0, std::min(top, next_top), 0, std::max(bottom, next_bottom)});
        const l3d_pixel_box box =
            l3d_pixel_box{wide.left, high.top, wide.right, high.bottom}.intersected(marked_);
        if (!box.empty() && bits_->any(box))
            add_quad(part, p00, box, levels);
    }
}

/// Whether a column of [left, right) is marked in columns_. Expects: 0 <= left < right.
bool band_fragments::has_column(std::int32_t left, std::int32_t right) const {
    std::size_t word = pixel_bits::word_of(left);
    const std::size_t last = pixel_bits::word_of(right - 1);
    const std::uint64_t from = ~std::uint64_t{0} << pixel_bits::bit_of(left);
    const std::uint64_t to = ~std::uint64_t{0} >> (63 - pixel_bits::bit_of(right - 1));
    if (word == last)
        return (columns_[word] & from & to) != 0;
    std::uint64_t any = columns_[word] & from;
    for (++word; word < last; ++word)
        any |= columns_[word];
    return (any | (columns_[last] & to)) != 0;
}

void band_fragments::add_quad(const l3d_surface_part& part, std::size_t p00,
                              const l3d_pixel_box& box, bool levels) {
    const l3d_micro_grid& grid = part.grid;
    quad_corners corners = corners_of(grid, p00);
    const quad_turns turns(corners);
    const std::uint32_t color = color_of(part, part.material);
    if (turns.level())
        return;
    if (grid.shows_both && !turns.folded())
        show_side(corners, turns.area2());
    if (!turns.folded())
        return add_convex(corners, color, box, true);
    const auto add_piece = [&](auto piece) {
        if (grid.shows_both)
            show_side(piece);
        add_convex(piece, color, reached(piece), true);
    };
    if (levels)
        cut_folded_levels(corners, add_piece);
    else
        cut_folded(corners, add_piece);
}

void band_fragments::add_triangles(const l3d_surface_part& part, std::size_t first,
                                   std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const std::array corners{part.triangles.vertex(i, 0), part.triangles.vertex(i, 1),
                                 part.triangles.vertex(i, 2)};
        add_convex(corners, color_of(part, part.material_of(i)), reached(corners),
                   part.grid.rows < 2);
    }
}

l3d_pixel_box band_fragments::reached(std::span<const l3d_micro_vertex> corners) const {
    l3d_subpixel_box box{corners[0].x, corners[0].y, corners[0].x, corners[0].y};
    for (const l3d_micro_vertex& v : corners.subspan(1)) {
        box.left = std::min(box.left, v.x);
        box.top = std::min(box.top, v.y);
        box.right = std::max(box.right, v.x);
        box.bottom = std::max(box.bottom, v.y);
    }
    return squares_in(box).intersected(marked_);
}

void band_fragments::add_convex(std::span<const l3d_micro_vertex> corners, std::uint32_t color,
                                const l3d_pixel_box& box, bool counts_once) {
    const l3d_micro_vertex &a = corners[0], &b = corners[1], &c = corners[2], &d = corners.back();
    const bool is_level = cross({c.x - a.x, c.y - a.y}, {d.x - b.x, d.y - b.y}) == 0;
    if (box.empty() || is_level)
        return;
    float farthest = corners[0].inv_w, nearest = farthest;
    for (const l3d_micro_vertex& v : corners.subspan(1)) {
        farthest = std::min(farthest, v.inv_w);
        nearest = std::max(nearest, v.inv_w);
    }
    if (!add_pairs(corners, box, nearest))
        return;
    fragment_polygon& polygon = polygons_.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
        const l3d_micro_vertex& v = corners[std::min(i, corners.size() - 1)];
        polygon.x[i] = v.x;
        polygon.y[i] = v.y;
        polygon.inv_w[i] = v.inv_w;
        for (std::size_t k = 0; k < 3; ++k)
            polygon.light[k][i] = v.normal[k];
    }
    polygon.farthest = farthest;
    polygon.nearest = nearest;
    polygon.corners = static_cast<std::int32_t>(corners.size());
    polygon.color = color;
    polygon.counts_once = counts_once;
}

/// Pairs the next polygon with the marked pixels of its box where it may be seen. False if there is
/// none.
bool band_fragments::add_pairs(std::span<const l3d_micro_vertex> corners, l3d_pixel_box box,
                               float nearest) {
    const auto name = static_cast<std::uint32_t>(polygons_.size());
    const std::size_t pairs = pairs_.size();
    const l3d_pixel_box whole = box;
    const bool is_wide = box.right - box.left > most_paired_whole;
    for (std::int32_t y = whole.top; y < whole.bottom; ++y) {
        if (is_wide) {
            box = reached_in_row(corners, y).intersected(whole);
            if (box.empty())
                continue;
        }
        const auto last = static_cast<std::int32_t>(pixel_bits::word_of(box.right - 1));
        for (auto w = static_cast<std::int32_t>(pixel_bits::word_of(box.left)); w <= last; ++w) {
            const std::uint64_t of_word = bits_->row(y)[w];
            std::uint64_t marked = of_word & pixel_bits::within(w, box.left, box.right);
            if (marked == 0)
                continue;
            // The marked pixels of a word are next to each other in the list.
            const std::uint64_t before = of_word & ((marked & -marked) - 1);
            std::uint32_t index = first_in(w, y) + static_cast<std::uint32_t>(bits_in(before));
            for (; marked != 0; marked &= marked - 1, ++index)
                if (nearest >= farthest_[index])
                    pairs_.push_back({index, name});
        }
    }
    return pairs_.size() != pairs;
}

void band_fragments::sort() {
    begins_.assign(pixels_.size() + 2, 0);
    for (const pair& p : pairs_)
        ++begins_[p.pixel + 2];
    for (std::size_t i = 2; i < begins_.size(); ++i)
        begins_[i] += begins_[i - 1];
    sorted_.resize(pairs_.size());
    for (const pair& p : pairs_)
        sorted_[begins_[p.pixel + 1]++] = p;
    begins_.pop_back();
}

} // namespace l3d_detail
