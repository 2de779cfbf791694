// SPDX-License-Identifier: MIT
// l3d against Open CASCADE's mesher and llvmpipe, on STEP files.
#ifndef L3D_TESTS_BENCH_CAD_PEERS_H
#define L3D_TESTS_BENCH_CAD_PEERS_H

#include <span>
#include <string>

/// Prints a table for one thread and, unless it is to be quick, two. Without files, it compares the
/// examples.
/// Errors: std::runtime_error without Open CASCADE, for a file that is no STEP file, and as
///         compare() of peer_timing.h.
void compare_cad(std::span<const std::string> files, bool quick);

#endif
