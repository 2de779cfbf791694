// SPDX-License-Identifier: MIT
// l3d_radix_sort against std::stable_sort.
#include "geom/radix_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace {

TEST(radix_sort, is_the_stable_sort) {
    std::mt19937 random(7031);
    std::vector<l3d_sort_item> other;
    for (int round = 0; round < 400; ++round) {
        // Few different keys to see stability; some digits the same in all to see passes left out.
        const std::uint32_t mask = static_cast<std::uint32_t>(random() & random());
        const auto common = static_cast<std::uint32_t>(random());
        std::vector<l3d_sort_item> items(random() % 3000);
        for (std::uint32_t i = 0; i < items.size(); ++i)
            items[i] = {(static_cast<std::uint32_t>(random()) & mask) | (common & ~mask), i};
        std::vector<l3d_sort_item> expected = items;
        std::ranges::stable_sort(expected, {}, &l3d_sort_item::key);
        l3d_radix_sort(items, other);
        ASSERT_EQ(items, expected) << "round " << round;
    }
}

} // namespace
