// SPDX-License-Identifier: MIT
// l3d_tessellation_dicer: n x n quads a patch, whatever its size.
#ifndef L3D_DICE_TESSELLATION_DICER_H
#define L3D_DICE_TESSELLATION_DICER_H

#include "dice/dice_counts.h"
#include "dice/diced_pieces.h"
#include "dice/uniform_grid.h"

/// What programs do who know nothing of the view: the same steps everywhere.
///
/// Points are evaluated by Horner's scheme. Patches that share an edge have the same points on it,
/// up to rounding in double, which snapping to 1/256 pixel hides.
class l3d_tessellation_dicer {
public:
    /// Expects: n >= 1.
    explicit l3d_tessellation_dicer(int n) : n_(n) {}

    /// Expects: l3d_needs_no_clipping(net, view).
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_diced_pieces& out, l3d_dice_counts& counts);

private:
    int n_;
    l3d_uniform_grid grid_;
};

#endif
