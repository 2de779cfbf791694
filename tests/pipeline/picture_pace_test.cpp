// SPDX-License-Identifier: MIT
// What the status line says of time: by a clock that the test sets.
#include "pipeline/viewer_controls.h"

#include <gtest/gtest.h>

#include <random>

namespace {

/// Time passes when the test says so.
struct studio {
    l3d_picture_pace::clock::time_point now{};
    l3d_picture_pace pace{[this] { return now; }};

    void pass(double milliseconds) {
        now += std::chrono::duration_cast<l3d_picture_pace::clock::duration>(
            std::chrono::duration<double, std::milli>(milliseconds));
    }
    void draw(double milliseconds) {
        pace.begin();
        pass(milliseconds);
        pace.end();
    }
};

TEST(picture_pace, tells_of_pictures_that_follow_each_other) {
    studio it;
    EXPECT_EQ(it.pace.text(), "");
    for (int i = 0; i < 200; ++i) {
        it.draw(4);
        it.pass(12);
    }
    it.pace.begin();
    EXPECT_NEAR(it.pace.per_second(), 62.5, 1e-9);
    EXPECT_NEAR(it.pace.milliseconds(), 4, 1e-9);
    EXPECT_EQ(it.pace.text(), "62 pictures a second, each drawn in 4.0 ms");
}

TEST(picture_pace, tells_of_slow_pictures) {
    studio it;
    for (int i = 0; i < 3; ++i) {
        it.draw(1480.5);
        it.pass(20);
    }
    it.pace.begin();
    EXPECT_EQ(it.pace.text(), "0.7 pictures a second, each drawn in 1480.5 ms");
}

TEST(picture_pace, counts_no_rest) {
    studio it;
    it.draw(10);
    it.pass(5000);
    it.pace.begin();
    EXPECT_EQ(it.pace.text(), "drawn in 10.0 ms");
    it.pass(20);
    it.pace.end();
    it.pass(5);
    it.pace.begin();
    EXPECT_EQ(it.pace.text(), "40 pictures a second, each drawn in 20.0 ms");
}

TEST(picture_pace, counts_no_picture_that_was_not_drawn) {
    studio it;
    it.draw(10);
    it.pass(10);
    it.pace.begin();
    it.pass(1);
    it.pace.begin();
    EXPECT_EQ(it.pace.milliseconds(), 10);
}

/// Whatever happens, so many pictures of that length fit into a second.
TEST(picture_pace, never_contradicts_itself) {
    std::mt19937_64 random(7);
    std::exponential_distribution<double> length(0.03);
    for (int run = 0; run < 100; ++run) {
        studio it;
        for (int i = 0; i < 100; ++i) {
            it.draw(length(random));
            if (random() % 3 == 0)
                it.pass(random() % 10 == 0 ? 3000 : length(random));
            if (random() % 2 == 0)
                it.pace.begin();
            EXPECT_LE(it.pace.per_second() * it.pace.milliseconds(), 1000 * (1 + 1e-9));
        }
    }
}

} // namespace
