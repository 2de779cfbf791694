// SPDX-License-Identifier: MIT
// The memory screen: padded rows, no events, no waiting.
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace {

std::unique_ptr<l3d_screen> make(l3d_size size) {
    l3d_service refusal;
    const l3d_screen_factory_memory factory;
    EXPECT_EQ(factory.service().how, l3d_service::level::fully);
    EXPECT_FALSE(factory.service().is_seen);
    return factory.create({size, "memory"}, refusal);
}

TEST(screen_memory, rows_are_longer_than_the_picture) {
    for (const int width : {1, 15, 16, 17, 320, 1023}) {
        const auto pixels = make({width, 7})->pixels();
        EXPECT_EQ(pixels.size(), (l3d_size{width, 7}));
        EXPECT_GT(pixels.stride, width);
        EXPECT_EQ(pixels.stride % 32, 16);
    }
}

TEST(screen_memory, starts_black_and_keeps_what_is_drawn) {
    const auto screen = make({37, 5});
    auto pixels = screen->pixels();
    for (int y = 0; y < pixels.height; ++y)
        EXPECT_TRUE(std::ranges::all_of(pixels.row(y), [](auto word) { return word == 0; }));
    pixels.row(4)[36] = 0x123456;
    screen->show();
    EXPECT_EQ(screen->pixels().row(4)[36], 0x123456U);
    EXPECT_EQ(screen->info().to_display(0x123456), 0x123456U);
    EXPECT_FALSE(screen->describe().empty());
}

TEST(screen_memory, draws_right_into_given_words) {
    std::vector<std::uint32_t> words(std::size_t{5} * 4, 7);
    l3d_screen_memory screen(l3d_pixels{words.data(), 3, 4, 5});
    EXPECT_EQ(screen.pixels().row(3).data(), words.data() + 15);
    screen.pixels().row(1)[2] = 0x123456;
    screen.show();
    EXPECT_EQ(words[7], 0x123456U);
    EXPECT_EQ(std::ranges::count(words, 7U), 19);
}

TEST(screen_memory, shows_packed_pixels_and_writes_nothing_beside_them) {
    const l3d_pixel_layout layout{.depth = 16,
                                  .bits_per_pixel = 16,
                                  .red_mask = 0xf800,
                                  .green_mask = 0x07e0,
                                  .blue_mask = 0x001f,
                                  .byte_order = std::endian::big};
    constexpr std::ptrdiff_t pitch = 2 * 9 + 3; // rows need not be aligned
    std::vector<std::uint8_t> bytes(pitch * 2, 0x55);
    l3d_screen_memory screen(l3d_packed_pixels{bytes.data(), {9, 2}, pitch, layout});
    for (int y = 0; y < 2; ++y)
        std::ranges::fill(screen.pixels().row(y), y == 0 ? 0xff0000U : 0x00ff00U);
    EXPECT_EQ(bytes[0], 0x55);
    screen.show();
    for (std::size_t x = 0; x < 9; ++x) {
        EXPECT_EQ(bytes[2 * x] << 8 | bytes[2 * x + 1], 0xf800);
        EXPECT_EQ(bytes[pitch + 2 * x] << 8 | bytes[pitch + 2 * x + 1], 0x07e0);
    }
    for (std::size_t i = 18; i < 21; ++i)
        EXPECT_TRUE(bytes[i] == 0x55 && bytes[pitch + i] == 0x55);
    EXPECT_NE(screen.describe().find("16 bits per pixel"), std::string::npos);
}

TEST(screen_memory, nothing_ever_happens) {
    const auto screen = make({3, 2});
    l3d_event event;
    // The test would not end if this slept.
    screen->wait(std::chrono::hours(24 * 365));
    EXPECT_FALSE(screen->next_event(event));
}

TEST(screen_memory, too_large_is_declined_with_the_size) {
    l3d_service refusal;
    const l3d_screen_factory_memory factory;
    // 2^31 * 2^31 words of 4 bytes are more than any address space holds.
    EXPECT_EQ(factory.create({{2147483647, 2147483646}, "huge"}, refusal), nullptr);
    EXPECT_EQ(refusal.how, l3d_service::level::not_here);
    EXPECT_NE(refusal.why.find("2147483647x2147483646"), std::string::npos) << refusal.why;
}

} // namespace
