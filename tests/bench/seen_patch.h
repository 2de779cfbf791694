// SPDX-License-Identifier: MIT
// One patch as a camera sees it, and how far straight pieces are from it.
#ifndef L3D_TESTS_BENCH_SEEN_PATCH_H
#define L3D_TESTS_BENCH_SEEN_PATCH_H

#include "geom/step_bound.h"
#include "scene/camera.h"
#include "scene/patch_model.h"

#include <array>
#include <vector>

/// A vertex of a triangle mesh: a surface point, its parameters, and where it is in the picture.
struct mesh_corner {
    double u = 0, v = 0;
    l3d_vector<double, 3> position{0.0, 0.0, 0.0};
    l3d_image_point image{0.0, 0.0, 1.0};
    double x = 0, y = 0; ///< of `image`; pixels from the picture's centre
};

/// The camera's picture of the world. Units: pixels from the picture's centre.
struct seen_world {
    seen_world(const l3d_camera& camera, l3d_size size);

    l3d_image_point operator()(const l3d_vector<double, 3>& position) const;
    mesh_corner corner(double u, double v, const l3d_vector<double, 3>& position) const;

    l3d_matrix<double> matrix;
    l3d_image_box window;
};

/// A patch in the picture. Errors are image distances between points of straight pieces and the
/// exact points of the same parameters, in pixels. A piece whose corners all lie beyond one side
/// of the window has none.
class seen_patch {
public:
    seen_patch(const l3d_patch_model::patch& patch, const seen_world& world);

    mesh_corner corner(double u, double v) const;

    /// Of a drawn point; none outside of the window.
    double point_error(const l3d_image_point& drawn, double u, double v) const;
    /// Of the middle of the line from a to b.
    double edge_error(const mesh_corner& a, const mesh_corner& b) const;
    /// Of the centre of a triangle.
    double centre_error(const mesh_corner& a, const mesh_corner& b, const mesh_corner& c) const;
    /// The largest of the three edge errors and the centre's.
    double triangle_error(const mesh_corner& a, const mesh_corner& b, const mesh_corner& c) const;

    /// Whether a triangle may reach into the window.
    bool visible(const mesh_corner& a, const mesh_corner& b, const mesh_corner& c) const;

    /// sqrt of the image's second derivative along u (v), the largest over v (u), integrated from 0
    /// to k / pieces: steps at equal values have nearly equal errors.
    static constexpr std::size_t pieces = 128;
    using growth = std::array<double, pieces + 1>;
    growth growth_along_u() const;
    growth growth_along_v() const;

    const l3d_patch_model::patch& patch() const { return patch_; }
    const seen_world& world() const { return world_; }

private:
    l3d_image_point exact(double u, double v) const;
    double distance(double x, double y, const l3d_image_point& exact) const;

    const l3d_patch_model::patch& patch_;
    const seen_world& world_;
    l3d_image_patch net_, transposed_;
    std::array<std::array<l3d_image_point, 4>, 4> power_; ///< of u^i v^j at [i][j]
};

/// n + 1 parameters from 0 to 1 at equal steps of `growth`.
std::vector<double> knots(const seen_patch::growth& growth, int n);

/// The same growth for a curve.
seen_patch::growth growth_of(const l3d_bezier_curve<double, 3>& curve, const seen_world& world);

#endif
