// SPDX-License-Identifier: MIT
// surfview: shows any file of surfaces or polygons, with its parts, sections and measures.
#include "audit.h"
#include "part_viewer.h"

#include <l3d/afd_options.h>
#include <l3d/part_options.h>
#include <l3d/pipeline_zbuffer.h>
#include <l3d/pipeline_zsort.h>
#include <l3d/polygon_options.h>
#include <l3d/program.h>
#include <l3d/rasterizer_factory.h>
#include <l3d/viewer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

// Step 2 of 5: the application is a pipeline, chosen by what the file holds.
class surfview {
public:
    surfview()
        : afd_(program_.options()), polygons_(program_.options(), afd_, true),
          parts_(program_.options()) {
        l3d_options& options = program_.options();
        options.begin_group("Section");
        options.add(
            "--section", normal_,
            "cut the model open: draw what lies in this direction from the plane across it");
        options.add("--section-at", place_,
                    "a place of that plane; without it, the middle of the model");
        options.begin_group("Audit");
        options.add("--audit", mesh_file_,
                    "print as JSON how far this mesh is from the surfaces, and where; --output "
                    "shows it in colours",
                    "FILE");
        options.prints_result("--audit");
        options.add("--audit-tolerance", tolerance_,
                    "the width of the bounds that --audit prints, by the model's diagonal", 1e-9,
                    1);
        options.begin_group("Edges");
        options.add(
            "--list-edges", lists_edges_,
            "draw nothing; list the ten edges that are farthest off their faces beyond what "
            "the file allows, with places and faces");
        options.prints_result("--list-edges");
        options.add_example("part.step --audit part.stl --output audit.png",
                            "a mesh's largest distance from its part, as JSON and in colours");
        options.add_example("part.step --section -1,0,0 --hide cover",
                            "a part without its cover, and without its half of larger x");
    }

    int run(int argc, char** argv) {
        program_.after_command_line([this] {
            l3d_refuse(
                {{"--section-at", place_ && !normal_, "--section says across which direction"},
                 {"--section", normal_ == vector{0.0, 0.0, 0.0}, "no direction"},
                 {"--list-edges", lists_edges_ && !mesh_file_.empty(), "--audit prints, too"},
                 {"--list-edges", lists_edges_ && parts_.lists(), "--list-parts prints, too"}});
            if (lists_edges_)
                list_edges();
            else if (!mesh_file_.empty())
                shows_ = audited();
            else if (parts_.lists())
                polygons_.list_parts();
            else
                shows_ = prepared();
            return shows_ != nullptr;
        });
        return program_.run(argc, argv, [this] { return shows_(); }); // step 1: choose factories
    }

private:
    using vector = l3d_vector<double, 3>;

    /// Prepares the other steps; returns nothing if all is done. Wrong options and models are
    /// reported here, before any message or question about a back-end.
    std::function<l3d_exit()> prepared() {
        const l3d_camera camera = afd_.camera();
        const l3d_pipeline_kind pipeline = polygons_.pipeline();
        if (pipeline == l3d_pipeline_kind::afd) {
            polygons_.refuse_for_patches();
            const l3d_afd_settings settings = afd_.settings();
            l3d_refuse({{"--section", normal_ && settings.error_map,
                         "--error-output has bounds of whole surfaces alone"},
                        {"--section", normal_ && afd_.wants_drawing(),
                         "line drawings are of whole surfaces"}});
            const l3d_patch_scene whole = afd_.scene();
            const l3d_parts parts = whole.parts();
            check_names(parts);
            if (afd_.write_svg(parts_.scene(whole)))
                return {};
            l3d_patch_scene scene = parts_.scene_by_opacity(whole);
            afd_.lay_picture(scene);
            const section_plane section = section_through(whole.pieces_middle());
            return [=, this] {
                return show<patches_in_parts>(parts, section, scene, camera, settings);
            };
        }
        parts_.refuse_for_polygons();
        const l3d_polygon_settings settings = polygons_.settings();
        const l3d_polygon_model model = polygons_.model();
        check_names(model.parts());
        const section_plane section = section_through(model.centre());
        return [=, this] {
            const auto show_by = [&]<class Pipeline>(const auto&... more) {
                return show<polygons_in_parts<Pipeline>>(model.parts(), section, model, camera,
                                                         settings, more...);
            };
            switch (pipeline) {
            case l3d_pipeline_kind::zsort:
                if (program_.draws_by_gl())
                    throw l3d_error(l3d_exit::usage,
                                    "--pipeline zsort: processors paint polygons in order, and "
                                    "--backend mesa asks for GL, which --pipeline zbuffer has");
                return show_by.template operator()<l3d_pipeline_zsort>();
            case l3d_pipeline_kind::mesa:
                return show_by.template operator()<l3d_pipeline_zbuffer>(gl(), "mesa");
            default: // drawn by the back-end's rasterizers
                return show_by.template operator()<l3d_pipeline_zbuffer>();
            }
        };
    }

    /// Lists edges that are off their faces, the worst one first.
    void list_edges() {
        constexpr std::size_t most = 10;
        const l3d_patch_model model = afd_.model();
        const auto loose = model.loose_edges();
        for (std::size_t i = 0; i < std::min(most, loose.size()); ++i) {
            const l3d_loose_edge& one = loose[i];
            // Names of faces, or of pieces if the file numbers no faces.
            std::vector<std::string> faces;
            for (const std::size_t piece : one.pieces) {
                const std::uint32_t face = model.face_of(piece);
                std::string name = face > 0 ? "face " + std::to_string(face)
                                            : "piece " + std::to_string(piece + 1);
                if (std::ranges::find(faces, name) == faces.end())
                    faces.push_back(std::move(name));
            }
            std::cout << "edge " << one.edge + 1 << ": off by " << one.off << ", not "
                      << one.tolerance << ", at " << one.place[0] << ',' << one.place[1] << ','
                      << one.place[2];
            for (const std::string& face : faces)
                std::cout << ", " << face;
            std::cout << '\n';
        }
    }

    /// Compares a mesh with the model. Returns the step that shows the picture; nothing if none is
    /// wanted.
    std::function<l3d_exit()> audited() {
        l3d_refuse({{"--audit", normal_.has_value(), "it compares whole models"},
                    {"--audit", parts_.lists(), "--list-parts prints, too"}});
        const l3d_patch_model model = afd_.model();
        const auto audit =
            std::make_shared<const mesh_audit>(afd_.model_file(), model, mesh_file_, tolerance_);
        std::cout << audit->json() << std::endl;
        if (const std::string hint = audit->hint(); !hint.empty())
            std::cerr << "surfview: --audit: " << hint << '\n';
        if (program_.options().common().output.empty())
            return {};
        return [audit, this] {
            const auto dispatcher = program_.create_dispatcher();
            l3d_camera camera = afd_.camera();
            if (!afd_.places_camera())
                camera.eye = camera.target + audit->sight();
            audit_viewer pipeline(program_.create_canvas(afd_.model_title()), *audit, camera,
                                  polygons_.settings());
            if (!afd_.places_camera())
                pipeline.frame_all();
            dispatcher->plug(pipeline, pipeline.screen());
            return dispatcher->start();
        };
    }

    /// The rasterizers of the back-end, if it draws by GL; else the first ones found.
    const l3d_rasterizer_factory_mesa& gl() {
        const auto* const by_gl = dynamic_cast<const l3d_rasterizer_factory_mesa*>(
            program_.factories().chosen().rasterizer_factory.get());
        return by_gl ? *by_gl : any_gl_;
    }

    /// Refuses options that name parts which the model does not have.
    void check_names(const l3d_parts& parts) const {
        l3d_part_list list;
        list.set_names(parts.names());
        parts_.put_into(list, parts);
    }

    /// `arguments` are those of Shown's constructor after the canvas.
    template <class Shown, class... Arguments>
    l3d_exit show(const l3d_parts& parts, const section_plane& section,
                  const Arguments&... arguments) {
        const auto dispatcher = program_.create_dispatcher(); // step 3
        l3d_viewer<part_viewer<Shown>> pipeline(
            program_, afd_, program_.create_canvas(afd_.model_title()), arguments...);
        // Pictures that are counted or written are the same in windows and in files.
        const l3d_frame_settings frames = program_.options().frame_settings();
        const bool with_list =
            pipeline.screen().is_window() && frames.frames == 0 && frames.output.empty();
        pipeline.begin([&](l3d_part_list& list) { parts_.put_into(list, parts); }, section,
                       with_list);
        pipeline.controls().set_view_teller([&] { return told_view(pipeline); });
        dispatcher->plug(pipeline, pipeline.screen()); // step 4
        const l3d_exit result = dispatcher->start();   // step 5
        pipeline.finish();
        return result;
    }

    /// The options that make the present view again, with its parts and section. They are printed
    /// on stderr, too, to be copied from there.
    template <class Pipeline> static std::string told_view(Pipeline& pipeline) {
        std::string text = l3d_afd_options::view_options(pipeline.camera());
        if constexpr (requires { pipeline.settings().rotation; })
            text += l3d_polygon_options::view_options(pipeline.settings());
        const auto shade = static_cast<std::size_t>(pipeline.settings().shade);
        if (pipeline.settings().shade != l3d_afd_settings().shade)
            text += std::string(" --shade ") + l3d_shade_names[shade].first;
        text += pipeline.part_options();
        std::cerr << text << '\n';
        return text;
    }

    section_plane section_through(const vector& middle) const {
        if (!normal_)
            return std::nullopt;
        return l3d_plane<double>::through(l3d_point<double>(place_.value_or(middle)), *normal_);
    }

    l3d_program program_{"surfview",
                         "Shows files of surfaces or polygons: their parts, sections and measures. "
                         "In the window, h lists the keys.",
                         {1024, 768}};
    l3d_rasterizer_factory_mesa any_gl_;
    l3d_afd_options afd_;
    l3d_polygon_options polygons_;
    l3d_part_options parts_;
    std::optional<vector> normal_, place_;
    bool lists_edges_ = false;
    std::string mesh_file_;
    double tolerance_ = l3d_surface_audit::usual_tolerance;
    std::function<l3d_exit()> shows_;
};

} // namespace

int main(int argc, char** argv) {
    return surfview().run(argc, argv);
}
