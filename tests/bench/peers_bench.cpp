// SPDX-License-Identifier: MIT
// l3d against Mesa's llvmpipe and against Embree at equal measured error, one thread against one
// and two against two.
//
// All draw the same view into memory, in turn, and medians are compared. A cell of the table is a
// view, a size and an error in pixels: ours gets the largest tolerance with which what it draws is
// within that error of the exact surface, the peers get the triangle mesh that is fastest for
// them of several that are within it: uniform, adaptive, and adaptive thinned out, all made for
// this very view, without what is outside of the window, in static buffers, with the shading
// baked into the vertices. Ours starts each frame from the patches and shades each pixel.
#include "bench/bench_cell.h"
#include "bench/peer_timing.h"
#include "geom/teapot.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct options {
    bool quick = false;
    std::string csv;

    /// What is not known is for the other benchmarks, which are run with the same arguments.
    options(int argc, char** argv) {
        for (int i = 1; i < argc; ++i) {
            const std::string_view argument = argv[i];
            constexpr std::string_view csv_option = "--csv=";
            if (argument == "--quick")
                quick = true;
            else if (argument.starts_with(csv_option))
                csv = argument.substr(csv_option.size());
        }
    }
};

void print_head(int threads) {
    std::printf("\n%d thread%s\n", threads, threads == 1 ? "" : "s");
    std::printf("%-28s | %-33s | %-46s | %-32s\n", "", "l3d", "llvmpipe", "Embree");
    std::printf("%-8s %10s %5s  | %6s %6s %6s %8s  | %-9s %7s %6s %2s %8s %7s | %-9s %7s %8s %6s "
                "| %s\n",
                "view", "size", "px", "tol", "bound", "error", "ms", "mesh", "tris", "error", "w",
                "ms", "ratio", "mesh", "tris", "ms", "ratio", "pixels differ");
}

void print_row(const bench_cell& cell, const cell_times& times) {
    const peer_mesh &mesa = cell.meshes[times.mesa.mesh], &embree = cell.meshes[times.embree.mesh];
    std::printf("%-8s %5dx%-4d %5.2f  | %6.3f %6.3f %6.3f %8.3f  | %-9s %7zu %6.3f %2d %8.3f %7.2f "
                "| %-9s %7zu %8.3f %6.2f | %ld %ld of %ld\n",
                cell.view->name, cell.size.width, cell.size.height, cell.error, cell.our_tolerance,
                cell.our_bound, cell.our_error, times.ours_ms, mesa.kind.c_str(), mesa.triangles(),
                mesa.error, times.mesa.mesa_threads, times.mesa_ms, times.mesa_ms / times.ours_ms,
                embree.kind.c_str(), embree.triangles(), times.embree_ms,
                times.embree_ms / times.ours_ms, times.mesa_differs, times.embree_differs,
                times.covered);
}

void print_ratios(const char* peer, std::vector<double> ratios) {
    std::ranges::sort(ratios);
    std::printf("%-8s least ratio %6.2f, median %6.2f\n", peer, ratios.front(),
                ratios[ratios.size() / 2]);
}

/// The table of one number of threads.
void print(std::span<const bench_cell> cells, std::span<const cell_times> times, int threads) {
    print_head(threads);
    std::vector<double> mesa, embree;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        print_row(cells[i], times[i]);
        mesa.push_back(times[i].mesa_ms / times[i].ours_ms);
        embree.push_back(times[i].embree_ms / times[i].ours_ms);
    }
    print_ratios("llvmpipe", mesa);
    print_ratios("Embree", embree);
    const long culled = std::ranges::min(times, {}, &cell_times::culled).culled;
    std::printf("llvmpipe draws both sides: without one it would lose %ld pixels or more\n", culled);
}

void write_csv(std::FILE* file, std::span<const bench_cell> cells,
               std::span<const cell_times> times, int threads) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bench_cell& c = cells[i];
        const cell_times& t = times[i];
        const peer_mesh &mesa = c.meshes[t.mesa.mesh], &embree = c.meshes[t.embree.mesh];
        std::fprintf(file, "%d,%s,%d,%d,%g,%g,%g,%g,%g,%s,%zu,%g,%d,%g,%g,%s,%zu,%g,%g\n", threads,
                     c.view->name, c.size.width, c.size.height, c.error, c.our_tolerance,
                     c.our_bound, c.our_error, t.ours_ms, mesa.kind.c_str(), mesa.triangles(),
                     mesa.error, t.mesa.mesa_threads, t.mesa_ms, t.mesa_ms / t.ours_ms,
                     embree.kind.c_str(), embree.triangles(), t.embree_ms,
                     t.embree_ms / t.ours_ms);
    }
}

std::FILE* open_csv(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    if (!file)
        throw std::runtime_error("cannot write " + path);
    std::fputs("threads,view,width,height,error_px,l3d_tolerance,l3d_bound,l3d_error,l3d_ms,"
               "llvmpipe_mesh,llvmpipe_triangles,llvmpipe_error,llvmpipe_workers,llvmpipe_ms,"
               "llvmpipe_ratio,embree_mesh,embree_triangles,embree_ms,embree_ratio\n",
               file);
    return file;
}

void run(const options& wanted) {
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    if (!model)
        throw std::runtime_error(why);
    std::vector<l3d_size> sizes{{640, 480}, {1024, 768}, {1920, 1080}};
    if (wanted.quick)
        sizes = {{1024, 768}};
    std::FILE* const csv = wanted.csv.empty() ? nullptr : open_csv(wanted.csv);

    std::printf("l3d %s against %s\n", l3d_real_name(), peer_names().c_str());
    constexpr std::array errors{0.5, 0.25, 0.1};
    const auto cells = planned_cells(*model, sizes, errors);
    for (const int threads : {1, 2}) {
        const auto times = compare(*model, cells, threads);
        print(cells, times, threads);
        if (csv)
            write_csv(csv, cells, times, threads);
    }
    std::printf("\n");
    for (const l3d_size size : sizes)
        std::printf("clearing colour and depth of %dx%d: %.3f ms\n", size.width, size.height,
                    clearing_ms(size));
    if (csv && std::fclose(csv) != 0)
        throw std::runtime_error("cannot write " + wanted.csv);
}

} // namespace

/// Usage: peers_bench [--quick] [--csv=path].
int main(int argc, char** argv) try {
    run(options(argc, argv));
} catch (const std::exception& error) {
    std::fprintf(stderr, "peers_bench: %s\n", error.what());
    return 1;
}
