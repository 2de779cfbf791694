// SPDX-License-Identifier: MIT
// modelview: shows any model file by any pipeline.
#include <l3d/pipeline_afd_viewer.h>
#include <l3d/pipeline_zbuffer.h>
#include <l3d/pipeline_zsort.h>
#include <l3d/rasterizer_factory.h>
#include <l3d/part_options.h>
#include <l3d/polygon_options.h>
#include <l3d/program.h>
#include <l3d/viewer.h>

#include <functional>

namespace {

// Step 2 of 5: the application is a pipeline, here one of three viewers.
class modelview {
public:
    modelview()
        : afd_(program_.options()), polygons_(program_.options(), afd_),
          parts_(program_.options()) {}

    int run(int argc, char** argv) {
        program_.after_command_line([this] {
            if (parts_.lists())
                polygons_.list_parts();
            else
                shows_ = prepared();
            return shows_ != nullptr;
        });
        return program_.run(argc, argv, [this] { return shows_(); }); // step 1: choose factories
    }

private:
    /// Prepares the other steps; returns nothing if all is done. Wrong options and models are
    /// reported here, before any message or question about a back-end.
    std::function<l3d_exit()> prepared() {
        const l3d_camera camera = afd_.camera();
        if (polygons_.pipeline() == l3d_pipeline_kind::afd) {
            polygons_.refuse_for_patches();
            const l3d_afd_settings settings = afd_.settings();
            l3d_patch_scene scene = parts_.scene(afd_.scene());
            afd_.lay_picture(scene);
            if (afd_.write_svg(scene))
                return {};
            return [=, this] { return show<l3d_pipeline_afd_viewer>(scene, camera, settings); };
        }
        const l3d_polygon_settings settings = polygons_.settings();
        return [=, this, model = parts_.applied(polygons_.model())] {
            switch (polygons_.pipeline()) {
            case l3d_pipeline_kind::zsort:
                if (program_.draws_by_gl())
                    throw l3d_error(l3d_exit::usage,
                                    "--pipeline zsort: processors paint polygons in order, and "
                                    "--backend mesa asks for GL, which --pipeline zbuffer has");
                return show<l3d_pipeline_zsort>(model, camera, settings);
            case l3d_pipeline_kind::mesa:
                return show<l3d_pipeline_zbuffer>(model, camera, settings, gl(), "mesa");
            default: // drawn by the back-end's rasterizers
                return show<l3d_pipeline_zbuffer>(model, camera, settings);
            }
        };
    }

    /// The rasterizers of the back-end, if it draws by GL; else the first ones found.
    const l3d_rasterizer_factory_mesa& gl() {
        const l3d_rasterizer_factory* const chosen =
            program_.factories().chosen().rasterizer_factory.get();
        const auto* const by_gl = dynamic_cast<const l3d_rasterizer_factory_mesa*>(chosen);
        return by_gl ? *by_gl : any_gl_;
    }

    /// `arguments` are those of the Pipeline's constructor after the canvas.
    template <class Pipeline, class... Arguments> l3d_exit show(const Arguments&... arguments) {
        const auto dispatcher = program_.create_dispatcher(); // step 3
        l3d_viewer<Pipeline> pipeline(program_, afd_, program_.create_canvas(afd_.model_title()),
                                      arguments...);
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        const l3d_exit result = dispatcher->start();   // step 5
        pipeline.finish();
        return result;
    }

    l3d_program program_{"modelview",
                         "Draws models of polygons or patches from files of many formats. "
                         "In the window, h lists the keys.",
                         {1024, 768}};
    l3d_rasterizer_factory_mesa any_gl_;
    l3d_afd_options afd_;
    l3d_polygon_options polygons_;
    l3d_part_options parts_;
    std::function<l3d_exit()> shows_;
};

} // namespace

int main(int argc, char** argv) {
    return modelview().run(argc, argv);
}
