// SPDX-License-Identifier: MIT
// The memory screen: padded rows, no events, no waiting.
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>

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
