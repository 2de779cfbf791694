// SPDX-License-Identifier: MIT
// l3d_drawn_pixels: rounds boxes in the picture outwards.
#include "scene/drawn_pixels.h"

#include "scene/culling/scene_culling_p.h"

#include <algorithm>
#include <cmath>

namespace {

/// The pixels whose squares meet the box, even if their centres are not in the box.
l3d_pixel_box pixels_of(const l3d_image_box& box, const l3d_dice_view& view) {
    const l3d_image_box window = view.window(), seen = box.intersected(window);
    if (seen.empty())
        return {};
    return l3d_pixel_box{static_cast<std::int32_t>(std::floor(seen.left - window.left)),
                         static_cast<std::int32_t>(std::floor(seen.top - window.top)),
                         static_cast<std::int32_t>(std::floor(seen.right - window.left)) + 1,
                         static_cast<std::int32_t>(std::floor(seen.bottom - window.top)) + 1}
        .intersected(l3d_whole(view.size));
}

} // namespace

void l3d_drawn_pixels(const l3d_box_lanes& boxes, const l3d_matrix<double>& to_image,
                      const l3d_dice_view& view, l3d_pixel_boxes& result, std::int64_t enough) {
    l3d_detail::culled_boxes culled;
    const double near = view.unlifted().near;
    for (std::size_t first = 0; first < boxes.count() && result.area() <= enough;
         first += l3d_box_lanes::lanes) {
        l3d_detail::cull_boxes(boxes, first, {to_image, {}, view, view.margin()}, culled);
        const std::size_t here = std::min(l3d_box_lanes::lanes, boxes.count() - first);
        for (std::size_t i = 0; i < here; ++i) {
            if (culled.most[i] <= near || culled.least[i] >= view.far || culled.inside[i] < 0)
                continue;
            result.add(culled.least[i] > culled.near[i]
                           ? pixels_of(drawn_box_of(culled, i, view), view)
                           : l3d_whole(view.size));
        }
    }
}
