// SPDX-License-Identifier: MIT
// method_viewer: the viewer of patches, with a key that steps through the methods.
#ifndef L3D_APPS_TEAPOT_AFD_METHOD_VIEWER_H
#define L3D_APPS_TEAPOT_AFD_METHOD_VIEWER_H

#include "compare/method_choice.h"
#include <l3d/pipeline_afd_viewer.h>

/// Lives: as l3d_pipeline_afd_viewer.
class method_viewer : public l3d_pipeline_afd_viewer {
public:
    /// Expects: the settings are those of a method that l3d_method_option has chosen, `first`.
    method_viewer(l3d_canvas canvas, l3d_patch_scene scene, const l3d_camera& camera,
                  const l3d_afd_settings& settings, const l3d_method_choice& first);

private:
    void take_next_method();

    l3d_method_choice method_;
};

/// The same settings without what their method cannot show: the wireframe, and shades that need its
/// bound or exact patches.
l3d_afd_settings as_method_can(l3d_afd_settings settings);

/// Lets a pipeline draw with another method, without what that method cannot show.
/// Errors: l3d_error if it cannot be created here; then nothing changes.
void show_method(l3d_pipeline_afd& pipeline, const l3d_method_choice& method);

/// Lets it draw with the next method that can be created here.
/// Returns a line that names it, and any that had to be passed over, with the reason.
std::string show_next_method(l3d_pipeline_afd& pipeline, l3d_method_choice& method);

#endif
