// SPDX-License-Identifier: MIT
// l3d_method_afd: adaptive forward differencing, the library's own method.
#ifndef L3D_PIPELINE_METHOD_AFD_H
#define L3D_PIPELINE_METHOD_AFD_H

#include "dice/frame_dicer.h"
#include "dice/outlines/frame_outlines.h"
#include "scene/inspected_scene.h"
#include "scene/culling/scene_culling.h"
#include "pipeline/surface_method.h"
#include "pipeline/laid_pictures_p.h"
#include "raster/rasterizer_factory.h"
#include "raster/parallel/workers.h"

#include <memory>

/// Draws surfaces by adaptive forward differencing: leaves out patches that cannot be seen, dices
/// the remaining patches into quads within the tolerance, and fills the quads. It works batch after
/// batch, from the nearest patches to the farthest.
///
/// Lives: borrows the workers.
/// Cost:  once the largest frame has been drawn, frames without outlines allocate nothing.
template <class T> class l3d_method_afd final : public l3d_surface_method {
public:
    l3d_method_afd(const l3d_rasterizer_factory& rasterizers, l3d_workers& workers);

private:
    std::string do_renderer() const override { return used_->describe(); }
    bool do_certifies_depth() const override { return true; }
    bool do_certifies_shade(const l3d_shading& shading) const override {
        return shading.mode == l3d_shade::lambert && surface_->takes_levels();
    }
    bool do_draws_parts() const override { return surface_->draws_parts(); }
    void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) override;
    const l3d_dice_counts& do_counts() const override { return counts_; }
    const l3d_surface_counts& do_surface_counts() const override { return used_->counts(); }
    const l3d_pixel_bits* do_outlines() const override {
        return outlines_ ? &outlines_->mask() : nullptr;
    }

    l3d_surface_rasterizer& surface_for(const l3d_shading& shading);
    std::span<const l3d_placed_patch> next_batch(const l3d_surface_rasterizer& surface);
    void draw_batch(const l3d_method_frame& frame, const l3d_shading& shading,
                    std::span<const l3d_placed_patch> batch, l3d_stage_times& times);
    void begin_outlines(const l3d_method_frame& frame, const l3d_dice_view& view,
                        l3d_stage_times& times);
    void add_outlines(std::span<const l3d_placed_patch> batch, l3d_stage_times& times);

    l3d_workers& workers_;
    std::unique_ptr<l3d_surface_rasterizer> surface_;
    /// The rasterizer for inspecting shades, if `surface_` cannot draw them.
    std::unique_ptr<l3d_surface_rasterizer> inspector_;
    l3d_surface_rasterizer* used_; ///< the rasterizer that drew the last frame
    l3d_inspected_scene inspected_;
    l3d_detail::laid_pictures pictures_;
    l3d_scene_culling culling_;
    l3d_frame_dicer<T> dicer_;
    l3d_dice_counts counts_;
    /// Outlines of the last frame, if the frame asked for outlines.
    std::unique_ptr<l3d_frame_outlines> outlines_;
};

#endif
