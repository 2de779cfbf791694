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

/// The order in which a model is turned about the world's axes: xyz turns it about x first.
enum class L3D_PUBLIC l3d_rotation_order { xyz, xzy, yxz, yzx, zxy, zyx };

/// The matrix that turns about the three axes, one after the other. The point `centre` stays where
/// it is.
/// Units: degrees about x, y and z, counterclockwise for a person at whom the axis points.
L3D_PUBLIC l3d_matrix<double>
l3d_euler_rotation(const l3d_vector<double, 3>& degrees, const l3d_vector<double, 3>& centre,
                   l3d_rotation_order order = l3d_rotation_order::xyz);

/// How a camera's picture is fitted to the pixels: stretched and moved.
struct L3D_PUBLIC l3d_picture_fit {
    /// Factor by which widths of the picture are stretched against heights.
    /// Expects: > 0.
    double stretch = 1;
    /// The distance by which the picture is moved to the right and down. Units: pixels.
    double shift = 0;
};

/// The rule by which a view's points get their depths. In perspective, `step` is 0 and the depth is
/// 1 / distance. In a parallel projection, the depth is base + step * distance.
/// Units: distances along the view axis.
struct L3D_PUBLIC l3d_view_depths {
    /// The numbers of the rule, as in l3d_shading.
    double base = 0, step = 0;

    /// The depth of a point of the picture, from its d and w by l3d_polygon_view::matrix.
    double at(double d, double w) const { return step == 0 ? 1 / w : base + step * d; }
};

/// The view of a model in a frame: the matrix from the model to the picture, and all else that
/// depends on camera and placement.
///
/// Shape:   matrix() takes model (x, y, z, 1) to (x, y, d, w). The place in the picture is the
///          picture's centre plus (x / w, y / w), in pixels. d is the distance along the view axis.
///          w is d in perspective, else 1.
/// Expects: a valid camera; a placement that turns, moves and perhaps mirrors, and keeps lengths.
class L3D_PUBLIC l3d_polygon_view {
public:
    /// A place or a direction in model or world space.
    using vector = l3d_vector<double, 3>;

    /// The view of a model that stands in the world at `placement`, in a picture of this size.
    l3d_polygon_view(const l3d_camera& camera, l3d_size size, const l3d_matrix<double>& placement,
                     const l3d_picture_fit& fit = {});

    /// The matrix from model space to the picture's (x, y, d, w).
    const l3d_matrix<double>& matrix() const { return matrix_; }
    /// The matrix from model space to world space.
    const l3d_matrix<double>& placement() const { return placement_; }
    /// The camera of the view.
    const l3d_camera& camera() const { return camera_; }
    /// The picture's width and height, in pixels.
    l3d_size size() const { return size_; }
    /// Whether the projection is parallel: far things do not look smaller.
    bool is_parallel() const { return camera_.is_parallel(); }

    /// Positive if the eye sees the front of a plane, the side that its normal points to. `point`
    /// is any point of the plane; all is in model space. In perspective the result is the dot
    /// product of the normal and eye - point.
    double faces_eye(const vector& normal, const vector& point) const {
        return is_parallel() ? -l3d_dot(normal, forward_) : l3d_dot(normal, eye_ - point);
    }

    /// Whether all planes of a group certainly show the eye their fronts or, if `front` is false,
    /// their backs. The planes' normals are within `spread` of `axis`, and their points within
    /// `reach` of `middle`.
    /// Expects: normals of length 1 or 0.
    bool all_face(const vector& axis, double spread, const vector& middle, double reach,
                  bool front) const;

    /// The rule for the depths of points in a ball of model space. In a parallel projection, depths
    /// are 2 at the ball's nearest and 1 at its farthest point.
    /// Expects: radius >= 0.
    l3d_view_depths depths(const vector& middle, double radius) const;

    /// The shading for rasterizers, with `light` in world space. Its rays are zero, so that
    /// rasterizers reverse no normal: the plane of a face decides which side is seen. Near an
    /// outline, smooth normals point away from the eye in some pixels, and must stay so.
    l3d_shading shading(l3d_shade mode, const vector& light,
                        const l3d_lighting& lighting = {}) const;

private:
    l3d_camera camera_;
    l3d_size size_;
    l3d_picture_fit fit_;
    l3d_matrix<double> placement_, matrix_;
    vector eye_, forward_; ///< the eye, and the direction of view, in model space
};

/// The nearest point of a model's faces on the ray through a place of the picture.
///
/// Each error is the largest distance from the exact value, rounding included.
struct L3D_PUBLIC l3d_polygon_pick {
    std::size_t face = 0; ///< index of the face in the mesh
    std::string part{};   ///< name of the face's part; empty if the face belongs to none
    /// Indices of the vertices of the triangle that the ray meets.
    std::array<std::uint32_t, 3> corners{};
    std::array<double, 3> weights{}; ///< weights with which the point is the mean of the corners
    double weights_error = 0;        ///< error of each weight

    l3d_camera::vector point{0.0, 0.0, 0.0}; ///< the point in the world
    double point_error = 0;                  ///< error of the point, in world units
    double depth = 0;                        ///< distance of the point along the view axis

    /// The triangle's unit normal in the world, turned to the eye.
    l3d_camera::vector normal{0.0, 0.0, 0.0};
    double normal_error = 0; ///< error of the normal, as the length of a difference

    /// All values as text. Each line has a value's name, the value, and its error. Faces and
    /// vertices count from 0.
    std::string text() const;

    /// The text of face and point alone, in one line.
    std::string line() const;
};

/// Finds the face that is seen at (x, y) of a picture. The result is nothing if the ray meets no
/// face between the near and the far plane. The ray meets no faces without area and, if `culls` is
/// true, no faces that are seen from behind.
///
/// Units:   pixels from the picture's left upper corner; a pixel's middle is at 1/2.
/// Expects: finite x and y.
/// Cost:    some 20 ns for each triangle.
L3D_PUBLIC std::optional<l3d_polygon_pick> l3d_polygon_pick_at(const l3d_polygon_model& model,
                                                               const l3d_polygon_view& view,
                                                               bool culls, double x, double y);

#endif
