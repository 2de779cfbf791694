// SPDX-License-Identifier: MIT
// l3d_polygon_view: how a model of polygons is placed and seen in a frame, and what a place of the
// picture shows.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_VIEW_H
#define L3D_PIPELINE_POLYGONS_POLYGON_VIEW_H

#include "base/public.h"
#include "geom/matrix.h"
#include "pipeline/polygons/polygon_model.h"
#include "raster/surface_rasterizer.h"
#include "scene/camera.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

/// The order in which a model is turned about the world's axes, the first one first.
enum class L3D_PUBLIC l3d_rotation_order { xyz, xzy, yxz, yzx, zxy, zyx };

/// The matrix that turns about the three axes, one after the other. The centre stays where it is.
/// Units: degrees about x, y and z, counterclockwise for a person at whom the axis points.
L3D_PUBLIC l3d_matrix<double>
l3d_euler_rotation(const l3d_vector<double, 3>& degrees, const l3d_vector<double, 3>& centre,
                   l3d_rotation_order order = l3d_rotation_order::xyz);

/// The fit of a camera's picture to the pixels.
struct L3D_PUBLIC l3d_picture_fit {
    /// Factor by which widths of the picture are stretched against heights.
    /// Expects: > 0.
    double stretch = 1;
    /// The distance by which the picture is moved to the right and down. Units: pixels.
    double shift = 0;
};

/// The rule by which a view's points get their depths: 1 / distance, or base + step * distance in a
/// parallel projection, where `step` is not 0.
/// Units: distances along the view axis.
struct L3D_PUBLIC l3d_view_depths {
    /// The numbers of the rule, as in l3d_shading.
    double base = 0, step = 0;

    /// The depth of a point of the picture, from its d and w by l3d_polygon_view::matrix.
    double at(double d, double w) const { return step == 0 ? 1 / w : base + step * d; }
};

/// The matrix of a frame, from the model to the picture, and all else that depends on the view.
///
/// Shape:   matrix() takes model (x, y, z, 1) to (x, y, d, w). The pixel is the picture's centre
///          plus (x / w, y / w). d is the distance along the view axis. w is d in perspective,
///          else 1.
/// Expects: a valid camera; a placement that turns, moves and perhaps mirrors, and keeps
///          lengths.
class L3D_PUBLIC l3d_polygon_view {
public:
    /// A place or a direction.
    using vector = l3d_vector<double, 3>;

    /// The view of a model that stands at `placement`, in a picture of that size.
    l3d_polygon_view(const l3d_camera& camera, l3d_size size, const l3d_matrix<double>& placement,
                     const l3d_picture_fit& fit = {});

    /// From the model to the picture: (x, y, d, w).
    const l3d_matrix<double>& matrix() const { return matrix_; }
    /// From the model to the world.
    const l3d_matrix<double>& placement() const { return placement_; }
    /// The camera of the view.
    const l3d_camera& camera() const { return camera_; }
    /// The picture's width and height, in pixels.
    l3d_size size() const { return size_; }
    /// Whether the projection is parallel: far things do not look smaller.
    bool is_parallel() const { return camera_.is_parallel(); }

    /// Positive if the eye sees a plane's front, the side that its normal points to. The sign is
    /// that of the dot product of the normal and eye - point, all in model space.
    double faces_eye(const vector& normal, const vector& point) const {
        return is_parallel() ? -l3d_dot(normal, forward_) : l3d_dot(normal, eye_ - point);
    }

    /// Whether all planes of a group certainly show their fronts or, if `front` is false, their
    /// backs. The group has normals within `spread` of `axis` and points within `reach` of
    /// `middle`.
    /// Expects: normals of length 1 or 0.
    bool all_face(const vector& axis, double spread, const vector& middle, double reach,
                  bool front) const;

    /// The depths of things in a ball of model space. In a parallel projection they are 2 at the
    /// ball's nearest and 1 at its farthest point.
    /// Expects: radius >= 0.
    l3d_view_depths depths(const vector& middle, double radius) const;

    /// The shading for rasterizers, with the light in world space. Its rays are zero, so that
    /// rasterizers turn no normal round: the plane of a face decides which side is seen. Near an
    /// outline, smooth normals point away from the eye in some pixels, and are right as they are.
    l3d_shading shading(l3d_shade mode, const vector& light,
                        const l3d_lighting& lighting = {}) const;

private:
    l3d_camera camera_;
    l3d_size size_;
    l3d_picture_fit fit_;
    l3d_matrix<double> placement_, matrix_;
    vector eye_, forward_; ///< in model space
};

/// The nearest point of a model's faces on the ray through a place of the picture.
///
/// Each error is the largest distance from the exact value, rounding included.
struct L3D_PUBLIC l3d_polygon_pick {
    std::size_t face = 0;                   ///< index in the mesh
    std::string part{};                     ///< its name; empty if the face belongs to none
    std::array<std::uint32_t, 3> corners{}; ///< vertices of the triangle of the face that is met
    std::array<double, 3> weights{};        ///< the point is the corners' mean with these weights
    double weights_error = 0;               ///< error of each weight

    l3d_camera::vector point{0.0, 0.0, 0.0}; ///< in the world
    double point_error = 0;                  ///< in world units
    double depth = 0;                        ///< distance along the view axis

    /// The triangle's unit normal in the world, turned to the eye.
    l3d_camera::vector normal{0.0, 0.0, 0.0};
    double normal_error = 0; ///< the length of the difference

    /// All values, a line each: name, value and error. Faces and vertices count from 0.
    std::string text() const;

    /// Face and point in one line.
    std::string line() const;
};

/// Finds the face that is seen at (x, y) of a picture. Nothing if the ray meets no face between the
/// near and the far plane. Faces that turn their back are not met if `culls`; nor are faces without
/// an area.
///
/// Units:   pixels from the picture's left upper corner; a pixel's middle is at 1/2.
/// Expects: finite x and y.
/// Cost:    some 20 ns for each triangle.
L3D_PUBLIC std::optional<l3d_polygon_pick> l3d_polygon_pick_at(const l3d_polygon_model& model,
                                                               const l3d_polygon_view& view,
                                                               bool culls, double x, double y);

#endif
