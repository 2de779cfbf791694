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

    /// Two chords meet.
    struct joint {
        l3d_point_2d at;
        l3d_point_2d ends, begins; ///< directions of the first and of the second
        double shortest;           ///< the shorter length
        l3d_join join;
    };

    void find_chords(const std::vector<pen_point>& points, bool closed);
    bool add_chord(const pen_point& from, l3d_point_2d leaves, const pen_point& to);
    void add_dot(l3d_point_2d at, l3d_point_2d along);
    /// A side of the pen: the left one of travel, or the right one, from its begin to its end.
    using side = std::vector<l3d_point_2d>;

    void add_ends(l3d_point_2d at, l3d_point_2d direction);
    void add_joint(const chord& before, const chord& after);
    void add_left(const joint& j, side& to);
    void add_outside(const joint& j, double sine, double cosine, side& to);
    void add_cap(l3d_point_2d at, l3d_point_2d arrives);
    /// Finds points near the circle about (0, 0), from the direction (1, 0) on.
    void find_turns(double angle, std::vector<l3d_point_2d>& turns) const;
    /// Adds the points of a circle about `center`, from the direction `left` on.
    static void add_arc(l3d_point_2d center, l3d_point_2d left,
                        const std::vector<l3d_point_2d>& turns, side& to);
    void end_outline(side& outline);

    /// The point beside a joint, in the middle between the left of both chords.
    static l3d_point_2d between(const joint& j, double scale) {
        return {j.at.x + scale * (j.ends.y + j.begins.y), j.at.y - scale * (j.ends.x + j.begins.x)};
    }
    l3d_point_2d beside(l3d_point_2d p, l3d_point_2d direction) const {
        return {p.x + radius_ * direction.y, p.y - radius_ * direction.x};
    }

    const l3d_stroke& pen_;
    l3d_path& result_;
    double radius_, most_angle_;
    double least_cosine_; ///< cosine of most_angle_
    double most_turn_;    ///< the largest turn between points of an arc
    std::vector<chord> chords_;
    side left_, right_; ///< the outline that is being made
    std::vector<l3d_point_2d> turns_;
    std::vector<l3d_point_2d> half_turn_; ///< arc of all round caps; empty before the first one
};

} // namespace l3d_detail

#endif
