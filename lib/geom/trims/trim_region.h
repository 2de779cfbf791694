// SPDX-License-Identifier: MIT
// l3d_trim_region: the part of a patch's parameters that trims leave. Its loops are polygons, and
// lines cut it.
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

/// Says which edge of the model a side of a polygon follows, and the edge's parameters at the ends
/// of the side.
struct l3d_trim_use {
    std::uint32_t edge = l3d_no_edge;
    double from = 0, to = 0;

    /// The edge's parameter at a place of the side: `part` is 0 at the side's beginning, 1 at its
    /// end.
    double at(double part) const { return part >= 1 ? to : from + (to - from) * part; }
};

/// A corner of a polygon, and the edge that the side from this corner to the next follows, if any.
struct l3d_trim_corner : l3d_trim_place {
    l3d_trim_use side{};
};

/// A closed polygon in the plane of parameters.
using l3d_trim_polygon = std::vector<l3d_trim_corner>;

/// A rectangle of parameters.
struct l3d_trim_box {
    l3d_trim_place least{0, 0}, most{1, 1};
};

/// A region in the plane of parameters, bounded by polygons. The odd rule says whether a place is
/// inside: polygons count that wind around the place an odd number of times. If their number is
/// odd, the place is inside.
struct l3d_trim_region {
    std::vector<l3d_trim_polygon> polygons;

    bool is_empty() const { return polygons.empty(); }
    /// Whether the region is the whole box, as far as its polygons show without a search: each is
    /// the box itself, and their number is odd.
    bool is_all_of(const l3d_trim_box& box) const;
    /// Whether the region is empty, as far as its polygons show without a search: each is the box
    /// itself, and their number is even. For instance, both the outer polygon and a hole's polygon
    /// become the box in a hole.
    bool is_none_of(const l3d_trim_box& box) const;
    /// Whether a place is inside.
    bool contains(const l3d_trim_place& at) const;

    /// Whether any side follows an edge.
    bool follows_edges() const;

    /// Cuts the region at a line of equal u (along = 0) or equal v (along = 1), and returns the
    /// parts below and above the line. Both parts have the same corners on the line, bit for bit,
    /// and the same parameters of edges at these corners. Only a corner that touches the line from
    /// one side has no partner in the other part.
    std::array<l3d_trim_region, 2> halves(std::size_t along, double at) const;
    /// The part of the region in a box.
    l3d_trim_region within(const l3d_trim_box& box) const;
    /// The region in the box's own parameters, which run from 0 to 1 each way.
    /// Expects: the region lies in the box.
    l3d_trim_region in_box(const l3d_trim_box& box) const;

    /// The stretches of a line of equal u (along = 0) or equal v (along = 1) at which the region
    /// lies, on either side of the line.
    /// Shape: first and last value of each stretch, in order; stretches do not touch.
    std::vector<std::array<double, 2>> stretches(std::size_t along, double at) const;
};

/// Sorts stretches, and joins those that touch.
void l3d_join_stretches(std::vector<std::array<double, 2>>& stretches);

/// Turns loops of curves into polygons, adds the polygons to `to`, and returns the largest distance
/// in space between a loop and its polygon. No point of a loop or polygon is farther than `wanted`
/// from the other line.
/// Shape:  `lengths` are upper bounds of the length in space of a unit of u and of v.
/// Source: the convex hull of control points; halving by de Casteljau's scheme.
double l3d_flat_trims(std::span<const l3d_trim_loop> loops, const l3d_trim_place& lengths,
                      double wanted, l3d_trim_region& to);

/// How far polygons are off their loops, in space.
struct l3d_flatness {
    double off = 0;   ///< the largest distance, except for chords where any distance was permitted
    double share = 0; ///< the largest ratio of a distance to the wanted distance at its place
};
/// Turns loops into polygons as the function above does, but with a wanted distance for each part
/// of a curve: wanted(box) gives the distance for the part in a box. Where the wanted distance is
/// infinite, the part becomes one chord, whose own distance does not count.
l3d_flatness l3d_flat_trims(std::span<const l3d_trim_loop> loops, const l3d_trim_place& lengths,
                            const std::function<double(const l3d_trim_box&)>& wanted,
                            l3d_trim_region& to);

/// Bounds the share that the control points between a rational curve's ends have in any point of
/// the curve. If these control points are off the chord by some distance, the curve is off by at
/// most this share of the distance. Among equal weights, the ends have a share of at least 2^(1 -
/// n), where n is the degree.
double l3d_share_between(std::size_t points, double lightest_end, double heaviest_between);

/// Bounds how far a curve is from the chord between its ends, in space. Shape: as l3d_flat_trims.
double l3d_off_chord(const l3d_trim_curve& curve, const l3d_trim_place& lengths);

/// Finds the loops that matter for the piece of a surface in a box, in the box's own parameters
/// from 0 to 1. In the box, these loops leave the same places as all loops of the surface do.
/// Expects: loops without a complaint.
std::vector<l3d_trim_loop> l3d_trims_in(std::span<const l3d_trim_loop> loops,
                                        const l3d_trim_box& box);

/// The error message for invalid loops, as l3d_trims_complaint gives it. Unlike there, a curve need
/// not begin where the curve before ends.
std::string l3d_trim_curves_complaint(std::span<const l3d_trim_loop> loops);

/// Turns loops of a surface that is closed along u, v or both into closed loops of the plane of u
/// and v. The closed loops leave the same places of the box. A curve may end at one side of the box
/// where the next begins at the other. Curves may go on beyond the box.
///
/// A loop may go around the surface, and so come back at the other side. Such a loop keeps the part
/// on its left, if u runs to the right and v upwards. If several loops go around, the loop with the
/// least v decides, or the loop with the least u if they go along v.
/// Errors: nothing, and the reason in `why`: as l3d_trims_complaint; for a loop that goes around
///         twice; for loops around both ways.
std::optional<std::vector<l3d_trim_loop>> l3d_unrolled(std::span<const l3d_trim_loop> loops,
                                                       const l3d_trim_box& box,
                                                       const std::array<bool, 2>& is_closed,
                                                       std::string& why);

/// Whether a surface closes on itself along u, and whether along v.
std::array<bool, 2> l3d_closed_ways(const l3d_nurbs_surface& surface);

/// The border of a box, as a loop that trims.
l3d_trim_loop l3d_trim_around(const l3d_trim_box& box);

/// The ranges of a direction's parameter between different knots: one for each Bezier piece.
std::vector<std::array<double, 2>> l3d_spans_of(const l3d_bspline_direction& d);

#endif
