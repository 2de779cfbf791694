// SPDX-License-Identifier: MIT
// comparison: shows two pipelines with one camera, and their captions.
#include "comparison.h"

#include "half_screen.h"
#include "method_viewer.h"
#include "base/formatted_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace {

using l3d_detail::formatted;

constexpr std::uint32_t line_color = 0x00ffd873;
/// The limits of the viewer's keys + and -.
constexpr double least_tolerance = 1.0 / 64, largest_tolerance = 64;

l3d_canvas half_of(const std::shared_ptr<l3d_screen>& whole,
                   const std::shared_ptr<const l3d_rasterizer_factory>& rasterizers,
                   const l3d_font& font, half_screen::side side) {
    return {std::make_unique<half_screen>(whole, side), rasterizers, font};
}

/// Settings in which two methods compare. Errors are measured by depths. Times compare equal work,
/// so AFD has no smooth edges.
l3d_afd_settings comparable(l3d_afd_settings settings) {
    settings.depth = true;
    settings.antialias = false;
    return settings;
}

l3d_afd_settings with_method(l3d_afd_settings settings, const l3d_method_choice& method) {
    settings.method = method.factory();
    return as_method_can(settings);
}

} // namespace

/// The lines of the caption; short ones have no column of words before the numbers.
l3d_panel caption::lines(bool are_short) const {
    l3d_panel panel;
    const auto add = [&](const std::string& key, const std::string& text) {
        if (are_short)
            panel.add(key + ' ' + text);
        else
            panel.add(key, text);
    };
    panel.add(are_short ? "" : "method", method);
    if (shows_time && milliseconds > 0)
        add("time", formatted("%.2f ms", milliseconds));
    if (!std::isfinite(bound_px))
        add("bound", "none");
    else if (tolerance_px && !are_short)
        add("bound", formatted("%.3f px, of %.3g", bound_px, *tolerance_px));
    else
        add("bound", formatted("%.3f px", bound_px));
    const char* const off = are_short ? "%.3f px" : "%.3f px off";
    if (error == error_state::awaited) {
        add("error", awaited_seconds > 0 ? formatted("measured for %d s", awaited_seconds)
                                         : "being measured");
    } else if (error == error_state::known && !measured.is_known) {
        add("error", "not known");
    } else if (error == error_state::known) {
        add("outlines", formatted(off, measured.outline_px));
        const std::string judged =
            formatted(" (%.0f %% of pixels judged)", std::floor(100 * measured.judged));
        add("depth", formatted(off, measured.depth_px) + (are_short ? "" : judged));
    }
    return panel;
}

l3d_panel caption::panel(l3d_size half, const l3d_panel_style& style) const {
    l3d_panel name;
    name.add(method);
    const l3d_pixel_box whole = l3d_whole(half);
    for (const l3d_panel& panel : {lines(false), lines(true), name}) {
        const l3d_pixel_box box = panel.box_in(whole, l3d_corner::top_right, style);
        if (!box.empty() && 2 * box.area() <= whole.area())
            return panel;
    }
    return {};
}

void other_half::draw_overlay() {
    text.bound_px = bound();
    const l3d_size half = screen().pixels().size();
    l3d_pixel_box free = l3d_whole(half);
    text.panel(half, style).draw(rasterizer(), free, l3d_corner::top_right, style);
}

comparison::comparison(l3d_canvas canvas, const l3d_patch_model& model, const l3d_camera& camera,
                       const l3d_afd_settings& settings, const l3d_method_choice& other)
    : comparison(std::shared_ptr<l3d_screen>(std::move(canvas.screen)),
                 std::move(canvas.rasterizers), canvas.font, model, camera, comparable(settings),
                 other) {}

comparison::comparison(std::shared_ptr<l3d_screen> whole,
                       std::shared_ptr<const l3d_rasterizer_factory> rasterizers,
                       const l3d_font& font, const l3d_patch_model& model, const l3d_camera& camera,
                       const l3d_afd_settings& settings, const l3d_method_choice& other)
    : l3d_pipeline_afd_viewer(half_of(whole, rasterizers, font, half_screen::side::left), model,
                              camera, settings),
      whole_(std::move(whole)), other_(half_of(whole_, rasterizers, font, half_screen::side::right),
                                       model, camera, with_method(settings, other)),
      other_method_(other), other_tolerance_(settings.tolerance), live_(screen().is_window()) {
    controls().add({"m", "another method on the right", {{'m', [this] { take_next_method(); }}}});
    controls().add({"b", "the same time, or the same error", {{'b', [this] { switch_budget(); }}}});
}

void comparison::take_next_method() {
    controls().say(show_next_method(other_, other_method_));
    other_pace_ = l3d_picture_pace();
}

void comparison::switch_budget() {
    equal_time_ = !equal_time_;
    frames_to_settle_ = 60; // frames: a second
    other_tolerance_ = settings().tolerance;
    controls().say(!equal_time_ ? "both keep the same error"
                   : other_method_.keeps_tolerance()
                       ? "the right one takes the time of the left one"
                       : other_method_.name() + " has steps of its own");
}

/// Hands the event to a half; a drag that crosses the line stays with the half in which it began.
void comparison::pointer_event(const l3d_event& event) {
    const halves parts(whole_->pixels().width);
    const bool is_drag = event.type == l3d_event_type::pointer_motion && event.button != 0;
    const bool is_right = is_drag ? drags_right_ : event.x >= parts.right_start;
    if (event.type == l3d_event_type::button_press)
        drags_right_ = is_right;
    l3d_event moved = event;
    if (is_right)
        moved.x -= parts.right_start;
    l3d_pipeline_afd_viewer::pointer_event(moved);
}

l3d_frame_report comparison::report() const {
    l3d_frame_report result = l3d_pipeline_afd_viewer::report();
    result.frame = frame_;
    return result;
}

bool comparison::skip_event() {
    ++frame_;
    return true;
}

std::optional<l3d_pick> comparison::pick(double x, double y) const {
    const halves parts(whole_->pixels().width);
    if (x >= parts.right_start)
        return other_.pick(x - parts.right_start, y);
    return x < parts.width ? l3d_pipeline_afd_viewer::pick(x, y) : std::nullopt;
}

void comparison::interrupt_when(std::function<bool()> wanted) {
    other_.interrupt_when(wanted);
    l3d_pipeline_afd_viewer::interrupt_when(std::move(wanted));
}

void comparison::resize_event(l3d_size size) {
    l3d_pipeline_afd_viewer::resize_event(size);
    other_.resize_event(size);
}

bool comparison::needs_redraw() const {
    return l3d_pipeline_afd_viewer::needs_redraw() || other_.needs_redraw() ||
           live_.has_results() || passes_a_second();
}

/// Whether the captions show fewer seconds of a measurement than have passed.
bool comparison::passes_a_second() const {
    return text_.error == caption::error_state::awaited && live_.seconds() > text_.awaited_seconds;
}

/// Whether nothing changes by itself. It is false while an error is measured, so that the error is
/// shown once it is known.
bool comparison::is_at_rest() const {
    return l3d_pipeline_afd_viewer::is_at_rest() && live_.is_idle();
}

l3d_pixel_box comparison::changed() const {
    if (l3d_pipeline_afd_viewer::changed().empty() && other_.changed().empty())
        return {};
    return l3d_whole(whole_->pixels().size());
}

/// Draws both halves. A window shows errors when they are known; pictures in files wait for them.
void comparison::draw_event() {
    ++frame_;
    const bool shows_results = live_.has_results();
    draw_both();
    measure();
    if (!screen().is_window()) {
        live_.wait();
        if (live_.has_results())
            draw_both();
    } else if (!changed().empty()) {
        // A frame that shows measured errors must not change the tolerance that they belong to.
        if (!shows_results || frames_to_settle_ > 0)
            seek_equal_time();
    }
}

void comparison::draw_both() {
    take_results();
    follow_left();
    l3d_pipeline_afd_viewer::draw_event();
    other_pace_.begin();
    other_.draw_event();
    if (!other_.changed().empty())
        other_pace_.end();
    draw_line();
}

/// Shows the same parts on the right as on the left, where the key d puts another model in place of
/// the whole one.
void comparison::show_same_parts() {
    const l3d_patch_instance& right = other_.scene().instances()[0];
    if (right.model().identity() != shown().identity())
        other_.scene().place(0, shown(), right.placement());
}

/// Makes the right half show the same as the left one, as far as its method can.
void comparison::follow_left() {
    if (l3d_pipeline_afd_viewer::needs_redraw())
        other_.redraw();
    show_same_parts();
    const l3d_method_factory method = other_.settings().method;
    l3d_afd_settings now = settings();
    now.method = method;
    if (equal_time_ && other_method_.keeps_tolerance())
        now.tolerance = other_tolerance_;
    other_.settings() = as_method_can(now);
    if (!method.draws_parallel())
        camera().projection = l3d_projection::perspective;
    other_.camera() = camera();
    other_.style = controls().panel_style();
    other_.text.method = method.name();
    other_.text.tolerance_px =
        other_method_.keeps_tolerance() ? std::optional(now.tolerance) : std::nullopt;
    text_.method = settings().method.name();
    text_.tolerance_px = settings().tolerance;
    text_.shows_time = other_.text.shows_time = screen().is_window();
    text_.milliseconds = controls().pace().milliseconds();
    other_.text.milliseconds = other_pace_.milliseconds();
    tell_errors();
}

l3d_standing_panel comparison::standing_panel() {
    text_.bound_px = bound();
    return {text_.panel(screen().pixels().size(), controls().panel_style()), l3d_corner::top_right};
}

void comparison::draw_line() {
    const l3d_pixels pixels = whole_->pixels();
    const halves parts(pixels.width);
    for (int y = 0; y < pixels.height; ++y)
        std::ranges::fill(pixels.row(y).subspan(static_cast<std::size_t>(parts.width),
                                                static_cast<std::size_t>(parts.line_width())),
                          line_color);
}

/// Changes the right tolerance until both halves take the same time. That time is about
/// proportional to 1 / tolerance. The fourth root damps the noise of times.
void comparison::seek_equal_time() {
    if (!equal_time_ || !other_method_.keeps_tolerance())
        return;
    constexpr double near_enough = 1.1;
    const double ratio = other_.report().time_ms.total / std::max(report().time_ms.total, 1e-3);
    if (ratio < near_enough && ratio > 1 / near_enough)
        return;
    other_tolerance_ = std::clamp(other_tolerance_ * std::sqrt(std::sqrt(ratio)), least_tolerance,
                                  largest_tolerance);
    if (frames_to_settle_-- > 0)
        redraw();
}

comparison::subjects comparison::now() {
    const auto of = [this](const l3d_afd_settings& half) {
        return live_subject{
            {shown()}, camera(), screen().pixels().size(), half.tolerance, half.method.name()};
    };
    return {of(settings()), of(other_.settings())};
}

bool comparison::measures_errors() {
    return !settings().wireframe && has_exact_picture(shown(), camera(), settings());
}

/// Begins a measurement, unless one is going on or this picture has been measured.
void comparison::measure() {
    const subjects seen = now();
    if (!measures_errors() || seen == begun_ || !live_.is_idle())
        return;
    begun_ = seen;
    live_.begin({shown(), camera(), screen().pixels().size(), {distances(), other_.distances()}});
}

void comparison::take_results() {
    const auto results = live_.take_results();
    if (results.empty())
        return;
    text_.measured = results[0];
    other_.text.measured = results[1];
    measured_ = begun_;
    redraw();
}

/// Puts measured errors into the captions, unless they belong to another view.
void comparison::tell_errors() {
    using enum caption::error_state;
    const subjects seen = now();
    const bool are_measured = measures_errors();
    const auto state = [&](bool is_of_this) {
        return !are_measured ? none : is_of_this ? known : awaited;
    };
    const int seconds = screen().is_window() ? live_.seconds() : 0;
    if (seconds != text_.awaited_seconds) {
        redraw();
        other_.redraw();
    }
    text_.awaited_seconds = other_.text.awaited_seconds = seconds;
    text_.error = state(measured_.left == seen.left);
    other_.text.error = state(measured_.right == seen.right);
}
