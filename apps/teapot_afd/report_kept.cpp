// SPDX-License-Identifier: MIT
// Measures flights over the teapot, with micropolygons that are kept and with others.
#include "report_alternatives.h"
#include "report_models.h"
#include "report_rows.h"
#include "report_table.h"

#include "compare/method_choice.h"
#include "compare/method_kept.h"
#include "processor_time.h"
#include <l3d/pipeline_afd.h>
#include <l3d/screen_memory.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

namespace {

/// The bytes of a vertex that is not kept: its place, depth and normal in the form in which they
/// are filled.
constexpr double plain_vertex = 2 * sizeof(std::int32_t) + 4 * sizeof(float);

/// A flight: the camera at frame `at` of `frames`.
using flight = std::function<l3d_camera(const l3d_camera&, int at, int frames)>;

/// Turns a degree each frame, round the target's upright axis.
l3d_camera turned(const l3d_camera& from, int at, int) {
    const double a = at * std::numbers::pi / 180;
    const l3d_camera::vector d = from.eye - from.target;
    l3d_camera result = from;
    result.eye = from.target + l3d_camera::vector(d[0] * std::cos(a) + d[2] * std::sin(a), d[1],
                                                  d[2] * std::cos(a) - d[0] * std::sin(a));
    return result;
}

/// Zooms to a third of the field of view.
l3d_camera zoomed(const l3d_camera& from, int at, int frames) {
    l3d_camera result = from;
    result.fov = from.fov * std::pow(1.0 / 3, double(at) / frames);
    return result;
}

/// Moves the eye by a millionth of its distance. So the numbers differ, but the picture is the
/// same.
l3d_camera still(const l3d_camera& from, int at, int) {
    l3d_camera result = from;
    result.eye = from.eye + (from.eye - from.target) * (1e-6 * at);
    return result;
}

class flying final : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;

    void look_from(const l3d_camera& at) { camera() = at; }
};

/// Lives: `made` points to the method as long as the pipeline lives.
l3d_method_factory kept_factory(std::shared_ptr<const l3d_method_kept*> made) {
    return {"kept", [made](const l3d_rasterizer_factory& rasterizers, l3d_workers& workers) {
                auto method = std::make_unique<l3d_method_kept>(2, rasterizers, workers);
                *made = method.get();
                return method;
            }};
}

std::string fly(const char* name, const flight& along, bool keeps, const report_model& of,
                l3d_size size, int frames) {
    const auto made = std::make_shared<const l3d_method_kept*>();
    l3d_afd_settings settings;
    settings.antialias = false;
    settings.background = {};
    settings.threads = 1;
    std::string why;
    settings.method = keeps
                          ? kept_factory(made)
                          : l3d_method_choice::from_name("micropolygons:2", why).value().factory();
    const l3d_camera& start = of.views[0].camera;
    flying pipeline(l3d_memory_canvas(size), of.model, start, settings);
    std::vector<double> times;
    double diced = 0, quads = 0, bytes = 0;
    for (int at = 0; at <= frames; ++at) {
        pipeline.look_from(along(start, at, frames));
        const double before = processor_seconds();
        pipeline.draw_event();
        if (at == 0)
            continue; // all is new in the first frame
        times.push_back(1e3 * (processor_seconds() - before));
        const l3d_frame_report report = pipeline.report();
        diced += static_cast<double>(report.dice.samples);
        quads += static_cast<double>(report.surface.quads);
        bytes = std::max(bytes, keeps ? static_cast<double>((*made)->bytes())
                                      : plain_vertex * static_cast<double>(report.dice.samples));
    }
    std::sort(times.begin(), times.end());
    double sum = 0;
    for (const double time : times)
        sum += time;
    return table_row(name, keeps ? "kept" : "micropolygons", frames, times[times.size() / 2],
                     sum / frames, times.back(), diced / frames, quads / frames, bytes / 1e6);
}

} // namespace

void write_kept_table(const std::string& folder, l3d_size size, bool quick) {
    std::string text = "flight,method,frames,median_ms,mean_ms,worst_ms,diced,quads,megabytes\n";
    const report_model teapot = report_models().front();
    const l3d_size half{size.width / 2, size.height / 2};
    const int frames = quick ? 4 : 60;
    for (const bool keeps : {false, true}) {
        text += fly("still", still, keeps, teapot, half, frames);
        text += fly("turning", turned, keeps, teapot, half, frames);
        text += fly("zoom", zoomed, keeps, teapot, half, frames);
    }
    write_text(folder + "/kept.csv", text);
}
