// SPDX-License-Identifier: MIT
// l3d_tessellated: patches as a mesh of triangles.
#ifndef L3D_PIPELINE_POLYGONS_PATCH_TESSELLATION_H
#define L3D_PIPELINE_POLYGONS_PATCH_TESSELLATION_H

#include "base/public.h"
#include "geom/polygon_mesh.h"
#include "scene/patch_model.h"

#include <cstddef>
#include <string>
#include <vector>

struct l3d_model_file;

/// Largest n that programs take: 2 n^2 triangles for each patch make two million for the teapot.
inline constexpr int l3d_most_facets = 192;

/// The usual n of models that are drawn as polygons.
inline constexpr int l3d_usual_facets = 8;

/// Patches as triangles.
struct L3D_PUBLIC l3d_patch_mesh {
    l3d_polygon_mesh mesh;              ///< the triangles of all patches
    std::vector<std::size_t> face_ends; ///< patch by patch, the number of faces up to its last
};

/// Each patch as n by n quads of two triangles, counterclockwise where dS/du x dS/dv points to,
/// with the patch's normals at the vertices, of its material and in its part.
///
/// Patches with a common boundary have the same points on it: these are a function of the
/// boundary's control points, whichever way it runs. They are one vertex, unless the normals of the
/// two differ, as at a crease. Triangles whose corners coincide, as at the teapot's knob, are left
/// out.
/// Expects: n >= 1.
L3D_PUBLIC l3d_patch_mesh l3d_tessellated(const l3d_patch_model& model, int n);

/// The polygons of a file that was read, and its patches as n by n quads each.
/// Errors: throws l3d_error(bad_input) for a file that holds neither, and for patches that are no
///         bicubic ones.
/// Expects: n >= 1.
L3D_PUBLIC l3d_polygon_mesh l3d_mesh_of(const l3d_model_file& file, const std::string& name, int n);

#endif
