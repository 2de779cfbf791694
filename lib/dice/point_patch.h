// SPDX-License-Identifier: MIT
// Draws patches smaller than the tolerance as points.
#ifndef L3D_DICE_POINT_PATCH_H
#define L3D_DICE_POINT_PATCH_H

#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/piece_pool.h"
#include "geom/normal_net.h"

#include <cstdint>
#include <optional>

/// The pixel centre at which a patch is drawn as a point. It is the only centre that the patch can
/// cover, since the patch's hull is no wider than the tolerance.
struct l3d_point_place {
    std::int32_t x = 0, y = 0; ///< place of the centre, in 1/256 pixel from the picture's corner
    double bound = 0;          ///< largest distance of the patch from the drawn point, in pixels
};

/// Finds the pixel centre for a patch that may be drawn as a point. Returns nothing for other
/// patches.
///
/// The bounding box of the patch's net, with the point's own extent, must be within the tolerance
/// and hold exactly one pixel's centre. All points of the net must be at nearly the same depth
/// (l3d_dice_view::depth_of_point). Any pixel centre that the patch covers is in the box, so no gap
/// opens. If the patch does not cover the drawn centre, the centre is still within the tolerance of
/// the patch's points.
std::optional<l3d_point_place> l3d_point_place_of(const l3d_image_net& net,
                                                  const l3d_dice_view& view);

/// Draws a patch as a point, with the depth and the light of the patch's middle.
/// Shape: `normal` is the normal in the patch's middle, in the world, of any length.
void l3d_draw_point(const l3d_point_place& place, const l3d_image_patch& net,
                    const l3d_normal_net::vector& normal, const l3d_dice_view& view,
                    l3d_piece_pool& out, l3d_dice_counts& counts);

#endif
