// SPDX-License-Identifier: MIT
// The lights and the shading of a frame, as its camera sees them.
#ifndef L3D_SCENE_CAMERA_SHADING_H
#define L3D_SCENE_CAMERA_SHADING_H

#include "scene/camera.h"
#include "raster/surface_rasterizer.h"

struct l3d_dice_view;

/// The lights of one frame.
struct l3d_frame_lights {
    l3d_camera::vector light; ///< towards the first light, world space, any length but 0
    l3d_lighting lighting;    ///< the first light's colour, and further lights
};

/// The light of a single lamp that goes with the eye. It shines over the right shoulder, as
/// l3d_usual_light does in the programs' first view of the teapot. `lighting` gives the ambient
/// light and the lamp's colour.
/// Expects: camera.is_valid().
l3d_frame_lights l3d_headlight(const l3d_camera& camera, const l3d_lighting& lighting);

/// The shading of one frame: the data on camera and light for a surface rasterizer.
///
/// Units:   `light` points towards the first light, world space, any length but 0.
/// Expects: camera.is_valid().
l3d_shading l3d_camera_shading(const l3d_camera& camera, l3d_size size, l3d_shade mode,
                               const l3d_camera::vector& light, const l3d_lighting& lighting = {});

/// Prepares a view for dicing that lights the vertices, and returns the rest of the shading for the
/// rasterizer. Vertices get levels if `with_levels` and the mode is lambert, else normals turned to
/// the eye.
/// Expects: `with_levels` is false if l3d_shading::is_lit.
l3d_shading l3d_lit_while_diced(l3d_dice_view& view, const l3d_shading& shading, bool with_levels);

#endif
