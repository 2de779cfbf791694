// SPDX-License-Identifier: MIT
// Fills the slit between a piece's own boundary row and the polyline along which neighbours meet.
#ifndef L3D_DICE_EDGES_GAP_FILLER_H
#define L3D_DICE_EDGES_GAP_FILLER_H

#include "dice/edges/edge_polyline.h"

#include <cstddef>
#include <span>

/// A vertex of a piece's boundary row, at parameter t of the edge it lies along.
struct l3d_boundary_point {
    double t = 0;
    l3d_clip_vertex vertex;
    float side = 1; ///< factor of the corners' light in the slit from here to the next vertex
};

/// Adds triangles that fill the slit between `row` and the stretch of `edge` beside it.
///
/// Both are polylines with vertices on the same curve of the surface. A triangle joins two
/// neighbouring vertices of one with a vertex of the other, so it spans at most one step. Its error
/// is that of the step's chord, so filling adds nothing to the error bound. The row may start or
/// end between two points of the edge. Then the fan from the edge point before goes on in the
/// neighbouring piece, which shares the row's end vertex. With anti-aliasing, the edge is noted in
/// the part's border if it `is_border`.
/// Shape:   row in order of rising t, at least two points.
/// Expects: every t of `row` within [0, 1]; if it is_border, a part without a grid.
void l3d_fill_gap(std::span<const l3d_boundary_point> row, const l3d_edge_polyline& edge,
                  const l3d_dice_view& view, l3d_diced_piece& out, bool is_border = false);

/// Fills the slit along a whole side of the piece's grid, without clipping. The side lies along the
/// edge from t0 to t1.
///
/// First the row takes over the edge's vertices where both stand for the same points: at the ends
/// of strips, and in strips with as many steps as the edge. There the slit is empty. The row's
/// normals stay, and triangles use them. If the grid shows both sides, a triangle shows the same
/// one as the quad beside it. Triangles that hold no pixel's centre are left out, unless the view
/// keeps what is centreless or has trims.
/// Shape:   side as in l3d_edge_polylines; piece.u or piece.v and the grid's blocks are written.
/// Expects: the edge has strips. An end of the row between the edge's own ends is at the exact
///          place that both neighbours compute. The edge's points there may be balanced.
/// Cost:    some 150 instructions for a triangle that is left out, and 500 for another one. No
///          allocation once there is memory for the most triangles.
void l3d_close_side(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                    const l3d_dice_view& view, double t0 = 0, double t1 = 1);

/// Adds the stretch of an edge from t0 to t1 to the part's border. Each segment lies beside the
/// quad of the grid's side that has the parameter of its middle. Triangles between grid and edge
/// count as these quads do. An edge that reaches behind the near plane counts as far as it lies
/// before the plane.
/// Expects: as l3d_close_side or l3d_fill_gap, which came before.
/// Cost:    some 5 ns a point.
void l3d_note_outline_edge(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                           const l3d_dice_view& view, double t0 = 0, double t1 = 1);

#endif
