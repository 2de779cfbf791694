// SPDX-License-Identifier: MIT
// pen_outline: the area of a pen along a chain of chords, as outlines wound clockwise.
#ifndef L3D_RASTER_PATHS_PEN_OUTLINE_P_H
#define L3D_RASTER_PATHS_PEN_OUTLINE_P_H

#include "raster/paths/path.h"

#include <cstddef>
#include <vector>

namespace l3d_detail {

/// An end of a chord.
struct pen_point {
    l3d_point_2d at;
    bool smooth = false; ///< two chords of one curve meet here
    /// The directions of a curve that ends here and of one that begins here, of length 1. (0, 0)
    /// means the chord's direction.
    l3d_point_2d arrives{}, leaves{};
};

/// Adds to a path, for each chain of chords, one outline, or two if the chain is closed.
///
/// Such an outline is the sum of a rectangle for each chord and a wedge for each joint, all wound
/// the same way. For that, it goes by way of the joint itself on a joint's inner side. So each
/// place that is covered is wound about once or more, never back to 0.
class pen_outline {
public:
    pen_outline(const l3d_stroke& pen, l3d_path& result);

    /// Adds a chain's outline. If all points are one, a square cap has sides along `along`.
    void add(const std::vector<pen_point>& points, bool closed, l3d_point_2d along = {1, 0});

private:
    /// A chord from a point to the next different one.
    struct chord {
        l3d_point_2d from, to;
        double length;
        l3d_point_2d begins, ends; ///< directions that the pen is square to
        bool smooth;               ///< whether its beginning lies within a curve
    };

    void find_chords(const std::vector<pen_point>& points, bool closed);
    bool add_chord(const pen_point& from, l3d_point_2d leaves, const pen_point& to);
    void add_dot(l3d_point_2d at, l3d_point_2d along);
    /// Adds the side left of the direction of travel, from the first chord's beginning to the last
    /// one's end.
    void add_side(bool closed);
    void add_joint(const chord& before, const chord& after);
    bool add_small_joint(const chord& before, const chord& after, double sine, double cosine);
    static l3d_point_2d between(const chord& before, const chord& after, double scale);
    void add_outer_joint(const chord& before, const chord& after, double sine, double cosine);
    void add_cap(const chord& last);
    /// Finds points near the circle about (0, 0), from the direction (1, 0) on.
    void find_turns(double angle, std::vector<l3d_point_2d>& turns) const;
    /// Adds the points of a circle about `center`, from the direction `left` on.
    void add_arc(l3d_point_2d center, l3d_point_2d left, const std::vector<l3d_point_2d>& turns);
    void add_point(l3d_point_2d p) { outline_.push_back(p); }
    void end_outline();
    void reverse();

    l3d_point_2d beside(l3d_point_2d p, l3d_point_2d direction) const {
        return {p.x + radius_ * direction.y, p.y - radius_ * direction.x};
    }

    const l3d_stroke& pen_;
    l3d_path& result_;
    double radius_, most_angle_;
    double least_cosine_; ///< cosine of most_angle_
    double most_turn_;    ///< the largest turn between points of an arc
    std::vector<chord> chords_;
    std::vector<l3d_point_2d> outline_; ///< the outline that is being made
    std::vector<l3d_point_2d> turns_;
    std::vector<l3d_point_2d> half_turn_; ///< arc of all round caps; empty before the first one
};

} // namespace l3d_detail

#endif
