// SPDX-License-Identifier: MIT
// l3d_program: the common part of every main function, which then shows the five steps alone;
// l3d_show_picture.
#ifndef L3D_SYSTEM_PROGRAM_H
#define L3D_SYSTEM_PROGRAM_H

#include "base/public.h"
#include "pipeline/pipeline.h"
#include "pipeline/pipeline_2d.h"
#include "system/factory_manager.h"
#include "system/options/options.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

/// A program's command line and its factory manager, which chooses a back-end as the command line
/// says.
///
///     int main(int argc, char** argv) {
///         l3d_program program("drawdot", "A dot leaves a trail.", {320, 200});
///         return program.run(argc, argv, [&] {                     // step 1: choose factories
///             const auto dispatcher = program.create_dispatcher(); // step 3
///             drawdot_pipeline pipeline(program.create_canvas());
///             dispatcher->plug(pipeline, pipeline.screen());       // step 4
///             return dispatcher->start();                          // step 5
///         });
///     }
///
/// Lives:   a local object of main, which outlives what it creates.
class L3D_PUBLIC l3d_program {
public:
    /// Makes a program of this name. --help begins with `purpose`, which should list the keys, too.
    l3d_program(std::string name, const std::string& purpose, l3d_size default_size);

    /// Makes a program with a caption, which --help begins with. Windows show the caption, unless
    /// their frames are counted or written.
    l3d_program(std::string name, const l3d_caption& caption, l3d_size default_size);

    /// The command line. A program adds its own options to it before run().
    l3d_options& options() { return options_; }

    /// The factory manager. A program adds its own back-ends to it before run().
    l3d_factory_manager& factories() { return factories_; }

    /// Sets a function that is called once the command line has been read, for work without a
    /// screen, such as a report. It returns whether there is more to do.
    void after_command_line(std::function<bool()> goes_on) { goes_on_ = std::move(goes_on); }

    /// Reads the command line, chooses a back-end, and does the other steps; returns main's exit
    /// code. The steps are left out if there is nothing to show, as after --help.
    ///
    /// Errors:  none: each exception becomes a line on stderr, and its exit code.
    int run(int argc, const char* const* argv, const std::function<l3d_exit()>& steps);

    /// Does all five steps for a program of one pipeline, which gets a canvas and these arguments.
    /// Returns main's exit code. A program whose arguments depend on the command line calls run().
    /// Errors:  as run().
    template <class Pipeline, class... Arguments>
    int show(int argc, const char* const* argv, const Arguments&... arguments) {
        return run(argc, argv, [&] {
            const auto dispatcher = create_dispatcher();
            Pipeline pipeline(create_canvas(), arguments...);
            dispatcher->plug(pipeline, pipeline.screen());
            return dispatcher->start();
        });
    }

    /// Makes a dispatcher of the back-end that was chosen.
    /// Expects: called by the steps.
    /// Errors:  as l3d_factory_manager::create_dispatcher.
    std::unique_ptr<l3d_dispatcher> create_dispatcher() const;

    /// Makes a screen and the rasterizers that draw into it. `shows` names the thing that the
    /// window shows, such as a model, in UTF-8. The title begins with it, unless it is the
    /// program's name.
    /// Expects: called by the steps.
    /// Errors:  as l3d_factory_manager::create_screen.
    l3d_canvas create_canvas(const std::string& shows = {}) const;

    /// Refuses pictures without background where they cannot be made: no window shows them, and the
    /// GL back-end does not draw them.
    ///
    /// Errors: l3d_error(usage) that names the option and the obstacle.
    /// Expects: called by the steps.
    void check_transparency(bool in_window) const;

    /// Whether the back-end that was chosen is GL. Expects: called by the steps.
    bool draws_by_gl() const;

    /// Whether a lesson draws as the book does: --classic.
    bool is_classic() const { return is_classic_; }

    /// The number with which random numbers start: --seed.
    std::uint64_t seed() const { return options_.common().seed; }

private:
    l3d_options options_;
    l3d_factory_manager factories_;
    l3d_caption caption_;
    bool is_classic_ = false;
    std::function<bool()> goes_on_ = [] { return true; };
};

/// Shows a finished picture until the user closes its window or presses q or Escape. The picture
/// fills as much of the window as its shape allows. L3D_BACKEND names the back-end; otherwise the
/// first one that can serve is taken. Where nobody would see the picture, it is written to
/// `name`.png, and a line on stderr says so.
///
/// Shape:   `name` is the window's title and a file's name without its end.
/// Returns: the exit code that main should return.
/// Errors:  none: each becomes a line on stderr and an exit code, as for l3d_program::run.
/// Expects: a picture of 1 to l3d_largest_side pixels in both directions.
L3D_PUBLIC int l3d_show_picture(const l3d_pixels& picture, const std::string& name = "picture");

#endif
