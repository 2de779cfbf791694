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
/// It compares vertices by their indices. If some side then has no neighbour, vertices at the same
/// place count as one, even if their indices differ. A triangle with two corners that count as one
/// has no area and gets no neighbours: the triangles on both sides of it become neighbours.
/// Cost: 12 bytes per triangle, and linear time when a model comes for the first time.
class triangle_neighbours {
public:
    /// Stands for no neighbour. Either no other triangle has the side, or its corners go round the
    /// other way. Where more than two triangles meet, the first two may be neighbours, and further
    /// ones have none.
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// Finds the neighbours of a model, unless it is that of the last call.
    void make(const l3d_polygon_model& model);

    /// The triangle across the side from corner `side` to the next one; or none.
    std::uint32_t across(std::size_t triangle, std::size_t side) const {
        return across_[triangle][side];
    }

    /// Whether the model consists of closed bodies whose fronts are outside. In these, two
    /// triangles meet at each side, their corners go round alike, and the volume is certainly
    /// positive. So from outside, no face is seen from behind, unless a body goes through itself.
    bool are_closed() const { return are_closed_; }

private:
    bool match(std::span<const std::uint32_t> names);
    bool face_outward() const;

    l3d_polygon_model model_; ///< kept, so that no other model has its address
    std::vector<std::array<std::uint32_t, 3>> across_;
    bool are_closed_ = false;
};

} // namespace l3d_detail

#endif
