// SPDX-License-Identifier: MIT
// Whether patches enclose a body whose inside cannot be seen from outside.
#ifndef L3D_SCENE_CLOSED_BODY_H
#define L3D_SCENE_CLOSED_BODY_H

#include "scene/culling/facing_cones.h"
#include "scene/sides/halved_sides.h"
#include "geom/bezier_patch.h"

#include <span>

/// 1 if the patches are proven to be the whole surface of a body, with normals dS/du x dS/dv that
/// point out of it; -1 if these point into it. 0 if the proof fails.
///
/// The proof has two parts. Every edge that is not collapsed into a point is an edge of exactly one
/// other patch, with the same control points in the opposite direction; halves of an edge may be
/// edges of two. So the surface has no boundary. Every block of the surface turns the same side to
/// one point, the middle of the body's box. So a ray from there crosses the surface always in the
/// same direction, hence once: the body is star-shaped, and does not cut itself.
/// Shape:   as many cones as patches.
int l3d_orientation_of(std::span<const l3d_bezier_patch<double, 3>> patches,
                       std::span<const l3d_facing_cones> cones,
                       std::span<const l3d_halved_side> halved = {});

#endif
