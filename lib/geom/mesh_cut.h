// SPDX-License-Identifier: MIT
// Meshes cut in two by a plane, and brought into left-handed axes.
#ifndef L3D_GEOM_MESH_CUT_H
#define L3D_GEOM_MESH_CUT_H

#include "base/public.h"
#include "geom/plane.h"
#include "geom/polygon_mesh.h"

/// The treatment of the hole where a mesh was cut.
enum class L3D_PUBLIC l3d_cut_end {
    open,   ///< the cut is left as it is: one can look in
    capped, ///< a face closes each loop of cut edges
};

/// The half of a mesh in front of a plane, as a mesh of its own.
///
/// Neighbours share the vertices of the edges that are cut, vertices that no face uses are left
/// out, and faces keep colour, material and named part, but no look and no picture. A cap takes
/// colour and material from the first face that was cut in its loop. The other half is that in
/// front of plane.flipped(). Shape:   vertices keep their order, and new ones follow. Faces keep
/// their order, too. Caps come
///          last, and so belong to the last named part.
/// Expects: mesh.is_valid(); convex faces. Caps are right for a closed mesh whose cut has no loop
///          inside another.
/// Cost:    memory for one entry per cut edge.
L3D_PUBLIC l3d_polygon_mesh l3d_cut_mesh(const l3d_polygon_mesh& mesh,
                                         const l3d_plane<double>& plane,
                                         l3d_cut_end end = l3d_cut_end::open);

/// The direction that is upwards in a model.
enum class L3D_PUBLIC l3d_model_up {
    y, ///< as in most files
    z, ///< as in 3D Studio's and Videoscape's
};

/// Turns right-handed axes into left-handed ones with y up, so that the model is no mirror image: y
/// and z change places, or z is negated if y is up already. The corners of each face are reversed,
/// so that its outside stays the outside.
L3D_PUBLIC void l3d_turn_left_handed(l3d_polygon_mesh& mesh, l3d_model_up up = l3d_model_up::z);

/// The sum of the areas of all faces. Expects: mesh.is_valid(). Units: world units squared.
L3D_PUBLIC double l3d_area(const l3d_polygon_mesh& mesh);

#endif
