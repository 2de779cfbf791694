// SPDX-License-Identifier: MIT
// l3d_inspected_scene: the data about a scene that inspecting shades need.
#ifndef L3D_SCENE_INSPECTED_SCENE_H
#define L3D_SCENE_INSPECTED_SCENE_H

#include "raster/inspected_patches.h"
#include "raster/surface_rasterizer.h"
#include "scene/camera.h"
#include "scene/patch_scene.h"
#include "scene/culling/scene_culling.h"

#include <span>

/// Collects the patches of a frame, in the coordinates of the eye, for a rasterizer that inspects
/// surfaces (l3d_inspected_patches).
///
/// Lives: kept from frame to frame for its memory.
class l3d_inspected_scene {
public:
    /// Starts a frame. Expects: a valid camera; an inspection whose direction is not 0.
    void begin(const l3d_camera& camera, const l3d_dice_view& view, const l3d_shading& shading);

    /// Adds the patches of a batch in their order, after the patches of earlier batches.
    void add(const l3d_patch_scene& scene, std::span<const l3d_placed_patch> batch);

    const l3d_inspected_patches& patches() const { return patches_; }

private:
    l3d_matrix<double> to_eye_;
    l3d_inspected_patches patches_;
    bool with_materials_ = false;
};

/// The curvature at the end of a colour scale that suits a scene. Nine tenths of the scene's area
/// have less curvature. The number is 1, 2 or 5 times a power of ten; 1 if nothing bends.
///
/// Expects: `shade` is `gaussian` or `mean`.
/// Cost:    some 7 us a patch, but at most 30 ms.
double l3d_usual_curvature(const l3d_patch_scene& scene, l3d_shade shade);

#endif
