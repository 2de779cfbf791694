// SPDX-License-Identifier: MIT
// winding_scan: keeps the edges of each row, which come and go from row to row.
#include "raster/shapes/winding_scan_p.h"

#include "raster/shapes/polygon_corners_p.h"

#include <algorithm>

namespace l3d_detail {

std::span<const pixel_span> winding_scan::convert(std::span<const l3d_outline_2d> outlines,
                                                  l3d_winding inside, l3d_size size) {
    edges_.clear();
    crossings_.clear();
    spans_.clear();
    for (const l3d_outline_2d outline : outlines) {
        if (!std::ranges::all_of(outline, is_number))
            return {};
        add_outline(outline, size.height);
    }
    std::ranges::sort(edges_, {}, &edge::top);
    std::size_t next = 0;
    for (std::int32_t row = 0; next < edges_.size() || !crossings_.empty(); ++row) {
        if (crossings_.empty())
            row = edges_[next].top;
        for (; next < edges_.size() && edges_[next].top == row; ++next)
            crossings_.push_back({edges_[next].columns.column(), edges_[next].direction, next});
        sort_crossings();
        add_spans(row, inside, size.width);
        step_to(row + 1);
    }
    return spans_;
}

void winding_scan::add_outline(l3d_outline_2d outline, std::int32_t height) {
    if (outline.empty())
        return;
    far_point from = lattice_point(outline.back());
    for (const l3d_point_2d& corner : outline) {
        const far_point to = lattice_point(corner);
        add_edge(from, to, height);
        from = to;
    }
}

void winding_scan::add_edge(far_point from, far_point to, std::int32_t height) {
    const bool down = from.y < to.y;
    const far_point upper = down ? from : to, lower = down ? to : from;
    const std::int32_t top = std::max(first_centre(upper.y), 0);
    const std::int32_t bottom = std::min(first_centre(lower.y), height);
    if (top < bottom)
        edges_.push_back({top, bottom, down ? -1 : 1, exact_edge(upper, lower, top)});
}

/// Sorts crossings by insertion, since few crossings change places from one row to the next.
void winding_scan::sort_crossings() {
    for (auto place = crossings_.begin(); place != crossings_.end(); ++place) {
        const crossing moving = *place;
        auto hole = place;
        for (; hole != crossings_.begin() && std::prev(hole)->column > moving.column; --hole)
            *hole = *std::prev(hole);
        *hole = moving;
    }
}

void winding_scan::add_spans(std::int32_t row, l3d_winding inside, std::int32_t width) {
    const unsigned counted = inside == l3d_winding::even_odd ? 1u : ~0u;
    int turns = 0;
    std::int32_t begin = 0;
    for (const crossing& c : crossings_) {
        const std::int32_t end = std::clamp(c.column, 0, width);
        if ((static_cast<unsigned>(turns) & counted) != 0 && begin < end) {
            if (!spans_.empty() && spans_.back().row == row && spans_.back().last == begin)
                spans_.back().last = end;
            else
                spans_.push_back({row, begin, end});
        }
        begin = end;
        turns += c.direction;
    }
}

void winding_scan::step_to(std::int32_t row) {
    std::erase_if(crossings_, [&](const crossing& c) { return edges_[c.edge].bottom <= row; });
    for (crossing& c : crossings_) {
        edges_[c.edge].columns.step();
        c.column = edges_[c.edge].columns.column();
    }
}

} // namespace l3d_detail
