// SPDX-License-Identifier: MIT
// l3d_frame_dicer: dices many patches on all workers.
#ifndef L3D_DICE_FRAME_DICER_H
#define L3D_DICE_FRAME_DICER_H

#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/kept_trims.h"
#include "dice/piece_pool.h"
#include "dice/edges/edge_polylines.h"
#include "dice/edges/shared_polylines.h"
#include "dice/lanes/lane_dicer.h"
#include "dice/patch_dicer.h"
#include "dice/trim_cells.h"
#include "scene/culling/scene_culling.h"
#include "raster/parallel/height_order_p.h"
#include "raster/parallel/workers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

/// Which dicer gets a patch that both the lane dicer and the general dicer can dice.
enum class l3d_dice_way {
    lanes,  ///< l3d_lane_dicer takes the patch, in SIMD lanes
    general ///< l3d_patch_dicer takes the patch; it is the lane dicer's slow twin
};

/// Dices the patches of a frame, batch by batch, into parts for the rasterizer.
///
/// A patch and the view alone decide how the patch is diced, as long as the frame's budget lasts.
/// If the budget runs short, the patches of this batch and of earlier batches decide, too. Parts
/// come in the order of their patches. So the result does not depend on the number or the speed of
/// workers.
///
/// Each batch may spend half of the budget that is left, and the last batch all that is left. The
/// patches of a batch get equal shares. Patches that keep the tolerance with less than their share
/// leave the rest to the other patches. These other patches are diced again, as long as this at
/// least doubles their shares. So no frame costs twice its budget.
///
/// For a shade that inspects surfaces, vertices have their parameters in place of normals. In this
/// case, the material of a part is a patch's index among all patches of the frame. In a frame with
/// pictures on surfaces, the parameters of vertices are kept, too.
/// Lives: borrows the workers. Parts live until the next batch, or as long as keep_batches() says.
/// Cost:  no allocation in a frame whose patches and batches were drawn before. Otherwise a worker
///        allocates for a patch that is larger than any other in the frame. A slot (the i-th place
///        of a batch) allocates for a patch larger than all that it held before.
template <class T> class l3d_frame_dicer {
public:
    explicit l3d_frame_dicer(l3d_workers& workers, l3d_dice_way way = l3d_dice_way::lanes,
                             bool keep_parameters = false)
        : workers_(workers), way_(way), keep_parameters_(keep_parameters),
          each_worker_(static_cast<std::size_t>(workers.count())) {}

    /// Sets, from the next frame on, whether the parts of all batches live until the following
    /// frame begins.
    void keep_batches(bool keep) { keeps_batches_ = keep; }

    /// Starts a frame. Expects: tolerance > 0, near > 0.
    void begin(const l3d_dice_view& view);

    /// Dices a batch of patches, and returns their parts. Expects: a batch that `culling` handed
    /// out for this scene.
    std::span<const l3d_surface_part* const> dice(const l3d_patch_scene& scene,
                                                  const l3d_scene_culling& culling,
                                                  std::span<const l3d_placed_patch> batch);

    /// The pieces of patch i of the last batch. The pieces have the parameters of all vertices if
    /// the dicer keeps parameters.
    std::span<const l3d_diced_piece> pieces(std::size_t i) const {
        return slots_[first_slot_ + i].used();
    }

    /// Gives each quad and triangle of patch i of the last batch a number of its own, a name, in
    /// place of a material. By its name, the rasterizer finds the parameters of a polygon under a
    /// picture. The names are noted in `to`. Pieces for which not enough names are left keep their
    /// material.
    /// Expects: a shading with paints; `like` has material, texture and map; `next` is the next
    ///          free name.
    void name_polygons(std::size_t i, const l3d_detail::painted_part& like, std::size_t& next,
                       l3d_detail::painted_parts& to);

    /// The counts of all batches of the frame.
    const l3d_dice_counts& counts() const { return counts_; }

private:
    /// The memory of a worker. Shape: it begins a pair of cache lines, so that no two workers share
    /// a line.
    struct alignas(128) worker_space {
        l3d_lane_dicer<T> lanes;
        l3d_patch_dicer<T> general;
        l3d_edge_polylines edges;
        l3d_dice_view view; ///< the frame's view, with the errors of the patch that is being diced
        l3d_dice_counts counts;
        l3d_bend_bounds bends; ///< bends of the patch that is being diced
        /// The bends of the patch that is being diced, computed where its placement is no
        /// similarity.
        std::optional<l3d_surface_bends> own_bends;
        l3d_trim_cells trims;
        /// The trims of one piece's grid, for patches of several pieces.
        l3d_grid_trims trims_of_piece;
        l3d_grid_trims::workshop workshop;

        void reserve_as(const worker_space& other) {
            general.reserve_as(other.general);
            edges.reserve_as(other.edges);
        }
    };

    /// The counts and the cost of dicing one patch of the batch.
    struct outcome {
        l3d_dice_counts counts;
        std::int64_t cost = 0;
        /// Whether the patch exceeds the tolerance, and would keep it with a larger share.
        bool is_short = false;
    };

    /// The batch that is being diced, and its scene.
    struct task {
        const l3d_patch_scene& scene;
        const l3d_scene_culling& culling;
        std::span<const l3d_placed_patch> batch;
    };

    void make_polylines(const task& of);
    void prepare_trims(const task& of);
    void dice_slots(const task& of, std::int64_t share);
    void dice_short_ones(const task& of, std::int64_t allowance, std::int64_t share);
    void dice_slot(std::size_t i, const task& of, std::int64_t share, worker_space& space);
    void dice_placed(std::size_t i, const task& of, l3d_dice_budget& budget, worker_space& space);
    void share_memory_sizes();
    unsigned backs_of(const l3d_patch_instance& instance, const l3d_matrix<double>& to_image,
                      std::size_t patch) const;
    unsigned folds_of(const l3d_patch_instance& instance, const l3d_matrix<double>& to_image,
                      std::size_t patch) const;
    void trim(const l3d_patch_model& model, std::size_t patch, l3d_piece_pool& out,
              bool keeps_parameters, worker_space& space);
    void build_edges(const l3d_patch_instance& instance, const l3d_matrix<double>& to_image,
                     std::size_t patch, const l3d_image_patch& net, worker_space& space) const;
    void dice_patch(const l3d_image_patch& net, const l3d_normal_net& normals, unsigned backs,
                    l3d_piece_pool& out, l3d_dice_budget& budget, worker_space& space) const;

    /// The polylines of an instance's edges. The polylines are made when the first of the
    /// instance's patches that follow edges is diced.
    struct instance_edges {
        bool is_made = false;
        std::vector<l3d_shared_polyline> lines;
        double off_px = 0; ///< the largest distance of an edge from its faces, in pixels
    };

    l3d_workers& workers_;
    l3d_dice_way way_;
    bool keep_parameters_;
    l3d_dice_view view_; ///< the frame's view, with the camera's own near plane
    l3d_dice_counts counts_;
    std::vector<worker_space> each_worker_;
    std::vector<instance_edges> edges_; ///< edges of each of the scene's instances
    /// Kept trims of each model, by l3d_patch_model::identity().
    std::map<const void*, l3d_kept_trims> trims_;
    std::uint64_t frame_ = 0;
    l3d_piece_pool& slot(std::size_t i) { return slots_[first_slot_ + i]; }

    std::vector<l3d_piece_pool> slots_; ///< pieces of each patch of a batch, or of all batches
    /// The index of the last batch's first slot, and the index behind its last slot.
    std::size_t first_slot_ = 0, next_slot_ = 0;
    std::size_t patches_before_ = 0; ///< patches in the frame's batches before the last one
    bool keeps_batches_ = false;
    std::vector<outcome> outcomes_;   ///< the outcome for each patch of the last batch
    std::vector<std::size_t> wanted_; ///< the slots that are to be diced
    std::int64_t budget_left_ = 0;
    std::vector<const l3d_surface_part*> parts_;
    l3d_detail::height_order by_height_; ///< the patches of a batch, sorted by their height
};

#endif
