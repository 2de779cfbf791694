// SPDX-License-Identifier: MIT
// The part of a parameter rectangle that trimming loops leave: loops as polygons, cut at lines.
#ifndef L3D_GEOM_TRIM_REGION_H
#define L3D_GEOM_TRIM_REGION_H

#include "geom/files/patch_file.h"
#include "geom/nurbs_surface.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// A place in the plane of parameters. Shape: u, v.
using l3d_trim_place = std::array<double, 2>;

/// The edge of the model that a side of a polygon follows, and the edge's parameters at the ends of
/// the side.
struct l3d_trim_use {
    std::uint32_t edge = l3d_no_edge;
    double from = 0, to = 0;

    /// The edge's parameter at a part of the side.
    double at(double part) const { return part >= 1 ? to : from + (to - from) * part; }
};

/// A corner of a polygon, and what the side from here to the next corner follows.
struct l3d_trim_corner : l3d_trim_place {
    l3d_trim_use side{};
};

/// A closed polygon of parameters.
using l3d_trim_polygon = std::vector<l3d_trim_corner>;

/// A rectangle of parameters.
struct l3d_trim_box {
    l3d_trim_place least{0, 0}, most{1, 1};
};

/// The part of a plane of parameters that polygons bound, by the odd rule: a point is inside if the
/// polygons that wind around it an odd number of times are odd in number.
struct l3d_trim_region {
    std::vector<l3d_trim_polygon> polygons;

    bool is_empty() const { return polygons.empty(); }
    /// Whether each polygon has the box's four corners alone, and they leave all of the box.
    bool is_all_of(const l3d_trim_box& box) const;
    /// The same if they leave nothing, as the outer polygon does in a hole.
    bool is_none_of(const l3d_trim_box& box) const;
    /// Whether a place is inside.
    bool contains(const l3d_trim_place& at) const;

    /// Whether a side follows an edge.
    bool follows_edges() const;

    /// Cuts the region at a line of equal u (along = 0) or equal v (along = 1), and returns the
    /// parts below and above the line. Both parts have the same corners on the line, bit for bit,
    /// and the same parameters of edges there.
    /// Corners that touch the line from one side alone are an exception.
    std::array<l3d_trim_region, 2> halves(std::size_t along, double at) const;
    /// The part in a box.
    l3d_trim_region within(const l3d_trim_box& box) const;
    /// The region in the box's own parameters, which run from 0 to 1 each way.
    /// Expects: the region lies in the box.
    l3d_trim_region in_box(const l3d_trim_box& box) const;

    /// The stretches of a line of equal u (along = 0) or equal v (along = 1) that touch the region
    /// from below or from above.
    /// Shape: first and last value of each stretch, in order; stretches do not touch.
    std::vector<std::array<double, 2>> stretches(std::size_t along, double at) const;
};

/// Sorts stretches, and joins those that touch.
void l3d_join_stretches(std::vector<std::array<double, 2>>& stretches);

/// Turns loops into polygons. Each polygon is no farther from its loop in space than `wanted`, nor
/// is the loop from it. Returns the largest such distance.
/// Shape: `lengths` are the most that a unit of u, and of v, is long in space.
/// Source: the convex hull of control points; halving by de Casteljau's scheme.
double l3d_flat_trims(std::span<const l3d_trim_loop> loops, const l3d_trim_place& lengths,
                      double wanted, l3d_trim_region& to);

/// How far polygons are off their loops.
struct l3d_flatness {
    double off = 0;   ///< the largest distance that counts
    double share = 0; ///< the largest distance by what is wanted for it
};
/// The same with a distance of its own for each part of a curve: wanted(box) has it for the part in
/// a box. Where it is infinite, no distance counts.
l3d_flatness l3d_flat_trims(std::span<const l3d_trim_loop> loops, const l3d_trim_place& lengths,
                            const std::function<double(const l3d_trim_box&)>& wanted,
                            l3d_trim_region& to);

/// The largest share that the control points between a rational curve's ends have of any of its
/// points: the ends have 2^(1 - n) at least among equal weights, where n is the degree.
double l3d_share_between(std::size_t points, double lightest_end, double heaviest_between);

/// How far a curve may be from the chord between its ends, in space. Shape: as l3d_flat_trims.
double l3d_off_chord(const l3d_trim_curve& curve, const l3d_trim_place& lengths);

/// The loops that the piece in a box needs, in the box's own parameters from 0 to 1. In the box,
/// they leave the same places as all loops of the surface.
/// Expects: loops without a complaint.
std::vector<l3d_trim_loop> l3d_trims_in(std::span<const l3d_trim_loop> loops,
                                        const l3d_trim_box& box);

/// As l3d_trims_complaint, but curves need not begin where others end.
std::string l3d_trim_curves_complaint(std::span<const l3d_trim_loop> loops);

/// Loops of a surface that is closed along u, v or both, as closed loops of the plane that leave
/// the same places of the box. A curve may end at one side of the box where the next begins at the
/// other, and curves may go on beyond the box.
///
/// A loop that goes around the surface, and so comes back at the other side, leaves what is on its
/// left if u runs to the right and v upwards. If several go around, that of the least v (or u, if
/// they go along v) decides.
/// Errors: nothing, and the loop at fault in `why`: as l3d_trims_complaint, for loops that go
///         around twice, and for loops around both ways.
std::optional<std::vector<l3d_trim_loop>> l3d_unrolled(std::span<const l3d_trim_loop> loops,
                                                       const l3d_trim_box& box,
                                                       const std::array<bool, 2>& is_closed,
                                                       std::string& why);

/// Whether a surface comes back to where it began, along u and along v.
std::array<bool, 2> l3d_closed_ways(const l3d_nurbs_surface& surface);

/// The border of a box.
l3d_trim_loop l3d_trim_around(const l3d_trim_box& box);

/// The ranges of a direction's parameter between knots that differ: one for each Bezier piece.
std::vector<std::array<double, 2>> l3d_spans_of(const l3d_bspline_direction& d);

#endif
