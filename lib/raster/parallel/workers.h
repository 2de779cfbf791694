// SPDX-License-Identifier: MIT
// l3d_workers: the threads that share the work of a frame.
#ifndef L3D_RASTER_PARALLEL_WORKERS_H
#define L3D_RASTER_PARALLEL_WORKERS_H

#include "base/public.h"

#include <chrono>
#include <concepts>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

/// The limit of threads that draw together. Machines have fewer processors than this limit, and
/// each thread takes memory of its own.
inline constexpr int l3d_most_threads = 1024;

/// The size of a stack that suffices for every thread that draws, however large or fine the drawing
/// is. A host's own threads may have smaller stacks. Sanitizers need several times as much.
/// Units: bytes.
inline constexpr std::size_t l3d_stack_bytes = 128 * 1024;

/// The reason why this number of threads cannot draw together, in words that name the number; "" if
/// this number of threads can draw together.
L3D_PUBLIC std::string l3d_threads_complaint(int threads);

/// The limit of threads that draw by default.
/// Source:  a picture of 1024x768 is filled in 12 bands, and the teapot has 28 patches to dice. So
///          each of 8 threads has at most two bands and four patches. If one thread takes 1 ms for
///          a frame, 8 more threads could save 0.06 ms. Waking them costs about as much.
inline constexpr int l3d_most_usual_threads = 8;

/// The number of threads that draw by default: as many as processors, up to l3d_most_usual_threads.
L3D_PUBLIC int l3d_usual_threads();

/// The exception that ends work before it is done.
class L3D_PUBLIC l3d_interrupted final : public std::exception {
public:
    const char* what() const noexcept override { return "interrupted"; }
};

/// Threads that do independent items of work.
///
/// The caller's thread works too, until no item is left to begin. If the system does not let a
/// worker run, only the item that this worker has begun is late. Workers sleep between calls.
class L3D_PUBLIC l3d_workers {
public:
    /// Starts threads, until there are `threads` including the caller's. With 1, the caller does
    /// all work, in order. If the system refuses some threads, there are fewer; count() and
    /// take_shortage() tell how many.
    /// Errors:  l3d_error with l3d_threads_complaint, if there is a complaint; std::bad_alloc.
    explicit l3d_workers(int threads);
    l3d_workers(const l3d_workers&) = delete;
    l3d_workers& operator=(const l3d_workers&) = delete;
    ~l3d_workers();

    /// The number of threads, the caller's thread included.
    int count() const { return count_; }

    /// A line of text about missing threads: how many threads there are, how many were asked for,
    /// and the system's reason. The result is "" in later calls, and if no thread is missing.
    std::string take_shortage() { return std::exchange(shortage_, {}); }

    /// Sets a question that the caller's thread asks while it works, some fifty times a second.
    /// Once the answer is true, the items that were begun are finished, and l3d_interrupted ends
    /// the work.
    void interrupt_when(std::function<bool()> wanted) { is_unwanted_ = std::move(wanted); }

    /// Asks the question of interrupt_when, if a fiftieth of a second has passed. Long loops of the
    /// caller's thread that are not divided into items call this function.
    /// Errors:  l3d_interrupted.
    /// Cost:    a look at the clock.
    void ask() {
        if (is_unwanted_)
            ask_if_due();
    }

    /// Calls work(item, worker) once for each item in [0, items), and returns when all are done.
    /// `worker` is a number in [0, count()). Lower items are begun first. Calls that run at the
    /// same time have different workers.
    /// Expects: one call of for_each at a time, and none from within work.
    /// Errors:  the first exception of work. Items that were not begun before it are left out.
    template <std::invocable<int, int> Work> void for_each(int items, Work&& work) {
        run(items, call_of<Work>, context_of(work));
    }

    /// Calls work as for_each does, but in no fixed order, for items whose neighbours use the same
    /// memory. Each worker begins at its own place in the row of items, and goes on to the items
    /// beside this place. So in repeated calls most items meet the same worker, and find their
    /// memory in the caches of this worker's core.
    template <std::invocable<int, int> Work> void for_each_beside(int items, Work&& work) {
        run_beside(items, call_of<Work>, context_of(work));
    }

private:
    using item_call = void (*)(void* context, int item, int worker);

    template <class Work> static void call_of(void* context, int item, int worker) {
        (*static_cast<std::remove_reference_t<Work>*>(context))(item, worker);
    }
    template <class Work> static void* context_of(Work& work) {
        return const_cast<void*>(static_cast<const void*>(std::addressof(work)));
    }

    void run(int items, item_call call, void* context);
    void run_beside(int items, item_call call, void* context);

    void ask_if_due();

    struct threads;
    int count_ = 1;
    std::function<bool()> is_unwanted_;
    std::chrono::steady_clock::time_point asked_{};
    std::string shortage_;
    std::unique_ptr<threads> threads_;
};

#endif
