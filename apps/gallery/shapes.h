// SPDX-License-Identifier: MIT
// The gallery's models, each made of a few numbers.
#ifndef L3D_APPS_GALLERY_SHAPES_H
#define L3D_APPS_GALLERY_SHAPES_H

#include <l3d/patch_model.h>

// Every model stands on the ground, y = 0, with the y axis in its middle.

/// A ball of radius 1, on the ground.
l3d_patch_model ball();

/// A ring that lies on the ground, as wide as ball().
l3d_patch_model ring();

/// A vase with a narrow neck.
l3d_patch_model vase();

/// A sheet with waves, made of four by four patches that join smoothly.
l3d_patch_model waves();

/// The Utah teapot, whose lid, handle and spout have other colours than its body.
l3d_patch_model colored_teapot();

/// The given model, moved and scaled to stand where the teapot does: on the ground, and as wide or
/// as high as the teapot.
l3d_patch_model in_teapots_place(const l3d_patch_model& model);

/// The given model without highlights, so that a report's bound of shades is finite.
l3d_patch_model matt(const l3d_patch_model& model);

#endif
