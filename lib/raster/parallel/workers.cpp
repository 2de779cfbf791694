// SPDX-License-Identifier: MIT
// l3d_workers: a task arena of oneTBB, and counters that hand out items.
#include "raster/parallel/workers.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <thread>
#include <vector>

namespace {

/// Items [begin, end) that are still to be taken, from either end.
///
/// Shape: two cache lines of its own, since processors fetch them in pairs.
class alignas(128) item_range {
public:
    void set(int begin, int end) { ends_.store(packed(begin, end), std::memory_order_relaxed); }

    /// The first or the last one; none if all are taken.
    std::optional<int> take(bool first) {
        std::uint64_t ends = ends_.load(std::memory_order_relaxed);
        for (;;) {
            const int begin = static_cast<int>(ends >> 32), end = static_cast<int>(ends);
            if (begin >= end)
                return std::nullopt;
            const std::uint64_t left = first ? packed(begin + 1, end) : packed(begin, end - 1);
            if (ends_.compare_exchange_weak(ends, left, std::memory_order_relaxed))
                return first ? begin : end - 1;
        }
    }

private:
    static std::uint64_t packed(int begin, int end) {
        return std::uint64_t{static_cast<std::uint32_t>(begin)} << 32 |
               static_cast<std::uint32_t>(end);
    }

    std::atomic<std::uint64_t> ends_{0};
};

} // namespace

struct l3d_workers::threads {
    explicit threads(int count) : arena(count), ranges(static_cast<std::size_t>(count)) {}

    /// Calls work(worker) by each thread that comes.
    template <class Work> void run(int count, const Work& work) {
        // By default the whole process has no more threads than processors. Of all limits that
        // exist at a time, TBB obeys the smallest. So this one lives no longer than the work.
        std::optional<tbb::global_control> more;
        if (count > tbb::info::default_concurrency())
            more.emplace(tbb::global_control::max_allowed_parallelism,
                         static_cast<std::size_t>(count));
        arena.execute([&] {
            tbb::parallel_for(
                0, count, [&](int) { work(tbb::this_task_arena::current_thread_index()); },
                tbb::simple_partitioner{});
        });
    }

    tbb::task_arena arena;
    std::vector<item_range> ranges; ///< one for each worker
};

int l3d_usual_threads() {
    constexpr int most = 8;
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, most);
}

l3d_workers::l3d_workers(int threads_wanted) : count_(threads_wanted) {
    assert(threads_wanted >= 1);
    if (count_ > 1)
        threads_ = std::make_unique<threads>(count_);
}

l3d_workers::~l3d_workers() = default;

void l3d_workers::run(int items, item_call call, void* context) {
    if (count_ == 1 || items <= 1) {
        for (int item = 0; item < items; ++item)
            call(context, item, 0);
        return;
    }
    std::atomic<int> next{0};
    threads_->run(count_, [&](int worker) {
        for (int item = next++; item < items; item = next++)
            call(context, item, worker);
    });
}

/// Each worker has a range, which it takes from its outer end. When that is empty, it steals from
/// the others' ranges, its neighbours' first. It steals at the far end from their owner.
void l3d_workers::run_beside(int items, item_call call, void* context) {
    if (count_ == 1 || items <= 1)
        return run(items, call, context);
    std::vector<item_range>& ranges = threads_->ranges;
    for (int i = 0; i < count_; ++i)
        ranges[static_cast<std::size_t>(i)].set(
            static_cast<int>(std::int64_t{items} * i / count_),
            static_cast<int>(std::int64_t{items} * (i + 1) / count_));
    threads_->run(count_, [&](int worker) {
        for (int away = 0; away < count_; ++away) {
            const int owner = (worker + away) % count_;
            item_range& range = ranges[static_cast<std::size_t>(owner)];
            const bool first = (2 * owner < count_) == (away == 0);
            while (const auto item = range.take(first))
                call(context, *item, worker);
        }
    });
}
