// SPDX-License-Identifier: MIT
// l3d_pipeline_zbuffer: gives all triangles at once to a surface rasterizer.
#include "pipeline/polygons/pipeline_zbuffer.h"

#include "pipeline/polygons/polygon_frame.h"
#include "pipeline/stopwatch_p.h"
#include "pipeline/wire_p.h"
#include "raster/lines/hidden_lines.h"

#include <algorithm>
#include <utility>

using l3d_detail::stopwatch;

l3d_pipeline_zbuffer::l3d_pipeline_zbuffer(l3d_canvas canvas, l3d_polygon_model model,
                                           const l3d_camera& camera,
                                           const l3d_polygon_settings& settings,
                                           const l3d_rasterizer_factory& surfaces,
                                           const char* method)
    : l3d_pipeline_polygons(std::move(canvas), std::move(model), camera, settings), method_(method),
      rasterizer_(surfaces.create_surface(workers())) {}

/// Copies the shared pointer to the canvas's factory. The canvas may be the factory's only owner,
/// and is moved away before the surface rasterizer is made.
l3d_pipeline_zbuffer::l3d_pipeline_zbuffer(l3d_canvas canvas, l3d_polygon_model model,
                                           const l3d_camera& camera,
                                           const l3d_polygon_settings& settings)
    : l3d_pipeline_zbuffer(std::shared_ptr(canvas.rasterizers), std::move(canvas), std::move(model),
                           camera, settings) {}

l3d_pipeline_zbuffer::l3d_pipeline_zbuffer(
    const std::shared_ptr<const l3d_rasterizer_factory>& surfaces, l3d_canvas&& canvas,
    l3d_polygon_model&& model, const l3d_camera& camera, const l3d_polygon_settings& settings)
    : l3d_pipeline_zbuffer(std::move(canvas), std::move(model), camera, settings, *surfaces) {}

l3d_pipeline_zbuffer::~l3d_pipeline_zbuffer() = default;

void l3d_pipeline_zbuffer::fill(const scene& what, l3d_depth_buffer* depth,
                                l3d_polygon_report& report) {
    l3d_surface_rasterizer& rasterizer = rasterizer_for(what.shading);
    rasterizer.count_pixels(what.count_pixels);
    rasterizer.use_materials(what.materials);
    rasterizer.begin(what.target, depth, what.shading);
    rasterizer.draw(what.frame.parts());
    rasterizer.finish();
    report.surface = rasterizer.counts();
    report.renderer = rasterizer.describe();
}

/// The rasterizer for a shading. OpenGL does not have l3d's fog, so l3d's own rasterizer draws
/// frames with fog.
l3d_surface_rasterizer& l3d_pipeline_zbuffer::rasterizer_for(const l3d_shading& shading) {
    if (!shading.fog.is_on() || rasterizer_->inspects())
        return *rasterizer_;
    if (!with_fog_)
        with_fog_ = l3d_rasterizer_factory_sw().create_surface(workers());
    return *with_fog_;
}

void l3d_pipeline_zbuffer::draw_solid(const scene& what, l3d_polygon_report& report) {
    const stopwatch filling;
    fill(what, nullptr, report);
    report.time_ms.raster = filling.milliseconds();
}

void l3d_pipeline_zbuffer::draw_hidden_lines(const scene& what, l3d_polygon_report& report) {
    const stopwatch filling;
    depth_.resize(what.target.size());
    scene clear = what; // GL may fill the depth if there is no fog
    clear.shading.fog = {};
    fill(clear, &depth_, report);
    what.frame.list(triangles_, workers());
    l3d_draw_seen_sides(what.target, depth_, triangles_, what.shading,
                        {l3d_detail::wire_color, what.smooth_lines});
    report.time_ms.raster = filling.milliseconds();
}
