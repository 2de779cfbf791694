// SPDX-License-Identifier: MIT
// l3d_edge_polyline: the one polyline that all patches sharing an edge meet along.
#ifndef L3D_DICE_EDGES_EDGE_POLYLINE_H
#define L3D_DICE_EDGES_EDGE_POLYLINE_H

#include "scene/dice_view.h"
#include "dice/near_clip.h"
#include "raster/surface_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {
struct edge_strips;
}

/// The polyline at which all patches that share an edge end. An edge is a patch boundary, or a line
/// along which a patch was cut.
///
/// The points depend on the edge's four control points and the view alone, not on a patch. So both
/// neighbours compute the same bits, even if one runs along the edge backwards. Each neighbour
/// fills the slit between its own boundary row and this polyline.
/// Shape: points in order of rising t, from 0 to 1, one array for each component.
/// Cost:  at most 32 points a strip; an edge that needs more is cut. 150 ns for an edge of 24
///        points that needs no clipping and is made with three others (AVX-512).
class l3d_edge_polyline {
public:
    /// Builds four polylines at once: lines[k] from edges[k]. The points of edges[k] have the share
    /// shares[k] of the view's errors.
    /// Expects: the view's near plane is no farther than the near plane of points with the least
    ///          share (l3d_dice_view::near_of).
    static void build(std::span<l3d_edge_polyline, 4> lines,
                      const std::array<l3d_image_curve, 4>& edges, const l3d_dice_view& view,
                      const std::array<double, 4>& shares = {1, 1, 1, 1});

    /// Builds the polyline of one edge. The points are the same as if four polylines were built at
    /// once. Building four at once takes less than four times as long.
    void build(const l3d_image_curve& edge, const l3d_dice_view& view);

    /// Makes this polyline from the polylines of its edge's two halves. The halves are sides of
    /// smaller patches beyond the edge.
    /// Expects: `first` ends where `second` begins; both were built for this view.
    void join(const l3d_edge_polyline& first, const l3d_edge_polyline& second,
              const l3d_dice_view& view);

    /// Reserves as much memory as `other` has. Then this polyline allocates for no edge for which
    /// `other` has enough memory.
    void reserve_as(const l3d_edge_polyline& other);

    std::size_t size() const { return size_; }
    const double* t() const { return t_.data(); }
    const std::int32_t* x() const { return x_.data(); }
    const std::int32_t* y() const { return y_.data(); }
    const float* inv_w() const { return inv_w_.data(); }

    /// Point i in the form that clipping takes, without parameters and normal.
    l3d_clip_vertex clip_vertex(std::size_t i, const l3d_dice_view& view) const;

    /// The largest number of equal parts into which an edge is cut, so that 32 steps a strip are
    /// enough.
    static constexpr std::size_t most_parts = 16;
    /// The number of equal parts into which this edge is cut, mostly 1.
    std::size_t parts() const { return parts_; }

    /// Where the strips of a part begin, as indices of the edge's points. A part has one strip, or
    /// four strips of equal length, as a patch has. The number of strips is 0 if some points of the
    /// edge cannot be drawn.
    const l3d_block_starts& strips(std::size_t part = 0) const { return strips_[part]; }

    /// The strips of the part that runs from t0 to t1; null if no part does.
    const l3d_block_starts* strips_between(double t0, double t1) const {
        const double part = t0 * static_cast<double>(parts_);
        return (t1 - t0) * static_cast<double>(parts_) == 1 && part == std::floor(part)
                   ? &strips_[static_cast<std::size_t>(part)]
                   : nullptr;
    }

    /// The index of the last point at or before t.
    std::size_t point_before(double t) const {
        if (t >= 1)
            return size_ - 1;
        const double* first = t_.data();
        return static_cast<std::size_t>(std::upper_bound(first, first + size_ - 1, t) - first) - 1;
    }

    /// The certified error of the visible segments in the picture, in two parts. The first is the
    /// error of chords between exact points, the second the error of the points themselves. bound()
    /// is their sum. Units: pixels.
    double chord_error() const { return chord_error_; }
    double vertex_error() const { return vertex_error_; }
    double bound() const { return chord_error_ + vertex_error_; }

private:
    void give_room(l3d_detail::edge_strips& to, std::size_t part = 0);
    void take(const l3d_detail::edge_strips& strips, const l3d_image_curve& edge,
              const l3d_dice_view& view, double share);
    bool take_parts(const l3d_image_curve& edge, const l3d_dice_view& view);
    bool join(std::span<const l3d_image_curve> parts, const l3d_dice_view& view);
    void cut(const l3d_image_curve& edge, const l3d_dice_view& view);
    void add_strip(const l3d_image_curve& strip, double t0, double t1, int level,
                   const l3d_dice_view& view);
    void add_point(const l3d_image_point& h, double t, const l3d_dice_view& view);
    void reverse();

    std::size_t size_ = 0;
    /// The parameters; arrays t_, x_, y_ and inv_w_ may have more than size_ numbers.
    std::vector<double> t_;
    std::vector<std::int32_t> x_, y_;
    std::vector<float> inv_w_;

    // The homogeneous points of edges without strips, and whether each can be drawn.
    std::vector<l3d_image_point> h_;
    std::vector<unsigned char> drawable_;

    std::size_t parts_ = 1;
    std::array<l3d_block_starts, most_parts> strips_;
    double chord_error_ = 0, vertex_error_ = 0;
};

#endif
