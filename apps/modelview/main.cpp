// SPDX-License-Identifier: MIT
// modelview: any model file, by any pipeline.
#include <l3d/pipeline_afd_viewer.h>
#include <l3d/pipeline_zbuffer.h>
#include <l3d/pipeline_zsort.h>
#include <l3d/rasterizer_factory_mesa.h>
#include <l3d/rasterizer_factory_sw.h>
#include <l3d/polygon_options.h>
#include <l3d/program.h>
#include <l3d/viewer.h>

#include <type_traits>
#include <utility>

namespace {

// Step 2 of 5: the application is a pipeline, here one of three viewers.
class modelview {
public:
    modelview() : afd_(program_.options()), polygons_(program_.options(), afd_) {}

    int run(int argc, char** argv) {
        return program_.run(argc, argv, [this] { // step 1: choose factories
            if (polygons_.pipeline() == l3d_pipeline_kind::afd)
                return show_patches();
            const l3d_polygon_settings settings = polygons_.settings();
            const l3d_polygon_model model = polygons_.model();
            const l3d_camera camera = polygons_.camera(model);
            const auto show_polygons = [&]<class Pipeline>(std::type_identity<Pipeline>,
                                                           const auto&... more) {
                return show<Pipeline>(program_.create_canvas(), model, camera, settings, more...);
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
        const l3d_afd_settings settings = afd_.settings();
        const l3d_camera camera = afd_.camera();
        const l3d_patch_model model = afd_.model();
        l3d_canvas canvas = program_.create_canvas();
        return show<l3d_pipeline_afd_viewer>(std::move(canvas.screen), *canvas.rasterizers, model,
                                             camera, settings);
    }

    template <class Pipeline, class... Arguments> l3d_exit show(Arguments&&... arguments) {
        const auto dispatcher = program_.create_dispatcher(); // step 3
        l3d_viewer<Pipeline> pipeline(program_, afd_, std::forward<Arguments>(arguments)...);
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        const l3d_exit result = dispatcher->start();   // step 5
        pipeline.finish();
        return result;
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
