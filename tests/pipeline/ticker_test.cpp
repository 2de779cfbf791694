// SPDX-License-Identifier: MIT
// Row 42 of the book's features: as many steps in a second at any frame rate.
#include "pipeline/pipeline.h"

#include <gtest/gtest.h>

TEST(ticker, row_42_as_far_at_any_frame_rate) {
    for (const int fps : {7, 30, 50, 60, 144, 300, 1000}) {
        l3d_ticker ticker;
        int steps = 0;
        for (int frame = 0; frame < 10 * fps; ++frame)
            steps += ticker.due(1.0 / fps);
        EXPECT_EQ(steps, 600) << fps;
    }
}

TEST(ticker, gives_one_step_to_each_frame_of_its_own_rate) {
    l3d_ticker ticker;
    for (int frame = 0; frame < 1000000; ++frame)
        ASSERT_EQ(ticker.due(1.0 / 60), 1) << frame;
}

TEST(ticker, does_not_catch_up_with_hours) {
    l3d_ticker ticker(25);
    EXPECT_EQ(ticker.due(5 * 3600), 25);
    EXPECT_EQ(ticker.due(0.01), 0);
    EXPECT_EQ(ticker.due(0.03), 1);
}

TEST(ticker, a_clock_set_back_takes_nothing) {
    l3d_ticker ticker(10);
    EXPECT_EQ(ticker.due(0.05), 0);
    EXPECT_EQ(ticker.due(-7), 0);
    EXPECT_EQ(ticker.due(0.05), 1);
}
