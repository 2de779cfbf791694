// SPDX-License-Identifier: MIT
// l3d_diced_piece: a piece of a patch as the rasterizer takes it, and what is known of it.
#ifndef L3D_PIPELINE_DICED_PIECE_H
#define L3D_PIPELINE_DICED_PIECE_H

#include "raster/surface_part.h"

#include <array>
#include <vector>

/// A grid and the triangles around it. Vertex (r, c) of the grid stands for the exact surface
/// point at (u[c], v[r]), corner k of triangle i for the one at triangle_uv[k][i].
///
/// Lives: kept from frame to frame for its memory.
struct l3d_diced_piece {
    struct parameters {
        double u, v;
    };

    l3d_surface_part part;
    std::vector<double> u, v;
    double bound = 0; ///< certified image error of the grid, in pixels; triangles have the frame's

    /// Only written if asked for, by whoever measures.
    bool keep_parameters = false;
    std::array<std::vector<parameters>, 3> triangle_uv;
};

#endif
