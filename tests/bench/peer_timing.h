// SPDX-License-Identifier: MIT
// How long each side takes for a cell, in turn in one process.
#ifndef L3D_TESTS_BENCH_PEER_TIMING_H
#define L3D_TESTS_BENCH_PEER_TIMING_H

#include "bench/bench_cell.h"
#include "bench/child_process.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

/// A peer's fastest way to draw a cell.
struct peer_choice {
    std::size_t mesh = 0; ///< in bench_cell::meshes
    int mesa_threads = 0; ///< llvmpipe's workers
    int mesa_bits = 0;    ///< in a vector of llvmpipe's
    int embree_rays = 0;  ///< in a packet of Embree's
    bool one_processor = false;
    double ms = 0;
};

/// llvmpipe's ways to use so many processors: numbers of workers, and widths of vectors.
std::vector<peer_choice> mesa_ways(int threads);

/// The child in which llvmpipe draws in a way: it reads its settings once in a process.
child_setting setting_of(const peer_choice& choice);

/// Of many frames. Units: milliseconds.
struct frame_times {
    double median = 0; ///< of frames that follow one of the same side, as an animation's do
    double least = 0;  ///< of those; where others use the machine too, this one is the truer
    double first = 0;  ///< median of those that follow another side's
};

/// The measurements of a cell.
struct cell_times {
    peer_choice mesa_way, embree_way;
    frame_times lambert, gouraud; ///< ours: a unit normal in every pixel, a grey at every vertex
    frame_times mesa, embree;     ///< a grey at every vertex
    long mesa_differs = 0, embree_differs = 0; ///< pixels that do not look alike
    long covered = 0;                          ///< pixels that ours covers
    long culled = 0; ///< pixels that llvmpipe would lose if it culled the side that loses least
};

/// Compares on `threads` threads a side, cell by cell.
///
/// First each peer tries its meshes; llvmpipe also tries numbers of workers and widths of vectors,
/// Embree packets. With its best it is then timed in turn with both shadings of ours, a few frames
/// each. llvmpipe reads its settings once in a process, so all this happens in children.
/// Errors: std::runtime_error if a peer is not there, or a picture is wrong.
std::vector<cell_times> compare(const l3d_patch_model& model, std::span<const bench_cell> cells,
                                int threads);

/// Median time to clear the colour and the depth of a picture, on one thread. Milliseconds.
double clearing_ms(l3d_size size);

/// The names of the peers.
std::string peer_names();

#endif
