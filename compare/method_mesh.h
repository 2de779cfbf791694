// SPDX-License-Identifier: MIT
// l3d_method_mesh: methods that make polygons of patches, for the common rasterizer.
#ifndef L3D_COMPARE_METHOD_MESH_H
#define L3D_COMPARE_METHOD_MESH_H

#include "compare/method_patches.h"
#include "pipeline/surface_method.h"
#include "raster/rasterizer_factory.h"
#include "raster/parallel/workers.h"

#include <concepts>
#include <cstddef>
#include <memory>
#include <vector>

/// Makes polygons of a patch that needs no clipping (l3d_needs_no_clipping), and adds their
/// certified error to the counts.
template <class D>
concept l3d_mesh_dicer = std::copy_constructible<D> &&
    requires(D dicer, const l3d_image_patch& net, const l3d_normal_net& normals,
             const l3d_dice_view& view, l3d_piece_pool& out, l3d_dice_counts& counts) {
    dicer.dice(net, normals, view, out, counts);
};

/// Draws all patches in one batch. Each worker has its own copy of `Dicer`, which dices ordinary
/// patches. In every method, l3d_patch_dicer dices the patches that need clipping.
///
/// Lives: borrows the workers.
template <l3d_mesh_dicer Dicer> class l3d_method_mesh final : public l3d_surface_method {
public:
    l3d_method_mesh(const l3d_rasterizer_factory& rasterizers, l3d_workers& workers,
                    const Dicer& dicer)
        : workers_(workers), surface_(rasterizers.create_surface(workers)),
          dicers_(static_cast<std::size_t>(workers.count()), dicer), patches_(workers) {}

private:
    void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) override {
        const l3d_detail::stopwatch dicing;
        const auto parts = patches_.dice_each(
            frame, [this](const l3d_method_patch& patch, const l3d_dice_view& view, int worker,
                          l3d_piece_pool& out, l3d_dice_counts& counts) {
                dicers_[static_cast<std::size_t>(worker)].dice(patch.net, patch.normals, view, out,
                                                               counts);
            });
        times.dice += dicing.milliseconds();
        l3d_fill_parts(*surface_, frame, parts, times);
    }
    std::string do_renderer() const override { return surface_->describe(); }
    const l3d_dice_counts& do_counts() const override { return patches_.counts(); }
    const l3d_surface_counts& do_surface_counts() const override { return surface_->counts(); }

    l3d_workers& workers_;
    std::unique_ptr<l3d_surface_rasterizer> surface_;
    std::vector<Dicer> dicers_;
    l3d_method_patches patches_;
};

#endif
