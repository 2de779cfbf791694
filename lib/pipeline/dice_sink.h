// SPDX-License-Identifier: MIT
// l3d_dice_sink: where diced surfaces go.
#ifndef L3D_PIPELINE_DICE_SINK_H
#define L3D_PIPELINE_DICE_SINK_H

#include "geom/step_bound.h"
#include "raster/micro_grid.h"

#include <span>

/// A vertex with the patch parameters whose exact point it stands for.
struct l3d_dice_vertex {
    l3d_micro_vertex vertex;
    double u = 0, v = 0;
};

/// A grid of vertices: vertex (r, c) stands for the exact surface point at (u[c], v[r]).
struct l3d_dice_grid {
    const l3d_micro_grid& vertices;
    std::span<const double> u, v;
    double bound; ///< certified image error of everything drawn from it, in pixels
};

/// Takes what the dicer makes: grids, and triangles along their edges. Virtual per batch.
class l3d_dice_sink {
public:
    l3d_dice_sink() = default;
    l3d_dice_sink(const l3d_dice_sink&) = delete;
    l3d_dice_sink& operator=(const l3d_dice_sink&) = delete;
    virtual ~l3d_dice_sink() = default;

    void grid(const l3d_dice_grid& grid) { do_grid(grid); }

    /// Three vertices each. The bound is that of the frame so far.
    void triangles(std::span<const l3d_dice_vertex> corners, double bound) {
        do_triangles(corners, bound);
    }

private:
    virtual void do_grid(const l3d_dice_grid& grid) = 0;
    virtual void do_triangles(std::span<const l3d_dice_vertex> corners, double bound) = 0;
};

#endif
