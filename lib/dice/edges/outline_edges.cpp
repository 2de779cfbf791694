// SPDX-License-Identifier: MIT
// l3d_note_outline_edge: an edge's segments and the quads beside them.
#include "dice/edges/outline_edges.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

void l3d_note_outline_edge(l3d_diced_piece& piece, std::size_t side, const l3d_edge_polyline& edge,
                           const l3d_dice_view& view, double t0, double t1) {
    const l3d_micro_grid& grid = piece.part.grid;
    const bool along_u = side < 2, at_end = side == 1 || side == 3;
    // So the quad is on the right if its corners p00 p10 p11 p01 turn to the right.
    const bool forward = side == 0 || side == 3;
    const std::vector<double>& parameters = along_u ? piece.u : piece.v;
    const double per_t = (parameters.back() - parameters.front()) / (t1 - t0);
    const std::size_t first = edge.point_before(t0), last = edge.point_before(t1);
    const int quads = static_cast<int>(parameters.size()) - 1;
    const int across = at_end ? (along_u ? grid.rows : grid.columns) - 2 : 0;
    constexpr int sides[] = {0, 2, 3, 1}; // v = 0, v = 1, u = 0, u = 1
    const int side_of_quad = sides[side];
    int quad = 0;
    for (std::size_t i = first; i < last; ++i) {
        const double middle =
            parameters.front() + per_t * ((edge.t()[i] + edge.t()[i + 1]) / 2 - t0);
        while (quad + 1 < quads && parameters[static_cast<std::size_t>(quad) + 1] <= middle)
            ++quad;
        const int row = along_u ? across : quad, column = along_u ? quad : across;
        // The level of the grid's vertex on the side where the quad begins.
        const std::size_t vertex =
            grid.index(row + (along_u && at_end ? 1 : 0), column + (!along_u && at_end ? 1 : 0));
        l3d_micro_vertex from{edge.x()[i], edge.y()[i], edge.inv_w()[i], {}};
        l3d_micro_vertex to{edge.x()[i + 1], edge.y()[i + 1], edge.inv_w()[i + 1], {}};
        if (edge.strips().blocks == 0) {
            l3d_clip_vertex a = edge.clip_vertex(i, view), b = edge.clip_vertex(i + 1, view);
            if (!l3d_clip_segment(a, b, view))
                continue;
            from = a.dice.vertex;
            to = b.dice.vertex;
        }
        if (!forward)
            std::swap(from, to);
        piece.part.border.push_back(
            {from.x, from.y, to.x, to.y, from.inv_w, to.inv_w,
             piece.has_levels ? grid.normal[0][vertex] : std::numeric_limits<float>::quiet_NaN(),
             row, column, side_of_quad});
    }
}
