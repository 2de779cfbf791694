// SPDX-License-Identifier: MIT
// l3d_screen_info: masks, packing, and the display's own pixel values.
#include "tool_2d/screen_info.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace {

constexpr l3d_pixel_layout layout_555{15, 16, 0x7C00, 0x03E0, 0x001F, std::endian::little, 32};
constexpr l3d_pixel_layout layout_565{16, 16, 0xF800, 0x07E0, 0x001F, std::endian::little, 32};
constexpr l3d_pixel_layout layout_bgr{24, 32, 0x0000FF, 0x00FF00, 0xFF0000, std::endian::little,
                                      32};
constexpr l3d_pixel_layout layout_10{
    30, 32, 0x3FF00000, 0x000FFC00, 0x000003FF, std::endian::little, 32};
constexpr l3d_pixel_layout layout_332{8, 8, 0x07, 0x38, 0xC0, std::endian::little, 32};
constexpr l3d_pixel_layout layout_argb{32, 32, 0xFF0000, 0x00FF00, 0x0000FF, std::endian::little,
                                       32};

std::uint32_t shown(const l3d_pixel_layout& layout, int red, int green, int blue) {
    return l3d_screen_info(layout).to_display(l3d_rgb(red, green, blue));
}

TEST(screen_info, packs_channels_into_a_word) {
    EXPECT_EQ(l3d_rgb(0x12, 0x34, 0x56), 0x123456U);
    EXPECT_EQ(l3d_rgb(0, 255, 128), 0x00FF80U);
}

TEST(screen_info, clamps_channels) {
    EXPECT_EQ(l3d_rgb(-1, 256, 7), 0x00FF07U);
    EXPECT_EQ(l3d_rgb(100000, -100000, 300), 0xFF00FFU);
}

TEST(screen_info, the_books_colour_on_every_layout) {
    EXPECT_EQ(shown({}, 0, 255, 128), 0x00FF80U);
    EXPECT_EQ(shown(layout_565, 0, 255, 128), 0x07EFU);
    EXPECT_EQ(shown(layout_555, 0, 255, 128), 0x03EFU);
    EXPECT_EQ(shown(layout_bgr, 0, 255, 128), 0x80FF00U);
    EXPECT_EQ(shown(layout_332, 0, 255, 128), 0x78U);
    // 128 * 1023 / 255 = 513.5..., to nearest.
    EXPECT_EQ(shown(layout_10, 0, 255, 128), 0x3FFU << 10 | 514U);
    EXPECT_EQ(shown(layout_argb, 0, 255, 128), 0xFF00FF80U);
}

TEST(screen_info, derives_shift_and_width) {
    const l3d_screen_info info(layout_565);
    EXPECT_EQ(info.red().shift, 11);
    EXPECT_EQ(info.red().width, 5);
    EXPECT_EQ(info.green().shift, 5);
    EXPECT_EQ(info.green().width, 6);
    EXPECT_EQ(info.blue().shift, 0);
    EXPECT_EQ(info.blue().width, 5);
    EXPECT_EQ(info.bytes_per_pixel(), 2);
}

TEST(screen_info, only_a_deep_display_has_opaque_bits) {
    EXPECT_EQ(l3d_screen_info(layout_argb).opaque_bits(), 0xFF000000U);
    EXPECT_EQ(l3d_screen_info(layout_10).opaque_bits(), 0U);
    EXPECT_EQ(l3d_screen_info().opaque_bits(), 0U);
}

TEST(screen_info, words_are_native_only_if_everything_agrees) {
    EXPECT_TRUE(l3d_screen_info().native_is_word());
    for (const auto& layout : {layout_bgr, layout_10, layout_argb, layout_565})
        EXPECT_FALSE(l3d_screen_info(layout).native_is_word()) << layout.depth;
    l3d_pixel_layout swapped;
    swapped.byte_order =
        std::endian::native == std::endian::little ? std::endian::big : std::endian::little;
    EXPECT_FALSE(l3d_screen_info(swapped).native_is_word());
}

/// Levels by arithmetic in doubles, which is exact enough: no product here has more than 18 bits.
std::uint32_t expected_level(std::uint32_t value, int width) {
    const double level = value * ((1U << width) - 1) / 255.0;
    return static_cast<std::uint32_t>(width > 8 ? std::round(level) : std::floor(level));
}

TEST(screen_info, every_level_of_every_layout) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const auto& layout :
         {layout_555, layout_565, layout_bgr, layout_10, layout_332, layout_argb}) {
        const l3d_screen_info info(layout);
        for (int i = 0; i < 2000; ++i) {
            const std::uint32_t word = random() & 0xFFFFFF;
            const auto level = [&](int shift, l3d_channel channel) {
                return expected_level(word >> shift & 255, channel.width) << channel.shift;
            };
            EXPECT_EQ(info.to_display(word), (level(16, info.red()) | level(8, info.green()) |
                                              level(0, info.blue()) | info.opaque_bits()))
                << std::hex << word << " at depth " << std::dec << layout.depth;
        }
    }
}

TEST(screen_info, twelve_bits) {
    const l3d_pixel_layout layout{12, 16, 0x00F, 0x0F0, 0xF00, std::endian::big, 16};
    // 18 * 15 / 255 = 1.06, 52 -> 3.06, 186 -> 10.9; rounded down.
    EXPECT_EQ(shown(layout, 18, 52, 186), 0xA31U);
}

TEST(screen_info, direct_color_is_like_true_color) {
    l3d_pixel_layout direct;
    direct.color_class = l3d_color_class::direct_color;
    EXPECT_TRUE(l3d_screen_info(direct).native_is_word());
    EXPECT_EQ(shown(direct, 0x12, 0x34, 0x56), 0x123456U);
}

constexpr l3d_pixel_layout layout_map{
    8, 8, 0, 0, 0, std::endian::little, 32, l3d_color_class::pseudo_color};

TEST(screen_info, levels_are_nearest_to_their_share) {
    for (int levels = 2; levels <= 256; ++levels) {
        EXPECT_EQ(l3d_palette::value_of(0, levels), 0);
        EXPECT_EQ(l3d_palette::value_of(levels - 1, levels), 255);
        for (int level = 0; level < levels; ++level)
            EXPECT_EQ(l3d_palette::value_of(level, levels),
                      std::floor(255.0 * level / (levels - 1) + 0.5));
    }
}

TEST(screen_info, a_grey_is_as_bright_as_its_colour) {
    for (std::uint32_t value = 0; value < 256; ++value)
        EXPECT_EQ(l3d_screen_info::gray_of(value * 0x010101), value);
    EXPECT_EQ(l3d_screen_info::gray_of(0xFF0000), 76U);
    EXPECT_EQ(l3d_screen_info::gray_of(0x00FF00), 150U);
    EXPECT_EQ(l3d_screen_info::gray_of(0x0000FF), 29U);
    // 12.708 + 60.461 + 3.762
    EXPECT_EQ(l3d_screen_info::gray_of(0x2A6721), 77U);
}

/// Every value of each channel: no level of the cube is nearer than that which is shown.
TEST(screen_info, a_cube_shows_the_nearest_level) {
    const int red = 6, green = 5, blue = 4;
    l3d_palette palette{red, green, blue, {}};
    for (std::uint32_t place = 0; place < 120; ++place)
        palette.pixels.push_back(250 - place);
    const l3d_screen_info info(layout_map, palette);
    EXPECT_TRUE(info.has_palette());
    EXPECT_FALSE(info.native_is_word());
    EXPECT_FALSE(l3d_screen_info({}, palette).native_is_word());
    const auto distance = [](int value, int level, int levels) {
        return std::abs(value - l3d_palette::value_of(level, levels));
    };
    const auto least = [&](int value, int levels) {
        int found = 256;
        for (int level = 0; level < levels; ++level)
            found = std::min(found, distance(value, level, levels));
        return found;
    };
    for (int i = 0; i < 256; ++i) {
        const int r = i, g = i * 77 & 255, b = i * 151 & 255;
        const int place = 250 - static_cast<int>(info.to_display(l3d_rgb(r, g, b)));
        EXPECT_EQ(distance(r, place / (green * blue), red), least(r, red)) << r;
        EXPECT_EQ(distance(g, place / blue % green, green), least(g, green)) << g;
        EXPECT_EQ(distance(b, place % blue, blue), least(b, blue)) << b;
    }
    // The lower of two levels that are equally near: 0 and 85 around 42.5 have none, 0 and 64
    // around 32 have.
    EXPECT_EQ(info.to_display(0x002000), 250U);
}

TEST(screen_info, a_ramp_shows_the_nearest_grey) {
    const l3d_screen_info info(layout_map, {4, 1, 1, {7, 5, 3, 1}});
    EXPECT_EQ(info.to_display(0x000000), 7U);
    EXPECT_EQ(info.to_display(0x2A2A2A), 7U);
    EXPECT_EQ(info.to_display(0x2B2B2B), 5U);
    EXPECT_EQ(info.to_display(0x0000FF), 7U); // 29
    EXPECT_EQ(info.to_display(0xFF0000), 5U); // 76
    EXPECT_EQ(info.to_display(0x00FF00), 3U); // 150
    EXPECT_EQ(info.to_display(0xFFFFFF), 1U);
}

TEST(screen_info, describes_itself) {
    l3d_pixel_layout swapped = layout_565;
    swapped.byte_order = std::endian::big;
    EXPECT_EQ(l3d_screen_info(swapped).describe(),
              "TrueColor, depth 16, 16 bits per pixel, high byte first, masks f800/7e0/1f");
    EXPECT_EQ(l3d_screen_info(layout_map, {2, 3, 2, std::vector<std::uint32_t>(12)}).describe(),
              "PseudoColor, depth 8, 8 bits per pixel, low byte first, 2x3x2 colours");
    l3d_pixel_layout gray = layout_map;
    gray.color_class = l3d_color_class::static_gray;
    EXPECT_EQ(l3d_screen_info(gray, {3, 1, 1, {0, 1, 2}, 9}).describe(),
              "StaticGray, depth 8, 8 bits per pixel, low byte first, 3 grays, exact within 9/255");
}

} // namespace

// Every value of a channel at every intensity, against the formula; the other channels are others.
TEST(screen_info, row_10_light_and_fog) {
    for (std::uint32_t c = 0; c < 256; ++c)
        for (std::uint32_t i = 0; i < 256; ++i) {
            const std::uint32_t word = c << 16 | (255 - c) << 8 | (c ^ 0x5A);
            const auto lit = [i](std::uint32_t v) { return (2 * v * i + 255) / 510; };
            const auto fogged = [i](std::uint32_t v) {
                return 255 - (2 * (255 - v) * (255 - i) + 255) / 510;
            };
            const auto of = [&](auto change) {
                return change(c) << 16 | change(255 - c) << 8 | change(c ^ 0x5A);
            };
            ASSERT_EQ(l3d_screen_info::light_native(word, i), of(lit)) << c << ' ' << i;
            ASSERT_EQ(l3d_screen_info::fog_native(word, i), of(fogged)) << c << ' ' << i;
        }
    EXPECT_EQ(l3d_screen_info::light_native(0x123456, 255), 0x123456u);
    EXPECT_EQ(l3d_screen_info::light_native(0x123456, 0), 0u);
    EXPECT_EQ(l3d_screen_info::fog_native(0x123456, 0), 0x123456u);
    EXPECT_EQ(l3d_screen_info::fog_native(0x123456, 255), 0xFFFFFFu);
}
