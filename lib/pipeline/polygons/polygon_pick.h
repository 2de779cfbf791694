// SPDX-License-Identifier: MIT
// l3d_polygon_pick: the face at a place of a polygon model's picture.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_PICK_H
#define L3D_PIPELINE_POLYGONS_POLYGON_PICK_H

#include "base/public.h"
#include "pipeline/polygons/polygon_model.h"
#include "pipeline/polygons/polygon_view.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

/// The nearest point of a model's faces on the ray through a place of the picture.
///
/// Each error is the largest distance from the exact value, rounding included.
struct L3D_PUBLIC l3d_polygon_pick {
    std::size_t face = 0;                   ///< index in the mesh
    std::string part{};                     ///< its name; empty if the face belongs to none
    std::array<std::uint32_t, 3> corners{}; ///< vertices of the triangle of the face that is met
    std::array<double, 3> weights{};        ///< weights of the corners, whose mean the point is
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
