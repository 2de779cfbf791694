// SPDX-License-Identifier: MIT
// method_viewer: the viewer of patches, with a key that steps through the methods, and the error.
#ifndef L3D_APPS_TEAPOT_AFD_METHOD_VIEWER_H
#define L3D_APPS_TEAPOT_AFD_METHOD_VIEWER_H

#include "live_error.h"

#include "compare/method_choice.h"
#include <l3d/pipeline_afd_editor.h>

#include <optional>
#include <string>

/// A viewer whose shade `error` shows each pixel's error, measured by the exact renderer, on a
/// scale that ends at the tolerance. Windows show the certified bounds until that is known. Scenes
/// with transparent parts, one-sided ones and those that the far plane cuts have no exact picture,
/// and show bounds. Pixels that cannot be measured, at outlines and creases, are grey.
///
/// Lives: as l3d_pipeline_afd_editor.
class method_viewer : public l3d_pipeline_afd_editor {
public:
    /// Expects: the settings are those of a method that l3d_method_option has chosen, `first`.
    method_viewer(l3d_canvas canvas, const l3d_patch_scene& scene, const l3d_camera& camera,
                  const l3d_afd_settings& settings, const l3d_method_choice& first);

    /// The report, with the number of the picture.
    l3d_frame_report report() const;

    void draw_event() override;
    bool skip_event() override;
    bool needs_redraw() const override;
    bool is_at_rest() const override;

protected:
    void paint_surfaces() override;
    std::string error_scale_title() const override;

private:
    /// The settings that a measurement belongs to.
    struct subject {
        shown_model model;
        l3d_camera camera;
        l3d_size size;
        double tolerance = 0;
        std::string method;

        friend bool operator==(const subject&, const subject&) = default;
    };

    void take_next_method();
    bool measures_error();
    subject now();
    void measure();
    void take_errors();
    void paint_errors();

    /// The last frame. It may be drawn twice.
    int frame_ = -1;
    l3d_method_choice method_;
    /// The fog that the user asked for.
    const l3d_fog fog_;
    /// The scene is one opaque model.
    bool is_one_model_;
    /// Made at its first use.
    std::optional<live_error> live_;
    /// The subject of the running or last measurement.
    subject begun_;
    std::optional<reference::error_map> errors_;
    /// The subject that errors_ belong to.
    subject measured_;
    /// The picture shows errors_, not bounds.
    bool shows_errors_ = false;
};

/// The same settings, less those that their method cannot show: the wireframe, fog, and shades that
/// need its bound or exact patches.
l3d_afd_settings as_method_can(l3d_afd_settings settings);

/// Makes a pipeline draw with another method, less the settings that it cannot show.
/// Errors: l3d_error if it cannot be created here; then nothing changes.
void show_method(l3d_pipeline_afd& pipeline, const l3d_method_choice& method);

/// Lets it draw with the next method that can be created here.
/// Returns a line that names it, and any that had to be passed over, with the reason.
std::string show_next_method(l3d_pipeline_afd& pipeline, l3d_method_choice& method);

#endif
