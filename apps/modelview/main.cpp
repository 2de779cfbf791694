// SPDX-License-Identifier: MIT
// modelview: any model file, by any pipeline.
#include "pipeline/pipeline_afd_viewer.h"
#include "pipeline/pipeline_zbuffer.h"
#include "pipeline/pipeline_zsort.h"
#include "raster/rasterizer_factory_mesa.h"
#include "raster/rasterizer_factory_sw.h"
#include "system/polygon_options.h"
#include "system/program.h"
#include "system/report_writer.h"
#include "system/screenshot.h"

#include <optional>
#include <utility>

namespace {

// Step 2 of 5: the application is a pipeline, here one of three with a line for each frame.
template <class Pipeline> class reporting final : public Pipeline {
public:
    template <class... Arguments>
    explicit reporting(const std::string& file, Arguments&&... arguments)
        : Pipeline(std::forward<Arguments>(arguments)...) {
        if (!file.empty())
            reports_.emplace(file);
    }

    void frame_event(const l3d_frame_times& times) override {
        Pipeline::frame_event(times);
        if (reports_)
            reports_->add(this->report().json());
    }

private:
    std::optional<l3d_report_writer> reports_;
};

class modelview {
public:
    modelview() : afd_(program_.options()), polygons_(program_.options(), afd_) {}

    int run(int argc, char** argv) {
        return program_.run(argc, argv, [this] { // step 1: choose factories
            if (polygons_.pipeline() == l3d_pipeline_kind::afd)
                return show_patches();
            const l3d_polygon_model model = polygons_.model();
            const auto show_polygons = [&]<class Pipeline>(std::type_identity<Pipeline>,
                                                           const auto&... more) {
                return show<Pipeline>(program_.create_canvas(), model, polygons_.camera(model),
                                      polygons_.settings(), more...);
            };
            switch (polygons_.pipeline()) {
            case l3d_pipeline_kind::zsort:
                return show_polygons(std::type_identity<l3d_pipeline_zsort>());
            case l3d_pipeline_kind::mesa:
                return show_polygons(std::type_identity<l3d_pipeline_zbuffer>(),
                                     l3d_rasterizer_factory_mesa(), "mesa");
            default:
                return show_polygons(std::type_identity<l3d_pipeline_zbuffer>(),
                                     l3d_rasterizer_factory_sw());
            }
        });
    }

private:
    l3d_exit show_patches() {
        const l3d_patch_model model = afd_.model();
        l3d_canvas canvas = program_.create_canvas();
        return show<l3d_pipeline_afd_viewer>(std::move(canvas.screen), *canvas.rasterizers, model,
                                             afd_.camera(), afd_.settings());
    }

    template <class Pipeline, class... Arguments> l3d_exit show(Arguments&&... arguments) {
        const auto dispatcher = program_.create_dispatcher(); // step 3
        reporting<Pipeline> pipeline(afd_.report(), std::forward<Arguments>(arguments)...);
        pipeline.controls().set_turntable(afd_.turntable(),
                                          1 / program_.options().frame_settings().step());
        pipeline.controls().set_screenshot(l3d_save_screenshot);
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        return dispatcher->start();                    // step 5
    }

    l3d_program program_{"modelview",
                         "Draws models of polygons or patches from files of many formats. "
                         "In the window, h lists the keys.",
                         {1024, 768}};
    l3d_afd_options afd_;
    l3d_polygon_options polygons_;
};

} // namespace

int main(int argc, char** argv) {
    return modelview().run(argc, argv);
}
