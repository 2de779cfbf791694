// SPDX-License-Identifier: MIT
// l3d_edge_polyline: the one polyline that all patches sharing an edge meet along.
#ifndef L3D_PIPELINE_EDGE_POLYLINE_H
#define L3D_PIPELINE_EDGE_POLYLINE_H

#include "geom/bezier_curve.h"
#include "pipeline/dice_view.h"
#include "pipeline/near_clip.h"

#include <vector>

/// A point of an edge polyline, at parameter t of the edge.
struct l3d_edge_point {
    double t = 0;
    l3d_clip_vertex vertex;
};

/// Points of an edge (a patch boundary, or a line along which a patch was cut).
///
/// The points are a function of the edge's four control points and the view alone, not of the
/// patch: both neighbours compute the same bits, also if one runs along it backwards. Each
/// neighbour fills the slit between its own boundary row and this polyline.
/// Cost: at most 32 points a strip; strips halve where that is too coarse.
class l3d_edge_polyline {
public:
    template <class Wide>
    void build(const l3d_bezier_curve<Wide, 3>& edge, const l3d_dice_view& view);

    /// In order of rising t, from 0 to 1.
    const std::vector<l3d_edge_point>& points() const { return points_; }

    /// Certified image error of the visible segments, in pixels: that of chords between exact
    /// points, and what the points' own errors add.
    double chord_error() const { return chord_error_; }
    double vertex_error() const { return vertex_error_; }
    double bound() const { return chord_error_ + vertex_error_; }

private:
    template <class Wide>
    void add_strip(const l3d_bezier_curve<Wide, 3>& strip, double t0, double t1, int level,
                   const l3d_dice_view& view);
    template <class Wide>
    void add_point(const l3d_vector<Wide, 3>& h, double t, const l3d_dice_view& view);

    std::vector<l3d_edge_point> points_;
    double chord_error_ = 0, vertex_error_ = 0;
};

/// A homogeneous point as a vertex: the one way in which corners and edge points become pixels.
template <class Wide>
l3d_clip_vertex l3d_canonical_vertex(const l3d_vector<Wide, 3>& h, const l3d_dice_view& view);

#endif
