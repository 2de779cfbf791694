// SPDX-License-Identifier: MIT
// band_fragments: from items to polygons that reach marked pixels.
#include "raster/refine/band_fragments_p.h"

#include "raster/refine/sample_places_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <array>

namespace l3d_detail {

namespace {

/// Fragments before what is hidden is left out for the first time: 1 MB, and up to 10 MB of
/// polygons. A band of a usual frame has fewer.
constexpr std::size_t least_most_fragments = std::size_t{1} << 16;

/// The pixels that may have a sample between the least and the most of some places.
l3d_pixel_box samples_between(const l3d_subpixel_box& box) {
    constexpr std::int32_t first = l3d_subpixel_one / sample_places::cells / 2;
    return {(box.left + first - 1) >> l3d_subpixel_bits, (box.top + first - 1) >> l3d_subpixel_bits,
            ((box.right - first) >> l3d_subpixel_bits) + 1,
            ((box.bottom - first) >> l3d_subpixel_bits) + 1};
}

} // namespace

void band_fragments::begin(const pixel_bits& marks, const drawn_depth& depth,
                           const l3d_pixel_box& band) {
    pixels_.begin(marks, depth, band);
    polygon_count_ = 0;
    count_ = 0;
    most_fragments_ = least_most_fragments;
}

void band_fragments::add(const band_list& list, const band_item& item, bool levels) {
    inside_ = item.box.intersected(pixels_.band());
    if (inside_.empty() || !pixels_.may_reach(inside_))
        return;
    add_triangles(*item.part, item.triangle_begin, item.triangle_end);
    for (int row = item.cells.row_begin; row < item.cells.row_end; ++row) {
        // Rows are told by the centres that they may cover: one more on either side is reached.
        const band_rows& reached = list.rows(item)[row - item.cells.row_begin];
        const l3d_pixel_box strip{inside_.left, std::max(reached.top - 1, inside_.top),
                                  inside_.right, std::min(reached.bottom + 1, inside_.bottom)};
        if (!strip.empty() && pixels_.may_reach(strip))
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
        if (!box.empty() && pixels_.may_reach(box))
            add_quad(part, first + i, box, levels);
    }
}

void band_fragments::add_quad(const l3d_surface_part& part, std::size_t p00,
                              const l3d_pixel_box& box, bool levels) {
    const l3d_micro_grid& grid = part.grid;
    quad_corners corners = corners_of(grid, p00);
    const quad_turns turns(corners);
    const std::uint32_t color = color_of(part, part.material);
    if (turns.level() || grid.is_cut(p00))
        return;
    if (!turns.folded()) {
        if (grid.shows_both)
            show_side(corners, turns.area2());
        return add_convex(corners, color, box);
    }
    const auto add_piece = [&](auto piece, std::int64_t area2) {
        if (grid.shows_both)
            show_side(piece, area2);
        add_convex(piece, color, reached(piece));
    };
    if (levels)
        cut_folded_levels(corners, turns, add_piece);
    else
        cut_folded(corners, turns, add_piece);
}

void band_fragments::add_triangles(const l3d_surface_part& part, std::size_t first,
                                   std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {
        const std::array corners{part.triangles.vertex(i, 0), part.triangles.vertex(i, 1),
                                 part.triangles.vertex(i, 2)};
        const l3d_pixel_box box = reached(corners);
        if (!box.empty() && pixels_.may_reach(box))
            add_convex(corners, color_of(part, part.material_of(i)), box);
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
    return samples_between(box).intersected(inside_);
}

void band_fragments::add_convex(std::span<const l3d_micro_vertex> corners, std::uint32_t color,
                                const l3d_pixel_box& box) {
    if (polygons_.size() == polygon_count_)
        polygons_.resize(2 * polygon_count_ + 1);
    fragment_polygon& polygon = polygons_[polygon_count_];
    polygon.set_corners(corners);
    if (box.empty() || polygon.area2 == 0)
        return;
    const std::size_t room = std::min(static_cast<std::size_t>(box.area()), pixels().size());
    if (fragments_.size() < count_ + room + 1)
        fragments_.resize(2 * count_ + room + 1);
    const std::size_t covered =
        cover_samples(polygon, static_cast<std::uint32_t>(polygon_count_), box, pixels_,
                      fragments_.data() + count_, static_cast<std::uint32_t>(count_));
    if (covered == 0)
        return;
    count_ += covered;
    ++polygon_count_;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            polygon.light[k][i] = corners[std::min(i, corners.size() - 1)].normal[k];
    polygon.color = color;
    polygon.set_plane();
    if (count_ >= most_fragments_)
        leave_out_hidden();
}

/// Keeps the fragments that are seen so far, and their polygons, in their order.
void band_fragments::leave_out_hidden() {
    finish();
    names_.assign(polygon_count_, fragment::none);
    for (const seen_fragment& s : seen_)
        names_[s.polygon] = 0;
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < polygon_count_; ++i)
        if (names_[i] != fragment::none) {
            polygons_[kept] = polygons_[i];
            names_[i] = kept++;
        }
    polygon_count_ = kept;
    count_ = 0;
    for (std::size_t i = 0; i < pixels().size(); ++i) {
        std::uint32_t& last = pixels_.pixels()[i].last;
        last = fragment::none;
        for (const seen_fragment& s : seen_in(i)) {
            fragments_[count_] = {s.samples, names_[s.polygon], last};
            last = static_cast<std::uint32_t>(count_++);
        }
    }
    most_fragments_ = std::max(least_most_fragments, 2 * count_);
}

void band_fragments::finish() {
    see_samples(polygons_, std::span(fragments_).first(count_), pixels(), seen_, begins_);
}

} // namespace l3d_detail
