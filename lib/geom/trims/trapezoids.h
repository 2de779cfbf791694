// SPDX-License-Identifier: MIT
// l3d_trapezoids: cuts a region into trapezoids between lines of equal v.
#ifndef L3D_GEOM_TRAPEZOIDS_H
#define L3D_GEOM_TRAPEZOIDS_H

#include "geom/trims/trim_region.h"

#include <cstddef>
#include <span>
#include <vector>

/// A trapezoid of a region, between two lines of equal v.
///
/// Shape: `low` and `high` are the values of u of the points on the lower and the upper side, in
///        rising order. Each side has at least one point. `left` and `right` name the edges that
///        the left and the right side follow, upwards.
struct l3d_trapezoid {
    double low_v = 0, high_v = 0;
    std::span<const double> low, high;
    l3d_trim_use left{}, right{};
    /// Indices of the polygons' sides that bound the trapezoid on the left and on the right.
    std::size_t left_side = 0, right_side = 0;
};

/// Cuts a region into trapezoids that meet without T-junctions on their low and high sides. If a
/// corner of one trapezoid lies on such a side of another, it is also a point of that side. On the
/// left and right sides, neighbouring trapezoids have corners of their own.
///
/// Polygons may cross themselves and each other.
/// Cost: time in proportion to the number of corners, times the number of sides that a line of
///       equal v meets. Memory is kept for reuse.
class l3d_trapezoids {
public:
    /// Calls visit(l3d_trapezoid) for each trapezoid of a region.
    template <class Visit> void of(const l3d_trim_region& region, const Visit& visit) {
        begin(region);
        while (next_line())
            for (const ended& one : ended_)
                visit(l3d_trapezoid{one.low_v, v_, std::span(pool_).subspan(one.low, one.low_count),
                                    std::span(marks_).subspan(one.high, one.high_count),
                                    sides_[one.left].use_between(one.low_v, v_),
                                    sides_[one.right].use_between(one.low_v, v_), one.left,
                                    one.right});
    }

private:
    /// A side of a polygon, directed upwards. This side may also be the left side of one open
    /// trapezoid.
    struct side {
        l3d_trim_place low, high;
        l3d_trim_use use{};
        /// The right side of the trapezoid whose left side this is.
        std::size_t right = none;
        std::size_t next_right = none;
        double low_v = 0;
        /// The range of this trapezoid's low points in pool_.
        std::size_t first_low = 0, low_count = 0;

        double at(double v) const;
        l3d_trim_use use_between(double from_v, double to_v) const;
    };
    struct ended {
        double low_v;
        std::size_t low, low_count, high, high_count, left, right;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    void begin(const l3d_trim_region& region);
    bool next_line();
    double order_until(double next);
    void pair_up(double next);
    void end_and_begin();

    double v_ = 0;
    std::vector<side> sides_;             ///< the polygons' sides, in the order of their low v
    std::vector<l3d_trim_place> corners_; ///< the polygons' corners, in the order of v, then of u
    std::size_t next_side_ = 0, next_corner_ = 0, first_corner_ = 0;
    double next_v_ = 0;
    bool is_begun_ = false;
    std::vector<std::size_t> active_;   ///< the sides that cross the line v_, from left to right
    std::vector<std::size_t> open_;     ///< left sides of trapezoids that are open below v_
    std::vector<std::size_t> new_open_; ///< left sides of trapezoids that are open above v_
    std::vector<double> marks_, pool_, keys_;
    std::vector<ended> ended_;
};

#endif
