// SPDX-License-Identifier: MIT
// l3d_pipeline_zsort: order, then paint.
#include "pipeline/polygons/pipeline_zsort.h"

#include "pipeline/stopwatch_p.h"

#include <utility>

using l3d_detail::stopwatch;

l3d_pipeline_zsort::l3d_pipeline_zsort(l3d_canvas canvas, const l3d_polygon_model& model,
                                       const l3d_camera& camera,
                                       const l3d_polygon_settings& settings)
    : l3d_pipeline_polygons(std::move(canvas), model, camera, settings) {}

void l3d_pipeline_zsort::make_order(const scene& what, l3d_polygon_report& report) {
    const stopwatch ordering;
    what.frame.list(triangles_);
    order_.make(triangles_, what.target.size());
    report.order = order_.counts();
    report.time_ms.order = ordering.milliseconds();
}

void l3d_pipeline_zsort::draw_solid(const scene& what, l3d_polygon_report& report) {
    make_order(what, report);
    const stopwatch painting;
    painter_.paint(what.target, what.shading, order_.triangles(), order_.pieces(), order_.cuts());
    report.surface = painter_.counts();
    report.time_ms.raster = painting.milliseconds();
}

void l3d_pipeline_zsort::draw_hidden_lines(const scene& what, l3d_polygon_report& report) {
    make_order(what, report);
    const stopwatch painting;
    painter_.paint_lines(what.target, order_.triangles(), order_.pieces(), order_.cuts(),
                         wire_color);
    report.surface = painter_.counts();
    report.time_ms.raster = painting.milliseconds();
}
