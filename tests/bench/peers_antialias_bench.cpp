// SPDX-License-Identifier: MIT
// l3d's anti-aliased pictures against those of Mesa's llvmpipe and of Embree: error and time.
//
// The exact picture has in each pixel the mean of the light from all of its square. Errors are root
// mean squares of differences in levels from it, over all pixels and over those at edges alone.
// Ours draws with several tolerances, the peers draw meshes from coarse to fine. Ratios of times
// are told at equal errors, between the points of the curves on straight lines in logarithms.
#include "bench/mesa_smooth_peer.h"
#include "bench/smooth_curves.h"
#include "geom/teapot.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

namespace {

constexpr l3d_size size{1024, 768};
constexpr std::array our_tolerances{1.0, 0.5, 0.25, 0.1, 0.05, 0.02};

/// With the first the peers' pictures are twice as wrong as the worst of ours, with the last a
/// triangle has less than a pixel.
constexpr std::array mesh_tolerances{1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625};

/// Where the curves shall go, too. What is not known is for the other benchmarks, which are run
/// with the same arguments.
std::string csv_path(int argc, char** argv) {
    constexpr std::string_view csv_option = "--antialias-csv=";
    for (int i = 1; i < argc; ++i)
        if (const std::string_view argument = argv[i]; argument.starts_with(csv_option))
            return std::string(argument.substr(csv_option.size()));
    return "";
}

/// The meshes of every view, on all processors.
void make_meshes(const l3d_patch_model& model, std::vector<smooth_scenery>& sceneries) {
    for (smooth_scenery& of : sceneries) {
        of.mesh_tolerances.assign(mesh_tolerances.begin(), mesh_tolerances.end());
        of.meshes.resize(mesh_tolerances.size());
    }
    const std::size_t count = sceneries.size() * mesh_tolerances.size();
    // The dearest are begun first.
    std::atomic<std::size_t> left = count;
    const auto work = [&] {
        for (std::size_t i = left--; i > 0 && i <= count; i = left--) {
            smooth_scenery& of = sceneries[(i - 1) % sceneries.size()];
            const std::size_t mesh = (i - 1) / sceneries.size();
            of.meshes[mesh] = adaptive_mesh(
                {model, of.view->camera, of.size, mesh_tolerances[mesh], l3d_afd_settings().light});
        }
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads)
        thread.join();
}

/// How many times as long as `ours` a curve takes for an error.
struct ratio {
    bool reached = false;
    double value = 0; ///< if not reached: of the most exact picture of the curve
};

ratio ratio_of(const std::vector<smooth_point>& theirs, const smooth_point& ours,
               const smooth_measure& measure) {
    if (const auto ms = time_at(theirs, measure.over, ours.error.*measure.over))
        return {true, *ms / ours.ms};
    return {false, most_exact(theirs, measure.over).ms / ours.ms};
}

/// The other way round: at the error of the rival's most exact picture.
ratio best_ratio(const smooth_duel& duel, const smooth_measure& measure) {
    const smooth_point& best = most_exact(duel.theirs, measure.over);
    if (const auto ms = time_at(duel.ours, measure.over, best.error.*measure.over))
        return {true, best.ms / *ms};
    return {false, best.ms / most_exact(duel.ours, measure.over).ms};
}

void print_points(const smooth_duel& duel) {
    std::printf("  %s (%s)\n", name_of(duel.rival),
                duel.rival == smooth_rival::embree
                    ? ("packets of " + std::to_string(duel.way.embree_rays)).c_str()
                    : ("workers: " + std::to_string(duel.way.mesa_threads) +
                       ", bits: " + std::to_string(duel.way.mesa_bits))
                          .c_str());
    for (const smooth_point& p : duel.theirs)
        std::printf("    %8g %8zu | %7.3f %7.3f %8.2f\n", p.tolerance, p.triangles, p.error.all,
                    p.error.edges, p.ms);
    std::printf("    ours, in turn; ratios over all pixels and over edges\n");
    for (const smooth_point& p : duel.ours) {
        std::printf("    %8g %8s | %7.3f %7.3f %8.2f |", p.tolerance, "", p.error.all,
                    p.error.edges, p.ms);
        for (const smooth_measure& measure : smooth_measures) {
            const ratio r = ratio_of(duel.theirs, p, measure);
            std::printf(" %s%.1f", r.reached ? "" : "not reached, >", r.value);
        }
        std::printf("\n");
    }
    std::printf("    at the least error of theirs:");
    for (const smooth_measure& measure : smooth_measures) {
        const ratio r = best_ratio(duel, measure);
        std::printf(" %s %s%.1f", measure.name, r.reached ? "" : "ours never so exact, ", r.value);
    }
    std::printf("\n");
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return (values[(values.size() - 1) / 2] + values[values.size() / 2]) / 2;
}

void print_ratios(std::span<const smooth_duel> duels, smooth_rival rival,
                  const smooth_measure& measure) {
    std::vector<double> reached, at_best;
    std::size_t lines = 0, views = 0;
    for (const smooth_duel& duel : duels) {
        if (duel.rival != rival)
            continue;
        for (const smooth_point& p : duel.ours) {
            const ratio r = ratio_of(duel.theirs, p, measure);
            if (r.reached)
                reached.push_back(r.value);
            ++lines;
        }
        ++views;
        if (const ratio r = best_ratio(duel, measure); r.reached)
            at_best.push_back(r.value);
    }
    std::printf("%-22s over %-5s: ", name_of(rival), measure.name);
    if (!reached.empty())
        std::printf("least %.1f, median %.1f, most %.1f of %zu lines; ",
                    *std::ranges::min_element(reached), median(reached),
                    *std::ranges::max_element(reached), reached.size());
    std::printf("%zu of %zu lines not reached; ", lines - reached.size(), lines);
    std::printf("ours reaches the rival's least error in %zu of %zu views", at_best.size(), views);
    if (!at_best.empty())
        std::printf(": least %.1f, median %.1f", *std::ranges::min_element(at_best),
                    median(at_best));
    std::printf("\n");
}

/// As it stands in docs/SPEED.md: a line for each picture of ours.
void print_table(std::span<const smooth_duel> duels) {
    std::printf("\n| view | tolerance | error: all, edges | ms");
    for (const smooth_rival rival : smooth_rivals)
        std::printf(" | %s", name_of(rival));
    std::printf(" |\n|---|---|---|---|---|---|---|\n");
    const std::size_t views = duels.size() / smooth_rivals.size();
    for (std::size_t view = 0; view < views; ++view)
        for (std::size_t i = 0; i < our_tolerances.size(); ++i) {
            const smooth_point& first = duels[view].ours[i];
            std::vector<double> ms;
            for (std::size_t d = view; d < duels.size(); d += views)
                ms.push_back(duels[d].ours[i].ms);
            std::printf("| %s | %g | %.2f, %.2f | %.1f", duels[view].of->view->name,
                        first.tolerance, first.error.all, first.error.edges, median(ms));
            for (std::size_t d = view; d < duels.size(); d += views)
                for (const smooth_measure& measure : smooth_measures) {
                    const ratio r = ratio_of(duels[d].theirs, duels[d].ours[i], measure);
                    std::printf("%s%s%.1f", measure.over == &smooth_error::all ? " | " : ", ",
                                r.reached ? "" : "over ", r.value);
                }
            std::printf(" |\n");
        }
}

/// Errors: std::runtime_error if somebody's pictures cannot be of this view.
void check(std::span<const smooth_duel> duels) {
    constexpr double most = 3; // levels: four samples a pixel, the worst way, leave two
    for (const smooth_duel& duel : duels)
        for (const auto* const side : {&duel.ours, &duel.theirs})
            if (most_exact(*side, &smooth_error::all).error.all > most)
                throw std::runtime_error(std::string("a picture is wrong: ") +
                                         (side == &duel.ours ? "l3d" : name_of(duel.rival)));
}

void print(std::span<const smooth_duel> duels, int threads) {
    for (const smooth_duel& duel : duels) {
        std::printf("\n%s, %d thread%s\n    %8s %8s | %7s %7s %8s\n", duel.of->view->name, threads,
                    threads == 1 ? "" : "s", "px", "tris", "all", "edges", "ms");
        print_points(duel);
    }
    std::printf("\n%d thread%s\n", threads, threads == 1 ? "" : "s");
    print_table(duels);
    std::printf("\n");
    for (const smooth_measure& measure : smooth_measures)
        for (const smooth_rival rival : smooth_rivals)
            print_ratios(duels, rival, measure);
    std::fflush(stdout);
}

std::FILE* open_csv(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    if (!file)
        throw std::runtime_error("cannot write " + path);
    std::fputs("threads,view,width,height,rival,side,tolerance_px,triangles,rms_all,rms_edges,"
               "ms,least_ms\n",
               file);
    return file;
}

void write_csv(std::FILE* file, std::span<const smooth_duel> duels, int threads) {
    for (const smooth_duel& duel : duels) {
        constexpr std::array short_names{"llvmpipe_samples", "llvmpipe_pixels", "embree"};
        const char* const rival = short_names[static_cast<std::size_t>(duel.rival)];
        const auto write = [&](const char* side, const std::vector<smooth_point>& points) {
            for (const smooth_point& p : points)
                std::fprintf(file, "%d,%s,%d,%d,%s,%s,%g,%zu,%g,%g,%g,%g\n", threads,
                             duel.of->view->name, size.width, size.height, rival, side, p.tolerance,
                             p.triangles, p.error.all, p.error.edges, p.ms, p.least_ms);
        };
        write("l3d", duel.ours);
        write(rival, duel.theirs);
    }
}

/// What the processors were busy with besides.
double load() {
    double of_a_minute = 0;
    getloadavg(&of_a_minute, 1);
    return of_a_minute;
}

void run(const std::string& path, const std::string& folder) {
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    if (!model)
        throw std::runtime_error(why);
    std::FILE* const csv = path.empty() ? nullptr : open_csv(path);
    std::vector<smooth_scenery> sceneries;
    for (const bench_view& view : bench_views) {
        const auto& of = sceneries.emplace_back(
            smooth_scenery{&view, size, smooth_judge(*model, view, size, folder), {}, {}});
        std::printf("%s: %zu pixels shown, %zu of them at edges; the exact picture is unsure of "
                    "%.3f levels there\n",
                    view.name, of.judge.shown(), of.judge.edges(), of.judge.unsure());
    }
    make_meshes(*model, sceneries);
    std::printf("l3d %s against %s, anti-aliased; errors: root mean squares in levels; medians of "
                "frames, a few in turn\n",
                l3d_real_name(), peer_names().c_str());
    for (const int threads : {1, 2}) {
        const double before = load();
        const auto duels = measured_duels(*model, sceneries, our_tolerances, threads);
        check(duels);
        print(duels, threads);
        std::printf("load before: %.1f, after: %.1f\n", before, load());
        if (csv)
            write_csv(csv, duels, threads);
    }
    if (csv && std::fclose(csv) != 0)
        throw std::runtime_error("cannot write " + path);
}

} // namespace

/// Usage: peers_antialias_bench [--antialias-csv=path]. The exact pictures are kept beside the
/// program, in the folder `exact`.
int main(int argc, char** argv) try {
    run(csv_path(argc, argv), (std::filesystem::path(argv[0]).parent_path() / "exact").string());
} catch (const std::exception& error) {
    std::fprintf(stderr, "peers_antialias_bench: %s\n", error.what());
    return 1;
}
