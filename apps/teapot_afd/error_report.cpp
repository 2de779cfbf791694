// SPDX-License-Identifier: MIT
// The report: what is measured, in which order.
#include "error_report.h"

#include "curve_measure.h"
#include "error_picture.h"
#include "frame_measure.h"
#include "report_files.h"
#include "report_plots.h"

#include <l3d/rasterizer_factory_sw.h>
#include <l3d/surface_method.h>
#include <l3d/error.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

namespace {

/// Says how far the report is: "[12/80] full, afd float, 0.25 px".
class progress {
public:
    explicit progress(std::size_t all) : all_(all) {}
    void next(const std::string& what) {
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        std::fprintf(stderr, "[%zu/%zu, %.0f s] %s\n", ++done_, all_, seconds, what.c_str());
    }

private:
    std::size_t all_, done_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

using settings = std::vector<measured_setting>;

void add_tolerances(settings& to, l3d_method method, const std::vector<double>& tolerances,
                    l3d_arithmetic arithmetic = l3d_real_arithmetic()) {
    for (const double tolerance : tolerances)
        to.push_back({{method, 0, arithmetic}, tolerance});
}

void add_numbers(settings& to, l3d_method method, const std::vector<int>& numbers,
                 l3d_arithmetic arithmetic = l3d_real_arithmetic()) {
    constexpr double unused = 0.25;
    for (const int n : numbers)
        to.push_back({{method, n, arithmetic}, unused});
}

bool has_mesa() {
    try {
        l3d_method_choice choice;
        choice.method = l3d_method::mesa;
        l3d_workers one(1);
        choice.factory().create(l3d_rasterizer_factory_sw(), one);
        return true;
    } catch (const l3d_error&) {
        return false;
    }
}

/// Arithmetics make no difference that depends on the view, so they are compared in one.
settings all_settings(bool quick, bool gl_is_there, bool all_arithmetics) {
    using enum l3d_method;
    using enum l3d_arithmetic;
    const std::vector<double> fine = quick ? std::vector<double>{1, 0.25, 0.1}
                                           : std::vector<double>{2, 1, 0.5, 0.25, 0.1, 0.05, 0.02};
    const std::vector<double> usual =
        quick ? std::vector<double>{0.5, 0.1} : std::vector<double>{1, 0.5, 0.25, 0.1, 0.05};
    settings result;
    add_tolerances(result, afd, fine);
    add_tolerances(result, fd, usual);
    if (all_arithmetics) {
        for (const auto arithmetic : {float_32, float_64, fixed_32_32})
            if (arithmetic != l3d_real_arithmetic())
                add_tolerances(result, afd, fine, arithmetic);
        for (const auto arithmetic : {float_32, float_64, fixed_16_16, block_32, fixed_32_32})
            if (arithmetic != l3d_real_arithmetic())
                add_tolerances(result, fd, usual, arithmetic);
        add_numbers(result, fd,
                    quick ? std::vector{8, 32, 128} : std::vector{4, 8, 16, 32, 64, 128, 256},
                    fixed_16_16);
    }
    add_tolerances(result, subdivision, usual);
    add_numbers(result, tessellation,
                quick ? std::vector{8, 32} : std::vector{4, 8, 16, 32, 64, 128});
    add_tolerances(result, micropolygons, {0.25});
    add_tolerances(result, isocurves, {0.25});
    add_tolerances(result, scanline, quick ? std::vector{0.25} : std::vector{1.0, 0.25, 0.05});
    add_numbers(result, voxels, quick ? std::vector{128} : std::vector{64, 128, 256, 512});
    if (gl_is_there)
        add_tolerances(result, mesa, usual);
    return result;
}

struct named_camera {
    const char* name;
    l3d_camera camera;
};

std::vector<named_camera> cameras_of(const l3d_camera& camera, bool project_views) {
    if (!project_views)
        return {{"view", camera}};
    return {
        {"full", {{3.2, 3.6, 7.4}, {0.2, 1.3, 0.0}, {0.0, 1.0, 0.0}, 38, 0.1, 1e13}},
        {"closeup", {{1.2, 2.6, 4.4}, {-0.3, 1.5, 0.0}, {0.0, 1.0, 0.0}, 45, 0.1, 1e13}},
        {"top", {{1.5, 7.5, 3.0}, {0.2, 1.2, 0.0}, {0.0, 1.0, 0.0}, 35, 0.1, 1e13}},
    };
}

curve_results measure_curves(bool quick) {
    const int curves = quick ? 40 : 400;
    std::vector<int> steps;
    for (int n = 4; n <= (quick ? 1024 : 8192); n *= 2)
        steps.push_back(n);
    std::vector<int> few;
    for (int n = 1; n <= 256; n *= 2)
        few.push_back(n);
    curve_results result;
    result.curves = curves;
    result.growth = measure_growth(1024, steps, curves);
    result.chords = measure_chords(1024, few, curves);
    result.steps = measure_steps(1024, 5, curves);
    constexpr double chang_range = 1024, rappoport_range = 131072;
    const int limit = 1 << (quick ? 11 : 14);
    for (const curve_numbers numbers : all_curve_numbers)
        result.limits.push_back(
            {numbers, most_steps_below_a_pixel(numbers, chang_range, limit, curves / 4),
             most_steps_below_a_pixel(numbers, rappoport_range, limit, curves / 4)});
    return result;
}

} // namespace

void write_error_report(const std::string& folder, const l3d_patch_model& model,
                        const l3d_camera& camera, l3d_size size, const error_report_scope& scope) {
    // llvmpipe is to have one thread, like everybody; it reads this when its context is made.
    ::setenv("LP_NUM_THREADS", "0", 0);
    std::filesystem::create_directories(folder);
    const bool mesa = has_mesa();
    if (!mesa)
        std::fprintf(stderr, "no software GL: the method mesa is left out\n");
    if (scope.quick)
        size = {size.width / 3, size.height / 3};
    const settings first = all_settings(scope.quick, mesa, true);
    const settings others = all_settings(scope.quick, mesa, false);
    const auto cameras = cameras_of(camera, scope.project_views);
    const double seconds = scope.quick ? 0.02 : 0.15;
    const int distances = scope.quick ? 30 : 60; // some 5 ms each

    report_contents report;
    report.size = size;
    report.quick = scope.quick;
    progress at(first.size() + 1 + (cameras.size() - 1) * (others.size() + 1) + 1);
    for (const named_camera& each : cameras) {
        at.next(std::string(each.name) + ": the exact picture");
        const measured_view view(each.name, model, each.camera, size);
        for (const measured_setting& setting : report.frames.empty() ? first : others) {
            at.next(std::string(each.name) + ", " + setting.series() + ", " + setting.label());
            frame_result& row =
                report.frames.emplace_back(measure_frames(view, setting, seconds, distances));
            const bool is_pictured =
                (setting.method.method == l3d_method::afd && setting.tolerance == 0.25 &&
                 setting.method.arithmetic == l3d_real_arithmetic()) ||
                (setting.method.method == l3d_method::tessellation &&
                 setting.method.resolution == (scope.quick ? 8 : 16));
            if (is_pictured && report.frames.front().view == row.view) {
                const std::string file = "error_" + std::to_string(report.pictures.size()) + ".png";
                const double legend = std::max(row.percentile_px, 1e-3);
                write_error_picture(folder + '/' + file, row.errors, size, legend);
                report.pictures.push_back({file, row.series + ", " + row.label});
            }
            row.errors = {};
        }
    }
    at.next("curves");
    report.curves = measure_curves(scope.quick);
    write_report_files(folder, report);
    draw_report_plots(folder, report);
    std::fprintf(stderr, "%s/report.md\n", folder.c_str());
}
