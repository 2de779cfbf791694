// SPDX-License-Identifier: MIT
// gallery: turns coloured models, with smooth edges and the certified error of each frame.
#include "shapes.h"
#include <l3d/afd_options.h>
#include <l3d/camera.h>
#include <l3d/material.h>
#include <l3d/panel.h>
#include <l3d/pipeline_afd_viewer.h>
#include <l3d/program.h>
#include <l3d/transform.h>
#include <l3d/viewer.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace {

/// The place, size and speed of turning of a model.
struct exhibit {
    double x, z, scale, degrees_per_second;

    l3d_matrix<double> placement(double seconds) const {
        return l3d_translation<double>(x, 0, z) *
               l3d_rotation_y<double>(degrees_per_second * seconds) *
               l3d_scaling<double>(scale, scale, scale);
    }
};

/// Exhibits in the order in which make_scene adds them. The teapot's handle ends 3 units from its
/// axis. The other models are farther away at its height, so all turn freely.
constexpr exhibit exhibits[] = {{0, 0, 1, 12},
                                {-3.6, 1.4, 1, -20},
                                {4.1, 2.8, 1.1, 24},
                                {-2.9, -3.0, 1.1, 16},
                                {3.3, -2.8, 1.2, -14}};

l3d_patch_scene make_scene(const l3d_patch_model& first, bool glossy) {
    const l3d_patch_model models[] = {
        first, ring().painted({0xe0952f, 0x707070, 80}), waves().painted({0x6fae6f, 0x404040, 40}),
        vase().painted({0x3f6fb8, 0x909090, 120}), ball().painted({0xb8456b, 0x909090, 120})};
    l3d_patch_scene scene;
    for (std::size_t i = 0; i < std::size(models); ++i)
        scene.add_by_opacity(glossy ? models[i] : matt(models[i]), exhibits[i].placement(0));
    return scene;
}

/// The exhibit that an instance belongs to. A file's model has one instance for each opacity, the
/// others have one each.
const exhibit& exhibit_of(std::size_t instance, std::size_t instances) {
    const std::size_t of_first = instances - (std::size(exhibits) - 1);
    return exhibits[instance < of_first ? 0 : instance - of_first + 1];
}

// Step 2 of 5: the application is a pipeline.
class gallery_pipeline : public l3d_pipeline_afd_viewer {
public:
    using l3d_pipeline_afd_viewer::l3d_pipeline_afd_viewer;

    bool is_at_rest() const override { return controls().is_paused(); }

    void update_event(double seconds) override {
        l3d_pipeline_afd_viewer::update_event(seconds);
        if (controls().is_paused())
            return;
        seconds_ += seconds;
        const std::size_t count = scene().instances().size();
        for (std::size_t i = 0; i < count; ++i)
            scene().place(i, exhibit_of(i, count).placement(seconds_));
    }

private:
    l3d_standing_panel standing_panel() override {
        l3d_panel panel;
        panel.add("patches", std::to_string(scene().patch_count()));
        panel.add("error", rounded(bound()) + " pixels at most");
        if (screen().is_window()) // pictures in files are the same each time
            panel.add("frame", rounded(controls().pace().milliseconds()) + " ms");
        return {panel, l3d_corner::bottom_right};
    }

    static std::string rounded(double number) {
        std::array<char, 32> text{};
        const auto end = std::to_chars(text.data(), text.data() + text.size(), number,
                                       std::chars_format::fixed, 2);
        return {text.data(), end.ptr};
    }

    double seconds_ = 0;
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "gallery",
        "Coloured models of bicubic patches turn; FILE takes the teapot's place. A panel "
        "tells the\ncertified error of each frame. In the window, h lists the keys.",
        {1024, 640});
    const l3d_afd_options afd(program.options());
    bool glossy = false;
    program.options().add("--glossy", glossy,
                          "surfaces with highlights; --error-output bounds each pixel closely");
    l3d_camera camera;
    l3d_afd_settings settings;
    l3d_patch_scene scene;
    program.after_command_line([&] {
        camera = afd.camera();
        settings = afd.settings();
        scene = make_scene(
            afd.model_file().empty() ? colored_teapot() : in_teapots_place(afd.model()), glossy);
        afd.lay_picture(scene);
        return true;
    });
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_viewer<gallery_pipeline> pipeline(
            program, afd, program.create_canvas(afd.model_file().empty() ? "" : afd.model_title()),
            scene, camera, settings);
        if (!afd.places_camera()) {
            // The camera looks from some 24 degrees above, so that the front models do not hide
            // those behind them.
            camera.eye = camera.target + l3d_upright(camera.up).at(0.15, 0.45, 1.0);
            pipeline.controls().set_home([&] {
                return l3d_framed(camera, pipeline.screen().pixels().size(),
                                  l3d_reach_of(pipeline.scene()));
            });
        }
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        const l3d_exit result = dispatcher->start();   // step 5
        pipeline.finish();
        return result;
    });
}
