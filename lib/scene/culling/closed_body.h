// SPDX-License-Identifier: MIT
// Whether patches enclose a body whose inside cannot be seen from outside.
#ifndef L3D_SCENE_CLOSED_BODY_H
#define L3D_SCENE_CLOSED_BODY_H

#include "scene/culling/facing_cones.h"
#include "scene/sides/halved_sides.h"
#include "geom/bezier_patch.h"

#include <span>

/// Finds out whether patches are the whole surface of a body, and to which side their normals
/// point. Returns 1 if the patches are proven to be the whole surface, and normals dS/du x dS/dv
/// point out of the body. Returns -1 if the patches are proven to be the whole surface, and normals
/// point into the body. Returns 0 if the proof fails.
///
/// First, every edge must be an edge of exactly one other patch, with the same control points in
/// the opposite direction. Or two smaller patches may lie beyond an edge, each along a half of the
/// edge. Edges that are collapsed into a point do not count. So the surface has no boundary.
/// Second, every block of the surface must turn the same side to the middle of the body's box. So a
/// ray from the middle crosses the surface always in the same direction, hence once. The body is
/// star-shaped, and does not cut itself.
/// Shape:   as many cones as patches; `halved` has the sides of patches that meet two smaller
///          patches.
int l3d_orientation_of(std::span<const l3d_bezier_patch<double, 3>> patches,
                       std::span<const l3d_facing_cones> cones,
                       std::span<const l3d_halved_side> halved = {});

#endif
