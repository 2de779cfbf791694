// SPDX-License-Identifier: MIT
// l3d_edge_polylines: the edges of a patch and of the pieces it is cut into.
#ifndef L3D_DICE_EDGES_EDGE_POLYLINES_H
#define L3D_DICE_EDGES_EDGE_POLYLINES_H

#include "dice/edges/edge_polyline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

/// The edge polylines of one patch, and of the pieces into which it is cut. The next patch reuses
/// their memory.
///
/// Shape: outer edges are [0] v low, [1] v high (both along u), [2] u low, [3] u high (both along
///        v). The edges from [4] on are cuts through the patch.
class l3d_edge_polylines {
public:
    static constexpr std::size_t sides = 4;

    /// Builds the four outer edges of a patch, and forgets all other edges.
    /// Expects: all patches that share an edge pass the same share for it
    ///          (l3d_dice_view::share_of).
    void build(const l3d_image_patch& net, const l3d_dice_view& view,
               const std::array<double, sides>& shares = {1, 1, 1, 1}) {
        l3d_edge_polyline::build(std::span(edges_).first<sides>(),
                                 {net.row(0), net.row(3), net.column(0), net.column(3)}, view,
                                 shares);
        used_ = sides;
    }

    /// Builds an outer edge anew from its halves, `first` and `second`. The halves are sides of two
    /// smaller patches beyond the edge, each with its own share of the view's errors.
    void build_halved(std::size_t side, const l3d_image_curve& first, const l3d_image_curve& second,
                      const l3d_dice_view& view, const std::array<double, 2>& shares) {
        l3d_edge_polyline::build(std::span(halves_).first<sides>(), {first, second, first, second},
                                 view, {shares[0], shares[1], shares[0], shares[1]});
        edges_[side].join(halves_[0], halves_[1], view);
    }

    /// Builds the edge of a cut through the patch, and returns its index.
    std::size_t add(const l3d_image_curve& curve, const l3d_dice_view& view) {
        if (used_ == edges_.size())
            edges_.emplace_back();
        edges_[used_].build(curve, view);
        return used_++;
    }

    /// Reserves memory for as many edges as `other` has, each as large as the edge with the same
    /// index in `other`. Then building edges of these sizes allocates nothing.
    void reserve_as(const l3d_edge_polylines& other) {
        if (edges_.size() < other.edges_.size())
            edges_.resize(other.edges_.size());
        for (std::size_t i = 0; i < other.edges_.size(); ++i)
            edges_[i].reserve_as(other.edges_[i]);
        for (std::size_t i = 0; i < sides; ++i)
            halves_[i].reserve_as(other.halves_[i]);
    }

    std::span<const l3d_edge_polyline, sides> outer() const {
        return std::span(edges_).first<sides>();
    }
    const l3d_edge_polyline& operator[](std::size_t i) const { return edges_[i]; }

private:
    std::vector<l3d_edge_polyline> edges_ = std::vector<l3d_edge_polyline>(sides);
    std::vector<l3d_edge_polyline> halves_ = std::vector<l3d_edge_polyline>(sides);
    std::size_t used_ = 0;
};

#endif
