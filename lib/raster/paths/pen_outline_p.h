// SPDX-License-Identifier: MIT
// pen_outline: outlines the area that a pen covers along a chain of chords.
#ifndef L3D_RASTER_PATHS_PEN_OUTLINE_P_H
#define L3D_RASTER_PATHS_PEN_OUTLINE_P_H

#include "raster/paths/path.h"

#include <cstddef>
#include <vector>

namespace l3d_detail {

/// An end of a chord of a path that is stroked.
struct pen_point {
    l3d_point_2d at;
    bool smooth = false; ///< whether two chords of one curve meet in this point
    /// The unit directions of the curve that ends here, and of the curve that begins here. (0, 0)
    /// means the chord's direction.
    l3d_point_2d arrives{}, leaves{};
};

/// Adds to a path the outline of a pen that runs along chains of chords: one outline for each
/// chain, or two if the chain is closed.
///
/// An outline is the sum of a rectangle for each chord and a wedge for each joint, all wound in the
/// same direction. Therefore, the outline passes through the joint itself on the joint's inner
/// side. So the winding number of each covered place is 1 or more, also where chords overlap.
class pen_outline {
public:
    pen_outline(const l3d_stroke& pen, l3d_path& result);

    /// Adds a chain's outline. If all points are the same, a square cap has sides along the
    /// direction `along`.
    void add(const std::vector<pen_point>& points, bool closed, l3d_point_2d along = {1, 0});

private:
    /// A chord from a point to the next point at another place.
    struct chord {
        l3d_point_2d from, to;
        double length;
        /// Directions of the path at the chord's beginning and end. There, the pen is square to
        /// these directions.
        l3d_point_2d begins, ends;
        bool smooth; ///< whether the chord's beginning lies within a curve
    };

    /// The place where two chords meet.
    struct joint {
        l3d_point_2d at;
        /// The path's directions at the end of the first chord and at the beginning of the second
        /// chord.
        l3d_point_2d ends, begins;
        double shortest; ///< the length of the shorter chord
        l3d_join join;
    };

    void find_chords(const std::vector<pen_point>& points, bool closed);
    bool add_chord(const pen_point& from, l3d_point_2d leaves, const pen_point& to);
    void add_dot(l3d_point_2d at, l3d_point_2d along);
    /// The points of one side of the pen, on the left or on the right of its way, from begin to
    /// end.
    using side = std::vector<l3d_point_2d>;

    void add_ends(l3d_point_2d at, l3d_point_2d direction);
    void add_joint(const chord& before, const chord& after);
    bool add_flat_joint(const chord& before, const chord& after);
    void add_left(const joint& j, side& to);
    void add_outside(const joint& j, double sine, double cosine, side& to);
    void add_cap(l3d_point_2d at, l3d_point_2d arrives);
    /// Finds points near the unit circle around (0, 0), over an angle from the direction (1, 0) on.
    void find_turns(double angle, std::vector<l3d_point_2d>& turns) const;
    /// Adds the points of a circle around `center`, from the direction `left` on.
    static void add_arc(l3d_point_2d center, l3d_point_2d left,
                        const std::vector<l3d_point_2d>& turns, side& to);
    void end_outline(side& outline);

    /// A point on the left of a joint. It is away from the joint by the sum of the unit vectors to
    /// the left of both chords, times `scale`.
    static l3d_point_2d between(const joint& j, double scale) {
        return {j.at.x + scale * (j.ends.y + j.begins.y), j.at.y - scale * (j.ends.x + j.begins.x)};
    }
    l3d_point_2d beside(l3d_point_2d p, l3d_point_2d direction) const {
        return {p.x + radius_ * direction.y, p.y - radius_ * direction.x};
    }

    const l3d_stroke& pen_;
    l3d_path& result_;
    double radius_, most_angle_;
    double least_cosine_; ///< the cosine of most_angle_
    double most_turn_;    ///< the largest turn between points of an arc
    std::vector<chord> chords_;
    side left_, right_; ///< both sides of the pen along the present outline
    std::vector<l3d_point_2d> turns_;
    /// Points of the arc of round caps; empty before the first cap.
    std::vector<l3d_point_2d> half_turn_;
};

} // namespace l3d_detail

#endif
