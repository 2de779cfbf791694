// SPDX-License-Identifier: MIT
// l3d_kept_trims: keeps the trimmed grids of a model, for all its instances and for the next frame.
#ifndef L3D_DICE_KEPT_TRIMS_H
#define L3D_DICE_KEPT_TRIMS_H

#include "geom/trims/grid_trims.h"
#include "scene/patch_model.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

/// Keeps what trims leave of the quads in grids of a model's patches. Two instances share a result
/// if their grids of a patch have the same lines. Most grids have the same lines as in the frame
/// before, so their results are used again.
///
/// Lives: a result lives as long as every frame asks for it. The object keeps its model alive.
/// Cost:  no allocation for grids that the frame before had.
class l3d_kept_trims {
public:
    explicit l3d_kept_trims(const l3d_patch_model& model)
        : model_(model), patches_(model.patches().size()) {}

    /// Notes that the frame with this number draws the model.
    void take_frame(std::uint64_t frame) { frame_ = frame; }

    /// Returns what trims leave of a grid of this patch, whose lines are at the parameters u and v.
    /// The result is made if it is not kept yet. Several threads may call at once.
    /// Lives: until forget_all_but() is called for a frame that did not ask for this grid.
    const l3d_grid_trims& of(std::size_t patch, std::span<const double> u,
                             std::span<const double> v, l3d_grid_trims::workshop& in) {
        of_patch& all = patches_[patch];
        const std::lock_guard lock(all.mutex);
        auto one = std::ranges::find_if(all.grids,
                                        [&](const auto& grid) { return grid->trims.is_for(u, v); });
        if (one == all.grids.end()) {
            one = all.grids.insert(one, std::make_unique<of_grid>());
            (*one)->trims.make(*model_.trim(patch), u, v, in);
        }
        (*one)->frame = frame_;
        return (*one)->trims;
    }

    /// Forgets the grids that the given frame did not ask for. Returns whether that frame drew the
    /// model.
    bool forget_all_but(std::uint64_t frame) {
        for (of_patch& all : patches_)
            std::erase_if(all.grids, [&](const auto& grid) { return grid->frame != frame; });
        return frame_ == frame;
    }

private:
    struct of_grid {
        l3d_grid_trims trims;
        std::uint64_t frame = 0; ///< the last frame that asked for this grid
    };
    struct of_patch {
        std::mutex mutex;
        std::vector<std::unique_ptr<of_grid>> grids;
    };

    l3d_patch_model model_;
    std::vector<of_patch> patches_;
    std::uint64_t frame_ = 0;
};

#endif
