// SPDX-License-Identifier: MIT
// l3d_moveable: something that flies: a place, three axes of its own, and a motion; and
// l3d_camera_left_handed, the camera of the book's programs, which flies.
#ifndef L3D_PIPELINE_WORLDS_CAMERA_LEFT_HANDED_H
#define L3D_PIPELINE_WORLDS_CAMERA_LEFT_HANDED_H

#include "base/public.h"
#include "geom/transform.h"
#include "scene/camera.h"
#include "tool_2d/pixels.h"

/// The rate that the book's programs are made for. Their motion per update is the library's motion
/// per 1/60 s. Units: updates a second.
inline constexpr double l3d_book_rate = 60;

/// A place with three axes of its own. A push moves it along one of them, and a turn is about one.
///
/// Motion is given per second, and damped: after a push the speed falls off exponentially. The
/// distance flown in any time is the exact integral of the speed. So flights end in the same place
/// at any frame rate. At l3d_book_rate they are the book's, except that the book turns by whole
/// degrees.
/// Shape: left-handed: right x up = forward, up x forward = right, forward x right = up; the book
///        calls them VRI, VUP and VFW, and the place VRP.
/// Units: world units, degrees, seconds; a turn is clockwise for a person at whom its axis points.
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

    /// Adds `thrust` to the velocity along each axis, as one press of a key does: `times` is +1 or
    /// -1 along an axis, 0 otherwise. A velocity that has reached its limit (90 units per update in
    /// the book) stays.
    void push(const by_axis& times);
    /// Adds to the spin about each axis, as push() does to the velocity. The limit is 95 degrees
    /// per update in the book.
    void twist(const by_axis& times);

    /// Turns at once about the axis right(). Units: degrees.
    void turn_about_right(double degrees);
    /// Turns at once about the axis up(). Units: degrees.
    void turn_about_up(double degrees);
    /// Turns at once about the axis forward(). Units: degrees.
    void turn_about_forward(double degrees);

    /// Sets the axes: forward() points along `forward`, and up() is the direction perpendicular to
    /// it that is nearest to `up`. Both may have any length.
    /// Errors:  false, and nothing changes, if one is zero or both lie on a line.
    bool set_axes(const vector& forward, const vector& up);

    /// Turns so that forward() points from the place to `target`; `up` is used as by set_axes().
    /// Errors: false, and nothing changes, if a direction is zero or both lie on a line.
    bool look_at(const point& target, const vector& up = point::of(0, 1, 0).from_origin) {
        return set_axes(target - place, up);
    }

    /// Transforms the place and the axes by a matrix.
    /// Errors: false, and nothing changes, if the matrix leaves no axes.
    bool transform(const l3d_matrix<T>& m);

    /// Flies on. A subclass that moves otherwise overrides it. Expects: seconds >= 0.
    /// Cost:    one turn about each axis that spins; the axes are made perpendicular and of length
    ///          1 again, so that no rounding adds up.
    virtual void update(double seconds);

    /// Whether update() changes anything. A subclass that overrides update() overrides this, too.
    virtual bool moves() const;

    /// The matrix from world coordinates to those along the three axes, with the place as origin.
    l3d_matrix<T> viewing_transform() const;
    /// The matrix from coordinates along the three axes, with the place as origin, to the world's.
    l3d_matrix<T> inverse_viewing_transform() const;

private:
    void fly(double seconds);
    void straighten();
    void spin_by(double share);

    vector right_ = point::of(1, 0, 0).from_origin;
    vector up_ = point::of(0, 1, 0).from_origin;
    vector forward_ = point::of(0, 0, 1).from_origin;
};

/// The book's term for a field of view: the distance of a window from the eye over its width. It is
/// half the cotangent of half the angle. Units: degrees.
L3D_PUBLIC double l3d_fov_term(double degrees);
/// The angle that has this term: the inverse of l3d_fov_term. Units: degrees.
L3D_PUBLIC double l3d_fov_degrees(double term);

/// A perspective camera in a left-handed world: x right, y up, z away from the viewer.
///
/// Units:   fovx and fovy are terms of l3d_fov_term, for the picture's width and height; near_z and
///          far_z are distances along the view axis.
/// Expects: fovx, fovy > 0; 0 < near_z < far_z.
template <class T> class L3D_PUBLIC l3d_camera_left_handed : public l3d_moveable<T> {
public:
    /// A camera for pictures of this size. It sees 100 degrees of width, about as a human eye;
    /// pixels are squares.
    explicit l3d_camera_left_handed(l3d_size size);

    /// Fields of view along x and y, as terms of l3d_fov_term.
    double fovx, fovy;
    /// The least and the largest distance that is drawn, in world units.
    double near_z = 5.5, far_z = 500;

    /// Adapts fovy to a new size of the picture, so that squares stay squares.
    void change_size(l3d_size from, l3d_size to);

    /// Turns as if a hand dragged the world. Things in the middle of a picture of this size move by
    /// `right` and `down` pixels.
    void drag(double right, double down, l3d_size size);

    /// A place in the picture, whose centre is (width / 2, height / 2); y is down.
    struct pixel {
        /// From the picture's left and top, in pixels.
        double x, y;
    };
    /// The place of a point in a picture of this size. Expects: p[2] > 0.
    pixel project(const l3d_point<T>& p, l3d_size size) const;
};

/// The l3d_camera that shows the same picture. Its world is the left-handed one with z reversed:
/// the point (x, y, z) of that world is (x, y, -z) for l3d_camera.
///
/// l3d_camera samples at the centre of a pixel, 1/2 beyond the book's place in x and y.
/// Expects: square pixels: fovx * width = fovy * height.
template <class T> L3D_PUBLIC l3d_camera l3d_right_handed(const l3d_camera_left_handed<T>& camera);

#endif
