// SPDX-License-Identifier: MIT
// The interface of the plug-in that makes patches from the cages of subdivision surfaces.
#ifndef L3D_GEOM_FILES_SUBDIVISION_PLUGIN_P_H
#define L3D_GEOM_FILES_SUBDIVISION_PLUGIN_P_H

#include "geom/files/plugin_p.h"

#include <cstdint>

namespace l3d_detail {

/// The cage of a Catmull-Clark surface, from which the plug-in makes patches.
///
/// Expects: a manifold whose faces all turn the same way, without a vertex twice in a face; each
///          crease is an edge of the cage.
struct subdivision_cage {
    std::uint32_t vertices;
    const double* places; ///< x, y, z of each vertex
    std::uint32_t faces;
    const std::uint32_t* face_ends; ///< per face, the index behind its last corner in `corners`
    const std::uint32_t* corners;
    std::uint32_t creases;
    const std::uint32_t* crease_vertices; ///< the two vertices of each crease
    /// Number of subdivisions that keep a crease sharp; 10 is for ever.
    const float* crease_sharpness;
    std::uint32_t points; ///< number of vertices that are sharp themselves
    const std::uint32_t* point_vertices;
    const float* point_sharpness;
    std::uint32_t holes;
    const std::uint32_t* hole_faces; ///< faces without patches
    std::uint32_t keeps_corners;     ///< 1 if corners of boundaries are sharp, else 0
    double wanted_error;             ///< the wanted bound of the distance from the limit surface
    /// The largest number of patches. If the wanted error takes more patches, the error grows
    /// instead.
    std::uint64_t most_patches;
};

/// The receiver of patches.
struct subdivision_sink {
    void* to;
    /// Takes a patch: 16 control points, x, y and z of each, u fastest. `face` is the patch's face
    /// of the cage. The normal dS/du x dS/dv points to the side from which the face's corners run
    /// counterclockwise. `error` bounds the distance from the limit surface at the same parameters.
    /// `error` also bounds the distance of the control points, unless the patch is a cap: a patch
    /// that is not exact.
    void (*take)(void* to, std::uint32_t face, const double* points, double error,
                 std::uint32_t is_cap);
    void (*fail)(void* to, const char* why);
};

/// The result of subdivide(): the error of the patches, and the effort.
struct subdivision_outcome {
    double error;         ///< bound of the patches' distance from the limit surface
    std::uint32_t levels; ///< number of subdivisions around irregular vertices
    std::uint32_t caps;   ///< number of patches that are not exact
};

/// The interface of the plug-in libl3d_subdivision.so, its symbol l3d_subdivision_plugin.
struct subdivision_plugin : plugin_interface {
    /// Makes patches within the wanted error of the limit surface, face by face. Neighbouring
    /// patches meet bit for bit: the control points on their boundary are the same, or halve the
    /// same curve.
    /// Errors: 0, after sink.fail with the reason; else 1.
    int (*subdivide)(const subdivision_cage* cage, const subdivision_sink* sink,
                     subdivision_outcome* outcome);
};

/// The version of subdivision_plugin.
inline constexpr std::uint32_t subdivision_plugin_version = 2;

} // namespace l3d_detail

#endif
