// SPDX-License-Identifier: MIT
// corner_tree: which corners of a flat polygon are left, and whether any is in a triangle.
#ifndef L3D_PIPELINE_POLYGONS_CORNER_TREE_P_H
#define L3D_PIPELINE_POLYGONS_CORNER_TREE_P_H

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// A corner's place in the plane of its polygon.
struct flat_place {
    double u = 0, v = 0;
};

/// Twice the area of a triangle, positive if it is counterclockwise.
inline double turn(const flat_place& a, const flat_place& b, const flat_place& p) {
    return (b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u);
}

/// A tree of halves of the corners, by the wider side of their box, with the number that is left in
/// each.
///
/// Cost:    n log n to make. A question looks at about sqrt(n) boxes if the triangle is empty, as
///          those are that its sides cross, and at fewer if it is not.
/// Source:  Bentley: Multidimensional binary search trees used for associative searching (CACM 18,
///          1975).
class corner_tree {
public:
    /// Lives: borrows the places.
    explicit corner_tree(std::span<const flat_place> places);

    /// Forgets a corner. Expects: it was left.
    void remove(std::size_t corner);

    /// Whether a corner that is left, other than these three, is in their triangle or on its sides.
    /// Expects: the triangle is counterclockwise.
    bool any_in(const std::array<std::size_t, 3>& triangle) const;

private:
    struct bounds {
        flat_place least, most;
        std::size_t left = 0; ///< corners not yet removed
    };
    struct half {
        std::size_t node, begin, end; ///< of `order_`
    };

    /// Corners in a leaf: fewer are looked at one by one.
    static constexpr std::size_t leaf = 8;

    void make(const half& all);
    static half first(const half& of) { return {2 * of.node, of.begin, middle(of)}; }
    static half second(const half& of) { return {2 * of.node + 1, middle(of), of.end}; }
    static std::size_t middle(const half& of) { return of.begin + (of.end - of.begin) / 2; }
    bool is_leaf(const half& of) const { return of.end - of.begin <= leaf; }
    half whole() const { return {1, 0, order_.size()}; }
    bool may_meet(const bounds& box, const std::array<flat_place, 3>& triangle) const;
    bool any_in_leaf(const half& of, const std::array<std::size_t, 3>& triangle) const;

    std::span<const flat_place> places_;
    std::vector<std::size_t> order_;    ///< corners, halves side by side
    std::vector<std::size_t> position_; ///< of each corner in `order_`
    std::vector<bool> removed_;
    std::vector<bounds> boxes_; ///< node n has the halves 2n and 2n + 1; the whole is 1
};

} // namespace l3d_detail

#endif
