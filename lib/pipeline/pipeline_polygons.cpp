// SPDX-License-Identifier: MIT
// l3d_pipeline_polygons: the stages of a frame.
#include "pipeline/pipeline_polygons.h"

#include "pipeline/frame_report.h"
#include "pipeline/stopwatch_p.h"

#include <utility>

using l3d_detail::stopwatch;

l3d_pipeline_polygons::l3d_pipeline_polygons(l3d_canvas canvas, const l3d_polygon_model& model,
                                             const l3d_camera& camera,
                                             const l3d_polygon_settings& settings)
    : screen_(std::move(canvas.screen)), workers_(settings.threads),
      imp_(canvas.rasterizers->create_2d(screen_->pixels())), rasterizer_(*imp_), model_(model),
      camera_(camera), first_camera_(camera), settings_(settings), first_settings_(settings) {
    report_.frame = -1;
    report_.threads = settings.threads;
    report_.faces = static_cast<std::int64_t>(model.mesh().faces());
    report_.triangles = static_cast<std::int64_t>(model.triangles().size());
}

void l3d_pipeline_polygons::resize_event(l3d_size) {
    imp_->set_target(screen_->pixels());
    stale_ = true;
}

void l3d_pipeline_polygons::draw_event() {
    const stopwatch whole;
    report_.method = name();
    report_.size = screen_->pixels().size();
    report_.time_ms = {};
    report_.order = {};
    report_.surface = {};
    ++report_.frame;
    draw_model(report_);
    const stopwatch overlaying;
    draw_overlay();
    rasterizer_.finish();
    report_.time_ms.overlay = overlaying.milliseconds();
    report_.time_ms.total = whole.milliseconds();
    stale_ = false;
}

void l3d_pipeline_polygons::draw_model(l3d_polygon_report& report) {
    const stopwatch placing;
    const l3d_pixels target = screen_->pixels();
    const l3d_polygon_view view(camera_, target.size(), settings_.projection,
                                l3d_euler_rotation(settings_.rotation, model_.centre()));
    if (settings_.style == l3d_polygon_style::wireframe) {
        const auto lines = wires_.make(model_, view, settings_.cull);
        report.polygons = {};
        report.time_ms.place = placing.milliseconds();
        const stopwatch drawing;
        rasterizer_.clear_buffer();
        rasterizer_.draw_lines(lines, wire_color);
        report.time_ms.raster = drawing.milliseconds();
        return;
    }
    const bool smooth = settings_.shade != l3d_shade::flat;
    frame_.make(model_, view, settings_.cull, smooth, workers_);
    report.polygons = frame_.counts();
    const scene what{target, frame_, view.shading(settings_.shade, settings_.light)};
    report.time_ms.place = placing.milliseconds();
    if (settings_.style == l3d_polygon_style::solid)
        draw_solid(what, report);
    else
        draw_hidden_lines(what, report);
}

void l3d_pipeline_polygons::frame_event(const l3d_frame_times& times) {
    report_.time_ms.show = 1000 * times.show;
    report_.time_ms.write = 1000 * times.write;
}

l3d_polygon_report l3d_pipeline_polygons::report() const {
    l3d_polygon_report result = report_;
    result.hash = l3d_hash(screen_->pixels());
    return result;
}
