// SPDX-License-Identifier: MIT
// Measures the effort of scan line methods, and draws their pictures.
#include "frame_measure.h"
#include "report_alternatives.h"
#include "report_models.h"
#include "report_rows.h"
#include "report_table.h"

#include "compare/plotters/blinn_plotter.h"
#include "compare/method_patches.h"
#include "compare/plotters/whitted_plotter.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include "scene/image_transform.h"
#include "scene/placed_net.h"
#include "scene/camera_shading.h"
#include <l3d/image.h>
#include <l3d/screen_memory.h>
#include <l3d/font.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace {

/// Counts a plotter's iterations in a view.
template <class Plotter>
l3d_scan_effort effort_of(const l3d_patch_model& model, const l3d_camera& camera, l3d_size size) {
    l3d_patch_scene world(model);
    const l3d_image_transform to_image(camera, size, world);
    const l3d_dice_view view = to_image.view(0.25);
    l3d_image picture(size);
    l3d_depth_buffer depth;
    depth.resize(size);
    depth.clear();
    l3d_point_canvas canvas;
    canvas.begin(picture.pixels(), depth,
                 l3d_camera_shading(camera, size, l3d_shade::lambert, l3d_usual_light));
    l3d_dice_counts counts;
    Plotter plotter;
    for (std::size_t i = 0; i < model.patches().size(); ++i) {
        const l3d_image_patch net = l3d_placed_net(to_image.matrix(), model.patches()[i]);
        if (l3d_needs_no_clipping(net, view))
            plotter.plot(net, {model.normals(i), view, canvas, counts});
    }
    return plotter.effort();
}

std::string line_of(const std::string& model, const std::string& view, const std::string& method,
                    const l3d_scan_effort& effort) {
    return table_row(model, view, method, effort.solved, effort.solved_rounds, effort.failed,
                     effort.failed_rounds);
}

/// Levels farther off than this are wrong to any eye.
constexpr int wrong_levels = 32;
constexpr std::uint32_t magenta = 0xff00ff, white = 0xffffff;

/// Draws a method's picture, with wrong pixels in magenta.
void draw_panel(const measured_view& exact, const char* method, const l3d_pixels& to) {
    l3d_afd_settings settings;
    settings.antialias = false;
    settings.background = {};
    settings.threads = 1;
    std::string why;
    settings.method = l3d_method_choice::from_name(method, why).value().factory();
    l3d_pipeline_afd pipeline(l3d_memory_canvas(exact.size()), exact.model(), exact.camera(),
                              settings);
    pipeline.draw_event();
    const l3d_pixels drawn = pipeline.screen().pixels();
    std::size_t k = 0;
    int wrong = 0;
    for (int y = 0; y < drawn.height; ++y)
        for (std::size_t x = 0; x < static_cast<std::size_t>(drawn.width); ++x, ++k) {
            const std::uint32_t word = drawn.row(y)[x] & 0xffffff;
            const bool is_wrong =
                std::abs(static_cast<int>(word & 255) - int{exact.levels()[k]}) > wrong_levels;
            wrong += is_wrong;
            to.row(y)[x] = is_wrong ? magenta : word;
        }
    l3d_rasterizer_2d_sw_imp imp(to);
    l3d_rasterizer_2d rasterizer(imp);
    l3d_draw_text(rasterizer, 8, 8,
                  std::string(method) + ": " + std::to_string(pipeline.report().dice.failures) +
                      " failures, " + std::to_string(wrong) + " wrong pixels",
                  white);
    rasterizer.finish();
}

void write_folds_picture(const std::string& folder) {
    constexpr l3d_size panel{400, 320};
    const report_model folds = report_folds();
    const measured_view exact("folds", folds.model, folds.views[0].camera, panel);
    constexpr std::array methods{"whitted", "blinn", "lane-carpenter", "afd"};
    l3d_image image({2 * panel.width, 2 * panel.height}, 2 * panel.width);
    const l3d_pixels whole = image.pixels();
    for (std::size_t i = 0; i < methods.size(); ++i) {
        l3d_pixels part = whole;
        part.words += (i / 2) * static_cast<std::size_t>(panel.height) *
                          static_cast<std::size_t>(whole.stride) +
                      (i % 2) * static_cast<std::size_t>(panel.width);
        part.width = panel.width;
        part.height = panel.height;
        draw_panel(exact, methods[i], part);
    }
    l3d_write_image(folder + "/scan_folds.png", whole);
}

} // namespace

void write_scan_line_table(const std::string& folder, l3d_size size) {
    std::string text = "model,view,method,solved,solved_rounds,failed,failed_rounds\n";
    std::vector<report_model> models = report_models();
    models.resize(1); // the teapot
    models.push_back(report_folds());
    for (const report_model& each : models)
        for (const report_view& view : each.views) {
            text += line_of(each.name, view.name, "whitted",
                            effort_of<l3d_whitted_plotter>(each.model, view.camera, size));
            text += line_of(each.name, view.name, "blinn",
                            effort_of<l3d_blinn_plotter>(each.model, view.camera, size));
        }
    write_text(folder + "/scan_lines.csv", text);
    write_folds_picture(folder);
}
