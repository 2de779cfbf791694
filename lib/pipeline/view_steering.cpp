// SPDX-License-Identifier: MIT
// l3d_view_steering: moves the camera.
#include "pipeline/viewer_controls.h"

#include "geom/transform.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace {

using vector = l3d_camera::vector;

/// The angle of turning for a drag: 360 pixels make one turn.
constexpr double drag_turn = 1; // degrees for a pixel
/// The factor of zoom for a notch of the wheel.
constexpr double notch_zoom = 1.1;
/// The factor of zoom for a drag by a pixel: a drag by 70 pixels doubles the distance.
constexpr double pixel_zoom = 1.01;
/// The sine of the eye's angle from the pole after leave_pole(). It is just larger than 0.02, the
/// sine at which l3d_camera::orbit stops.
constexpr double sine_beside_pole = 0.021;

/// The ratio of the picture's height to its smaller side.
double height_share(l3d_size size) {
    return static_cast<double>(size.height) / std::min(size.width, size.height);
}

} // namespace

l3d_view_steering::l3d_view_steering(l3d_screen& screen, l3d_camera& camera, l3d_viewed viewed)
    : screen_(screen), camera_(camera), viewed_(std::move(viewed)), first_(camera), kept_(camera),
      upright_(camera.up), up_(camera.up), size_(screen.pixels().size()) {}

void l3d_view_steering::set_home(std::function<l3d_camera()> home) {
    home_ = std::move(home);
    go_home();
}

void l3d_view_steering::go_home() {
    camera_ = home_ ? home_() : first_;
    kept_ = camera_;
    upright_ = up_ = camera_.up;
    is_home_ = true;
    is_framed_ = false;
}

void l3d_view_steering::frame_all() {
    if (!viewed_.framed)
        return;
    camera_ = kept_ = viewed_.framed(camera_);
    is_home_ = false;
    is_framed_ = true;
}

void l3d_view_steering::resized() {
    const l3d_size size = screen_.pixels().size();
    const double factor = height_share(size) / height_share(std::exchange(size_, size));
    if (!home_ && !is_framed_)
        return;
    if (camera_ != kept_)
        approach(factor);
    else if (is_home_)
        go_home();
    else
        frame_all();
}

void l3d_view_steering::turn(double around_up, double around_right) {
    leave_pole();
    camera_.orbit(around_up, around_right);
}

void l3d_view_steering::roll(double degrees) {
    leave_pole();
    const l3d_camera::frame axes = camera_.axes();
    const l3d_turn turn = l3d_turn_by(degrees);
    camera_.up = up_ = axes.up * turn.cosine - axes.right * turn.sine;
}

void l3d_view_steering::pan(double right, double down) {
    grabbed_ = camera_.target;
    move(right, down);
}

void l3d_view_steering::approach(double factor, const vector& place) {
    l3d_camera there = camera_;
    there.approach(factor, place);
    // The place must stay beyond the near plane, since it would not be drawn in front of it.
    const bool is_seen = factor > 1 || depth_of(place) * factor >= 2 * camera_.near_z;
    if (is_seen && there.is_valid())
        camera_ = there;
}

/// Looks from a direction. From above, the model's back is at the top of the picture; from below,
/// its front.
void l3d_view_steering::look_from(double right, double up, double front) {
    const l3d_upright stands(up_ = upright_);
    const double distance = l3d_length(camera_.eye - camera_.target);
    camera_.eye = camera_.target + l3d_normalized(stands.at(right, up, front)) * distance;
    camera_.up = right == 0 && front == 0 ? stands.front * (up > 0 ? -1.0 : 1.0) : up_;
}

bool l3d_view_steering::switch_projection() {
    camera_.projection =
        camera_.is_parallel() ? l3d_projection::perspective : l3d_projection::parallel;
    return camera_.is_parallel();
}

void l3d_view_steering::look_from_opposite() {
    const l3d_upright stands(up_);
    if (sees_along_up())
        look_from(0, l3d_dot(camera_.eye - camera_.target, stands.up) > 0 ? -1 : 1, 0);
    else
        camera_.orbit(180, 0);
}

/// Moves the eye a little off the pole above or below the target, since turning has no direction up
/// at a pole. The picture's direction up stays the same.
void l3d_view_steering::leave_pole() {
    if (!sees_along_up())
        return;
    const vector upright = l3d_upright(up_).up;
    const vector arm = camera_.eye - camera_.target;
    const double distance = l3d_length(arm), side = l3d_dot(arm, upright) > 0 ? 1 : -1;
    const double cosine = std::sqrt(1 - sine_beside_pole * sine_beside_pole);
    camera_.eye =
        camera_.target + (upright * cosine - camera_.up * sine_beside_pole) * (side * distance);
    camera_.up = up_;
}

bool l3d_view_steering::turn_about(double x, double y) {
    const auto found = viewed_.place_at ? viewed_.place_at(x, y) : std::nullopt;
    if (found)
        camera_.move(found->place - camera_.target);
    return found.has_value();
}

double l3d_view_steering::depth_of(const vector& place) const {
    return camera_.depth_of(camera_.is_parallel() ? camera_.target : place);
}

vector l3d_view_steering::place_under(double x, double y) const {
    if (const auto found = viewed_.place_at ? viewed_.place_at(x, y) : std::nullopt)
        return found->place;
    return camera_.place_at(x, y, camera_.depth_of(camera_.target), screen_.pixels().size());
}

std::optional<l3d_point_2d> l3d_view_steering::position(const vector& place) const {
    const double depth = depth_of(place);
    if (!(depth >= camera_.near_z) && !camera_.is_parallel())
        return std::nullopt;
    const l3d_size size = screen_.pixels().size();
    const l3d_camera::frame axes = camera_.axes();
    const vector arm = place - camera_.eye;
    const double scale = camera_.focal_length(size) / depth;
    return l3d_point_2d{size.width / 2.0 + l3d_dot(arm, axes.right) * scale - 0.5,
                        size.height / 2.0 - l3d_dot(arm, axes.up) * scale - 0.5};
}

bool l3d_view_steering::pointer(const l3d_event& event) {
    switch (event.type) {
    case l3d_event_type::wheel:
        approach(std::pow(notch_zoom, -event.turn), place_under(event.x + 0.5, event.y + 0.5));
        return true;
    case l3d_event_type::button_press:
        begin(event);
        return false;
    case l3d_event_type::button_release:
        drag_ = drag::none;
        return false;
    case l3d_event_type::pointer_motion:
        return go_on(event);
    default:
        return false;
    }
}

void l3d_view_steering::begin(const l3d_event& press) {
    x_ = press.x;
    y_ = press.y;
    if (press.button == 1 && !press.shift) {
        drag_ = press.control ? drag::none : drag::turn;
        return;
    }
    drag_ = press.button == 3 ? drag::zoom : drag::move;
    grabbed_ = place_under(press.x + 0.5, press.y + 0.5);
}

bool l3d_view_steering::go_on(const l3d_event& motion) {
    const int right = motion.x - x_, down = motion.y - y_;
    x_ = motion.x;
    y_ = motion.y;
    switch (motion.button == 0 ? drag::none : drag_) {
    case drag::turn:
        turn(-right * drag_turn * turn_speed_, -down * drag_turn * turn_speed_);
        return true;
    case drag::move:
        move(right, down);
        return true;
    case drag::zoom:
        approach(std::pow(pixel_zoom, down), grabbed_);
        return true;
    case drag::none:
        break;
    }
    return false;
}

/// Moves the eye so that the grabbed place stays under the pointer, which has moved to the right
/// and down by these pixels.
void l3d_view_steering::move(double right, double down) {
    const l3d_camera::frame axes = camera_.axes();
    const double pixel = depth_of(grabbed_) / camera_.focal_length(screen_.pixels().size());
    l3d_camera there = camera_;
    there.move((axes.up * down - axes.right * right) * pixel);
    if (there.is_valid())
        camera_ = there;
}
