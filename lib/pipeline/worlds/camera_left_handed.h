// SPDX-License-Identifier: MIT
// l3d_camera_left_handed: the camera of the book's programs, which flies.
#ifndef L3D_PIPELINE_WORLDS_CAMERA_LEFT_HANDED_H
#define L3D_PIPELINE_WORLDS_CAMERA_LEFT_HANDED_H

#include "base/public.h"
#include "tool_2d/pixels.h"
#include "scene/camera.h"
#include "pipeline/worlds/moveable.h"

/// The book's term for a field of view: the distance of a window from the eye over its width. It is
/// half the cotangent of half the angle. Units: degrees.
L3D_PUBLIC double l3d_fov_term(double degrees);
/// The angle that has this term: the inverse of l3d_fov_term. Units: degrees.
L3D_PUBLIC double l3d_fov_degrees(double term);

/// A perspective camera in a left-handed world: x right, y up, z away from the viewer.
///
/// Units:   fovx and fovy are terms as of l3d_fov_term, of the picture's width and height; near_z
///          and far_z are distances along the view axis.
/// Expects: fovx, fovy > 0; 0 < near_z < far_z.
template <class T> class L3D_PUBLIC l3d_camera_left_handed : public l3d_moveable<T> {
public:
    /// 100 degrees wide, about what a human eye sees; pixels are squares.
    explicit l3d_camera_left_handed(l3d_size size);

    /// Fields of view along x and y, as terms of l3d_fov_term.
    double fovx, fovy;
    /// The least and the largest distance that is drawn, in world units.
    double near_z = 5.5, far_z = 500;

    /// Follows the picture's new shape: squares stay squares.
    void change_size(l3d_size from, l3d_size to);

    /// Turns as if a hand moved the world: things in the middle of a picture of this size move so
    /// many pixels to the right and down.
    void drag(double right, double down, l3d_size size);

    /// A point's place in the picture, whose centre is (width / 2, height / 2); y is down. Expects:
    /// p[2] > 0.
    struct pixel {
        /// From the picture's left and top, in pixels.
        double x, y;
    };
    /// The place of a point in a picture of this size. Expects: p[2] > 0.
    pixel project(const l3d_point<T>& p, l3d_size size) const;
};

/// The same view of the same world seen through our camera, whose world is this one with z
/// reversed. A point (x, y, z) here is (x, y, -z) there, and pictures are alike.
///
/// A pixel's centre is where our camera samples, 1/2 beyond the book's in x and y.
/// Expects: square pixels: fovx * width = fovy * height.
template <class T> L3D_PUBLIC l3d_camera l3d_right_handed(const l3d_camera_left_handed<T>& camera);

#endif
