// SPDX-License-Identifier: MIT
// Cells in which the peers' pictures are as far from the exact one as ours.
#ifndef L3D_TESTS_BENCH_PICTURE_PLAN_H
#define L3D_TESTS_BENCH_PICTURE_PLAN_H

#include "bench/bench_cell.h"
#include "bench/picture_judge.h"

#include <array>
#include <span>
#include <vector>

/// Over which pixels pictures are equally wrong.
struct picture_measure {
    const char* name;
    double picture_error::*over;
};
inline constexpr std::array<picture_measure, 2> picture_measures{
    {{"all", &picture_error::all}, {"inside", &picture_error::inside}}};

/// What the peers draw with one mesh.
struct peer_picture {
    double tolerance = 0;   ///< of places, that the mesh was made with. Units: pixels
    picture_error llvmpipe; ///< by which it was chosen
    picture_error embree;   ///< of the same mesh
    bool reached = false;   ///< else no mesh that was tried is as near to the exact picture as ours
};

/// A cell whose mesh was chosen by one of picture_measures.
struct picture_cell {
    bench_cell cell;
    const picture_measure* measure = nullptr;
    picture_error ours;
    peer_picture theirs; ///< of the cell's only mesh
};

/// For each view and tolerance of ours, and both measures: the adaptive mesh with which
/// llvmpipe's error is nearly ours, if there is one.
///
/// Meshes are told apart by the tolerance of places that they are made with: it is changed by
/// twos until the error passes ours, and interpolated in logarithms from there on.
/// Thinned meshes are no use here: what thinning in places alone leaves is shaded worse.
/// Cost: all processors, a minute for four tolerances.
std::vector<picture_cell> planned_pictures(const l3d_patch_model& model, l3d_size size,
                                           std::span<const double> tolerances);

#endif
