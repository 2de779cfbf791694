// SPDX-License-Identifier: MIT
// l3d_moveable: something that flies: a place, three axes of its own, and a motion.
#ifndef L3D_PIPELINE_WORLDS_MOVEABLE_H
#define L3D_PIPELINE_WORLDS_MOVEABLE_H

#include "base/public.h"
#include "geom/transform.h"

/// The rate that the book's programs are made for: their motion per update is ours per 1/60 s.
/// Units: updates a second.
inline constexpr double l3d_book_rate = 60;

/// A place with three axes of its own; each push is along one of them, and each turn about one.
///
/// Motion is damped, and given per second: after a push the speed falls off exponentially, and the
/// way made good in any time is its exact integral. So flights end in the same place at any frame
/// rate; at l3d_book_rate they are the book's, but for its whole degrees.
/// Shape:   left-handed: right x up = forward, up x forward = right, forward x right = up; the book
///          calls them VRI, VUP and VFW, and the place VRP.
/// Units:   world units, degrees, seconds; a turn is clockwise for one who sees its axis come at
///          him.
template <class T> class L3D_PUBLIC l3d_moveable {
public:
    /// A place in the world.
    using point = l3d_point<T>;
    /// A direction in the world.
    using vector = l3d_vector<T, 3>;

    l3d_moveable() = default;
    /// Copies the place, the axes and the motion.
    l3d_moveable(const l3d_moveable&) = default;
    /// Takes the other one's place, axes and motion.
    l3d_moveable& operator=(const l3d_moveable&) = default;
    virtual ~l3d_moveable() = default;

    /// Numbers that belong to the three axes.
    struct by_axis {
        /// Along or about each axis; positive forward, up and to the right.
        double right = 0, up = 0, forward = 0;
    };

    point place = point::of(50, 5, 50); ///< where it is, in world units

    /// Units: per second.
    by_axis velocity;
    by_axis spin; ///< degrees per second about each axis

    /// The velocity that one push adds along each axis: 0.2 units per update in the book.
    by_axis thrust{0.2 * l3d_book_rate, 0.2 * l3d_book_rate, 0.2 * l3d_book_rate};

    /// The axis that points to its right, a unit vector in the world.
    const vector& right() const { return right_; }
    /// The axis that points upwards, a unit vector in the world.
    const vector& up() const { return up_; }
    /// The axis that points forward, a unit vector in the world.
    const vector& forward() const { return forward_; }

    /// One press of a key: `times` is +1 or -1 along or about an axis, 0 otherwise. A velocity that
    /// has reached its limit (90 units, 95 degrees per update in the book) stays.
    void push(const by_axis& times);
    /// As push, but turns: `times` is about each axis.
    void twist(const by_axis& times);

    /// Turns at once. Units: degrees.
    void turn_about_right(double degrees);
    /// Turns at once about the axis up(). Units: degrees.
    void turn_about_up(double degrees);
    /// Turns at once about the axis forward(). Units: degrees.
    void turn_about_forward(double degrees);

    /// Sets the axes: forward() points along `forward`, and up() is the direction perpendicular to
    /// it that is nearest to `up`. Both may have any length.
    /// Errors:  false, and nothing changes, if one is zero or both lie on a line.
    bool set_axes(const vector& forward, const vector& up);

    /// Turns so that forward() points from the place to `target`; `up` is as of set_axes.
    /// Errors:  as set_axes.
    bool look_at(const point& target, const vector& up = point::of(0, 1, 0).from_origin) {
        return set_axes(target - place, up);
    }

    /// Moves the place by a matrix, and turns the axes by it.
    /// Errors:  false, and nothing changes, if the matrix leaves no axes.
    bool transform(const l3d_matrix<T>& m);

    /// Flies on. A subclass that moves otherwise overrides it. Expects: seconds >= 0.
    /// Cost:    one turn about each axis that spins; the axes are made perpendicular and of length
    ///          1 again, so that no rounding adds up.
    virtual void update(double seconds);

    /// Whether update() changes anything. A subclass that overrides that overrides this, too.
    virtual bool moves() const;

    /// From the world to the three axes with the place as origin.
    l3d_matrix<T> viewing_transform() const;
    /// From the three axes with the place as origin to the world.
    l3d_matrix<T> inverse_viewing_transform() const;

private:
    void fly(double seconds);
    void straighten();
    void spin_by(double share);

    vector right_ = point::of(1, 0, 0).from_origin;
    vector up_ = point::of(0, 1, 0).from_origin;
    vector forward_ = point::of(0, 0, 1).from_origin;
};

#endif
