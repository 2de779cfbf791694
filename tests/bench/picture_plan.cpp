// SPDX-License-Identifier: MIT
// planned_pictures: pictures judged in a child, meshes made anew here.
#include "bench/picture_plan.h"

#include "bench/child_process.h"
#include "bench/embree_peer.h"
#include "bench/mesa_peer.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

/// A picture as near to the exact one as ours, to this share.
constexpr double close_enough = 0.03;

/// Meshes are made for tolerances from 2^-5 to 2^5 px: with the one a triangle has two pixels or
/// three, with the other every patch has its fewest.
constexpr int finest = -5, coarsest = 5;
constexpr int most_tries = 2;

mesh_wish wish_of(const l3d_patch_model& model, const bench_view& view, l3d_size size,
                  double tolerance) {
    return {model, view.camera, size, tolerance, l3d_afd_settings().light};
}

/// Calls work(i) for all i below count, on all processors.
template <class Work> void for_all(std::size_t count, const Work& work) {
    std::atomic<std::size_t> next = 0;
    const auto loop = [&] {
        for (std::size_t i = next++; i < count; i = next++)
            work(i);
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
        threads.emplace_back(loop);
    loop();
    for (std::thread& thread : threads)
        thread.join();
}

/// A view at a size, and the exact picture of it.
struct scenery {
    const bench_view* view;
    l3d_size size;
    picture_judge judge;
};

/// Meshes for one scenery, and what llvmpipe makes of them: by its rule no pixel along an edge is
/// missed.
class mesh_search {
public:
    mesh_search(const l3d_patch_model& model, const scenery& of)
        : model_(model), of_(of), mesa_(mesa_peer::open(why_)) {
        if (!mesa_)
            throw std::runtime_error(why_);
    }

    /// Expects: start > 0. Units: pixels.
    peer_picture like(double error, double picture_error::*over, double start) {
        const auto tolerance = [](int step) { return std::exp2(step); };
        const auto at = [&](double t) { return error_at(t).*over; };
        int step = std::clamp(static_cast<int>(std::floor(std::log2(start))), finest, coarsest);
        while (step > finest && at(tolerance(step)) > error)
            --step;
        while (step < coarsest && at(tolerance(step + 1)) <= error)
            ++step;
        double low = tolerance(step), high = tolerance(step + 1), best = low;
        if (at(low) > error || step == coarsest)
            return picture_at(low, at(low) <= error);
        const auto off = [&](double t) { return std::abs(std::log(at(t) / error)); };
        for (int i = 0; i < most_tries && off(best) > close_enough; ++i) {
            const double share = std::log(error / at(low)) / std::log(at(high) / at(low));
            const double between = low * std::pow(high / low, std::clamp(share, 0.1, 0.9));
            (at(between) <= error ? low : high) = between;
            if (off(between) < off(best))
                best = between;
        }
        return picture_at(best, true);
    }

private:
    peer_picture picture_at(double tolerance, bool reached) {
        peer_picture result;
        result.tolerance = tolerance;
        result.llvmpipe = error_at(tolerance);
        result.reached = reached;
        return result;
    }

    const picture_error& error_at(double tolerance) {
        const auto known = errors_.find(tolerance);
        if (known != errors_.end())
            return known->second;
        const peer_mesh mesh = adaptive_mesh(wish_of(model_, *of_.view, of_.size, tolerance));
        mesa_->prepare(mesh, of_.view->camera, of_.size, mesa_peer::culling::none);
        mesa_->draw();
        return errors_[tolerance] = of_.judge(mesa_->picture());
    }

    const l3d_patch_model& model_;
    const scenery& of_;
    std::string why_;
    std::unique_ptr<mesa_peer> mesa_;
    std::map<double, picture_error> errors_;
};

/// What is planned of a cell, as it comes through a pipe.
struct planned_numbers {
    double our_bound;
    picture_error ours;
    std::array<peer_picture, picture_measures.size()> theirs;
};
constexpr std::size_t numbers_of_a_cell = 3 + 4 * picture_measures.size();

void write(const planned_numbers& of, std::vector<double>& numbers) {
    numbers.insert(numbers.end(), {of.our_bound, of.ours.all, of.ours.inside});
    for (const peer_picture& p : of.theirs)
        numbers.insert(numbers.end(), {p.tolerance, p.llvmpipe.all, p.llvmpipe.inside,
                                       static_cast<double>(p.reached)});
}

planned_numbers read(std::span<const double, numbers_of_a_cell> numbers) {
    planned_numbers result{numbers[0], {numbers[1], numbers[2]}, {}};
    std::size_t next = 3;
    for (peer_picture& p : result.theirs) {
        p.tolerance = numbers[next++];
        p.llvmpipe.all = numbers[next++];
        p.llvmpipe.inside = numbers[next++];
        p.reached = numbers[next++] != 0;
    }
    return result;
}

std::vector<planned_numbers> planned(const l3d_patch_model& model, const scenery& of,
                                     std::span<const double> tolerances) {
    mesh_search search(model, of);
    const l3d_patch_scene scene(model);
    std::vector<planned_numbers> result;
    for (const double tolerance : tolerances) {
        bench_frame frame(scene, of.view->camera, of.size, tolerance, 1);
        frame.hash();
        planned_numbers& cell = result.emplace_back();
        cell.our_bound = frame.report().dice.bound_px;
        cell.ours = of.judge(greys_of(frame.pixels()));
        for (std::size_t m = 0; m < picture_measures.size(); ++m) {
            const auto over = picture_measures[m].over;
            cell.theirs[m] = search.like(cell.ours.*over, over, tolerance);
        }
    }
    return result;
}

/// What Embree makes of the same meshes.
void add_embree(std::span<picture_cell> cells, std::span<const scenery* const> of) {
    const std::vector<double> errors = in_child({}, [&] {
        std::string why;
        const auto peer = embree_peer::open(why);
        if (!peer)
            throw std::runtime_error(why);
        l3d_workers workers(1);
        std::vector<double> result;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            constexpr int rays = 8;
            peer->prepare(cells[i].cell.meshes.front(), of[i]->view->camera, of[i]->size, rays);
            peer->draw(workers);
            const picture_error error = of[i]->judge(greys_of(peer->picture()));
            result.insert(result.end(), {error.all, error.inside});
        }
        return result;
    });
    std::size_t next = 0;
    for (picture_cell& cell : cells) {
        cell.theirs.embree.all = errors.at(next++);
        cell.theirs.embree.inside = errors.at(next++);
    }
}

} // namespace

std::vector<picture_cell> planned_pictures(const l3d_patch_model& model, l3d_size size,
                                           std::span<const double> tolerances) {
    std::vector<std::optional<scenery>> sceneries(bench_views.size());
    for_all(sceneries.size(), [&](std::size_t i) {
        const bench_view& view = bench_views[i];
        sceneries[i] = scenery{&view, size, picture_judge(model, view.camera, size)};
    });
    // llvmpipe and our workers have threads, which a later child must not inherit.
    const std::vector<double> numbers = in_child({}, [&] {
        std::vector<std::vector<planned_numbers>> plans(sceneries.size());
        for_all(plans.size(),
                [&](std::size_t i) { plans[i] = planned(model, *sceneries[i], tolerances); });
        std::vector<double> result;
        for (const auto& plan : plans)
            for (const planned_numbers& cell : plan)
                write(cell, result);
        return result;
    });
    std::vector<picture_cell> cells;
    std::vector<const scenery*> places;
    std::size_t next = 0;
    for (const auto& of : sceneries)
        for (const double tolerance : tolerances) {
            const planned_numbers plan =
                read(std::span(numbers).subspan(next).first<numbers_of_a_cell>());
            next += numbers_of_a_cell;
            for (std::size_t m = 0; m < picture_measures.size(); ++m) {
                picture_cell& made = cells.emplace_back();
                made.cell.view = of->view;
                made.cell.size = of->size;
                made.cell.our_tolerance = tolerance;
                made.cell.our_bound = plan.our_bound;
                made.measure = &picture_measures[m];
                made.ours = plan.ours;
                made.theirs = plan.theirs[m];
                places.push_back(&*of);
            }
        }
    for_all(cells.size(), [&](std::size_t i) {
        picture_cell& of = cells[i];
        of.cell.meshes = {
            adaptive_mesh(wish_of(model, *of.cell.view, of.cell.size, of.theirs.tolerance))};
    });
    add_embree(cells, places);
    return cells;
}
