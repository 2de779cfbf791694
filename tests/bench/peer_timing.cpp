// SPDX-License-Identifier: MIT
// compare: trying, then timing in turn.
#include "bench/peer_timing.h"

#include "bench/child_process.h"
#include "bench/embree_peer.h"
#include "bench/mesa_peer.h"
#include "raster/parallel/simd_target.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <stdexcept>

namespace {

/// Frames that are drawn but not counted, frames of a trial, frames of clearing.
constexpr int warm_up = 2, trial_frames = 5, clearing_frames = 31;

/// A side's frames in a turn beside its first, and turns. The first finds the caches full of
/// another's data and workers asleep, which an animation's next frame does not.
constexpr int frames_of_turn = 5, turns = 7;

/// A picture within a pixel of the truth differs along outlines alone: share of covered pixels. Its
/// greys, interpolated between other vertices, are that many levels apart elsewhere.
constexpr double most_different = 0.02;
constexpr int most_levels_apart = 32;

double median(std::vector<double> ms) {
    std::ranges::sort(ms);
    return ms[ms.size() / 2];
}

template <class Action> double milliseconds(Action action) {
    const auto start = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start)
        .count();
}

template <class Action> double median_of(int count, Action action) {
    std::vector<double> times;
    for (int i = 0; i < warm_up + count; ++i)
        if (const double ms = milliseconds(action); i >= warm_up)
            times.push_back(ms);
    return median(times);
}

/// The times of a side's frames.
class side_times {
public:
    /// draw() returns a frame's milliseconds.
    template <class Draw> void take_turn(Draw draw) {
        first_.push_back(draw());
        for (int i = 0; i < frames_of_turn; ++i)
            later_.push_back(draw());
    }

    frame_times summary() const {
        return {median(later_), std::ranges::min(later_), median(first_)};
    }

private:
    std::vector<double> first_, later_;
};

std::unique_ptr<mesa_peer> open_mesa() {
    std::string why;
    auto peer = mesa_peer::open(why);
    if (!peer)
        throw std::runtime_error(why);
    return peer;
}

std::unique_ptr<embree_peer> open_embree() {
    std::string why;
    auto peer = embree_peer::open(why);
    if (!peer)
        throw std::runtime_error(why);
    return peer;
}

bool is_of(const peer_choice& choice, const peer_choice& way) {
    return choice.mesa_threads == way.mesa_threads && choice.mesa_bits == way.mesa_bits;
}

/// Left to itself, llvmpipe uses vectors of 256 bits where the processor has 512, too.
std::vector<int> mesa_widths() {
    const std::string best = l3d_simd_targets().front();
    if (best == "AVX3")
        return {256, 512};
    return {best == "AVX2" ? 256 : 128};
}

/// A cell's mesh, drawn in some way.
struct trial {
    std::size_t cell;
    peer_choice way;
};

/// Every mesh of every cell, in each of some ways side by side: what disturbs one disturbs all.
std::vector<trial> trials_of(std::span<const bench_cell> cells, std::span<const peer_choice> ways) {
    std::vector<trial> trials;
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (std::size_t mesh = 0; mesh < cells[i].meshes.size(); ++mesh)
            for (peer_choice way : ways) {
                way.mesh = mesh;
                trials.push_back({i, way});
            }
    return trials;
}

/// Makes all trials in one child, and keeps the best of each cell. draw(trials) returns the
/// milliseconds of each.
template <class Draw>
void choose(const child_setting& setting, std::vector<trial> trials, std::vector<peer_choice>& best,
            Draw draw) {
    const std::vector<double> ms = in_child(setting, [&] { return draw(trials); });
    for (std::size_t k = 0; k < trials.size(); ++k) {
        peer_choice& known = best[trials[k].cell];
        trials[k].way.ms = ms.at(k);
        if (known.ms == 0 || trials[k].way.ms < known.ms)
            known = trials[k].way;
    }
}

/// llvmpipe reads its settings once in a process.
std::vector<peer_choice> best_of_mesa(std::span<const bench_cell> cells, int threads) {
    std::vector<peer_choice> best(cells.size());
    for (const peer_choice& way : mesa_ways(threads))
        choose(setting_of(way), trials_of(cells, {&way, 1}), best,
               [&](std::span<const trial> trials) {
                   const auto peer = open_mesa();
                   std::vector<double> ms;
                   for (const trial& t : trials) {
                       const bench_cell& cell = cells[t.cell];
                       peer->prepare(cell.meshes[t.way.mesh], cell.view->camera, cell.size,
                                     mesa_peer::culling::none);
                       ms.push_back(median_of(trial_frames, [&] { peer->draw(); }));
                   }
                   return ms;
               });
    return best;
}

std::vector<peer_choice> best_of_embree(std::span<const bench_cell> cells, int threads) {
    std::vector<peer_choice> best(cells.size());
    const std::array<peer_choice, 2> ways{{{.embree_rays = 8}, {.embree_rays = 16}}};
    choose({}, trials_of(cells, ways), best, [&](std::span<const trial> trials) {
        const auto peer = open_embree();
        l3d_workers workers(threads);
        std::vector<double> ms;
        for (const trial& t : trials) {
            const bench_cell& cell = cells[t.cell];
            peer->prepare(cell.meshes[t.way.mesh], cell.view->camera, cell.size, t.way.embree_rays);
            ms.push_back(median_of(trial_frames, [&] { peer->draw(workers); }));
        }
        return ms;
    });
    return best;
}

/// Pixels that are covered in one of two pictures only, or `levels` apart; nothing that is covered
/// is black.
template <class Ours, class Theirs>
long differences(l3d_size size, const Ours& ours, const Theirs& theirs, int levels) {
    long count = 0;
    for (int y = 0; y < size.height; ++y)
        for (int x = 0; x < size.width; ++x) {
            const int a = ours(x, y), b = theirs(x, y);
            count += (a != 0) != (b != 0) || std::abs(a - b) > levels;
        }
    return count;
}

auto greys_of(const l3d_pixels& pixels) {
    return [pixels](int x, int y) {
        return static_cast<int>(pixels.row(y)[static_cast<std::size_t>(x)] & 0xff);
    };
}

auto greys_of(const std::vector<std::uint8_t>& bytes, int width) {
    return [&bytes, width](int x, int y) {
        return int{bytes[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                         static_cast<std::size_t>(x)]};
    };
}

/// Both shadings of ours and the two peers in turn; in a child.
class cell_timer {
public:
    cell_timer(const l3d_patch_model& model, int threads)
        : scene_(model), threads_(threads), workers_(threads) {}

    void time(const bench_cell& cell, cell_times& times) {
        const peer_mesh& mesh = cell.meshes[times.mesa_way.mesh];
        const auto& camera = cell.view->camera;
        const auto culling = harmless_culling(mesh, cell, times.culled);
        mesa_->prepare(mesh, camera, cell.size, culling);
        embree_->prepare(cell.meshes[times.embree_way.mesh], camera, cell.size,
                         times.embree_way.embree_rays);

        bench_frame lambert(scene_, camera, cell.size, cell.our_tolerance, threads_);
        bench_frame gouraud(scene_, camera, cell.size, cell.our_tolerance, threads_,
                            l3d_shade::gouraud);
        side_times ours_lambert, ours_gouraud, mesa, embree;
        for (int turn = 0; turn < turns; ++turn) {
            ours_lambert.take_turn([&] { return lambert.draw(); });
            mesa.take_turn([&] { return milliseconds([&] { mesa_->draw(); }); });
            ours_gouraud.take_turn([&] { return gouraud.draw(); });
            embree.take_turn([&] { return milliseconds([&] { embree_->draw(workers_); }); });
        }
        times.lambert = ours_lambert.summary();
        times.gouraud = ours_gouraud.summary();
        times.mesa = mesa.summary();
        times.embree = embree.summary();

        lambert.hash();
        gouraud.hash();
        const auto ours = greys_of(gouraud.pixels());
        const auto black = [](int, int) { return 0; };
        constexpr int any = 255;
        // Lambert's quads keep shades, too, and so may have other outlines within the bound.
        const long shadings_differ = differences(cell.size, ours, greys_of(lambert.pixels()), any);
        times.covered = differences(cell.size, ours, black, any);
        times.mesa_differs = differences(
            cell.size, ours, greys_of(mesa_->picture(), cell.size.width), most_levels_apart);
        times.embree_differs =
            differences(cell.size, ours, greys_of(embree_->picture()), most_levels_apart);
        for (const long different : {shadings_differ, times.mesa_differs, times.embree_differs})
            if (static_cast<double>(different) >
                most_different * static_cast<double>(times.covered))
                throw std::runtime_error("the pictures differ");
    }

private:
    /// A side that llvmpipe can leave out without losing a pixel; `lost` is what it loses by the
    /// side that loses least.
    mesa_peer::culling harmless_culling(const peer_mesh& mesh, const bench_cell& cell, long& lost) {
        const auto picture = [&](mesa_peer::culling sides) {
            mesa_->prepare(mesh, cell.view->camera, cell.size, sides);
            mesa_->draw();
            return mesa_->picture();
        };
        const std::vector<std::uint8_t> whole = picture(mesa_peer::culling::none);
        auto best = mesa_peer::culling::none;
        lost = static_cast<long>(whole.size());
        for (const auto side : {mesa_peer::culling::back, mesa_peer::culling::front}) {
            const std::vector<std::uint8_t> culled = picture(side);
            long different = 0;
            for (std::size_t i = 0; i < whole.size(); ++i)
                different += whole[i] != culled[i];
            lost = std::min(lost, different);
            if (different == 0)
                best = side;
        }
        return best;
    }

    l3d_patch_scene scene_;
    int threads_;
    l3d_workers workers_;
    std::unique_ptr<mesa_peer> mesa_ = open_mesa();
    std::unique_ptr<embree_peer> embree_ = open_embree();
};

/// A cell's numbers, as they come through a pipe.
constexpr std::size_t numbers_of_a_cell = 16;

void write(const cell_times& t, std::vector<double>& numbers) {
    for (const frame_times& times : {t.lambert, t.gouraud, t.mesa, t.embree})
        numbers.insert(numbers.end(), {times.median, times.least, times.first});
    for (const long count : {t.mesa_differs, t.embree_differs, t.covered, t.culled})
        numbers.push_back(static_cast<double>(count));
}

void read(std::span<const double, numbers_of_a_cell> numbers, cell_times& t) {
    std::size_t next = 0;
    for (frame_times* const times : {&t.lambert, &t.gouraud, &t.mesa, &t.embree}) {
        times->median = numbers[next++];
        times->least = numbers[next++];
        times->first = numbers[next++];
    }
    for (long* const count : {&t.mesa_differs, &t.embree_differs, &t.covered, &t.culled})
        *count = static_cast<long>(numbers[next++]);
}

} // namespace

child_setting setting_of(const peer_choice& choice) {
    return {{{"LP_NUM_THREADS", std::to_string(choice.mesa_threads)},
             {"LP_NATIVE_VECTOR_WIDTH", std::to_string(choice.mesa_bits)}},
            choice.one_processor};
}

std::vector<peer_choice> mesa_ways(int threads) {
    std::vector<peer_choice> ways;
    for (const int workers : {threads - 1, threads})
        for (const int bits : mesa_widths()) {
            peer_choice& way = ways.emplace_back();
            way.mesa_threads = workers;
            way.mesa_bits = bits;
            way.one_processor = threads == 1 && workers > 0;
        }
    return ways;
}

std::vector<cell_times> compare(const l3d_patch_model& model, std::span<const bench_cell> cells,
                                int threads) {
    const auto mesa = best_of_mesa(cells, threads), embree = best_of_embree(cells, threads);
    std::vector<cell_times> all(cells.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        all[i].mesa_way = mesa[i];
        all[i].embree_way = embree[i];
    }
    for (const peer_choice& way : mesa_ways(threads)) {
        std::vector<std::size_t> chosen;
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (is_of(mesa[i], way))
                chosen.push_back(i);
        const std::vector<double> numbers = in_child(setting_of(way), [&] {
            cell_timer timer(model, threads);
            std::vector<double> result;
            for (const std::size_t i : chosen) {
                timer.time(cells[i], all[i]);
                write(all[i], result);
            }
            return result;
        });
        for (std::size_t k = 0; k < chosen.size(); ++k)
            read(std::span(numbers).subspan(numbers_of_a_cell * k).first<numbers_of_a_cell>(),
                 all[chosen[k]]);
    }
    return all;
}

double clearing_ms(l3d_size size) {
    const auto count = static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height);
    std::vector<std::uint32_t> color(count, 1), depth(count, 1);
    const double ms = median_of(clearing_frames, [&] {
        std::ranges::fill(color, 0u);
        std::ranges::fill(depth, 0u);
    });
    if (color[count / 2] + depth[count / 2] != 0)
        throw std::runtime_error("nothing was cleared");
    return ms;
}

std::string peer_names() {
    const std::vector<double> letters = in_child({}, [] {
        const std::string name = open_mesa()->renderer() + " and " + open_embree()->name();
        return std::vector<double>(name.begin(), name.end());
    });
    std::string name;
    for (const double letter : letters)
        name.push_back(static_cast<char>(letter));
    return name;
}
