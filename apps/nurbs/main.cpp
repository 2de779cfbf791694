// SPDX-License-Identifier: MIT
// nurbs: lets users drag control points and weights of NURBS surfaces.
#include "shapes.h"
#include <l3d/afd_options.h>
#include <l3d/camera.h>
#include <l3d/material.h>
#include <l3d/pipeline_afd_editor.h>
#include <l3d/program.h>
#include <l3d/viewer.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace {

/// Step 2 of 5: the application is a pipeline. The editor has the handles; this class adds shapes.
class nurbs_pipeline : public l3d_pipeline_afd_editor {
public:
    nurbs_pipeline(l3d_canvas canvas, const l3d_patch_model& model,
                   std::vector<l3d_nurbs_surface> surfaces, const l3d_camera& camera,
                   const l3d_afd_settings& settings)
        : l3d_pipeline_afd_editor(std::move(canvas), model, camera, settings) {
        controls().add({"m", "another shape", {{'m', [this] { show_next_shape(); }}}});
        edit(model, std::move(surfaces));
    }

    /// Shows the whole net from some 24 degrees above, so that points in front hide few behind
    /// them.
    void look_at_net() {
        controls().set_home([this] {
            l3d_camera from = camera();
            from.eye = from.target + l3d_upright(from.up).at(0.35, 0.45, 1.0);
            return l3d_framed(from, screen().pixels().size(), handles()->reach());
        });
    }

    static l3d_patch_model model_of(const std::vector<l3d_nurbs_surface>& surfaces) {
        return l3d_patch_model::from_surfaces(surfaces).painted(l3d_material{.color = 0x5f8fc0});
    }

private:
    /// Shows the next shape. If there was a file's model, it does not come again.
    void show_next_shape() {
        const shape next = shape_at(next_ = (next_ + 1) % shape_count());
        edit(model_of(next.surfaces), next.surfaces);
        look_at_net();
        controls().say(std::string(next.name));
    }

    std::size_t next_ = 0;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("nurbs",
                        "Control points and weights of NURBS surfaces are dragged in the window: "
                        "of a vase, of\nother shapes by the key m, or of FILE. A panel tells the "
                        "certified error of each frame.\nIn the window, h lists the keys.",
                        {1024, 768});
    const l3d_afd_options afd(program.options());
    l3d_camera camera;
    l3d_afd_settings settings;
    std::vector<l3d_nurbs_surface> surfaces;
    l3d_patch_model model;
    program.after_command_line([&] {
        camera = afd.camera();
        settings = afd.settings();
        if (afd.model_file().empty()) {
            surfaces = shape_at(0).surfaces;
            model = nurbs_pipeline::model_of(surfaces);
        } else {
            model = afd.model();
            surfaces = afd.surfaces(model);
        }
        return true;
    });
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_viewer<nurbs_pipeline> pipeline(
            program, afd, program.create_canvas(afd.model_file().empty() ? "" : afd.model_title()),
            model, surfaces, camera, settings);
        pipeline.tell_times(program.options().frame_settings().frames == 0);
        if (!afd.places_camera())
            pipeline.look_at_net();
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        const l3d_exit result = dispatcher->start();   // step 5
        pipeline.finish();
        return result;
    });
}
