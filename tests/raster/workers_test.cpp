// SPDX-License-Identifier: MIT
// l3d_workers: every item once, by any worker.
#include "raster/parallel/workers.h"

#include "effort.h"
#include "base/error.h"

#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string>
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

/// Other workers hold on to their first item until the caller's has asked.
TEST(workers, end_work_that_nobody_wants) {
    for (const int count : all_counts)
        for (const bool beside : {false, true}) {
            l3d_workers workers(count);
            constexpr int items = 100;
            std::atomic<int> done{0};
            std::atomic<bool> is_asked{false};
            const auto work = [&](int, int worker) {
                while (worker != 0 && !is_asked)
                    std::this_thread::yield();
                ++done;
            };
            const auto call = [&] {
                beside ? workers.for_each_beside(items, work) : workers.for_each(items, work);
            };
            workers.interrupt_when([&] { return is_asked.exchange(true) || true; });
            EXPECT_THROW(call(), l3d_interrupted);
            EXPECT_LT(done, items);
            workers.interrupt_when({});
            done = 0;
            call();
            EXPECT_EQ(done, items);
        }
}

/// Leaves memory for the stacks of some threads, asks for eight, and exits with what came of that:
/// 0 is well.
[[noreturn]] void work_in_little_memory() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    constexpr std::size_t some_stacks = std::size_t{7} << 19;
    const rlim_t most = pages * static_cast<std::size_t>(getpagesize()) + some_stacks;
    const rlimit limit{most, most};
    if (setrlimit(RLIMIT_AS, &limit) != 0)
        std::_Exit(2);
    l3d_workers workers(8);
    const std::string why = workers.take_shortage();
    tally all(100, workers.count());
    workers.for_each(100, all);
    workers.for_each_beside(100, all);
    for (const std::atomic<int>& each : all.done)
        if (each != 2)
            std::_Exit(3);
    const bool is_told = workers.count() < 8 && workers.take_shortage().empty() &&
                         why.starts_with(std::to_string(workers.count()) + " thread") &&
                         why.find(", 8 were asked for: ") != std::string::npos;
    std::_Exit(is_told ? 0 : 4);
}

TEST(workers, are_fewer_where_the_system_makes_no_more) {
    if (sanitized)
        GTEST_SKIP() << "sanitizers need more memory than may be had here";
    // A process begun anew: stacks of threads that have ended are kept for those to come.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(work_in_little_memory(), testing::ExitedWithCode(0), "");
}

TEST(workers, are_no_more_than_machines_have_processors) {
    for (const int threads : {-1, 0, l3d_most_threads + 1, 100'000})
        try {
            l3d_workers refused(threads);
            ADD_FAILURE() << threads;
        } catch (const l3d_error& error) {
            EXPECT_EQ(error.what(), l3d_threads_complaint(threads));
            EXPECT_NE(l3d_threads_complaint(threads).find(std::to_string(threads)),
                      std::string::npos);
        }
    l3d_workers most(l3d_most_threads);
    EXPECT_EQ(most.take_shortage(), "");
    std::atomic<int> done{0};
    most.for_each(5, [&](int, int) { ++done; });
    EXPECT_EQ(done, 5);
}

TEST(workers, hand_on_what_work_throws_on_any_thread_and_work_again) {
    for (const int count : all_counts) {
        l3d_workers workers(count);
        for (int bad = 0; bad < 20; ++bad) {
            std::vector<std::atomic<int>> done(20);
            const auto work = [&](int item, int) {
                ++done[static_cast<std::size_t>(item)];
                if (item == bad)
                    throw std::runtime_error(std::to_string(item));
            };
            try {
                if (bad % 2 == 0)
                    workers.for_each(20, work);
                else
                    workers.for_each_beside(20, work);
                ADD_FAILURE() << "nothing was thrown";
            } catch (const std::runtime_error& error) {
                EXPECT_EQ(error.what(), std::to_string(bad));
            }
            for (const std::atomic<int>& each : done)
                EXPECT_LE(each, 1);
            tally after(20, count);
            workers.for_each_beside(20, after);
            after.judge();
        }
    }
}

TEST(workers, throw_once_if_all_throw) {
    l3d_workers workers(3);
    for (int i = 0; i < 50; ++i)
        EXPECT_THROW(workers.for_each(9, [](int, int) { throw std::bad_alloc(); }), std::bad_alloc);
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
