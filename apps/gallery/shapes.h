// SPDX-License-Identifier: MIT
// The gallery's models, each made of a few numbers.
#ifndef L3D_APPS_GALLERY_SHAPES_H
#define L3D_APPS_GALLERY_SHAPES_H

#include <l3d/patch_model.h>

// Every model stands on the ground, y = 0, about the upright axis.

/// A ball of radius 1.
l3d_patch_model ball();

/// A ring that lies on the ground, as wide as the ball.
l3d_patch_model ring();

/// A vase with a narrow neck.
l3d_patch_model vase();

/// A sheet with waves, four by four patches that pass into each other smoothly.
l3d_patch_model waves();

/// The Utah teapot, whose lid, handle and spout have other colours than its body.
l3d_patch_model colored_teapot();

/// The model moved and scaled to the teapot's place: on the ground, and as wide or as high as the
/// teapot.
l3d_patch_model in_teapots_place(const l3d_patch_model& model);

/// The model without highlights, so that the report's bound of shades is finite.
l3d_patch_model matt(const l3d_patch_model& model);

#endif
