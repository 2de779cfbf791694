// SPDX-License-Identifier: MIT
// method_viewer: the viewer of patches, with a key that steps through the methods, and the error.
#ifndef L3D_APPS_TEAPOT_AFD_METHOD_VIEWER_H
#define L3D_APPS_TEAPOT_AFD_METHOD_VIEWER_H

#include "live_error.h"

#include "compare/method_choice.h"
#include <l3d/pipeline_afd_editor.h>

#include <optional>
#include <string>

/// A viewer of patches with a key that steps through the methods. Its shade `error` shows each
/// pixel's error, measured by the exact renderer; the scale ends at the tolerance. Windows show the
/// certified bounds until the error is known. Scenes that are transparent in part, one-sided, or
/// cut by the far plane have no exact picture, and show bounds. Pixels that cannot be measured, at
/// outlines and creases, are grey.
///
/// Lives: as l3d_pipeline_afd_editor.
class method_viewer : public l3d_pipeline_afd_editor {
public:
    /// Begins with `first`, the method that l3d_method_option has chosen. Expects: the settings
    /// have this method.
    method_viewer(l3d_canvas canvas, const l3d_patch_scene& scene, const l3d_camera& camera,
                  const l3d_afd_settings& settings, const l3d_method_choice& first);

    /// The report of the last frame, with the viewer's own number of the frame.
    l3d_frame_report report() const;

    void draw_event() override;
    bool skip_event() override;
    bool needs_redraw() const override;
    bool is_at_rest() const override;

protected:
    void paint_surfaces() override;
    std::string error_scale_title() const override;

private:
    void take_next_method();
    bool measures_error();
    live_subject now();
    void measure();
    void take_errors();
    void paint_errors();

    /// The number of the last frame. The pipeline may draw one frame twice.
    int frame_ = -1;
    l3d_method_choice method_;
    /// The fog that the user asked for.
    const l3d_fog fog_;
    /// Whether the scene is one opaque model.
    bool is_one_model_;
    /// Measures errors; made at the first use.
    std::optional<live_error> live_;
    /// The subject of the measurement that runs or ran last.
    live_subject begun_;
    std::optional<reference::error_map> errors_;
    /// The subject that errors_ were measured for.
    live_subject measured_;
    /// Whether the picture shows errors_ in place of bounds.
    bool shows_errors_ = false;
};

/// The settings, without those that their method cannot show: the wireframe, fog, and shades that
/// need a bound of the error or exact patches.
l3d_afd_settings as_method_can(l3d_afd_settings settings);

/// Makes a pipeline draw with another method, without the settings that this method cannot show.
/// Errors:  l3d_error if the method cannot be created here; then nothing changes.
void show_method(l3d_pipeline_afd& pipeline, const l3d_method_choice& method);

/// Makes a pipeline draw with the next method that can be created here. Returns a line for the user
/// that names this method. If other methods had to be skipped, the line names them, too, with the
/// reason.
std::string show_next_method(l3d_pipeline_afd& pipeline, l3d_method_choice& method);

#endif
