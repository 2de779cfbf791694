// SPDX-License-Identifier: MIT
// limit_patches: bicubic patches for a Catmull-Clark surface, with the same bits where they meet.
#ifndef L3D_PLUGINS_SUBDIVISION_LIMIT_PATCHES_H
#define L3D_PLUGINS_SUBDIVISION_LIMIT_PATCHES_H

#include "cap_shapes.h"
#include "refined_mesh.h"

#include <cstddef>
#include <vector>

namespace l3d_limit {

/// Bicubic patches for a Catmull-Clark surface, with bounds of their distance from this limit
/// surface at the same parameters.
struct limit_patches {
    /// Control points of each patch for x, y and z, face by face.
    std::vector<std::array<net, 3>> patches;
    std::vector<leaf> leaves;   ///< the leaf that each patch stands for
    std::vector<double> errors; ///< the bound of each patch's error
    double error = 0;           ///< the largest of `errors`
    int levels = 0;
    std::size_t caps = 0; ///< number of patches that are no exact part of the surface

    /// Subdivides the cage `mesh` until the error is below `wanted`, until no level is left, or
    /// until the next level would have more patches than `most`. The first level is always made.
    limit_patches(const mesh_topology& mesh, const std::vector<place>& places,
                  OpenSubdiv::Sdc::Options options, double wanted, std::size_t most);
};

} // namespace l3d_limit

#endif
