// SPDX-License-Identifier: MIT
// l3d_workers: every item once, whoever does it.
#include "raster/parallel/workers.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace {

constexpr std::array all_counts{1, 2, 3, 8};

struct tally {
    tally(int items, int count)
        : done(static_cast<std::size_t>(items)), busy(static_cast<std::size_t>(count)) {}

    void operator()(int item, int worker) {
        ++done[static_cast<std::size_t>(item)];
        clashes += busy[static_cast<std::size_t>(worker)]++;
        std::this_thread::yield();
        --busy[static_cast<std::size_t>(worker)];
    }

    void judge() const {
        for (const std::atomic<int>& each : done)
            EXPECT_EQ(each, 1);
        EXPECT_EQ(clashes, 0);
    }

    std::vector<std::atomic<int>> done, busy;
    std::atomic<int> clashes{0}; ///< calls that found another one of the same worker
};

TEST(workers, do_each_item_once_and_one_at_a_time) {
    for (const int count : all_counts) {
        l3d_workers workers(count);
        ASSERT_EQ(workers.count(), count);
        for (int items = 0; items < 100; ++items) {
            tally in_order(items, count), beside(items, count);
            workers.for_each(items, in_order);
            workers.for_each_beside(items, beside);
            in_order.judge();
            beside.judge();
        }
    }
}

TEST(workers, alone_work_in_order) {
    l3d_workers one(1);
    std::vector<int> order;
    one.for_each(3, [&](int item, int) { order.push_back(item); });
    one.for_each_beside(3, [&](int item, int) { order.push_back(item); });
    EXPECT_EQ(order, (std::vector<int>{0, 1, 2, 0, 1, 2}));
}

/// Nobody goes on before all have begun; that there are fewer elsewhere holds no one back.
TEST(workers, begin_at_the_outer_ends_of_a_row) {
    l3d_workers two(2), three(3), four(4);
    for (l3d_workers* const each_set : {&two, &three, &four}) {
        l3d_workers& workers = *each_set;
        const int count = workers.count();
        constexpr int each = 5;
        std::vector<int> first(static_cast<std::size_t>(count), -1);
        std::atomic<int> begun{0};
        workers.for_each_beside(each * count, [&](int item, int worker) {
            int& mine = first[static_cast<std::size_t>(worker)];
            if (mine >= 0)
                return;
            mine = item;
            ++begun;
            while (begun < count)
                std::this_thread::yield();
        });
        for (int worker = 0; worker < count; ++worker) {
            const bool from_the_left = 2 * worker < count;
            EXPECT_EQ(first[static_cast<std::size_t>(worker)],
                      from_the_left ? each * worker : each * (worker + 1) - 1);
        }
    }
}

} // namespace
