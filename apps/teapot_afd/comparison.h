// SPDX-License-Identifier: MIT
// comparison: the same view by two methods, side by side.
#ifndef L3D_APPS_TEAPOT_AFD_COMPARISON_H
#define L3D_APPS_TEAPOT_AFD_COMPARISON_H

#include "compare/method_choice.h"
#include "live_error.h"
#include <l3d/pipeline_afd_viewer.h>

#include <memory>
#include <optional>
#include <string>

/// The text about a method in its half of the window: name, time, bound and measured error.
/// Units: milliseconds; pixels.
struct caption {
    std::string method;
    /// The mean time that drawing a picture takes, by l3d_picture_pace.
    double milliseconds = 0;
    /// Whether the text has the time. Pictures in files leave the time out, so that they are the
    /// same in each run.
    bool shows_time = false;
    double bound_px = 0;
    /// The tolerance; nothing if the method keeps no tolerance.
    std::optional<double> tolerance_px;
    /// The state of the error: not measured at all, being measured, or known as `measured`.
    enum class error_state { none, awaited, known } error = error_state::none;
    /// Seconds since the measurement began.
    int awaited_seconds = 0;
    live_result measured;

    /// The panel with the text, for the upper right corner of a half of this size. It covers at
    /// most half of this area. If there is too little room, the panel has short lines, then only
    /// the method's name, then nothing.
    l3d_panel panel(l3d_size half, const l3d_panel_style& style) const;

private:
    l3d_panel lines(bool are_short) const;
};

/// The right half of the window: the other method's pictures, and a caption.
class other_half final : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;

    caption text;
    l3d_panel_style style;

private:
    void draw_overlay() override;
};

/// A viewer that compares two methods side by side. The left half of the window is the viewer's own
/// picture. The right half shows another method, by the same camera and settings. Each half has a
/// caption with the method's name, time, bound and error, which is measured in the background.
///
/// Parts that are hidden on the left are hidden on the right, too, and in the exact picture.
///
/// Edges are not smooth at first, since only AFD has smooth edges. The key m takes the next method
/// on the right. The key b gives the right method the time of the left one instead of its
/// tolerance: it then draws as exactly as it can in this time.
///
/// Lives:   owns the screen. Each half is a screen for one of the two pipelines.
class comparison : public l3d_pipeline_afd_viewer {
public:
    /// Errors: as l3d_pipeline_afd, and l3d_error if the other method cannot be created here.
    comparison(l3d_canvas canvas, const l3d_patch_model& model, const l3d_camera& camera,
               const l3d_afd_settings& settings, const l3d_method_choice& other);

    /// The whole screen, with both halves, for the dispatcher.
    l3d_screen& whole() { return *whole_; }

    /// The report of the left half's last frame, with the frame number of the whole window.
    l3d_frame_report report() const;

    /// Finds the surface that is seen at (x, y) of the whole picture, in the half that holds this
    /// place.
    std::optional<l3d_pick> pick(double x, double y) const;

    void pointer_event(const l3d_event& event) override;
    void resize_event(l3d_size size) override;
    void draw_event() override;
    void interrupt_when(std::function<bool()> wanted) override;
    bool skip_event() override;
    l3d_pixel_box changed() const override;
    bool needs_redraw() const override;
    bool is_at_rest() const override;

private:
    struct subjects {
        live_subject left, right;

        friend bool operator==(const subjects&, const subjects&) = default;
    };

    comparison(std::shared_ptr<l3d_screen> whole,
               std::shared_ptr<const l3d_rasterizer_factory> rasterizers, const l3d_font& font,
               const l3d_patch_model& model, const l3d_camera& camera,
               const l3d_afd_settings& settings, const l3d_method_choice& other);
    l3d_standing_panel standing_panel() override;
    void take_next_method();
    void switch_budget();
    void draw_both();
    void follow_left();
    void show_same_parts();
    const l3d_patch_model& shown() { return scene().instances()[0].model(); }
    void draw_line();
    void seek_equal_time();
    subjects now();
    bool measures_errors();
    void measure();
    void take_results();
    void tell_errors();
    bool passes_a_second() const;

    std::shared_ptr<l3d_screen> whole_;
    other_half other_;
    l3d_method_choice other_method_;
    bool drags_right_ = false; ///< whether the last drag began in the right half
    bool equal_time_ = false;
    /// The tolerance of the right half while it has the time of the left one.
    double other_tolerance_;
    /// The number of frames still to be drawn, although nothing moves, until the right half's
    /// tolerance settles.
    int frames_to_settle_ = 0;
    /// The number of the window's last frame. For one frame, the halves may be drawn twice.
    int frame_ = -1;
    caption text_;
    l3d_picture_pace other_pace_; ///< pace of the right half
    live_error live_;
    /// The subjects of the measurement that runs or ran last, and the subjects of the errors in the
    /// captions.
    subjects begun_, measured_;
};

#endif
