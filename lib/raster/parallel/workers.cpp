// SPDX-License-Identifier: MIT
// l3d_workers: wakes sleeping threads, which take items by counters.
#include "raster/parallel/workers.h"

#include "base/error.h"

#include <pthread.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace {

/// The items of a worker that no worker has taken yet: a range [begin, end), from which items are
/// taken at either end.
///
/// Shape: fills two cache lines, since processors fetch them in pairs.
class alignas(128) item_range {
public:
    void set(int begin, int end) { ends_.store(packed(begin, end), std::memory_order_relaxed); }

    /// Takes the range's first item, or its last item if `first` is false. Returns nothing if all
    /// items are taken.
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

/// The threads of an l3d_workers. They sleep until there is work. The caller's thread is worker 0.
///
/// The other threads are made by pthread_create, since stacks of std::thread are as large as the
/// user's limit.
struct l3d_workers::threads {
    /// Makes `wanted` - 1 threads besides the caller's, or as many as the system allows.
    explicit threads(int wanted) : members(static_cast<std::size_t>(wanted)) {
        pthread_attr_t attributes;
        pthread_attr_init(&attributes);
        pthread_attr_setstacksize(&attributes, stack_bytes);
        for (; made < wanted; ++made) {
            member& next = members[static_cast<std::size_t>(made)];
            next.owner = this;
            next.worker = made;
            why_no_more = pthread_create(&next.thread, &attributes, begin, &next);
            if (why_no_more != 0)
                break;
        }
        pthread_attr_destroy(&attributes);
    }

    threads(const threads&) = delete;
    threads& operator=(const threads&) = delete;

    ~threads() {
        {
            const std::lock_guard lock(mutex);
            is_over = true;
        }
        begun.notify_all();
        for (int worker = 1; worker < made; ++worker)
            pthread_join(members[static_cast<std::size_t>(worker)].thread, nullptr);
    }

    /// Calls work(worker) on this thread, and on other threads that join in before the call ends.
    /// Cost: allocates nothing if `work` holds only a reference.
    void run(const std::function<void(int)>& work) {
        {
            const std::lock_guard lock(mutex);
            has_failed = false;
            present = &work;
            ++rounds;
        }
        begun.notify_all();
        attempt(work, 0);
        std::unique_lock lock(mutex);
        present = nullptr;
        if (busy > 0) {
            lock.unlock();
            watch();
            lock.lock();
        }
        ended.wait(lock, [this] { return busy == 0; });
        if (has_failed)
            std::rethrow_exception(std::exchange(failure, nullptr));
    }

    /// Size of a thread's stack. It is larger than programs without sanitizers need, since
    /// sanitizers make larger stack frames. Only touched pages take memory.
    static constexpr std::size_t stack_bytes = 8 * l3d_stack_bytes;

    struct member {
        threads* owner = nullptr;
        int worker = 0;
        pthread_t thread{};
        item_range range; ///< items that this worker begins with
    };

    std::vector<member> members;
    int made = 1; ///< the number of threads that exist, the caller's thread included
    int why_no_more = 0;
    /// Whether an item's work has thrown, so that no other item is begun.
    std::atomic<bool> has_failed{false};

private:
    static void* begin(void* context) noexcept {
        const member& self = *static_cast<const member*>(context);
        self.owner->serve(self.worker);
        return nullptr;
    }

    void serve(int worker) {
        std::uint64_t seen = 0;
        for (std::unique_lock lock(mutex);;) {
            begun.wait(lock, [&] { return is_over || (present && rounds != seen); });
            if (is_over)
                return;
            seen = rounds;
            const std::function<void(int)>& work = *present;
            ++busy;
            lock.unlock();
            attempt(work, worker);
            lock.lock();
            if (--busy == 0)
                ended.notify_one();
        }
    }

    /// Spins until the other threads' last items are done, but no longer than falling asleep and
    /// waking take. On a busy machine, a sleeper would wait for its turn.
    void watch() const {
        using clock = std::chrono::steady_clock;
        constexpr auto sleep_and_wake = std::chrono::microseconds(50);
        for (const auto start = clock::now(); busy > 0 && clock::now() - start < sleep_and_wake;)
            continue;
    }

    void attempt(const std::function<void(int)>& work, int worker) noexcept {
        try {
            work(worker);
        } catch (...) {
            const std::lock_guard lock(mutex);
            if (!has_failed.exchange(true))
                failure = std::current_exception();
        }
    }

    std::mutex mutex; ///< guards all members that follow
    std::condition_variable begun, ended;
    /// The work that other threads may join; null if there is none.
    const std::function<void(int)>* present = nullptr;
    /// The number of calls of run(), so that no thread joins a call twice.
    std::uint64_t rounds = 0;
    std::atomic<int> busy{0}; ///< the number of other threads at work; written under the lock
    bool is_over = false;
    std::exception_ptr failure; ///< the first exception of the work
};

int l3d_usual_threads() {
    return std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1,
                      l3d_most_usual_threads);
}

std::string l3d_threads_complaint(int threads) {
    if (threads < 1)
        return "threads: " + std::to_string(threads) + " is not positive";
    if (threads > l3d_most_threads)
        return "threads: " + std::to_string(threads) + " is more than " +
               std::to_string(l3d_most_threads) +
               "; each takes memory, and more than there are processors draw no faster";
    return "";
}

l3d_workers::l3d_workers(int wanted) {
    if (const std::string why = l3d_threads_complaint(wanted); !why.empty())
        throw l3d_error(l3d_exit::failure, why);
    if (wanted == 1)
        return;
    threads_ = std::make_unique<threads>(wanted);
    count_ = threads_->made;
    if (count_ < wanted)
        shortage_ = std::to_string(count_) + (count_ == 1 ? " thread draws, " : " threads draw, ") +
                    std::to_string(wanted) +
                    " were asked for: " + std::generic_category().message(threads_->why_no_more);
}

l3d_workers::~l3d_workers() = default;

void l3d_workers::ask_if_due() {
    constexpr std::chrono::milliseconds pause{20}; // nobody feels a wait of less than 50 ms
    const auto now = std::chrono::steady_clock::now();
    if (now - asked_ < pause)
        return;
    asked_ = now;
    if (is_unwanted_())
        throw l3d_interrupted();
}

void l3d_workers::run(int items, item_call call, void* context) {
    if (count_ == 1 || items <= 1) {
        for (int item = 0; item < items; ++item) {
            ask();
            call(context, item, 0);
        }
        return;
    }
    std::atomic<int> next{0};
    const auto take_items = [&](int worker) {
        for (int item = next++; item < items && !threads_->has_failed; item = next++) {
            if (worker == 0)
                ask();
            call(context, item, worker);
        }
    };
    threads_->run(std::cref(take_items));
}

/// Gives each worker a range of its own. The worker takes items from the range's outer end, which
/// is farther from the middle of all items. When the range is empty, the worker takes items of
/// other workers' ranges, its next neighbour's first. It takes these items from the ranges' inner
/// ends, as the owners take from the outer ends.
void l3d_workers::run_beside(int items, item_call call, void* context) {
    if (count_ == 1 || items <= 1)
        return run(items, call, context);
    std::vector<threads::member>& members = threads_->members;
    for (int i = 0; i < count_; ++i)
        members[static_cast<std::size_t>(i)].range.set(
            static_cast<int>(std::int64_t{items} * i / count_),
            static_cast<int>(std::int64_t{items} * (i + 1) / count_));
    const auto take_items = [&](int worker) {
        for (int away = 0; away < count_; ++away) {
            const int owner = (worker + away) % count_;
            item_range& range = members[static_cast<std::size_t>(owner)].range;
            const bool first = (2 * owner < count_) == (away == 0);
            for (auto item = range.take(first); item && !threads_->has_failed;
                 item = range.take(first)) {
                if (worker == 0)
                    ask();
                call(context, *item, worker);
            }
        }
    };
    threads_->run(std::cref(take_items));
}
