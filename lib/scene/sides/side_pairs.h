// SPDX-License-Identifier: MIT
// l3d_side_pairs: knows at which sides one patch continues another.
#ifndef L3D_SCENE_SIDE_PAIRS_H
#define L3D_SCENE_SIDE_PAIRS_H

#include "scene/patch_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Knows, for each side of a model's patches, how the surface continues beyond the side.
///
/// The surface goes on beyond a side if exactly one other side has the same control points, in
/// either direction. The surface also goes on if the two halves of the side are sides of other
/// patches. Sides are v = 0, u = 1, v = 1, u = 0, in the order in which one walks round the patch.
/// Cost: some microseconds a patch.
class l3d_side_pairs {
public:
    static constexpr std::size_t sides = 4; ///< the number of a patch's sides

    /// The kind of neighbour that a side has.
    enum class kind : unsigned char {
        open,   ///< the surface ends at the side
        point,  ///< the side is a point, around which the surface goes on
        paired, ///< one other side has the side's control points
        halved, ///< two other sides have the control points of the side's halves
        half    ///< a half of one other side has the side's control points
    };

    /// The neighbour of a side.
    struct beyond {
        kind is = kind::open;
        /// Whether both sides are walked in the same direction, so that the normals of the two
        /// patches are opposite.
        bool turns = false;
        /// The other side of the pair, or the side of which this side is a half. Meaningless for a
        /// side that is halved itself.
        std::uint32_t patch = 0, side = 0;
        /// For a side of kind `half`: 0 if it is the first half of the other side, 1 if it is the
        /// second.
        std::uint32_t part = 0;
    };

    explicit l3d_side_pairs(const l3d_patch_model& model);

    /// The neighbour beyond a side. Expects: a patch of the model, side < sides.
    const beyond& at(std::size_t patch, std::size_t side) const { return beyond_[patch][side]; }

    /// The parameters (u, v) of the place t on a side. t runs from 0 to 1 in the direction in which
    /// one walks round the patch. Expects: side < sides.
    static std::array<double, 2> place_on(std::size_t side, double t);

private:
    std::vector<std::array<beyond, sides>> beyond_;
};

#endif
