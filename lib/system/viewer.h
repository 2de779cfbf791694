// SPDX-License-Identifier: MIT
// l3d_viewer: a pipeline that is turned, saved and reported as the command line says.
#ifndef L3D_SYSTEM_VIEWER_H
#define L3D_SYSTEM_VIEWER_H

#include "base/public.h"
#include "pipeline/polygons/pipeline_polygons.h"
#include "system/options/afd_options.h"
#include "system/options/polygon_options.h"
#include "system/program.h"
#include "system/frame_writer.h"
#include "raster/depth_buffer.h"
#include "scene/camera.h"
#include "tool_2d/image.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <optional>
#include <span>
#include <string>
#include <utility>

/// A `Pipeline` with controls, such as l3d_pipeline_afd_viewer, that obeys the command line of
/// viewers. It serves --turntable, --turn-speed, --report, --explain, --statistics, --depth-output,
/// --error-output and --pick. Without --eye, --target and --file-camera it frames its model.
///
/// Lives:   borrows the options.
template <class Pipeline> class L3D_PUBLIC l3d_viewer final : public Pipeline {
public:
    /// Makes the Pipeline of `arguments`, and sets its controls as `asked` says.
    /// Errors:  as l3d_report_writer, and as the Pipeline's constructor; l3d_error(usage) as
    ///          l3d_program::check_transparency.
    template <class... Arguments>
    l3d_viewer(l3d_program& program, const l3d_afd_options& asked, Arguments&&... arguments)
        : Pipeline(std::forward<Arguments>(arguments)...), asked_(asked),
          wants_gl_(program.draws_by_gl()), command_(program.options().command()) {
        if (!asked.places_camera())
            this->controls().set_home([this] {
                return asked_.camera(
                    [this](const l3d_camera& usual) { return this->framed_unless_well(usual); });
            });
        this->controls().set_turntable(asked.turntable(),
                                       1 / program.options().frame_settings().step());
        this->controls().set_turn_speed(asked.turn_speed());
        this->controls().set_screenshot(l3d_save_screenshot);
        if constexpr (requires { this->set_saver(l3d_save_surfaces); })
            this->set_saver(l3d_save_surfaces);
        this->controls().set_view_teller([this] { return told_view(); });
        suit_onlooker(program);
        if (!asked.report().empty())
            reports_.emplace(asked.report());
    }

    /// Draws a frame, and counts its polygons and time for --statistics.
    void draw_event() override {
        Pipeline::draw_event();
        if (!asked_.statistics())
            return;
        const auto report = this->report();
        ++frames_;
        seconds_ += report.time_ms.total / 1000;
        if constexpr (requires { report.polygons.drawn; })
            polygons_ += report.polygons.drawn;
        else
            polygons_ += report.surface.quads;
    }

    /// Adds the frame's line to the file of --report, if there is one. It also tells once who
    /// draws, if the user asked for OpenGL.
    void frame_event(const l3d_frame_times& times) override {
        Pipeline::frame_event(times);
        if (!wants_gl_ && !reports_)
            return; // a report sums up all pixels of the frame
        const auto report = this->report();
        if (wants_gl_ && report.surface.quads > 0)
            tell_who_draws(report.renderer);
        if (reports_)
            reports_->add(report.json());
    }

    /// Writes all that the options ask for at the end. These are the last frame's distances, error
    /// bounds of pixels and skipped work, the run's times, and the thing at the place of --pick. It
    /// also tells why the picture is empty. Call it once the dispatcher has ended.
    /// Errors:  l3d_error(failure) that names the file and the system's reason.
    void finish() const {
        if constexpr (requires { this->depth(); })
            if (const std::string& file = asked_.depth_output(); !file.empty())
                write(file, this->depth().size(), this->distances());
        if constexpr (requires { this->error_map(); })
            if (const std::string& file = asked_.error_output();
                !file.empty() && this->error_map() != nullptr)
                write(file, this->error_map()->size(), this->error_map()->levels());
        if (asked_.explain())
            std::cerr << this->report().explanation();
        if (asked_.statistics())
            std::cerr << frames_ << (frames_ == 1 ? " frame, " : " frames, ") << seconds_ << " s, "
                      << polygons_ << (polygons_ == 1 ? " polygon, " : " polygons, ")
                      << (seconds_ > 0 ? std::llround(static_cast<double>(polygons_) / seconds_)
                                       : 0)
                      << " polygons a second\n";
        // A window shows the reason itself.
        if (const std::string why = this->why_empty(); !why.empty() && !in_window_)
            std::cerr << command_ << ": the picture is empty, as the model is " << why
                      << way_to_mend(why) << '\n';
        tell_pick();
    }

private:
    /// Shows a hint about the help to a user at a window. If frames are counted or written, it
    /// shows no hint, so that windows and files have the same pictures. It also checks --pick and
    /// the background for this screen.
    void suit_onlooker(l3d_program& program) {
        const l3d_frame_settings frames = program.options().frame_settings();
        in_window_ = this->screen().is_window();
        if (!in_window_) // a window may have got another size than it was given
            asked_.check_pick(program.options().common().size);
        if (this->settings().background.is_none())
            program.check_transparency(in_window_);
        if (!in_window_ || frames.frames != 0)
            return;
        constexpr double seconds = 5; // one line is read in two
        if (frames.output.empty())
            this->controls().show_hint(seconds);
    }

    /// Tells the user on stderr if the library itself draws although OpenGL was chosen. `gl` is the
    /// report's name of the OpenGL renderer, which is empty if the library itself draws.
    void tell_who_draws(const std::string& gl) {
        if (gl.empty())
            std::cerr << command_
                      << ": processors draw these surfaces, not GL: it has one far light, and no "
                         "highlights, fog or pictures\n";
        wants_gl_ = false; // it has been told
    }

    /// The view as command-line options. These options are also printed on stderr, so that the user
    /// can copy them from a terminal.
    std::string told_view() {
        std::string text = asked_.view_options(this->camera());
        if constexpr (requires { this->settings().rotation; })
            text += l3d_polygon_options::view_options(this->settings());
        std::cerr << text << '\n';
        return text;
    }

    /// Writes a PFM file with one value for each pixel. The file's name - stands for the standard
    /// output.
    static void write(const std::string& file, l3d_size size, std::span<const float> values) {
        if (file == "-")
            l3d_write_pfm(stdout, "standard output", size.width, size.height, values);
        else
            l3d_write_pfm(file, size.width, size.height, values);
    }

    /// The advice how to undo the option that made the picture empty. It is empty for a model that
    /// is too small or has no area, since no option helps then.
    std::string way_to_mend(const std::string& reason) const {
        if (reason == l3d_without_area || reason == l3d_too_small)
            return "";
        if (reason == l3d_turning_its_back)
            return "; leave out --one-sided, or press b in a window";
        if (reason.ends_with("plane"))
            return "; leave out --near and --far, or press f in a window";
        return asked_.places_camera() ? "; leave out --eye and --target, or press f in a window"
                                      : "; press f in a window";
    }

    /// Prints what is seen at the place of --pick.
    /// Errors:  l3d_error(failure) if the standard output cannot be written to.
    void tell_pick() const {
        if (!asked_.pick())
            return;
        const auto found = this->pick((*asked_.pick())[0], (*asked_.pick())[1]);
        if (!(std::cout << (found ? found->text() : "nothing there\n") << std::flush))
            throw l3d_error(l3d_exit::failure, "cannot write to the standard output");
    }

    const l3d_afd_options& asked_;
    bool wants_gl_ = false; ///< whether OpenGL was chosen, and the user was not told yet who draws
    bool in_window_ = false;
    std::int64_t frames_ = 0, polygons_ = 0; ///< numbers of frames and polygons drawn so far
    double seconds_ = 0;                     ///< time that drawing took so far
    std::string command_;
    std::optional<l3d_report_writer> reports_;
};

#endif
