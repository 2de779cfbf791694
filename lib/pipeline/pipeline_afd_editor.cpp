// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_editor: handles keys, and takes the handles' changes to the scene.
#include "pipeline/pipeline_afd_editor.h"

#include "base/formatted_p.h"
#include "pipeline/stopwatch_p.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace {

using l3d_detail::formatted;
using l3d_detail::stopwatch;

/// The factor by which a press of a key changes a weight, as a notch of the wheel does.
constexpr double key_weight = 1.1;

} // namespace

l3d_pipeline_afd_editor::l3d_pipeline_afd_editor(l3d_canvas canvas, l3d_patch_scene scene,
                                                 const l3d_camera& camera,
                                                 const l3d_afd_settings& settings)
    : l3d_pipeline_afd_viewer(std::move(canvas), std::move(scene), camera, settings) {
    controls().add({"k", "control points to drag", {{'k', [this] { switch_handles(); }}}});
    controls().add({"drag, right drag of one", "beside, along the line of sight"});
    controls().add({"wheel or , . over one",
                    "its weight",
                    {{',', [this] { change_weight(1 / key_weight); }},
                     {'.', [this] { change_weight(key_weight); }}}});
    controls().add({"u, U", "undo a change, all", {{'u', [this] { undo(false); }}, {'U', [this] {
                                                                                        undo(true);
                                                                                    }}}});
    controls().add({"S", "save the surface", {{'S', [this] { save(); }}}});
}

void l3d_pipeline_afd_editor::edit(const l3d_patch_model& model,
                                   std::vector<l3d_nurbs_surface> surfaces) {
    model_ = model;
    handles_.emplace(std::move(surfaces));
    show_handles(true);
    reshape();
}

/// Shows or hides the handles. While handles are shown, the screen reports all motion of the
/// pointer, since the pointer may come over a handle.
void l3d_pipeline_afd_editor::show_handles(bool shown) {
    is_editing_ = shown;
    settings().depth = shown || settings().depth; // tells which lines are hidden
    screen().set_pointer(shown ? l3d_pointer::followed : l3d_pointer::dragged);
    redraw();
}

void l3d_pipeline_afd_editor::switch_handles() {
    if (!handles_)
        return edit_scene();
    show_handles(!is_editing_);
}

/// Edits the scene's only model: each of its pieces becomes a surface.
void l3d_pipeline_afd_editor::edit_scene() {
    if (scene().instances().size() != 1 || scene().transparent_count() > 0)
        return controls().say("no control points to drag: the scene is not one opaque model");
    parts().show_all();
    const l3d_patch_model model = scene().instances()[0].model();
    edit(model, model.surfaces());
}

l3d_handle_view l3d_pipeline_afd_editor::handle_view() {
    return {camera(), screen().pixels().size(), screen().text_scale()};
}

void l3d_pipeline_afd_editor::pointer_event(const l3d_event& event) {
    using effect = l3d_control_handles::effect;
    // Presses with Ctrl or Shift keep their usual meaning: measuring places, or moving the eye.
    const bool is_free =
        event.type == l3d_event_type::button_press && (event.control || event.shift);
    const effect what =
        is_editing_ && !is_free ? handles_->pointer(event, handle_view()) : effect::none;
    if (what == effect::none)
        return l3d_pipeline_afd_viewer::pointer_event(event);
    is_changed_ = is_changed_ || what == effect::changed;
    redraw();
}

void l3d_pipeline_afd_editor::change_weight(double factor) {
    if (!is_editing_ || !handles_->marked())
        return controls().say("no control point is under the pointer");
    is_changed_ = handles_->scale_weight(*handles_->marked(), factor) || is_changed_;
}

void l3d_pipeline_afd_editor::undo(bool all) {
    bool is_undone = handles_ && handles_->undo();
    if (!is_undone)
        return controls().say("nothing to undo");
    while (all && handles_->undo())
        ;
    is_changed_ = true;
}

void l3d_pipeline_afd_editor::save() {
    if (!handles_)
        return controls().say("nothing to save: k shows control points");
    if (save_)
        controls().say(save_(handles_->surfaces()));
}

void l3d_pipeline_afd_editor::reshape() {
    const stopwatch making;
    scene().place(0, model_.reshaped(handles_->surfaces()), scene().instances()[0].placement());
    reshape_ms_ = making.milliseconds();
    is_changed_ = false;
}

/// Draws a frame. The model is made anew once for all changes since the last frame.
void l3d_pipeline_afd_editor::draw_event() {
    if (is_changed_)
        reshape();
    l3d_pipeline_afd_viewer::draw_event();
}

void l3d_pipeline_afd_editor::draw_overlay() {
    if (is_editing_)
        handles_->draw(rasterizer(), handle_view(), settings().wireframe ? nullptr : &depth());
}

/// The panel about handles. It tells times only in a window, since pictures in files shall be the
/// same each time.
l3d_standing_panel l3d_pipeline_afd_editor::standing_panel() {
    l3d_panel panel;
    if (!is_editing_)
        return {};
    panel.add("error", std::isfinite(bound()) ? formatted("%.2f pixels at most", bound())
                                              : "no bound with " + settings().method.name());
    if (screen().is_window() && tells_times_)
        panel.add("frame", formatted("%.2f ms, surface %.2f ms", controls().pace().milliseconds(),
                                     reshape_ms_));
    if (const auto handle = handles_->marked()) {
        const auto& place = handles_->place(*handle);
        panel.add("point", handles_->name(*handle));
        panel.add("place", formatted("%.4g, %.4g, %.4g", place[0], place[1], place[2]));
        panel.add("weight", formatted("%.4g", handles_->weight(*handle)));
    } else {
        panel.add("points", std::to_string(handles_->count()));
    }
    return {panel, l3d_corner::bottom_right};
}
