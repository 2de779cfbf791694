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

/// The common part of every main function: reads the command line, chooses a back-end, and reports
/// errors. So main itself consists only of the five steps.
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
/// Lives:   a local object of main. It must outlive the objects that it creates.
class L3D_PUBLIC l3d_program {
public:
    /// Makes a program of this name. `purpose` is the beginning of --help, and should list the
    /// keys, too.
    l3d_program(std::string name, const std::string& purpose, l3d_size default_size);

    /// Makes a program with a caption. --help begins with the caption's text, and windows show the
    /// caption, unless frames are counted or written.
    l3d_program(std::string name, const l3d_caption& caption, l3d_size default_size);

    /// The command line. A program adds its own options to it before run().
    l3d_options& options() { return options_; }

    /// The factory manager. A program adds its own back-ends to it before run().
    l3d_factory_manager& factories() { return factories_; }

    /// Sets a function that is called once the command line has been read, for work without a
    /// screen, such as a report. `goes_on` returns whether the program goes on with a screen.
    void after_command_line(std::function<bool()> goes_on) { goes_on_ = std::move(goes_on); }

    /// Reads the command line and chooses a back-end (step 1). Then it calls `steps`, which does
    /// the remaining steps. Returns main's exit code. `steps` is not called if there is nothing to
    /// show, as after --help.
    ///
    /// Errors:  none: an exception becomes a line on stderr and an exit code.
    int run(int argc, const char* const* argv, const std::function<l3d_exit()>& steps);

    /// Does all five steps for a program of one pipeline, whose constructor gets a canvas and
    /// `arguments`. Returns main's exit code. If the arguments depend on the command line, call
    /// run() instead.
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

    /// Makes a screen, and the rasterizers that draw into it. `shows` names the thing that the
    /// window shows, such as a model, in UTF-8. The window's title begins with this name, unless
    /// the name is the program's own.
    /// Expects: called by the steps.
    /// Errors:  as l3d_factory_manager::create_screen.
    l3d_canvas create_canvas(const std::string& shows = {}) const;

    /// Refuses pictures without a background where they cannot be made. Windows do not show such
    /// pictures, and the GL back-end does not draw them.
    ///
    /// Errors: l3d_error(usage) that names the option and the obstacle.
    /// Expects: called by the steps.
    void check_transparency(bool in_window) const;

    /// Whether the chosen back-end draws by OpenGL. Expects: called by the steps.
    bool draws_by_gl() const;

    /// Whether --classic was given: a lesson draws as the book does.
    bool is_classic() const { return is_classic_; }

    /// The number of --seed, with which random numbers start.
    std::uint64_t seed() const { return options_.common().seed; }

private:
    l3d_options options_;
    l3d_factory_manager factories_;
    l3d_caption caption_;
    bool is_classic_ = false;
    std::function<bool()> goes_on_ = [] { return true; };
};

/// Shows a finished picture until the user closes its window or presses q or Escape. The picture
/// fills as much of the window as its shape allows. The variable L3D_BACKEND names the back-end;
/// without this variable, the first automatic back-end that can serve is taken. If nobody would see
/// the picture, it is written to `name`.png, and a line on stderr says so.
///
/// Shape:   `name` is the window's title, and the name of the file without its ending.
/// Returns: the exit code that main should return.
/// Errors:  none: an error becomes a line on stderr and an exit code, as for l3d_program::run.
/// Expects: the picture has 1 to l3d_largest_side pixels in both directions.
L3D_PUBLIC int l3d_show_picture(const l3d_pixels& picture, const std::string& name = "picture");

#endif
