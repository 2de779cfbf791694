// SPDX-License-Identifier: MIT
// l3d_shared_polyline: the one polyline at which all trimmed faces of an edge end; and the strip
// between it and a face's own border.
#ifndef L3D_DICE_EDGES_SHARED_POLYLINES_H
#define L3D_DICE_EDGES_SHARED_POLYLINES_H

#include "dice/near_clip.h"
#include "geom/matrix.h"
#include "geom/trims/trim_region.h"
#include "scene/dice_view.h"
#include "scene/sides/shared_edges.h"

#include <cstddef>
#include <vector>

/// A corner of a strip in the picture, with z = 0, and in space, in pixels times w. It may be one
/// that clipping cuts off.
struct l3d_strip_corner {
    l3d_vector<double, 3> picture, space;

    l3d_strip_corner(const l3d_clip_vertex& at, const l3d_dice_view& view);
};

/// Points of an edge of a model, a function of the edge and the view alone.
///
/// In the picture and the margin around it, no chord is longer than l3d_longest_shared_chord, and
/// the edge is within l3d_shared_chord_error() of its chords.
/// Shape: points in order of rising t; chord i ends at point i.
/// Cost:  kept for its memory.
struct l3d_shared_polyline {
    std::vector<double> t; ///< the edge's parameters
    std::vector<l3d_clip_vertex> points;
    std::vector<l3d_strip_corner> corners;  ///< the points as they are drawn
    std::vector<l3d_drawn_distance> chords; ///< how far the edge may be off; infinite if unknown
    double off_px = 0; ///< how far the edge is off its faces where it may be seen

    void make(const l3d_shared_edge& edge, const l3d_matrix<double>& to_image,
              const l3d_dice_view& view);
};

/// Chords and strips that cross the near plane are measured as far as here.
inline double l3d_measured_near(const l3d_dice_view& view) {
    return view.near / 2;
}

/// How far chords of a shared polyline may be from the edge: a quarter of the tolerance.
inline double l3d_shared_chord_error(const l3d_dice_view& view) {
    return view.tolerance / 4;
}

/// A point of a face's own border, with the light of the face in `normal` of its vertex.
struct l3d_border_point {
    l3d_clip_vertex at;
    double t = 0; ///< the parameter of the edge that the border follows
};

/// The drawable vertex of a border as a point that clipping can take.
l3d_border_point l3d_border_point_of(const l3d_dice_vertex& at, double t,
                                     const l3d_dice_view& view);

/// Adds the triangles between a part of a face's border and the part of the polyline beside it.
///
/// A point of the polyline belongs to the border's part that ends at its parameter or has it
/// within. The last point at or before it is the polyline's point of a border point. So parts of a
/// border that share an end share a side there, whoever makes them. Triangles have the light of the
/// border at the same parameter. With anti-aliasing, chords join the part's border.
void l3d_add_strip(const l3d_shared_polyline& line, const l3d_border_point& from,
                   const l3d_border_point& to, const l3d_dice_view& view, l3d_diced_piece& piece);

/// The largest distance from an edge of the points of a strip that the picture may show.
///
/// It is measured at the drawn corners, and holds wherever these are (docs/NUMERICS.md, section
/// 27). It is infinite if a corner cannot be drawn.
/// Shape: the strip lies between a b and the polyline's points `first` to `last`.
l3d_drawn_distance l3d_strip_error(const l3d_shared_polyline& line, std::size_t first,
                                   std::size_t last, const l3d_clip_vertex& a,
                                   const l3d_clip_vertex& b, const l3d_dice_view& view);

#endif
