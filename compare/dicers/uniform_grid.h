// SPDX-License-Identifier: MIT
// l3d_uniform_grid: grids of equal steps over a whole patch, and their error bounds.
#ifndef L3D_COMPARE_DICERS_UNIFORM_GRID_H
#define L3D_COMPARE_DICERS_UNIFORM_GRID_H

#include "geom/normal_net.h"
#include "scene/dice_view.h"
#include "dice/diced_piece.h"
#include "dice/drawn_error.h"
#include "dice/normal_columns.h"

/// Sets a piece to a grid of nu x nv quads: parameters, one block, and normals. The caller sets the
/// positions.
/// Lives:   kept from patch to patch for its memory.
class l3d_uniform_grid {
public:
    void begin(const l3d_normal_net& normals, int nu, int nv, l3d_diced_piece& out);

private:
    l3d_normal_columns columns_;
};

/// The accuracy of a patch's vertices if they are evaluated in double and snapped.
/// Expects: l3d_needs_no_clipping(net, view).
l3d_vertex_accuracy l3d_evaluated_accuracy(const l3d_image_patch& net, const l3d_dice_view& view);

/// A bound of the error in the picture, if nu x nv quads cover the whole patch and their vertices
/// have this accuracy. Units: pixels.
///
/// Steps may be of any length. If they are so long that the w of a quad is off by more than an
/// eighth, errors of corners count more.
double l3d_uniform_bound(const l3d_image_patch& net, const l3d_dice_view& view, int nu, int nv,
                         const l3d_vertex_accuracy& accuracy);

#endif
