// SPDX-License-Identifier: MIT
// l3d_polygon_options: declares the options, and makes the settings and the model.
#include "system/options/polygon_options.h"

#include "base/printable_p.h"
#include "pipeline/polygons/polygon_model.h"
#include "scene/drawing/lost_lines_p.h"
#include "system/options/model_names_p.h"
#include "system/options/number_text.h"
#include "system/options/part_options.h"
#include "system/long_work_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iostream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

constexpr std::array<std::pair<const char*, l3d_rotation_order>, 6> rotation_orders{
    {{"xyz", l3d_rotation_order::xyz},
     {"xzy", l3d_rotation_order::xzy},
     {"yxz", l3d_rotation_order::yxz},
     {"yzx", l3d_rotation_order::yzx},
     {"zxy", l3d_rotation_order::zxy},
     {"zyx", l3d_rotation_order::zyx}}};

} // namespace

l3d_polygon_options::l3d_polygon_options(l3d_options& options, const l3d_afd_options& shared,
                                         bool prefers_patches)
    : shared_(shared), prefers_patches_(prefers_patches) {
    options.begin_group("Polygons");
    const std::string suitable =
        prefers_patches_ ? "auto is afd for patches alone"
                         : "auto is afd for trimmed surfaces, --subdivide, --drawing and --svg";
    options.add_choice<l3d_pipeline_kind>(
        "--pipeline", pipeline_,
        "afd draws patches; zsort sorts and cuts polygons, zbuffer has a depth buffer, mesa has GL "
        "draw them; " +
            suitable + ", else zbuffer",
        {{"auto", l3d_pipeline_kind::suitable},
         {"afd", l3d_pipeline_kind::afd},
         {"zsort", l3d_pipeline_kind::zsort},
         {"zbuffer", l3d_pipeline_kind::zbuffer},
         {"mesa", l3d_pipeline_kind::mesa}});
    options.add("--hidden-lines", hidden_lines_, "lines of polygons, without what faces hide");
    options.add("--rotate", rotation_,
                "degrees that polygons are turned about x, y and z, round their middle");
    options.add_choice<l3d_rotation_order>("--rotate-order", rotation_order_,
                                           "which turn of --rotate comes first, second and last",
                                           {rotation_orders.begin(), rotation_orders.end()});
    options.add("--to-origin", to_origin_, "move the mean of the polygons' vertices to the origin");
    options.add("--crease-angle", crease_angle_,
                "faces whose normals are more degrees apart meet in a crease", 0.0, 180.0);
    options.add("--no-textures", no_textures_, "polygons without the pictures on them");
    options.add("--facets", facets_, "patches as N by N quads, where polygons are drawn", 1,
                l3d_most_facets);
}

std::string l3d_polygon_options::view_options(const l3d_polygon_settings& settings) {
    const l3d_polygon_settings usual;
    std::string text;
    if (settings.rotation != usual.rotation)
        text += " --rotate " + l3d_number_text(settings.rotation[0]) + ',' +
                l3d_number_text(settings.rotation[1]) + ',' + l3d_number_text(settings.rotation[2]);
    for (const auto& [word, order] : rotation_orders)
        if (settings.rotation_order == order && order != usual.rotation_order)
            text += std::string(" --rotate-order ") + word;
    return text;
}

l3d_pipeline_kind l3d_polygon_options::pipeline() const {
    if (chosen_)
        return *chosen_;
    const auto is_best_as_patches = [&] {
        return shared_.subdivides() || shared_.has_trims() ||
               (prefers_patches_ && shared_.is_of_patches());
    };
    if (shared_.wants_drawing())
        chosen_ = l3d_pipeline_kind::afd;
    else if (pipeline_ != l3d_pipeline_kind::suitable)
        chosen_ = pipeline_;
    else
        chosen_ = is_best_as_patches() ? l3d_pipeline_kind::afd : l3d_pipeline_kind::zbuffer;
    return *chosen_;
}

void l3d_polygon_options::list_parts() const {
    if (pipeline() == l3d_pipeline_kind::afd)
        l3d_part_options::list(shared_.scene().parts(), "patches");
    else
        l3d_part_options::list(model().parts(), "faces");
}

l3d_polygon_model l3d_polygon_options::model() const {
    const std::string& name = shared_.model_file();
    if (name.empty())
        return l3d_polygon_model(l3d_tessellated(shared_.model(), facets_).mesh, to_origin_);
    l3d_model_file file = shared_.file();
    l3d_detail::note_lines_lost_to_polygons(file, name, file.notes);
    for (const std::string& note : file.notes)
        std::cerr << note << '\n';
    l3d_polygon_mesh mesh = l3d_mesh_of(file, name, facets_);
    const bool is_opaque =
        std::ranges::all_of(mesh.looks, [](const l3d_material& m) { return m.opacity == 1; });
    if (!is_opaque)
        std::cerr << l3d_detail::printable(name)
                  << ": transparent materials are opaque here; only patches are seen through, by "
                     "--pipeline afd\n";
    const l3d_polygon_model plain(std::move(mesh), to_origin_, crease_angle_);
    if (no_textures_)
        return plain;
    std::vector<std::string> notes;
    l3d_polygon_model model = plain.textured(l3d_read_textures(plain.mesh(), notes));
    for (const std::string& note : notes)
        std::cerr << note << '\n';
    return model;
}

void l3d_polygon_options::refuse_for_patches() const {
    const l3d_polygon_settings usual;
    const std::string why = "only polygons have it, and --pipeline afd draws patches";
    l3d_refuse({{"--hidden-lines", hidden_lines_, why},
                {"--rotate", rotation_ != usual.rotation, why},
                {"--rotate-order", rotation_order_ != usual.rotation_order, why},
                {"--to-origin", to_origin_, why},
                {"--crease-angle", crease_angle_ != l3d_usual_crease_angle, why},
                {"--no-textures", no_textures_, why},
                {"--facets", facets_ != l3d_usual_facets, why}});
}

l3d_polygon_settings l3d_polygon_options::settings() const {
    const l3d_afd_settings shared = shared_.settings();
    const std::string why = "polygons are drawn as they are; only --pipeline afd has it";
    l3d_refuse({
        {"--depth-output", shared.depth, "only --pipeline afd keeps the distances for it"},
        {"--error-output", shared.error_map, "only --pipeline afd has the bounds for it"},
        {"--shade", shared.shade == l3d_shade::error,
         "only --pipeline afd has the bound that error shows"},
        {"--shade", l3d_is_inspection(shared.shade),
         "only --pipeline afd has the exact patches that zebra, isophotes, gaussian, mean and "
         "draft look at"},
        {"--net", shared.net, why},
        {"--texture", shared_.gives_texture(), why},
        {"--tolerance", shared_.gives_tolerance(), why},
        {"--lateral-only", shared.lateral_only, why},
        {"--keep-all", shared.keep.drawing, why},
        {"--hidden-lines", hidden_lines_ && shared.shade != l3d_afd_settings().shade,
         std::string("lines have one colour, and show nothing of --shade ") +
             l3d_shade_names[static_cast<std::size_t>(shared.shade)].first},
    });
    l3d_polygon_settings settings;
    settings.style = hidden_lines_      ? l3d_polygon_style::hidden_lines
                     : shared.wireframe ? l3d_polygon_style::wireframe
                                        : l3d_polygon_style::solid;
    settings.shade = shared.shade;
    settings.light = shared.light;
    settings.lighting = shared.lighting;
    settings.headlight = shared.headlight;
    if (!shared_.places_camera() && !shared_.places_light()) {
        // The light is that of the teapot, turned to this model's view.
        settings.light =
            l3d_upright(shared_.camera().up).at(shared.light[0], shared.light[1], shared.light[2]);
    }
    settings.textures = no_textures_ ? std::nullopt : std::optional(shared.texture_filter);
    settings.rotation = rotation_;
    settings.rotation_order = rotation_order_;
    settings.cull = shared.one_sided;
    settings.antialias = shared.antialias;
    settings.background = shared.background;
    settings.fog = shared.fog;
    settings.count_pixels = shared.count_pixels;
    settings.threads = shared.threads;
    return settings;
}
