// SPDX-License-Identifier: MIT
// l3d_screen_info: masks, packing, and the display's own pixel values.
#include "tool_2d/screen_info.h"

#include <gtest/gtest.h>

#include <cmath>
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
    return l3d_screen_info(layout).to_display(l3d_screen_info::ext_to_native(red, green, blue));
}

TEST(screen_info, packs_channels_into_a_word) {
    EXPECT_EQ(l3d_screen_info::ext_to_native(0x12, 0x34, 0x56), 0x123456U);
    EXPECT_EQ(l3d_screen_info::ext_to_native(0, 255, 128), 0x00FF80U);
}

TEST(screen_info, clamps_channels) {
    EXPECT_EQ(l3d_screen_info::ext_to_native(-1, 256, 7), 0x00FF07U);
    EXPECT_EQ(l3d_screen_info::ext_to_native(100000, -100000, 300), 0xFF00FFU);
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

} // namespace
