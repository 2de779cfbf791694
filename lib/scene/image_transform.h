// SPDX-License-Identifier: MIT
// l3d_image_transform: patches from world space to homogeneous image space.
#ifndef L3D_SCENE_IMAGE_TRANSFORM_H
#define L3D_SCENE_IMAGE_TRANSFORM_H

#include "geom/matrix.h"
#include "geom/plane.h"
#include "geom/step_bound.h"
#include "scene/camera.h"
#include "scene/dice_view.h"
#include "scene/patch_scene.h"

/// The map from the world to the picture for a frame. The map is the camera's matrix, scaled so
/// that results fit the registers of every number type.
///
/// Homogeneous points may be scaled freely. The factor here is a power of two, which is exact. It
/// brings w to at most 2^8, |x| and |y| to at most 2^28. (The 32.32 format has 31 integer bits, and
/// differences of third order may grow eightfold.)
class l3d_image_transform {
public:
    l3d_image_transform() = default;
    l3d_image_transform(const l3d_camera& camera, l3d_size size, const l3d_patch_scene& scene);

    /// The matrix from world (x, y, z, 1) to (x, y, -, w).
    const l3d_matrix<double>& matrix() const { return matrix_; }

    /// The picture's data for dicing, in the units of the transformed points. The view's errors
    /// hold for all points of the scene; l3d_dice_view::of_share gives the errors of some points.
    /// The view's near plane is the camera's, or a farther one where rounding leaves too few
    /// certain digits of w.
    /// Units: tolerance in pixels.
    l3d_dice_view view(double tolerance) const;

    /// A plane of the world in the space of the transformed points, with the same distances.
    l3d_image_section section(const l3d_plane<double>& plane) const;

    /// In a parallel projection, w is counted from an eye that is farther from the target than the
    /// camera's eye. This is the difference of the two eyes' distances from the target. It is 0 in
    /// perspective.
    double nearer() const { return w_middle_ / depth_scale_ - to_target_; }

    /// Sets the members of a shading that tell the rasterizer how depths in a parallel projection
    /// depend on distances. In perspective nothing changes.
    void set_depths(l3d_shading& shading) const;

private:
    void set_parallel(const l3d_camera& camera, const l3d_patch_scene& scene);

    l3d_matrix<double> matrix_;
    l3d_size size_;
    double near_ = 0, far_ = 0;
    double focal_ = 0;
    double depth_scale_ = 1;
    double w_middle_ = 0;
    double to_target_ = 0;
    double error_xy_ = 0;
    double error_w_ = 0;
    double terms_ = 0, eye_terms_ = 0;
};

#endif
