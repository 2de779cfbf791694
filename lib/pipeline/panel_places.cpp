// SPDX-License-Identifier: MIT
// panel_places: chooses among free rectangles, and keeps their rest beside a panel.
#include "pipeline/panel_places_p.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <tuple>

namespace l3d_detail {

namespace {

bool has_same_size(const l3d_pixel_box& a, const l3d_pixel_box& b) {
    return a.right - a.left == b.right - b.left && a.bottom - a.top == b.bottom - b.top;
}

} // namespace

l3d_pixel_box panel_places::place_for(const l3d_panel& panel, l3d_corner corner) const {
    const l3d_pixel_box wanted = panel.box_in(picture_, corner, style_);
    using rank = std::tuple<int, std::int64_t, std::int64_t>; // the least is the best
    const auto rank_of = [&](const l3d_pixel_box& free) -> rank {
        const l3d_pixel_box box = panel.box_in(free, corner, style_);
        if (box.empty())
            return {2, -free.area(), 0};
        if (!has_same_size(box, wanted))
            return {1, -free.area(), 0};
        return {0, std::abs(box.left - wanted.left), std::abs(box.top - wanted.top)};
    };
    const auto best = std::ranges::min_element(free_, {}, rank_of);
    return best == free_.end() ? l3d_pixel_box() : *best;
}

bool panel_places::take(const l3d_panel& panel, l3d_corner corner) {
    if (panel.empty())
        return true;
    const l3d_pixel_box free = place_for(panel, corner);
    const l3d_pixel_box box = panel.box_in(free, corner, style_);
    remove(box.empty() ? free : box);
    return !box.empty();
}

l3d_pixel_box panel_places::draw(l3d_rasterizer_2d& rasterizer, const l3d_panel& panel,
                                 l3d_corner corner) {
    l3d_pixel_box free = place_for(panel, corner);
    const l3d_pixel_box box = panel.draw(rasterizer, free, corner, style_);
    remove(box);
    return box;
}

/// Takes a box out of the free rectangles. Up to four rectangles remain of each free rectangle, one
/// on each side of the box.
void panel_places::remove(const l3d_pixel_box& box) {
    if (box.empty())
        return;
    std::vector<l3d_pixel_box> rests;
    for (const l3d_pixel_box& free : free_) {
        if (free.intersected(box).empty()) {
            rests.push_back(free);
            continue;
        }
        std::array<l3d_pixel_box, 4> sides{free, free, free, free};
        sides[0].bottom = box.top;
        sides[1].top = box.bottom;
        sides[2].right = box.left;
        sides[3].left = box.right;
        std::ranges::remove_copy_if(sides, std::back_inserter(rests), &l3d_pixel_box::empty);
    }
    free_.clear();
    for (const l3d_pixel_box& rest : rests) {
        const auto holds = [&](const l3d_pixel_box& other) {
            return other.intersected(rest) == rest;
        };
        if (std::ranges::any_of(free_, holds))
            continue;
        std::erase_if(free_,
                      [&](const l3d_pixel_box& other) { return rest.intersected(other) == other; });
        free_.push_back(rest);
    }
}

} // namespace l3d_detail
