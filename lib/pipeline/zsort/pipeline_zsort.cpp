// SPDX-License-Identifier: MIT
// l3d_pipeline_zsort: orders triangles, then paints them.
#include "pipeline/zsort/pipeline_zsort.h"

#include "pipeline/zsort/painter_order.h"
#include "pipeline/polygons/polygon_frame.h"
#include "pipeline/stopwatch_p.h"
#include "pipeline/wire_p.h"
#include "raster/zsort/painter.h"
#include "raster/surfaces/surface_rasterizer_sw.h"

#include <utility>
#include <vector>

using l3d_detail::stopwatch;

struct l3d_pipeline_zsort::stages {
    explicit stages(l3d_workers& workers) : order(workers), painter(workers), depths(workers) {}

    std::vector<l3d_painter_triangle> triangles;
    l3d_painter_order order;
    l3d_painter painter;
    l3d_surface_rasterizer_sw depths; ///< fills the depth buffer by the painted triangles
};

l3d_pipeline_zsort::l3d_pipeline_zsort(l3d_canvas canvas, l3d_polygon_model model,
                                       const l3d_camera& camera,
                                       const l3d_polygon_settings& settings)
    : l3d_pipeline_polygons(std::move(canvas), std::move(model), camera, settings),
      stages_(std::make_unique<stages>(workers())) {}

l3d_pipeline_zsort::~l3d_pipeline_zsort() = default;

void l3d_pipeline_zsort::make_order(const scene& what, bool with_sides,
                                    l3d_polygon_report& report) {
    const stopwatch ordering;
    const std::vector<std::size_t> ends = what.frame.ends();
    std::vector<l3d_painter_triangle>& triangles = stages_->triangles;
    triangles.resize(ends.empty() ? 0 : ends.back());
    stages_->order.begin(triangles, ends, what.target.size(), {.sides = with_sides});
    workers().for_each_beside(static_cast<int>(ends.size()), [&](int number, int) {
        const auto part = static_cast<std::size_t>(number);
        const std::size_t begin = part > 0 ? ends[part - 1] : 0;
        what.frame.list_part(part, std::span(triangles).subspan(begin, ends[part] - begin));
        stages_->order.note(part); // while its triangles are in the cache
    });
    stages_->order.finish();
    report.order = stages_->order.counts();
    report.time_ms.order = ordering.milliseconds();
}

void l3d_pipeline_zsort::draw_solid(const scene& what, l3d_polygon_report& report) {
    make_order(what, false, report);
    const stopwatch painting;
    stages_->painter.paint(what.target, what.shading, what.materials, stages_->order.triangles(),
                           stages_->order.pieces(), stages_->order.cuts());
    report.surface = stages_->painter.counts();
    if (wants_depth(what.shading))
        report.surface.refined = look_at_depth(what);
    report.time_ms.raster = painting.milliseconds();
}

/// Fills the depth buffer by the painted triangles, and refines pixels at edges. At the centre of a
/// pixel, the painting order tells which triangle is in front. Elsewhere in a pixel, the depth
/// buffer tells which triangle is in front. It also tells how far away a triangle is. Returns the
/// number of pixels at edges.
std::int64_t l3d_pipeline_zsort::look_at_depth(const scene& what) {
    l3d_surface_rasterizer_sw& depths = stages_->depths;
    depths.count_pixels(false);
    depths.use_materials(what.materials);
    if (what.shading.lighting.point_count > 0)
        depths.begin(what.target, nullptr, what.shading); // point lights need depth in each pixel
    else
        depths.begin_over(what.target, what.shading);
    depths.draw(what.frame.parts());
    depths.finish();
    return depths.counts().refined;
}

void l3d_pipeline_zsort::draw_hidden_lines(const scene& what, l3d_polygon_report& report) {
    make_order(what, true, report);
    const stopwatch painting;
    stages_->painter.paint_lines(what.target, what.shading, stages_->order.triangles(),
                                 stages_->order.pieces(), stages_->order.cuts(),
                                 {l3d_detail::wire_color, what.smooth_lines});
    report.surface = stages_->painter.counts();
    report.time_ms.raster = painting.milliseconds();
}
