// SPDX-License-Identifier: MIT
// l3d_frame_outlines: finds the pixels of a frame in which an outline may change the visible
// surface.
#ifndef L3D_DICE_OUTLINES_FRAME_OUTLINES_H
#define L3D_DICE_OUTLINES_FRAME_OUTLINES_H

#include "scene/dice_view.h"
#include "dice/diced_piece.h"
#include "scene/patch_scene.h"
#include "scene/sides/patch_neighbours.h"
#include "scene/culling/scene_culling.h"
#include "raster/pixel_bits.h"
#include "raster/two_layer_depths.h"

#include <map>
#include <span>

/// Finds the outline pixels of a frame. In these pixels, an error of a drawn outline may change
/// which surface is visible. The object gathers the frame's surfaces, and searches their outlines
/// when all surfaces are drawn (NUMERICS, section 9, Outlines).
///
/// Lives: borrows the scene from begin to finish.
/// Cost:  36 bytes a pixel. All surfaces are drawn once more, on one thread. l3d_outline_search
///        looks at all patches of the scene, also at patches that cover no pixel.
class l3d_frame_outlines {
public:
    /// Starts a frame.
    /// Shape: `to_image` maps the world to the view's units. In a parallel projection, the depth
    ///        changes by `depth_by_pixel` where the distance changes by a pixel's width. In
    ///        perspective, `depth_by_pixel` is 0.
    /// Units: `focal` in pixels.
    void begin(const l3d_patch_scene& scene, const l3d_matrix<double>& to_image,
               const l3d_dice_view& view, double focal, double depth_by_pixel);

    /// Adds the diced pieces of a patch. Patches of which nothing is drawn may be left out.
    void add(const l3d_placed_patch& patch, std::span<const l3d_diced_piece> pieces);

    /// Finds all outlines.
    /// Units: bounds in pixels; `near` is in the view's w, as l3d_dice_counts::near_z, or 0 for the
    ///        view's near plane.
    void finish(double bound_px, double depth_bound_px, double near);

    /// The outlines of the last frame that was finished.
    const l3d_pixel_bits& mask() const { return mask_; }

private:
    const l3d_patch_neighbours& sides_of(const l3d_patch_model& model);

    const l3d_patch_scene* scene_ = nullptr;
    l3d_matrix<double> to_image_;
    l3d_dice_view view_;
    double focal_ = 1, depth_by_pixel_ = 0;
    /// The sides that may be outlines of the frame's models, by l3d_patch_model::identity().
    std::map<const void*, l3d_patch_neighbours> sides_;
    l3d_two_layer_depths depths_;
    l3d_pixel_bits mask_;
};

#endif
