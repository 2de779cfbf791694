// SPDX-License-Identifier: MIT
// The pixels that nothing was painted to yet, against a flag for each of them.
#include "raster/zsort/open_pixels_p.h"

#include <gtest/gtest.h>

#include <random>
#include <utility>
#include <vector>

namespace {

using namespace l3d_detail;

using runs = std::vector<std::pair<std::int32_t, std::int32_t>>;

/// A row of flags.
class slow_row {
public:
    explicit slow_row(std::int32_t width) : taken_(static_cast<std::size_t>(width), false) {}

    bool any(columns of) const {
        for (std::int32_t x = of.begin; x < of.end; ++x)
            if (is_open(x))
                return true;
        return false;
    }

    runs take(columns of) {
        runs open;
        for (std::int32_t x = of.begin; x < of.end; ++x) {
            if (!is_open(x))
                continue;
            if (!open.empty() && open.back().second == x)
                ++open.back().second;
            else
                open.emplace_back(x, x + 1);
            taken_[static_cast<std::size_t>(x)] = true;
        }
        return open;
    }

private:
    bool is_open(std::int32_t x) const { return !taken_[static_cast<std::size_t>(x)]; }

    std::vector<bool> taken_;
};

TEST(OpenPixels, AreTakenInRunsOnce) {
    std::mt19937 random(1);
    const auto below = [&](std::int32_t end) {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>(end));
    };
    for (int round = 0; round < 2000; ++round) {
        const std::int32_t width = 1 + below(300); // up to five words
        open_pixels fast;
        fast.open({3, 5}, width);
        slow_row slow(width);
        for (int i = 0; i < 12; ++i) {
            const std::int32_t begin = below(width);
            const columns of{begin, begin + below(std::min(width - begin, 90) + 1)};
            ASSERT_EQ(fast.any({4, 5}, of), slow.any(of)) << round;
            runs found;
            fast.take(4, of, [&](columns run) { found.emplace_back(run.begin, run.end); });
            ASSERT_EQ(found, slow.take(of)) << of.begin << " to " << of.end << ", " << round;
        }
        EXPECT_TRUE(fast.any({3, 5}, {0, width})) << "nothing was taken of the other row";
    }
}

} // namespace
