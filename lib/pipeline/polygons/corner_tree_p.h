// SPDX-License-Identifier: MIT
// corner_tree: tells whether any remaining corner of a flat polygon is in a triangle.
#ifndef L3D_PIPELINE_POLYGONS_CORNER_TREE_P_H
#define L3D_PIPELINE_POLYGONS_CORNER_TREE_P_H

#include "raster/shapes/exact_steps_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// The place of a polygon's corner in the polygon's plane, in whole steps of a grid. Coordinates
/// are below 2^52, so that areas of triangles are exact.
struct flat_place {
    std::int64_t u = 0, v = 0;
};

/// Twice the area of the triangle a, b, p; positive if its corners run counterclockwise.
inline wide_integer turn(const flat_place& a, const flat_place& b, const flat_place& p) {
    return wide_integer{b.u - a.u} * (p.v - a.v) - wide_integer{b.v - a.v} * (p.u - a.u);
}

/// A tree that finds out whether any corner of a polygon lies in a triangle. Each node divides its
/// corners into two halves, across the wider side of their box. Each node counts those of its
/// corners that are not removed yet.
///
/// Cost:   making the tree of n corners takes n log n time. For a triangle without corners,
///         any_in() looks at the boxes that the triangle's sides cross, about sqrt(n). For other
///         triangles it looks at fewer boxes.
/// Source: Bentley: Multidimensional binary search trees used for associative searching (CACM 18,
///         1975).
class corner_tree {
public:
    /// Makes a tree of the corners at these places. Lives: borrows the places.
    explicit corner_tree(std::span<const flat_place> places);

    /// Removes a corner, so that any_in() ignores it. Expects: the corner is not removed yet.
    void remove(std::size_t corner);

    /// Whether blocks(p, {ab, bc, ca}) is true for any corner p in the triangle or on its sides.
    /// The triangle's own corners and removed corners do not count. The numbers ab, bc and ca are
    /// turn() of each side with p; none is negative.
    /// Expects: the triangle is counterclockwise.
    template <class Blocks>
    bool any_in(const std::array<std::size_t, 3>& triangle, const Blocks& blocks) const {
        const std::array<flat_place, 3> corners{places_[triangle[0]], places_[triangle[1]],
                                                places_[triangle[2]]};
        // A node, and one pending sibling for each level of at most 64.
        std::array<half, 65> open;
        std::size_t count = 0;
        open[count++] = whole();
        while (count > 0) {
            const half next = open[--count];
            const bounds& box = boxes_[next.node];
            if (box.left == 0 || !may_meet(box, corners))
                continue;
            if (!is_leaf(next)) {
                open[count++] = second(next);
                open[count++] = first(next);
            } else if (any_in_leaf(next, triangle, blocks)) {
                return true;
            }
        }
        return false;
    }

private:
    struct bounds {
        flat_place least, most;
        std::size_t left = 0; ///< number of corners that are not removed yet
    };
    struct half {
        /// The node's number, and the range of its corners in `order_`.
        std::size_t node, begin, end;
    };

    /// The most corners in a leaf. any_in() looks at a leaf's corners one by one.
    static constexpr std::size_t leaf = 8;

    void make(const half& all);
    static half first(const half& of) { return {2 * of.node, of.begin, middle(of)}; }
    static half second(const half& of) { return {2 * of.node + 1, middle(of), of.end}; }
    static std::size_t middle(const half& of) { return of.begin + (of.end - of.begin) / 2; }
    bool is_leaf(const half& of) const { return of.end - of.begin <= leaf; }
    half whole() const { return {1, 0, order_.size()}; }
    bool may_meet(const bounds& box, const std::array<flat_place, 3>& triangle) const;
    template <class Blocks>
    bool any_in_leaf(const half& of, const std::array<std::size_t, 3>& triangle,
                     const Blocks& blocks) const {
        const auto [a, b, c] = triangle;
        for (std::size_t i = of.begin; i < of.end; ++i) {
            const std::size_t p = order_[i];
            if (removed_[p] || p == a || p == b || p == c)
                continue;
            const std::array turns{turn(places_[a], places_[b], places_[p]),
                                   turn(places_[b], places_[c], places_[p]),
                                   turn(places_[c], places_[a], places_[p])};
            if (turns[0] >= 0 && turns[1] >= 0 && turns[2] >= 0 && blocks(p, turns))
                return true;
        }
        return false;
    }

    std::span<const flat_place> places_;
    /// The corners, sorted so that each node's corners stand together.
    std::vector<std::size_t> order_;
    std::vector<std::size_t> position_; ///< each corner's index in `order_`
    std::vector<bool> removed_;
    /// The box of each node. Node 1 holds all corners; the halves of node n are the nodes 2n and 2n
    /// + 1.
    std::vector<bounds> boxes_;
};

} // namespace l3d_detail

#endif
