// SPDX-License-Identifier: MIT
// The plan of the report: which settings of which methods it measures, in which views.
#ifndef L3D_APPS_TEAPOT_AFD_REPORT_PLAN_H
#define L3D_APPS_TEAPOT_AFD_REPORT_PLAN_H

#include "frame_measure.h"
#include "report_models.h"

#include <cstddef>
#include <vector>

/// A model, with the settings that are measured in each of its views.
struct planned_model {
    report_model model;
    std::vector<measured_setting> settings;

    std::size_t rows() const { return model.views.size() * settings.size(); }
};

struct plan_scope {
    bool quick = false;      ///< whether the plan is small: one view of two models
    bool has_mesa = false;   ///< whether a software OpenGL is there
    bool has_folds = false;  ///< whether folded patches are measured, for scan line methods
    bool has_scenes = false; ///< whether hills of 4 to 4096 patches are measured, too
};

/// Plans measurements of each model by all methods and arithmetics. Settings that would make meshes
/// of millions of quads are left out.
std::vector<planned_model> report_plan(std::vector<report_model> models, const plan_scope& scope);

#endif
