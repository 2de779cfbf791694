// SPDX-License-Identifier: MIT
// Makes edges that need no clipping, four at a time in the lanes of the processor.
#ifndef L3D_DICE_EDGES_EDGE_STRIPS_P_H
#define L3D_DICE_EDGES_EDGE_STRIPS_P_H

#include "scene/dice_view.h"
#include "raster/surface_part.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// The number of edges that are made together.
inline constexpr std::size_t edges_at_once = 4;

/// Whether an edge's points are made from its last control point on. They begin at the
/// lexicographically smaller end, so that both directions give the same bits.
inline bool runs_backwards(const l3d_image_curve& edge) {
    const auto& p = edge.points;
    for (std::size_t i = 0; i < 2; ++i)
        for (int k = 0; k < 3; ++k)
            if (p[i][k] != p[3 - i][k])
                return p[3 - i][k] < p[i][k];
    return false;
}

/// The arrays to which an edge's points are written, and facts about the points.
struct edge_strips {
    /// Room for all points of an edge and one vector of up to eight doubles more, since whole
    /// vectors are stored.
    static constexpr std::size_t room =
        std::size_t{l3d_block_starts::most_blocks} * l3d_most_steps_whole + 1 + 8;

    double* t; ///< each array has `room` numbers
    std::int32_t *x, *y;
    float* inv_w;

    l3d_block_starts strips; ///< one strip or four; none if the edge needs clipping or more steps
    double chord_error, vertex_error;
    bool too_long; ///< every control point can be drawn, but a strip needs more than 32 steps
};

/// Makes the points of ordinary edges: their control points can all be drawn, and they need at most
/// 32 steps a strip. Other edges get no strips. The points depend on each edge alone, and are the
/// same, in reverse order, for the reversed edge.
/// Shape:  the points of edges[k] have the share shares[k] of the view's errors.
/// Cost:   150 ns an edge of 24 points with AVX-512.
/// Errors: points are evaluated in power form, see l3d_power_form_error.
void make_edge_strips(const std::array<l3d_image_curve, edges_at_once>& edges,
                      const l3d_dice_view& view, const std::array<double, edges_at_once>& shares,
                      std::array<edge_strips, edges_at_once>& results);

} // namespace l3d_detail

#endif
