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

/// Whether an edge's points are computed from its last control point on. The computation begins at
/// the lexicographically smaller end, so that both directions of an edge give the same bits.
inline bool runs_backwards(const l3d_image_curve& edge) {
    const auto& p = edge.points;
    for (std::size_t i = 0; i < 2; ++i)
        for (int k = 0; k < 3; ++k)
            if (p[i][k] != p[3 - i][k])
                return p[3 - i][k] < p[i][k];
    return false;
}

/// The result of make_edge_strips for an edge: the arrays to which its points are written, and
/// facts about the points.
struct edge_strips {
    /// Room for all points of an edge and one vector of up to eight doubles more, since whole
    /// vectors are stored.
    static constexpr std::size_t room =
        std::size_t{l3d_block_starts::most_blocks} * l3d_most_steps_whole + 1 + 8;

    double* t; ///< the points' parameters; each array has `room` numbers
    std::int32_t *x, *y;
    float* inv_w;

    /// One strip or four; none if the edge needs clipping or too many steps.
    l3d_block_starts strips;
    double chord_error, vertex_error;
    /// Whether every control point can be drawn, but a strip needs more than 32 steps.
    bool too_long;
};

/// Makes the points of ordinary edges. The control points of an ordinary edge can all be drawn, and
/// it needs at most 32 steps a strip. An edge that is not ordinary gets no strips. Points depend on
/// their edge alone. A reversed edge has the same points in reverse order.
/// Shape:  the points of edges[k] have the share shares[k] of the view's errors.
/// Cost:   150 ns an edge of 24 points with AVX-512.
/// Errors: points are evaluated in power form, see l3d_power_form_error.
void make_edge_strips(const std::array<l3d_image_curve, edges_at_once>& edges,
                      const l3d_dice_view& view, const std::array<double, edges_at_once>& shares,
                      std::array<edge_strips, edges_at_once>& results);

} // namespace l3d_detail

#endif
