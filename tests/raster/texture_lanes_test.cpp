// SPDX-License-Identifier: MIT
// Textures in lanes beside their slow twin, place by place, and the levels of light.
#include "raster/slow_texture.h"

#include "raster/color/linear_light_p.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <memory>
#include <random>
#include <utility>

namespace {

using l3d_detail::painted_pixels;

/// A picture of an odd size, each pixel of another colour.
l3d_texture texture(l3d_texture_wrap wrap_u, l3d_texture_wrap wrap_v) {
    std::mt19937 random(3);
    l3d_image image({37, 20}, 37);
    for (int y = 0; y < 20; ++y)
        for (std::uint32_t& word : image.pixels().row(y))
            word = random() & 0xffffff;
    return l3d_texture(image.pixels(), wrap_u, wrap_v);
}

TEST(texture_lanes, look_up_what_places_one_by_one_do) {
    using w = l3d_texture_wrap;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-3, 3), exponent(-9, 3), sign(-1, 1);
    for (const auto& [wrap_u, wrap_v] :
         {std::pair{w::repeat, w::clamp}, std::pair{w::clamp, w::mirror},
          std::pair{w::mirror, w::repeat}}) {
        const l3d_texture of = texture(wrap_u, wrap_v);
        const slow_texture slow(of);
        for (const auto& [name, filter] : l3d_texture_filter_names)
            for (const std::size_t count : {std::size_t{1}, std::size_t{17}, std::size_t{64}}) {
                const auto pixels = std::make_unique<painted_pixels>();
                for (std::size_t i = 0; i < painted_pixels::room; ++i) {
                    const auto way = [&] { return sign(random) * std::exp2(exponent(random)); };
                    pixels->u[i] = place(random);
                    pixels->v[i] = place(random);
                    pixels->u_right[i] = way();
                    pixels->v_right[i] = way();
                    pixels->u_down[i] = i % 5 == 0 ? 0 : way();
                    pixels->v_down[i] = i % 5 == 0 ? 0 : way();
                    for (auto& channel : pixels->light)
                        channel[i] = 0.5F;
                }
                light_by_texture(of.view(), filter, {0, count}, *pixels);
                int off = 0;
                for (std::size_t i = 0; i < count; ++i) {
                    const auto light =
                        slow.seen(filter, {double{pixels->u[i]}, double{pixels->v[i]},
                                           double{pixels->u_right[i]}, double{pixels->v_right[i]},
                                           double{pixels->u_down[i]}, double{pixels->v_down[i]}});
                    for (std::size_t c = 0; c < 3; ++c)
                        off += !(std::abs(double{pixels->light[c][i]} - 0.5 * light[c]) < 5e-4);
                }
                // One sample more or less, or the next pixel, where floats round across a border.
                EXPECT_LE(off, static_cast<int>(count) / 16) << name << ' ' << count;
            }
    }
}

TEST(texture_lanes, find_the_nearest_levels) {
    const auto& tables = l3d_detail::linear_light_tables();
    std::mt19937 random(5);
    std::uniform_real_distribution<float> light(-0.1F, 1.1F), dark(0, 0.01F);
    for (int round = 0; round < 100; ++round) {
        const auto pixels = std::make_unique<painted_pixels>();
        for (std::size_t i = 0; i < painted_pixels::room; ++i) {
            pixels->light[0][i] = light(random);
            pixels->light[1][i] = dark(random);
            pixels->light[2][i] = light(random);
        }
        encode_light({0, painted_pixels::most}, *pixels);
        for (std::size_t i = 0; i < painted_pixels::most; ++i)
            ASSERT_EQ(pixels->words[i], tables.level(pixels->light[0][i]) << 16 |
                                            tables.level(pixels->light[1][i]) << 8 |
                                            tables.level(pixels->light[2][i]));
    }
}

} // namespace
