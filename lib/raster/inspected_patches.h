// SPDX-License-Identifier: MIT
// l3d_inspected_patches: the exact patches of a frame in the eye's coordinates.
#ifndef L3D_RASTER_INSPECTED_PATCHES_H
#define L3D_RASTER_INSPECTED_PATCHES_H

#include "geom/bezier_patch.h"
#include "geom/material.h"

#include <array>
#include <vector>

/// The exact patches of a frame, and the settings by which they are inspected.
///
/// Units: places are measured from the eye, along axes to the right, down and forward, in world
///        units. So curvatures are those of the world.
struct l3d_inspected_patches {
    using vector = l3d_vector<double, 3>;

    /// The size, in pixels, at which a world unit is seen at distance 1.
    double focal = 1;
    /// The column of the picture's middle, in pixels.
    double centre_x = 0;
    /// The row of the picture's middle, in pixels.
    double centre_y = 0;
    /// The unit vector towards the light.
    vector light{0.0, 0.0, 1.0};
    /// The unit vector from which draft angles are measured.
    vector direction{0.0, 1.0, 0.0};
    /// The control nets of the patches. A part's material number is the index of its patch's net.
    std::vector<l3d_bezier_patch<double, 3>> nets;
    /// The patches' materials, for a program's own shade; empty for other shades.
    std::vector<l3d_material> materials;
    /// The eye's place in world space.
    vector eye{0.0, 0.0, 0.0};
    std::array<vector, 3> axes{};

    /// Turns a direction along these axes (right, down, forward) into the same direction in world
    /// space.
    vector in_world(const vector& of_axes) const {
        return axes[0] * of_axes[0] + axes[1] * of_axes[1] + axes[2] * of_axes[2];
    }

    /// The direction from the eye to a place of the picture, with length 1 along the view axis.
    /// Units: pixels.
    vector ray(double x, double y) const {
        return {(x - centre_x) / focal, (y - centre_y) / focal, 1.0};
    }
};

#endif
