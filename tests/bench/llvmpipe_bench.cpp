// SPDX-License-Identifier: MIT
// l3d against Mesa's llvmpipe drawing triangles, at equal measured error, each on one thread.
//
// Both draw the same view into memory, in turn, and the medians are compared. The peer gets the
// coarsest uniform mesh of n by n quads per patch whose measured error is at most ours, in static
// buffers, with the shading baked into its vertices (ours shades every pixel). The geometric
// error of both is measured alike; the pictures are compared, too, and must agree.
#include "bench/osmesa.h"
#include "bench/surface_error.h"
#include "geom/teapot.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/visibility.h"
#include "raster/rasterizer_factory_sw.h"
#include "tool_2d/screen_memory.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

struct named_view {
    const char* name;
    l3d_camera camera;
};

const std::array<named_view, 3> views{{
    {"full", {{3.2, 3.6, 7.4}, {0.2, 1.3, 0.0}, {0.0, 1.0, 0.0}, 38, 0.1, 1e13}},
    {"closeup", {{1.2, 2.6, 4.4}, {-0.3, 1.5, 0.0}, {0.0, 1.0, 0.0}, 45, 0.1, 1e13}},
    {"top", {{1.5, 7.5, 3.0}, {0.2, 1.2, 0.0}, {0.0, 1.0, 0.0}, 35, 0.1, 1e13}},
}};

/// GL's clip coordinates from ours: x and y to [-w, w], z = near, so that depth grows with 1 / w.
std::array<float, 16> clip_matrix(const l3d_camera& camera, l3d_size size) {
    const l3d_matrix<double> m = camera.image_matrix(size);
    std::array<float, 16> clip{};
    for (int column = 0; column < 4; ++column) {
        const auto at = static_cast<std::size_t>(4 * column);
        clip[at] = static_cast<float>(m(0, column) / (size.width / 2.0));
        clip[at + 1] = static_cast<float>(-m(1, column) / (size.height / 2.0));
        clip[at + 2] = static_cast<float>(column == 3 ? camera.near : 0.0);
        clip[at + 3] = static_cast<float>(m(3, column));
    }
    return clip;
}

gl_mesh uniform_mesh(const l3d_patch_model& model, const l3d_camera& camera, int n) {
    const auto light = l3d_normalized(l3d_vector<double, 3>(0.4, 0.8, 0.45));
    gl_mesh mesh;
    for (std::size_t i = 0; i < model.patches().size(); ++i) {
        const auto first = static_cast<std::uint32_t>(mesh.positions.size() / 3);
        for (int r = 0; r <= n; ++r)
            for (int c = 0; c <= n; ++c) {
                const double u = static_cast<double>(c) / n, v = static_cast<double>(r) / n;
                const auto p = model.patches()[i].evaluate(u, v);
                auto normal = l3d_normalized(model.normals(i).evaluate(u, v));
                if (l3d_dot(normal, camera.eye - p) < 0)
                    normal = normal * -1.0;
                const double grey = 0.1 + 0.9 * std::max(0.0, l3d_dot(normal, light));
                for (int k = 0; k < 3; ++k)
                    mesh.positions.push_back(static_cast<float>(p[k]));
                mesh.colors.insert(mesh.colors.end(), 3,
                                   static_cast<std::uint8_t>(255 * grey + 0.5));
                mesh.colors.push_back(255);
            }
        const auto pitch = static_cast<std::uint32_t>(n + 1);
        for (std::uint32_t r = 0; r < static_cast<std::uint32_t>(n); ++r)
            for (std::uint32_t c = 0; c < static_cast<std::uint32_t>(n); ++c) {
                const std::uint32_t a = first + r * pitch + c;
                mesh.indices.insert(mesh.indices.end(),
                                    {a, a + 1, a + pitch + 1, a, a + pitch + 1, a + pitch});
            }
    }
    return mesh;
}

double uniform_error(const l3d_patch_model& model, const l3d_camera& camera, l3d_size size, int n) {
    surface_error error(camera, size);
    for (const auto& patch : model.patches())
        for (int r = 0; r < n; ++r)
            for (int c = 0; c < n; ++c) {
                const double u0 = static_cast<double>(c) / n, u1 = (c + 1.0) / n;
                const double v0 = static_cast<double>(r) / n, v1 = (r + 1.0) / n;
                error.add_triangle(patch, {u0, u1, u1}, {v0, v0, v1});
                error.add_triangle(patch, {u0, u1, u0}, {v0, v1, v1});
            }
    return error.largest();
}

double our_error(const l3d_patch_model& model, const l3d_camera& camera, l3d_size size,
                 double tolerance, double& bound) {
    const l3d_image_transform transform(camera, size, model);
    const l3d_dice_view view = transform.view(tolerance);
    surface_error error(camera, size);
    l3d_patch_dicer<l3d_real> dicer;
    l3d_edge_polylines edges;
    l3d_diced_pieces pieces = l3d_diced_pieces::with_parameters();
    l3d_dice_counts counts;
    for (std::size_t i = 0; i < model.patches().size(); ++i) {
        const l3d_image_patch net = transform(model.patches()[i]);
        if (l3d_left_out(net, view, counts))
            continue;
        pieces.clear();
        edges.build(net, view);
        dicer.dice(net, model.normals(i), view, edges, pieces, counts);
        add_pieces(error, model.patches()[i], pieces.used(), view);
    }
    bound = counts.bound_px;
    return error.largest();
}

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<long>(values.size() / 2),
                     values.end());
    return values[values.size() / 2];
}

template <class Action> double milliseconds(Action action) {
    const auto start = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

/// Pixels covered in one picture only.
long different_coverage(l3d_pixels ours, std::span<const std::uint8_t> theirs) {
    long different = 0;
    for (int y = 0; y < ours.height; ++y)
        for (int x = 0; x < ours.width; ++x) {
            const auto at =
                4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(ours.width) +
                     static_cast<std::size_t>(x));
            different += (ours.row(y)[static_cast<std::size_t>(x)] != 0) != (theirs[at] != 0);
        }
    return different;
}

/// One row of the table. Returns the ratio of the medians, theirs to ours.
double compare(const l3d_patch_model& model, const named_view& view, l3d_size size,
               double tolerance, osmesa& gl, int rounds) {
    double bound = 0;
    const double ours = our_error(model, view.camera, size, tolerance, bound);
    int n = 2;
    while (uniform_error(model, view.camera, size, n) > ours)
        n += n < 16 ? 1 : 2;
    const double theirs = uniform_error(model, view.camera, size, n);

    l3d_service refusal;
    l3d_screen_factory_memory screens;
    l3d_screen_request request;
    request.size = size;
    l3d_afd_settings settings;
    settings.tolerance = tolerance;
    l3d_pipeline_afd pipeline(screens.create(request, refusal), l3d_rasterizer_factory_sw(), model,
                              view.camera, settings);
    gl.set_projection(clip_matrix(view.camera, size));
    gl.upload(uniform_mesh(model, view.camera, n));

    constexpr int warm_up = 3;
    std::vector<double> our_ms, their_ms;
    for (int i = 0; i < warm_up + rounds; ++i) {
        const double mine = milliseconds([&] { pipeline.draw_event(); });
        const double peer = milliseconds([&] { gl.draw(); });
        if (i >= warm_up) {
            our_ms.push_back(mine);
            their_ms.push_back(peer);
        }
    }
    const double ratio = median(their_ms) / median(our_ms);
    const long different = different_coverage(pipeline.screen().pixels(), gl.picture());
    std::printf("%-8s %5dx%-5d %5.2f | %6.3f %6.3f %7.2f | %3d %6.3f %7.2f | %6.2f | %5ld\n",
                view.name, size.width, size.height, tolerance, bound, ours, median(our_ms), n,
                theirs, median(their_ms), ratio, different);
    // Both pictures are within a pixel of the truth: more than the outline must not differ.
    if (different > pipeline.report().pixels_covered / 100) {
        std::fprintf(stderr, "the pictures differ\n");
        std::exit(1);
    }
    return ratio;
}

} // namespace

int main() {
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    const l3d_size size{1024, 768};
    const auto gl = osmesa::create(size, 0, why);
    if (!model || !gl) {
        std::fprintf(stderr, "llvmpipe_bench: %s\n", why.c_str());
        return 1;
    }
    std::printf("l3d %s, one thread, against %s, one thread; medians of 41 frames in turn\n\n",
                l3d_real_name(), gl->renderer().c_str());
    std::printf("%-8s %11s %5s | %6s %6s %7s | %3s %6s %7s | %6s | %s\n", "view", "size", "tol",
                "bound", "error", "l3d ms", "n", "error", "GL ms", "ratio", "pixels differ");
    double least = 1e9;
    for (const double tolerance : {0.5, 0.25, 0.1})
        for (const named_view& view : views)
            least = std::min(least, compare(*model, view, size, tolerance, *gl, 41));
    std::printf("\nleast ratio %.2f\n", least);
    return 0;
}
