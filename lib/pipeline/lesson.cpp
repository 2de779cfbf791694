// SPDX-License-Identifier: MIT
// l3d_lesson: handles the keys and the mouse, and draws the ground.
#include "pipeline/lesson.h"

#include <array>
#include <utility>

namespace {

/// The ground of lessons: darker than the ground of viewers, since the book's colours are made for
/// a black ground.
constexpr l3d_background dark{0x000b0f15, 0x00283241};

} // namespace

std::vector<l3d_caption_row> l3d_lesson_keys(const std::string& dragging) {
    return {{"drag", dragging}, {"space", "stop, go on"}, {"r", "start again"}};
}

l3d_lesson::l3d_lesson(l3d_canvas canvas) : l3d_lesson(canvas.is_classic, std::move(canvas)) {}

l3d_lesson::l3d_lesson(bool is_classic, l3d_canvas&& canvas)
    : l3d_pipeline_2d(std::move(canvas)), is_classic_(is_classic),
      ground_(is_classic ? l3d_background() : dark) {}

void l3d_lesson::any_event(const l3d_event&) {
    is_stale_ = true;
}

void l3d_lesson::key_event(int key) {
    if (key == ' ') {
        stopped_ = !stopped_;
    } else if (key == 'r') {
        is_bare_ = true;
        restart();
    } else {
        l3d_pipeline_2d::key_event(key);
    }
}

void l3d_lesson::pointer_event(const l3d_event& event) {
    if (event.type == l3d_event_type::wheel)
        return roll(event.notches);
    const bool is_first_button = event.button == 1;
    if (event.type == l3d_event_type::button_release && is_first_button)
        is_held_ = false;
    const bool is_pressed = event.type == l3d_event_type::button_press && is_first_button;
    if (is_pressed || (is_held_ && event.type == l3d_event_type::pointer_motion))
        drag(event.x, event.y, is_pressed ? 0 : event.x - x_, is_pressed ? 0 : event.y - y_);
    is_held_ |= is_pressed;
    x_ = event.x;
    y_ = event.y;
}

void l3d_lesson::drag(int, int, int, int) {}

void l3d_lesson::roll(int) {}

void l3d_lesson::resize_event(l3d_size size) {
    l3d_pipeline_2d::resize_event(size);
    is_bare_ = true;
}

void l3d_lesson::update_event(double seconds) {
    is_stale_ |= !is_at_rest();
    if (!stopped_)
        advance(seconds);
}

std::string l3d_lesson::message() const {
    return stopped_ ? "stopped; space goes on" : "";
}

/// Draws the ground as a rectangle with two colours, which every kind of output can draw.
void l3d_lesson::clear(l3d_rasterizer_2d& rasterizer) {
    if (ground_ == l3d_background())
        return rasterizer.clear_buffer();
    const double right = size().width, bottom = size().height;
    const std::array<l3d_colored_point_2d, 4> corners{{{0, 0, ground_.top},
                                                       {right, 0, ground_.top},
                                                       {right, bottom, ground_.bottom},
                                                       {0, bottom, ground_.bottom}}};
    rasterizer.draw_polygon_gouraudshaded(corners);
}

void l3d_lesson::draw(l3d_rasterizer_2d& rasterizer) {
    is_stale_ = false;
    if (std::exchange(is_bare_, false))
        clear(rasterizer);
    draw_lesson(rasterizer);
}
