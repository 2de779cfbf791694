// SPDX-License-Identifier: MIT
// l3d_left_out: the reasons.
#include "scene/visibility.h"

#include <cmath>

namespace {

/// Corners that are so far apart both ways spare most patches the box of their net.
bool is_wider_than_a_pixel(const l3d_image_patch& net) {
    const auto is_wider = [&](int along) {
        return l3d_far_apart(net.at(0, 0), net.at(3, 3), along, 1) ||
               l3d_far_apart(net.at(0, 3), net.at(3, 0), along, 1);
    };
    return is_wider(0) && is_wider(1);
}

/// The count of patches that are left out for the same reason as this one; null if it may be seen.
std::int64_t* reason(const l3d_image_patch& net, const l3d_dice_view& view,
                     l3d_dice_counts& counts) {
    const l3d_depth_range depth = l3d_depth_range_of(net.points);
    if (!view.keep.outside) {
        if (depth.most <= view.near)
            return &counts.behind;
        if (depth.least >= view.far)
            return &counts.beyond;
        if (l3d_outside(net.points, view.margin(), view.near, view.far))
            return &counts.offscreen;
    }
    if (depth.least <= view.near || view.keep.centreless || is_wider_than_a_pixel(net))
        return nullptr;
    return l3d_holds_no_centre(l3d_image_box_of(net.points), view) ? &counts.subpixel : nullptr;
}

} // namespace

bool l3d_holds_no_centre(const l3d_image_box& hull, const l3d_dice_view& view) {
    const l3d_image_box box = view.drawn_box(hull);
    if (box.width() > 1 && box.height() > 1)
        return false;
    constexpr double slack = 1.0 / l3d_subpixel_one;
    // Centres lie at k + 1/2 from the picture's corner.
    const auto none = [](double low, double high, double corner) {
        return std::floor(high - corner + slack - 0.5) < std::ceil(low - corner - slack - 0.5);
    };
    const l3d_image_box window = view.window();
    return none(box.left, box.right, window.left) || none(box.top, box.bottom, window.top);
}

bool l3d_left_out(const l3d_image_patch& net, const l3d_dice_view& view, l3d_dice_counts& counts) {
    std::int64_t* count = reason(net, view, counts);
    if (count)
        ++*count;
    return count != nullptr;
}
