// SPDX-License-Identifier: MIT
// bench_frame: a memory screen, and an eye that trembles.
#include "hard_edged.h"
#include "bench/bench_frame.h"

#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <chrono>

namespace {

l3d_afd_settings settings(double tolerance, int threads, l3d_shade shade) {
    l3d_afd_settings result = hard_edged();
    result.tolerance = tolerance;
    result.threads = threads;
    result.shade = shade;
    return result;
}

} // namespace

bench_frame::bench_frame(const l3d_patch_scene& scene, const l3d_camera& camera, l3d_size size,
                         double tolerance, int threads, l3d_shade shade)
    : bench_frame(scene, camera, size, settings(tolerance, threads, shade)) {}

bench_frame::bench_frame(const l3d_patch_scene& scene, const bench_view& view, l3d_size size,
                         double tolerance, int threads, l3d_shade shade)
    : bench_frame(scene, view.camera, size, tolerance, threads, shade) {
    turn_ = view.turn;
    pipeline_.settings().one_sided = view.of_solid;
}

bench_frame::bench_frame(const l3d_patch_scene& scene, const l3d_camera& camera, l3d_size size,
                         const l3d_afd_settings& settings)
    : camera_(camera), pipeline_(l3d_memory_canvas(size), scene, camera, settings) {}

double bench_frame::draw() {
    // Tenths of a millionth of the distance: no picture shows it, no frame equals another.
    constexpr double tremor = 1e-7;
    pipeline_.camera() = camera_;
    pipeline_.camera().eye = camera_.eye + (camera_.eye - camera_.target) * (tremor * ++frame_);
    if (turn_ != 0)
        pipeline_.camera().orbit(turn_ * frame_, 0);
    const auto start = std::chrono::steady_clock::now();
    pipeline_.draw_event();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

std::uint64_t bench_frame::hash() {
    pipeline_.camera() = camera_;
    pipeline_.draw_event();
    return pipeline_.report().hash;
}
