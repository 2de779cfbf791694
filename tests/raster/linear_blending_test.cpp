// SPDX-License-Identifier: MIT
// Mixing in linear light: each level, share and gap against the curve in long double.
#include "raster/canvas_2d.h"
#include "raster/paths/gradient.h"
#include "raster/paths/path.h"
#include "raster/color/color_mixer_p.h"
#include "raster/slow_light.h"

#include <array>
#include <random>
#include <vector>

namespace {

using l3d_detail::color_mixer;

/// The amounts where levels begin, and those of levels.
struct exact_curve {
    std::array<long double, 257> begins;
    std::array<long double, 256> amounts;
    exact_curve() {
        for (std::size_t i = 0; i < 256; ++i) {
            const auto level = static_cast<long double>(i);
            begins[i] = i == 0 ? -1 : slow_light::amount(l3d_blending::linear, level - 0.5L);
            amounts[i] = slow_light::amount(l3d_blending::linear, level);
        }
        begins[256] = 2;
    }
};

TEST(linear_blending, has_the_nearest_level_of_every_mix_of_two_levels) {
    const exact_curve curve;
    const color_mixer mixer(l3d_blending::linear);
    for (unsigned from = 0; from < 256; ++from)
        for (unsigned to = 0; to < 256; to += 3) {
            const std::array<unsigned, 3> targets{to, std::min(to + 1, 255u),
                                                  std::min(to + 2, 255u)};
            const auto color = mixer.color(targets[0] << 16 | targets[1] << 8 | targets[2]);
            for (int share = 0; share <= 255; ++share) {
                const std::uint32_t word = mixer.over(from * 0x010101, color, share / 255.0);
                for (std::size_t k = 0; k < 3; ++k) {
                    const long double amount =
                        (curve.amounts[from] * (255 - share) + curve.amounts[targets[k]] * share) /
                        255;
                    const auto level = static_cast<std::size_t>(
                        slow_light::channel(word, 16 - 8 * static_cast<int>(k)));
                    ASSERT_TRUE(amount >= curve.begins[level] && amount <= curve.begins[level + 1])
                        << from << " to " << targets[k] << " by " << share << ": " << level;
                }
            }
        }
}

/// Half white and half black is 188, not 128.
TEST(linear_blending, half_of_white_over_black_is_half_of_the_light) {
    canvas c(4, 3);
    l3d_path left_half;
    left_half.add_polygon(std::array<l3d_point_2d, 4>{{{-1, -1}, {2, -1}, {2, 4}, {-1, 4}}});
    c.draw.draw_path(left_half, {.color = 0x00ffffff, .blending = l3d_blending::linear});
    EXPECT_EQ(c.at(1, 1), 0x00ffffffu);
    EXPECT_EQ(c.at(2, 1), 0x00bcbcbcu); // 128 of 255: 0.502 of the light
    EXPECT_EQ(c.at(3, 1), 0u);
}

/// The same shares as in coded values, which a white path on black shows; other mixes.
TEST(linear_blending, of_paths_and_gradients_mixes_by_the_same_shares) {
    constexpr int width = 40, height = 30;
    std::mt19937 random(9);
    for (int n = 0; n < 60; ++n) {
        const auto place = [&] {
            return l3d_point_2d{double(random() % 4000) / 100, double(random() % 3000) / 100};
        };
        l3d_path path, clip;
        path.move_to(place());
        path.cubic_to(place(), place(), place());
        clip.add_circle(place(), 15);
        const std::array<l3d_color_stop, 2> stops{{{0, 0x00ff8020}, {1, 0x000040ff}}};
        const auto gradient = l3d_gradient::linear({0, 0}, {30, 20}, stops);
        l3d_fill fill{.color = static_cast<std::uint32_t>(random()) & 0x00ffffff,
                      .gradient = n % 3 == 0 ? &gradient : nullptr,
                      .alpha = n % 2 == 0 ? 1 : 0.6,
                      .clip = n % 4 == 0 ? &clip : nullptr,
                      .blending = l3d_blending::linear};
        canvas shares(width, height), mixed(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                mixed.at(x, y) = static_cast<std::uint32_t>(random()) & 0x00ffffff;
        std::vector<std::uint32_t> before;
        for (int i = 0; i < width * height; ++i)
            before.push_back(mixed.at(i % width, i / width));
        shares.draw.draw_path(path, {.color = 0x00ffffff, .alpha = fill.alpha, .clip = fill.clip});
        mixed.draw.draw_path(path, fill);
        ASSERT_TRUE(mixed.guards_intact());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                std::uint32_t color = fill.color;
                if (fill.gradient != nullptr)
                    gradient.colors(x, y, {&color, 1});
                const long double share = static_cast<int>(shares.at(x, y) & 255) / 255.0L;
                for (const int shift : {0, 8, 16}) {
                    const auto amount = [&](std::uint32_t word) {
                        return slow_light::amount(l3d_blending::linear,
                                                  slow_light::channel(word, shift));
                    };
                    const long double exact =
                        amount(before[std::size_t(y * width + x)]) * (1 - share) +
                        amount(color) * share;
                    ASSERT_NEAR(static_cast<double>(slow_light::level(l3d_blending::linear, exact)),
                                slow_light::channel(mixed.at(x, y), shift), 0.5 + 1e-9)
                        << n << ": " << x << ' ' << y;
                }
            }
    }
}

TEST(linear_blending, over_transparent_pixels_counts_colours_by_what_they_cover) {
    std::mt19937 random(4);
    for (const l3d_blending how : {l3d_blending::coded, l3d_blending::linear}) {
        const color_mixer mixer(how);
        for (int n = 0; n < 20000; ++n) {
            const auto word = static_cast<std::uint32_t>(random());
            const auto color = static_cast<std::uint32_t>(random());
            const double share = static_cast<double>(random() % 256) / 255;
            const std::uint32_t result = mixer.over(word, mixer.color(color), share);
            const long double shown = 1 - static_cast<long double>(word >> 24) / 255;
            const long double from = shown * (1 - static_cast<long double>(share));
            const long double sum = from + static_cast<long double>(share);
            if (share == 0) {
                ASSERT_EQ(result, word);
                continue;
            }
            ASSERT_NEAR(static_cast<double>(255 * (1 - sum)), result >> 24, 0.5 + 1e-9);
            for (const int shift : {0, 8, 16}) {
                const auto amount = [&](std::uint32_t w) {
                    return slow_light::amount(how, slow_light::channel(w, shift));
                };
                const long double exact =
                    (amount(word) * from + amount(color) * static_cast<long double>(share)) / sum;
                ASSERT_NEAR(static_cast<double>(slow_light::level(how, exact)),
                            slow_light::channel(result, shift), 0.5 + 1e-9);
            }
        }
    }
}

} // namespace
