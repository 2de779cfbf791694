// SPDX-License-Identifier: MIT
// row_cells: edges cut at columns, and the columns that outlines visit.
#include "raster/paths/row_cells_p.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {

void row_cells::begin(std::int32_t width) {
    const std::size_t columns = static_cast<std::size_t>(width) + 2;
    if (visits_.size() < columns) {
        for (std::vector<double>& sums : sums_)
            sums.resize(columns, 0.0);
        visits_.resize(columns, 0);
        heads_.resize(columns);
    }
    list_.clear();
    stay_ = {};
    first_ = nowhere;
    last_ = 0;
}

/// Notes an edge in a pixel, and whether the pixel has been visited before. Where an outline's
/// edges in a pixel all lead up, down, to the left or to the right, they do not cross each other.
/// Two that follow each other never do.
inline void row_cells::add_cell(edge_cell cell, cell_begin begin, std::uint8_t ways) {
    std::uint8_t& visits = visits_[cell.pixel];
    if (cell.pixel != stay_.pixel)
        begin = cell_begin::enters;
    if (begin != cell_begin::continues) {
        visits = visits == 0 ? 1 : 2;
    } else if (stay_.edges >= 2 && (stay_.ways | ways) == (up | down | to_left | to_right)) {
        visits = 2;
        begin = cell_begin::unclear;
    }
    cell.begin = begin;
    list_.push(cell);
}

void row_cells::add(const l3d_point_2d& from, const l3d_point_2d& to, std::uint8_t layer,
                    cell_begin begin) {
    const auto pixel_at = [](double x) { return static_cast<std::uint32_t>(x); };
    if (begin == cell_begin::unclear)
        stay_ = {pixel_at(from.x), 0, 0};
    else if (begin == cell_begin::enters)
        stay_ = {};
    const bool is_up = to.y < from.y, is_level = to.y == from.y;
    const auto ways = static_cast<std::uint8_t>((is_up      ? up
                                                 : is_level ? 0
                                                            : down) |
                                                (from.x < to.x   ? to_right
                                                 : to.x < from.x ? to_left
                                                                 : 0));
    const auto direction = static_cast<std::int8_t>(is_up ? 1 : is_level ? 0 : -1);
    // From left to right, an edge has this on its lower side, beyond what it has above.
    const std::int8_t below = from.x < to.x ? 1 : -1;
    const l3d_point_2d &least = from.x < to.x ? from : to, &most = from.x < to.x ? to : from;
    const std::uint32_t first = pixel_at(least.x), last = pixel_at(most.x);
    first_ = std::min(first_, first);
    last_ = std::max(last_, last);
    double* const sums = sums_[layer].data();
    const double per_column = first < last ? (most.y - least.y) / (most.x - least.x) : 0;
    l3d_point_2d at = least;
    for (std::uint32_t pixel = first; pixel <= last; ++pixel) {
        l3d_point_2d next = most;
        if (pixel < last) {
            next.x = pixel + 1;
            next.y = std::clamp(least.y + (next.x - least.x) * per_column, std::min(at.y, most.y),
                                std::max(at.y, most.y));
        }
        const double height = direction * std::abs(next.y - at.y);
        const double beyond = height * ((at.x + next.x) / 2 - pixel);
        sums[pixel] += height - beyond;
        sums[pixel + 1] += beyond;
        const bool leads_down = at.y <= next.y;
        add_cell({leads_down ? at : next, leads_down ? next : at, pixel, direction, layer,
                  pixel > first ? below : std::int8_t{0}, cell_begin::enters},
                 begin, ways);
        at = next;
    }
    if (const std::uint32_t end = pixel_at(to.x); end != stay_.pixel)
        stay_ = {end, 0, 0};
    ++stay_.edges;
    stay_.ways |= ways;
}

/// Links the edges of each pixel that outlines visit more than once.
void row_cells::link_shared() {
    constexpr std::uint8_t several = 2, listed = 3;
    links_.resize(std::max(links_.size(), list_.size()));
    for (std::uint32_t i = 0; i < list_.size(); ++i) {
        const std::uint32_t pixel = list_[i].pixel;
        if (visits_[pixel] < several)
            continue;
        if (visits_[pixel] == several)
            heads_[pixel] = nowhere;
        visits_[pixel] = listed;
        links_[i] = heads_[pixel];
        heads_[pixel] = i;
    }
}

void row_cells::add_to(double* sums, const windings& left, const fill_rules& rules) {
    link_shared();
    const std::size_t layers = rules.clips ? 2 : 1;
    // The area inside, if windings take two values that follow each other.
    const auto area_of = [&](double sum, std::size_t layer) {
        return rules.rule[layer] == l3d_winding::nonzero ? std::min(std::abs(sum), 1.0)
                                                         : std::abs(sum - 2 * std::rint(sum / 2));
    };
    std::array<double, 2> sum{static_cast<double>(left.turns[0]),
                              static_cast<double>(left.turns[1])};
    double before = rules.inside(left) ? 1 : 0;
    for (std::uint32_t pixel = first_; pixel <= last_ + 1; ++pixel) {
        for (std::size_t layer = 0; layer < layers; ++layer) {
            sum[layer] += sums_[layer][pixel];
            sums_[layer][pixel] = 0;
        }
        double area = 1;
        if (visits_[pixel] > 1) {
            pixel_.begin(static_cast<std::int32_t>(pixel));
            for (std::uint32_t i = heads_[pixel]; i != nowhere; i = links_[i])
                pixel_.add(list_[i]);
            area = pixel_.inside(sum, rules);
        } else {
            for (std::size_t layer = 0; layer < layers; ++layer)
                area *= area_of(sum[layer], layer);
        }
        visits_[pixel] = 0;
        sums[pixel] += area - before;
        before = area;
    }
}

} // namespace l3d_detail
