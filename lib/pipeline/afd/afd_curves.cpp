// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: draws curves in space on the surfaces' picture, hidden by the surfaces' depth.
#include "pipeline/afd/pipeline_afd_p.h"

#include "scene/drawing/edge_lines.h"
#include "scene/drawing/flat_space_curve_p.h"

#include <algorithm>

void l3d_pipeline_afd::draw_curves(const l3d_shading& shading) {
    if (!has_curves())
        return;
    auto& edges = stages_->edges;
    std::erase_if(edges, [&](const auto& kept) {
        return std::ranges::none_of(scene_.instances(), [&](const l3d_patch_instance& i) {
            return i.model().identity() == kept.first;
        });
    });
    rasterizer().finish();
    const l3d_pixels target = screen_->pixels();
    const l3d_size size = target.size();
    const l3d_detail::depth_law law{.focal = camera_.is_parallel() ? camera_.scale_at_target(size)
                                                                   : camera_.focal_length(size),
                                    .base = shading.depth_base,
                                    .step = shading.depth_step};
    const auto draw = [&](const l3d_space_curve& curve) {
        // Surfaces and chords may each be off by the tolerance, so they may differ by twice as
        // much.
        const l3d_detail::depth_lines::line line{.depth = depth_,
                                                 .width = curve.width(),
                                                 .error = 2 * settings_.tolerance +
                                                          report_.dice.edges_px,
                                                 .law = law,
                                                 .smooth = settings_.antialias};
        for (const l3d_detail::depth_chord& chord : l3d_detail::flat_space_curve(
                 curve, camera_, size, settings_.tolerance, law, settings_.section))
            stages_->lines.add(line, chord[0], chord[1]);
        stages_->lines.paint(target, curve.color(), shading);
    };
    for (const l3d_patch_instance& instance : scene_.instances())
        for (const l3d_space_curve& curve : instance.model().curves())
            draw(curve.placed(instance.placement() * curve.placement()));
    if (settings_.edges)
        for (const l3d_patch_instance& instance : scene_.instances()) {
            const auto [kept, is_new] = edges.try_emplace(instance.model().identity());
            if (is_new)
                kept->second = l3d_edge_lines(instance.model());
            for (const l3d_space_curve& curve : kept->second)
                draw(curve.placed(instance.placement()));
        }
    std::ranges::for_each(curves_, draw);
}
