// SPDX-License-Identifier: MIT
// The models that the report measures: made here, of different shapes and sizes.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_MODELS_H
#define L3D_APPS_TEAPOT_AFD_REPORT_MODELS_H

#include <l3d/camera.h>
#include <l3d/patch_model.h>

#include <string>
#include <vector>

/// A view that the report measures: its camera, and its name.
struct report_view {
    std::string name;
    l3d_camera camera;
};

/// A model, and the views in which the report measures it.
struct report_model {
    std::string name;
    l3d_patch_model model;
    std::vector<report_view> views;
};

/// The models that the report measures, in three views each: the teapot, a thin twisted band, a
/// lampshade of creases, a knot of hundreds of patches, and hills of thousands of patches, near and
/// far.
std::vector<report_model> report_models();

/// The same hills as 4, 16, ... 4096 patches, in one view each, to show how time grows with the
/// number of patches.
std::vector<report_model> report_scenes();

/// A curtain that folds over itself, in three views. Iterations of scan line methods fail on this
/// model.
report_model report_folds();

#endif
