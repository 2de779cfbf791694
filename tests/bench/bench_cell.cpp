// SPDX-License-Identifier: MIT
// planned_cells: our tolerance by trial, the peers' meshes by planning.
#include "bench/bench_cell.h"

#include "bench/surface_error.h"
#include "dice/frame_dicer.h"
#include "scene/image_transform.h"
#include "scene/levels/level_choice.h"

#include <atomic>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

/// The patches that stand for a model in a cell.
struct seen_model {
    l3d_patch_scene scene;
    double off = 0;  ///< how far these are from the model at most, in pixels
    double rest = 0; ///< of the tolerance

    seen_model(const l3d_patch_model& model, const bench_cell& cell, double tolerance,
               double shade_tolerance)
        : scene(model), rest(tolerance) {
        if (!model.is_curved())
            return;
        off = scene
                  .choose_levels({.camera = cell.view->camera,
                                  .size = cell.size,
                                  .places_px = l3d_curved_share * tolerance,
                                  .normals = l3d_curved_share_of_shade * shade_tolerance /
                                             l3d_level_of_cosine})
                  .places_px;
        rest = (1 - l3d_curved_share) * tolerance;
    }
    const l3d_patch_model& model() const { return scene.instances()[0].model(); }
};

struct measured {
    double error, bound;
};

/// Measures what the pipeline would draw.
measured measure_ours(const l3d_patch_model& model, const bench_cell& cell, double tolerance) {
    const seen_model seen(model, cell, tolerance, l3d_afd_settings().shade_tolerance);
    const l3d_patch_scene& scene = seen.scene;
    const l3d_image_transform transform(cell.view->camera, cell.size, scene);
    const l3d_dice_view view = transform.view(seen.rest);
    surface_error error(cell.view->camera, cell.size);
    l3d_scene_culling culling;
    culling.begin(scene, transform.matrix(), view);
    l3d_workers one(1);
    l3d_frame_dicer<l3d_real> dicer(one, l3d_dice_way::lanes, true);
    dicer.begin(view);
    const auto nothing_is_hidden = [](const l3d_subpixel_box&, float) { return false; };
    for (auto batch = culling.next(nothing_is_hidden); !batch.empty();
         batch = culling.next(nothing_is_hidden)) {
        dicer.dice(scene, culling, batch);
        for (std::size_t i = 0; i < batch.size(); ++i)
            add_pieces(error, seen.model().patches()[batch[i].patch], dicer.pieces(i), view);
    }
    return {error.largest() + seen.off, dicer.counts().bound_px + seen.off};
}

/// The largest tolerance that does. The error does not grow evenly with it, so all are tried, a
/// per cent apart, from above: the bound is never twice what is measured.
void plan_ours(const l3d_patch_model& model, bench_cell& cell) {
    for (double tolerance = 2 * cell.error; tolerance > cell.error / 2; tolerance /= 1.01) {
        const measured m = measure_ours(model, cell, tolerance);
        if (m.error > cell.error)
            continue;
        cell.our_tolerance = tolerance;
        cell.our_bound = m.bound;
        cell.our_error = m.error;
        return;
    }
    throw std::runtime_error("no tolerance of ours keeps the error");
}

void plan(const l3d_patch_model& model, bench_cell& cell) {
    plan_ours(model, cell);
    // The peers' meshes have exact shades: their patches need not be as many as ours.
    const seen_model seen(model, cell, cell.error, std::numeric_limits<double>::infinity());
    const mesh_wish wish{seen.model(), cell.view->camera, cell.size, cell.error - seen.off,
                         l3d_afd_settings().light};
    for (const auto& make : {adaptive_mesh, thinned_mesh})
        if (peer_mesh& mesh = cell.meshes.emplace_back(make(wish));
            (mesh.error += seen.off) > cell.error)
            throw std::runtime_error("the " + mesh.kind + " mesh errs too much");
}

} // namespace

std::vector<bench_cell> planned_cells(const l3d_patch_model& model,
                                      std::span<const bench_view> views,
                                      std::span<const l3d_size> sizes,
                                      std::span<const double> errors) {
    std::vector<bench_cell> cells;
    for (const l3d_size size : sizes)
        for (const double error : errors)
            for (const bench_view& view : views) {
                bench_cell& cell = cells.emplace_back();
                cell.view = &view;
                cell.size = size;
                cell.error = error;
            }
    // The dearest come last in the order above, and are begun first.
    std::atomic<std::size_t> left = cells.size();
    const auto work = [&] {
        for (std::size_t i = left--; i > 0 && i <= cells.size(); i = left--)
            plan(model, cells[i - 1]);
    };
    std::vector<std::thread> threads;
    for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i)
        threads.emplace_back(work);
    work();
    for (std::thread& thread : threads)
        thread.join();
    return cells;
}
