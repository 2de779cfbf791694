// SPDX-License-Identifier: MIT
// Pictures and colours of vertices on polygons: each pixel by what a pick meets there, and every
// way to draw them against the others.
#include "pipeline/polygons/pipeline_zbuffer.h"

#include "geom/polygon_shapes.h"
#include "hard_edged.h"
#include "pipeline/any_model.h"
#include "pipeline/worlds/pipeline_world.h"
#include "pipeline/zsort/pipeline_zsort.h"
#include "raster/color/srgb_light.h"
#include "raster/rasterizer_factory.h"
#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "tool_2d/image.h"
#include "tool_2d/screen_memory.h"
#include "words_of.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <unistd.h>

namespace {

constexpr l3d_size window{133, 101};
constexpr l3d_size of_picture{16, 8};

/// The word of a pixel of the picture.
std::uint32_t picture_word(int x, int y) {
    return static_cast<std::uint32_t>((x * 16 + 8) << 16 | (y * 32 + 16) << 8 |
                                      ((x + y) % 2 != 0 ? 0xff : 0x20));
}

l3d_image picture() {
    l3d_image image(of_picture);
    for (int y = 0; y < of_picture.height; ++y)
        for (int x = 0; x < of_picture.width; ++x)
            image.pixels().row(y)[static_cast<std::size_t>(x)] = picture_word(x, y);
    return image;
}

std::vector<std::shared_ptr<const l3d_texture>> textures() {
    l3d_image image = picture();
    return {std::make_shared<const l3d_texture>(image.pixels())};
}

/// A sphere of which each face shows a part of the picture, and other numbers at each corner.
l3d_polygon_mesh sphere(std::uint32_t highlight = 0) {
    l3d_polygon_mesh mesh = l3d_sphere_mesh(16, 8);
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
        const auto& v = mesh.vertices[mesh.corners[i]];
        mesh.picture_places.push_back(
            {static_cast<float>(v[0] + 0.3 * v[1]), static_cast<float>(v[1] - 0.2 * v[2])});
    }
    mesh.face_materials.assign(mesh.faces(), 0);
    mesh.materials = {"a"};
    mesh.looks = {{.highlight = highlight, .picture = 0}};
    mesh.pictures = {{"a.png"}};
    return mesh;
}

l3d_polygon_model textured_sphere(std::uint32_t highlight = 0) {
    return l3d_polygon_model(sphere(highlight)).textured(textures());
}

/// Colours as they are, whatever the light: levels are 255.
l3d_polygon_settings plainly(l3d_texture_filter filter = l3d_texture_filter::nearest) {
    l3d_polygon_settings settings = hard_edged_polygons();
    settings.shade = l3d_shade::lambert;
    settings.lighting.ambient = {1, 1, 1};
    settings.lighting.color = {0, 0, 0};
    settings.textures = filter;
    return settings;
}

/// The usual light, whose levels are multiplied by colours.
l3d_polygon_settings by_levels(l3d_texture_filter filter = l3d_texture_filter::nearest) {
    l3d_polygon_settings settings = plainly(filter);
    settings.lighting = {};
    return settings;
}

l3d_camera camera() {
    l3d_camera result;
    result.eye = {1.2, 0.9, 1.7};
    return result;
}

template <class Pipeline = l3d_pipeline_zbuffer, class... More>
std::vector<std::uint32_t> drawn(const l3d_polygon_model& model,
                                 const l3d_polygon_settings& settings, const More&... more) {
    Pipeline pipeline(l3d_memory_canvas(window), model, camera(), settings, more...);
    pipeline.draw_event();
    return words_of(pipeline.screen().pixels());
}

/// How many pixels differ by more than so many levels in a channel.
std::size_t differing(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b,
                      int levels = 0) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (const int shift : {0, 8, 16})
            if (std::abs(static_cast<int>(a[i] >> shift & 255) -
                         static_cast<int>(b[i] >> shift & 255)) > levels) {
                ++count;
                break;
            }
    return count;
}

/// Rasterizers that fill pixel by pixel, as the slow twin does.
class scalar_factory : public l3d_rasterizer_factory {
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override {
        return l3d_rasterizer_factory_sw().create_2d(target);
    }
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers&) const override {
        return std::make_unique<l3d_surface_rasterizer_scalar>();
    }
};

/// The picture's pixel at the place that a pick finds; none where it is too near to the next.
TEST(textured_polygons, show_the_pixel_of_the_picture_that_a_pick_finds) {
    for (const l3d_projection projection :
         {l3d_projection::perspective, l3d_projection::parallel}) {
        const l3d_polygon_model model = textured_sphere();
        l3d_polygon_settings settings = plainly();
        l3d_camera from = camera();
        from.projection = projection;
        settings.rotation = {20, 30, 40};
        l3d_pipeline_zbuffer pipeline(l3d_memory_canvas(window), model, from, settings);
        pipeline.draw_event();
        const auto words = words_of(pipeline.screen().pixels());
        int judged = 0, off = 0;
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x) {
                const auto at = pipeline.pick(x + 0.5, y + 0.5);
                if (!at)
                    continue;
                std::array<double, 2> place{};
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto& v = model.mesh().vertices[at->corners[k]];
                    place[0] += at->weights[k] * (v[0] + 0.3 * v[1]) * of_picture.width;
                    place[1] += at->weights[k] * (v[1] - 0.2 * v[2]) * of_picture.height;
                }
                constexpr double apart = 1e-3;
                if (std::abs(place[0] - std::round(place[0])) < apart ||
                    std::abs(place[1] - std::round(place[1])) < apart)
                    continue;
                const auto wrapped = [](double p, int size) {
                    return ((static_cast<int>(std::floor(p)) % size) + size) % size;
                };
                ++judged;
                off += words[static_cast<std::size_t>(y * window.width + x)] !=
                       picture_word(wrapped(place[0], of_picture.width),
                                    wrapped(place[1], of_picture.height));
            }
        EXPECT_GT(judged, 3000);
        // Corners lie on sub-pixels, so that sides, and what is in front there, may be a pixel off.
        EXPECT_LE(off, judged / 100);
    }
}

/// A quadrangle through the near plane: what is left of its triangles shows their own planes.
TEST(textured_polygons, are_exact_where_the_near_plane_cuts_them) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{-3, 0, 9}, {3, 0, 9}, {3, 0, -9}, {-3, 0, -9}};
    mesh.add_face({{0, 1, 2, 3}});
    mesh.picture_places = {{0, 3}, {1, 3}, {1, 0}, {0, 0}};
    mesh.face_materials = {0};
    mesh.materials = {"a"};
    mesh.looks = {{.picture = 0}};
    mesh.pictures = {{"a.png"}};
    const l3d_polygon_model model = l3d_polygon_model(mesh).textured(textures());
    l3d_pipeline_zbuffer pipeline(l3d_memory_canvas(window), model, camera(), plainly());
    pipeline.draw_event();
    const auto words = words_of(pipeline.screen().pixels());
    int judged = 0, off = 0;
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x)
            if (const auto at = pipeline.pick(x + 0.5, y + 0.5)) {
                const double u = (at->point[0] + 3) / 6 * of_picture.width;
                const double v = (at->point[2] + 9) / 6 * of_picture.height;
                if (std::abs(u - std::round(u)) < 1e-4 || std::abs(v - std::round(v)) < 1e-4)
                    continue;
                ++judged;
                off += words[static_cast<std::size_t>(y * window.width + x)] !=
                       picture_word(static_cast<int>(u), static_cast<int>(v) % of_picture.height);
            }
    EXPECT_GT(judged, 3000);
    EXPECT_LE(off, 20);
}

/// By levels, by normals in lanes, and by normals pixel by pixel; and with smooth edges.
TEST(textured_polygons, are_the_same_by_any_number_of_threads) {
    for (const std::uint32_t highlight : {0U, 0xffffffU})
        for (const bool antialias : {false, true}) {
            l3d_polygon_settings settings = by_levels(l3d_texture_filter::anisotropic);
            settings.antialias = antialias;
            settings.fog = {.from = 1, .to = 4, .color = 0x4060a0};
            const auto one = drawn(textured_sphere(highlight), settings);
            settings.threads = 5;
            EXPECT_EQ(one, drawn(textured_sphere(highlight), settings));
            settings.textures.reset();
            EXPECT_GT(differing(one, drawn(textured_sphere(highlight), settings), 20), 2000U);
        }
}

TEST(textured_polygons, are_the_same_by_all_rasterizers) {
    for (const std::uint32_t highlight : {0U, 0xffffffU})
        for (const l3d_shade shade : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat}) {
            const l3d_polygon_model model = textured_sphere(highlight);
            l3d_polygon_settings settings = by_levels(l3d_texture_filter::trilinear);
            settings.shade = shade;
            const auto fast = drawn(model, settings);
            EXPECT_EQ(differing(fast, drawn(model, settings, scalar_factory()), 1), 0U);
            EXPECT_LE(differing(fast, drawn<l3d_pipeline_zsort>(model, settings), 1), 5U); // ties
            EXPECT_EQ(differing(fast, drawn(model, settings, l3d_rasterizer_factory_mesa()), 1),
                      0U);
            settings.antialias = true;
            const auto smooth = drawn(model, settings);
            EXPECT_LE(differing(smooth, drawn<l3d_pipeline_zsort>(model, settings), 1), 5U);
            // All but edges is the same; flat faces have edges on all sides.
            EXPECT_LT(differing(fast, smooth), shade == l3d_shade::flat ? 1500U : 600U);
            EXPECT_GT(differing(fast, smooth), 50U);
        }
}

/// Where a frame draws no light there is nothing to colour, and a material from outside hides all.
TEST(textured_polygons, show_no_picture_where_none_is_asked_for) {
    l3d_polygon_mesh plain = sphere();
    plain.looks[0].picture = l3d_material::no_picture;
    l3d_polygon_settings settings = by_levels();
    settings.shade = l3d_shade::normals;
    EXPECT_EQ(drawn(textured_sphere(), settings), drawn(l3d_polygon_model(plain), settings));
    settings = by_levels();
    settings.material = l3d_material{.color = 0xc06020};
    EXPECT_EQ(drawn(textured_sphere(), settings), drawn(l3d_polygon_model(plain), settings));
    settings = by_levels();
    const auto without = drawn(l3d_polygon_model(plain), settings);
    EXPECT_EQ(drawn(l3d_polygon_model(sphere()), settings), without) << "nobody read the picture";
    settings.textures.reset();
    EXPECT_EQ(drawn(textured_sphere(), settings), without);
}

/// A part that is painted loses its picture and its vertices' colours; hidden ones leave the others
/// as they are.
TEST(textured_polygons, keep_their_pictures_when_parts_change) {
    l3d_polygon_mesh mesh = sphere();
    const auto half = static_cast<std::uint32_t>(mesh.faces() / 2);
    mesh.parts = {{"upper", 0}, {"lower", half}};
    mesh.vertex_colors.assign(mesh.vertices.size(), 0x80ff40);
    const l3d_polygon_model model = l3d_polygon_model(mesh).textured(textures());
    const l3d_polygon_model painted = model.part_painted(1, {.color = 0xff0000});
    const l3d_polygon_model one = model.without(std::array<std::size_t, 1>{1});
    ASSERT_EQ(one.painted().size(), one.triangles().size());
    const auto both = drawn(model, plainly()), red = drawn(painted, plainly()),
               alone = drawn(one, plainly());
    std::size_t kept = 0, turned = 0;
    for (std::size_t i = 0; i < both.size(); ++i) {
        kept += both[i] != 0 && red[i] == both[i];
        turned += red[i] == 0xff0000;
        EXPECT_TRUE(red[i] == both[i] || red[i] == 0xff0000);
        EXPECT_TRUE(alone[i] == 0 || alone[i] == red[i] || red[i] == 0xff0000);
    }
    EXPECT_GT(kept, 500U);
    EXPECT_GT(turned, 500U);
}

/// Between corners, light is linear in the triangle's plane.
TEST(textured_polygons, blend_the_colours_of_vertices) {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{-1, -1, 0.5}, {1, -1, -2}, {0, 1, 0}};
    mesh.add_face({{0, 1, 2}});
    mesh.vertex_colors = {0xff0000, 0x00ff00, 0x0000ff};
    l3d_pipeline_zbuffer pipeline(l3d_memory_canvas(window), l3d_polygon_model(mesh), camera(),
                                  plainly());
    pipeline.draw_event();
    const auto words = words_of(pipeline.screen().pixels());
    int judged = 0;
    for (int y = 0; y < window.height; ++y)
        for (int x = 0; x < window.width; ++x) {
            const auto at = pipeline.pick(x + 0.5, y + 0.5);
            const std::uint32_t word = words[static_cast<std::size_t>(y * window.width + x)];
            if (!at || word == 0)
                continue;
            ++judged;
            for (std::size_t k = 0; k < 3; ++k) // corner k alone has channel k
                EXPECT_NEAR(double(word >> (16 - 8 * k) & 255), l3d_level_of_light(at->weights[k]),
                            1)
                    << x << ' ' << y;
        }
    EXPECT_GT(judged, 300);
}

/// Those that are scaled become models of their own, with the same pictures.
TEST(textured_polygons, are_drawn_in_worlds) {
    const auto of_world = [](const l3d_matrix<l3d_real>& shape, const l3d_polygon_mesh& mesh) {
        l3d_world world(window);
        world.surfaces = plainly();
        world.camera.place = l3d_point<l3d_real>::of(0, 0, -2);
        world.camera.near_z = 0.5;
        for (const int x : {-1, 1}) {
            auto object = std::make_unique<l3d_object>();
            object->set_mesh(mesh, textures());
            object->set_transform(0, shape);
            object->set_transform(1, l3d_translation<l3d_real>(0.6 * x, 0, 0));
            world.add(std::move(object));
        }
        l3d_pipeline_world pipeline(l3d_memory_canvas(window), world);
        pipeline.draw_event();
        return words_of(pipeline.screen().pixels());
    };
    l3d_polygon_mesh half = sphere();
    for (auto& v : half.vertices)
        v *= 0.5;
    const auto small = of_world(l3d_identity<l3d_real>(), half);
    EXPECT_LT(differing(small, of_world(l3d_scaling<l3d_real>(0.5, 0.5, 0.5), sphere())), 20U);
    std::size_t shown = 0;
    for (const std::uint32_t word : small)
        shown += word != 0 && word != 0xffffff;
    EXPECT_GT(shown, 1000U);
    half.looks[0].picture = l3d_material::no_picture;
    EXPECT_GT(differing(small, of_world(l3d_identity<l3d_real>(), half)), 1000U);
}

/// A folder with a model of one square, of a material of which the test says more.
class textured_file : public testing::Test {
protected:
    textured_file() : folder_(testing::TempDir() + "textured_" + std::to_string(getpid())) {
        std::filesystem::create_directories(folder_ / "more");
        std::ofstream(folder_ / "a.obj")
            << "mtllib more/a.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
               "vt 0 1\nusemtl a\nf 1/1 2/2 3/3 4/4\n";
    }
    ~textured_file() override { std::filesystem::remove_all(folder_); }

    std::string file(const std::string& name) const { return (folder_ / name).string(); }

    /// What is said of the pictures of a model whose material has this line.
    std::vector<std::string> notes_of(const std::string& line) const {
        std::ofstream(file("more/a.mtl")) << "newmtl a\n" << line << '\n';
        return notes_of_model();
    }
    std::vector<std::string> notes_of_model() const {
        std::vector<std::string> notes;
        const l3d_any_model model = l3d_load_any_model(file("a.obj"), &notes);
        EXPECT_EQ(std::get<l3d_polygon_model>(model).mesh().faces(), 1U);
        return notes;
    }

private:
    std::filesystem::path folder_;
};

/// Its top left corner is where v is 1.
TEST_F(textured_file, shows_the_picture_beside_its_file_of_materials) {
    l3d_image image = picture();
    for (const std::string name : {"my wood.png", "b.ppm"}) {
        l3d_write_image(file("more/" + name), image.pixels());
        EXPECT_TRUE(notes_of("map_Kd -clamp on " + name).empty());
        const l3d_polygon_model model = l3d_polygon_model::load(file("a.obj"));
        l3d_camera eye;
        eye.eye = {0, 0, 3};
        l3d_pipeline_zbuffer pipeline(l3d_memory_canvas(window), model, eye, plainly());
        pipeline.draw_event();
        const auto words = words_of(pipeline.screen().pixels());
        const auto seen = std::ranges::find_if(words, [](std::uint32_t w) { return w != 0; });
        ASSERT_NE(seen, words.end());
        EXPECT_EQ(*seen, picture_word(0, 0));
        EXPECT_EQ(
            *std::find_if(words.rbegin(), words.rend(), [](std::uint32_t w) { return w != 0; }),
            picture_word(of_picture.width - 1, of_picture.height - 1));
    }
}

TEST_F(textured_file, shows_the_picture_that_a_comment_of_a_ply_names) {
    l3d_image image = picture();
    l3d_write_image(file("more/b.ppm"), image.pixels());
    EXPECT_TRUE(notes_of("map_Kd b.ppm").empty());
    std::ofstream(file("a.ply"))
        << "ply\nformat ascii 1.0\ncomment TextureFile more/b.ppm\nelement vertex 4\n"
           "property float x\nproperty float y\nproperty float z\nproperty float u\n"
           "property float v\nelement face 1\nproperty list uchar int vertex_indices\n"
           "end_header\n-1 -1 0 0 0\n1 -1 0 1 0\n1 1 0 1 1\n-1 1 0 0 1\n4 0 1 2 3\n";
    const auto words = drawn(l3d_polygon_model::load(file("a.ply")), plainly());
    EXPECT_EQ(words, drawn(l3d_polygon_model::load(file("a.obj")), plainly()));
    EXPECT_GT(std::set(words.begin(), words.end()).size(), 20U) << "of the picture's 128";
}

TEST_F(textured_file, is_drawn_without_a_picture_that_is_missing_or_broken) {
    const std::string rest = "; its faces have the colours of their materials";
    const auto only_note = [&](const std::string& line) {
        const auto notes = notes_of(line);
        return notes.size() == 1 ? notes[0] : std::to_string(notes.size());
    };
    const std::string missing = only_note("map_Kd none.png");
    EXPECT_EQ(missing.find(file("more/none.png")), 0U) << missing;
    EXPECT_TRUE(missing.ends_with(rest)) << missing;
    std::ofstream(file("more/text.png")) << "no picture";
    EXPECT_EQ(only_note("map_Kd text.png"),
              file("more/text.png") + ": neither PNG nor JPEG nor binary PPM" + rest);
    std::ofstream(file("more/huge.ppm")) << "P6 100000 100000 255\n";
    EXPECT_EQ(only_note("map_Kd huge.ppm"),
              file("more/huge.ppm") + ": 100000 by 100000 pixels are more than 67108864" + rest);
    l3d_image image = picture();
    l3d_write_image(file("more/cut.png"), image.pixels());
    std::filesystem::resize_file(file("more/cut.png"), 60);
    const std::string cut = only_note("map_Kd cut.png");
    EXPECT_EQ(cut.find(file("more/cut.png") + ": "), 0U) << cut;
    EXPECT_TRUE(cut.ends_with(rest)) << cut;
}

} // namespace
