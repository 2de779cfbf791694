// SPDX-License-Identifier: MIT
// For each rule by which a frame leaves work out: its gain where it applies, and its cost where it
// does not.
//
// The baseline is the same frame with that rule alone switched off. Both are drawn by turns, by one
// thread into the same memory; what is compared is the processor's time, pair by pair.
#include "bench/bench_frame.h"
#include "bench/leaving_out_cases.h"
#include "processor_time.h"
#include "raster/rasterizer_factory.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

/// Draws a case with its rule and without it.
class program final : public l3d_pipeline_afd {
public:
    explicit program(const leaving_out_case& of)
        : l3d_pipeline_afd(l3d_memory_canvas(leaving_out_cases::size), of.world,
                           leaving_out_cases::camera, of.settings),
          of_(of) {
        for (const l3d_patch_instance& instance : scene().instances())
            placements_.push_back(instance.placement());
    }

    /// Seconds of the processor for a frame, the mean of so many.
    double draw(bool with_rule, int frames) {
        double seconds = 0;
        for (int i = 0; i < frames; ++i) {
            change();
            settings().keep.*of_.keep = !with_rule;
            const double before = processor_seconds();
            draw_event();
            seconds += processor_seconds() - before;
        }
        return seconds / frames;
    }

private:
    void change() {
        // A ten-millionth of the distance: no picture shows it, no frame equals another.
        const double tremor = 1e-7 * (1 + ++frame_ % 64);
        const l3d_camera& from = leaving_out_cases::camera;
        const auto there = (from.eye - from.target) * tremor;
        const auto move = [&](std::size_t i) {
            scene().place(i,
                          l3d_translation<double>(there[0], there[1], there[2]) * placements_[i]);
        };
        if (of_.change == frame_change::eye)
            camera().eye = from.eye + there;
        if (of_.change == frame_change::one)
            move(placements_.size() - 1);
        for (std::size_t i = 0; of_.change == frame_change::all && i < placements_.size(); ++i)
            move(i);
        redraw();
    }

    const leaving_out_case& of_;
    std::vector<l3d_matrix<double>> placements_;
    int frame_ = 0;
};

struct quartiles {
    double low = 0, middle = 0, high = 0;

    explicit quartiles(std::vector<double> values) {
        std::ranges::sort(values);
        const std::size_t last = values.size() - 1;
        low = values[last / 4];
        middle = values[last / 2];
        high = values[last - last / 4];
    }
};

/// Units: milliseconds; ratio: with the rule / without it, of one pair.
struct outcome {
    std::int64_t left_out = 0, quads = 0, all_quads = 0;
    std::size_t pairs = 0;
    quartiles with, without, ratio;
};

outcome measured(const leaving_out_case& of, double seconds) {
    constexpr int warm = 3;
    constexpr std::size_t fewest = 11, most = 2001;
    program drawn(of);
    drawn.draw(false, warm);
    const std::int64_t all_quads = drawn.report().surface.quads;
    const double of_without = drawn.draw(false, 1);
    drawn.draw(true, warm);
    const l3d_frame_report report = drawn.report();
    // Where almost nothing is left to do, the clock is too coarse for one frame.
    const bool is_nothing = report.surface.quads == 0;
    const int frames_with = is_nothing ? 1000 : 1;
    const auto pairs =
        std::clamp(static_cast<std::size_t>(seconds / (2 * of_without)), fewest, most);
    std::array<std::vector<double>, 2> times;
    std::vector<double> ratios;
    for (std::size_t pair = 0; pair < pairs; ++pair) {
        for (const bool with : {pair % 2 == 0, pair % 2 == 1})
            times[with].push_back(1000 * drawn.draw(with, with ? frames_with : 1));
        ratios.push_back(times[1].back() / times[0].back());
    }
    return {of.left_out(report), report.surface.quads, all_quads,        pairs,
            quartiles(times[1]), quartiles(times[0]),  quartiles(ratios)};
}

void check(const leaving_out_case& of, const outcome& found) {
    const std::int64_t few = of.applies ? 0 : found.quads / 5;
    if ((found.left_out > few) != of.applies)
        throw std::runtime_error(of.rule + ", " + of.scene + ": left out " +
                                 std::to_string(found.left_out) + ' ' + of.unit);
}

void print(const leaving_out_case& of, const outcome& found) {
    std::printf("%-12s %-36s %9lld %-8s %7lld %7lld %9.4f %9.4f %7.2f (%6.2f to %6.2f) %5zu\n",
                of.rule.c_str(), of.scene.c_str(), static_cast<long long>(found.left_out), of.unit,
                static_cast<long long>(found.quads), static_cast<long long>(found.all_quads),
                found.with.middle, found.without.middle, 100 * found.ratio.middle,
                100 * found.ratio.low, 100 * found.ratio.high, found.pairs);
    std::fflush(stdout);
}

void write(std::FILE* csv, const leaving_out_case& of, const outcome& found) {
    std::fprintf(csv, "%s,\"%s\",%d,%lld,%s,%lld,%lld,%.4f,%.4f,%.2f,%.2f,%.2f,%zu\n",
                 of.rule.c_str(), of.scene.c_str(), of.applies,
                 static_cast<long long>(found.left_out), of.unit,
                 static_cast<long long>(found.quads), static_cast<long long>(found.all_quads),
                 found.with.middle, found.without.middle, 100 * found.ratio.low,
                 100 * found.ratio.middle, 100 * found.ratio.high, found.pairs);
}

/// Expects: no path, or one of a file that can be written.
void run(double seconds, const char* path) {
    std::FILE* const csv = path ? std::fopen(path, "w") : nullptr;
    if (path && !csv)
        throw std::runtime_error(std::string("cannot write ") + path);
    if (csv)
        std::fprintf(csv, "rule,scene,applies,left_out,unit,quads,all_quads,with_ms,without_ms,"
                          "percent_low,percent,percent_high,pairs\n");
    const leaving_out_cases cases;
    std::printf("%dx%d, one thread, %s; milliseconds and per cent: with the rule and without it, "
                "medians of pairs of frames, and quartiles\n%-12s %-36s %-18s %7s %7s %9s %9s %7s "
                "%21s\n",
                leaving_out_cases::size.width, leaving_out_cases::size.height, l3d_real_name(),
                "rule", "scene", " left out", "quads", "of", "ms with", "without", "%", "pairs");
    for (const leaving_out_case& of : cases.all()) {
        const outcome found = measured(of, seconds);
        check(of, found);
        print(of, found);
        if (csv)
            write(csv, of, found);
    }
    if (csv && std::fclose(csv) != 0)
        throw std::runtime_error(std::string("cannot write ") + path);
}

} // namespace

/// Usage: leaving_out_bench [--quick] [path of a table]. Other options are for the other
/// benchmarks.
int main(int argc, char** argv) try {
    double seconds = 6;
    const char* path = nullptr;
    for (int i = 1; i < argc; ++i)
        if (std::strcmp(argv[i], "--quick") == 0)
            seconds = 0.5;
        else if (argv[i][0] != '-')
            path = argv[i];
    run(seconds, path);
} catch (const std::exception& error) {
    std::fprintf(stderr, "leaving_out_bench: %s\n", error.what());
    return EXIT_FAILURE;
}
