// SPDX-License-Identifier: MIT
// The cost of a frame in which little or nothing changed: a thousand teapots stand still, one
// moves.
//
// The baseline is the same frame drawn whole; the pictures must be the same bits.
#include "hard_edged.h"
#include "bench/bench_frame.h"
#include "geom/teapot.h"
#include "pipeline/pipeline_afd.h"
#include "processor_time.h"
#include "raster/rasterizer_factory.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr l3d_size size{1024, 768};
constexpr int frames = 41;

[[noreturn]] void fail(const char* what) {
    std::fprintf(stderr, "still_bench: %s\n", what);
    std::exit(EXIT_FAILURE);
}

class program final : public l3d_pipeline_afd {
public:
    program(l3d_patch_scene scene, const l3d_camera& camera, const l3d_afd_settings& settings)
        : l3d_pipeline_afd(l3d_memory_canvas(size), std::move(scene), camera, settings) {}

    /// The far plane is elsewhere, behind all that there is: the same picture has to be drawn
    /// whole.
    void forget_picture() { camera().far_z = std::nextafter(camera().far_z, 0.0); }
};

/// Median of the processor's milliseconds that draw_event takes after `change(frame)`.
template <class Change> double milliseconds(program& of, const Change& change) {
    std::vector<double> times;
    for (int frame = 0; frame < frames; ++frame) {
        change(frame);
        const double before = processor_seconds();
        of.draw_event();
        times.push_back(1000 * (processor_seconds() - before));
    }
    std::nth_element(times.begin(), times.begin() + frames / 2, times.end());
    return times[frames / 2];
}

/// The processor's milliseconds of a frame that asks to be drawn though nothing changed.
double milliseconds_at_rest(program& of) {
    constexpr int many = 1000;
    const double before = processor_seconds();
    for (int frame = 0; frame < many; ++frame) {
        of.redraw();
        of.draw_event();
    }
    return 1000 * (processor_seconds() - before) / many;
}

/// Teapots all over the picture, some behind others.
l3d_patch_scene crowd(const l3d_patch_model& model, const l3d_camera& camera, int count) {
    std::mt19937_64 random(20061);
    std::uniform_real_distribution<double> unit(-1, 1);
    const l3d_camera::frame axes = camera.axes();
    l3d_patch_scene scene;
    for (int i = 0; i < count; ++i) {
        const double w = 90 + 50 * unit(random);
        const auto p = camera.eye + axes.forward * w + axes.right * (0.43 * w * unit(random)) +
                       axes.up * (0.33 * w * unit(random));
        scene.add(model, l3d_translation<double>(p[0], p[1], p[2]) *
                             l3d_rotation<double>({unit(random), unit(random), 1.0}, 172));
    }
    return scene;
}

/// The teapot before all others, so large, at a place that differs from frame to frame.
l3d_matrix<double> in_front(const l3d_camera& camera, double scale, int frame) {
    const l3d_camera::frame axes = camera.axes();
    const auto p = camera.eye + axes.forward * 20.0 +
                   (axes.right * double(frame % 8) + axes.up * double(frame % 5)) * (0.02 * scale) +
                   axes.up * -scale;
    l3d_matrix<double> m = l3d_translation<double>(p[0], p[1], p[2]);
    for (int i = 0; i < 3; ++i)
        m(i, i) = scale;
    return m;
}

/// The time of a frame in which `move(program, frame)` moves things, and a check that its picture
/// is right.
template <class Move>
double milliseconds_of_moves(program& all, const l3d_camera& camera,
                             const l3d_afd_settings& settings, const Move& move) {
    move(all, frames);
    all.forget_picture();
    all.draw_event();
    const double result = milliseconds(all, [&](int frame) { move(all, frame); });
    program fresh(all.scene(), camera, settings);
    fresh.draw_event();
    if (fresh.report().hash != all.report().hash)
        fail("a part of a picture is another picture");
    return result;
}

void print_moving(const l3d_patch_model& model, const l3d_camera& camera, int threads) {
    constexpr int still = 1000;
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = 0.5;
    settings.threads = threads;
    l3d_patch_scene scene = crowd(model, camera, still);
    scene.add(model, in_front(camera, 1, 0));
    program all(scene, camera, settings);
    const double whole = milliseconds(all, [&](int) { all.forget_picture(); });
    const double rest = milliseconds_at_rest(all);
    if (all.report().pixels_kept != l3d_whole(size).area())
        fail("a still frame is drawn");
    std::printf("%d teapots at %dx%d, tolerance 0.5 px, %d thread(s)\n"
                "drawn whole %.3f ms; nothing moved %.4f ms\n"
                "%8s %9s %9s %9s %9s\n",
                still + 1, size.width, size.height, threads, whole, rest, "part", "of all, %",
                "quads", "ms", "of all, %");
    for (const double scale : {0.05, 0.1, 0.2, 0.4, 0.8, 1.2, 1.35, 1.6}) {
        const auto move = [&](program& p, int frame) {
            p.scene().place(still, in_front(camera, scale, frame));
        };
        const double part = milliseconds_of_moves(all, camera, settings, move);
        const l3d_pixel_box box = all.changed();
        std::printf(
            "%3dx%-4d %9.2f %9lld %9.3f %9.2f\n", box.right - box.left, box.bottom - box.top,
            100.0 * static_cast<double>(box.area()) / static_cast<double>(l3d_whole(size).area()),
            static_cast<long long>(all.report().surface.quads), part, 100 * part / whole);
    }
}

/// Two before the crowd move, in opposite corners: what is between them is the crowd's.
void print_corners(const l3d_patch_model& model, const l3d_camera& camera) {
    constexpr int still = 1000;
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = 0.5;
    l3d_patch_scene scene = crowd(model, camera, still);
    const l3d_camera::frame axes = camera.axes();
    const auto at = [&](double side, double scale, int frame) {
        const auto off = (axes.right * 8.0 + axes.up * 6.0) * side;
        return l3d_translation<double>(off[0], off[1], off[2]) * in_front(camera, scale, frame);
    };
    scene.add(model, at(-1, 1, 0));
    scene.add(model, at(1, 1, 0));
    program all(scene, camera, settings);
    const double whole = milliseconds(all, [&](int) { all.forget_picture(); });
    std::printf("\ntwo move in opposite corners; drawn whole %.3f ms\n%8s %9s %9s %9s\n", whole,
                "around", "drawn, %", "ms", "of all, %");
    for (const double scale : {0.05, 0.1, 0.2, 0.4, 0.8}) {
        const auto move = [&](program& p, int frame) {
            p.scene().place(still, at(-1, scale, frame));
            p.scene().place(still + 1, at(1, scale, frame));
        };
        const double part = milliseconds_of_moves(all, camera, settings, move);
        const l3d_pixel_box box = all.changed();
        const auto pixels = static_cast<double>(l3d_whole(size).area());
        const double drawn = 1 - static_cast<double>(all.report().pixels_kept) / pixels;
        std::printf("%3dx%-4d %9.2f %9.3f %9.2f\n", box.right - box.left, box.bottom - box.top,
                    100 * drawn, part, 100 * part / whole);
    }
}

/// The cost of finding out that everything moves. A frame whose camera moved, too, does not ask.
void print_all_moving(const l3d_patch_model& model, const l3d_camera& camera) {
    constexpr int count = 1000;
    l3d_afd_settings settings = hard_edged();
    settings.tolerance = 0.5;
    program all(crowd(model, camera, count), camera, settings);
    std::vector<l3d_matrix<double>> first;
    for (const l3d_patch_instance& instance : all.scene().instances())
        first.push_back(instance.placement());
    const auto cost = [&](int frame, bool asks) {
        for (std::size_t i = 0; i < first.size(); ++i)
            all.scene().place(i, l3d_translation<double>(1e-6 * (frame % 2), 0.0, 0.0) * first[i]);
        if (!asks)
            all.forget_picture();
        const double before = processor_seconds();
        all.draw_event();
        if (all.report().pixels_kept != 0)
            fail("not all moves");
        return 1000 * (processor_seconds() - before);
    };
    std::vector<double> asked, whole;
    for (int frame = 0; frame < frames; ++frame) { // by turns: others use the machine, too
        asked.push_back(cost(2 * frame, true));
        whole.push_back(cost(2 * frame + 1, false));
    }
    const double asks = *std::min_element(asked.begin(), asked.end());
    const double does_not = *std::min_element(whole.begin(), whole.end());
    std::printf("\nall of %d teapots move: %.3f ms; without asking what moved %.3f ms: %+.2f %%\n",
                count, asks, does_not, 100 * (asks / does_not - 1));
}

} // namespace

int main() {
    const l3d_patch_model model = l3d_patch_model::teapot();
    const l3d_camera& camera = bench_views[0].camera;
    for (const int threads : {1, 2})
        print_moving(model, camera, threads);
    print_corners(model, camera);
    print_all_moving(model, camera);
    return EXIT_SUCCESS;
}
