#include "judge.h"
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
using namespace stability;
int main(int argc, char** argv) {
    std::uint64_t from = 1, count = 1000; bool frames = false; 
    if (argc > 1) from = std::strtoull(argv[1], nullptr, 10);
    if (argc > 2) count = std::strtoull(argv[2], nullptr, 10);
    if (argc > 3) frames = true;
    const auto ways = all_arithmetics();
    if (argc > 1 && !std::strcmp(argv[1], "named")) {
        int n = 0; const int first = argc > 3 ? std::atoi(argv[3]) : 0;
        for (const test_case& c : named_cases()) {
            ++n;
            if (n < first || (argc > 2 && (c.group + ": " + c.name).find(argv[2]) == std::string::npos)) continue;
            std::fprintf(stderr, "%d %s: %s\n", n, c.group.c_str(), c.name.c_str());
            judge j(c, {3000, 8});
            for (const auto& way : ways) {
                auto t0 = std::chrono::steady_clock::now();
                const verdict v = j.of_frame(*way);
                const double d = std::chrono::duration<double>(std::chrono::steady_clock::now() - t0).count();
                std::printf("%d %s: %s [%s] %s bound %g tol %g measured %g ratio %.3f pieces %ld samples %ld missing %ld extra %ld pic %d ms %.1f (%.2f s) %s\n", n, c.group.c_str(), c.name.c_str(), way->name(), name_of(v.what), v.bound, c.tolerance, v.measured, v.ratio, (long)v.pieces, (long)v.samples, (long)v.missing, (long)v.extra, v.picture_judged, v.milliseconds, d, v.reason.c_str());
                std::fflush(stdout);
                if (j.accepted() && !std::strcmp(way->name(), pipeline_arithmetic())) {
                    const frame f = draw_by_pipeline(*j.accepted());
                    if (f.words != j.words()) std::printf("%d PIPELINE DIFFERS\n", n);
                }
            }
        }
        return 0;
    }
    std::map<std::string, std::map<std::string, int>> outcomes;
    std::map<std::string, double> worst, slow;
    double total[5]{};
    for (std::uint64_t s = from; s < from + count; ++s) {
        const test_case c = random_case(s);
        auto t0 = std::chrono::steady_clock::now();
        judge j(c, {200, 3});
        auto lap = [&] { auto t1 = std::chrono::steady_clock::now(); double d = std::chrono::duration<double>(t1 - t0).count(); t0 = t1; return d; };
        total[4] += lap();
        int n = 0;
        for (const auto& way : ways) {
            const verdict v = frames ? j.of_frame(*way) : j.of_points(*way);
            const double d = lap();
            total[n++] += d;
            ++outcomes[c.group + " " + way->name()][name_of(v.what)];
            auto& w = worst[c.group + " " + way->name()];
            w = std::max(w, v.ratio);
            auto& sl = slow[c.group + " " + way->name()];
            sl = std::max(sl, d);
            if (v.what == outcome::violated || d > 2)
                std::printf("%s %s %s tol %g size %dx%d fov %g: %s %s bound %g measured %g  %.2f s pieces %ld samples %ld\n", c.group.c_str(), c.name.c_str(), way->name(), c.tolerance, c.size.width, c.size.height, c.eye.fov_degrees, name_of(v.what), v.reason.c_str(), v.bound, v.measured, d, (long)v.pieces, (long)v.samples);
            std::fflush(stdout);
        }
    }
    for (auto& [k, m] : outcomes) { std::printf("%-24s worst %.3f slowest %.3f:", k.c_str(), worst[k], slow[k]); for (auto& [o, n] : m) std::printf(" %s %d", o.c_str(), n); std::puts(""); }
    std::printf("seconds: judge %.2f", total[4]); for (int i = 0; i < 4; ++i) std::printf(" %s %.2f", ways[i]->name(), total[i]); std::puts("");
}
