// SPDX-License-Identifier: MIT
// l3d_method_patches: a frame's patches, as the methods that are compared take them.
#ifndef L3D_COMPARE_METHOD_PATCHES_H
#define L3D_COMPARE_METHOD_PATCHES_H

#include "dice/piece_pool.h"
#include "dice/edges/edge_polylines.h"
#include "dice/patch_dicer.h"
#include "scene/culling/scene_culling.h"
#include "pipeline/stopwatch_p.h"
#include "pipeline/surface_method.h"
#include "raster/parallel/workers.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

/// A patch in the image, with all that a method needs to draw it. Lives: pointers are valid until
/// the frame's end.
struct l3d_method_patch {
    l3d_image_patch net;
    l3d_normal_net normals;
    std::uint32_t color = 0xffffff;                  ///< colour of its material
    std::uint32_t material = 0;                      ///< the index of the material
    l3d_placed_patch placed{};                       ///< instance and number of the patch
    const l3d_patch_model::patch* surface = nullptr; ///< the patch in its model's space
    const l3d_matrix<double>* to_image = nullptr;    ///< from the model's space
};

/// Whether a net lies wholly between the near and the far plane, and in the guard band.
bool l3d_needs_no_clipping(const l3d_image_patch& net, const l3d_dice_view& view);

/// The patches of a frame that may be seen. Culling finds the same ones for every method.
///
/// The methods are compared on ordinary patches. Patches that need clipping are diced by
/// l3d_patch_dicer in every method, and counted as `clipped`.
/// Lives: borrows the workers.
class l3d_method_patches {
public:
    explicit l3d_method_patches(l3d_workers& workers)
        : workers_(workers), each_worker_(static_cast<std::size_t>(workers.count())) {}

    using dice_call = std::function<void(const l3d_method_patch&, const l3d_dice_view&, int worker,
                                         l3d_piece_pool&, l3d_dice_counts&)>;

    /// Calls `dice` for each ordinary patch, on any worker. Returns the parts of all patches, in an
    /// order that depends on the frame alone.
    /// Lives:   the parts are valid until the next call.
    std::span<const l3d_surface_part* const> dice_each(const l3d_method_frame& frame,
                                                       const dice_call& dice);

    /// The counts of the last frame.
    const l3d_dice_counts& counts() const { return counts_; }

private:
    struct worker_space {
        l3d_patch_dicer<double> clipping;
        l3d_edge_polylines edges;
        l3d_dice_counts counts;
    };

    void dice_one(const l3d_method_frame& frame, const l3d_placed_patch& placed,
                  const dice_call& dice, int worker, l3d_piece_pool& out);

    l3d_workers& workers_;
    std::vector<worker_space> each_worker_;
    l3d_scene_culling culling_;
    l3d_dice_counts counts_;
    std::vector<l3d_piece_pool> slots_; ///< one for each patch
    std::vector<const l3d_surface_part*> parts_;
};

/// Fills diced surfaces for methods without smooth edges, and adds the time to times.raster.
void l3d_fill_parts(l3d_surface_rasterizer& surface, const l3d_method_frame& frame,
                    std::span<const l3d_surface_part* const> parts, l3d_stage_times& times);

#endif
