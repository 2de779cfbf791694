// SPDX-License-Identifier: MIT
// l3d_lane_carpenter_dicer: subdivision into polygons, for scan conversion.
#ifndef L3D_COMPARE_DICERS_LANE_CARPENTER_DICER_H
#define L3D_COMPARE_DICERS_LANE_CARPENTER_DICER_H

#include "dice/piece_pool.h"
#include "geom/patch_part.h"
#include "geom/normal_net.h"
#include "scene/counts.h"
#include "scene/dice_view.h"

/// Cuts a patch until it is as good as a polygon: its control points are within the tolerance of a
/// plane, and its sides within the tolerance of their chords. Then its four corners are a polygon,
/// which is filled as always. Nothing is iterated, so nothing fails to converge.
///
/// As in the paper, cracks stay, since the tolerance keeps them small. Pixels may be left out where
/// a side is straight for one piece and cut by its neighbour. So there is no bound. The method
/// `subdivision` is this one with its cracks mended, and with a certified bound.
/// Source: Lane, Carpenter, A Generalized Scan Line Algorithm for the Computer Display of
/// Parametrically Defined Surfaces, CGIP 11, 1979; with Whitted, Blinn, CACM 23, 1980.
class l3d_lane_carpenter_dicer {
public:
    /// Dices a patch and adds its polygons to `out`. Expects: l3d_needs_no_clipping(net, view).
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_piece_pool& out, l3d_dice_counts& counts);

private:
    struct task {
        const l3d_normal_net& normals;
        const l3d_dice_view& view;
        l3d_diced_piece& out;
        l3d_dice_counts& counts;
    };
    static void divide(const l3d_patch_part& p, task& of);
};

/// Whether a net is as good as a polygon. Its points must be within `tolerance` of a plane, and
/// those of each side within `tolerance` of the side's chord. Depth is measured in pixels, too.
bool l3d_is_polygon(const l3d_image_patch& net, const l3d_dice_view& view, double tolerance);

#endif
