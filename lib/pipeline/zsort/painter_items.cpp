// SPDX-License-Identifier: MIT
// painter_items: finds boxes and depths of items, and the pixels of small triangles.
#include "pipeline/zsort/painter_items_p.h"

#include "pipeline/zsort/tile_cover_p.h"
#include "raster/shapes/scan_edge_p.h"
#include "raster/surfaces/quad_cut_p.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace l3d_detail {

namespace {

/// Makes the item of a triangle; nothing if the triangle cannot be seen.
std::optional<painter_item> item_of(const std::array<l3d_micro_vertex, 3>& v, l3d_size size,
                                    bool with_sides) {
    const auto [least_x, most_x] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [least_y, most_y] = std::minmax({v[0].y, v[1].y, v[2].y});
    const l3d_pixel_box box{first_centre(least_x), first_centre(least_y), first_centre(most_x),
                            first_centre(most_y)};
    const l3d_pixel_box seen = box.intersected(l3d_whole(size));
    if (seen.empty())
        return std::nullopt;
    const auto [farthest, nearest] = std::minmax({v[0].inv_w, v[1].inv_w, v[2].inv_w});
    painter_item item{.left = seen.left,
                      .top = seen.top,
                      .right = seen.right,
                      .bottom = seen.bottom,
                      .farthest = farthest,
                      .nearest = nearest,
                      .cover = 0,
                      .triangle = 0};
    const std::int32_t side = std::max(box.right - box.left, box.bottom - box.top);
    const bool is_small = !with_sides && side <= painter_item::small_side && box == seen;
    if (is_small)
        tile_cover(v, {box.left, box.top, 1, 1}, &item.cover);
    if (is_small ? item.cover == 0 : twice_area(v[0], v[1], v[2]) == 0)
        return std::nullopt;
    return item;
}

} // namespace

void painter_items::begin(std::span<const l3d_painter_triangle> triangles,
                          std::span<const std::size_t> ends, l3d_size size, bool with_sides) {
    triangles_ = triangles;
    ends_.assign(ends.begin(), ends.end());
    size_ = size;
    with_sides_ = with_sides;
    items_.resize(triangles.size());
    kept_.resize(ends.size());
    areas_.resize(ends.size());
}

void painter_items::make(std::size_t chunk) {
    painter_item* const first_item = items_.data() + first(chunk);
    painter_item* next = first_item;
    double area = 0;
    for (std::size_t i = first(chunk); i < ends_[chunk]; ++i) {
        const std::optional<painter_item> item = item_of(triangles_[i].v, size_, with_sides_);
        if (!item)
            continue;
        *next = *item;
        next->triangle = static_cast<std::uint32_t>(i);
        area += double(next->right - next->left) * (next->bottom - next->top);
        ++next;
    }
    kept_[chunk] = static_cast<std::size_t>(next - first_item);
    areas_[chunk] = area;
}

void painter_items::finish() {
    count_ = std::accumulate(kept_.begin(), kept_.end(), std::size_t{0});
    area_ = std::accumulate(areas_.begin(), areas_.end(), 0.0);
}

} // namespace l3d_detail
