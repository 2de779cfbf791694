// SPDX-License-Identifier: MIT
// The eye's place in a model's space, and the least depth of the model.
#ifndef L3D_SCENE_MODEL_EYE_H
#define L3D_SCENE_MODEL_EYE_H

#include "scene/patch_model.h"
#include "geom/matrix.h"

#include <optional>

/// The eye's place in a model's space: the point that to_image takes to x = y = w = 0.
///
/// Shape:  to_image takes the model's space to (x, y, -, w).
/// Errors: nothing if there is no such point.
std::optional<l3d_vector<double, 3>> l3d_eye_of(const l3d_matrix<double>& to_image);

/// The least w of any point in the model's box. to_image takes the model's space to (x, y, -, w).
double l3d_least_w_of(const l3d_patch_model& model, const l3d_matrix<double>& to_image);

#endif
