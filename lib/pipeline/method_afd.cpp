// SPDX-License-Identifier: MIT
// l3d_method_afd: runs the stages of a frame.
#include "pipeline/method_afd.h"

#include "raster/rasterizer_factory.h"
#include "scene/camera_shading.h"
#include "pipeline/stopwatch_p.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

using l3d_detail::stopwatch;

template <class T>
l3d_method_afd<T>::l3d_method_afd(const l3d_rasterizer_factory& rasterizers, l3d_workers& workers)
    : workers_(workers), surface_(rasterizers.create_surface(workers)), used_(surface_.get()),
      dicer_(workers) {}

/// The rasterizer for a shading. It is the canvas's rasterizer if that can draw the shading. OpenGL
/// cannot draw inspecting shades and fog: these need the library's own rasterizer.
template <class T>
l3d_surface_rasterizer& l3d_method_afd<T>::surface_for(const l3d_shading& shading) {
    const bool is_special = l3d_sees_patches(shading.mode) || shading.fog.is_on();
    if (!is_special || surface_->inspects())
        return *surface_;
    if (!inspector_)
        inspector_ = l3d_rasterizer_factory_sw().create_surface(workers_);
    return *inspector_;
}

template <class T>
std::span<const l3d_placed_patch>
l3d_method_afd<T>::next_batch(const l3d_surface_rasterizer& surface) {
    return culling_.next([&surface](const l3d_subpixel_box& box, float inv_w) {
        return surface.hidden(box, inv_w);
    });
}

/// Draws batch after batch, so that patches behind nearer batches need not be diced. Most scenes
/// are one batch. Such a scene needs no depth of the whole picture, unless the frame wants depth.
template <class T>
void l3d_method_afd<T>::do_draw(const l3d_method_frame& frame, l3d_stage_times& times) {
    l3d_dice_view view = frame.view;
    l3d_surface_rasterizer& surface = surface_for(frame.shading);
    used_ = &surface;
    const bool with_levels = surface.takes_levels() && !frame.shading.is_lit(frame.materials);
    l3d_shading shading = l3d_lit_while_diced(view, frame.shading, with_levels);
    if (l3d_is_light(shading.mode))
        view.shading.paints = shading.paints =
            pictures_.begin(frame.scene, frame.filter, frame.materials.size());
    if (l3d_sees_patches(shading.mode)) {
        inspected_.begin(frame.camera, view, shading);
        shading.inspected = &inspected_.patches();
    }
    begin_outlines(frame, view, times);
    const stopwatch placing;
    culling_.begin(frame.scene, frame.to_image, view,
                   frame.part.grown(shading.reach()).intersected(l3d_whole(view.size)));
    dicer_.keep_batches(shading.antialias || shading.paints);
    dicer_.begin(view);
    std::span<const l3d_placed_patch> batch = next_batch(surface);
    const bool keep_depth = frame.wants_depth || !culling_.is_done();
    if (keep_depth)
        frame.depth.resize(view.size);
    l3d_depth_buffer* const depth = keep_depth ? &frame.depth : nullptr;
    surface.count_pixels(frame.counts_pixels);
    surface.leave_depth(frame.wants_depth);
    surface.use_materials(frame.materials);
    if (frame.is_part())
        surface.begin_part(frame.target, depth, shading, frame.part);
    else
        surface.begin(frame.target, depth, shading, frame.untouched);
    times.transform += placing.milliseconds();
    while (!batch.empty()) {
        draw_batch(frame, shading, batch, times);
        const stopwatch going_on;
        batch = next_batch(surface);
        times.transform += going_on.milliseconds();
    }
    const stopwatch finishing;
    surface.finish();
    times.raster += finishing.milliseconds();
    counts_ = dicer_.counts();
    counts_.add(culling_.counts());
    counts_.bound_px += counts_.edges_px;
    counts_.depth_bound_px += counts_.edges_px;
    const stopwatch seeking;
    if (outlines_)
        outlines_->finish(counts_.bound_px + frame.curved_px,
                          counts_.depth_bound_px + frame.curved_px, counts_.near_z);
    times.outlines += seeking.milliseconds();
}

template <class T>
void l3d_method_afd<T>::draw_batch(const l3d_method_frame& frame, const l3d_shading& shading,
                                   std::span<const l3d_placed_patch> batch,
                                   l3d_stage_times& times) {
    const stopwatch dicing;
    const auto parts = dicer_.dice(frame.scene, culling_, batch);
    times.dice += dicing.milliseconds();
    add_outlines(batch, times);
    const stopwatch filling;
    if (shading.inspected)
        inspected_.add(frame.scene, batch);
    if (shading.paints)
        pictures_.add(frame.scene, batch, dicer_);
    used_->draw(parts);
    times.raster += filling.milliseconds();
}

template <class T>
void l3d_method_afd<T>::begin_outlines(const l3d_method_frame& frame, const l3d_dice_view& view,
                                       l3d_stage_times& times) {
    const stopwatch beginning;
    if (!frame.outlines || frame.is_part())
        outlines_.reset();
    else if (!outlines_)
        outlines_ = std::make_unique<l3d_frame_outlines>();
    if (outlines_)
        outlines_->begin(frame.scene, frame.to_image, view, frame.camera.focal_length(view.size),
                         std::abs(frame.shading.depth_step) /
                             frame.camera.scale_at_target(view.size));
    times.outlines += beginning.milliseconds();
}

template <class T>
void l3d_method_afd<T>::add_outlines(std::span<const l3d_placed_patch> batch,
                                     l3d_stage_times& times) {
    if (!outlines_)
        return;
    const stopwatch drawing;
    for (std::size_t i = 0; i < batch.size(); ++i)
        outlines_->add(batch[i], dicer_.pieces(i));
    times.outlines += drawing.milliseconds();
}

template class l3d_method_afd<float>;
template class l3d_method_afd<double>;
template class l3d_method_afd<l3d_fixed<std::int64_t, 32>>;
