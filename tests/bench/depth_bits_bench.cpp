// SPDX-License-Identifier: MIT
// How a depth buffer of whole numbers spends its range, and what 16 bits of it look like.
//
// depth_bits_bench [picture.png]: hills and a lake, far / near = 1000, with 16 bits on the left and
// our depth buffer on the right. Both halves have the same pixels of the same two surfaces. Only
// the comparison of depths differs.
#include "geom/polygon_shapes.h"
#include "pipeline/polygons/polygon_frame.h"
#include "raster/rasterizer_factory.h"
#include "scene/camera_shading.h"
#include "tool_2d/image.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <vector>

namespace {

constexpr l3d_size half{480, 360};
constexpr double near = 1, far = 1000;

/// The part of the range that GL's whole numbers, linear in 1/w, spend on what is nearer than w.
/// Units: near planes.
double spent_before(double w, double ratio) {
    return (1 - 1 / w) / (1 - 1 / ratio);
}

void print_shares() {
    std::printf(
        "far / near  nearest 1 %%  2 %%  10 %%  50 %% of the depth: per cent of the range\n");
    for (const double ratio : {1e2, 1e3, 1e4, 1e6}) {
        std::printf("%10.0e", ratio);
        for (const double part : {0.01, 0.02, 0.1, 0.5})
            std::printf("  %6.2f", 100 * spent_before(1 + part * (ratio - 1), ratio));
        std::printf("\n");
    }
}

/// One surface, drawn alone.
struct drawn_surface {
    std::vector<std::uint32_t> words;
    std::vector<float> distances; ///< infinite where it is not
};

l3d_camera camera() {
    l3d_camera result;
    result.eye = {30, -480, 150};
    result.target = {0, 0, -40};
    result.up = {0, 0, 1};
    result.near_z = near;
    result.far_z = far;
    return result;
}

template <class Height> drawn_surface drawn(Height height, const l3d_material& material) {
    constexpr double reach = 500;
    l3d_polygon_mesh mesh = l3d_grid_mesh(180, height);
    for (auto& vertex : mesh.vertices)
        vertex *= reach;
    const l3d_polygon_model model(mesh);
    l3d_workers workers(1);
    const auto surface = l3d_rasterizer_factory_sw().create_surface(workers);
    l3d_polygon_frame frame;
    const l3d_polygon_view view(camera(), half, l3d_identity<double>());
    frame.make(model, view, {.cull = false, .smooth = true}, workers);
    drawn_surface result;
    result.words.resize(static_cast<std::size_t>(half.width * half.height));
    l3d_depth_buffer depth;
    depth.resize(half);
    const l3d_pixels target{result.words.data(), half.width, half.height, half.width};
    const std::array<l3d_material, 1> materials{material};
    surface->use_materials(materials);
    surface->begin(target, &depth,
                   l3d_camera_shading(camera(), half, l3d_shade::lambert, {-0.6, -0.4, 0.5}));
    surface->draw(frame.parts());
    surface->finish();
    result.distances = l3d_distances(depth);
    return result;
}

/// What a buffer of 16 bits holds.
int whole(float distance) {
    constexpr double most = 65535;
    return static_cast<int>(
        std::floor(most * spent_before(static_cast<double>(distance) / near, far / near) + 0.5));
}

void write_picture(const char* file) {
    const auto hills = drawn(
        [](double x, double y) {
            return 0.004 * std::sin(9 * x + 2 * y) * std::cos(7 * y - x) +
                   0.0013 * std::sin(31 * x) * std::sin(27 * y + 5 * x);
        },
        {});
    const auto lake = drawn([](double, double) { return 0.0; }, {});
    constexpr int gap = 4;
    const l3d_size size{2 * half.width + gap, half.height};
    l3d_image image(size);
    long wrong = 0;
    for (int y = 0; y < half.height; ++y)
        for (int x = 0; x < half.width; ++x) {
            const auto at = static_cast<std::size_t>(y * half.width + x);
            const float near_hill = hills.distances[at], near_lake = lake.distances[at];
            const bool is_exact = near_lake < near_hill;
            const bool is_whole = std::isfinite(near_lake) && (!std::isfinite(near_hill) ||
                                                               whole(near_lake) < whole(near_hill));
            wrong += is_exact != is_whole;
            const auto word_of = [&](bool shows_lake) {
                const std::uint32_t grey = (shows_lake ? lake : hills).words[at] & 255;
                return shows_lake ? grey / 3 << 16 | grey / 2 << 8 | grey
                                  : grey << 16 | grey << 8 | grey / 2;
            };
            image.pixels().row(y)[static_cast<std::size_t>(x)] = word_of(is_whole);
            image.pixels().row(y)[static_cast<std::size_t>(half.width + gap + x)] =
                word_of(is_exact);
        }
    std::printf("%ld of %d pixels show the wrong one of two surfaces with 16 bits\n", wrong,
                half.width * half.height);
    l3d_write_image(file, image.pixels());
}

} // namespace

int main(int argc, char** argv) try {
    print_shares();
    // Options are for the other benchmarks, which are run with the same arguments.
    if (argc > 1 && argv[1][0] != '-')
        write_picture(argv[1]);
} catch (const std::exception& error) {
    std::fprintf(stderr, "depth_bits_bench: %s\n", error.what());
    return 1;
}
