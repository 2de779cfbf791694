// SPDX-License-Identifier: MIT
// l3d_pipeline_polygons: runs the stages of a frame, and handles the keys for polygons.
#include "pipeline/polygons/pipeline_polygons.h"

#include "pipeline/polygons/paint_gatherer_p.h"
#include "pipeline/polygons/polygon_frame.h"
#include "pipeline/polygons/polygon_wires.h"
#include "base/error.h"
#include "geom/real.h"
#include "base/counted_p.h"
#include "pipeline/stopwatch_p.h"
#include "raster/parallel/simd_target.h"
#include "scene/camera_shading.h"
#include "scene/camera.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

using l3d_detail::stopwatch;

namespace {

constexpr double key_degrees = 5;

constexpr std::array<std::pair<l3d_polygon_style, const char*>, 3> styles{
    {{l3d_polygon_style::solid, "solid"},
     {l3d_polygon_style::wireframe, "wireframe"},
     {l3d_polygon_style::hidden_lines, "hidden lines removed"}}};

template <class Enum> constexpr std::size_t after(Enum value, std::size_t count) {
    return (static_cast<std::size_t>(value) + 1) % count;
}

} // namespace

l3d_pipeline_polygons::l3d_pipeline_polygons(l3d_canvas canvas, l3d_polygon_model model,
                                             const l3d_camera& camera,
                                             const l3d_polygon_settings& settings)
    : screen_(std::move(canvas.screen)), font_(std::move(canvas.font)), workers_(settings.threads),
      imp_(canvas.rasterizers->create_2d(screen_->pixels())), rasterizer_(*imp_),
      model_(std::move(model)), camera_(camera), settings_(settings), first_settings_(settings),
      frame_(std::make_unique<l3d_polygon_frame>()), wires_(std::make_unique<l3d_polygon_wires>()),
      controls_(
          *this, *screen_, camera_, own_rows(), [this] { reset_view(); }, viewed(), font_) {
    report_.frame = -1;
    report_.real = l3d_real_name();
    report_.simd = l3d_simd_target();
    report_.threads = workers_.count();
    take_model(model_);
}

l3d_pipeline_polygons::~l3d_pipeline_polygons() = default;

void l3d_pipeline_polygons::take_model(const l3d_polygon_model& model) {
    model_ = model;
    report_.faces = static_cast<std::int64_t>(model_.mesh().faces());
    report_.triangles = static_cast<std::int64_t>(model_.triangles().size());
    stale_ = true;
}

void l3d_pipeline_polygons::resize_event(l3d_size) {
    imp_->set_target(screen_->pixels());
    controls_.resized();
    stale_ = true;
}

void l3d_pipeline_polygons::draw_event() {
    const stopwatch whole;
    if (const std::string why = camera_.complaint(); !why.empty())
        throw l3d_error(l3d_exit::failure, why);
    if (static_cast<std::size_t>(settings_.shade) >= l3d_shades_of_normals)
        throw l3d_error(l3d_exit::failure, "shade: polygons have normals and nothing else to show");
    controls_.pace().begin();
    report_.method = name();
    report_.renderer = {};
    report_.size = screen_->pixels().size();
    report_.time_ms = {};
    report_.order = {};
    report_.surface = {};
    ++report_.frame;
    draw_model(report_);
    const stopwatch overlaying;
    draw_overlay();
    draw_panels();
    rasterizer_.finish();
    report_.time_ms.overlay = overlaying.milliseconds();
    report_.time_ms.total = whole.milliseconds();
    controls_.pace().end();
    stale_ = false;
}

void l3d_pipeline_polygons::draw_model(l3d_polygon_report& report) {
    const stopwatch placing;
    const l3d_pixels target = screen_->pixels();
    const l3d_polygon_view view = this->view();
    const bool is_solid = settings_.style == l3d_polygon_style::solid;
    const l3d_frame_lights lights = settings_.headlight
                                        ? l3d_headlight(camera_, settings_.lighting)
                                        : l3d_frame_lights{settings_.light, settings_.lighting};
    l3d_shading shading = view.shading(settings_.shade, lights.light, lights.lighting);
    const l3d_view_depths depths = view.depths(model_.centre(), model_.radius());
    shading.depth_base = depths.base;
    shading.depth_step = depths.step;
    shading.antialias = settings_.antialias && is_solid;
    shading.background = settings_.background;
    shading.fog = settings_.fog;
    if (settings_.style == l3d_polygon_style::wireframe) {
        const auto lines = wires_->make(model_, view, settings_.cull);
        report.polygons = {};
        report.time_ms.place = placing.milliseconds();
        const stopwatch drawing;
        l3d_detail::wire_picture picture(rasterizer_, target, shading, settings_.antialias,
                                         screen_->text_scale());
        picture.draw(lines);
        picture.finish();
        report.time_ms.raster = drawing.milliseconds();
        return;
    }
    const bool smooth = settings_.shade != l3d_shade::flat;
    l3d_polygon_frame::way how{.cull = settings_.cull,
                               .smooth = smooth,
                               .antialias = shading.antialias,
                               .parts = draws_parts(shading),
                               .cull_hidden = true};
    l3d_face_paints paints;
    if (is_solid && l3d_is_light(shading.mode)) {
        l3d_detail::paint_gatherer gatherer(settings_, model_.materials().size(), paints);
        how.first_painted = gatherer.add(model_, view, 0);
        shading.paints = gatherer.paints();
    }
    frame_->make(model_, view, how, workers_);
    report.polygons = frame_->counts();
    const std::vector<l3d_material> repainted(settings_.material ? model_.materials().size() + 1
                                                                 : 0,
                                              settings_.material.value_or(l3d_material()));
    const scene what{target,
                     *frame_,
                     settings_.material ? std::span<const l3d_material>(repainted)
                                        : model_.materials(),
                     shading,
                     settings_.count_pixels,
                     settings_.antialias};
    report.time_ms.place = placing.milliseconds();
    if (is_solid)
        draw_solid(what, report);
    else
        draw_hidden_lines(what, report);
}

std::vector<l3d_viewer_row> l3d_pipeline_polygons::own_rows() {
    l3d_viewer_row turn{"x y z", "turn the model (X Y Z back)"};
    for (int axis = 0; axis < 3; ++axis)
        for (const auto& [key, degrees] :
             {std::pair('x' + axis, key_degrees), std::pair('X' + axis, -key_degrees)})
            turn.actions.emplace_back(key, [this, axis, by = degrees] {
                double& angle = settings_.rotation[axis];
                angle = std::remainder(angle + by, 360.0);
            });
    const auto shade = [this] {
        const auto& next = l3d_shade_names[after(settings_.shade, l3d_shades_of_normals)];
        settings_.shade = next.second;
        controls_.say(std::string("shading: ") + next.first);
    };
    const auto style = [this] {
        const auto& next = styles[after(settings_.style, styles.size())];
        settings_.style = next.first;
        controls_.say(next.second);
    };
    const auto cull = [this] {
        settings_.cull = !settings_.cull;
        controls_.say(settings_.cull ? "faces seen from behind are left out"
                                     : "both sides of faces are drawn");
    };
    const auto antialias = [this] {
        settings_.antialias = !settings_.antialias;
        controls_.say(settings_.antialias ? "smooth edges" : "sharp edges");
    };
    return {std::move(turn),
            {"c", "shading", {{'c', shade}}},
            {"w", "solid, wires, hidden lines", {{'w', style}}},
            {"a", "smooth edges", {{'a', antialias}}},
            {"l",
             "light with the eye, in the world",
             {{'l', [this] { controls_.switch_headlight(settings_.headlight); }}}},
            {"b", "faces seen from behind", {{'b', cull}}},
            {"v", "perspective, parallel", {{'v', [this] { controls_.switch_projection(); }}}}};
}

/// Resets the model's turn, which belongs to the view. Colours stay as they are.
void l3d_pipeline_polygons::reset_view() {
    settings_.rotation = first_settings_.rotation;
}

void l3d_pipeline_polygons::key_event(int key) {
    stale_ |= controls_.key(key);
}

void l3d_pipeline_polygons::pointer_event(const l3d_event& event) {
    stale_ |= controls_.pointer(event);
}

void l3d_pipeline_polygons::update_event(double seconds) {
    stale_ |= controls_.update(seconds);
}

void l3d_pipeline_polygons::rest_event(double seconds) {
    stale_ |= controls_.rest(seconds);
}

void l3d_pipeline_polygons::tell_empty() {
    const std::string why = report_.polygons.drawn == 0 ? why_empty() : "";
    controls_.set_empty(why, why == l3d_without_area       ? '\0'
                             : why == l3d_turning_its_back ? 'b'
                                                           : 'f');
}

void l3d_pipeline_polygons::draw_panels() {
    if (screen_->is_window())
        tell_empty();
    screen_->set_text({});
    const l3d_standing_panel standing = standing_panel();
    if (!controls_.shows_text() && standing.panel.empty())
        return;
    const auto some = [](std::int64_t count, const char* things) {
        return l3d_detail::counted(static_cast<std::size_t>(count), things);
    };
    std::vector lines{std::to_string(report_.polygons.drawn) + " of " +
                      some(report_.triangles, "polygons") + " drawn by " + name()};
    if (report_.order.knots > 0)
        lines.push_back(some(report_.order.knots, "knots") + ", " +
                        some(report_.order.cuts, "cuts"));
    controls_.draw(rasterizer_, lines, {}, standing);
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
