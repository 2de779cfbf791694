// SPDX-License-Identifier: MIT
// Worlds through a depth buffer: against rays that are cast at every polygon, and against what
// models of polygons show by themselves.
#include "pipeline/worlds/pipeline_world.h"

#include "hard_edged.h"
#include "geom/polygon_mesh.h"
#include "geom/polygon_shapes.h"
#include "pipeline/polygons/pipeline_zbuffer.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"
#include "words_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace {

using real = l3d_real;
using vector = l3d_vector<double, 3>;

constexpr l3d_size window{80, 60};

double uniform(std::mt19937& random) {
    return static_cast<double>(random()) / 0x1p31 - 1;
}

/// Colours as they are, whatever the light.
void paint_plainly(l3d_world& world) {
    world.surfaces.lighting.ambient = {1, 1, 1};
    world.surfaces.lighting.color = {0, 0, 0};
    world.surfaces.cull = false;
    world.surfaces.antialias = false;
    world.surfaces.background = {};
}

void add_quad(l3d_polygon_mesh& mesh, const std::array<vector, 4>& corners, std::uint32_t color) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.add_face({{first, first + 1, first + 2, first + 3}});
    mesh.face_colors.push_back(color);
}

/// Two rooms of 20 x 10 x 20 side by side, with a wall between them that has a door.
l3d_polygon_mesh house() {
    l3d_polygon_mesh mesh;
    for (int room = 0; room < 2; ++room) {
        const double x0 = 20 * room, x1 = x0 + 20;
        const std::uint32_t tint = room == 0 ? 0x000030 : 0x300000;
        add_quad(mesh, {{{x0, 0, 0}, {x0, 0, 20}, {x1, 0, 20}, {x1, 0, 0}}}, 0x404040 + tint);
        add_quad(mesh, {{{x0, 10, 0}, {x1, 10, 0}, {x1, 10, 20}, {x0, 10, 20}}}, 0xc0c0c0 + tint);
        add_quad(mesh, {{{x0, 0, 20}, {x0, 10, 20}, {x1, 10, 20}, {x1, 0, 20}}}, 0x808000 + tint);
        add_quad(mesh, {{{x0, 0, 0}, {x1, 0, 0}, {x1, 10, 0}, {x0, 10, 0}}}, 0x008080 + tint);
    }
    add_quad(mesh, {{{0, 0, 0}, {0, 10, 0}, {0, 10, 20}, {0, 0, 20}}}, 0x803080);
    add_quad(mesh, {{{40, 0, 0}, {40, 0, 20}, {40, 10, 20}, {40, 10, 0}}}, 0x308030);
    return mesh;
}

/// The wall at x = 20 without what lies in the door, from z = 8 to 12 and up to y = 7: what is cut
/// off at each of the door's planes stays.
std::vector<l3d_polygon_mesh> wall_with_door() {
    l3d_polygon_mesh rest;
    add_quad(rest, {{{20, 0, 0}, {20, 10, 0}, {20, 10, 20}, {20, 0, 20}}}, 0xe0a040);
    std::vector<l3d_polygon_mesh> parts;
    for (const auto& plane : {l3d_plane<double>::through({20, 0, 8}, {0.0, 0.0, -1.0}),
                              l3d_plane<double>::through({20, 0, 12}, {0.0, 0.0, 1.0}),
                              l3d_plane<double>::through({20, 7, 0}, {0.0, 1.0, 0.0})}) {
        parts.push_back(l3d_cut_mesh(rest, plane, l3d_cut_end::open));
        rest = l3d_cut_mesh(rest, plane.flipped(), l3d_cut_end::open);
    }
    return parts;
}

/// What a ray meets first.
struct hit {
    double distance = std::numeric_limits<double>::max();
    std::uint32_t color = 0;
    /// How near the ray comes to any edge of a polygon, in pixels, or to a place where two polygons
    /// are equally far.
    bool is_close_call = false;
};

/// Casts rays at all faces, each in the camera's coordinates, in double and without any buffer.
class ray_caster {
public:
    ray_caster(const l3d_world& world, l3d_size size) : camera_(world.camera), size_(size) {
        for (const auto& object : world.objects()) {
            const l3d_matrix<real> to_camera =
                camera_.viewing_transform() * object->world_transform();
            for (std::size_t f = 0; f < object->mesh().faces(); ++f) {
                face made{{}, object->mesh().face_colors[f]};
                for (const std::uint32_t i : object->mesh().face(f)) {
                    const auto p = l3d_transformed(to_camera, object->vertices()[i]);
                    made.corners.push_back(
                        {l3d_to_double(p[0]), l3d_to_double(p[1]), l3d_to_double(p[2])});
                }
                faces_.push_back(std::move(made));
            }
        }
    }

    /// Through the pixel's centre, which is a whole number in the book's pictures.
    hit cast(int x, int y) const {
        const vector ray{(x - size_.width / 2.0) / (camera_.fovx * size_.width),
                         (size_.height / 2.0 - y) / (camera_.fovy * size_.height), 1.0};
        hit result;
        for (const face& f : faces_) {
            const auto [distance, margin] = meet(f, ray);
            if (std::abs(margin) < closest && distance < result.distance * 1.001)
                result.is_close_call = true;
            if (margin < 0 || !(distance >= camera_.near_z) || distance > camera_.far_z)
                continue;
            if (std::abs(distance - result.distance) < 1e-4 * distance)
                result.is_close_call = true;
            if (distance < result.distance) {
                result.distance = distance;
                result.color = f.color;
            }
        }
        return result;
    }

private:
    /// Vertices are rounded to 1/256 pixel in x and in y: edges move by less than this. Units:
    /// pixels.
    static constexpr double closest = 0.75 / 256;

    struct face {
        std::vector<vector> corners;
        std::uint32_t color;
    };

    /// Distance along the view axis, and how far inside the face the ray passes: the least distance
    /// from an edge in the plane of the picture, in pixels; negative outside.
    std::pair<double, double> meet(const face& f, const vector& ray) const {
        const vector normal = l3d_cross(f.corners[1] - f.corners[0], f.corners[2] - f.corners[0]);
        const double towards = l3d_dot(normal, ray);
        if (towards == 0)
            return {0, -1e9};
        const double distance = l3d_dot(normal, f.corners[0]) / towards;
        double margin = 1e9;
        for (std::size_t k = 0; k < f.corners.size(); ++k) {
            // The plane through the eye and an edge: its distance from the ray, at z = 1.
            const vector plane = l3d_cross(f.corners[k], f.corners[(k + 1) % f.corners.size()]);
            const double across = std::hypot(plane[0] / (camera_.fovx * size_.width),
                                             plane[1] / (camera_.fovy * size_.height));
            margin = std::min(margin, -l3d_dot(plane, ray) / across * (towards < 0 ? 1 : -1));
        }
        return {distance, distance > 0 ? margin : -1e9};
    }

    l3d_camera_left_handed<real> camera_;
    l3d_size size_;
    std::vector<face> faces_;
};

/// What is kept from frame to frame for each object changes nothing that is seen: objects turn, are
/// scaled anew, go and come, and a world of their copies shows the same.
TEST(world_depth, objects_that_turn_go_and_come_look_as_in_a_new_world) {
    l3d_world world(window);
    const auto dress = [](l3d_world& one) {
        paint_plainly(one);
        one.camera.place = l3d_point<real>::of(0, 0, -14);
    };
    dress(world);
    std::mt19937 random(5);
    const auto add = [&] {
        l3d_polygon_mesh mesh = l3d_box_mesh();
        for (std::size_t i = 0; i < mesh.faces(); ++i)
            mesh.face_colors.push_back(static_cast<std::uint32_t>(random() >> 8));
        l3d_object& object = world.add(std::make_unique<l3d_object>(mesh));
        object.set_transform(0, l3d_scaling<real>(2 + uniform(random), uniform(random) - 2, 3));
        object.set_transform(
            2, l3d_translation<real>(12 * uniform(random), 9 * uniform(random), uniform(random)));
    };
    for (int i = 0; i < 12; ++i)
        add();
    l3d_pipeline_world pipeline(l3d_memory_canvas(window), world);
    int differing = 0, shown = 0;
    for (int frame = 0; frame < 60; ++frame) {
        if (frame % 3 == 0)
            world.remove(*world.objects()[static_cast<std::size_t>(frame) % 12]);
        for (const auto& object : world.objects())
            object->set_transform(1, l3d_rotation_x<real>(11.0 * frame) *
                                         l3d_rotation_y<real>(7.0 * frame));
        if (frame % 3 == 0)
            add();
        if (frame % 5 == 0)
            world.objects()[3]->set_transform(0, l3d_scaling<real>(1, 2, 2.0 + frame));
        pipeline.draw_event();
        l3d_world copies(window);
        dress(copies);
        for (const auto& object : world.objects())
            copies.add(object->clone());
        l3d_pipeline_world fresh(l3d_memory_canvas(window), copies);
        fresh.draw_event();
        const auto seen = words_of(pipeline.screen().pixels());
        const auto wanted = words_of(fresh.screen().pixels());
        for (std::size_t i = 0; i < seen.size(); ++i) {
            differing += seen[i] != wanted[i];
            shown += wanted[i] != 0;
        }
    }
    EXPECT_GT(shown, 60 * 500);
    EXPECT_LE(differing, shown / 10000); // rounding, where an edge meets the middle of a pixel
}

/// Of 100 poses in both rooms, none shows a wall of the next room where the nearest one is.
TEST(world_depth, shows_what_rays_meet_first) {
    l3d_world world(window);
    paint_plainly(world);
    world.camera.near_z = 0.05;
    world.add(std::make_unique<l3d_object>(house()));
    for (auto& part : wall_with_door())
        world.add(std::make_unique<l3d_object>(std::move(part)));
    auto box = std::make_unique<l3d_object>(l3d_pyramid_mesh());
    auto mesh = box->mesh();
    mesh.face_colors = {0xff0000, 0x00ff00, 0x0000ff, 0xffff00};
    box->set_mesh(mesh);
    box->set_transform(0, l3d_scaling<real>(0.3, 0.5, 0.2)); // not rigid
    box->set_transform(1, l3d_rotation_y<real>(30));
    box->set_transform(2, l3d_translation<real>(26, 0.5, 9));
    l3d_object& turning = world.add(std::move(box));
    l3d_pipeline_world pipeline(l3d_memory_canvas(window), world);
    std::mt19937 random(7);
    int judged = 0, wrong = 0, far_first_wrong = 0;
    for (int pose = 0; pose < 100; ++pose) {
        turning.set_transform(1, l3d_rotation_y<real>(30 + 7.0 * pose));
        world.camera.place = l3d_point<real>::of(20 + 19 * uniform(random), 5 + 4 * uniform(random),
                                                 10 + 9 * uniform(random));
        world.camera.look_at(l3d_point<real>::of(20 + 3 * uniform(random), 4 + uniform(random),
                                                 10 + uniform(random)),
                             l3d_point<real>::of(0.3 * uniform(random), 1, 0).from_origin);
        world.camera.fovx = 0.5 + 0.3 * uniform(random); // pixels that are no squares, too
        const ray_caster rays(world, window);
        std::vector<std::vector<std::uint32_t>> pictures;
        for (const auto order : {l3d_draw_order::by_depth, l3d_draw_order::far_first}) {
            world.order = order;
            pipeline.draw_event();
            pictures.push_back(words_of(pipeline.screen().pixels()));
        }
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x) {
                const hit exact = rays.cast(x, y);
                const auto at = static_cast<std::size_t>(y * window.width + x);
                if (exact.is_close_call)
                    continue;
                ++judged;
                wrong += pictures[0][at] != exact.color;
                far_first_wrong += pictures[1][at] != exact.color;
            }
    }
    EXPECT_EQ(wrong, 0) << "of " << judged;
    EXPECT_GT(judged, 98 * 100 * window.width * window.height / 100);
    EXPECT_GT(far_first_wrong, judged / 300); // the painter's order is what is wrong there
}

/// One object, a camera that looks along z: the picture of the model by itself, lit and smooth.
TEST(world_depth, an_object_looks_as_its_model_does) {
    for (const bool smooth : {false, true}) {
        l3d_world world(window);
        l3d_polygon_settings settings = hard_edged_polygons();
        settings.shade = l3d_shade::lambert;
        settings.antialias = smooth;
        settings.light = {0.3, 0.5, 0.8};
        world.surfaces = settings;
        world.surfaces.light[2] = -world.surfaces.light[2]; // left-handed
        l3d_polygon_mesh mesh = l3d_torus_mesh(24, 12);
        world.camera.place = l3d_point<real>::of(0, 0, -6);
        world.camera.near_z = 1;
        auto turned = std::make_unique<l3d_object>(mesh);
        turned->set_transform(0, l3d_rotation_x<real>(40));
        world.add(std::move(turned));
        l3d_pipeline_world pipeline(l3d_memory_canvas(window), world);
        pipeline.draw_event();

        // The same in right-handed axes: z and the corners' order are reversed.
        for (vector& v : mesh.vertices)
            v[2] = -v[2];
        for (std::size_t i = 0; i + 2 < mesh.corners.size(); i += 3)
            std::swap(mesh.corners[i], mesh.corners[i + 2]);
        settings.rotation = {-40.0, 0.0, 0.0};
        const l3d_rasterizer_factory_sw sw;
        l3d_pipeline_zbuffer alone(l3d_memory_canvas(window), l3d_polygon_model(mesh),
                                   l3d_right_handed(world.camera), settings, sw);
        alone.draw_event();
        const auto ours = words_of(pipeline.screen().pixels());
        const auto theirs = words_of(alone.screen().pixels());
        // The book's pixels lie half a pixel further: compare where neighbours are alike.
        int judged = 0, lit = 0;
        for (int y = 1; y + 1 < window.height; ++y)
            for (int x = 1; x + 1 < window.width; ++x) {
                int least = 255, most = 0;
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const auto at = static_cast<std::size_t>((y + dy) * window.width + x + dx);
                        least = std::min(least, static_cast<int>(theirs[at] & 255));
                        most = std::max(most, static_cast<int>(theirs[at] & 255));
                    }
                if (most - least > 40)
                    continue;
                ++judged;
                const int level = ours[static_cast<std::size_t>(y * window.width + x)] & 255;
                lit += level > 60;
                ASSERT_GE(level, least - 2) << x << ' ' << y;
                ASSERT_LE(level, most + 2) << x << ' ' << y;
            }
        EXPECT_GT(judged, 3500);
        EXPECT_GT(lit, 100);
    }
}

/// Materials of each object stay its own, also beside objects without any.
TEST(world_depth, every_object_keeps_its_colours) {
    l3d_world world(window);
    paint_plainly(world);
    world.camera.place = l3d_point<real>::of(0, 0, 0);
    const std::vector<std::uint32_t> colors{0xff0000, 0, 0x00ff00, 0x0000ff}; // 0: plain
    for (std::size_t i = 0; i < colors.size(); ++i) {
        l3d_polygon_mesh mesh;
        const double x = 5.0 * static_cast<double>(i) - 10;
        add_quad(mesh, {{{x, -2, 20}, {x, 2, 20}, {x + 4, 2, 20}, {x + 4, -2, 20}}}, colors[i]);
        if (colors[i] == 0)
            mesh.face_colors.clear();
        world.add(std::make_unique<l3d_object>(std::move(mesh)));
    }
    l3d_pipeline_world pipeline(l3d_memory_canvas(window), world);
    pipeline.draw_event();
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const auto at = world.camera.project(
            l3d_point<real>::of(5.0 * static_cast<double>(i) - 8, 0, 20), window);
        EXPECT_EQ(
            pipeline.screen().pixels().row(static_cast<int>(at.y))[static_cast<std::size_t>(at.x)],
            colors[i] == 0 ? 0xffffffu : colors[i]);
    }
}

/// A part of a picture shows another place; around it, nothing changes.
TEST(world_depth, a_part_of_a_picture_is_drawn_by_itself) {
    class with_mirror final : public l3d_world {
    public:
        using l3d_world::l3d_world;
        std::size_t draw_all(const l3d_world_target& target) override {
            std::size_t drawn = l3d_world::draw_all(target);
            if (!mirror)
                return drawn;
            l3d_world_target part = target;
            part.pixels.words += 10 * part.pixels.stride + 50;
            part.pixels.width = 20;
            part.pixels.height = 20;
            camera.turn_about_up(180);
            drawn += l3d_world::draw_all(part);
            camera.turn_about_up(180);
            return drawn;
        }
        bool mirror = false;
    };
    with_mirror world(window);
    paint_plainly(world);
    world.camera.place = l3d_point<real>::of(20, 5, 10);
    world.camera.near_z = 0.05;
    world.add(std::make_unique<l3d_object>(house()));
    l3d_pipeline_world pipeline(l3d_memory_canvas(window), world);
    pipeline.draw_event();
    const auto plain = words_of(pipeline.screen().pixels());
    world.mirror = true;
    pipeline.draw_event();
    const auto both = words_of(pipeline.screen().pixels());
    int inside = 0;
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            const auto at = static_cast<std::size_t>(y * window.width + x);
            if (x >= 50 && x < 70 && y >= 10 && y < 30)
                inside += plain[at] != both[at];
            else
                ASSERT_EQ(plain[at], both[at]) << x << ' ' << y;
        }
    EXPECT_GT(inside, 200);
}

/// Wires and hidden lines, any number of threads, and a HUD on top.
TEST(world_depth, styles_threads_and_instruments) {
    class with_hud final : public l3d_pipeline_world {
    public:
        using l3d_pipeline_world::l3d_pipeline_world;

    protected:
        void draw_overlay(l3d_rasterizer_2d& rasterizer) override {
            rasterizer.draw_line(0, 3, window.width, 3, 0x123456);
        }
    };
    std::vector<std::vector<std::uint32_t>> pictures;
    for (const auto style :
         {l3d_polygon_style::solid, l3d_polygon_style::wireframe, l3d_polygon_style::hidden_lines})
        for (const int threads : {1, 3}) {
            l3d_world world(window);
            world.surfaces.style = style;
            world.surfaces.threads = threads;
            world.camera.place = l3d_point<real>::of(0, 0, -12);
            world.camera.near_z = 1;
            for (int i = 0; i < 20; ++i) {
                auto ring = std::make_unique<l3d_object>(l3d_torus_mesh(12, 8));
                ring->set_transform(0, l3d_rotation_x<real>(25.0 * i));
                ring->set_transform(
                    1, l3d_translation<real>(3.0 * (i % 5) - 6, 3.0 * (i / 5) - 5, i % 3));
                world.add(std::move(ring));
            }
            with_hud pipeline(l3d_memory_canvas(window), world);
            pipeline.draw_event();
            pictures.push_back(words_of(pipeline.screen().pixels()));
            EXPECT_EQ(pictures.back()[3 * window.width + 50], 0x123456u);
        }
    for (std::size_t i = 0; i < pictures.size(); i += 2) {
        EXPECT_EQ(pictures[i], pictures[i + 1]);
        EXPECT_NE(pictures[i], pictures[(i + 2) % pictures.size()]);
    }
}

} // namespace
