// SPDX-License-Identifier: MIT
// l3d_plot_task: the input of plotters of a patch's pixels beside its net.
#ifndef L3D_COMPARE_PLOTTERS_PLOT_TASK_H
#define L3D_COMPARE_PLOTTERS_PLOT_TASK_H

#include "scene/counts.h"
#include "scene/dice_view.h"
#include "geom/normal_net.h"
#include "compare/plotters/point_canvas.h"

/// The input of a plotter beside a patch's net. Lives: borrows everything.
struct l3d_plot_task {
    const l3d_normal_net& normals;
    const l3d_dice_view& view;
    l3d_point_canvas& canvas;
    l3d_dice_counts& counts;
};

#endif
