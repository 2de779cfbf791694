// SPDX-License-Identifier: MIT
// How much of its stack a thread needs that draws: less than l3d_stack_bytes, whatever it draws.
#include "effort.h"

#include "geom/polygon_shapes.h"
#include "geom/transform.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/rasterizer_factory.h"
#include "raster/placement_2d.h"
#include "raster/parallel/workers.h"
#include "raster/paths/gradient.h"
#include "raster/paths/path.h"
#include "raster/text/font.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <pthread.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <utility>

namespace {

constexpr l3d_size window{320, 240};

/// Runs something on a thread of its own, whose stack is painted before. Returns how many bytes of
/// it are no longer as they were.
std::size_t stack_taken(const std::function<void()>& work) {
    constexpr std::size_t bytes = std::size_t{1} << 22, page = 4096;
    constexpr std::uint64_t paint = 0x5eed5eed5eed5eed;
    const auto free = [](std::uint64_t* stack) { std::free(stack); };
    const std::unique_ptr<std::uint64_t, decltype(free)> stack(
        static_cast<std::uint64_t*>(std::aligned_alloc(page, bytes)), free);
    const std::size_t words = bytes / sizeof(std::uint64_t);
    std::fill_n(stack.get(), words, paint);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstack(&attributes, stack.get(), bytes);
    const auto call = [](void* context) -> void* {
        (*static_cast<const std::function<void()>*>(context))();
        return nullptr;
    };
    pthread_t thread{};
    EXPECT_EQ(pthread_create(&thread, &attributes, call,
                             const_cast<void*>(static_cast<const void*>(&work))),
              0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    const auto* const first =
        std::find_if(stack.get(), stack.get() + words, [](std::uint64_t w) { return w != paint; });
    return static_cast<std::size_t>(stack.get() + words - first) * sizeof(std::uint64_t);
}

void expect_small(const std::string& name, const std::function<void()>& work) {
    const std::size_t taken = stack_taken(work);
    std::printf("%s: %zu bytes of stack\n", name.c_str(), taken);
    EXPECT_LT(taken, l3d_stack_bytes) << name;
}

l3d_camera camera_at(double x, double y, double z) {
    l3d_camera camera;
    camera.eye = {x, y, z};
    camera.target = {0.2, 1.3, 0.0};
    return camera;
}

/// The teapot from afar, from near, and cut by the near plane.
void draw_patches(const l3d_afd_settings& settings) {
    l3d_patch_scene scene(l3d_patch_model::teapot());
    scene.add(l3d_patch_model::teapot(), l3d_translation<double>(0.5, 0.25, 1.0));
    for (const l3d_camera& camera :
         {camera_at(6, 5, 7), camera_at(1.5, 2.5, 2.5), camera_at(0.1, 1.2, 0.9)}) {
        l3d_pipeline_afd pipeline(l3d_memory_canvas(window), scene, camera, settings);
        pipeline.draw_event();
        scene.set_opacity(1, 0.5);
    }
}

TEST(small_stack, draws_patches_of_every_shade) {
    if (sanitized)
        GTEST_SKIP() << "sanitizers have larger frames";
    for (const auto& [name, shade] : l3d_shade_names)
        for (const bool antialias : {false, true}) {
            l3d_afd_settings settings;
            settings.shade = shade;
            settings.antialias = antialias;
            settings.tolerance = antialias ? 0.05 : 0.25;
            expect_small(std::string(name) + (antialias ? ", smooth" : ""),
                         [&] { draw_patches(settings); });
        }
}

TEST(small_stack, draws_lines_nets_and_maps_of_doubt) {
    if (sanitized)
        GTEST_SKIP() << "sanitizers have larger frames";
    l3d_afd_settings settings;
    settings.net = settings.wireframe = settings.antialias = true;
    expect_small("wireframe", [&] { draw_patches(settings); });
    settings = {};
    settings.outlines = settings.depth = settings.net = true;
    settings.lighting.count = 1;
    settings.lighting.lights[0].direction = {-0.6F, 0.8F, 0};
    expect_small("outlines, two lights", [&] { draw_patches(settings); });
    settings.error_map = true;
    settings.lighting = {};
    expect_small("map of doubt", [&] {
        l3d_pipeline_afd pipeline(l3d_memory_canvas({64, 48}), l3d_patch_model::teapot(),
                                  camera_at(6, 5, 7), settings);
        pipeline.draw_event();
        EXPECT_TRUE(pipeline.pick(32, 24));
    });
}

template <class Pipeline, class... More>
void draw_polygons(const l3d_polygon_settings& settings, const More&... more) {
    l3d_polygon_mesh mesh = l3d_torus_mesh(60, 40);
    mesh.append(l3d_grid_mesh(60, [](double x, double y) { return std::sin(3 * x) * y; }));
    mesh.append(l3d_sphere_mesh(30, 20, 1.5));
    for (const l3d_camera& camera : {camera_at(6, 5, 7), camera_at(0.4, 0.3, 2.1)}) {
        Pipeline pipeline(l3d_memory_canvas(window), l3d_polygon_model(mesh), camera, settings,
                          more...);
        pipeline.draw_event();
    }
}

TEST(small_stack, draws_polygons) {
    if (sanitized)
        GTEST_SKIP() << "sanitizers have larger frames";
    for (const l3d_polygon_style style :
         {l3d_polygon_style::solid, l3d_polygon_style::wireframe, l3d_polygon_style::hidden_lines})
        for (const bool antialias : {false, true}) {
            l3d_polygon_settings settings;
            settings.style = style;
            settings.antialias = antialias;
            settings.shade = antialias ? l3d_shade::lambert : l3d_shade::flat;
            const std::string which =
                std::to_string(static_cast<int>(style)) + (antialias ? ", smooth" : "");
            expect_small("zbuffer, style " + which, [&] {
                draw_polygons<l3d_pipeline_zbuffer>(settings, l3d_rasterizer_factory_sw());
            });
            expect_small("zsort, style " + which,
                         [&] { draw_polygons<l3d_pipeline_zsort>(settings); });
        }
}

TEST(small_stack, draws_paths_text_images_and_meshes) {
    if (sanitized)
        GTEST_SKIP() << "sanitizers have larger frames";
    expect_small("two dimensions", [] {
        l3d_image picture(window);
        const auto imp = l3d_rasterizer_factory_sw().create_2d(picture.pixels());
        l3d_rasterizer_2d rasterizer(*imp);
        l3d_path path;
        path.add_circle({150, 120}, 90);
        path.move_to({-1e5, -50});
        path.cubic_to({700, 400}, {-400, 400}, {300, -1e6});
        std::string why;
        for (const l3d_font& font : {l3d_font(), l3d_font::of_system(why)}) {
            font.outline(path, {20.5, 60.25}, "Kerned AV", 33);
            font.draw(rasterizer, 10, 20, "plain", 0x00ffffff, 17);
        }
        for (const l3d_blending blending : {l3d_blending::coded, l3d_blending::linear}) {
            l3d_path clip;
            clip.add_circle({160, 120}, 100);
            rasterizer.draw_path(path, {.alpha = 0.5,
                                        .inside = l3d_winding::even_odd,
                                        .clip = &clip,
                                        .blending = blending});
            rasterizer.draw_path(l3d_stroked(path, {.width = 5, .dashes = {9, 4, 2}}),
                                 {.blending = blending});
        }
        rasterizer.draw_curves(path, 0x00ff8000);
        l3d_image small({7, 5}, 7);
        rasterizer.draw_image({.pixels = small.pixels(), .place = {{80, 60}, {9, 3}, {-4, 11}}},
                              {});
        l3d_mesh_patch patch;
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                patch.points[row][column] = {300.0 * static_cast<double>(column * column) / 9,
                                             200.0 * static_cast<double>(row) / 3};
        rasterizer.draw_mesh({&patch, 1});
        rasterizer.finish();
    });
}

} // namespace
