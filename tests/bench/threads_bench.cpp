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
#include "raster/simd_target.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cinttypes>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

constexpr int warm_up = 5, frames = 201;
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

struct measured {
    double median_ms = 0, slow_ms = 0; ///< slow: 95 of 100 frames are faster
    double work_ms = 0;                ///< processor time a frame, of all threads
    std::uint64_t hash = 0;
};

measured measure(const l3d_patch_model& model, const l3d_camera& camera, int threads) {
    bench_frame frame(model, camera, size, tolerance, threads);
    for (int i = 0; i < warm_up; ++i)
        frame.draw();
    std::vector<double> times;
    const double before = processor_seconds();
    for (int i = 0; i < frames; ++i)
        times.push_back(frame.draw());
    const double work = processor_seconds() - before;
    std::sort(times.begin(), times.end());
    return {times[frames / 2], times[frames * 95 / 100], 1000 * work / frames, frame.hash()};
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
bool print_threads(const l3d_patch_model& model, double clear) {
    bool same = true;
    std::printf("%-8s %7s | %8s %8s %9s %8s %8s | %s\n", "view", "threads", "ms", "speed-up",
                "work ms", "clears", "study", "hash");
    for (std::size_t v = 0; v < bench_views.size(); ++v) {
        const bench_view& view = bench_views[v];
        const measured alone = measure(model, view.camera, 1);
        for (const int threads : {1, 2, 3, 8}) {
            const measured m = threads == 1 ? alone : measure(model, view.camera, threads);
            std::printf("%-8s %7d | %8.3f %8.2f %9.3f %8.1f %8s | %016" PRIx64 "\n", view.name,
                        threads, m.median_ms, alone.median_ms / m.median_ms, m.work_ms,
                        m.median_ms / clear, study_text(v, l3d_simd_target(), threads).c_str(),
                        m.hash);
            same = same && m.hash == alone.hash;
        }
    }
    return same;
}

/// Returns whether all sets of instructions draw the same.
bool print_vectors(const l3d_patch_model& model, double clear) {
    bool same = true;
    std::printf("\n%-8s %-9s | %8s %8s %8s | %s\n", "view", "vectors", "ms", "clears", "study",
                "hash");
    for (std::size_t v = 0; v < bench_views.size(); ++v) {
        const bench_view& view = bench_views[v];
        std::uint64_t hash = 0;
        for (const std::string& target : l3d_simd_targets()) {
            l3d_set_simd_target(target);
            const measured m = measure(model, view.camera, 1);
            if (hash == 0)
                hash = m.hash;
            std::printf("%-8s %-9s | %8.3f %8.1f %8s | %016" PRIx64 "\n", view.name, target.c_str(),
                        m.median_ms, m.median_ms / clear, study_text(v, target, 1).c_str(), m.hash);
            same = same && m.hash == hash;
        }
        l3d_set_simd_target("");
    }
    return same;
}

void print_beside_others(const l3d_patch_model& model) {
    std::printf("\ncloseup beside other processes that never rest\n%8s %7s | %8s %8s\n", "beside",
                "threads", "ms", "95 % ms");
    for (const unsigned beside : {0u, 1u, std::thread::hardware_concurrency()}) {
        const busy_neighbours neighbours(beside);
        for (const int threads : {1, 2}) {
            const measured m = measure(model, bench_views[1].camera, threads);
            std::printf("%8u %7d | %8.3f %8.3f\n", beside, threads, m.median_ms, m.slow_ms);
        }
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
    const double clear = clearing_ms(size);
    std::printf("1024x768, tolerance %.2f, l3d_real %s; medians of %d frames; a clear: %.3f ms\n\n",
                tolerance, l3d_real_name(), frames, clear);
    const bool threads_agree = print_threads(*model, clear);
    const bool vectors_agree = print_vectors(*model, clear);
    print_beside_others(*model);
    if (!threads_agree || !vectors_agree)
        std::fprintf(stderr, "threads_bench: the pictures differ\n");
    return threads_agree && vectors_agree ? 0 : 1;
}
