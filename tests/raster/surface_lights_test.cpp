// SPDX-License-Identifier: MIT
// Several lights and highlights: Blinn's rule evaluated in doubles, and the twins against each
// other.
#include "base/error.h"
#include "raster/lighting.h"
#include "raster/parallel/simd_target.h"
#include "raster/shaders/lit_words_p.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;
using place = std::array<double, 3>;

double dot_of(const place& a, const place& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

place unit_of(const place& v) {
    const double length = std::sqrt(dot_of(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

place wide(const std::array<float, 3>& v) {
    return {double{v[0]}, double{v[1]}, double{v[2]}};
}

/// A channel by the rule that l3d_lighting states, of what lies at a place.
/// Expects: a unit normal, turned to the eye.
double channel(const l3d_shading& shading, const l3d_material& material, const place& normal,
               const place& to_eye, const place& at, std::size_t i) {
    const int shift = 16 - 8 * static_cast<int>(i);
    double scattered = double{shading.lighting.ambient[i]}, mirrored = 0;
    const auto add = [&](const place& to_light, double brightness) {
        const double lit = dot_of(normal, to_light);
        if (lit <= 0)
            return;
        const place half =
            unit_of({to_light[0] + to_eye[0], to_light[1] + to_eye[1], to_light[2] + to_eye[2]});
        scattered += 0.9 * brightness * lit;
        mirrored += brightness * std::pow(std::max(0.0, dot_of(normal, half)), material.sharpness);
    };
    add(wide(shading.light), double{shading.lighting.color[i]});
    for (std::size_t k = 0; k < shading.lighting.count; ++k)
        add(wide(shading.lighting.lights[k].direction),
            double{shading.lighting.lights[k].color[i]});
    for (std::size_t k = 0; k < shading.lighting.point_count; ++k) {
        const l3d_point_light& light = shading.lighting.points[k];
        const place way{light.position[0] - at[0], light.position[1] - at[1],
                        light.position[2] - at[2]};
        const double reach = double{light.reach};
        add(unit_of(way),
            double{light.color[i]} * (reach > 0 ? reach * reach / dot_of(way, way) : 1));
    }
    return std::clamp((material.color >> shift & 255) * scattered +
                          (material.highlight >> shift & 255) * mirrored,
                      0.0, 255.0);
}

l3d_shading with_lights(l3d_shade mode = l3d_shade::lambert) {
    l3d_shading shading = scene_shading(mode);
    shading.look = {-0.3F, 0.2F, -1};
    shading.look_right = {0.003F, 0, 0};
    shading.look_down = {0, -0.002F, 0.001F};
    shading.lighting.color = {1, 0.8F, 0.5F};
    shading.lighting.ambient = {0.05F, 0.1F, 0.2F};
    shading.lighting.add({-3, 1, 2}, {0.2F, 0.3F, 1});
    shading.lighting.add({0.1, -1, 0.5}, {0.6F, 0, 0});
    return shading;
}

/// Two of them at places, in perspective or in a parallel projection.
l3d_shading with_points(bool parallel, l3d_shade mode = l3d_shade::lambert) {
    l3d_shading shading = with_lights(mode);
    shading.eye = {1, 2, 3};
    shading.look_depth = 1;
    if (parallel) {
        shading.look_right = shading.look_down = {};
        shading.aside = {-1, 1, 0};
        shading.aside_right = {0.01F, 0, 0};
        shading.aside_down = {0, -0.02F, 0};
        shading.depth_base = 2.5;
        shading.depth_step = -0.5;
    }
    shading.lighting.add_point({{0.5, 2.5, 2}, 0.9F, {0.9F, 0.7F, 0.3F}});
    shading.lighting.add_point({{2, 1, 4}, 0, {0.1F, 0.2F, 0.4F}});
    return shading;
}

const std::vector<l3d_material> shining{
    {.color = 0xc04020, .highlight = 0xffffff, .sharpness = 20},
    {.color = 0x2060c0, .highlight = 0x806020, .sharpness = 300},
    {.color = 0x808080}};

surface_parts painted_scene(unsigned seed, int sheets) {
    surface_parts parts = random_scene(seed, scene_size, sheets);
    std::uint32_t next = 0;
    for (l3d_surface_part& part : parts)
        part.material = next++ % 3;
    return parts;
}

void draw_in(surface_picture& picture, const surface_parts& scene, const l3d_shading& shading,
             bool with_depth = true) {
    picture.rasterizer.use_materials(shining);
    picture.rasterizer.begin(picture.pixels(), with_depth ? &picture.depth : nullptr, shading);
    picture.rasterizer.draw(pointers(scene));
    picture.rasterizer.finish();
}

/// Compares words of random normals, ways and depths with the rule.
void expect_blinns_rule(const l3d_shading& shading) {
    random_polygons random(scene_seed, scene_size);
    const bool parallel = shading.depth_step != 0;
    int bright = 0;
    for (int n = 0; n < 20'000; ++n) {
        const std::uint32_t material = static_cast<std::uint32_t>(n % 3);
        lit_shader shader(shading, shining);
        shader.use_material(material);
        const place raw{random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)};
        const place away{random.real(-1, 1), random.real(-1, 1), random.real(-1, -0.1F)};
        const double depth = random.real(0.5F, 2);
        const float at[lit_shader::components] = {float(raw[0]),  float(raw[1]),  float(raw[2]),
                                                  float(away[0]), float(away[1]), float(away[2]),
                                                  float(depth)};
        const place look = parallel ? wide(shading.look) : away;
        place normal = unit_of(raw);
        if (dot_of(raw, look) > 0)
            normal = {-normal[0], -normal[1], -normal[2]};
        const place to_eye = unit_of({-look[0], -look[1], -look[2]});
        const double distance =
            parallel ? (depth - shading.depth_base) / shading.depth_step : 1 / depth;
        place there = shading.eye;
        for (std::size_t i = 0; i < 3; ++i)
            there[i] += look[i] * distance + (parallel ? away[i] : 0);
        const std::uint32_t word = shader.word(at);
        for (std::size_t i = 0; i < 3; ++i) {
            const double exact = channel(shading, shining[material], normal, to_eye, there, i);
            ASSERT_NEAR(word >> (16 - 8 * static_cast<int>(i)) & 255, exact, 0.51) << n;
            bright += exact > 200;
        }
    }
    EXPECT_GT(bright, 100);
}

TEST(surface_lights, are_as_blinns_rule_says) {
    expect_blinns_rule(with_lights());
}

TEST(surface_lights, at_places_are_as_blinns_rule_says) {
    expect_blinns_rule(with_points(false));
    expect_blinns_rule(with_points(true));
}

TEST(surface_lights, of_one_white_light_and_no_highlights_are_the_greys_of_before) {
    l3d_shading usual = scene_shading(l3d_shade::lambert), same = usual;
    same.lighting.add({0, 0, 1}, {0, 0, 0});
    EXPECT_FALSE(usual.is_lit({}));
    EXPECT_TRUE(usual.is_lit(shining));
    EXPECT_TRUE(same.is_lit({}));
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::flat}) {
        usual.mode = same.mode = mode;
        surface_picture one(scene_size.width, scene_size.height),
            other(scene_size.width, scene_size.height);
        const surface_parts scene = random_scene(scene_seed, scene_size, 30);
        one.begin(usual);
        draw_part(one.rasterizer, scene[0]);
        one.rasterizer.finish();
        other.begin(same);
        draw_part(other.rasterizer, scene[0]);
        other.rasterizer.finish();
        for (int y = 0; y < scene_size.height; ++y)
            for (int x = 0; x < scene_size.width; ++x)
                ASSERT_NEAR(one.word(x, y) & 255, other.word(x, y) & 255, 1);
    }
}

TEST(surface_lights, have_the_same_bits_for_all_threads_bands_and_instructions) {
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::flat})
        for (const bool antialias : {false, true}) {
            l3d_shading shading = with_points(false, mode);
            shading.antialias = antialias;
            const surface_parts scene = painted_scene(scene_seed + 9, 30);
            surface_picture one(scene_size.width, scene_size.height, 1);
            draw_in(one, scene, shading);
            for (const std::string& name : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(name));
                surface_picture other(scene_size.width, scene_size.height, 2, {24});
                draw_in(other, scene, shading, antialias);
                EXPECT_EQ(other.words, one.words) << name << int(mode) << antialias;
            }
            l3d_set_simd_target("");
        }
}

TEST(surface_lights, are_the_slow_twins) {
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat}) {
        const surface_parts scene = painted_scene(scene_seed + 2, 30);
        surface_picture fast(scene_size.width, scene_size.height, 2),
            slow(scene_size.width, scene_size.height);
        draw_in(fast, scene, with_points(false, mode));
        draw_in(slow, scene, with_points(false, mode));
        int other = 0;
        for (int y = 0; y < scene_size.height; ++y)
            for (int x = 0; x < scene_size.width; ++x) {
                int most = 0;
                for (int shift = 0; shift < 24; shift += 8)
                    most = std::max(most, std::abs(int(fast.word(x, y) >> shift & 255) -
                                                   int(slow.word(x, y) >> shift & 255)));
                other += most > 1;
            }
        // Where two sheets meet, a difference in the last bits decides which is seen.
        EXPECT_LE(other, scene_size.width * scene_size.height / 1000) << int(mode);
    }
}

/// Random normals of random materials, some pixels of which are empty.
struct coded_pixels {
    static constexpr int width = 61, height = 40, pitch = 70;
    std::vector<std::uint32_t> words, normals;
    std::vector<float> depths;

    explicit coded_pixels(unsigned seed, std::uint32_t materials)
        : words(pitch * height), normals(pitch * height), depths(pitch * height) {
        random_polygons random(seed, scene_size);
        std::uint32_t material = 0;
        for (std::size_t i = 0; i < words.size(); ++i) {
            if (random.real(0, 1) < 0.1F)
                material = static_cast<std::uint32_t>(random.real(0, float(materials) - 0.01F));
            const std::array<float, 3> normal{random.real(-1, 1), random.real(-1, 1),
                                              i % 97 == 0 ? 0 : random.real(-1, 1)};
            const normal_code code = normal_code::of(normal.data());
            words[i] = code.z | material;
            normals[i] = code.xy;
            depths[i] = random.real(-1, 4) > 0 ? random.real(0.3F, 2) : 0.0F;
        }
    }
    lit_pixels pixels() {
        return {words.data(), pitch, depths.data(), normals.data(), pitch, 7, 3, width, height};
    }
};

TEST(surface_lights, in_lanes_are_lit_shaders_bits) {
    l3d_shading turned = with_lights();
    turned.ray = turned.ray_right = turned.ray_down = {};
    for (const l3d_shading& shading :
         {with_lights(), turned, with_points(false), with_points(true)})
        for (const auto materials :
             {std::span<const l3d_material>(shining), std::span<const l3d_material>()}) {
            lit_words lights;
            lights.begin(shading, materials);
            const auto kinds =
                static_cast<std::uint32_t>(std::max<std::size_t>(1, materials.size()));
            coded_pixels slow(scene_seed, kinds);
            lights.color_slowly(slow.pixels());
            EXPECT_GT(
                std::ranges::count_if(slow.words, [](auto w) { return (w >> 8 & 255) > 200; }), 2);
            for (const std::string& name : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(name));
                coded_pixels fast(scene_seed, kinds);
                lights.color(fast.pixels());
                EXPECT_EQ(fast.words, slow.words) << name << kinds;
            }
            l3d_set_simd_target("");
        }
}

TEST(surface_lights, codes_keep_normals_to_a_ten_thousandth) {
    random_polygons random(scene_seed, scene_size);
    for (int n = 0; n < 10'000; ++n) {
        const place raw = unit_of({random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
        const std::array<float, 3> normal{float(raw[0]), float(raw[1]), float(raw[2])};
        normal_code code = normal_code::of(normal.data());
        code.z |= static_cast<std::uint32_t>(n);
        const auto coded = code.scaled();
        for (std::size_t i = 0; i < 3; ++i)
            ASSERT_NEAR(coded[i] / normal_code::scale, normal[i], 0.501F / normal_code::scale);
    }
}

TEST(lighting, refuses_more_lights_than_it_has_room_for) {
    l3d_lighting lighting;
    for (std::size_t i = 0; i < l3d_lighting::most_further; ++i)
        lighting.add({0.0, 1.0, 0.0}, {1, 1, 1});
    EXPECT_THROW(lighting.add({0.0, 1.0, 0.0}, {1, 1, 1}), l3d_error);
    for (std::size_t i = 0; i < l3d_lighting::most_points; ++i)
        lighting.add_point({});
    EXPECT_THROW(lighting.add_point({}), l3d_error);
}

} // namespace
