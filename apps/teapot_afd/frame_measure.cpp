// SPDX-License-Identifier: MIT
// frame_measure: a pipeline into memory, an eye that trembles, and the exact picture.
#include "frame_measure.h"

#include <l3d/rasterizer_factory_sw.h>
#include "system/number_text.h"
#include <l3d/screen_memory.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <ctime>
#include <utility>

namespace {

reference::vec3 vec3_of(const l3d_camera::vector& v) {
    return {v[0], v[1], v[2]};
}

reference::camera camera_of(const l3d_camera& camera) {
    return {vec3_of(camera.eye), vec3_of(camera.target), vec3_of(camera.up), camera.fov,
            camera.near};
}

std::vector<reference::patch> patches_of(const l3d_patch_model& model) {
    std::vector<reference::patch> result;
    for (const auto& patch : model.patches()) {
        reference::patch& copy = result.emplace_back();
        for (std::size_t i = 0; i < copy.points.size(); ++i)
            copy.points[i] = vec3_of(patch.points[i]);
    }
    return result;
}

/// Time that this thread has run: what others do with the machine meanwhile does not count.
double processor_ms() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

class trembling_pipeline final : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;

    /// Tenths of a millionth of the distance: no picture shows it, no frame equals another.
    void tremble(const l3d_camera& at, int frame) {
        constexpr double tremor = 1e-7;
        camera() = at;
        camera().eye = at.eye + (at.eye - at.target) * (tremor * frame);
    }
};

void summarize(frame_result& result) {
    for (const float distance : result.errors.outline)
        if (std::isfinite(distance))
            result.outline_px = std::max(result.outline_px, static_cast<double>(distance));
    result.judged = result.errors.depth_share();
    result.holes = std::count(result.errors.holes.begin(), result.errors.holes.end(), true);
    std::vector<float> known;
    std::copy_if(result.errors.depth.begin(), result.errors.depth.end(), std::back_inserter(known),
                 [](float error) { return std::isfinite(error); });
    if (known.empty())
        return;
    std::sort(known.begin(), known.end());
    double sum = 0;
    for (const float error : known)
        sum += static_cast<double>(error);
    result.mean_px = sum / static_cast<double>(known.size());
    result.largest_px = static_cast<double>(known.back());
    result.percentile_px = static_cast<double>(known[(known.size() - 1) * 999 / 1000]);
}

} // namespace

measured_view::measured_view(std::string name, const l3d_patch_model& model,
                             const l3d_camera& camera, l3d_size size)
    : name_(std::move(name)), model_(model), camera_(camera), size_(size),
      patches_(patches_of(model)), exact_(patches_, camera_of(camera), {size.width, size.height}),
      region_(patches_, camera_of(camera), {size.width, size.height}) {}

std::string measured_setting::series() const {
    l3d_method_choice without_number = method;
    without_number.resolution = 0;
    const std::string name = without_number.name();
    const bool walks = method.method == l3d_method::afd || method.method == l3d_method::fd;
    return walks ? name + ' ' + l3d_name_of(method.arithmetic) : name;
}

std::string measured_setting::label() const {
    return method.resolution > 0 ? "n = " + std::to_string(method.resolution)
                                 : l3d_number_text(tolerance) + " px";
}

frame_result measure_frames(const measured_view& view, const measured_setting& setting,
                            double seconds, int most_distances) {
    using clock = std::chrono::steady_clock;
    l3d_afd_settings settings;
    settings.tolerance = setting.tolerance;
    settings.method = setting.method.factory();
    settings.depth = true;
    trembling_pipeline pipeline(l3d_memory_canvas(view.size()), view.model(), view.camera(),
                                settings);
    std::vector<double> times;
    const auto start = clock::now();
    const auto enough = std::chrono::duration<double>(seconds);
    constexpr int fewest_frames = 3, most_frames = 400;
    while (times.size() < fewest_frames ||
           (times.size() < most_frames && clock::now() - start < enough)) {
        pipeline.tremble(view.camera(), 1 + static_cast<int>(times.size()));
        const double before = processor_ms();
        pipeline.draw_event();
        times.push_back(processor_ms() - before);
    }
    frame_result result;
    result.first_ms = times.front();
    times.erase(times.begin());
    std::sort(times.begin(), times.end());
    result.least_ms = times.front();
    result.median_ms = times[times.size() / 2];
    result.frames = static_cast<int>(times.size());

    pipeline.tremble(view.camera(), 0);
    pipeline.draw_event();
    const l3d_frame_report report = pipeline.report();
    result.view = view.name();
    result.series = setting.series();
    result.label = setting.label();
    result.samples = report.dice.samples;
    result.quads = report.surface.quads;
    result.failures = report.dice.failures;
    result.bound_px = report.dice.bound_px;
    result.errors = view.errors(l3d_distances(pipeline.depth()), most_distances);
    summarize(result);
    return result;
}
