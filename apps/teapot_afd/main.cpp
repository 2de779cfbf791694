// SPDX-License-Identifier: MIT
// teapot_afd: the Utah teapot (or any bicubic patches) by adaptive forward differencing.
#include "pipeline/pipeline_afd_viewer.h"
#include "system/afd_options.h"
#include "system/dispatcher.h"
#include "system/factory_manager.h"
#include "system/options.h"
#include "system/report_writer.h"
#include "system/screenshot.h"
#include "tool_2d/image_file.h"

#include "error_report.h"

#include <iostream>
#include <optional>

namespace {

// Step 2 of 5: the application is a pipeline. The viewer draws and has the keys; this one reports.
class teapot_pipeline final : public l3d_pipeline_afd_viewer {
public:
    using l3d_pipeline_afd_viewer::l3d_pipeline_afd_viewer;

    void write_reports(const std::string& file) { reports_.emplace(file); }

    void frame_event(const l3d_frame_times& times) override {
        l3d_pipeline_afd_viewer::frame_event(times);
        if (reports_)
            reports_->add(report().json());
    }

private:
    std::optional<l3d_report_writer> reports_;
};

void write_depth(const std::string& file, const l3d_depth_buffer& depth) {
    l3d_write_pfm(file, depth.size().width, depth.size().height, l3d_distances(depth));
}

} // namespace

int main(int argc, char** argv) try {
    l3d_options options("teapot_afd",
                        "Draws bicubic patches, the Utah teapot unless told otherwise, by adaptive "
                        "forward differencing,\nwith a certified bound of the error in pixels. "
                        "In the window, h lists the keys.",
                        {1024, 768});
    l3d_afd_options afd(options);
    l3d_factory_manager factories; // step 1: choose factories
    if (!options.parse(argc, argv))
        return 0;
    const l3d_camera camera = afd.camera();
    const l3d_afd_settings settings = afd.settings();
    const l3d_patch_model model = afd.model();
    if (!afd.error_report().empty()) {
        write_error_report(afd.error_report(), model, camera, options.common().size,
                           {afd.shows_the_usual(), afd.quick()});
        return 0;
    }
    if (!factories.choose(options))
        return 0;

    const auto dispatcher = factories.create_dispatcher(options.frame_settings()); // step 3
    teapot_pipeline pipeline(factories.create_screen(options.screen_request()),
                             *factories.chosen().rasterizer_factory, model, camera, settings);
    pipeline.controls().set_turntable(afd.turntable(), 1 / options.frame_settings().step());
    pipeline.controls().set_screenshot(l3d_save_screenshot);
    if (!afd.report().empty())
        pipeline.write_reports(afd.report());
    dispatcher->plug(pipeline, pipeline.screen()); // step 4
    const l3d_exit result = dispatcher->start();   // step 5

    if (!afd.depth_output().empty())
        write_depth(afd.depth_output(), pipeline.depth());
    if (afd.explain())
        std::cerr << pipeline.report().explanation();
    return l3d_report("teapot_afd", result);
} catch (const std::exception& error) {
    return l3d_report("teapot_afd", error);
}
