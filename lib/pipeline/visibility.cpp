// SPDX-License-Identifier: MIT
// l3d_left_out: the reasons.
#include "pipeline/visibility.h"

#include <cmath>

namespace {

/// Whether a box (pixels from the picture's corner) holds no pixel centre k + 1/2, even when
/// snapping moves its points by half a sub-pixel.
bool holds_no_centre(const l3d_image_box& box) {
    constexpr double slack = 1.0 / l3d_subpixel_one;
    const auto none = [](double low, double high) {
        return std::floor(high + slack - 0.5) < std::ceil(low - slack - 0.5);
    };
    return none(box.left, box.right) || none(box.top, box.bottom);
}

/// The count of patches that are left out for the same reason as this one; null if it may be seen.
std::int64_t* reason(const l3d_image_patch& net, const l3d_dice_view& view,
                     l3d_dice_counts& counts) {
    const l3d_depth_range depth = l3d_depth_range_of(net.points);
    if (depth.most <= view.near)
        return &counts.behind;
    if (depth.least >= view.far)
        return &counts.beyond;
    if (l3d_outside(net.points, view.margin(), view.near, view.far))
        return &counts.offscreen;
    if (depth.least <= view.near)
        return nullptr;
    const l3d_image_box window = view.window();
    const l3d_image_box box = l3d_image_box_of(net.points);
    return holds_no_centre({box.left - window.left, box.top - window.top, box.right - window.left,
                            box.bottom - window.top})
               ? &counts.subpixel
               : nullptr;
}

} // namespace

bool l3d_left_out(const l3d_image_patch& net, const l3d_dice_view& view, l3d_dice_counts& counts) {
    std::int64_t* count = reason(net, view, counts);
    if (count)
        ++*count;
    return count != nullptr;
}
