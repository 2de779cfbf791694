// SPDX-License-Identifier: MIT
// The lights and the shading of a frame, as its camera sees them.
#ifndef L3D_SCENE_CAMERA_SHADING_H
#define L3D_SCENE_CAMERA_SHADING_H

#include "scene/camera.h"
#include "raster/surface_rasterizer.h"

struct l3d_dice_view;

/// The lights of one frame: the direction and colour of the first light, and all further lights.
struct l3d_frame_lights {
    l3d_camera::vector light; ///< towards the first light, world space, any length but 0
    l3d_lighting lighting;    ///< the first light's colour, and further lights
};

/// A frame's lights for a single lamp that moves with the eye. The lamp shines over the viewer's
/// right shoulder, as l3d_usual_light does in the programs' first view of the teapot. The ambient
/// light and the lamp's colour are those of `lighting`.
/// Expects: camera.is_valid().
l3d_frame_lights l3d_headlight(const l3d_camera& camera, const l3d_lighting& lighting);

/// Makes the shading of one frame, which tells a surface rasterizer about the camera and the
/// lights.
///
/// Units:   `light` points towards the first light, world space, any length but 0.
/// Expects: camera.is_valid().
l3d_shading l3d_camera_shading(const l3d_camera& camera, l3d_size size, l3d_shade mode,
                               const l3d_camera::vector& light, const l3d_lighting& lighting = {});

/// Divides the work of shading between dicing and the rasterizer. `view` gets the shading of
/// vertices; the result is the shading that is left to the rasterizer. Vertices get shade levels if
/// `with_levels` is true and the mode is lambert, else normals turned to the eye.
/// Expects: `with_levels` is false if l3d_shading::is_lit.
l3d_shading l3d_lit_while_diced(l3d_dice_view& view, const l3d_shading& shading, bool with_levels);

#endif
