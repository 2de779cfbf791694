// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_editor: a viewer whose surfaces change as their control points are dragged.
#ifndef L3D_PIPELINE_PIPELINE_AFD_EDITOR_H
#define L3D_PIPELINE_PIPELINE_AFD_EDITOR_H

#include "base/public.h"
#include "pipeline/control_handles.h"
#include "pipeline/pipeline_afd_viewer.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

/// l3d_pipeline_afd_viewer with l3d_control_handles on its model, and keys that show them, undo and
/// save. A panel tells the bound, times, and the handle under the pointer.
///
/// Expects: the scene is one opaque instance at its own place, or the key says why it shows no
///          handles.
/// Cost:    after a change the whole model is made again before the next frame, some 10 us a
///          bicubic patch, and more for other pieces. The panel tells the time.
class L3D_PUBLIC l3d_pipeline_afd_editor : public l3d_pipeline_afd_viewer {
public:
    /// A viewer that shows no handles yet. Errors: as l3d_pipeline_afd.
    l3d_pipeline_afd_editor(l3d_canvas canvas, l3d_patch_scene scene, const l3d_camera& camera,
                            const l3d_afd_settings& settings);

    /// Puts these surfaces into the scene, with handles on them. Nothing is left to be undone.
    /// Expects: pieces() of the surfaces, in their order, are as many as those of the model, which
    ///          has colours and parts.
    void edit(const l3d_patch_model& model, std::vector<l3d_nurbs_surface> surfaces);

    /// Whether the panel tells times in a window. Pictures that are counted want none: each run
    /// draws the same. Default: true.
    void tell_times(bool whether) { tells_times_ = whether; }

    /// The handles; null before edit() and the key that shows them.
    const l3d_control_handles* handles() const { return handles_ ? &*handles_ : nullptr; }

    /// Sets the function that the key S calls with the surfaces; without one the key does nothing.
    /// The function returns a line to show, such as the file's name.
    void set_saver(std::function<std::string(std::span<const l3d_nurbs_surface>)> save) {
        save_ = std::move(save);
    }

    void pointer_event(const l3d_event& event) override;
    void draw_event() override;

protected:
    void draw_overlay() override;
    /// Empty unless handles are shown.
    l3d_standing_panel standing_panel() override;

private:
    l3d_handle_view handle_view();
    void show_handles(bool shown);
    void switch_handles();
    void edit_scene();
    void change_weight(double factor);
    void undo(bool all);
    void save();
    void reshape();

    l3d_patch_model model_; ///< all of it, with its colours and parts
    std::optional<l3d_control_handles> handles_;
    bool is_editing_ = false, is_changed_ = false;
    bool tells_times_ = true;
    double reshape_ms_ = 0;
    std::function<std::string(std::span<const l3d_nurbs_surface>)> save_;
};

#endif
