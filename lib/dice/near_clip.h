// SPDX-License-Identifier: MIT
// Clips triangles that reach behind the near plane or far beyond the window.
#ifndef L3D_DICE_NEAR_CLIP_H
#define L3D_DICE_NEAR_CLIP_H

#include "scene/dice_view.h"
#include "dice/diced_piece.h"

/// A vertex for clipping: a surface point that may be anywhere, even behind the eye.
struct l3d_clip_vertex {
    l3d_image_point h{0.0, 0.0, 0.0};
    l3d_dice_vertex dice; ///< the vertex in the picture; valid only if `drawable`
    bool drawable = false;
    bool away = false; ///< whether the normal points away from the eye
};

/// Whether a homogeneous point can be drawn. It must lie between the near and the far plane, inside
/// the guard band, and on the kept side of a section.
bool l3d_drawable(const l3d_image_point& h, const l3d_dice_view& view);

/// Makes a vertex of a homogeneous point. The corners of all pieces are projected by this function,
/// so neighbours get the same places.
l3d_clip_vertex l3d_canonical_vertex(const l3d_image_point& h, const l3d_dice_view& view);

/// Adds to `out`, as triangles, the part of triangle a b c that can be drawn.
///
/// A drawable corner keeps its vertex bit for bit. A new corner on the edge p q depends on p and q
/// alone, whatever their order. So triangles that share an edge still fit together. With
/// anti-aliasing, new sides in the near plane, the far plane or the plane of a section become
/// borders of out.part, if it has no grid.
/// Source: Sutherland, Hodgman, Reentrant Polygon Clipping, CACM 17, 1974, in homogeneous space.
void l3d_clip_triangle(const l3d_clip_vertex& a, const l3d_clip_vertex& b, const l3d_clip_vertex& c,
                       const l3d_dice_view& view, l3d_diced_piece& out);

/// Clips the straight line from a to b to the part that can be drawn. Returns false if no part can
/// be drawn.
bool l3d_clip_segment(l3d_clip_vertex& a, l3d_clip_vertex& b, const l3d_dice_view& view);

#endif
