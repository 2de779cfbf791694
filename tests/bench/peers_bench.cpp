// SPDX-License-Identifier: MIT
// l3d against Mesa's llvmpipe and against Embree at equal measured error, one thread against one
// and two against two.
//
// All draw the same view into memory, a few frames in turn, and medians are compared. A cell of the
// table is a view, a size and an error in pixels. Ours gets the largest tolerance with which what
// it draws is within that error of the exact surface. The peers get triangle meshes that are within
// it too, made beforehand for this very view, without what is outside of the window. These lie in
// static buffers, with the shading baked into the vertices. There are adaptive ones, and the same
// thinned out for as long as the error allows. Ours starts each frame from the patches and shades
// each pixel (lambert) or, as the peers do, each vertex (gouraud).
#include "bench/bench_cell.h"
#include "bench/cad_peers.h"
#include "bench/peer_timing.h"
#include "geom/nurbs_surface.h"
#include "geom/teapot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct options {
    bool quick = false, hull = false, cad = false;
    std::string csv;
    std::vector<std::string> files;

    /// What is not known is for the other benchmarks, which are run with the same arguments.
    options(int argc, char** argv) {
        for (int i = 1; i < argc; ++i) {
            const std::string_view argument = argv[i];
            constexpr std::string_view csv_option = "--csv=";
            if (argument == "--quick")
                quick = true;
            else if (argument == "--hull")
                hull = true;
            else if (argument == "--cad")
                cad = true;
            else if (argument.starts_with(csv_option))
                csv = argument.substr(csv_option.size());
            else if (cad && !argument.starts_with('-'))
                files.emplace_back(argument);
        }
    }
};

/// Theirs to ours.
double ratio(const frame_times& theirs, const frame_times& ours) {
    return theirs.median / ours.median;
}

void print_head(int threads) {
    std::printf("\n%d thread%s\n%-23s | %-35s | %-62s | %-47s |\n", threads,
                threads == 1 ? "" : "s", "", "l3d: lambert, gouraud",
                "llvmpipe; ratio to lambert, to gouraud", "Embree; ratio to lambert, to gouraud");
    std::printf("%-7s %9s %5s | %5s %5s %5s %8s %8s | %-8s %6s %5s %7s %4s %8s %8s %8s | "
                "%-8s %6s %4s %8s %8s %8s | %s\n",
                "view", "size", "px", "tol", "bound", "error", "ms", "ms", "mesh", "tris", "error",
                "workers", "bits", "ms", "ratio", "ratio", "mesh", "tris", "rays", "ms", "ratio",
                "ratio", "pixels differ");
}

void print_row(const bench_cell& cell, const cell_times& times) {
    const peer_mesh& mesa = cell.meshes[times.mesa_way.mesh];
    const peer_mesh& embree = cell.meshes[times.embree_way.mesh];
    std::printf("%-7s %4dx%-4d %5.2f | %5.3f %5.3f %5.3f %8.3f %8.3f | ", cell.view->name,
                cell.size.width, cell.size.height, cell.error, cell.our_tolerance, cell.our_bound,
                cell.our_error, times.lambert.median, times.gouraud.median);
    std::printf("%-8s %6zu %5.3f %7d %4d %8.3f %8.2f %8.2f | ", mesa.kind.c_str(), mesa.triangles(),
                mesa.error, times.mesa_way.mesa_threads, times.mesa_way.mesa_bits,
                times.mesa.median, ratio(times.mesa, times.lambert),
                ratio(times.mesa, times.gouraud));
    std::printf("%-8s %6zu %4d %8.3f %8.2f %8.2f | %ld %ld of %ld\n", embree.kind.c_str(),
                embree.triangles(), times.embree_way.embree_rays, times.embree.median,
                ratio(times.embree, times.lambert), ratio(times.embree, times.gouraud),
                times.mesa_differs, times.embree_differs, times.covered);
}

void print_ratios(const char* peer, const char* shade, std::span<const cell_times> times,
                  frame_times cell_times::*theirs, frame_times cell_times::*ours) {
    const auto print_some = [&](const char* which, double frame_times::*number) {
        std::vector<double> ratios;
        for (const cell_times& t : times)
            ratios.push_back((t.*theirs).*number / ((t.*ours).*number));
        std::ranges::sort(ratios);
        std::printf("%s least %.2f, median %.2f", which, ratios.front(), ratios[ratios.size() / 2]);
    };
    std::printf("%-8s to %s:", peer, shade);
    print_some("", &frame_times::median);
    print_some("; of the fastest frames:", &frame_times::least);
    print_some("; of the first of each turn:", &frame_times::first);
    std::printf("\n");
}

/// The table of one kind of mesh and one number of threads.
void print(std::span<const bench_cell> cells, std::span<const cell_times> times, int threads) {
    print_head(threads);
    for (std::size_t i = 0; i < cells.size(); ++i)
        print_row(cells[i], times[i]);
    print_ratios("llvmpipe", "lambert", times, &cell_times::mesa, &cell_times::lambert);
    print_ratios("llvmpipe", "gouraud", times, &cell_times::mesa, &cell_times::gouraud);
    print_ratios("Embree", "lambert", times, &cell_times::embree, &cell_times::lambert);
    print_ratios("Embree", "gouraud", times, &cell_times::embree, &cell_times::gouraud);
    const long lost = std::ranges::min(times, {}, &cell_times::culled).culled;
    if (lost > 0)
        std::printf("llvmpipe culls nothing: it would lose at least %ld pixels\n", lost);
}

void write_csv(std::FILE* file, std::span<const bench_cell> cells,
               std::span<const cell_times> times, int threads) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const bench_cell& c = cells[i];
        const cell_times& t = times[i];
        const peer_mesh &mesa = c.meshes[t.mesa_way.mesh], &embree = c.meshes[t.embree_way.mesh];
        std::fprintf(file, "%d,%s,%d,%d,%g,%g,%g,%g,%g,%g,%g,%g,", threads, c.view->name,
                     c.size.width, c.size.height, c.error, c.our_tolerance, c.our_bound,
                     c.our_error, t.lambert.median, t.lambert.least, t.gouraud.median,
                     t.gouraud.least);
        std::fprintf(file, "%s,%zu,%g,%d,%g,%g,", mesa.kind.c_str(), mesa.triangles(), mesa.error,
                     t.mesa_way.mesa_threads, t.mesa.median, t.mesa.least);
        std::fprintf(file, "%s,%zu,%g,%g,", embree.kind.c_str(), embree.triangles(),
                     t.embree.median, t.embree.least);
        std::fprintf(file, "%g,%g,%g,%g,%d,%d\n", t.lambert.first, t.gouraud.first, t.mesa.first,
                     t.embree.first, t.embree_way.embree_rays, t.mesa_way.mesa_bits);
    }
}

std::FILE* open_csv(const std::string& path) {
    std::FILE* const file = std::fopen(path.c_str(), "w");
    if (!file)
        throw std::runtime_error("cannot write " + path);
    std::fputs(
        "threads,view,width,height,error_px,l3d_tolerance,l3d_bound,l3d_error,l3d_ms,"
        "l3d_least_ms,l3d_gouraud_ms,l3d_gouraud_least_ms,llvmpipe_mesh,llvmpipe_triangles,"
        "llvmpipe_error,llvmpipe_workers,"
        "llvmpipe_ms,llvmpipe_least_ms,embree_mesh,embree_triangles,embree_ms,"
        "embree_least_ms,l3d_first_ms,l3d_gouraud_first_ms,llvmpipe_first_ms,embree_first_ms,"
        "embree_rays,llvmpipe_bits\n",
        file);
    return file;
}

/// The cells, with a mesh of one kind alone for the peers.
std::vector<bench_cell> with_one_mesh(std::vector<bench_cell> cells, std::size_t kind) {
    for (bench_cell& cell : cells)
        cell.meshes = {cell.meshes[kind]};
    return cells;
}

/// A ship's hull of 20 by 20 rational patches of degree 5 by 5, from the deck at one side round the
/// keel to the other. It is 8 units long and pointed at both ends.
l3d_patch_model hull() {
    constexpr std::size_t along = 25;
    const l3d_bspline_direction direction = l3d_bspline_direction::clamped(5, along);
    std::vector<l3d_nurbs_surface::vector> points;
    std::vector<double> weights;
    for (std::size_t row = 0; row < along; ++row)
        for (std::size_t column = 0; column < along; ++column) {
            const double u = 2.0 * static_cast<double>(column) / (along - 1) - 1;
            const double v = 2.0 * static_cast<double>(row) / (along - 1) - 1;
            const double full = 1 - std::pow(u, 4), flare = 0.6 + 0.5 * u * u;
            const double up = std::pow(std::abs(v), 1.5);
            points.push_back({4 * u * (0.85 + 0.15 * up), 1.6 * up - 0.8 + 0.3 * u * u,
                              std::copysign(full * std::pow(std::abs(v), flare), v)});
            weights.push_back(1 + 0.3 * std::cos(5 * u) * std::cos(3 * v));
        }
    return l3d_patch_model::from_surfaces(
        std::array{l3d_nurbs_surface(direction, direction, points, weights)});
}

constexpr l3d_vector<double, 3> above{0.0, 1.0, 0.0};
const std::array<bench_view, 2> hull_views{{
    {"abeam", {{2.5, 2.0, 9.5}, {0.0, 0.0, 0.0}, above, 45, 0.1, 1e13}},
    {"bow", {{7.5, 1.5, 3.5}, {1.5, 0.1, 0.0}, above, 45, 0.1, 1e13}},
}};

l3d_patch_model teapot() {
    std::string why;
    const auto model = l3d_patch_model::from_bpt(l3d_teapot_bpt(), "teapot.bpt", why);
    if (!model)
        throw std::runtime_error(why);
    return *model;
}

void run(const options& wanted) {
    const l3d_patch_model model = wanted.hull ? hull() : teapot();
    const std::span<const bench_view> views =
        wanted.hull ? std::span<const bench_view>(hull_views) : bench_views;
    std::vector<l3d_size> sizes{{640, 480}, {1024, 768}, {1920, 1080}};
    if (wanted.quick)
        sizes = {{1024, 768}};
    std::FILE* const csv = wanted.csv.empty() ? nullptr : open_csv(wanted.csv);

    double load = 0;
    getloadavg(&load, 1);
    std::printf("l3d %s against %s; medians of frames, a few in turn; load before: %.1f\n",
                l3d_real_name(), peer_names().c_str(), load);
    constexpr std::array errors{0.5, 0.25, 0.1};
    const auto planned = planned_cells(model, views, sizes, errors);
    for (std::size_t kind = 0; kind < planned.front().meshes.size(); ++kind) {
        const auto cells = with_one_mesh(planned, kind);
        for (const int threads : {1, 2}) {
            const auto times = compare(model, cells, threads);
            print(cells, times, threads);
            if (csv)
                write_csv(csv, cells, times, threads);
        }
    }
    std::printf("\n");
    for (const l3d_size size : sizes)
        std::printf("clearing colour and depth of %dx%d: %.3f ms\n", size.width, size.height,
                    clearing_ms(size));
    if (csv && std::fclose(csv) != 0)
        throw std::runtime_error("cannot write " + wanted.csv);
}

} // namespace

/// Usage: peers_bench [--quick] [--hull] [--csv=path], or peers_bench --cad [--quick]
/// [file.step...]. The hull of a ship is drawn instead of the teapot. With --cad, Open CASCADE
/// makes the peer's meshes.
int main(int argc, char** argv) try {
    const options wanted(argc, argv);
    if (wanted.cad)
        compare_cad(wanted.files, wanted.quick);
    else
        run(wanted);
} catch (const std::exception& error) {
    std::fprintf(stderr, "peers_bench: %s\n", error.what());
    return 1;
}
