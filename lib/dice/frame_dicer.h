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

/// The dicer that gets the patches that both dicers can dice.
enum class l3d_dice_way {
    lanes,  ///< the SIMD dicer; the general one takes the rest
    general ///< the general one, the slow twin, takes all
};

/// Dices batches of placed patches into parts for the rasterizer.
///
/// The result of a patch depends on the patch and the view alone, unless the frame's budget runs
/// short. Then it depends on the patches of this batch and of earlier ones, too. Parts come in the
/// order of their patches. So nothing depends on the workers.
///
/// Each batch may spend half of the budget that is left, the last batch all of it. The patches of a
/// batch get equal shares. Patches that keep the tolerance with less leave the rest to the others.
/// These are diced again, as long as that at least doubles their shares. So no frame costs twice
/// its budget.
///
/// For a shade that inspects surfaces, vertices have their parameters in place of normals. A part's
/// material then is the index of its patch in all batches of the frame. In a frame with paints the
/// parameters of vertices are kept, too.
/// Lives: borrows the workers. Parts live until the next batch, or as long as keep_batches() says.
/// Cost:  no allocation in a frame of patches and batches that was drawn before. Else, a worker
///        allocates for a patch that is larger than any that the frame's other workers had. A slot
///        (the i-th place of a batch) allocates for a patch larger than any it held.
template <class T> class l3d_frame_dicer {
public:
    explicit l3d_frame_dicer(l3d_workers& workers, l3d_dice_way way = l3d_dice_way::lanes,
                             bool keep_parameters = false)
        : workers_(workers), way_(way), keep_parameters_(keep_parameters),
          each_worker_(static_cast<std::size_t>(workers.count())) {}

    /// Sets whether the parts of all batches of a frame live until the next frame begins. It takes
    /// effect from the next frame on.
    void keep_batches(bool keep) { keeps_batches_ = keep; }

    /// Starts a frame. Expects: tolerance > 0, near > 0.
    void begin(const l3d_dice_view& view);

    /// Dices a batch of patches, and returns their parts. Expects: the batch comes from this scene
    /// and culling.
    std::span<const l3d_surface_part* const> dice(const l3d_patch_scene& scene,
                                                  const l3d_scene_culling& culling,
                                                  std::span<const l3d_placed_patch> batch);

    /// The result of patch i of the last batch, with the parameters of all vertices if these are
    /// kept.
    std::span<const l3d_diced_piece> pieces(std::size_t i) const {
        return slots_[first_slot_ + i].used();
    }

    /// Names each quad and triangle of patch i of the last batch, and notes the names in `to`. A
    /// name is a number of its own in place of a material. Pieces for which there are not enough
    /// names keep their material.
    /// Expects: a shading with paints; `like` has material, texture and map, `next` the next name.
    void name_polygons(std::size_t i, const l3d_detail::painted_part& like, std::size_t& next,
                       l3d_detail::painted_parts& to);

    /// The counts of all batches of the frame.
    const l3d_dice_counts& counts() const { return counts_; }

private:
    /// A worker's memory. Shape: it begins a pair of cache lines, so that workers do not take each
    /// other's.
    struct alignas(128) worker_space {
        l3d_lane_dicer<T> lanes;
        l3d_patch_dicer<T> general;
        l3d_edge_polylines edges;
        l3d_dice_view view; ///< the frame's, with the errors of the patch that is diced
        l3d_dice_counts counts;
        l3d_bend_bounds bends;                      ///< bends of the patch that is diced
        std::optional<l3d_surface_bends> own_bends; ///< where the placement is no similarity
        l3d_trim_cells trims;
        l3d_grid_trims trims_of_piece; ///< where a patch has several pieces
        l3d_grid_trims::workshop workshop;

        void reserve_as(const worker_space& other) {
            general.reserve_as(other.general);
            edges.reserve_as(other.edges);
        }
    };

    /// The result of a patch of the batch.
    struct outcome {
        l3d_dice_counts counts;
        std::int64_t cost = 0;
        bool is_short = false; ///< the tolerance is exceeded, and a larger share would keep it
    };

    /// A batch, and its slots that are to be diced.
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

    /// The polylines of an instance's edges, once a patch of it follows any.
    struct instance_edges {
        bool is_made = false;
        std::vector<l3d_shared_polyline> lines;
        double off_px = 0; ///< the most that any is off its faces
    };

    l3d_workers& workers_;
    l3d_dice_way way_;
    bool keep_parameters_;
    l3d_dice_view view_; ///< the frame's, its near plane where the camera's is
    l3d_dice_counts counts_;
    std::vector<worker_space> each_worker_;
    std::vector<instance_edges> edges_;           ///< by the scene's instances
    std::map<const void*, l3d_kept_trims> trims_; ///< by the models' identities
    std::uint64_t frame_ = 0;
    l3d_piece_pool& slot(std::size_t i) { return slots_[first_slot_ + i]; }

    std::vector<l3d_piece_pool> slots_; ///< one for each patch of a batch, or of all batches
    std::size_t first_slot_ = 0, next_slot_ = 0; ///< the last batch's; the one behind it
    std::size_t patches_before_ = 0; ///< patches in the frame's batches before the last one
    bool keeps_batches_ = false;
    std::vector<outcome> outcomes_;   ///< one for each patch of the last batch
    std::vector<std::size_t> wanted_; ///< the slots that are to be diced
    std::int64_t budget_left_ = 0;
    std::vector<const l3d_surface_part*> parts_;
    l3d_detail::height_order by_height_; ///< the patches of a batch
};

#endif
