// SPDX-License-Identifier: MIT
// l3d_frame_pacer: deadlines in made-up time.
#include "system/frame_pacer.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {

using namespace std::chrono_literals;
using time_point = l3d_frame_pacer::clock::time_point;

const time_point start{12345s};

TEST(frame_pacer, first_frame_is_due_at_once) {
    EXPECT_EQ(l3d_frame_pacer(50, start).due(), start);
}

TEST(frame_pacer, late_frames_do_not_shift_the_grid) {
    l3d_frame_pacer pacer(50, start);
    pacer.frame_done(start + 3ms, false);
    EXPECT_EQ(pacer.due(), start + 20ms);
    pacer.frame_done(start + 39ms, false);
    EXPECT_EQ(pacer.due(), start + 40ms);
    pacer.frame_done(start + 41ms, true);
    EXPECT_EQ(pacer.due(), start + 60ms);
}

TEST(frame_pacer, missed_deadlines_are_dropped) {
    l3d_frame_pacer pacer(50, start);
    pacer.frame_done(start + 2013ms, false);
    EXPECT_EQ(pacer.due(), start + 2020ms);
    pacer.frame_done(start + 2021ms, false);
    EXPECT_EQ(pacer.due(), start + 2040ms);
}

/// Frames of different lengths, each begun a little late, are as many as the rate says.
TEST(frame_pacer, six_hundred_frames_take_ten_seconds) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    l3d_frame_pacer pacer(60, start);
    for (int frame = 0; frame < 600; ++frame)
        pacer.frame_done(pacer.due() + std::chrono::microseconds(random() % 16000), false);
    EXPECT_NEAR(std::chrono::duration<double>(pacer.due() - start).count(), 10, 1e-6);
}

TEST(frame_pacer, no_limit_waits_only_when_idle) {
    l3d_frame_pacer pacer(0, start);
    pacer.frame_done(start + 7ms, false);
    EXPECT_EQ(pacer.due(), start + 7ms);
    pacer.frame_done(start + 9ms, true);
    EXPECT_GT(pacer.due(), start + 9ms + 16ms);
    EXPECT_LT(pacer.due(), start + 9ms + 17ms);
}

TEST(frame_pacer, hardly_any_frames) {
    l3d_frame_pacer pacer(1e-300, start);
    pacer.frame_done(start + 1ms, false);
    EXPECT_EQ(pacer.due(), start + 1h);
}

} // namespace
