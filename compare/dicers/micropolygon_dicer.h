// SPDX-License-Identifier: MIT
// l3d_micropolygon_dicer: quads smaller than pixels.
#ifndef L3D_COMPARE_DICERS_MICROPOLYGON_DICER_H
#define L3D_COMPARE_DICERS_MICROPOLYGON_DICER_H

#include "geom/real.h"
#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/piece_pool.h"
#include "dice/edges/edge_polylines.h"
#include "dice/grid_builder.h"
#include "dice/surface_piece.h"

#include <array>

/// The largest number of quads along a grid. With two quads along a pixel, such a grid is 16 pixels
/// long, as large as the paper's grids. Walks of up to 32 steps are certified.
inline constexpr int l3d_most_micropolygons = 32;

/// The estimated lengths of the longest curves along u and along v: those of the longest rows of
/// control points. Units: pixels.
std::array<double, 2> l3d_micropolygon_lengths(const l3d_image_patch& net);

/// The number of quads along a curve of this length in pixels.
int l3d_micropolygons_along(double length, int quads_a_pixel);

/// Bounds, splits and dices, as in REYES. A patch is cut until each piece needs only a small grid
/// of micropolygons. Then each piece is diced into that grid by forward differences. No tolerance
/// is kept. The error comes out small, and is certified like every grid's.
///
/// Pieces and neighbours meet along edge polylines finer than the tolerance, so the paper's cracks
/// do not occur.
/// Cost:   25 ns a quad, some ten quads a pixel with two along each.
/// Source: Cook, Carpenter, Catmull, The Reyes Image Rendering Architecture, SIGGRAPH 1987.
class l3d_micropolygon_dicer {
public:
    /// Sets the number of quads along a pixel. The paper has two, so that quads are half as large
    /// as the distance of samples.
    /// Expects: >= 1.
    explicit l3d_micropolygon_dicer(int quads_a_pixel = 2) : quads_a_pixel_(quads_a_pixel) {}

    /// Dices a patch and adds its polygons to `out`. Expects: l3d_needs_no_clipping(net, view).
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_piece_pool& out, l3d_dice_counts& counts);

private:
    struct task {
        const l3d_dice_view& view;
        l3d_piece_pool& out;
        l3d_dice_counts& counts;
        int cuts_left;
    };

    void dice_piece(const l3d_surface_piece& p, task& of);
    void cut(const l3d_surface_piece& p, bool along_u, task& of);

    int quads_a_pixel_;
    l3d_edge_polylines edges_;
    l3d_grid_builder<l3d_real> drawer_;
};

#endif
