// SPDX-License-Identifier: MIT
// Error against time of anti-aliased pictures: ours beside a rival's.
#ifndef L3D_TESTS_BENCH_SMOOTH_CURVES_H
#define L3D_TESTS_BENCH_SMOOTH_CURVES_H

#include "bench/peer_timing.h"
#include "bench/smooth_judge.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

enum class smooth_rival {
    mesa_samples, ///< llvmpipe, GL_SAMPLES 4
    mesa_pixels,  ///< llvmpipe, 4 x 4 times as many pixels
    embree,       ///< 16 rays a pixel
};
inline constexpr std::array smooth_rivals{smooth_rival::mesa_samples, smooth_rival::mesa_pixels,
                                          smooth_rival::embree};
const char* name_of(smooth_rival rival);

/// Over which pixels the error is taken.
struct smooth_measure {
    const char* name;
    double smooth_error::*over;
};
inline constexpr std::array<smooth_measure, 2> smooth_measures{
    {{"all", &smooth_error::all}, {"edges", &smooth_error::edges}}};

/// A picture's error and time.
struct smooth_point {
    double tolerance = 0;      ///< of ours, or of places in the mesh; pixels
    std::size_t triangles = 0; ///< of the mesh
    smooth_error error;
    double ms = 0, least_ms = 0; ///< of a frame: median and least
};

/// Least time for an error of at most `error`, on the straight lines between the points in
/// logarithms. None if all points err more.
std::optional<double> time_at(std::span<const smooth_point> curve, double smooth_error::*over,
                              double error);

/// The most exact picture of a curve.
const smooth_point& most_exact(std::span<const smooth_point> curve, double smooth_error::*over);

/// A view, its exact picture, and meshes of it for the peers, from coarse to fine.
struct smooth_scenery {
    const bench_view* view;
    l3d_size size;
    smooth_judge judge;
    std::vector<double> mesh_tolerances; ///< pixels
    std::vector<peer_mesh> meshes;
};

/// Ours and a rival's, measured in turn.
struct smooth_duel {
    const smooth_scenery* of;
    smooth_rival rival;
    peer_choice way; ///< of the rival
    std::vector<smooth_point> ours, theirs;
};

/// Of every scenery against every rival, with so many threads a side.
///
/// First each rival's ways are tried with a middle mesh: llvmpipe's workers and widths of vectors,
/// Embree's packets. Each duel then has a child of its own, where all tolerances and all meshes
/// take turns. llvmpipe reads its settings once in a process.
/// Expects: threads >= 1; tolerances of ours, in pixels.
/// Errors:  std::runtime_error if a peer is not there.
std::vector<smooth_duel> measured_duels(const l3d_patch_model& model,
                                        std::span<const smooth_scenery> sceneries,
                                        std::span<const double> tolerances, int threads);

#endif
