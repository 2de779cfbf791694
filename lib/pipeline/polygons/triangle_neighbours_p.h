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

/// For each side of each triangle of a model, the triangle beyond it.
///
/// Vertices at the same place are the same, whatever their numbers. A triangle with two corners at
/// one place has no neighbours: those on its two sides meet.
/// Cost:    12 bytes per triangle, and linear time when a model comes for the first time.
class triangle_neighbours {
public:
    /// There is no other triangle, or one whose corners go round the other way. Where more than two
    /// meet, the first two may be neighbours, and further ones have none.
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    /// Finds the neighbours of a model, unless it is the last call's.
    void make(const l3d_polygon_model& model);

    /// The triangle across the side from corner `side` to the next one; or none.
    std::uint32_t across(std::size_t triangle, std::size_t side) const {
        return across_[triangle][side];
    }

    /// Whether the model consists of closed bodies whose fronts are outside: two triangles meet at
    /// each side, their corners go round alike, and each body's volume is certainly positive. So
    /// from outside, no face is seen from behind, unless a body goes through itself.
    bool are_closed() const { return are_closed_; }

private:
    bool match(std::span<const std::uint32_t> names);
    bool face_outward() const;

    l3d_polygon_model model_; ///< kept, so that no other one has its address
    std::vector<std::array<std::uint32_t, 3>> across_;
    bool are_closed_ = false;
};

} // namespace l3d_detail

#endif
