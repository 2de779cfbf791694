// SPDX-License-Identifier: MIT
// l3d_pipeline_afd: curves in space on the surfaces' picture, hidden by the surfaces' depth.
#include "pipeline/pipeline_afd_p.h"

#include "scene/flat_space_curve_p.h"

void l3d_pipeline_afd::draw_curves(const l3d_shading& shading) {
    if (curves_.empty())
        return;
    rasterizer().finish();
    const l3d_pixels target = screen_->pixels();
    for (const l3d_space_curve& curve : curves_) {
        // Surfaces and chords keep the tolerance each, so they may be off by twice as much.
        const l3d_detail::depth_lines::line line{.depth = depth_,
                                                 .width = curve.width(),
                                                 .error = 2 * settings_.tolerance,
                                                 .focal = camera_.focal_length(target.size()),
                                                 .smooth = settings_.antialias};
        for (const l3d_detail::depth_chord& chord :
             l3d_detail::flat_space_curve(curve, camera_, target.size(), settings_.tolerance))
            stages_->lines.add(line, chord[0], chord[1]);
        stages_->lines.paint(target, curve.color(), shading);
    }
}
