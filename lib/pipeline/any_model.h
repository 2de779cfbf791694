// SPDX-License-Identifier: MIT
// l3d_load_any_model: the contents of a model file, and the pipeline that draws them.
#ifndef L3D_PIPELINE_ANY_MODEL_H
#define L3D_PIPELINE_ANY_MODEL_H

#include "base/public.h"
#include "pipeline/pipeline_afd_viewer.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/polygons/polygon_model.h"
#include "scene/patch_model.h"
#include "scene/patch_scene.h"

#include <string>
#include <type_traits>
#include <variant>
#include <vector>

/// The contents of a model file: patches, or polygons.
using l3d_any_model = std::variant<l3d_patch_model, l3d_polygon_model>;

/// Loads a model file in any format of l3d_read_model. A file of patches alone gives patches. Any
/// other file gives polygons. Patches of such a file become quads, as l3d_polygon_model::load makes
/// them. If `notes` is not null, notes on skipped lines are added to it.
/// Errors: throws l3d_error(bad_input) with file, line and reason, also for a file without patches
///         and polygons, and for patches that l3d_patch_model::from_patches refuses.
L3D_PUBLIC l3d_any_model l3d_load_any_model(const std::string& file,
                                            std::vector<std::string>* notes = nullptr);

/// The contents of a model file in the form that a pipeline draws: a scene of patches, or polygons.
using l3d_any_scene = std::variant<l3d_patch_scene, l3d_polygon_model>;

/// Loads a model file as l3d_load_any_model does. A shape that stands at many places, as in an
/// assembly, becomes one model with many instances, and takes memory once.
/// Errors: as l3d_load_any_model.
L3D_PUBLIC l3d_any_scene l3d_load_any_scene(const std::string& file,
                                            std::vector<std::string>* notes = nullptr);

/// The viewer for a kind of model: exact patches, or polygons through a depth buffer. Its
/// constructor takes a canvas, the model, a camera and settings; `{}` stands for the usual
/// settings.
///
///     std::visit([&]<class Model>(const Model& model) {
///         l3d_pipeline_for<Model> pipeline(l3d_memory_canvas({640, 480}), model,
///                                          {.eye = {1, 1, 3}}, {});
///         pipeline.frame_all();
///         pipeline.draw_event();
///     }, l3d_load_any_model(file));
template <class Model>
using l3d_pipeline_for = std::conditional_t<std::is_convertible_v<Model, l3d_patch_scene>,
                                            l3d_pipeline_afd_viewer, l3d_pipeline_zbuffer>;

#endif
