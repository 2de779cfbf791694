// SPDX-License-Identifier: MIT
// Patches smaller than the tolerance, which are drawn as points.
#ifndef L3D_DICE_POINT_PATCH_H
#define L3D_DICE_POINT_PATCH_H

#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/piece_pool.h"
#include "geom/normal_net.h"

#include <cstdint>
#include <optional>

/// The pixel centre at which a patch is drawn as a point: the only centre that the patch can cover,
/// since its hull is no wider than the tolerance.
struct l3d_point_place {
    std::int32_t x = 0, y = 0; ///< place of the centre, in 1/256 pixel from the picture's corner
    double bound = 0;          ///< largest distance of the patch from the drawn point, in pixels
};

/// The place of a patch that may be drawn as a point; nothing for others. The bounding box of its
/// net, with the point's own extent, must be within the tolerance and hold exactly one pixel's
/// centre. All points of the net must be at nearly the same depth.
///
/// Any pixel centre that the patch covers is in that box, so no gap opens. If the drawn point
/// covers another centre, its distance from the patch's points is at most the box's width.
std::optional<l3d_point_place> l3d_point_place_of(const l3d_image_net& net,
                                                  const l3d_dice_view& view);

/// Draws a patch as a point, with the depth of its middle. Shape: `normal` is that of the middle,
/// of any length, in the world.
void l3d_draw_point(const l3d_point_place& place, const l3d_image_patch& net,
                    const l3d_normal_net::vector& normal, const l3d_dice_view& view,
                    l3d_piece_pool& out, l3d_dice_counts& counts);

#endif
