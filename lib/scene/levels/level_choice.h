// SPDX-License-Identifier: MIT
// Chooses the levels of curved models that a picture needs.
#ifndef L3D_SCENE_LEVEL_CHOICE_H
#define L3D_SCENE_LEVEL_CHOICE_H

#include "scene/camera.h"
#include "tool_2d/pixels.h"

/// The shares of a picture's tolerances that errors of curved models may take. The first is a share
/// of the tolerance of places, the second of the tolerance of shade levels. Errors of places fall
/// with the fourth power of the number of patches along a side, and errors of normals with the
/// third. So larger shares would save little.
inline constexpr double l3d_curved_share = 0.125, l3d_curved_share_of_shade = 0.25;

/// The view for which levels of curved models are chosen, with the largest errors that these models
/// may have in the picture.
struct l3d_level_view {
    const l3d_camera& camera;
    l3d_size size;
    double places_px; ///< largest error of places, in pixels
    double normals;   ///< largest difference of unit normals from the exact ones
};

/// Bounds of the errors of curved models in a picture, at the chosen levels.
struct l3d_curved_error {
    double places_px = 0; ///< error of places, and of depth along the drawn normal; in pixels
    double normals = 0;   ///< difference of unit normals from the exact ones
    double places = 0;    ///< error of places in the world's unit
};

#endif
