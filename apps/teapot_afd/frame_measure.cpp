// SPDX-License-Identifier: MIT
// frame_measure: draws into memory with an eye that trembles, and compares with the exact picture.
#include "frame_measure.h"

#include "pipeline/polygons/polygon_model.h"
#include "system/options/number_text.h"
#include <l3d/pipeline_zbuffer.h>
#include <l3d/pipeline_zsort.h>
#include <l3d/rasterizer_factory.h>
#include <l3d/screen_memory.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <iterator>
#include <limits>
#include <utility>

namespace {

reference::vec3 vec3_of(const l3d_camera::vector& v) {
    return {v[0], v[1], v[2]};
}

reference::camera camera_of(const l3d_camera& camera) {
    return {vec3_of(camera.eye), vec3_of(camera.target), vec3_of(camera.up),
            camera.fov,          camera.near_z,          camera.is_parallel()};
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

/// The processor time of this thread, in milliseconds. Other threads and processes do not count.
double processor_ms() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// Moves the eye by tenths of a millionth of the distance. No picture shows it, and no frame equals
/// another.
l3d_camera trembling(const l3d_camera& at, int frame) {
    constexpr double tremor = 1e-7;
    l3d_camera result = at;
    result.eye = at.eye + (at.eye - at.target) * (tremor * frame);
    return result;
}

class patch_pipeline final : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;

    void look_from(const l3d_camera& at) { camera() = at; }
};

template <class Pipeline> class polygon_pipeline final : public Pipeline {
public:
    using Pipeline::Pipeline;

    void look_from(const l3d_camera& at) {
        this->camera() = at;
        this->redraw();
    }
};

/// Draws frames for about the given time, and the view itself at the end.
template <class Pipeline>
void time_frames(Pipeline& pipeline, const l3d_camera& camera, double seconds,
                 frame_result& result) {
    using clock = std::chrono::steady_clock;
    std::vector<double> times;
    const auto start = clock::now();
    const auto enough = std::chrono::duration<double>(seconds);
    constexpr int fewest_frames = 4, most_frames = 400;
    while (times.size() < fewest_frames ||
           (times.size() < most_frames && clock::now() - start < enough)) {
        pipeline.look_from(trembling(camera, 1 + static_cast<int>(times.size())));
        const double before = processor_ms();
        pipeline.draw_event();
        times.push_back(processor_ms() - before);
    }
    result.first_ms = times.front();
    times.erase(times.begin());
    std::sort(times.begin(), times.end());
    result.least_ms = times.front();
    result.median_ms = times[times.size() / 2];
    result.frames = static_cast<int>(times.size());
    pipeline.look_from(camera);
    pipeline.draw_event();
}

std::vector<std::uint8_t> levels_of(const l3d_pixels& picture) {
    std::vector<std::uint8_t> levels;
    for (int y = 0; y < picture.height; ++y)
        for (const std::uint32_t word : picture.row(y))
            levels.push_back(static_cast<std::uint8_t>(word & 0xff));
    return levels;
}

double rms_of(const std::vector<std::uint8_t>& drawn, const std::vector<unsigned char>& exact) {
    double sum = 0;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) {
        const double off = int{drawn[i]} - int{exact[i]};
        shown += drawn[i] != 0 || exact[i] != 0;
        sum += off * off;
    }
    return shown > 0 ? std::sqrt(sum / static_cast<double>(shown)) : 0;
}

/// Distances for a picture without depth. Such a picture tells coverage alone, so a covered pixel
/// gets the exact distance, if there is one.
std::vector<float> covered_distances(const std::vector<std::uint8_t>& levels,
                                     const reference::exact_image& exact) {
    std::vector<float> result;
    const auto width = static_cast<std::size_t>(exact.size().width);
    for (std::size_t i = 0; i < levels.size(); ++i) {
        const auto& there = exact.at(static_cast<int>(i % width), static_cast<int>(i / width));
        const double known = there.covered() ? there.w : 1;
        result.push_back(levels[i] != 0 ? static_cast<float>(known)
                                        : std::numeric_limits<float>::infinity());
    }
    return result;
}

void summarize(const reference::error_map& errors, frame_result& result) {
    for (const float distance : errors.outline)
        if (std::isfinite(distance))
            result.outline_px = std::max(result.outline_px, static_cast<double>(distance));
    result.judged = errors.depth_share();
    result.holes = std::count(errors.holes.begin(), errors.holes.end(), true);
    std::vector<float> known;
    std::copy_if(errors.depth.begin(), errors.depth.end(), std::back_inserter(known),
                 [](float error) { return std::isfinite(error); });
    if (known.empty()) {
        result.mean_px = result.largest_px = result.percentile_px =
            std::numeric_limits<double>::quiet_NaN();
        return;
    }
    std::sort(known.begin(), known.end());
    double sum = 0;
    for (const float error : known)
        sum += static_cast<double>(error);
    result.mean_px = sum / static_cast<double>(known.size());
    result.largest_px = static_cast<double>(known.back());
    result.percentile_px = static_cast<double>(known[(known.size() - 1) * 999 / 1000]);
}

measured_frames measure_patches(const measured_view& view, const measured_setting& setting,
                                double seconds, int most_distances) {
    l3d_afd_settings settings;
    settings.antialias = false;
    settings.background = {};
    settings.threads = 1;
    settings.tolerance = setting.tolerance;
    settings.method = setting.method.factory();
    settings.depth = true;
    settings.lateral_only = setting.places_only;
    patch_pipeline pipeline(l3d_memory_canvas(view.size()), view.model(), view.camera(), settings);
    measured_frames result;
    time_frames(pipeline, view.camera(), seconds, result.row);
    const l3d_frame_report report = pipeline.report();
    result.row.samples = report.dice.samples;
    result.row.quads = report.surface.quads;
    result.row.failures = report.dice.failures;
    result.row.bound_px = report.dice.bound_px;
    result.row.rms_levels = rms_of(levels_of(pipeline.screen().pixels()), view.levels());
    result.errors = view.errors(pipeline.distances(), most_distances);
    return result;
}

template <class Pipeline, class... More>
measured_frames measure_polygons(const measured_view& view, int n, double seconds,
                                 int most_distances, const More&... more) {
    l3d_polygon_settings settings{.background = {}, .antialias = false, .threads = 1};
    settings.cull = false; // shows both sides, as the patches do
    polygon_pipeline<Pipeline> pipeline(l3d_memory_canvas(view.size()),
                                        l3d_polygon_model(l3d_tessellated(view.model(), n).mesh),
                                        view.camera(), settings, more...);
    measured_frames result;
    time_frames(pipeline, view.camera(), seconds, result.row);
    result.row.quads = pipeline.report().polygons.drawn / 2;
    result.row.bound_px = std::numeric_limits<double>::infinity();
    const auto levels = levels_of(pipeline.screen().pixels());
    result.row.rms_levels = rms_of(levels, view.levels());
    result.errors = view.errors(covered_distances(levels, view.exact()), most_distances);
    std::fill(result.errors.depth.begin(), result.errors.depth.end(),
              std::numeric_limits<float>::quiet_NaN());
    return result;
}

} // namespace

measured_view::measured_view(std::string name, const l3d_patch_model& model,
                             const l3d_camera& camera, l3d_size size, std::stop_token stop)
    : name_(std::move(name)), model_(model), camera_(camera), size_(size), stop_(std::move(stop)),
      patches_(patches_of(model)),
      exact_(patches_, camera_of(camera), {size.width, size.height}, stop_),
      region_(patches_, camera_of(camera), {size.width, size.height}, stop_),
      levels_(exact_.lambert(vec3_of(l3d_usual_light))) {}

std::string measured_setting::series() const {
    if (as != drawn_as::patches)
        return as == drawn_as::zsort ? "zsort" : "zbuffer";
    if (places_only)
        return "afd places only";
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

measured_frames measure_frames(const measured_view& view, const measured_setting& setting,
                               double seconds, int most_distances) {
    const int n = setting.method.resolution;
    measured_frames result =
        setting.as == drawn_as::zsort
            ? measure_polygons<l3d_pipeline_zsort>(view, n, seconds, most_distances)
        : setting.as == drawn_as::zbuffer
            ? measure_polygons<l3d_pipeline_zbuffer>(view, n, seconds, most_distances,
                                                     l3d_rasterizer_factory_sw())
            : measure_patches(view, setting, seconds, most_distances);
    frame_result& row = result.row;
    row.view = view.name();
    row.series = setting.series();
    row.label = setting.label();
    row.patches = static_cast<std::int64_t>(view.model().patches().size());
    summarize(result.errors, row);
    return result;
}
