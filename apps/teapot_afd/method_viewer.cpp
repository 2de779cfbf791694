// SPDX-License-Identifier: MIT
// method_viewer: changes methods by a key, drops settings that they cannot show, and shows errors.
#include "method_viewer.h"

#include "dice/error_color.h"
#include <l3d/error.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

method_viewer::method_viewer(l3d_canvas canvas, const l3d_patch_scene& scene,
                             const l3d_camera& camera, const l3d_afd_settings& settings,
                             const l3d_method_choice& first)
    : l3d_pipeline_afd_editor(std::move(canvas), scene, camera, settings), method_(first),
      fog_(settings.fog),
      is_one_model_(scene.instances().size() == 1 && scene.transparent_count() == 0) {
    controls().add({"m", "another method", {{'m', [this] { take_next_method(); }}}});
}

bool method_viewer::measures_error() {
    return settings().shade == l3d_shade::error && !settings().wireframe && is_one_model_ &&
           has_exact_picture(scene().instances()[0].model(), camera(), settings());
}

live_subject method_viewer::now() {
    return {{scene().instances()[0].model()},
            camera(),
            screen().pixels().size(),
            settings().tolerance,
            method_.name()};
}

/// Draws a frame. A window shows errors when they are known; pictures in files wait for them.
void method_viewer::draw_event() {
    ++frame_;
    if (!measures_error())
        return l3d_pipeline_afd_editor::draw_event();
    settings().depth = true;
    take_errors();
    l3d_pipeline_afd_editor::draw_event();
    measure();
    if (!screen().is_window()) {
        live_->wait();
        if (!live_->has_results())
            return;
        take_errors();
        static_cast<void>(pixels()); // draws all: reports describe no kept pictures
        l3d_pipeline_afd_editor::draw_event();
    }
}

l3d_frame_report method_viewer::report() const {
    l3d_frame_report result = l3d_pipeline_afd_editor::report();
    result.frame = frame_;
    return result;
}

bool method_viewer::skip_event() {
    ++frame_;
    return true;
}

bool method_viewer::needs_redraw() const {
    return l3d_pipeline_afd_editor::needs_redraw() || (live_ && live_->has_results());
}

/// Whether nothing changes by itself. It is false while an error is measured, so that the error is
/// shown once it is known.
bool method_viewer::is_at_rest() const {
    return l3d_pipeline_afd_editor::is_at_rest() && (!live_ || live_->is_idle());
}

/// Begins a measurement, unless one is going on or this picture has been measured.
void method_viewer::measure() {
    if (!live_)
        live_.emplace(screen().is_window());
    if (begun_ == now() || !live_->is_idle())
        return;
    begun_ = now();
    live_->begin({*begun_.model.model, begun_.camera, begun_.size, {distances()}});
}

void method_viewer::take_errors() {
    if (!live_ || !live_->has_results())
        return;
    errors_ = std::move(live_->take_results().front().map);
    measured_ = begun_;
    redraw();
}

void method_viewer::paint_surfaces() {
    shows_errors_ = measures_error() && errors_ && measured_ == now();
    if (shows_errors_)
        paint_errors();
}

/// Colours pixels by their measured errors: surfaces, and outlines whose error was measured. A
/// pixel is coloured if a surface covers its centre, since errors are measured only there.
void method_viewer::paint_errors() {
    constexpr std::uint32_t not_measured = 0x00606060;
    const std::vector<float> distances = this->distances();
    const l3d_pixels target = pixels();
    std::size_t k = 0;
    for (int y = 0; y < target.height; ++y)
        for (std::uint32_t& word : target.row(y)) {
            const float at_depth = errors_->depth[k], at_outline = errors_->outline[k];
            const float error = std::isnan(at_depth) ? at_outline : at_depth;
            if (!std::isfinite(distances[k]))
                word = settings().background.word(y, target.height);
            else
                word = std::isnan(error)
                           ? not_measured
                           : l3d_error_color(static_cast<double>(error), settings().tolerance);
            ++k;
        }
}

std::string method_viewer::error_scale_title() const {
    return shows_errors_ ? "measured error, in pixels; grey: not known"
                         : l3d_pipeline_afd_editor::error_scale_title();
}

/// Takes the next method. AFD gets back the fog that other methods drop, since no key switches fog
/// on.
void method_viewer::take_next_method() {
    controls().say(show_next_method(*this, method_));
    if (settings().method.is_default())
        settings().fog = fog_;
}

l3d_afd_settings as_method_can(l3d_afd_settings settings) {
    const bool is_afd = settings.method.is_default();
    settings.wireframe = settings.wireframe && is_afd;
    if (!is_afd)
        settings.fog = {};
    if ((settings.shade == l3d_shade::error && !settings.method.has_bound()) ||
        (l3d_is_inspection(settings.shade) && !is_afd))
        settings.shade = l3d_shade::lambert;
    return settings;
}

void show_method(l3d_pipeline_afd& pipeline, const l3d_method_choice& method) {
    pipeline.take_method(method.factory());
    pipeline.settings() = as_method_can(pipeline.settings());
}

/// Takes the next method, and skips those that cannot be created. AFD always can, so the search
/// ends.
std::string show_next_method(l3d_pipeline_afd& pipeline, l3d_method_choice& method) {
    std::string passed_over;
    for (;;)
        try {
            method = method.next();
            show_method(pipeline, method);
            return "method: " + method.name() + passed_over;
        } catch (const l3d_error& error) {
            passed_over += "; not " + method.name() + ": " + error.what();
        }
}
