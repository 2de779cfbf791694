// SPDX-License-Identifier: MIT
// l3d_frame_outlines: the pixels of a frame in which outlines leave open what is seen.
#ifndef L3D_DICE_FRAME_OUTLINES_H
#define L3D_DICE_FRAME_OUTLINES_H

#include "dice/dice_view.h"
#include "dice/diced_piece.h"
#include "dice/patch_scene.h"
#include "dice/patch_sides.h"
#include "dice/scene_culling.h"
#include "raster/outline_mask.h"
#include "raster/sheet_depths.h"

#include <map>
#include <span>
#include <vector>

/// Gathers what a frame draws, and finds its outlines when all is drawn (NUMERICS, Outlines).
///
/// Lives: borrows the scene from begin to finish, models as long as it is used.
/// Cost:  memory for 36 bytes a pixel; time for drawing all once more on one thread, and
///        l3d_outline_search.
class l3d_frame_outlines {
public:
    /// Units: focal in pixels.
    void begin(const l3d_patch_scene& scene, const l3d_dice_view& view, double focal);

    /// A patch of the frame, and what became of it.
    /// Shape: to_image as culling.matrix has it.
    void add(const l3d_placed_patch& patch, const l3d_matrix<double>& to_image,
             std::span<const l3d_diced_piece> pieces);

    /// Finds all outlines. Units: pixels; the nearest w drawn, in the view's, or 0.
    void finish(double bound_px, double depth_bound_px, double near);

    /// Of the last frame that was finished.
    const l3d_outline_mask& mask() const { return mask_; }

private:
    struct placed {
        const l3d_patch_instance* instance;
        std::uint32_t patch;
        l3d_matrix<double> to_image;
    };

    const l3d_patch_sides& sides_of(const l3d_patch_model& model);

    const l3d_patch_scene* scene_ = nullptr;
    l3d_dice_view view_;
    double focal_ = 1;
    std::vector<placed> placed_;
    std::map<const l3d_patch_model*, l3d_patch_sides> sides_; ///< of the frame's models
    l3d_sheet_depths depths_;
    l3d_outline_mask mask_;
};

#endif
