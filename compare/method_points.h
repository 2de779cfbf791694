// SPDX-License-Identifier: MIT
// l3d_method_points: methods that find the pixels of patches themselves.
#ifndef L3D_COMPARE_METHOD_POINTS_H
#define L3D_COMPARE_METHOD_POINTS_H

#include "compare/plotters/plot_task.h"
#include "compare/method_patches.h"
#include "pipeline/surface_method.h"
#include "compare/plotters/point_canvas.h"
#include "raster/rasterizer_factory.h"
#include "raster/parallel/workers.h"

#include <memory>
#include <vector>

/// Puts the pixels of a patch that needs no clipping (l3d_needs_no_clipping) on a canvas.
template <class P>
concept l3d_point_plotter = requires(P plotter, const l3d_image_patch& net,
                                     const l3d_plot_task& of) {
    plotter.plot(net, of);
};

/// Draws pixels without polygons. First l3d_patch_dicer draws the patches that need clipping. Then
/// a `Plotter` draws all others, patch after patch, on one thread.
/// Lives:   borrows the workers, which tell whether to go on.
template <l3d_point_plotter Plotter> class l3d_method_points final : public l3d_surface_method {
public:
    l3d_method_points(const l3d_rasterizer_factory& rasterizers, l3d_workers& asked,
                      const Plotter& plotter = Plotter())
        : asked_(asked), surface_(rasterizers.create_surface(worker_)), plotter_(plotter) {}

private:
    void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) override {
        const l3d_detail::stopwatch dicing;
        ordinary_.clear();
        const auto parts = patches_.dice_each(
            frame, [this](const l3d_method_patch& patch, const l3d_dice_view&, int, l3d_piece_pool&,
                          l3d_dice_counts&) { ordinary_.push_back(patch); });
        times.dice += dicing.milliseconds();

        const l3d_detail::stopwatch filling;
        frame.depth.resize(frame.view.size);
        surface_->count_pixels(false);
        l3d_shading shading = frame.shading;
        shading.antialias = false; // points have no edges
        surface_->use_materials(frame.materials);
        surface_->begin(frame.target, &frame.depth, shading);
        surface_->draw(parts);
        surface_->finish();
        canvas_.begin(frame.target, frame.depth, frame.shading);
        counts_ = patches_.counts();
        for (const l3d_method_patch& patch : ordinary_) {
            asked_.ask();
            canvas_.set_color(patch.color);
            plotter_.plot(patch.net, {patch.normals, frame.view, canvas_, counts_});
        }
        surface_counts_ = surface_->counts();
        surface_counts_.samples += canvas_.counts().samples;
        surface_counts_.written += canvas_.counts().written;
        surface_counts_.covered = covered_of(frame, frame.depth);
        times.raster += filling.milliseconds();
    }
    const l3d_dice_counts& do_counts() const override { return counts_; }
    const l3d_surface_counts& do_surface_counts() const override { return surface_counts_; }

    l3d_workers& asked_;
    l3d_workers worker_{1};
    std::unique_ptr<l3d_surface_rasterizer> surface_;
    l3d_method_patches patches_{worker_};
    std::vector<l3d_method_patch> ordinary_;
    Plotter plotter_;
    l3d_point_canvas canvas_;
    l3d_dice_counts counts_;
    l3d_surface_counts surface_counts_;
};

#endif
