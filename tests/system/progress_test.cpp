// SPDX-License-Identifier: MIT
// progress: when a line is written, and that none is left.
#include "system/progress_p.h"

#include <gtest/gtest.h>

#include <sstream>

namespace {

using l3d_detail::progress;
using std::chrono::milliseconds;

constexpr progress::clock::time_point start{};

TEST(progress, is_told_once_a_second_and_taken_away) {
    std::ostringstream out;
    {
        progress told(out, true, "dot", 5000, start);
        told.done(1, start + milliseconds(999));
        EXPECT_EQ(out.str(), "");
        told.done(2, start + milliseconds(1000));
        EXPECT_EQ(out.str(), "\r\x1b[Kdot: frame 2 of 5000");
        told.done(3, start + milliseconds(1999));
        told.done(4, start + milliseconds(2500));
    }
    EXPECT_EQ(out.str(), "\r\x1b[Kdot: frame 2 of 5000\r\x1b[Kdot: frame 4 of 5000\r\x1b[K");
}

TEST(progress, of_short_runs_and_elsewhere_than_in_terminals_is_not_told) {
    std::ostringstream out;
    progress(out, true, "dot", 3, start).done(3, start + milliseconds(20));
    progress(out, false, "dot", 5000, start).done(900, start + milliseconds(9000));
    EXPECT_EQ(out.str(), "");
}

} // namespace
