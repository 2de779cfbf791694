// SPDX-License-Identifier: MIT
// compare_cad: meshes as coarse as the error allows, time to the first picture, and frames.
#include "bench/cad_peers.h"

#include "bench/cad_shape.h"
#include "bench/child_process.h"
#include "bench/mesa_peer.h"
#include "bench/peer_timing.h"
#include "geom/files/model_file.h"
#include "processor_time.h"
#include "tool_2d/text_file.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

namespace {

constexpr l3d_size size{1024, 768};
constexpr double wanted_px = 0.25;    // our own usual tolerance
constexpr double deep = 100;          // times as large as all of it
constexpr int repeats = 5;            // of what happens once in a program
constexpr double turn_of_frame = 0.1; // degrees
constexpr double enough = 3000;       // milliseconds
constexpr double most_for_deep = 100; // milliseconds of the mesher for all of it

/// What something takes: the least of some times.
struct effort {
    double wall = std::numeric_limits<double>::infinity(); ///< milliseconds
    double processor = wall;                               ///< of this process and its children
};

double processor_ms() {
    rusage children{};
    getrusage(RUSAGE_CHILDREN, &children);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return 1e3 * (processor_seconds() + seconds(children.ru_utime) + seconds(children.ru_stime));
}

template <class Action> void take(effort& least, Action action) {
    const double processor = processor_ms();
    const auto start = std::chrono::steady_clock::now();
    action();
    const double wall =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    least.processor = std::min(least.processor, processor_ms() - processor);
    least.wall = std::min(least.wall, wall);
}

/// A file, a view of it, and the mesh for this view.
struct cad_cell {
    std::string name;
    bench_cell cell;
    cad_fineness fineness;
    cad_error error;
};

/// The efforts until a picture is there, and for those that follow.
struct cad_efforts {
    effort read, mesher, vertices, drawn; ///< theirs: the file, the mesh, the first frame
    effort loaded, model, frame;          ///< ours: the file and its records, the model, the frame
    effort their_later, our_later;        ///< frames that follow

    static constexpr std::array all{
        &cad_efforts::read,  &cad_efforts::mesher,      &cad_efforts::vertices,
        &cad_efforts::drawn, &cad_efforts::loaded,      &cad_efforts::model,
        &cad_efforts::frame, &cad_efforts::their_later, &cad_efforts::our_later};
    double theirs(double effort::*time) const {
        return mesher.*time + vertices.*time + drawn.*time;
    }
    /// Without what Open CASCADE needs to read the file.
    double ours(double effort::*time) const {
        return std::max(0.0, loaded.*time - read.*time) + model.*time + frame.*time;
    }
};

l3d_model_file read(const std::string& file) {
    std::string why;
    auto model = l3d_read_cad(l3d_read_text_file(file), file, why);
    if (!model)
        throw std::runtime_error(why);
    return *std::move(model);
}

l3d_patch_model model_of(const l3d_model_file& file, const std::string& name) {
    std::string why;
    auto model = l3d_patch_model::from_file(file, name, why);
    if (!model)
        throw std::runtime_error(why);
    return *std::move(model);
}

const l3d_vector<double, 3> light = l3d_normalized(l3d_usual_light);

/// The coarsest mesh that keeps the errors. The mesher's error falls in steps, so finer and finer
/// meshes are tried, a fifth apart.
void plan(cad_shape& shape, cad_cell& of) {
    const l3d_camera& camera = of.cell.view->camera;
    const double finer = std::pow(0.5, 0.25);
    cad_fineness& fineness = of.fineness;
    const auto is_good = [&] {
        shape.mesh(fineness);
        of.error = shape.error(camera, size, light);
        return of.error.places <= wanted_px;
    };
    for (fineness.deflection = 1.5 * wanted_px / camera.scale_at_target(size); !is_good();)
        fineness.deflection *= finer;
    peer_mesh& mesh = of.cell.meshes.emplace_back(shape.vertices(light));
    mesh.error = of.error.places;
}

/// The effort of a frame among frames that follow each other. draw() draws one.
template <class Draw> void take_frames(effort& least, Draw draw) {
    const auto frames = static_cast<int>(std::clamp(enough / 100 / least.wall, 1.0, 20.0));
    for (int turn = 0; turn < repeats; ++turn) {
        effort all;
        take(all, [&] {
            for (int i = 0; i < frames; ++i)
                draw();
        });
        least.wall = std::min(least.wall, all.wall / frames);
        least.processor = std::min(least.processor, all.processor / frames);
    }
}

/// A peer that draws a cell's mesh without backs. What a program does once, however many files it
/// opens, is done.
std::unique_ptr<mesa_peer> opened_peer(const cad_cell& of) {
    std::string why;
    auto peer = mesa_peer::open(why);
    if (!peer)
        throw std::runtime_error(why);
    peer->prepare(of.cell.meshes[0], of.cell.view->camera, size, mesa_peer::culling::back);
    peer->draw();
    return peer;
}

/// llvmpipe's best way to draw a cell.
peer_choice best_way(const cad_cell& of, int threads) {
    std::vector<peer_choice> ways = mesa_ways(threads);
    for (peer_choice& way : ways)
        way.ms = in_child(setting_of(way), [&] {
                     const auto peer = opened_peer(of);
                     effort least;
                     take(least, [&] { peer->draw(); });
                     take_frames(least, [&] { peer->draw(); });
                     return std::vector{threads > 1 ? least.wall : least.processor};
                 }).at(0);
    return *std::ranges::min_element(ways, {}, &peer_choice::ms);
}

/// Theirs, in a child in which llvmpipe draws in its best way.
void take_theirs(cad_shape& shape, const std::string& file, const cad_cell& of, int threads,
                 cad_efforts& to) {
    const auto peer = opened_peer(of);
    cad_fineness fineness = of.fineness;
    fineness.in_parallel = threads > 1;
    for (int i = 0; i == 0 || (i < repeats && to.mesher.wall * i < enough); ++i) {
        take(to.read, [&] { const cad_shape again(file); });
        take(to.mesher, [&] { shape.mesh(fineness); });
        peer_mesh mesh;
        take(to.vertices, [&] { mesh = shape.vertices(light); });
        take(to.drawn, [&] {
            peer->prepare(mesh, of.cell.view->camera, size, mesa_peer::culling::back);
            peer->draw();
        });
    }
    take(to.their_later, [&] { peer->draw(); });
    take_frames(to.their_later, [&] { peer->draw(); });
}

void take_ours(const std::string& file, const bench_view& view, int threads, cad_efforts& to) {
    for (int i = 0; i == 0 || (i < repeats && to.frame.wall * i < enough); ++i) {
        std::optional<l3d_model_file> records;
        std::optional<l3d_patch_model> model;
        std::optional<bench_frame> ours;
        take(to.loaded, [&] { records = read(file); });
        take(to.model, [&] { model = model_of(*records, file); });
        take(to.frame, [&] {
            ours.emplace(*model, view, size, wanted_px, threads, l3d_shade::gouraud);
            ours->draw();
        });
        take(to.our_later, [&] { ours->draw(); });
        take_frames(to.our_later, [&] { ours->draw(); });
    }
}

/// The part of the pixels that are covered in one of both pictures alone or have greys that are far
/// apart.
double difference(const cad_cell& of, const l3d_patch_model& model) {
    constexpr int far_apart = 32;
    return in_child({},
                    [&] {
                        const auto peer = opened_peer(of);
                        const std::vector<std::uint8_t> theirs = peer->picture();
                        bench_frame ours(model, *of.cell.view, size, wanted_px, 1,
                                         l3d_shade::gouraud);
                        ours.hash();
                        double covered = 0, differ = 0;
                        for (int y = 0; y < size.height; ++y)
                            for (int x = 0; x < size.width; ++x) {
                                const auto column = static_cast<std::size_t>(x);
                                const int a = static_cast<int>(ours.pixels().row(y)[column] & 0xff);
                                const int b = theirs[static_cast<std::size_t>(y * size.width + x)];
                                covered += a != 0;
                                differ += (a != 0) != (b != 0) || std::abs(a - b) > far_apart;
                            }
                        return std::vector{differ / std::max(covered, 1.0)};
                    })
        .at(0);
}

/// Both, each in a child of its own.
cad_efforts efforts_of(cad_shape& shape, const std::string& file, const cad_cell& of, int threads) {
    cad_efforts result;
    const auto in_own_child = [&](const child_setting& setting, auto work) {
        const std::vector<double> numbers = in_child(setting, [&] {
            cad_efforts measured;
            work(measured);
            std::vector<double> all;
            for (const auto part : cad_efforts::all)
                all.insert(all.end(), {(measured.*part).wall, (measured.*part).processor});
            return all;
        });
        for (std::size_t i = 0; i < cad_efforts::all.size(); ++i) {
            effort& least = result.*cad_efforts::all[i];
            least.wall = std::min(least.wall, numbers.at(2 * i));
            least.processor = std::min(least.processor, numbers.at(2 * i + 1));
        }
    };
    in_own_child(setting_of(best_way(of, threads)),
                 [&](cad_efforts& to) { take_theirs(shape, file, of, threads, to); });
    in_own_child({}, [&](cad_efforts& to) { take_ours(file, *of.cell.view, threads, to); });
    return result;
}

/// A view of all of a model from the side of x, y and z, and one of a round edge of it, larger.
std::array<bench_view, 2> views_of(const cad_shape& shape, const l3d_patch_model& model) {
    l3d_camera whole;
    whole.eye = {0.5, -1.0, 0.7};
    whole.up = {0.0, 0.0, 1.0};
    whole = l3d_framed(whole, size, l3d_reach_of(l3d_patch_scene(model)));
    l3d_camera near = whole;
    const auto place = shape.round_edge_near(whole.eye);
    near.target = place;
    near.approach(1 / deep, place);
    near.near_z = l3d_length(near.eye - place) / 100;
    return {{{"whole", whole, turn_of_frame, true}, {"deep", near, turn_of_frame / deep, true}}};
}

void print_head() {
    std::printf("milliseconds of the processor, with two threads by the clock; ratios: theirs / "
                "ours\n%-7s %-5s %2s | %8s %6s %6s | %8s %8s %8s %8s | %8s %8s %8s %8s %6s | "
                "%8s %8s %6s | %s | %s\n",
                "shape", "view", "th", "tris", "px", "levels", "mesher", "normals", "drawn", "sum",
                "records", "model", "drawn", "sum", "ratio", "llvmpipe", "l3d", "ratio", "reading",
                "pixels differ");
}

void print_row(const cad_cell& of, const cad_efforts& f, int threads, double differ) {
    const auto time = threads > 1 ? &effort::wall : &effort::processor;
    std::printf("%-7s %-5s %2d | %8zu %6.3f %6.2f | %8.1f %8.1f %8.1f %8.1f | ", of.name.c_str(),
                of.cell.view->name, threads, of.cell.meshes[0].triangles(), of.error.places,
                of.error.shades, f.mesher.*time, f.vertices.*time, f.drawn.*time, f.theirs(time));
    std::printf("%8.1f %8.1f %8.1f %8.1f %6.2f | %8.3f %8.3f %6.2f | %.0f | %.2f %%\n",
                std::max(0.0, f.loaded.*time - f.read.*time), f.model.*time, f.frame.*time,
                f.ours(time), f.theirs(time) / f.ours(time), f.their_later.*time, f.our_later.*time,
                f.their_later.*time / (f.our_later.*time), f.read.*time, 100 * differ);
    std::fflush(stdout);
}

void compare_file(const std::string& file, bool quick) {
    cad_shape shape(file);
    const l3d_patch_model model = model_of(read(file), file);
    double mesher_ms = 0;
    for (const bench_view& view : views_of(shape, model)) {
        // A mesh for the nearer view is ten to a hundred times as large.
        if (mesher_ms > most_for_deep)
            continue;
        cad_cell of;
        of.name = std::filesystem::path(file).stem();
        of.cell.view = &view;
        of.cell.size = size;
        of.cell.our_tolerance = wanted_px;
        plan(shape, of);
        const double differ = difference(of, model);
        for (int threads = 1; threads <= (quick ? 1 : 2); ++threads) {
            const cad_efforts all = efforts_of(shape, file, of, threads);
            print_row(of, all, threads, differ);
            mesher_ms = std::max(mesher_ms, all.mesher.processor);
        }
    }
}

} // namespace

void compare_cad(std::span<const std::string> asked, bool quick) {
    cad_shape::expect_open_cascade();
    // The plug-in lies where programs look for it, and this one lies in tests/bench.
    const auto program = std::filesystem::read_symlink("/proc/self/exe");
    setenv("L3D_PLUGIN_PATH", (program.parent_path() / "../../lib/l3d").c_str(), 0);
    std::vector<std::string> files(asked.begin(), asked.end());
    const auto folder =
        std::filesystem::temp_directory_path() / ("l3d_cad_peers_" + std::to_string(getpid()));
    if (files.empty()) {
        std::filesystem::create_directory(folder);
        files = cad_shape::write_examples(folder);
    }
    print_head();
    for (const std::string& file : files)
        compare_file(file, quick);
    std::filesystem::remove_all(folder);
}
