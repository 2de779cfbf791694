// SPDX-License-Identifier: MIT
// lit_faces: faces in the light, for worlds, which draw every face in its own colour.
#ifndef L3D_APPS_MORPH3D_LIT_FACES_H
#define L3D_APPS_MORPH3D_LIT_FACES_H

#include <l3d/polygon_mesh.h>
#include <l3d/transform.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

/// Mixes two colours. `share` is the part of the second one, from 0 to 1.
inline std::uint32_t mixed(std::uint32_t first, std::uint32_t second, double share) {
    std::uint32_t word = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        const double from = first >> shift & 255, to = second >> shift & 255;
        word |= static_cast<std::uint32_t>(std::lround(from + (to - from) * share)) << shift;
    }
    return word;
}

/// The brightness of a face, after the matrix `turned` has turned the mesh: 0.25 in the shadow, and
/// 1 in full light. The light comes from above, from the left and from the viewer.
inline double light_on(const l3d_polygon_mesh& mesh, std::size_t face,
                       const l3d_matrix<double>& turned) {
    const auto corners = mesh.face(face);
    const auto& origin = mesh.vertices[corners[0]];
    const auto normal =
        l3d_cross(mesh.vertices[corners[1]] - origin, mesh.vertices[corners[2]] - origin);
    const auto world = turned * l3d_vector<double, 4>(normal, 0.0);
    const double length = l3d_length(normal);
    if (length == 0)
        return 1;
    const double cosine = (-0.48 * world[0] + 0.6 * world[1] - 0.64 * world[2]) / length;
    return 0.25 + 0.75 * std::clamp(cosine, 0.0, 1.0);
}

#endif
