// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: the stages of a frame.
#include "pipeline/pipeline_afd.h"

#include "pipeline/camera_shading.h"
#include "pipeline/dice_sinks_p.h"
#include "pipeline/near_clip.h"
#include "pipeline/snap.h"
#include "pipeline/stopwatch_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace {

using l3d_detail::stopwatch;

constexpr std::uint32_t wire_color = 0x0080d0ff, net_color = 0x00ff9030;

} // namespace

l3d_pipeline_afd::l3d_pipeline_afd(std::unique_ptr<l3d_screen> screen,
                                   const l3d_rasterizer_factory& rasterizers,
                                   const l3d_patch_model& model, const l3d_camera& camera,
                                   const l3d_afd_settings& settings)
    : screen_(std::move(screen)), imp_(rasterizers.create_2d(screen_->pixels())),
      rasterizer_(*imp_), surface_rasterizer_(rasterizers.create_surface(workers_)), model_(model),
      camera_(camera), first_camera_(camera), settings_(settings) {
    report_.frame = -1;
    report_.method = "afd";
    report_.real = l3d_real_name();
}

void l3d_pipeline_afd::resize_event(l3d_size) {
    imp_->set_target(screen_->pixels());
    redraw();
}

void l3d_pipeline_afd::draw_event() {
    const stopwatch whole;
    l3d_stage_times times;

    const stopwatch clearing;
    clear();
    times.clear = clearing.milliseconds();

    const stopwatch transforming;
    place_patches();
    times.transform = transforming.milliseconds();

    const stopwatch drawing;
    times.raster = draw_surfaces();
    times.dice = drawing.milliseconds() - times.raster;

    const stopwatch overlaying;
    if (settings_.net)
        draw_nets();
    draw_overlay();
    rasterizer_.finish();
    times.overlay = overlaying.milliseconds();

    times.total = whole.milliseconds();
    report_.time_ms = times;
    ++report_.frame;
    report_.size = view_.size;
    report_.tolerance_px = settings_.tolerance;
    report_.patches = static_cast<std::int64_t>(model_.patches().size());
    report_.dice = dicer_.counts();
    report_.surface = surface_rasterizer_->counts();
    stale_ = false;
}

void l3d_pipeline_afd::frame_event(const l3d_frame_times& times) {
    report_.time_ms.show = 1000 * times.show;
    report_.time_ms.write = 1000 * times.write;
}

void l3d_pipeline_afd::clear() {
    depth_.resize(screen_->pixels().size());
}

/// Nearest first: what is hidden is then mostly rejected by the depth test before it is shaded.
void l3d_pipeline_afd::place_patches() {
    const l3d_size size = screen_->pixels().size();
    transform_ = l3d_image_transform<wide>(camera_, size, model_);
    view_ = transform_.view(settings_.tolerance);
    view_.keep_all = settings_.keep_all;
    placed_.clear();
    for (std::size_t i = 0; i < model_.patches().size(); ++i) {
        placed_patch& p = placed_.emplace_back();
        p.net = transform_(model_.patches()[i]);
        p.nearest_w = l3d_to_double(p.net.bounds().first[2]);
        p.index = i;
    }
    std::sort(placed_.begin(), placed_.end(), [](const placed_patch& a, const placed_patch& b) {
        return a.nearest_w != b.nearest_w ? a.nearest_w < b.nearest_w : a.index < b.index;
    });
}

/// Returns the milliseconds that filling took.
double l3d_pipeline_afd::draw_surfaces() {
    dicer_.begin(view_);
    surface_rasterizer_->begin(
        screen_->pixels(), &depth_,
        l3d_camera_shading(camera_, screen_->pixels().size(), settings_.shade, settings_.light));
    const auto draw_into = [this](l3d_dice_sink& sink) {
        for (const placed_patch& p : placed_)
            dicer_.dice(p.net, model_.normals(p.index), sink);
    };
    if (settings_.wireframe) {
        l3d_detail::line_sink lines(rasterizer_, wire_color);
        surface_rasterizer_->finish();
        draw_into(lines);
        return 0;
    }
    l3d_detail::filling_sink filling(parts_, settings_.shade == l3d_shade::error,
                                     settings_.tolerance);
    draw_into(filling);
    const stopwatch finishing;
    filling.draw(*surface_rasterizer_);
    surface_rasterizer_->finish();
    return finishing.milliseconds();
}

/// The 24 edges of every control net. An edge that reaches behind the near plane is left out.
void l3d_pipeline_afd::draw_nets() {
    std::vector<l3d_line_2d> lines;
    const auto add = [&](const l3d_vector<wide, 3>& from, const l3d_vector<wide, 3>& to) {
        const l3d_clip_vertex a = l3d_canonical_vertex<wide>(from, view_);
        const l3d_clip_vertex b = l3d_canonical_vertex<wide>(to, view_);
        if (a.drawable && b.drawable)
            lines.push_back(
                {a.dice.vertex.x >> l3d_subpixel_bits, a.dice.vertex.y >> l3d_subpixel_bits,
                 b.dice.vertex.x >> l3d_subpixel_bits, b.dice.vertex.y >> l3d_subpixel_bits});
    };
    for (const placed_patch& p : placed_)
        for (int line = 0; line < 4; ++line)
            for (int i = 0; i < 3; ++i) {
                add(p.net.at(line, i), p.net.at(line, i + 1));
                add(p.net.at(i, line), p.net.at(i + 1, line));
            }
    rasterizer_.draw_lines(lines, net_color);
}

l3d_frame_report l3d_pipeline_afd::report() const {
    l3d_frame_report result = report_;
    result.hash = l3d_hash(screen_->pixels());
    result.pixels_covered = result.surface.covered;
    return result;
}
