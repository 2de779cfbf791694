// SPDX-License-Identifier: MIT
// The part of a parameter rectangle that trimming loops leave: loops as polygons, cut at lines.
#ifndef L3D_GEOM_TRIM_REGION_H
#define L3D_GEOM_TRIM_REGION_H

#include "geom/files/patch_file.h"
#include "geom/nurbs_surface.h"

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

/// A place in the plane of parameters. Shape: u, v.
using l3d_trim_place = std::array<double, 2>;

/// A closed polygon of parameters.
using l3d_trim_polygon = std::vector<l3d_trim_place>;

/// A rectangle of parameters.
struct l3d_trim_box {
    l3d_trim_place least{0, 0}, most{1, 1};
};

/// Polygons of which an odd number winds around a point that is inside, each an odd number of
/// times.
struct l3d_trim_region {
    std::vector<l3d_trim_polygon> polygons;

    bool is_empty() const { return polygons.empty(); }
    /// Whether it is one polygon of four corners, those of the box.
    bool is_all_of(const l3d_trim_box& box) const;
    bool contains(const l3d_trim_place& at) const;

    /// The parts below and above a line of equal u (0) or v (1). Both have the same corners on that
    /// line, bit for bit, but for corners that merely touch it from the other side.
    std::array<l3d_trim_region, 2> halves(std::size_t along, double at) const;
    /// The part in a box.
    l3d_trim_region within(const l3d_trim_box& box) const;
    /// The same with the box from 0 to 1 each way. Expects: all lies in the box.
    l3d_trim_region in_box(const l3d_trim_box& box) const;

    /// The stretches, between two values, of a line of equal u (0) or v (1) beside which, below it
    /// or above it, the region lies. Shape: in order, apart.
    std::vector<std::array<double, 2>> stretches(std::size_t along, double at) const;
};

/// Loops as polygons. A unit of u is at most `length_u` long in space, one of v `length_v`. Each
/// polygon is no farther from its loop than `wanted`, nor the loop from it. Returns that distance.
/// Source: the convex hull of control points; halving by de Casteljau's scheme.
double l3d_flat_trims(std::span<const l3d_trim_loop> loops, const l3d_trim_place& lengths,
                      double wanted, l3d_trim_region& to);

/// The part of a surface's loops that the piece in a box needs, from 0 to 1 there. It winds around
/// places of the box an odd number of times where the loops do. Expects: loops without a complaint.
std::vector<l3d_trim_loop> l3d_trims_in(std::span<const l3d_trim_loop> loops,
                                        const l3d_trim_box& box);

/// The border of a box.
l3d_trim_loop l3d_trim_around(const l3d_trim_box& box);

/// The spans of a direction between different knots, within its range: those of the pieces.
std::vector<std::array<double, 2>> l3d_spans_of(const l3d_bspline_direction& d);

/// A trapezoid of a region. Shape: the sides `low` and `high` have equal v; their points have
/// rising u, and there may be one or more on each.
struct l3d_trapezoid {
    double low_v = 0, high_v = 0;
    std::span<const double> low, high;
};

/// Cuts a region into trapezoids that meet without a T: where a corner of one lies on the low or
/// high side of another, it is one of that side's points. Slanted and upright sides of neighbours
/// have corners of their own.
///
/// Polygons may cross themselves and each other.
/// Cost: time in proportion to the corners times the sides at one v; keeps its memory.
class l3d_trapezoids {
public:
    /// Calls visit(l3d_trapezoid) for each one.
    template <class Visit> void of(const l3d_trim_region& region, const Visit& visit) {
        begin(region);
        while (next_line())
            for (const ended& one : ended_)
                visit(l3d_trapezoid{one.low_v, v_, std::span(pool_).subspan(one.low, one.low_count),
                                    std::span(marks_).subspan(one.high, one.high_count)});
    }

private:
    /// A side of a polygon, upwards.
    struct side {
        l3d_trim_place low, high;
        std::size_t right = none; ///< the side at the other end of the trapezoid that it begins
        std::size_t next_right = none;
        double low_v = 0;
        std::size_t first_low = 0, low_count = 0; ///< in pool_

        double at(double v) const;
    };
    struct ended {
        double low_v;
        std::size_t low, low_count, high, high_count;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void begin(const l3d_trim_region& region);
    bool next_line();
    double order_until(double next);
    void pair_up(double next);
    void end_and_begin();

    double v_ = 0;
    std::vector<side> sides_;             ///< by their low v
    std::vector<l3d_trim_place> corners_; ///< by v, then u
    std::size_t next_side_ = 0, next_corner_ = 0, first_corner_ = 0;
    double next_v_ = 0;
    bool is_begun_ = false;
    std::vector<std::size_t> active_;   ///< sides at v_, from left to right
    std::vector<std::size_t> open_;     ///< left sides of trapezoids that go on
    std::vector<std::size_t> new_open_; ///< those from v_ on
    std::vector<double> marks_, pool_, keys_;
    std::vector<ended> ended_;
};

#endif
