// SPDX-License-Identifier: MIT
// l3d against Mesa's llvmpipe and against Embree where their pictures are as wrong as ours.
//
// The picture's error is the root mean square of its differences in grey levels from the exact
// picture. So errors of place, depth and shade count by what they do to pixels. It is taken over
// all pixels, where outlines weigh most, and over those inside one surface, where shade weighs
// most. For either, the peers get the mesh with which their picture is as wrong as ours. All is
// timed as in peers_bench; ours is lambert.
#include "bench/peer_timing.h"
#include "bench/picture_plan.h"
#include "geom/teapot.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

/// Where the table shall go, too. What is not known is for the other benchmarks, which are run with
/// the same arguments.
std::string csv_path(int argc, char** argv) {
    constexpr std::string_view csv_option = "--picture-csv=";
    for (int i = 1; i < argc; ++i)
        if (const std::string_view argument = argv[i]; argument.starts_with(csv_option))
            return std::string(argument.substr(csv_option.size()));
    return "";
}

/// A peer's side of a line.
struct peer_line {
    const char* name;
    picture_error error;
    double ms, ratio;
};

struct line {
    const picture_cell& of;
    const cell_times& times;

    std::array<peer_line, 2> peers() const {
        return {{{"llvmpipe", of.theirs.llvmpipe, times.mesa.median, ratio(times.mesa)},
                 {"Embree", of.theirs.embree, times.embree.median, ratio(times.embree)}}};
    }
    const peer_mesh& mesh() const { return of.cell.meshes.front(); }

private:
    double ratio(const frame_times& theirs) const { return theirs.median / times.lambert.median; }
};

void print_line(const line& l) {
    const bench_cell& cell = l.of.cell;
    std::printf("%-7s %4dx%-4d %5.2f %-6s | %5.3f %6.2f %6.3f %7.3f | %7zu %5.3f |",
                cell.view->name, cell.size.width, cell.size.height, cell.our_tolerance,
                l.of.measure->name, cell.our_bound, l.of.ours.all, l.of.ours.inside,
                l.times.lambert.median, l.mesh().triangles(), l.mesh().error);
    for (const peer_line& p : l.peers())
        std::printf(" %6.2f %6.3f %7.3f %s%6.2f |", p.error.all, p.error.inside, p.ms,
                    l.of.theirs.reached ? " " : ">", p.ratio);
    std::printf("\n");
}

/// Least and median of a peer's ratios over the lines of one measure.
void print_ratios(std::span<const line> lines, const picture_measure& measure, std::size_t peer) {
    std::vector<double> ratios;
    const char* name = "";
    std::size_t not_reached = 0;
    for (const line& l : lines)
        if (l.of.measure == &measure) {
            const peer_line p = l.peers()[peer];
            ratios.push_back(p.ratio);
            name = p.name;
            not_reached += !l.of.theirs.reached;
        }
    std::ranges::sort(ratios);
    std::printf("%-8s over %-6s: least %.2f, median %.2f, most %.2f of %zu lines; in %zu of them "
                "no mesh is as near to the exact picture\n",
                name, measure.name, ratios.front(),
                (ratios[(ratios.size() - 1) / 2] + ratios[ratios.size() / 2]) / 2, ratios.back(),
                ratios.size(), not_reached);
}

void print(std::span<const line> lines, int threads) {
    std::printf("\n%d thread%s; errors: root mean squares over all pixels and inside one surface; "
                "> where the peer's picture is worse than ours with any mesh\n",
                threads, threads == 1 ? "" : "s");
    std::printf("%-30s | %-28s | %-13s | %-30s | %-30s |\n", "", "l3d", "mesh", "llvmpipe",
                "Embree");
    std::printf("%-7s %9s %5s %-6s | %5s %6s %6s %7s | %7s %5s |", "view", "size", "px", "over",
                "bound", "all", "inside", "ms", "tris", "px");
    for (int peer = 0; peer < 2; ++peer)
        std::printf(" %6s %6s %7s %7s |", "all", "inside", "ms", "ratio");
    std::printf("\n");
    for (const line& l : lines)
        print_line(l);
    for (const picture_measure& measure : picture_measures)
        for (const std::size_t peer : {std::size_t{0}, std::size_t{1}})
            print_ratios(lines, measure, peer);
}

void write_csv(std::FILE* file, std::span<const line> lines, int threads) {
    for (const line& l : lines) {
        const bench_cell& cell = l.of.cell;
        std::fprintf(file, "%d,%s,%d,%d,%g,%s,%g,%g,%g,%g,%zu,%g,%d", threads, cell.view->name,
                     cell.size.width, cell.size.height, cell.our_tolerance, l.of.measure->name,
                     cell.our_bound, l.of.ours.all, l.of.ours.inside, l.times.lambert.median,
                     l.mesh().triangles(), l.mesh().error, l.of.theirs.reached);
        for (const peer_line& p : l.peers())
            std::fprintf(file, ",%g,%g,%g", p.error.all, p.error.inside, p.ms);
        std::fprintf(file, "\n");
    }
}

std::FILE* open_csv(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    if (!file)
        throw std::runtime_error("cannot write " + path);
    std::fputs("threads,view,width,height,l3d_tolerance,equal_over,l3d_bound,l3d_all,l3d_inside,"
               "l3d_ms,triangles,mesh_error_px,reached,llvmpipe_all,llvmpipe_inside,llvmpipe_ms,"
               "embree_all,embree_inside,embree_ms\n",
               file);
    return file;
}

void run(const std::string& path) {
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    if (!model)
        throw std::runtime_error(why);
    std::FILE* const csv = path.empty() ? nullptr : open_csv(path);

    double load = 0;
    getloadavg(&load, 1);
    std::printf("l3d %s against %s, pictures equally wrong; medians of frames, a few in turn; load "
                "before: %.1f\n",
                l3d_real_name(), peer_names().c_str(), load);
    constexpr std::array tolerances{1.0, 0.5, 0.25, 0.1};
    const auto planned = planned_pictures(*model, {1024, 768}, tolerances);
    std::vector<bench_cell> cells;
    for (const picture_cell& p : planned)
        cells.push_back(p.cell);
    for (const int threads : {1, 2}) {
        const auto times = compare(*model, cells, threads);
        std::vector<line> lines;
        for (std::size_t i = 0; i < planned.size(); ++i)
            lines.push_back({planned[i], times[i]});
        print(lines, threads);
        if (csv)
            write_csv(csv, lines, threads);
    }
    if (csv && std::fclose(csv) != 0)
        throw std::runtime_error("cannot write " + path);
}

} // namespace

/// Usage: peers_picture_bench [--picture-csv=path].
int main(int argc, char** argv) try {
    run(csv_path(argc, argv));
} catch (const std::exception& error) {
    std::fprintf(stderr, "peers_picture_bench: %s\n", error.what());
    return 1;
}
