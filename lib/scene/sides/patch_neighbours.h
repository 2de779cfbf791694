// SPDX-License-Identifier: MIT
// l3d_patch_neighbours: finds sides of a model's patches that may be outlines, and patches that
// touch.
#ifndef L3D_SCENE_PATCH_NEIGHBOURS_H
#define L3D_SCENE_PATCH_NEIGHBOURS_H

#include "scene/patch_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Knows which sides of a model's patches end or break the surface, and which patches touch.
///
/// A side lies inside the surface if l3d_side_pairs pairs it with another. A side is smooth if the
/// normals of both patches along it point the same way, to within eight shade levels. A side that
/// is a point is smooth if all normals at it point the same way.
/// Cost: some 10 us a patch.
class l3d_patch_neighbours {
public:
    explicit l3d_patch_neighbours(const l3d_patch_model& model);

    /// A bit for each side of a patch that is not smooth, in the order v = 0, u = 1, v = 1, u = 0.
    unsigned outlines(std::size_t patch) const { return outlines_[patch]; }

    /// The indices of the patches that share a corner with this patch, its own included, in
    /// ascending order.
    std::span<const std::uint32_t> touching(std::size_t patch) const { return touching_[patch]; }

private:
    void find_touching(std::span<const l3d_patch_model::patch> patches);

    std::vector<unsigned char> outlines_;
    std::vector<std::vector<std::uint32_t>> touching_;
};

#endif
