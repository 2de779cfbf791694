// SPDX-License-Identifier: MIT
// Surfaces in colour: the greys of before, each times its material's colour.
#include "raster/parallel/simd_target.h"
#include "raster/shaders/material_words_p.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace l3d_detail;

constexpr std::array light_modes{l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat,
                                 l3d_shade::levels};

/// Colours from which a pixel's material and level can be told.
const std::vector<l3d_material> telling{{.color = 0xff0000},
                                        {.color = 0x00ff00},
                                        {.color = 0x0000ff},
                                        {.color = 0xffff00},
                                        {.color = 0x00ffff},
                                        {.color = 0xff00ff},
                                        {}};

std::uint32_t level_of(std::uint32_t word) {
    return std::max({word >> 16 & 255, word >> 8 & 255, word & 255});
}

/// The place of a pixel's material among those; as many where there is only background.
std::size_t material_of(std::uint32_t word) {
    if (word == 0)
        return telling.size();
    for (std::size_t i = 0; i < telling.size(); ++i)
        if (word == l3d_product_of_colors(telling[i].color, 0x010101 * level_of(word)))
            return i;
    ADD_FAILURE() << std::hex << word;
    return telling.size();
}

/// Grids have a material each; every other part of triangles has one for each of them.
surface_parts painted_scene(unsigned seed, int sheets) {
    surface_parts parts = random_scene(seed, scene_size, sheets);
    const auto count = static_cast<std::uint32_t>(telling.size());
    std::uint32_t next = 0;
    for (l3d_surface_part& part : parts) {
        part.material = next++ % count;
        if (next % 2 == 0)
            for (std::size_t i = 0; i < part.triangles.count; ++i)
                part.triangles.materials.push_back(next++ % count);
    }
    return parts;
}

void draw_in(surface_picture& picture, const surface_parts& scene, const l3d_shading& shading,
             std::span<const l3d_material> materials, bool with_depth = true) {
    picture.rasterizer.use_materials(materials);
    picture.rasterizer.begin(picture.pixels(), with_depth ? &picture.depth : nullptr, shading);
    picture.rasterizer.draw(pointers(scene));
    picture.rasterizer.finish();
}

/// A picture by the product.
struct small : surface_picture {
    explicit small(int threads = 1, l3d_band_settings settings = {})
        : surface_picture(scene_size.width, scene_size.height, threads, settings) {}
};

TEST(surface_materials, multiply_encoded_levels_and_round) {
    for (std::uint32_t color = 0; color < 256; ++color)
        for (std::uint32_t level = 0; level < 256; ++level) {
            const double exact = color * level / 255.0;
            EXPECT_EQ(color_of_level(color, level), std::lround(exact)) << color << ' ' << level;
        }
    EXPECT_EQ(color_of_level(0x80ff01, 200), 0x64c801u);
}

TEST(surface_materials, are_the_same_by_every_instruction_set_as_pixel_by_pixel) {
    std::vector<l3d_material> materials;
    for (std::uint32_t i = 0; i < 256; ++i)
        materials.push_back({.color = i << 16 | (255 - i) << 8 | (i * 7 & 255)});
    material_words words;
    words.begin(materials);
    constexpr std::int32_t width = 261, height = 256, pitch = 263;
    for (const bool mixed : {false, true}) {
        std::vector<std::uint32_t> coded(pitch * height);
        std::vector<float> depths(coded.size());
        for (std::size_t i = 0; i < coded.size(); ++i) {
            coded[i] = static_cast<std::uint32_t>((mixed ? i * 31 & 255 : i / pitch) << 8 |
                                                  (i % pitch & 255));
            depths[i] = i % 11 < 8 ? 0.5f : 0;
        }
        std::vector<std::uint32_t> slow = coded;
        words.color_slowly({slow.data(), pitch, depths.data(), pitch, width, height});
        for (const std::string& name : l3d_simd_targets()) {
            ASSERT_TRUE(l3d_set_simd_target(name));
            std::vector<std::uint32_t> fast = coded;
            words.color({fast.data(), pitch, depths.data(), pitch, width, height});
            EXPECT_EQ(fast, slow) << name;
        }
        l3d_set_simd_target("");
        EXPECT_NE(slow, coded);
    }
}

TEST(surface_materials, that_are_white_change_no_bit) {
    const std::vector<l3d_material> white(telling.size());
    for (const l3d_shade mode : light_modes)
        for (const bool antialias : {false, true}) {
            l3d_shading shading = scene_shading(mode);
            shading.antialias = antialias;
            const surface_parts scene = painted_scene(scene_seed, 30);
            small plain, colored;
            draw_in(plain, scene, shading, {});
            draw_in(colored, scene, shading, white);
            EXPECT_EQ(colored.words, plain.words) << int(mode) << antialias;
        }
}

TEST(surface_materials, show_the_greys_of_before_times_a_color) {
    for (const l3d_shade mode : light_modes)
        for (unsigned n = 0; n < 6; ++n) {
            const surface_parts scene = painted_scene(scene_seed + n, 30);
            small plain, colored(2);
            surface_picture slow(scene_size.width, scene_size.height);
            draw_in(plain, scene, scene_shading(mode), {});
            draw_in(colored, scene, scene_shading(mode), telling);
            draw_in(slow, scene, scene_shading(mode), telling);
            int other = 0, filled = 0;
            for (int y = 0; y < scene_size.height; ++y)
                for (int x = 0; x < scene_size.width; ++x) {
                    ASSERT_EQ(level_of(colored.word(x, y)), plain.word(x, y) & 255);
                    const std::size_t material = material_of(colored.word(x, y));
                    other += material != material_of(slow.word(x, y));
                    filled += material < telling.size();
                }
            // Where two sheets meet, a difference in the last bits decides which is seen.
            EXPECT_LE(other, scene_size.width * scene_size.height / 1000) << int(mode);
            EXPECT_GT(filled, 1000);
            EXPECT_TRUE(colored.guards_intact());
        }
}

TEST(surface_materials, have_the_same_bits_for_all_threads_bands_and_instructions) {
    for (const l3d_shade mode : light_modes)
        for (const bool antialias : {false, true}) {
            l3d_shading shading = scene_shading(mode);
            shading.antialias = antialias;
            const surface_parts scene = painted_scene(scene_seed + 9, 40);
            small one;
            draw_in(one, scene, shading, telling);
            small without_depth(3, {16});
            draw_in(without_depth, scene, shading, telling, false);
            EXPECT_EQ(without_depth.words, one.words) << int(mode) << antialias;
            for (const std::string& name : l3d_simd_targets()) {
                ASSERT_TRUE(l3d_set_simd_target(name));
                small other(2, {24});
                draw_in(other, scene, shading, telling);
                EXPECT_EQ(other.words, one.words) << name << int(mode) << antialias;
            }
            l3d_set_simd_target("");
        }
}

TEST(surface_materials, may_come_in_several_draws_and_over_a_picture_of_before) {
    const surface_parts first = painted_scene(scene_seed + 3, 20),
                        second = painted_scene(scene_seed + 4, 20);
    surface_parts both = first;
    both.insert(both.end(), second.begin(), second.end());
    const l3d_shading shading = scene_shading(l3d_shade::lambert);
    surface_picture once(scene_size.width, scene_size.height);
    small twice(2);
    draw_in(once, both, shading, telling);
    for (int frame = 0; frame < 2; ++frame) {
        twice.rasterizer.use_materials(telling);
        twice.rasterizer.begin(twice.pixels(), &twice.depth, shading, frame > 0);
        twice.rasterizer.draw(pointers(first));
        twice.rasterizer.draw(pointers(second));
        twice.rasterizer.finish();
        int other = 0;
        for (int y = 0; y < scene_size.height; ++y)
            for (int x = 0; x < scene_size.width; ++x)
                other += material_of(once.word(x, y)) != material_of(twice.word(x, y));
        EXPECT_LE(other, scene_size.width * scene_size.height / 1000);
    }
}

TEST(surface_materials, of_a_part_of_a_picture_are_those_of_the_whole) {
    for (const bool antialias : {false, true})
        for (const l3d_pixel_box part :
             {l3d_pixel_box{17, 9, 18, 10}, l3d_pixel_box{40, 30, 150, 77}}) {
            l3d_shading shading = scene_shading(l3d_shade::lambert);
            shading.antialias = antialias;
            const surface_parts scene = painted_scene(scene_seed + 5, 40);
            small whole(2), some(2);
            draw_in(whole, scene, shading, telling);
            some.rasterizer.use_materials(telling);
            some.rasterizer.begin_part(some.pixels(), nullptr, shading, part);
            some.rasterizer.draw(pointers(scene));
            some.rasterizer.finish();
            for (int y = 0; y < scene_size.height; ++y)
                for (int x = 0; x < scene_size.width; ++x) {
                    const bool inside =
                        x >= part.left && x < part.right && y >= part.top && y < part.bottom;
                    ASSERT_EQ(some.word(x, y), inside ? whole.word(x, y) : surface_picture::noise);
                }
        }
}

TEST(surface_materials, do_not_color_what_is_no_light) {
    for (const l3d_shade mode : {l3d_shade::normals, l3d_shade::error}) {
        const surface_parts scene = painted_scene(scene_seed, 20);
        small plain, colored;
        draw_in(plain, scene, scene_shading(mode), {});
        draw_in(colored, scene, scene_shading(mode), telling);
        EXPECT_EQ(colored.words, plain.words);
    }
}

} // namespace
