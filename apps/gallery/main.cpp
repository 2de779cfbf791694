// SPDX-License-Identifier: MIT
// gallery: coloured models that turn, with smooth edges and the certified error of each frame.
#include "shapes.h"
#include <l3d/afd_options.h>
#include <l3d/framing.h>
#include <l3d/material.h>
#include <l3d/panel.h>
#include <l3d/pipeline_afd_viewer.h>
#include <l3d/program.h>
#include <l3d/transform.h>
#include <l3d/viewer.h>

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <string>
#include <vector>

namespace {

/// Where a model stands, and how fast it turns.
struct exhibit {
    double x, z, size, degrees_per_second;

    l3d_matrix<double> placement(double seconds) const {
        return l3d_translation<double>(x, 0, z) *
               l3d_rotation_y<double>(degrees_per_second * seconds) *
               l3d_scaling<double>(size, size, size);
    }
};

/// In the order in which make_scene adds them.
constexpr exhibit exhibits[] = {{0, 0, 1, 12},
                                {-3.6, 1.4, 1, -20},
                                {3.4, 2.0, 1.1, 24},
                                {-2.9, -3.0, 1.1, 16},
                                {3.3, -2.8, 1.2, -14}};

/// Takes a model of any size to where the teapot would stand: as high or as wide, on the ground.
l3d_matrix<double> fitted(const l3d_patch_model& model) {
    constexpr double height = 3, width = 4;
    const auto extent = model.most() - model.least();
    const double scale = std::min(height / std::max(extent[1], 1e-300),
                                  width / std::max({extent[0], extent[2], 1e-300}));
    const auto middle = (model.least() + model.most()) * 0.5;
    return l3d_scaling<double>(scale, scale, scale) *
           l3d_translation<double>(-middle[0], -model.least()[1], -middle[2]);
}

/// Without `glossy`, no material has highlights, and all shades are certified.
l3d_patch_scene make_scene(const l3d_patch_model& first, const l3d_matrix<double>& fit,
                           bool glossy) {
    const auto made_of = [glossy](l3d_material material) {
        return glossy ? material : l3d_material{.color = material.color};
    };
    l3d_patch_model middle = first;
    if (!glossy && !middle.materials().empty()) {
        std::vector<l3d_material> materials;
        for (std::size_t i = 0; i < middle.patches().size(); ++i)
            materials.push_back(made_of(middle.materials()[middle.material_of(i)]));
        middle = middle.painted(materials);
    }
    const l3d_patch_model models[] = {middle, ring().painted(made_of({0xe0952f, 0x707070, 80})),
                                      waves().painted(made_of({0x6fae6f, 0x404040, 40})),
                                      vase().painted(made_of({0x3f6fb8, 0x909090, 120})),
                                      ball().painted(made_of({0xb8456b, 0x909090, 120}))};
    l3d_patch_scene scene;
    for (std::size_t i = 0; i < std::size(models); ++i)
        scene.add(models[i], exhibits[i].placement(0) * (i == 0 ? fit : l3d_identity<double>()));
    return scene;
}

// Step 2 of 5: the application is a pipeline.
class gallery_pipeline : public l3d_pipeline_afd_viewer {
public:
    using l3d_pipeline_afd_viewer::l3d_pipeline_afd_viewer;

    void update_event(double seconds) override {
        l3d_pipeline_afd_viewer::update_event(seconds);
        seconds_ += seconds;
        for (std::size_t i = 0; i < std::size(exhibits); ++i)
            scene().place(i, exhibits[i].placement(seconds_) *
                                 (i == 0 ? fit_ : l3d_identity<double>()));
    }

    /// How the model in the middle is fitted to its place.
    void set_fit(const l3d_matrix<double>& fit) { fit_ = fit; }

private:
    void draw_overlay() override {
        l3d_panel panel;
        panel.add("patches", std::to_string(scene().patch_count()));
        panel.add("error", rounded(bound()) + " pixels at most");
        if (screen().is_window()) // files are the same each time
            panel.add("frame", rounded(last_report().time_ms.total) + " ms");
        l3d_pixel_box free = l3d_whole(screen().pixels().size());
        panel.draw(rasterizer(), free, l3d_corner::bottom_right, controls().panel_style());
        l3d_pipeline_afd_viewer::draw_overlay();
    }

    static std::string rounded(double number) {
        char text[32];
        std::snprintf(text, sizeof text, "%.2f", number);
        return text;
    }

    double seconds_ = 0;
    l3d_matrix<double> fit_ = l3d_identity<double>();
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program(
        "gallery",
        "Coloured models of bicubic patches turn. A panel tells the certified error "
        "of each frame.\nIn the window, h lists the keys.",
        {1024, 640});
    const l3d_afd_options afd(program.options());
    bool glossy = false;
    program.options().add("--glossy", glossy, "highlights, which take longer and have no bound");
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        l3d_camera camera = afd.camera();
        l3d_afd_settings settings = afd.settings();
        if (!afd.background())
            settings.background = l3d_background::gradient();
        const bool is_given = !afd.model_file().empty();
        const l3d_patch_model first = is_given ? afd.model() : colored_teapot();
        const auto fit = is_given ? fitted(first) : l3d_identity<double>();
        l3d_viewer<gallery_pipeline> pipeline(program, afd, program.create_canvas("gallery"),
                                              make_scene(first, fit, glossy), camera, settings);
        pipeline.set_fit(fit);
        if (!afd.places_camera()) {
            camera.eye = camera.target + l3d_camera::vector(0.15, 0.45, 1.0);
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
