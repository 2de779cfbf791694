// SPDX-License-Identifier: MIT
// A cell of the comparison: a view, a size and an error; what each side draws there.
#ifndef L3D_TESTS_BENCH_BENCH_CELL_H
#define L3D_TESTS_BENCH_BENCH_CELL_H

#include "bench/bench_frame.h"
#include "bench/peer_mesh.h"

#include <span>
#include <vector>

/// Either nobody's measured error of places is more than `error`, nor less than need be, or all
/// pictures are as far from the exact one.
struct bench_cell {
    const bench_view* view = nullptr;
    l3d_size size;
    double error = 0; ///< of places, pixels; 0 where pictures are alike

    double our_tolerance = 0; ///< the largest found with which ours is within `error`
    double our_bound = 0;     ///< what ours certifies then
    double our_error = 0;     ///< what it measures

    std::vector<peer_mesh> meshes; ///< candidates of the peers
};

/// All views at each size and error. Cost: all processors, some seconds a cell.
std::vector<bench_cell> planned_cells(const l3d_patch_model& model,
                                      std::span<const bench_view> views,
                                      std::span<const l3d_size> sizes,
                                      std::span<const double> errors);

#endif
