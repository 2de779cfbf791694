// SPDX-License-Identifier: MIT
// What threads and vector instructions do for a frame: time, work done, and the same picture.
//
// Machines differ, so times are told in clears, too: how many times as long as to clear colour and
// depth of the picture, in the same run. Beside them stands what the feasibility study set itself.
//
// Wall time says how long a frame takes, processor time how much work was done in it: their ratio
// is the number of processors that were really at work. The last table lets another process keep
// every processor busy meanwhile, which a program that waits by spinning does not survive.
#include "bench/bench_frame.h"
#include "bench/peer_timing.h"
#include "geom/teapot.h"
#include "processor_time.h"
#include "raster/parallel/simd_target.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <deque>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

/// The first frame of a turn, which finds another's data in the caches, is drawn beside them.
constexpr int frames_of_turn = 5, turns = 41;
constexpr l3d_size size{1024, 768};
constexpr double tolerance = 0.25;

/// The study's targets in clears of its machine, which took 0.063 ms for one: shaded alike or
/// dearer, with AVX-512 on one and two cores, and with AVX2 on one. For the bench_views.
struct study_targets {
    double one, two, avx2;
};
constexpr double study_clear_ms = 0.063;
constexpr std::array<study_targets, 3> study{
    {{1.2 / study_clear_ms, 0.7 / study_clear_ms, 1.7 / study_clear_ms},
     {2.0 / study_clear_ms, 1.2 / study_clear_ms, 2.7 / study_clear_ms},
     {1.7 / study_clear_ms, 1.0 / study_clear_ms, 2.3 / study_clear_ms}}};

/// The study's target of a view, as a column of the tables; empty where it set none.
std::string study_text(std::size_t view, std::string_view vectors, int threads) {
    const study_targets& targets = study[view];
    double clears = 0;
    if (vectors == "AVX3" && threads <= 2)
        clears = threads == 1 ? targets.one : targets.two;
    else if (vectors == "AVX2" && threads == 1)
        clears = targets.avx2;
    std::array<char, 16> text{};
    if (clears > 0)
        std::snprintf(text.data(), text.size(), "%.1f", clears);
    return text.data();
}

/// A way to draw a view.
struct draw_way {
    int threads = 1;
    std::string vectors; ///< a SIMD target; empty for the best
};

struct measured {
    double median_ms = 0, slow_ms = 0; ///< slow: 95 of 100 frames are faster
    double work_ms = 0;                ///< processor time a frame, of all threads
    std::uint64_t hash = 0;
};

/// A view, drawn in several ways, and a clear.
struct compared {
    std::vector<measured> ways;
    double clear_ms = 0;
};

double quantile(std::vector<double> numbers, std::size_t percent) {
    std::ranges::sort(numbers);
    return numbers[numbers.size() * percent / 100];
}

/// Frames of one way.
class way_timer {
public:
    way_timer(const l3d_patch_model& model, const l3d_camera& camera, const draw_way& way)
        : frame_(model, camera, size, tolerance, way.threads), vectors_(way.vectors) {}

    void take_turn() {
        l3d_set_simd_target(vectors_);
        frame_.draw();
        const double before = processor_seconds();
        for (int i = 0; i < frames_of_turn; ++i)
            ms_.push_back(frame_.draw());
        work_s_ += processor_seconds() - before;
    }

    measured result() {
        l3d_set_simd_target(vectors_);
        constexpr double ms_per_s = 1000;
        return {quantile(ms_, 50), quantile(ms_, 95),
                ms_per_s * work_s_ / static_cast<double>(ms_.size()), frame_.hash()};
    }

private:
    bench_frame frame_;
    std::string vectors_;
    std::vector<double> ms_;
    double work_s_ = 0;
};

/// All ways in turn: what disturbs one disturbs all.
compared measure(const l3d_patch_model& model, const l3d_camera& camera,
                 std::span<const draw_way> ways) {
    std::deque<way_timer> timers;
    for (const draw_way& way : ways)
        timers.emplace_back(model, camera, way);
    std::vector<double> clears;
    for (int turn = 0; turn < turns; ++turn) {
        clears.push_back(clearing_ms(size));
        for (way_timer& timer : timers)
            timer.take_turn();
    }
    compared all;
    for (way_timer& timer : timers)
        all.ways.push_back(timer.result());
    all.clear_ms = quantile(clears, 50);
    l3d_set_simd_target("");
    return all;
}

/// Processes that do nothing but keep processors busy.
class busy_neighbours {
public:
    explicit busy_neighbours(unsigned count) {
        for (unsigned i = 0; i < count; ++i)
            if (const pid_t child = fork(); child == 0)
                for (volatile int never_over = 1; never_over != 0;) {
                }
            else
                children_.push_back(child);
    }
    busy_neighbours(const busy_neighbours&) = delete;
    busy_neighbours& operator=(const busy_neighbours&) = delete;
    ~busy_neighbours() {
        for (const pid_t child : children_) {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
    }

private:
    std::vector<pid_t> children_;
};

/// Returns whether all numbers of threads draw the same.
bool print_threads(const l3d_patch_model& model) {
    constexpr std::array numbers{1, 2, 3, 8};
    std::vector<draw_way> ways;
    ways.reserve(numbers.size());
    for (const int threads : numbers)
        ways.push_back({.threads = threads, .vectors = {}});
    bool same = true;
    std::printf("%-8s %7s | %8s %8s %9s %8s %8s | %s\n", "view", "threads", "ms", "speed-up",
                "work ms", "clears", "study", "hash");
    for (std::size_t v = 0; v < bench_views.size(); ++v) {
        const auto [all, clear] = measure(model, bench_views[v].camera, ways);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const measured& m = all[i];
            std::printf("%-8s %7d | %8.3f %8.2f %9.3f %8.1f %8s | %016" PRIx64 "\n",
                        bench_views[v].name, numbers[i], m.median_ms,
                        all.front().median_ms / m.median_ms, m.work_ms, m.median_ms / clear,
                        study_text(v, l3d_simd_target(), numbers[i]).c_str(), m.hash);
            same = same && m.hash == all.front().hash;
        }
    }
    return same;
}

/// Returns whether all sets of instructions draw the same.
bool print_vectors(const l3d_patch_model& model) {
    std::vector<draw_way> ways;
    for (const std::string& target : l3d_simd_targets())
        ways.push_back({.threads = 1, .vectors = target});
    bool same = true;
    std::printf("\n%-8s %-9s | %8s %8s %8s | %s\n", "view", "vectors", "ms", "clears", "study",
                "hash");
    for (std::size_t v = 0; v < bench_views.size(); ++v) {
        const auto [all, clear] = measure(model, bench_views[v].camera, ways);
        for (std::size_t i = 0; i < all.size(); ++i) {
            const measured& m = all[i];
            std::printf("%-8s %-9s | %8.3f %8.1f %8s | %016" PRIx64 "\n", bench_views[v].name,
                        ways[i].vectors.c_str(), m.median_ms, m.median_ms / clear,
                        study_text(v, ways[i].vectors, 1).c_str(), m.hash);
            same = same && m.hash == all.front().hash;
        }
    }
    return same;
}

void print_beside_others(const l3d_patch_model& model) {
    const std::vector<draw_way> ways{{.threads = 1, .vectors = {}}, {.threads = 2, .vectors = {}}};
    std::printf("\ncloseup beside other processes that never rest\n%8s %7s | %8s %8s\n", "beside",
                "threads", "ms", "95 % ms");
    for (const unsigned beside : {0u, 1u, std::thread::hardware_concurrency()}) {
        const busy_neighbours neighbours(beside);
        const auto all = measure(model, bench_views[1].camera, ways).ways;
        for (std::size_t i = 0; i < all.size(); ++i)
            std::printf("%8u %7d | %8.3f %8.3f\n", beside, ways[i].threads, all[i].median_ms,
                        all[i].slow_ms);
    }
}

} // namespace

int main() {
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    if (!model) {
        std::fprintf(stderr, "threads_bench: %s\n", why.c_str());
        return 1;
    }
    std::printf("1024x768, tolerance %.2f, l3d_real %s; medians of %d frames, %d in turn; a clear: "
                "%.3f ms\n\n",
                tolerance, l3d_real_name(), turns * frames_of_turn, frames_of_turn,
                clearing_ms(size));
    const bool threads_agree = print_threads(*model);
    const bool vectors_agree = print_vectors(*model);
    print_beside_others(*model);
    if (!threads_agree || !vectors_agree)
        std::fprintf(stderr, "threads_bench: the pictures differ\n");
    return threads_agree && vectors_agree ? 0 : 1;
}
