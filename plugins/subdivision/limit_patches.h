// SPDX-License-Identifier: MIT
// limit_patches: bicubic patches for a Catmull-Clark surface, with the same bits where they meet.
#ifndef L3D_PLUGINS_SUBDIVISION_LIMIT_PATCHES_H
#define L3D_PLUGINS_SUBDIVISION_LIMIT_PATCHES_H

#include "cap_shapes.h"
#include "refined_mesh.h"

#include <cstddef>
#include <vector>

namespace l3d_limit {

/// Patches with a bound of their distance from the limit surface at the same parameters.
struct limit_patches {
    std::vector<std::array<net, 3>> patches; ///< x, y and z, face by face
    std::vector<leaf> leaves;                ///< the leaves that the patches stand for
    std::vector<double> errors;              ///< one for each patch
    double error = 0;                        ///< the largest of them
    int levels = 0;
    std::size_t caps = 0; ///< patches that are no exact part of the surface

    /// Subdivides until the error is below `wanted`, no level is left, or the next one has more
    /// patches than `most`. The first level is always made.
    limit_patches(const mesh_topology& mesh, const std::vector<place>& places,
                  OpenSubdiv::Sdc::Options options, double wanted, std::size_t most);
};

} // namespace l3d_limit

#endif
