// SPDX-License-Identifier: MIT
// l3d_workers: a task arena of oneTBB, and a counter that hands out items in order.
#include "raster/workers.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/partitioner.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cassert>

struct l3d_workers::threads {
    explicit threads(int count)
        : allowed(tbb::global_control::max_allowed_parallelism,
                  static_cast<std::size_t>(std::max(count, tbb::info::default_concurrency()))),
          arena(count) {}
    tbb::global_control allowed; ///< else there are no more threads than processors
    tbb::task_arena arena;
};

l3d_workers::l3d_workers(int threads_wanted) : count_(threads_wanted) {
    assert(threads_wanted >= 1);
    if (count_ > 1)
        threads_ = std::make_unique<threads>(count_);
}

l3d_workers::~l3d_workers() = default;

void l3d_workers::run(int items, void (*call)(void*, int, int), void* context) {
    if (count_ == 1 || items <= 1) {
        for (int item = 0; item < items; ++item)
            call(context, item, 0);
        return;
    }
    std::atomic<int> next{0};
    const auto take_items = [&](int) {
        const int worker = tbb::this_task_arena::current_thread_index();
        for (int item = next++; item < items; item = next++)
            call(context, item, worker);
    };
    threads_->arena.execute(
        [&] { tbb::parallel_for(0, count_, take_items, tbb::simple_partitioner{}); });
}
