// SPDX-License-Identifier: MIT
// l3d_frame_outlines: marks pixels with close sheets, and with visible outlines.
#include "dice/outlines/frame_outlines.h"

#include "dice/outlines/outline_search.h"
#include "scene/placed_net.h"
#include "scene/model_eye.h"
#include "scene/culling/facing_cones.h"

#include <algorithm>
#include <cmath>

void l3d_frame_outlines::begin(const l3d_patch_scene& scene, const l3d_matrix<double>& to_image,
                               const l3d_dice_view& view, double focal, double depth_by_pixel) {
    scene_ = &scene;
    to_image_ = to_image;
    view_ = view;
    focal_ = focal;
    depth_by_pixel_ = depth_by_pixel;
    sides_.clear(); // a new model may have the identity of a gone one
    depths_.begin(view.size, focal, depth_by_pixel);
}

const l3d_patch_neighbours& l3d_frame_outlines::sides_of(const l3d_patch_model& model) {
    return sides_.try_emplace(model.identity(), model).first->second;
}

void l3d_frame_outlines::add(const l3d_placed_patch& patch,
                             std::span<const l3d_diced_piece> pieces) {
    const l3d_patch_model& model = scene_->instances()[patch.instance].model();
    const auto touching = sides_of(model).touching(patch.patch);
    for (const l3d_diced_piece& piece : pieces)
        depths_.add(piece.part, {patch.instance, patch.patch, touching});
}

void l3d_frame_outlines::finish(double bound_px, double depth_bound_px, double near) {
    mask_.begin(view_.size);
    // If depth has no bound, the bound of places stands for it.
    const double depth_bound = std::isfinite(depth_bound_px) ? depth_bound_px : bound_px;
    const double bound = std::max(bound_px, depth_bound);
    for (int y = 0; y < view_.size.height; ++y)
        for (int x = 0; x < view_.size.width; ++x)
            if (depths_.gap(x, y) <= bound || !std::isfinite(bound))
                mask_.set(x, y);
    if (!std::isfinite(bound))
        return;
    l3d_outline_search search(view_,
                              {.focal = focal_,
                               .depth_by_pixel = depth_by_pixel_,
                               .places = bound_px,
                               .depth = depth_bound,
                               .farthest_near = near},
                              depths_, mask_);
    for (const l3d_patch_instance& instance : scene_->instances()) {
        const l3d_matrix<double> to_image = to_image_ * instance.placement();
        const l3d_patch_model& model = instance.model();
        const auto eye = l3d_eye_of(to_image);
        for (std::size_t i = 0; eye && i < model.patches().size(); ++i) {
            // A patch that shows backs alone, which are not drawn, has no outlines.
            if (view_.one_sided && model.facing(i).away_from(*eye, 1) == l3d_facing_cones::all)
                continue;
            const auto& patch = model.patches()[i];
            search.add(patch, model.normals(i), *eye, l3d_placed_net(to_image, patch),
                       sides_of(model).outlines(i),
                       view_.share_of(instance.reach(model.reach(i).whole)));
        }
    }
}
