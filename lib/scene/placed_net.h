// SPDX-License-Identifier: MIT
// Control nets in homogeneous image space, computed in lanes from a model's own.
#ifndef L3D_SCENE_PLACED_NET_H
#define L3D_SCENE_PLACED_NET_H

#include "geom/matrix.h"
#include "geom/normal_net.h"
#include "geom/step_bound.h"

/// A patch's control points in the picture, as (x, y, w): rows 0, 1 and 3 of to_image times (point,
/// 1).
///
/// Each point has the same bits as if it were placed alone. So points that two patches share are
/// equal in both results.
/// Cost: some 25 ns.
l3d_image_patch l3d_placed_net(const l3d_matrix<double>& to_image,
                               const l3d_bezier_patch<double, 3>& patch);

/// A normal net whose vectors are multiplied by the upper left three by three of a matrix. The
/// product is scaled so that its largest component is 1. If the matrix holds the cofactors of an
/// affine map, the result is the normal net of the patch that the map moves.
/// Expects: a matrix that can be inverted.
/// Cost:    some 500 instructions.
l3d_normal_net l3d_placed_normals(const l3d_matrix<double>& by, const l3d_normal_net& normals);

#endif
