// SPDX-License-Identifier: MIT
// band_fragments: finds the polygons of items that reach marked pixels.
#include "raster/refine/band_fragments_p.h"

#include "raster/refine/sample_places_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <array>

namespace l3d_detail {

namespace {

/// The number of fragments at which hidden ones are removed for the first time. This number of
/// fragments takes 1 MB, and their polygons take up to 10 MB. A band of a usual frame has fewer.
constexpr std::size_t least_most_fragments = std::size_t{1} << 16;

/// Finds the pixels that may have a sample in a polygon's box.
l3d_pixel_box samples_between(const l3d_subpixel_box& box) {
    constexpr std::int32_t first = l3d_subpixel_one / sample_places::cells / 2;
    return {(box.left + first - 1) >> l3d_subpixel_bits, (box.top + first - 1) >> l3d_subpixel_bits,
            ((box.right - first) >> l3d_subpixel_bits) + 1,
            ((box.bottom - first) >> l3d_subpixel_bits) + 1};
}

} // namespace

std::int32_t band_fragments::begin(const l3d_pixel_bits& marks, const drawn_depth& depth,
                                   const l3d_pixel_box& band, std::size_t most) {
    pixels_.begin(marks, depth, band, most);
    polygon_count_ = 0;
    count_ = 0;
    most_fragments_ = least_most_fragments;
    return pixels_.band().bottom;
}

void band_fragments::add(const band_list& list, const band_item& item, bool levels) {
    inside_ = item.box.intersected(pixels_.band());
    if (inside_.empty() || !pixels_.reached(inside_))
        return;
    add_triangles(*item.part, item.triangle_begin, item.triangle_end);
    const band_rows* const rows = list.rows(item);
    for (int row = item.cells.row_begin; row < item.cells.row_end; ++row) {
        // The quads may cover centres of the rows `reached`, and parts of one more row on either
        // side.
        const band_rows& reached = rows[row - item.cells.row_begin];
        const l3d_pixel_box strip{inside_.left, std::max(reached.top - 1, inside_.top),
                                  inside_.right, std::min(reached.bottom + 1, inside_.bottom)};
        if (!strip.empty() && pixels_.reached(strip))
            add_row(*item.part, item.cells, row, levels);
    }
}

void band_fragments::add_row(const l3d_surface_part& part, const grid_cells& cells, int row,
                             bool levels) {
    const std::size_t first = part.grid.index(row, cells.column_begin);
    const auto count = static_cast<std::size_t>(cells.column_end - cells.column_begin);
    boxes_.find(part.grid, first, count, inside_);
    for (std::size_t i = 0; i < count; ++i) {
        const l3d_pixel_box box{boxes_.left[i], boxes_.top[i], boxes_.right[i], boxes_.bottom[i]};
        if (!box.empty() && pixels_.reached(box))
            add_quad(part, first + i, box, levels);
    }
}

/// Keeps a polygon if it has a fragment in a box.
void band_fragments::add_polygon(const quad_corners& corners, std::int32_t count,
                                 std::int64_t area2, const l3d_pixel_box& box,
                                 std::uint32_t color) {
    if (polygons_.size() == polygon_count_)
        polygons_.resize(2 * polygon_count_ + 1);
    fragment_polygon& polygon = polygons_[polygon_count_];
    polygon.set(corners, count, area2);
    const std::size_t room = pixels().size();
    if (fragments_.size() < count_ + room) {
        const std::size_t more = count_ + count_ / 2 + room;
        fragments_.reserve(more); // resize() alone would double the capacity
        fragments_.resize(more);
    }
    const std::size_t covered =
        cover_samples(polygon, static_cast<std::uint32_t>(polygon_count_), box, pixels_,
                      fragments_.data() + count_, static_cast<std::uint32_t>(count_));
    if (covered == 0)
        return;
    count_ += covered;
    polygon.color = color;
    polygon.set_plane();
    ++polygon_count_;
    if (count_ >= most_fragments_)
        leave_out_hidden();
}

void band_fragments::add_quad(const l3d_surface_part& part, std::size_t p00,
                              const l3d_pixel_box& box, bool levels) {
    const l3d_micro_grid& grid = part.grid;
    quad_corners corners = corners_of(grid, p00);
    const quad_turns turns(corners);
    if (turns.level() || grid.is_cut(p00))
        return;
    const std::uint32_t color = color_of(part, part.material_of_quad(p00));
    if (!turns.folded()) {
        if (grid.shows_both)
            show_side(corners, turns.area2());
        return add_polygon(corners, 4, turns.area2(), box, color);
    }
    const auto add_piece = [&](auto piece, std::int64_t area2) {
        if (grid.shows_both)
            show_side(piece, area2);
        add_triangle(piece, color);
    };
    if (levels)
        cut_folded_levels(corners, grid.is_parallel, turns, add_piece);
    else
        cut_folded(corners, grid.is_parallel, turns, add_piece);
}

void band_fragments::add_triangles(const l3d_surface_part& part, std::size_t first,
                                   std::size_t last) {
    for (std::size_t i = first; i < last; ++i)
        add_triangle(
            {part.triangles.vertex(i, 0), part.triangles.vertex(i, 1), part.triangles.vertex(i, 2)},
            color_of(part, part.material_of(i)));
}

void band_fragments::add_triangle(const std::array<l3d_micro_vertex, 3>& corners,
                                  std::uint32_t color) {
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
    const l3d_pixel_box box = samples_between({left, top, right, bottom}).intersected(inside_);
    if (box.empty() || !pixels_.reached(box))
        return;
    const std::int64_t area2 = twice_area(corners[0], corners[1], corners[2]);
    if (area2 != 0)
        add_polygon({corners[0], corners[1], corners[2], corners[2]}, 3, area2, box, color);
}

/// Keeps the fragments that are seen so far, and their polygons, in the same order.
void band_fragments::leave_out_hidden() {
    names_.assign(polygon_count_, fragment::none);
    kept_.clear();
    visit_seen([&](std::size_t i, std::span<const seen_fragment> seen) {
        std::uint32_t last = fragment::none;
        for (const seen_fragment& s : seen) {
            names_[s.polygon] = 0;
            kept_.push_back({s.samples, s.polygon, last});
            last = static_cast<std::uint32_t>(kept_.size() - 1);
        }
        pixels_.pixels()[i].last = last;
    });
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < polygon_count_; ++i)
        if (names_[i] != fragment::none) {
            polygons_[kept] = polygons_[i];
            names_[i] = kept++;
        }
    polygon_count_ = kept;
    for (fragment& f : kept_)
        f.polygon = names_[f.polygon];
    fragments_.swap(kept_);
    count_ = fragments_.size();
    most_fragments_ = std::max(least_most_fragments, 2 * count_);
}

} // namespace l3d_detail
