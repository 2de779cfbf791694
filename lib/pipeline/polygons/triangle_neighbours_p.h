// SPDX-License-Identifier: MIT
// triangle_neighbours: finds triangles that share a side, and whether they close a body.
#ifndef L3D_PIPELINE_POLYGONS_TRIANGLE_NEIGHBOURS_P_H
#define L3D_PIPELINE_POLYGONS_TRIANGLE_NEIGHBOURS_P_H

#include "pipeline/polygons/polygon_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Finds the triangle across each side of each triangle of a model.
///
/// It first compares vertices by their indices. If any side has no neighbour then, it compares
/// vertices by their places instead. A triangle with two equal corners has no area and gets no
/// neighbours. The triangles on its two sides become neighbours of each other instead.
/// Cost: 12 bytes per triangle, and linear time if the model is not that of the last call.
class triangle_neighbours {
public:
    /// Stands for no neighbour across a side. Either no other triangle has the side, or the corners
    /// of the triangle beyond it go round in the opposite direction. Where more than two triangles
    /// meet at a side, the first two may be neighbours, and the remaining ones have none.
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// Finds the neighbours of a model's triangles, unless the last call was for the same model.
    void make(const l3d_polygon_model& model);

    /// The triangle across the side from corner `side` to the next corner; or none.
    std::uint32_t across(std::size_t triangle, std::size_t side) const {
        return across_[triangle][side];
    }

    /// Whether the model consists of closed bodies whose fronts are outside. In such bodies, two
    /// triangles meet at each side, their corners go round in the same direction, and each body's
    /// volume is certainly positive. So from outside, no face is seen from behind, unless a body
    /// passes through itself.
    bool are_closed() const { return are_closed_; }

private:
    bool match(std::span<const std::uint32_t> names);
    bool face_outward() const;

    /// The model of the last call, kept so that no other model gets its address.
    l3d_polygon_model model_;
    std::vector<std::array<std::uint32_t, 3>> across_;
    bool are_closed_ = false;
};

} // namespace l3d_detail

#endif
