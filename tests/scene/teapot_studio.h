// SPDX-License-Identifier: MIT
// The teapot, and a camera that looks at it from no symmetric place.
#ifndef L3D_TESTS_SCENE_TEAPOT_STUDIO_H
#define L3D_TESTS_SCENE_TEAPOT_STUDIO_H

#include "scene/camera.h"
#include "scene/patch_model.h"

namespace dice_tests {

inline l3d_patch_model teapot_model() {
    return l3d_patch_model::teapot();
}

inline l3d_camera oblique_camera() {
    l3d_camera camera;
    camera.eye = {2.5, 3.1, 6.3};
    camera.target = {0.4, 0.2, -0.3};
    camera.up = {0.1, 1.0, 0.05};
    camera.fov = 41;
    return camera;
}

} // namespace dice_tests

#endif
