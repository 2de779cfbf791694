// SPDX-License-Identifier: MIT
// l3d_subdivide: patches of the smooth surface whose cage is a mesh of polygons.
#ifndef L3D_GEOM_SUBDIVISION_H
#define L3D_GEOM_SUBDIVISION_H

#include "base/public.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

struct l3d_model_file;

/// Sharp edges and vertices of a mesh, for subdivision, as statements `t` of .obj files give them.
struct L3D_PUBLIC l3d_cage_tags {
    /// An edge between two vertices, which stays sharp for `sharpness` subdivisions. From 10 on it
    /// is a crease for ever.
    struct crease {
        std::uint32_t from, to; ///< indices of vertices
        float sharpness;        ///< number of subdivisions; not negative

        friend bool operator==(const crease&, const crease&) = default;
    };
    /// A vertex that stays sharp for `sharpness` subdivisions.
    struct corner {
        std::uint32_t vertex; ///< index of the vertex
        float sharpness;      ///< number of subdivisions, as for a crease

        friend bool operator==(const corner&, const corner&) = default;
    };
    std::vector<crease> creases;      ///< sharp edges
    std::vector<corner> corners;      ///< sharp vertices
    std::vector<std::uint32_t> holes; ///< indices of faces without a surface
    /// Whether a boundary's corners are sharp; nothing if the file does not say.
    std::optional<bool> keeps_corners{};

    friend bool operator==(const l3d_cage_tags&, const l3d_cage_tags&) = default;
};

/// The treatment of the corners of boundaries: vertices that belong to only one face.
enum class L3D_PUBLIC l3d_cage_boundary {
    as_tagged, ///< as the file's tags say; sharp if they say nothing
    corners,   ///< corners are sharp
    smooth,    ///< corners are rounded
};

/// Settings of l3d_subdivide.
struct L3D_PUBLIC l3d_subdivision {
    /// The permitted distance from the limit surface, as a share of the diagonal of the cage's
    /// bounding box. At 2^-13, a model 1000 pixels large is off by an eighth of a pixel at most.
    double error = 0x1p-13;
    /// The largest angle between the normals of faces that join smoothly. Where the angle is
    /// larger, their common edge becomes a crease. Units: degrees.
    double crease_angle = 180;
    l3d_cage_boundary boundary = l3d_cage_boundary::as_tagged; ///< the corners of boundaries
};

/// Replaces a model's polygons by patches of their Catmull-Clark surface, with materials and parts.
/// Most patches are exact. Patches at irregular vertices are within the model's patch_errors of the
/// limit surface (docs/NUMERICS.md, section 29). A note tells the error that was reached.
///
/// The function needs the plug-in libl3d_subdivision.so, of the package l3d-subdivision.
/// Errors: false, and `why` = "name: reason", if the plug-in is missing or the mesh has no faces.
///         The same holds if a face has a vertex twice, or if faces meet in nothing but a vertex.
///         It also holds if an edge belongs to more than two faces, or to two faces that turn
///         opposite ways.
/// Cost:   some 10 us a patch. There are at most 2^17 patches; if these are too few, the error is
///         larger.
/// Source: E. Catmull, J. Clark, 1978; patches and creases as OpenSubdiv 3.5 has them.
L3D_PUBLIC bool l3d_subdivide(l3d_model_file& model, const l3d_subdivision& how,
                              std::string_view name, std::string& why);

#endif
