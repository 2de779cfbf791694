// SPDX-License-Identifier: MIT
// l3d_moveable: something that flies: a place, three axes of its own, and a motion; and
// l3d_camera_left_handed, the camera of the book's programs, which flies.
#ifndef L3D_PIPELINE_WORLDS_CAMERA_LEFT_HANDED_H
#define L3D_PIPELINE_WORLDS_CAMERA_LEFT_HANDED_H

#include "base/public.h"
#include "geom/transform.h"
#include "scene/camera.h"
#include "tool_2d/pixels.h"

/// The rate of updates that the book's programs are made for. The book's motion per update is this
/// library's motion per 1/60 s. Units: updates per second.
inline constexpr double l3d_book_rate = 60;

/// A thing that flies, such as a camera: a place with three axes of its own, and a motion. push()
/// adds speed along the axes, and twist() adds turning about them.
///
/// Motion is given per second, and damped: after a push the speed falls off exponentially. The
/// distance flown in any time is the exact integral of the speed. So flights end in the same place
/// at any frame rate. At l3d_book_rate, flights are those of the book, except that the book turns
/// by whole degrees.
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
    /// Takes the place, axes and motion of another object.
    l3d_moveable& operator=(const l3d_moveable&) = default;
    virtual ~l3d_moveable() = default;

    /// One number for each of the three axes.
    struct by_axis {
        /// The number for motion along, or turning about, the axis of this name.
        double right = 0, up = 0, forward = 0;
    };

    point place = point::of(50, 5, 50); ///< the thing's place in the world, in world units

    /// The speed along each axis. Units: world units per second.
    by_axis velocity;
    by_axis spin; ///< the speed of turning about each axis, in degrees per second

    /// The velocity that one push adds along each axis: 0.2 units per update in the book.
    by_axis thrust{0.2 * l3d_book_rate, 0.2 * l3d_book_rate, 0.2 * l3d_book_rate};

    /// The axis that points to the right, a unit vector in the world.
    const vector& right() const { return right_; }
    /// The axis that points upwards, a unit vector in the world.
    const vector& up() const { return up_; }
    /// The axis that points forward, a unit vector in the world.
    const vector& forward() const { return forward_; }

    /// Adds the product of `times` and `thrust` to the velocity along each axis. For a press of a
    /// key, `times` is +1 or -1 for one axis, and 0 for the two other axes. A velocity of 90 units
    /// per update of the book, or more, is not increased further.
    void push(const by_axis& times);
    /// Adds to the spin about each axis `times` times 5 degrees per update of the book. A spin of
    /// 95 degrees per update, or more, is not increased further.
    void twist(const by_axis& times);

    /// Turns at once about the axis right(). Units: degrees.
    void turn_about_right(double degrees);
    /// Turns at once about the axis up(). Units: degrees.
    void turn_about_up(double degrees);
    /// Turns at once about the axis forward(). Units: degrees.
    void turn_about_forward(double degrees);

    /// Sets the axes: forward() points along `forward`, and up() is the direction perpendicular to
    /// forward() that is nearest to `up`. Both vectors may have any length.
    /// Errors:  returns false, and changes nothing, if a vector is zero or both lie on one line.
    bool set_axes(const vector& forward, const vector& up);

    /// Turns the axes so that forward() points from the place to `target`; `up` means the same as
    /// for set_axes().
    /// Errors: returns false, and changes nothing, if one of the two directions is zero, or if both
    ///         lie on one line.
    bool look_at(const point& target, const vector& up = point::of(0, 1, 0).from_origin) {
        return set_axes(target - place, up);
    }

    /// Transforms the place and the axes by a matrix.
    /// Errors: returns false, and changes nothing, if the transformed axes do not define three
    ///         perpendicular ones, such as zero vectors.
    bool transform(const l3d_matrix<T>& m);

    /// Flies on for this time. A subclass with another way of motion overrides this function.
    /// Expects: seconds >= 0.
    /// Cost:    one turn about each axis that spins; the axes are made perpendicular and of length
    ///          1 again, so that no rounding adds up.
    virtual void update(double seconds);

    /// Whether update() would change anything. A subclass that overrides update() overrides this
    /// function, too.
    virtual bool moves() const;

    /// The matrix from world coordinates to coordinates along the three axes, with the place as
    /// origin.
    l3d_matrix<T> viewing_transform() const;
    /// The inverse of viewing_transform(): the matrix from coordinates along the three axes, with
    /// the place as origin, to world coordinates.
    l3d_matrix<T> inverse_viewing_transform() const;

private:
    void fly(double seconds);
    void straighten();
    void spin_by(double share);

    vector right_ = point::of(1, 0, 0).from_origin;
    vector up_ = point::of(0, 1, 0).from_origin;
    vector forward_ = point::of(0, 0, 1).from_origin;
};

/// The book's term for a field of view: the distance from the eye to the picture, divided by the
/// picture's width. This is half the cotangent of half the angle. Units: degrees.
L3D_PUBLIC double l3d_fov_term(double degrees);
/// The angle of a field of view for which the book has this term: the inverse of l3d_fov_term.
/// Units: degrees.
L3D_PUBLIC double l3d_fov_degrees(double term);

/// The camera of the book's programs: a perspective camera that flies in a left-handed world. At
/// first x points right, y up, and z away from the viewer.
///
/// Units:   fovx and fovy are terms as l3d_fov_term returns them, for the picture's width and
///          height. near_z and far_z are distances along the view axis.
/// Expects: fovx, fovy > 0; 0 < near_z < far_z.
template <class T> class L3D_PUBLIC l3d_camera_left_handed : public l3d_moveable<T> {
public:
    /// Makes a camera for pictures of this size. Its field of view is 100 degrees wide, about that
    /// of a human eye, and pixels are squares.
    explicit l3d_camera_left_handed(l3d_size size);

    /// Fields of view along x and y, as terms of l3d_fov_term.
    double fovx, fovy;
    /// The least and the largest distance at which things are drawn, in world units.
    double near_z = 5.5, far_z = 500;

    /// Adapts fovy when the picture's size changes from `from` to `to`, so that squares still look
    /// like squares.
    void change_size(l3d_size from, l3d_size to);

    /// Turns the camera as if a hand dragged the world: things in the middle of a picture of this
    /// size move by `right` and `down` pixels.
    void drag(double right, double down, l3d_size size);

    /// A place in the picture. The picture's centre is (width / 2, height / 2), and y points down.
    struct pixel {
        /// Distances from the picture's left and top border, in pixels.
        double x, y;
    };
    /// The place in a picture of this size of a point in the camera's coordinates
    /// (viewing_transform). Expects: p[2] > 0.
    pixel project(const l3d_point<T>& p, l3d_size size) const;
};

/// The l3d_camera that shows the same picture as the book's camera. Its world is the book's with z
/// reversed: the point (x, y, z) of the left-handed world is (x, y, -z) for l3d_camera.
///
/// l3d_camera samples a pixel at its centre, 1/2 pixel to the right of and below the book's place.
/// Expects: square pixels: fovx * width = fovy * height.
template <class T> L3D_PUBLIC l3d_camera l3d_right_handed(const l3d_camera_left_handed<T>& camera);

#endif
