// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: frames and picks models, and gives the reasons for an empty picture.
#include "pipeline/pipeline_afd.h"

#include "pipeline/empty_picture_p.h"
#include "geom/normal_net.h"
#include "scene/camera_shading.h"
#include "scene/camera.h"
#include "scene/inspected_scene.h"

#include <cstddef>

namespace {

/// Whether a scene has patches that could be seen, but all of these patches lack an area: all their
/// normals are zero. Instances of opacity 0 do not count.
bool is_without_area(const l3d_patch_scene& scene) {
    bool has_patches = false;
    for (const l3d_patch_instance& instance : scene.instances()) {
        if (instance.opacity() == 0)
            continue;
        const l3d_patch_model& model = instance.model();
        for (std::size_t i = 0; i < model.patches().size(); ++i) {
            has_patches = true;
            for (int row = 0; row < 6; ++row)
                for (int column = 0; column < 6; ++column)
                    if (model.normals(i).at(row, column) != l3d_normal_net::vector(0))
                        return false;
        }
    }
    return has_patches;
}

} // namespace

void l3d_pipeline_afd::frame_all() {
    camera_ = l3d_framed(camera_, screen_->pixels().size(), l3d_reach_of(scene_));
    redraw();
}

l3d_camera l3d_pipeline_afd::framed_unless_well(const l3d_camera& usual) const {
    return l3d_framed_unless_well(usual, screen_->pixels().size(), l3d_reach_of(scene_));
}

l3d_frame_lights l3d_pipeline_afd::lights() const {
    return settings_.headlight ? l3d_headlight(camera_, settings_.lighting)
                               : l3d_frame_lights{settings_.light, settings_.lighting};
}

std::optional<l3d_pick> l3d_pipeline_afd::pick(double x, double y) const {
    return l3d_pick_at(
        scene_, {camera_, screen_->pixels().size(), settings_.one_sided, settings_.section}, x, y);
}

std::string l3d_pipeline_afd::why_empty() const {
    const auto is_empty = [&] {
        return l3d_detail::is_empty(screen_->pixels(), settings_.background);
    };
    if (is_without_area(scene_) && is_empty()) // lines may be seen all the same
        return l3d_without_area;
    std::string why = l3d_why_unseen(camera_, screen_->pixels().size(), l3d_reach_of(scene_));
    if (why == l3d_smaller_than_a_pixel && !is_empty())
        return "";
    const l3d_dice_counts& dice = report_.dice;
    // Some methods draw without counting patches.
    const bool left_all_out = dice.drawn == 0 && dice.offscreen + dice.subpixel + dice.behind +
                                                         dice.beyond + dice.backfacing >=
                                                     scene_.patch_count();
    return why.empty() && left_all_out ? "not where a pixel shows it" : why;
}

l3d_inspection l3d_pipeline_afd::inspection() {
    l3d_inspection result = settings_.inspection;
    if (result.scale > 0)
        return result;
    const l3d_shade shade = settings_.shade;
    if (shade == l3d_shade::draft)
        result.scale = l3d_inspection::usual_draft;
    if (shade != l3d_shade::gaussian && shade != l3d_shade::mean)
        return result;
    if (!usual_curvature_ || usual_curvature_->first != shade || scene_.is_changed())
        usual_curvature_.emplace(shade, l3d_usual_curvature(scene_, shade));
    result.scale = usual_curvature_->second;
    return result;
}

l3d_frame_report l3d_pipeline_afd::report() const {
    l3d_frame_report result = report_;
    result.hash = l3d_hash(screen_->pixels());
    return result;
}
