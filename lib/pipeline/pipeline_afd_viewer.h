// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_viewer: patches that can be turned, zoomed and inspected with keys and mouse.
#ifndef L3D_PIPELINE_PIPELINE_AFD_VIEWER_H
#define L3D_PIPELINE_PIPELINE_AFD_VIEWER_H

#include "base/public.h"
#include "pipeline/part_list.h"
#include "pipeline/pipeline_afd.h"
#include "pipeline/viewer_controls.h"
#include "scene/patch_model.h"
#include "scene/patch_scene.h"

#include <cstddef>
#include <string>
#include <vector>

/// Shows, hides and colours the named parts of a scene's models, as an l3d_part_list says. Parts
/// with the same name count as one part, even in different instances.
///
/// The scene holds only parts that are shown: a hidden part's patches are taken out of their
/// instances. If a program gives an instance another model, all of that model is shown.
/// Lives: borrows the scene.
class L3D_PUBLIC l3d_part_switch {
public:
    /// Switches the parts of this scene. The scene may get its models later.
    explicit l3d_part_switch(l3d_patch_scene& scene) : scene_(scene) {}

    /// The list of all models' parts and their states, brought up to date. After a change of the
    /// list, call apply().
    l3d_part_list& list();

    /// Makes the scene show the parts as the list says. If no part would be left to see, it takes
    /// the list's last change back instead.
    /// Returns: false if the change was taken back.
    /// Cost:    bounds of the patches that stay are computed again. This takes some microseconds a
    ///          patch.
    bool apply();

    /// Chooses the next part: the first part at the first call, and again after the last part.
    /// Returns: a line that names the part.
    std::string choose_next() { return list().choose_next(); }

    /// Hides the chosen part, or shows it again. If no part is chosen, the list first chooses its
    /// first part.
    /// Returns: a line that tells the part's new state.
    /// Cost:    as apply().
    std::string switch_chosen();

    /// The name of the chosen part; "" if none is chosen.
    std::string chosen() const { return list_.chosen() ? list_.chosen()->name : ""; }

    /// The text that tells the user that apply() took a change back.
    std::string refusal() const;

    /// Shows all parts.
    void show_all();

private:
    /// An instance's whole model, and the model of the shown parts that replaces it in the scene.
    struct taken {
        l3d_patch_model whole, shown;
    };

    l3d_patch_model as_listed(const l3d_patch_model& whole) const;

    l3d_patch_scene& scene_;
    l3d_part_list list_;
    std::vector<taken> instances_;
};

/// A viewer of patches: l3d_pipeline_afd with keys and mouse to turn, zoom and inspect the scene.
/// The viewer's help lists the keys.
class L3D_PUBLIC l3d_pipeline_afd_viewer : public l3d_pipeline_afd {
public:
    using l3d_pipeline_afd::l3d_pipeline_afd;

    /// The viewer's keys, mouse and lines of text.
    l3d_viewer_controls& controls() { return controls_; }
    /// The viewer's keys, mouse and lines of text, read-only.
    const l3d_viewer_controls& controls() const { return controls_; }

    void any_event(const l3d_event& event) override { controls_.note(event); }
    void key_event(int key) override;
    void pointer_event(const l3d_event& event) override;
    void resize_event(l3d_size size) override;
    void update_event(double seconds) override;
    void draw_event() override;
    /// Whether the controls are at rest. Nothing else in the viewer changes with time. A subclass
    /// that overrides update_event overrides this function, too.
    bool is_at_rest() const override { return controls_.is_at_rest(); }
    double rest_left() const override { return controls_.rest_left(); }
    void rest_event(double seconds) override;

protected:
    /// The title of the scale of colours in mode `error`. A subclass whose scale shows errors that
    /// are no bounds overrides this function.
    virtual std::string error_scale_title() const { return "bound of the error, in pixels"; }

    /// A panel that a subclass shows in every picture. The viewer's own panels do not cover it.
    virtual l3d_standing_panel standing_panel() { return {}; }

    /// The switch of the parts that keys choose, hide and show.
    l3d_part_switch& parts() { return parts_; }

private:
    void draw_panels() override;
    std::vector<l3d_viewer_row> own_rows();
    l3d_viewed viewed();
    void scale_tolerance(double factor);
    void take_next_shade();
    void take_next_inspection();
    void add_inspection(l3d_panel& panel);
    void switch_wireframe();
    void switch_antialias();
    void switch_projection();
    void tell_of_part(std::string line);
    l3d_panel legend();

    l3d_part_switch parts_{scene()};
    bool marks_part_ = false; ///< whether the picture marks the chosen part, until the next key
    l3d_viewer_controls controls_{
        *this, screen(), camera(), own_rows(), [this] { parts_.show_all(); }, viewed(), font()};
};

#endif
