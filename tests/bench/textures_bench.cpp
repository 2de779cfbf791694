// SPDX-License-Identifier: MIT
// Pictures on surfaces: how far each filter is from the mean of 256 samples, ours beside those of
// Mesa's llvmpipe, and the time of a frame of both.
//
// The surfaces are a flat patch under several angles, the teapot and an exact sphere, in pictures
// of 64 x 48 pixels. Errors are roots of mean squares over the pixels that lie within the surface.
// The time is that of the teapot in 1024 x 768 pixels with a picture of 1024 x 1024, one thread of
// each. llvmpipe gets triangles; ours starts from the patches.
//
// Usage: textures_bench [errors | time | ours FILTER FRAMES | mesa FILTER FRAMES]. The last two
// draw so many frames, for a profiler or `perf stat`.
#include "bench/mesa_textured_peer.h"
#include "pipeline/textured_scenes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace textured_scenes;

std::unique_ptr<mesa_textured_peer> opened_peer() {
    std::string why;
    auto peer = mesa_textured_peer::open(why);
    if (!peer)
        throw std::runtime_error(why);
    return peer;
}

// ---- errors

void print_errors(const std::string& name, const l3d_patch_model& model, const l3d_camera& camera,
                  l3d_image& picture, double tolerance) {
    const l3d_patch_scene scene =
        scene_of(model, std::make_shared<const l3d_texture>(
                            picture.pixels(), l3d_texture_wrap::clamp, l3d_texture_wrap::clamp));
    const means truth(scene, camera);
    const auto peer = opened_peer();
    constexpr int quads = 32; // finer than pixels
    const int level = std::min(model.most_level(), 1);
    peer->prepare(model.at_level(level, level), camera, means::size, quads, picture.pixels(), true);
    std::printf("%-28s", name.c_str());
    for (const auto& [filter_name, filter] : l3d_texture_filter_names) {
        l3d_afd_settings settings = plainly(filter);
        settings.tolerance = tolerance;
        const double ours = truth.error_of(drawn(scene, settings, camera, means::size));
        const bool has = peer->take(filter);
        peer->draw();
        std::printf(" | %5.1f %5.1f", ours, has ? truth.error_of(peer->picture()) : -1);
    }
    std::printf("\n");
}

void print_errors() {
    std::printf("levels of 255: ours, and %s\n%-28s", opened_peer()->renderer().c_str(), "");
    for (const auto& [name, filter] : l3d_texture_filter_names)
        std::printf(" | %11s", name);
    std::printf("\n");
    l3d_image squares = squares_picture(128), waves = waves_picture(128);
    const double usual = by_levels().tolerance;
    for (const int angle : {0, 30, 45, 60, 70, 80, 85})
        print_errors("a plane, " + std::to_string(angle) + " degrees", floor_patch(),
                     above_floor(90 - angle), squares, usual);
    l3d_camera beside;
    beside.eye = {1.6, 1.2, 3.6};
    for (const double tolerance : {usual, 0.02}) {
        const std::string how = ", " + std::to_string(tolerance).substr(0, 4) + " px";
        for (l3d_image* const picture : {&waves, &squares}) {
            const std::string of = how + (picture == &waves ? "" : ", squares");
            print_errors("the teapot" + of, l3d_patch_model::teapot(), teapot_camera(), *picture,
                         tolerance);
            print_errors("a sphere" + of, sphere(), beside, *picture, tolerance);
        }
    }
}

// ---- time

constexpr l3d_size size{1024, 768};

l3d_image noise() {
    std::mt19937 random(1);
    constexpr int side = 1024;
    l3d_image image({side, side}, side);
    for (int y = 0; y < side; ++y)
        for (std::uint32_t& word : image.pixels().row(y))
            word = static_cast<std::uint32_t>(random() & 0xffffff);
    return image;
}

/// A side of the comparison: draws a frame. The picture never changes, and is drawn anew.
struct ours {
    l3d_pipeline_afd pipeline;

    explicit ours(l3d_texture_filter filter)
        : pipeline(l3d_memory_canvas(size),
                   scene_of(l3d_patch_model::teapot(),
                            std::make_shared<const l3d_texture>(noise().pixels())),
                   teapot_camera(), settings(filter)) {}

    static l3d_afd_settings settings(l3d_texture_filter filter) {
        l3d_afd_settings result = by_levels(filter);
        result.threads = 1;
        result.keep.drawing = true;
        return result;
    }
    void draw() { pipeline.draw_event(); }
};

struct theirs {
    std::unique_ptr<mesa_textured_peer> peer = opened_peer();

    explicit theirs(l3d_texture_filter filter) {
        l3d_image picture = noise();
        constexpr int quads = 8; // as many triangles as 0.25 pixels need
        peer->prepare(l3d_patch_model::teapot(), teapot_camera(), size, quads, picture.pixels(),
                      false);
        if (!peer->take(filter))
            throw std::runtime_error("this GL has no anisotropic filter");
    }
    void draw() { peer->draw(); }
};

/// Median of some frames, in milliseconds.
template <class Side> double median_ms(Side& side) {
    constexpr int frames = 21;
    std::array<double, frames> times{};
    side.draw();
    for (double& time : times) {
        const auto start = std::chrono::steady_clock::now();
        side.draw();
        time = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
                   .count();
    }
    std::ranges::nth_element(times, times.begin() + frames / 2);
    return times[frames / 2];
}

void print_times() {
    std::printf("\nthe teapot, %d x %d, picture of 1024 x 1024, one thread: ms a frame\n"
                "%-12s %8s %8s %8s\n",
                size.width, size.height, "", "ours", "llvmpipe", "ratio");
    for (const auto& [name, filter] : l3d_texture_filter_names) {
        ours a(filter);
        theirs b(filter);
        const double of_a = median_ms(a), of_b = median_ms(b);
        std::printf("%-12s %8.2f %8.2f %8.2f\n", name, of_a, of_b, of_b / of_a);
    }
}

l3d_texture_filter filter_named(const std::string& name) {
    for (const auto& [known, filter] : l3d_texture_filter_names)
        if (name == known)
            return filter;
    throw std::runtime_error("no filter " + name);
}

template <class Side> void draw_frames(const std::string& filter, const std::string& frames) {
    Side side(filter_named(filter));
    for (int i = std::atoi(frames.c_str()); i > 0; --i)
        side.draw();
}

} // namespace

int main(int argc, char** argv) try {
    setenv("LP_NUM_THREADS", "0", 0); // all of llvmpipe in the thread that calls it
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "ours" && argc == 4)
        draw_frames<ours>(argv[2], argv[3]);
    else if (what == "mesa" && argc == 4)
        draw_frames<theirs>(argv[2], argv[3]);
    else {
        if (what != "time")
            print_errors();
        if (what != "errors")
            print_times();
    }
} catch (const std::exception& error) {
    std::fprintf(stderr, "textures_bench: %s\n", error.what());
    return 1;
}
