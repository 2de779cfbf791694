// SPDX-License-Identifier: MIT
// corner_tree: halves sets of corners, boxes them, and searches for corners in a triangle.
#include "pipeline/polygons/corner_tree_p.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace l3d_detail {

corner_tree::corner_tree(std::span<const flat_place> places)
    : places_(places), order_(places.size()), position_(places.size()), removed_(places.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    // Halves differ by one corner at most, so the depths of leaves differ by one at most.
    boxes_.resize(4 * std::bit_ceil(places.size() / leaf + 1));
    std::vector<half> open{whole()};
    while (!open.empty()) {
        const half next = open.back();
        open.pop_back();
        make(next);
        if (!is_leaf(next)) {
            open.push_back(first(next));
            open.push_back(second(next));
        }
    }
    for (std::size_t i = 0; i < order_.size(); ++i)
        position_[order_[i]] = i;
}

/// Makes a node: fills its box, sorts its corners into halves, and makes the nodes of the halves.
void corner_tree::make(const half& of) {
    const auto begin = order_.begin() + static_cast<std::ptrdiff_t>(of.begin);
    const auto end = order_.begin() + static_cast<std::ptrdiff_t>(of.end);
    bounds& box = boxes_[of.node];
    box.left = of.end - of.begin;
    box.least = box.most = places_[*begin];
    for (auto corner = begin; corner != end; ++corner) {
        const flat_place& place = places_[*corner];
        box.least = {std::min(box.least.u, place.u), std::min(box.least.v, place.v)};
        box.most = {std::max(box.most.u, place.u), std::max(box.most.v, place.v)};
    }
    if (is_leaf(of))
        return;
    const bool by_u = box.most.u - box.least.u > box.most.v - box.least.v;
    const auto split = order_.begin() + static_cast<std::ptrdiff_t>(middle(of));
    std::ranges::nth_element(begin, split, end, {}, [&](std::size_t corner) {
        return by_u ? places_[corner].u : places_[corner].v;
    });
}

void corner_tree::remove(std::size_t corner) {
    removed_[corner] = true;
    half at = whole();
    for (;;) {
        --boxes_[at.node].left;
        if (is_leaf(at))
            return;
        at = position_[corner] < middle(at) ? first(at) : second(at);
    }
}

/// Whether a box may meet a triangle. The result is false only if no point of the box is in the
/// triangle. For each side of the triangle, the function tests the corner of the box that lies
/// farthest to the side's left, where turn() is largest.
bool corner_tree::may_meet(const bounds& box, const std::array<flat_place, 3>& triangle) const {
    for (std::size_t i = 0; i < 3; ++i) {
        const flat_place &a = triangle[i], &b = triangle[(i + 1) % 3];
        const flat_place farthest{b.v >= a.v ? box.least.u : box.most.u,
                                  b.u >= a.u ? box.most.v : box.least.v};
        if (turn(a, b, farthest) < 0)
            return false;
    }
    const auto [left, right] = std::ranges::minmax(triangle, {}, &flat_place::u);
    const auto [bottom, top] = std::ranges::minmax(triangle, {}, &flat_place::v);
    return box.least.u <= right.u && box.most.u >= left.u && box.least.v <= top.v &&
           box.most.v >= bottom.v;
}

} // namespace l3d_detail
