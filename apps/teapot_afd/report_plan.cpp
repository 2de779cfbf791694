// SPDX-License-Identifier: MIT
// report_plan: lists settings of each method from coarse to fine, four at least.
#include "report_plan.h"

#include <utility>

namespace {

using settings = std::vector<measured_setting>;
using tolerances = std::vector<double>;
using numbers = std::vector<int>;

/// The most quads of a mesh that is measured, and of one whose errors become a picture. More take
/// seconds for each frame, and hundreds of bytes a quad.
constexpr std::size_t most_quads = 1'200'000, most_painted_quads = 300'000;

/// Plans the settings for one model's report.
class planner {
public:
    planner(std::size_t patches, bool quick) : patches_(patches), quick_(quick) {}

    void add(l3d_method method, const tolerances& all,
             l3d_arithmetic arithmetic = l3d_real_arithmetic()) {
        for (const double tolerance : quick_ ? tolerances{all.front(), all.back()} : all)
            made_.push_back({{method, 0, arithmetic}, tolerance});
    }

    void add_others(l3d_method method, std::initializer_list<l3d_arithmetic> arithmetics,
                    const tolerances& all) {
        for (const l3d_arithmetic arithmetic : arithmetics)
            if (arithmetic != l3d_real_arithmetic())
                add(method, all, arithmetic);
    }

    void add(l3d_method method, const numbers& all, std::size_t quads_each = 0,
             l3d_arithmetic arithmetic = l3d_real_arithmetic()) {
        for (const int n : quick_ ? numbers{all.front(), all[1]} : all)
            if (quads(n) * quads_each <= most_quads)
                made_.push_back({{method, n, arithmetic}});
    }

    void add(drawn_as as, const numbers& all) {
        for (const int n : quick_ ? numbers{all.front()} : all)
            if (quads(n) <= most_painted_quads)
                made_.push_back({{l3d_method::tessellation, n}, 0.25, as});
    }

    void add_places_only(const tolerances& all) {
        for (const double tolerance : all)
            made_.push_back({{l3d_method::afd}, tolerance, drawn_as::patches, true});
    }

    settings done() { return std::move(made_); }

private:
    std::size_t quads(int n) const {
        return patches_ * static_cast<std::size_t>(n) * static_cast<std::size_t>(n);
    }

    std::size_t patches_;
    bool quick_;
    settings made_;
};

settings all_settings(std::size_t patches, bool is_first, const plan_scope& scope) {
    using enum l3d_method;
    using enum l3d_arithmetic;
    const tolerances usual{1, 0.5, 0.25, 0.1, 0.05}, four{1, 0.25, 0.1, 0.05};
    planner plan(patches, scope.quick);
    plan.add(afd, is_first ? tolerances{2, 1, 0.5, 0.25, 0.1, 0.05, 0.02} : usual);
    plan.add_others(afd, {float_32, float_64, fixed_32_32}, four);
    plan.add_places_only(four);
    plan.add(fd, usual);
    plan.add_others(fd, {float_32, float_64, fixed_16_16, block_32, fixed_32_32}, four);
    if (is_first)
        plan.add(fd, numbers{4, 8, 16, 32, 64, 128, 256}, 0, fixed_16_16);
    plan.add(subdivision, tolerances{1, 0.5, 0.25, 0.1});
    plan.add(tessellation, numbers{2, 4, 8, 16, 32, 64, 128}, 1);
    plan.add(drawn_as::zsort, {2, 4, 8, 16, 32});
    plan.add(drawn_as::zbuffer, {2, 4, 8, 16, 32});
    plan.add(micropolygons, numbers{1, 2, 3, 4});
    plan.add(isocurves, numbers{1, 2, 3, 4});
    plan.add(scanline, tolerances{1, 0.25, 0.1, 0.05});
    plan.add(whitted, tolerances{1, 0.25, 0.1, 0.05});
    plan.add(blinn, tolerances{1, 0.25, 0.1, 0.05});
    plan.add(lane_carpenter, tolerances{1, 0.25, 0.1, 0.05});
    plan.add(kept, numbers{1, 2, 3, 4});
    plan.add(voxels, numbers{64, 128, 256, 512});
    if (scope.has_mesa)
        plan.add(mesa, tolerances{1, 0.5, 0.25, 0.1});
    return plan.done();
}

/// The settings that are compared on folded patches.
settings fold_settings(const plan_scope& scope) {
    using enum l3d_method;
    planner plan(1, scope.quick);
    const tolerances two{0.25, 0.05};
    for (const l3d_method each : {afd, subdivision, scanline, whitted, blinn, lane_carpenter})
        plan.add(each, two);
    return plan.done();
}

/// One setting of each kind of method, for scenes of many sizes.
settings scene_settings(std::size_t patches, const plan_scope& scope) {
    using enum l3d_method;
    planner plan(patches, false);
    const tolerances one{0.25};
    plan.add(afd, one);
    plan.add(fd, one);
    plan.add(subdivision, one);
    plan.add(tessellation, numbers{8}, 1);
    plan.add(drawn_as::zsort, {8});
    plan.add(micropolygons, numbers{2});
    plan.add(scanline, one);
    if (scope.has_mesa)
        plan.add(mesa, one);
    return plan.done();
}

} // namespace

std::vector<planned_model> report_plan(std::vector<report_model> models, const plan_scope& scope) {
    std::vector<planned_model> result;
    for (report_model& model : models) {
        const std::size_t patches = model.model.patches().size();
        settings made = all_settings(patches, result.empty(), scope);
        result.push_back({std::move(model), std::move(made)});
    }
    if (scope.has_folds)
        result.push_back({report_folds(), fold_settings(scope)});
    if (scope.has_scenes)
        for (report_model& scene : report_scenes()) {
            const std::size_t patches = scene.model.patches().size();
            result.push_back({std::move(scene), scene_settings(patches, scope)});
        }
    return result;
}
