// SPDX-License-Identifier: MIT
// l3d_view_steering: moves a viewer's eye by keys and the pointer.
#ifndef L3D_PIPELINE_VIEW_STEERING_H
#define L3D_PIPELINE_VIEW_STEERING_H

#include "base/public.h"
#include "raster/rasterizer_2d.h"
#include "scene/camera.h"
#include "tool_2d/event.h"
#include "tool_2d/screen.h"

#include <functional>
#include <optional>
#include <string>

/// The nearest place of a model at a position in the picture.
struct L3D_PUBLIC l3d_pointed_place {
    l3d_camera::vector place{0.0, 0.0, 0.0}; ///< in the world
    double error = 0; ///< the largest distance from the exact place, in world units
    std::string text; ///< a line about the surface there
};

/// The questions that the controls ask a viewer about its picture. An empty function leaves out the
/// controls that need it.
struct L3D_PUBLIC l3d_viewed {
    /// The camera that shows everything along the line of sight of the given one.
    std::function<l3d_camera(const l3d_camera&)> framed{};
    /// The nearest place at a position, in pixels from the picture's left upper corner; none if
    /// there is no surface.
    std::function<std::optional<l3d_pointed_place>(double x, double y)> place_at{};
    /// Whether the projection is parallel now.
    std::function<bool()> is_parallel{};
};

/// Moves a viewer's camera: turns it about its target, moves and zooms by the place under the
/// pointer, shows a model from its sides, and frames it.
///
/// Lives:   borrows screen and camera.
class L3D_PUBLIC l3d_view_steering {
public:
    /// A place or a direction in the world.
    using vector = l3d_camera::vector;

    /// Steers the camera of pictures on that screen.
    l3d_view_steering(l3d_screen& screen, l3d_camera& camera, l3d_viewed viewed);

    /// Sets the function that makes the first view: now, at each reset, and at each change of the
    /// picture's size until the camera is moved.
    void set_home(std::function<l3d_camera()> home);

    /// Back to the first view.
    void go_home();
    /// Shows everything along the line of sight.
    void frame_all();
    /// Keeps the view of the model after the picture has got another size. A camera that a program
    /// placed itself stays as it is.
    void resized();

    /// Sets the factor by which keys and the pointer turn more than usual. Expects: more than 0.
    void set_turn_speed(double factor) { turn_speed_ = factor; }

    /// Moves the eye around the target. Units: radians, about the upright axis and about the
    /// picture's right.
    void turn(double around_up, double around_right);
    /// Turns the picture about its middle, clockwise. The picture's new upright direction holds for
    /// turn() until look_from or go_home. Units: radians.
    void roll(double angle);
    /// Moves things at the target's depth so many pixels to the right and down.
    void pan(double right, double down);
    /// Multiplies the distance from the target, unless that leads too near or too far.
    void approach(double factor) { approach(factor, camera_.target); }
    /// Moves the eye to this direction from the target, at the same distance. The three numbers are
    /// steps along the axes of l3d_upright, such as (0, 0, 1) for the front. Expects: not all 0.
    void look_from(double right, double up, double front);
    /// Moves the eye to the opposite side.
    void look_from_opposite();

    /// The place under the pointer becomes the middle of the picture, which the eye turns about.
    /// False if nothing is there.
    bool turn_about(double x, double y);

    /// A world place's position in the picture, as rasterizers count: whole numbers are the middles
    /// of pixels. Nothing if it is before the near plane.
    std::optional<l3d_point_2d> position(const vector& place) const;

    /// A button went down, the pointer moved or the wheel turned: turns, moves or zooms. True if
    /// another picture is needed.
    bool pointer(const l3d_event& event);

private:
    enum class drag { none, turn, move, zoom };

    void begin(const l3d_event& press);
    bool go_on(const l3d_event& motion);
    void approach(double factor, const vector& place);
    void move(double x, double y);
    /// The place under the pointer; without a surface, at the target's depth.
    vector place_under(double x, double y) const;
    double depth_of(const vector& place) const;
    void leave_pole();
    bool sees_along_up() const { return camera_.up != up_; }

    l3d_screen& screen_;
    l3d_camera& camera_;
    l3d_viewed viewed_;
    std::function<l3d_camera()> home_;
    l3d_camera first_; ///< the program's own view, without a home
    l3d_camera kept_;  ///< view set by home or frame; camera_ differs once it was moved
    bool is_home_ = false, is_framed_ = false; ///< whether home or frame set kept_
    vector upright_;                           ///< the model's, whatever the picture shows
    vector up_; ///< the eye's axis of turning: upright_, unless rolled
    double turn_speed_ = 1;
    l3d_size size_;
    drag drag_ = drag::none;
    vector grabbed_{0.0, 0.0, 0.0};
    int x_ = 0, y_ = 0;
};

#endif
