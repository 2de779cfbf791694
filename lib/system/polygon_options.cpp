// SPDX-License-Identifier: MIT
// l3d_polygon_options: declarations, the model, and the camera that frames it.
#include "system/polygon_options.h"

#include "geom/files/model_file.h"
#include "pipeline/polygons/patch_tessellation.h"
#include "system/places.h"
#include "tool_2d/text_file.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>
#include <utility>

namespace {

/// Directions as seen by a person who stands upright before a model.
struct upright_frame {
    l3d_camera::vector right, up, front;

    explicit upright_frame(const l3d_camera::vector& upwards) : up(l3d_normalized(upwards)) {
        // Front is the z axis, or -y where that is up.
        const bool z_is_up = std::abs(up[2]) > 0.9;
        const l3d_camera::vector across =
            z_is_up ? l3d_camera::vector{0.0, -1.0, 0.0} : l3d_camera::vector{0.0, 0.0, 1.0};
        right = l3d_normalized(l3d_cross(up, across));
        front = l3d_cross(right, up);
    }
};

} // namespace

l3d_polygon_options::l3d_polygon_options(l3d_options& options, const l3d_afd_options& shared)
    : shared_(shared) {
    options.add_choice<l3d_pipeline_kind>(
        "--pipeline", pipeline_,
        "who is in front: patches by afd; polygons sorted and cut, by a depth buffer, or by GL",
        {{"afd", l3d_pipeline_kind::afd},
         {"zsort", l3d_pipeline_kind::zsort},
         {"zbuffer", l3d_pipeline_kind::zbuffer},
         {"mesa", l3d_pipeline_kind::mesa}});
    options.add("--parallel", parallel_, "parallel projection of polygons");
    options.add("--hidden-lines", hidden_lines_, "lines of polygons, what is hidden removed");
    options.add("--all-faces", all_faces_, "draw faces seen from behind, too");
    options.add("--rotate", rotation_,
                "degrees that polygons are turned about x, then y, then z, round their middle");
    options.add("--to-origin", to_origin_, "move the mean of the polygons' vertices to the origin");
    options.add("--facets", facets_, "patches as N by N quads, where polygons are drawn", 1,
                l3d_most_facets);
}

l3d_polygon_model l3d_polygon_options::model() const {
    std::string why;
    l3d_polygon_mesh mesh;
    bool has_patches = true;
    if (const std::string& name = shared_.model_file(); !name.empty()) {
        auto file = l3d_read_model(l3d_read_text_file(l3d_data_file(name)), name, why);
        if (!file)
            throw l3d_error(l3d_exit::bad_input, why);
        for (const std::string& note : file->notes)
            std::cerr << note << '\n';
        mesh = std::move(file->mesh);
        has_patches = !file->patches.empty();
        if (!has_patches && mesh.faces() == 0)
            throw l3d_error(l3d_exit::bad_input, name + ": no polygons and no patches");
    }
    if (has_patches)
        mesh.append(l3d_tessellated(shared_.model(), facets_).mesh);
    return l3d_polygon_model(std::move(mesh), to_origin_);
}

l3d_camera l3d_polygon_options::camera(const l3d_polygon_model& model) const {
    l3d_camera camera = shared_.camera();
    if (shared_.places_camera())
        return camera;
    const double radius = model.radius() > 0 ? model.radius() : 1;
    constexpr double margin = 1.05;
    const double half_angle = camera.fov / 2 * std::numbers::pi / 180;
    const double distance = margin * radius / std::sin(half_angle);
    const upright_frame frame(camera.up);
    camera.target = model.centre();
    camera.eye = camera.target +
                 l3d_normalized(frame.front + frame.right * 0.35 + frame.up * 0.45) * distance;
    camera.near = std::min(camera.near, 1e-3 * radius);
    return camera;
}

l3d_polygon_settings l3d_polygon_options::settings() const {
    const l3d_afd_settings shared = shared_.settings();
    if (shared.depth)
        throw l3d_error(l3d_exit::usage,
                        "--depth-output: only --pipeline afd keeps the distances for it");
    if (shared.error_map)
        throw l3d_error(l3d_exit::usage,
                        "--error-output: only --pipeline afd has the bounds for it");
    if (shared.shade == l3d_shade::error)
        throw l3d_error(l3d_exit::usage,
                        "--shade: only --pipeline afd has the bound that error shows");
    l3d_polygon_settings settings;
    settings.style = hidden_lines_      ? l3d_polygon_style::hidden_lines
                     : shared.wireframe ? l3d_polygon_style::wireframe
                                        : l3d_polygon_style::solid;
    settings.shade = shared.shade;
    settings.projection = parallel_ ? l3d_projection::parallel : l3d_projection::perspective;
    settings.light = shared.light;
    if (!shared_.places_camera() && !shared_.places_light()) {
        // The teapot's, from where this model is looked at.
        const upright_frame frame(shared_.camera().up);
        settings.light = frame.right * shared.light[0] + frame.up * shared.light[1] +
                         frame.front * shared.light[2];
    }
    settings.rotation = rotation_;
    settings.cull = !all_faces_;
    settings.antialias = shared.antialias;
    settings.background = shared.background;
    settings.count_pixels = shared.count_pixels;
    settings.threads = shared.threads;
    return settings;
}
