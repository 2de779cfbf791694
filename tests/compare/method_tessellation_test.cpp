// SPDX-License-Identifier: MIT
// Patches as polygons: how far these are from the surface, and from which scene they were made.
#include "dice/certificate.h"
#include "dice/scene.h"

#include "scene/camera_shading.h"
#include "compare/method_patches.h"
#include "compare/method_tessellation.h"
#include "pipeline/polygons/polygon_model.h"
#include "raster/rasterizer_factory.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

namespace dice_tests {
namespace {

/// The polygons of a patch as l3d_polygon_frame draws them, with parameters, which they have
/// carried through it as the direction of their normals.
l3d_diced_piece drawn_triangles(const scene& s, std::size_t patch, const l3d_dice_view& view,
                                int n) {
    const scene alone({s.patches[patch]}, s.eye, s.size);
    l3d_polygon_mesh mesh = l3d_tessellated(alone.model, n).mesh;
    const auto side = static_cast<std::size_t>(n) + 1;
    l3d_diced_piece piece;
    piece.keep_parameters = true;
    if (mesh.vertices.size() != side * side)
        return piece; // points that coincide are one vertex of several parameters
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        mesh.vertex_normals[i] = {static_cast<double>(i % side) / n,
                                  static_cast<double>(i / side) / n, 1};
    const l3d_polygon_model model(std::move(mesh));
    l3d_workers worker(1);
    l3d_polygon_frame frame;
    l3d_camera camera = s.camera;
    camera.near_z = view.near / view.depth_scale;
    frame.make(model, {camera, s.size, l3d_identity<double>()}, {.cull = false, .smooth = true},
               worker);
    for (const l3d_surface_part* part : frame.parts())
        for (std::size_t i = 0; i < part->triangles.count; ++i) {
            std::array<l3d_dice_vertex, 3> v;
            for (std::size_t k = 0; k < 3; ++k) {
                const l3d_micro_vertex& vertex = part->triangles.vertex(i, k);
                const auto parameter = [&](int axis) {
                    const double found = static_cast<double>(vertex.normal[axis]) /
                                         static_cast<double>(vertex.normal[2]);
                    return std::round(found * n) / n;
                };
                v[k] = {vertex, parameter(0), parameter(1)};
            }
            piece.add_triangle(v[0], v[1], v[2]);
        }
    return piece;
}

TEST(method_tessellation, holds_its_bound_on_random_patches) {
    const std::uint64_t seeds = thorough ? 25 : 3;
    const reference::camera eye{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
    std::int64_t samples = 0;
    double worst = 0;
    for (const auto kind : {reference::patch_kind::moderate, reference::patch_kind::thin,
                            reference::patch_kind::folded})
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
            const scene s(reference::random_patches(seed, kind, 3, eye, {317, 241}), eye,
                          {317, 241});
            const l3d_patch_scene world(s.model);
            const l3d_image_transform to_image(s.camera, s.size, world);
            const l3d_dice_view view = to_image.view(0.3);
            certificate measured(s.eye, s.size);
            for (std::size_t i = 0; i < s.model.patches().size(); ++i) {
                const l3d_image_patch net = l3d_placed_net(to_image.matrix(), s.model.patches()[i]);
                if (!l3d_needs_no_clipping(net, view))
                    continue;
                for (const int n : {1, 3, 7, 20}) {
                    const l3d_diced_piece piece = drawn_triangles(s, i, view, n);
                    measured.next(s.patches[i]);
                    measured.draw({&piece, 1}, l3d_tessellation_bound(net, view, n));
                }
            }
            samples += measured.samples;
            worst = std::max(worst, measured.worst_ratio);
            EXPECT_EQ(measured.violations, 0)
                << "kind " << static_cast<int>(kind) << ", seed " << seed << ": "
                << measured.worst_measured << " px at (" << measured.worst_u << ", "
                << measured.worst_v << "), bound " << measured.worst_bound;
        }
    EXPECT_GT(samples, 10000);
    std::printf("%ld samples, measured / bound at most %.2f\n", static_cast<long>(samples), worst);
}

/// The corners of one triangle are snapped and nothing else can be wrong with it: the bound holds
/// that, too, and hardly more.
TEST(method_tessellation, bounds_what_snapping_does_to_a_flat_patch) {
    const l3d_dice_view view = [] {
        l3d_dice_view result;
        result.size = {317, 241};
        result.near = 0.1;
        return result;
    }();
    l3d_image_patch net;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            net.points[static_cast<std::size_t>(4 * row + column)] = {-37.25 + 21 * column,
                                                                      11.5 + 17 * row, 1.0};
    const double half_a_sub_pixel = std::sqrt(2.0) / 512;
    const double bound = l3d_tessellation_bound(net, view, 5);
    EXPECT_GE(bound, half_a_sub_pixel);
    EXPECT_LE(bound, 1.3 * half_a_sub_pixel);
}

/// A scene that has changed is drawn as by a method that has never seen another.
TEST(method_tessellation, makes_its_polygons_again_when_the_scene_changes) {
    const l3d_size size{233, 171};
    const scene s = teapot(reference::project_view("full"), size);
    const l3d_rasterizer_factory_sw rasterizers;
    l3d_workers workers(1);
    const auto picture_of = [&](const l3d_patch_scene& what, l3d_surface_method& method) {
        std::vector<std::uint32_t> words(static_cast<std::size_t>(size.width * size.height));
        const l3d_pixels target{words.data(), size.width, size.height, size.width};
        const l3d_image_transform to_image(s.camera, size, what);
        const l3d_dice_view view = to_image.view(0.25);
        l3d_depth_buffer depth;
        l3d_stage_times times;
        method.draw({what,
                     {},
                     s.camera,
                     to_image.matrix(),
                     view,
                     l3d_camera_shading(s.camera, size, l3d_shade::lambert, {0.3, 0.8, 0.5}),
                     target,
                     depth,
                     false,
                     false,
                     false,
                     l3d_whole(size)},
                    times);
        return words;
    };
    l3d_patch_scene moved;
    l3d_matrix<double> placement = l3d_identity<double>();
    placement(0, 3) = 0.7;
    placement(1, 1) = 0.6; // turns normals
    moved.add(s.model, placement);
    l3d_patch_scene two = moved;
    two.add(s.model);
    l3d_method_tessellation method(6, rasterizers, workers);
    std::vector<std::vector<std::uint32_t>> pictures;
    for (const l3d_patch_scene& what : {l3d_patch_scene(s.model), moved, two}) {
        l3d_method_tessellation fresh(6, rasterizers, workers);
        pictures.push_back(picture_of(what, method));
        EXPECT_EQ(pictures.back(), picture_of(what, fresh));
        EXPECT_EQ(pictures.back(), picture_of(what, method));
    }
    EXPECT_NE(pictures[0], pictures[1]);
    EXPECT_NE(pictures[1], pictures[2]);
}

} // namespace
} // namespace dice_tests
