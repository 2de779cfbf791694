// SPDX-License-Identifier: MIT
// Frames of our own for benchmarks: the views, and a pipeline that draws into memory.
#ifndef L3D_TESTS_BENCH_BENCH_FRAME_H
#define L3D_TESTS_BENCH_BENCH_FRAME_H

#include "pipeline/pipeline_afd.h"

#include <array>
#include <cstdint>

struct bench_view {
    const char* name;
    l3d_camera camera;
    double turn = 0;       ///< around the target from frame to frame. Units: degrees
    bool of_solid = false; ///< of closed bodies, whose backs nobody sees
};

inline const std::array<bench_view, 3> bench_views{{
    {"full", {{3.2, 3.6, 7.4}, {0.2, 1.3, 0.0}, {0.0, 1.0, 0.0}, 38, 0.1, 1e13}},
    {"closeup", {{1.2, 2.6, 4.4}, {-0.3, 1.5, 0.0}, {0.0, 1.0, 0.0}, 45, 0.1, 1e13}},
    {"top", {{1.5, 7.5, 3.0}, {0.2, 1.2, 0.0}, {0.0, 1.0, 0.0}, 35, 0.1, 1e13}},
}};

/// One scene, drawn again and again into memory; from model and camera to finished pixels.
class bench_frame {
public:
    bench_frame(const l3d_patch_scene& scene, const l3d_camera& camera, l3d_size size,
                double tolerance, int threads, l3d_shade shade = l3d_shade::lambert);
    bench_frame(const l3d_patch_scene& scene, const bench_view& view, l3d_size size,
                double tolerance, int threads, l3d_shade shade);
    bench_frame(const l3d_patch_scene& scene, const l3d_camera& camera, l3d_size size,
                const l3d_afd_settings& settings);

    /// Draws a frame from an eye that is never twice at the same place: nothing can be reused.
    /// A view's turn is one frame farther.
    /// Returns its milliseconds, by the wall's clock.
    double draw();

    /// Draws the view itself, and returns the picture's hash.
    std::uint64_t hash();

    l3d_pixels pixels() { return pipeline_.screen().pixels(); }
    l3d_frame_report report() const { return pipeline_.report(); }

private:
    l3d_camera camera_;
    l3d_pipeline_afd pipeline_;
    double turn_ = 0;
    int frame_ = 0;
};

#endif
