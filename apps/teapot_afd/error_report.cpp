// SPDX-License-Identifier: MIT
// write_error_report: plans the measurements, makes them in order, and writes their files.
#include "error_report.h"

#include "error_picture.h"
#include "report_alternatives.h"
#include "report_curves.h"
#include "report_plan.h"
#include "report_rows.h"

#include "raster/parallel/simd_target.h"
#include <l3d/error.h>
#include <l3d/plugin_loader.h>
#include <l3d/rasterizer_factory.h>
#include <l3d/real.h>
#include <l3d/surface_method.h>
#include <l3d/version.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <thread>

namespace {

/// Tells the report's progress, and the time that it may still take: "[12/80, 35 s, 200 s to go]
/// ...".
class progress {
public:
    progress(std::size_t all, std::size_t known) : all_(all), known_(known), done_(known) {}

    void next(const std::string& what) {
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        const auto measured = static_cast<double>(done_ - known_);
        const auto left = static_cast<double>(all_ - done_);
        std::fprintf(stderr, "[%zu/%zu, %.0f s", ++done_, all_, seconds);
        if (measured > 0)
            std::fprintf(stderr, ", %.0f s to go", seconds / measured * left);
        std::fprintf(stderr, "] %s\n", what.c_str());
    }

private:
    std::size_t all_, known_, done_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(':') + 2);
    return "unknown processor";
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::array<char, 32> text{};
    std::tm utc{};
    std::strftime(text.data(), text.size(), "%Y-%m-%d", ::gmtime_r(&now, &utc));
    return text.data();
}

/// The facts that all rows share.
nlohmann::ordered_json machine(l3d_size size, bool quick) {
    return {{"processor", processor()},
            {"processors", std::thread::hardware_concurrency()},
            {"simd", l3d_simd_target()},
            {"compiler", __VERSION__},
            {"real", l3d_real_name()},
            {"version", L3D_VERSION_TEXT},
            {"width", size.width},
            {"height", size.height},
            {"quick", quick}};
}

/// The file for the picture of a setting's errors; null for settings without one. The library's own
/// method gets a picture, and so does a mesh of about the same cost.
const char* pictured(const measured_setting& what) {
    const l3d_method_choice& method = what.method;
    if (method.method == l3d_method::afd && what.tolerance == 0.25 &&
        method.arithmetic == l3d_real_arithmetic())
        return "error_afd.png";
    return method.method == l3d_method::tessellation && method.resolution == 16 &&
                   what.as == drawn_as::patches
               ? "error_tessellation.png"
               : nullptr;
}

/// Measures the rows that are missing. Rows on which the exact renderer gives up are left out, with
/// a message.
class measurer {
public:
    measurer(const std::string& folder, bool quick, l3d_size size, row_store& rows, progress& at)
        : folder_(folder), quick_(quick), size_(size), rows_(rows), at_(at) {}

    void measure(const planned_model& of, const report_view& from, bool has_pictures) {
        const std::string seen = of.model.name + ", " + from.name;
        std::optional<measured_view> view;
        for (const measured_setting& setting : of.settings) {
            const row_name name{of.model.name, from.name, setting.series(), setting.label()};
            if (rows_.has(name))
                continue;
            const std::string row = seen + ", " + name.series + ", " + name.label;
            measured_frames measured;
            try {
                if (!view)
                    view.emplace(from.name, of.model.model, from.camera, size_);
                at_.next(row);
                const double seconds = quick_ ? 0.02 : 0.1;
                const int distances = quick_ ? 30 : 60; // some 5 ms each
                measured = measure_frames(*view, setting, seconds, distances);
            } catch (const std::runtime_error& reason) {
                std::fprintf(stderr, "%s: left out: %s\n", (view ? row : seen).c_str(),
                             reason.what());
                if (!view)
                    return;
                continue;
            }
            measured.row.model = name.model;
            if (const char* const file = has_pictures ? pictured(setting) : nullptr)
                write_error_picture(folder_ + '/' + file, measured.errors, size_,
                                    std::max(measured.row.percentile_px, 1e-3));
            rows_.add(measured.row);
        }
    }

private:
    const std::string& folder_;
    bool quick_;
    l3d_size size_;
    row_store& rows_;
    progress& at_;
};

std::vector<planned_model> plan_of(const l3d_patch_model& model, const l3d_camera& camera,
                                   const error_report_scope& scope, bool mesa) {
    std::vector<report_model> models;
    if (scope.project_models)
        models = report_models();
    else
        models.push_back({"model", model, {{"view", camera}}});
    if (scope.quick) {
        constexpr std::size_t few = 2;
        models.resize(std::min(models.size(), few));
        for (report_model& each : models)
            each.views.resize(1);
    }
    return report_plan(std::move(models), {scope.quick, mesa, scope.project_models,
                                           scope.project_models && !scope.quick});
}

} // namespace

void write_error_report(const std::string& folder, const l3d_patch_model& model,
                        const l3d_camera& camera, l3d_size size, const error_report_scope& scope) {
    // llvmpipe shall have one thread, like all methods. It reads this when its context is made.
    ::setenv("LP_NUM_THREADS", "0", 0);
    std::filesystem::create_directories(folder);
    const bool mesa = has_mesa();
    if (!mesa)
        std::fprintf(stderr, "no software GL: the method mesa is left out\n");
    if (scope.quick)
        size = {size.width / 3, size.height / 3};
    const auto plan = plan_of(model, camera, scope, mesa);
    std::vector<row_name> names;
    for (const planned_model& each : plan)
        for (const report_view& view : each.model.views)
            for (const measured_setting& setting : each.settings)
                names.push_back({each.model.name, view.name, setting.series(), setting.label()});

    nlohmann::ordered_json facts = machine(size, scope.quick);
    row_store rows(folder, facts.dump());
    const auto known = static_cast<std::size_t>(std::count_if(
        names.begin(), names.end(), [&](const auto& name) { return rows.has(name); }));
    if (known > 0)
        std::fprintf(stderr, "%zu of %zu rows are there already\n", known, names.size());
    progress at(names.size() + (scope.project_models ? 2 : 1), known);
    measurer measuring(folder, scope.quick, size, rows, at);
    for (const planned_model& each : plan)
        for (const report_view& view : each.model.views)
            measuring.measure(each, view,
                              &each == &plan.front() && &view == &each.model.views.front());
    at.next("curves");
    write_curve_tables(folder, scope.quick);
    if (scope.project_models) {
        at.next("scan lines, cells, smoke, micropolygons that are kept");
        write_scan_line_table(folder, size);
        write_cell_table(folder, size, scope.quick);
        write_smoke(folder, scope.quick);
        write_kept_table(folder, size, scope.quick);
    }
    facts["date"] = today();
    write_text(folder + "/machine.json", facts.dump(1) + '\n');
    const std::size_t all = names.size();
    const std::size_t left_out =
        std::erase_if(names, [&](const row_name& name) { return !rows.has(name); });
    rows.finish(names);
    std::fprintf(stderr,
                 "the numbers are in %s; pages of them: python3 %s/report/report_pages.py %s\n",
                 folder.c_str(), l3d_data_folder().c_str(), folder.c_str());
    if (left_out > 0)
        throw l3d_error(l3d_exit::failure, "--error-report: " + std::to_string(left_out) + " of " +
                                               std::to_string(all) +
                                               " rows are left out, for the reasons above");
}
