// SPDX-License-Identifier: MIT
// l3d_pick: the surface at a place of the picture, found from the exact patches.
#ifndef L3D_SCENE_PICK_H
#define L3D_SCENE_PICK_H

#include "base/public.h"
#include "scene/camera.h"
#include "scene/patch_scene.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <optional>
#include <string>

/// The nearest point of a scene's patches on the ray through a place of the picture.
///
/// Each error is the largest distance from the exact value, rounding included. It is infinite where
/// nothing is known, as of the curvature where the surface has no normal.
struct L3D_PUBLIC l3d_pick {
    /// The instance's index in the scene.
    std::size_t instance = 0;
    /// The patch's index in the instance's model.
    std::size_t patch = 0;
    /// The name of the part that the patch belongs to; empty if there is none.
    std::string part{};
    /// The first parameter, from 0 to 1.
    double u = 0;
    /// The second parameter, from 0 to 1.
    double v = 0;
    /// The error of u.
    double u_error = 0;
    /// The error of v.
    double v_error = 0;

    /// The point in the world.
    l3d_camera::vector point{0.0, 0.0, 0.0};
    /// The point's error, in world units.
    double point_error = 0;
    /// The distance along the view axis, as good as the point.
    double depth = 0;

    /// The unit normal in the world, on the side that is turned to the eye; zero if there is none.
    l3d_camera::vector normal{0.0, 0.0, 0.0};
    /// The length of the normal's difference from the exact one; radians if it is small.
    double normal_error = 0;

    /// Gaussian curvature, in 1 / world units squared.
    double gaussian = 0;
    /// The error of gaussian, in its unit.
    double gaussian_error = 0;
    /// Mean curvature, in 1 / world units: positive where the surface bends towards the normal, as
    /// a bowl that is seen from above.
    double mean = 0;
    /// The error of mean, in its unit.
    double mean_error = 0;

    /// True if it is proven that the ray meets the surface here. Otherwise the ray passes so near
    /// to an outline, or to a place without a normal, that rounding decides; the errors say how
    /// near.
    bool is_proven = false;

    /// All values, a line each: name, value and error. Patches count from 0.
    std::string text() const;

    /// Patch, parameters and point in one line, with no more digits than a picture has room for.
    std::string line() const;
};

/// The view in which a scene is picked.
struct L3D_PUBLIC l3d_pick_view {
    l3d_camera camera;      ///< its near and far planes limit the depth of hits
    l3d_size size;          ///< size of the picture, in pixels
    bool one_sided = false; ///< backs are not seen, as l3d_afd_settings has it
};

/// Finds the surface that is seen at (x, y) of a picture. Nothing if the ray meets no patch between
/// the near and the far plane.
///
/// Units:   pixels from the picture's left upper corner; a pixel's middle is at 1/2. Any place may
///          be asked for, also one outside the picture.
/// Expects: a valid camera; finite x and y.
/// Cost:    a look at each patch, some 100 ns, and 20 us to 200 us for those that the ray is near.
/// Source:  subdivision, nearest part first, until Krawczyk's operator proves a part to hold one
///          point of the ray; docs/NUMERICS.md tells the errors.
L3D_PUBLIC std::optional<l3d_pick> l3d_pick_at(const l3d_patch_scene& scene,
                                               const l3d_pick_view& view, double x, double y);

#endif
