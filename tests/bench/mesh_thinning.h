// SPDX-License-Identifier: MIT
// Fewer triangles for the same error.
#ifndef L3D_TESTS_BENCH_MESH_THINNING_H
#define L3D_TESTS_BENCH_MESH_THINNING_H

#include "bench/patch_mesh.h"

/// Takes vertices out of a patch's mesh and turns edges, as long as every triangle's error stays
/// at or below `tolerance`. The boundary stays, and so neighbours still meet.
void thin_out(patch_mesh& mesh, const seen_patch& patch, double tolerance);

#endif
