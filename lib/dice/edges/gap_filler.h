// SPDX-License-Identifier: MIT
// Fills the slit between a piece's own boundary row and the polyline along which neighbours meet.
#ifndef L3D_DICE_EDGES_GAP_FILLER_H
#define L3D_DICE_EDGES_GAP_FILLER_H

#include "dice/edges/edge_polyline.h"

#include <cstddef>
#include <span>

/// A vertex of a piece's boundary row, at parameter t of the edge along which the row lies.
struct l3d_boundary_point {
    double t = 0;
    l3d_clip_vertex vertex;
    float side = 1; ///< 1, or -1 to negate the slit's light up to the next vertex
};

/// Adds triangles that fill the slit between `row` and the stretch of `edge` beside it.
///
/// Row and edge are polylines with vertices on the same curve of the surface. A triangle joins two
/// neighbouring vertices of one polyline with a vertex of the other, so it spans at most one step.
/// The triangle errs no more than the chord of that step, so filling adds nothing to the error
/// bound. The row may begin or end between two points of the edge. Such an end vertex also belongs
/// to the neighbouring piece. That piece continues the fan of triangles around the edge's last
/// point before the vertex. If `is_border`, the edge joins the part's border, for anti-aliasing.
/// Shape:   row in order of rising t, at least two points.
/// Expects: every t of `row` within [0, 1]; if is_border, a part without a grid.
void l3d_fill_gap(std::span<const l3d_boundary_point> row, const l3d_edge_polyline& edge,
                  const l3d_dice_view& view, l3d_diced_piece& out, bool is_border = false);

/// Fills the slit along a whole side of a piece's grid, without clipping. The side lies along the
/// edge from t0 to t1.
///
/// First the grid's row takes over vertices of the edge that stand for the same points. These
/// vertices are the ends of strips, and all vertices of strips with as many steps as the edge has.
/// At strips with as many steps, the slit is empty. The row keeps its normals, and the slit's
/// triangles use the row's normals. If the grid shows both sides, a triangle shows the same side as
/// the quad beside it. Triangles that hold no pixel's centre are left out, unless the view keeps
/// them (`keep.centreless`) or has trims.
/// Shape:   side as in l3d_edge_polylines; piece.u or piece.v and the grid's blocks are written.
/// Expects: the edge has strips. If an end of the row lies between the edge's own ends, the row's
///          end is at the exact place that both neighbours compute. The edge's points near such an
///          end may be balanced.
/// Cost:    some 150 instructions for a triangle that is left out, and 500 for one that is drawn.
///          No allocation once there is memory for the most triangles.
void l3d_close_side(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                    const l3d_dice_view& view, double t0 = 0, double t1 = 1);

/// Adds the stretch of an edge from t0 to t1 to the part's border, which anti-aliasing
/// searches for outlines. Each segment belongs to the quad of the grid's side whose range of
/// parameters holds the segment's middle. Triangles between grid and edge count as part of these
/// quads. If an edge reaches behind the near plane, only its part in front of that plane counts.
/// Expects: l3d_close_side or l3d_fill_gap was called for this side. Their expectations hold here.
/// Cost:    some 5 ns a point.
void l3d_note_outline_edge(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                           const l3d_dice_view& view, double t0 = 0, double t1 = 1);

#endif
