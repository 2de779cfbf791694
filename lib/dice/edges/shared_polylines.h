// SPDX-License-Identifier: MIT
// l3d_shared_polyline: the one polyline at which all trimmed faces of an edge end. Also the strip
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

/// A corner of a strip, in the picture and in space, for measuring how far the strip is from its
/// edge. The place in the picture has z = 0. The place in space is in pixels times w. The corner
/// may lie in a part of the strip that clipping cuts off.
struct l3d_strip_corner {
    l3d_vector<double, 3> picture, space;

    l3d_strip_corner(const l3d_clip_vertex& at, const l3d_dice_view& view);
};

/// The polyline at which all trimmed faces at an edge of a model end, so that no gap shows between
/// them. The polyline depends on the edge and the view alone.
///
/// In the picture and the margin around it, no chord is longer than l3d_longest_shared_chord, and
/// the edge is within l3d_shared_chord_error() of its chords.
/// Shape: points in order of rising t; chord i ends at point i.
/// Cost:  kept for its memory.
struct l3d_shared_polyline {
    std::vector<double> t; ///< the edge's parameter at each point
    std::vector<l3d_clip_vertex> points;
    std::vector<l3d_strip_corner> corners; ///< the polyline's points, for measuring strips
    /// How far the edge may be off each chord; infinite if unknown.
    std::vector<l3d_drawn_distance> chords;
    double off_px = 0; ///< how far the edge is off its faces where it may be seen

    void make(const l3d_shared_edge& edge, const l3d_matrix<double>& to_image,
              const l3d_dice_view& view);
};

/// The least w at which chords and strips that cross the near plane are measured.
inline double l3d_measured_near(const l3d_dice_view& view) {
    return view.near / 2;
}

/// The largest allowed distance between an edge and the chords of its polyline. It is a quarter of
/// the tolerance.
/// Units: pixels.
inline double l3d_shared_chord_error(const l3d_dice_view& view) {
    return view.tolerance / 4;
}

/// A point of a face's own border, beside an edge of the model. The `normal` of its vertex holds
/// the light of the face.
struct l3d_border_point {
    l3d_clip_vertex at;
    double t = 0; ///< the edge's parameter at the place beside this point
};

/// Makes a border point of a drawable vertex. `t` is its parameter on the edge.
l3d_border_point l3d_border_point_of(const l3d_dice_vertex& at, double t,
                                     const l3d_dice_view& view);

/// Adds a strip to a piece. A strip is a row of triangles between a part of a face's border and the
/// part of the edge's polyline beside it. Strips close the gaps between faces that end at an edge.
///
/// The part of the border runs from `from` to `to`. The strip has the polyline's points from the
/// last point at or before from.t up to to.t. So the strips of two neighbouring parts of a border
/// share a side, whichever pieces make the strips. Triangles have the light of the border at the
/// same parameter. With anti-aliasing, the polyline's chords join the border of piece.part.
void l3d_add_strip(const l3d_shared_polyline& line, const l3d_border_point& from,
                   const l3d_border_point& to, const l3d_dice_view& view, l3d_diced_piece& piece);

/// Bounds how far any point of a strip that the picture may show is from its edge.
///
/// The bound follows from the drawn corners alone, wherever these are (docs/NUMERICS.md, section
/// 27). It is infinite if a corner is too near to the eye, or if the distance of the edge from a
/// chord is unknown.
/// Shape: the strip lies between the border a b and the polyline's points `first` to `last`.
l3d_drawn_distance l3d_strip_error(const l3d_shared_polyline& line, std::size_t first,
                                   std::size_t last, const l3d_clip_vertex& a,
                                   const l3d_clip_vertex& b, const l3d_dice_view& view);

#endif
