// SPDX-License-Identifier: MIT
// teapot_afd: draws the Utah teapot, or any bicubic patches, by adaptive forward differencing.
#include "compare/method_option.h"
#include <l3d/afd_options.h>
#include <l3d/camera.h>
#include <l3d/part_options.h>
#include <l3d/program.h>
#include <l3d/viewer.h>

#include "comparison.h"
#include "error_report.h"
#include "method_viewer.h"

#include <algorithm>
#include <optional>
#include <string>

namespace {

// Step 2 of 5: the application is a pipeline. The viewer of patches draws and has the keys.
using teapot_pipeline = l3d_viewer<method_viewer>;
using comparing_pipeline = l3d_viewer<comparison>;

/// The command line, and what it asks to draw.
struct command {
    explicit command(l3d_program& program)
        : afd(program.options()),
          method(methods(program.options()), "--method", "afd", "how surfaces are drawn: "),
          compared(program.options(), "--compare", "",
                   "draw the right half by this method (--report, --explain and --statistics tell "
                   "of the left one): "),
          parts(program.options()), common(program.options().common()) {
        program.options().begin_group("Measurements");
        program.options().add("--error-report", folder,
                              "draw nothing; measure what accuracy costs with each method, and "
                              "write the numbers there",
                              "FOLDER");
        program.options().has_result("--error-report");
        program.options().add("--quick", quick, "a small --error-report, in half a minute or so");
        program.options().add_example("--compare tessellation:6", "two methods side by side");
    }

    /// Reads what the options say. Returns whether there is something to show.
    bool take() {
        camera = afd.camera();
        settings = method.settings(afd);
        if (parts.lists()) {
            l3d_part_options::list(afd.model().parts(), "patches");
            return false;
        }
        other = compared.choice();
        refuse_what_does_not_go_together();
        if (folder.empty())
            return take_scene();
        measure();
        return false;
    }

    l3d_afd_options afd;
    l3d_method_option method, compared;
    l3d_part_options parts;
    const l3d_common_options& common;
    std::string folder;
    bool quick = false;
    l3d_camera camera;
    l3d_afd_settings settings;
    l3d_patch_scene scene;
    std::optional<l3d_method_choice> other;

private:
    static l3d_options& methods(l3d_options& options) {
        options.begin_group("Methods");
        return options;
    }

    void refuse_what_does_not_go_together() const {
        const bool measures = !folder.empty(), compares = other.has_value();
        const bool keeps_depth = !afd.depth_output().empty(), bounds = !afd.error_output().empty();
        const bool is_kept = method.choice()->method == l3d_method::kept ||
                             (other && other->method == l3d_method::kept);
        const std::string two = "not with --compare, whose halves are two pictures",
                          none = "not with --error-report, which draws nothing",
                          follow = "not with kept, whose frames depend on those before them";
        l3d_refuse({{"--depth-output", compares && keeps_depth, two},
                    {"--error-output", compares && bounds, two},
                    {"--texture",
                     afd.gives_texture() &&
                         (compares || measures || method.choice()->method != l3d_method::afd),
                     "only --method afd has it, and not beside another method"},
                    {"--output", measures && !common.output.empty(), none},
                    {"--report", measures && !afd.report().empty(), none},
                    {"--depth-output", measures && keeps_depth, none},
                    {"--error-output", measures && bounds, none},
                    {"--svg", measures && afd.gives_svg(), none},
                    {"--svg", compares && afd.gives_svg(), two},
                    {"--pick", measures && afd.pick(), none},
                    {"--explain", measures && afd.explain(), none},
                    {"--statistics", measures && afd.statistics(), none},
                    {"--compare", measures && compares, none},
                    {"--parallel", measures && camera.is_parallel(), none},
                    {"--parallel", other && !other->draws_parallel() && camera.is_parallel(),
                     "not with --compare of a method that draws perspective alone"},
                    {"--frames", measures && common.frames > 0, none},
                    {"--resume", is_kept && common.resume, follow},
                    {"--frames", is_kept && common.first_frame > 0, follow},
                    {"--quick", quick && !measures, "goes with --error-report"}});
    }

    bool take_scene() {
        scene = parts.scene(afd.model());
        afd.lay_picture(scene);
        if (afd.write_svg(scene))
            return false;
        if (other && scene.transparent_count() > 0)
            throw l3d_error(l3d_exit::usage, "--opacity: not with --compare");
        if (other && scene.has_trims())
            throw l3d_error(l3d_exit::usage, "--compare: not with trimmed surfaces");
        return true;
    }

    void measure() {
        const l3d_size size = common.size;
        constexpr int least = 6; // so that half of a third is still a picture
        if (std::min(size.width, size.height) < least)
            throw l3d_error(l3d_exit::usage,
                            "--size: '" + std::to_string(size.width) + 'x' +
                                std::to_string(size.height) +
                                "' is too small for --error-report, which needs 6x6");
        scene = l3d_patch_scene(parts.applied(afd.model()));
        if (scene.has_trims())
            throw l3d_error(l3d_exit::usage, "--error-report: not with trimmed surfaces");
        camera = afd.camera([&](const l3d_camera& usual) {
            return l3d_framed_unless_well(usual, size, l3d_reach_of(scene));
        });
        write_error_report(folder, scene.instances()[0].model(), camera, size,
                           {afd.shows_the_usual(), quick});
    }
};

} // namespace

int main(int argc, char** argv) {
    l3d_program program("teapot_afd",
                        "Draws bicubic patches, the Utah teapot unless told otherwise, by adaptive "
                        "forward differencing,\nwith a certified bound of the error in pixels. "
                        "In the window, h lists the keys.",
                        {1024, 768});
    command given(program);
    program.after_command_line([&] { return given.take(); });
    return program.run(argc, argv, [&] {                     // step 1: choose factories
        const auto dispatcher = program.create_dispatcher(); // step 3
        const auto show = [&](auto& pipeline, l3d_screen& screen) {
            dispatcher->plug(pipeline, screen);          // step 4
            const l3d_exit result = dispatcher->start(); // step 5
            pipeline.finish();
            return result;
        };
        l3d_canvas canvas = program.create_canvas(given.afd.model_title());
        if (given.other) {
            comparing_pipeline pipeline(program, given.afd, std::move(canvas),
                                        given.scene.instances()[0].model(), given.camera,
                                        given.settings, *given.other);
            pipeline.controls().set_screenshot([&pipeline](const l3d_pixels&) {
                return l3d_save_screenshot(pipeline.whole().pixels());
            });
            return show(pipeline, pipeline.whole());
        }
        teapot_pipeline pipeline(program, given.afd, std::move(canvas), given.scene, given.camera,
                                 given.settings, *given.method.choice());
        return show(pipeline, pipeline.screen());
    });
}
