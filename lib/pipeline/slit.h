// SPDX-License-Identifier: MIT
// Filling the slit between a piece's own boundary row and the polyline its neighbours meet along.
#ifndef L3D_PIPELINE_SLIT_H
#define L3D_PIPELINE_SLIT_H

#include "pipeline/edge_polyline.h"

#include <span>
#include <vector>

/// A vertex of a piece's boundary row, at parameter t of the edge it lies along.
struct l3d_boundary_point {
    double t = 0;
    l3d_clip_vertex vertex;
    /// Sign of the signed area, y down, that the piece's quads have here: negative shows the
    /// front. A slit has no side of its own, so its triangles are turned to agree. 0: unknown.
    int facing = 0;
};

/// Appends triangles that fill the slit between `row` and the stretch of `edge` beside it.
///
/// Both are polylines with vertices on the same curve of the surface. A triangle joins two
/// neighbours of one with one of the other, so its vertices span at most one step, and it is as
/// far off as that step's chord: filling adds nothing to the error bound. Where the row starts or
/// ends between two points of the edge, the fan from the edge point below goes on in the
/// neighbouring piece, which shares the row's end vertex.
/// Shape:   row in order of rising t, at least two points.
/// Expects: every t of `row` within [0, 1].
void l3d_fill_slit(std::span<const l3d_boundary_point> row, const l3d_edge_polyline& edge,
                   const l3d_dice_view& view, std::vector<l3d_dice_vertex>& triangles);

#endif
