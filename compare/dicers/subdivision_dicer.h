// SPDX-License-Identifier: MIT
// l3d_subdivision_dicer: halves patches until they are flat.
#ifndef L3D_COMPARE_DICERS_SUBDIVISION_DICER_H
#define L3D_COMPARE_DICERS_SUBDIVISION_DICER_H

#include "geom/normal_net.h"
#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/piece_pool.h"
#include "geom/patch_part.h"

#include <array>

/// Adaptive subdivision by de Casteljau's scheme. A piece becomes two triangles once the bound says
/// that they are within the tolerance and all of its edges are straight. Otherwise it is cut in
/// two, across the direction with the larger error.
///
/// The control points of an edge alone decide whether it is straight, so neighbours agree. A piece
/// may be cut across a straight edge for the sake of its inside. Then the triangle of the edge's
/// ends and its middle is added, so that a neighbour that draws the edge as one line meets no gap.
/// Cost:   some 100 ns a triangle; no allocation once the largest patch has been seen.
/// Source:  Catmull, A Subdivision Algorithm for Computer Display of Curved Surfaces, 1974;
///          flatness as in Lane, Carpenter, Whitted, Blinn, CACM 23, 1980.
class l3d_subdivision_dicer {
public:
    /// Dices a patch and adds its polygons to `out`. Expects: l3d_needs_no_clipping(net, view).
    void dice(const l3d_image_patch& net, const l3d_normal_net& normals, const l3d_dice_view& view,
              l3d_piece_pool& out, l3d_dice_counts& counts);

private:
    /// A piece of a patch that is to be drawn or cut.
    /// Shape:   corner 2 * (high v) + (high u); edges v low, v high, u low, u high.
    struct piece : l3d_patch_part {
        std::array<l3d_dice_vertex, 4> corners;
        std::array<bool, 4> straight{};
    };

    /// The data that stay the same for a patch.
    struct task {
        const l3d_normal_net& normals;
        const l3d_dice_view& view;
        double budget;
        l3d_diced_piece& out;
        l3d_dice_counts& counts;
        double chord_error = 0;
    };

    static l3d_dice_vertex vertex_at(const l3d_image_point& h, double u, double v, task& of);
    static bool is_straight(const l3d_image_curve& edge, task& of);
    static void divide(piece& p, task& of);
    static void cut(const piece& p, bool along_u, task& of);
};

#endif
