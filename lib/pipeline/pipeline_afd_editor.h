// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_editor: a viewer whose surfaces change as their control points, the handles,
// are dragged.
#ifndef L3D_PIPELINE_PIPELINE_AFD_EDITOR_H
#define L3D_PIPELINE_PIPELINE_AFD_EDITOR_H

#include "base/public.h"
#include "geom/nurbs_surface.h"
#include "pipeline/pipeline_afd_viewer.h"
#include "raster/depth_buffer.h"
#include "raster/rasterizer_2d.h"
#include "scene/camera.h"
#include "tool_2d/event.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// The picture in which handles are drawn and dragged.
struct L3D_PUBLIC l3d_handle_view {
    l3d_camera camera;     ///< the camera of the picture
    l3d_size size;         ///< size of the picture, in pixels
    double text_scale = 1; ///< factor of the size of lines and handles: l3d_screen::text_scale
};

/// The control points of surfaces as handles that the user can drag, joined by the lines of their
/// nets. A handle stands for all control points that were at the same place at first: where patches
/// meet, where a surface closes, and at a pole. The points of a handle move together, and their
/// weights change by the same factor.
///
/// A drag with the left button moves a handle in the plane through it that is parallel to the
/// picture. A drag with the right button moves the handle along the view axis: upwards in the
/// picture moves it away from the eye. The wheel over a handle changes the handle's weight. undo()
/// takes each of these changes back.
/// Lives: a value.
class L3D_PUBLIC l3d_control_handles {
public:
    /// A place in the world.
    using vector = l3d_nurbs_surface::vector;

    /// Makes handles for the control points of these surfaces. Cost: a search for each control
    /// point.
    explicit l3d_control_handles(std::vector<l3d_nurbs_surface> surfaces);

    /// The surfaces with all changes.
    std::span<const l3d_nurbs_surface> surfaces() const { return surfaces_; }

    /// The number of handles.
    std::size_t count() const { return members_.size(); }
    /// The place of a handle in the world. Expects: handle < count().
    const vector& place(std::size_t handle) const;
    /// The weight of a handle's first control point. Expects: handle < count().
    double weight(std::size_t handle) const;
    /// The name of a handle for the user: surface, row and column of its first control point,
    /// counted from 1. The name leaves out the surface if there is only one surface. Expects:
    /// handle < count().
    std::string name(std::size_t handle) const;

    /// Finds the handle nearest to (x, y) of the picture. Among handles that are about equally
    /// near, it finds the one nearest to the eye. The result is nothing if no handle is within 10
    /// pixels times text_scale.
    /// Units: pixels from the picture's left upper corner.
    std::optional<std::size_t> find(double x, double y, const l3d_handle_view& view) const;

    /// The handle that is dragged, or else the handle under the pointer; nothing if there is
    /// neither.
    std::optional<std::size_t> marked() const { return marked_; }

    /// A function that tells how far handles reach in a direction, for l3d_framed.
    /// Lives: the result borrows this object.
    l3d_reach reach() const;

    /// Moves a handle to this place in the world. It returns false, and changes nothing, if the
    /// absolute value of a coordinate exceeds 1e12.
    /// Expects: handle < count().
    bool move(std::size_t handle, const vector& to);

    /// Multiplies the weights of a handle's control points by a factor. It returns false, and
    /// changes nothing, if a weight would leave the range from least_weight to most_weight.
    /// Expects: handle < count(), factor > 0.
    bool scale_weight(std::size_t handle, double factor);
    /// The least weight that scale_weight makes.
    static constexpr double least_weight = 1e-3;
    /// The largest weight that scale_weight makes. Tests cover bounds of the error for weights up
    /// to this one.
    static constexpr double most_weight = 1e3;

    /// Takes the last change back: a whole drag, or all changes of one handle's weight in a row. It
    /// returns false if there is no change to take back.
    bool undo();

    /// The effect of an event on handles. It tells which things must be drawn again.
    enum class effect {
        none,    ///< the event means nothing to handles
        seen,    ///< only the handles must be drawn again; the surfaces are the same
        changed, ///< the surfaces have changed
    };
    /// Handles an event of the pointer: drags a handle or changes its weight, and marks the handle
    /// under the pointer.
    effect pointer(const l3d_event& event, const l3d_handle_view& view);

    /// Draws nets and handles. `depth` holds the depths of the surfaces in the picture: lines and
    /// handles behind these surfaces are pale. If `depth` is null, nothing is pale.
    void draw(l3d_rasterizer_2d& rasterizer, const l3d_handle_view& view,
              const l3d_depth_buffer* depth) const;

private:
    struct member {
        std::size_t surface, point;
    };
    /// A handle's place and weights before a change, for undo().
    struct state {
        std::size_t handle;
        vector place;
        std::vector<double> weights;
    };
    enum class change { place, weight };
    struct grab {
        double right, down; ///< offset from the pointer to the handle, in pixels
        bool is_along_view;
        int y; ///< the pointer's last row
    };

    double weight_of(const member& m) const;
    void keep_for_undo(std::size_t handle, change kind);
    effect mark(std::optional<std::size_t> handle);
    effect press(const l3d_event& event, const l3d_handle_view& view);
    effect drag(const l3d_event& motion, const l3d_handle_view& view);

    std::vector<l3d_nurbs_surface> surfaces_;
    std::vector<std::vector<member>> members_; ///< the control points of each handle
    /// Pairs of handles that lines of nets join, each pair once.
    std::vector<std::pair<std::size_t, std::size_t>> net_;
    std::optional<std::size_t> marked_;
    /// How the pointer holds the marked handle; empty unless the user drags it.
    std::optional<grab> grab_;
    std::vector<state> undo_;
    /// The handle that is being changed, and the kind of change. Further steps of this change add
    /// no state to undo.
    std::optional<std::pair<std::size_t, change>> going_on_;
};

/// A viewer of patches in which the user drags the model's control points (l3d_control_handles).
/// Keys show the handles, undo changes, and save. A panel tells the error bound, times, and the
/// handle under the pointer.
///
/// Expects: the scene is one opaque instance, placed without a transform. For another number of
///          instances, or a transparent instance, the key for handles shows a reason instead of
///          handles.
/// Cost:    after a change the whole model is made again before the next frame. This takes some 10
///          us for a bicubic patch, and more for a piece that is not bicubic. The panel tells the
///          time.
class L3D_PUBLIC l3d_pipeline_afd_editor : public l3d_pipeline_afd_viewer {
public:
    /// Makes a viewer that shows no handles yet. Errors: as l3d_pipeline_afd.
    l3d_pipeline_afd_editor(l3d_canvas canvas, l3d_patch_scene scene, const l3d_camera& camera,
                            const l3d_afd_settings& settings);

    /// Puts these surfaces into the scene, with handles on their control points. Earlier changes
    /// cannot be undone any more.
    /// Expects: all surfaces together have as many pieces() as the model. Each piece gets its
    ///          colour and part from the model's piece with the same number.
    void edit(const l3d_patch_model& model, std::vector<l3d_nurbs_surface> surfaces);

    /// Sets whether the panel in a window tells times; at first it does. Times differ from run to
    /// run. Pass false if each run has to draw the same pictures.
    void tell_times(bool whether) { tells_times_ = whether; }

    /// The handles; null until edit(), or the key that shows handles, makes them.
    const l3d_control_handles* handles() const { return handles_ ? &*handles_ : nullptr; }

    /// Sets the function that the key S calls with the surfaces; without a function the key does
    /// nothing. The function returns a line to show, such as the file's name.
    void set_saver(std::function<std::string(std::span<const l3d_nurbs_surface>)> save) {
        save_ = std::move(save);
    }

    void pointer_event(const l3d_event& event) override;
    void draw_event() override;

protected:
    void draw_overlay() override;
    /// The panel about error bound, times and the marked handle; empty unless handles are shown.
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

    l3d_patch_model model_; ///< the model of edit(), with its colours and parts
    std::optional<l3d_control_handles> handles_;
    bool is_editing_ = false, is_changed_ = false;
    bool tells_times_ = true;
    double reshape_ms_ = 0;
    std::function<std::string(std::span<const l3d_nurbs_surface>)> save_;
};

#endif
