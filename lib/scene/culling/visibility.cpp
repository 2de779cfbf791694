// SPDX-License-Identifier: MIT
// l3d_left_out: finds the reason, if there is one, and counts it.
#include "scene/culling/visibility.h"

#include "raster/pixel_centres.h"

namespace {

/// Whether opposite corners of a net are more than a pixel apart in x and in y. Most patches are so
/// large, and need no box of their net.
bool is_wider_than_a_pixel(const l3d_image_patch& net) {
    const auto is_wider = [&](int along) {
        return l3d_far_apart(net.at(0, 0), net.at(3, 3), along, 1) ||
               l3d_far_apart(net.at(0, 3), net.at(3, 0), along, 1);
    };
    return is_wider(0) && is_wider(1);
}

} // namespace

bool l3d_holds_no_centre(const l3d_image_box& hull, const l3d_dice_view& view) {
    const l3d_image_box box = view.drawn_box(hull);
    if (box.width() > 1 && box.height() > 1)
        return false;
    const l3d_image_box window = view.window();
    return l3d_centres_near(box.left, box.right, window.left).none() ||
           l3d_centres_near(box.top, box.bottom, window.top).none();
}

bool l3d_left_out(const l3d_image_net& net, const l3d_dice_view& view, l3d_dice_counts& counts) {
    std::int64_t* const count = l3d_reason_to_leave_out(
        net.w(), view,
        [&] {
            return view.section.cuts_off(net.points) ||
                   l3d_outside(net.points, view.margin(), view.near, view.far);
        },
        [&] {
            return net.w().least > view.near && !is_wider_than_a_pixel(net) &&
                   l3d_holds_no_centre(net.box(), view);
        },
        counts);
    if (count)
        ++*count;
    return count != nullptr;
}
