// SPDX-License-Identifier: MIT
// l3d_viewer_controls: handles the keys, pointer and panels that all viewers share.
#include "pipeline/viewer_controls.h"

#include "base/formatted_p.h"
#include "pipeline/panel_places_p.h"
#include "raster/paths/path.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <set>

namespace {

using l3d_detail::formatted;

constexpr double key_turn = 5; // degrees
constexpr double zoom_factor = 1.1;
constexpr double pan_share = 0.05; // share of the picture's smaller side
/// The speed of the turntable that the key t switches on: 60 degrees a second, a turn in six
/// seconds.
constexpr double usual_turntable = 60;

[[maybe_unused]] bool each_key_is_in_one_row(const std::vector<l3d_viewer_row>& rows) {
    std::set<int> keys;
    return std::ranges::all_of(rows, [&](const l3d_viewer_row& row) {
        return std::ranges::all_of(
            row.actions, [&](const auto& action) { return keys.insert(action.first).second; });
    });
}

} // namespace

l3d_viewer_controls::l3d_viewer_controls(l3d_pipeline& viewer, l3d_screen& screen,
                                         l3d_camera& camera, std::vector<l3d_viewer_row> rows,
                                         std::function<void()> reset, l3d_viewed viewed,
                                         l3d_font font)
    : screen_(screen), font_(std::move(font)), viewed_(viewed),
      steering_(screen, camera, std::move(viewed)), rows_(first_rows()) {
    std::ranges::move(side_rows(), std::back_inserter(rows_));
    std::ranges::move(rows, std::back_inserter(rows_));
    own_end_ = std::ssize(rows_);
    std::ranges::move(last_rows(viewer, screen, std::move(reset)), std::back_inserter(rows_));
    assert(each_key_is_in_one_row(rows_));
}

void l3d_viewer_controls::add(l3d_viewer_row row) {
    rows_.insert(rows_.begin() + own_end_++, std::move(row));
    assert(each_key_is_in_one_row(rows_));
}

/// The rows of help for keys that move the eye.
std::vector<l3d_viewer_row> l3d_viewer_controls::first_rows() {
    const auto towards = [this](int right, int down) {
        return [this, right, down] { arrow(right, down); };
    };
    const auto approach = [this](double factor) {
        return [this, factor] { steering_.approach(factor); };
    };
    return {{"arrows, 4 6 8 2, drag",
             "turn",
             {{l3d_key_left, towards(-1, 0)},
              {l3d_key_right, towards(1, 0)},
              {l3d_key_up, towards(0, -1)},
              {l3d_key_down, towards(0, 1)},
              {'4', towards(-1, 0)},
              {'6', towards(1, 0)},
              {'8', towards(0, -1)},
              {'2', towards(0, 1)}}},
            {"Ctrl+arrows, Shift+drag", "move, as the middle button does"},
            {"Shift+left, right", "roll"},
            {"wheel, Page, Ctrl++, -",
             "zoom, as a drag with the right button",
             {{l3d_key_page_up, approach(1 / zoom_factor)},
              {l3d_key_page_down, approach(zoom_factor)}}},
            {"double click", "turn about this place"},
            {"Ctrl+click", "what is there; a second one: distance, angle"}};
}

/// The rows of help for keys that show the model's sides. The keys are those of Blender.
std::vector<l3d_viewer_row> l3d_viewer_controls::side_rows() {
    const auto look = [this](double right, double up, double front) {
        return [this, right, up, front] {
            const double sign = control_ ? -1 : 1;
            steering_.look_from(sign * right, sign * up, sign * front);
        };
    };
    return {
        {"f", "show all of it", {{'f', [this] { steering_.frame_all(); }}}},
        {"1, 3, 7",
         "from the front, the right, above",
         {{'1', look(0, 0, 1)}, {'3', look(1, 0, 0)}, {'7', look(0, 1, 0)}}},
        {"Ctrl+1, 3, 7", "from the back, the left, below"},
        {"9", "from the opposite side", {{'9', [this] { steering_.look_from_opposite(); }}}},
    };
}

/// The rows of help for the program as a whole: status, turntable, pause, reset, files, help, end.
std::vector<l3d_viewer_row> l3d_viewer_controls::last_rows(l3d_pipeline& viewer, l3d_screen& screen,
                                                           std::function<void()> reset) {
    const auto pause = [this] {
        paused_ = !paused_;
        say(paused_ ? "paused" : "");
    };
    const auto help = [this] {
        help_page_ = help_page_ < help_pages().size() ? help_page_ + 1 : 0;
    };
    const auto end = [&viewer] { viewer.done = true; };
    const auto first_view = [this, reset = std::move(reset)] {
        if (reset)
            reset();
        measured_.reset();
        marks_.clear();
        steering_.go_home();
    };
    const auto save = [this, &screen] {
        if (save_)
            say(save_(screen.pixels()));
    };
    const auto tell_view = [this] {
        if (tell_view_)
            say(tell_view_());
    };
    return {
        {"o", "status", {{'o', [this] { status_shown_ = !status_shown_; }}}},
        {"t",
         "turntable",
         {{'t', [this] { turntable_degrees_ = turntable_degrees_ == 0 ? usual_turntable : 0; }}}},
        {"p, space", "pause", {{'p', pause}, {' ', pause}}},
        {"r", "reset view", {{'r', first_view}}},
        {"s", "save a picture", {{'s', save}}},
        {"g", "this view as options", {{'g', tell_view}}},
        {"F11", "whole screen"},
        {"h, ?", "this help", {{'h', help}, {'?', help}}},
        {"q, Escape", "quit", {{'q', end}, {l3d_key_escape, end}}},
    };
}

void l3d_viewer_controls::switch_headlight(bool& is_on) {
    is_on = !is_on;
    say(is_on ? "light: goes with the eye" : "light: stays where it is in the world");
}

void l3d_viewer_controls::switch_projection() {
    say(steering_.switch_projection() ? "parallel projection" : "perspective");
}

/// Acts on an arrow key, or on its digit on the number pad: moves the eye with Ctrl, rolls with
/// Shift, and turns otherwise.
void l3d_viewer_controls::arrow(int right, int down) {
    const double angle = key_turn * turn_speed_;
    if (control_) {
        const l3d_size size = screen_.pixels().size();
        const double step = pan_share * std::min(size.width, size.height);
        steering_.pan(right * step, down * step);
    } else if (shift_ && right != 0) {
        steering_.roll(right * angle);
    } else {
        steering_.turn(-right * angle, down * angle);
    }
}

/// Zooms by the keys + and - if Ctrl is held. Without Ctrl, these keys belong to the program.
/// Returns whether the key zoomed.
bool l3d_viewer_controls::zoom_key(int key) {
    if (!control_ || (key != '+' && key != '-'))
        return false;
    steering_.approach(key == '+' ? 1 / zoom_factor : zoom_factor);
    return true;
}

bool l3d_viewer_controls::key(int key) {
    const bool has_marks = !measured_ && !marks_.empty();
    const bool said = !message_.empty() || hint_seconds_ > 0 || has_marks;
    message_.clear();
    hint_seconds_ = 0;
    if (!measured_)
        marks_.clear();
    if (zoom_key(key))
        return true;
    for (const l3d_viewer_row& row : rows_)
        for (const auto& [code, action] : row.actions)
            if (code == key) {
                action();
                return true;
            }
    return said;
}

bool l3d_viewer_controls::pointer(const l3d_event& event) {
    const bool needs_picture = steering_.pointer(event);
    if (event.type != l3d_event_type::button_press || event.button != 1 || event.shift)
        return needs_picture;
    // The middle of the pixel under the pointer.
    const double x = event.x + 0.5, y = event.y + 0.5;
    if (event.control)
        measure(x, y);
    else if (event.clicks == 2)
        return steering_.turn_about(x, y);
    return event.control;
}

namespace {

/// The angle between two places' normals in words. An error of length e in a unit normal changes
/// the angle by at most 2 asin(e / 2). Rounding adds to this.
std::string angle_text(const l3d_pointed_place& a, const l3d_pointed_place& b) {
    const double sine = l3d_length(l3d_cross(a.normal, b.normal));
    const double cosine = l3d_dot(a.normal, b.normal);
    const double errors = a.normal_error + b.normal_error;
    if ((sine == 0 && cosine == 0) || !(errors < 1))
        return "";
    constexpr double degree = std::numbers::pi / 180, rounding = 16 * 0x1p-53;
    return formatted("; normals %.9g degrees apart, good to %.1g",
                     std::atan2(sine, cosine) / degree,
                     (2 * std::asin(errors / 2) + rounding) / degree);
}

} // namespace

/// Measures at a place in the picture, at a click with Ctrl. The first of two clicks tells its
/// place, and the second click tells the distance from this place.
void l3d_viewer_controls::measure(double x, double y) {
    if (!viewed_.place_at)
        return;
    const auto found = viewed_.place_at(x, y);
    if (!found) {
        if (!measured_)
            marks_.clear();
        say("nothing is there");
    } else if (!measured_) {
        measured_ = found;
        marks_ = {found->place};
        say(found->text);
    } else {
        marks_.push_back(found->place);
        say(formatted("distance %.9g units, good to %.1g",
                      l3d_length(found->place - measured_->place),
                      found->error + measured_->error) +
            angle_text(*measured_, *found));
        measured_.reset();
    }
}

bool l3d_viewer_controls::update(double seconds) {
    const bool turns = turntable_degrees_ != 0 && !paused_ && !first_frame_;
    if (turns)
        steering_.turn(turntable_degrees_ * seconds, 0);
    first_frame_ = false;
    return rest(seconds) || turns;
}

bool l3d_viewer_controls::rest(double seconds) {
    const bool was_shown = hint_seconds_ > 0;
    hint_seconds_ -= seconds;
    return was_shown && !(hint_seconds_ > 0);
}

l3d_panel_style l3d_viewer_controls::panel_style() const {
    return l3d_detail::panel_style_of(screen_, font_);
}

/// The help with all keys, on as many pages as the window needs.
std::vector<l3d_panel> l3d_viewer_controls::help_pages() const {
    l3d_panel all;
    for (const l3d_viewer_row& row : rows_)
        all.add(row.keys, row.text);
    return all.pages(screen_.pixels().size(), "h", panel_style());
}

l3d_panel l3d_viewer_controls::message_panel() const {
    l3d_panel message;
    if (!empty_line_.empty())
        message.add(empty_line_);
    if (!message_.empty())
        message.add(message_);
    else if (hint_seconds_ > 0)
        message.add("h", "shows all keys");
    return message;
}

l3d_panel l3d_viewer_controls::status_panel(std::span<const std::string> lines) const {
    l3d_panel status;
    if (!status_shown_)
        return status;
    if (const std::string pace = pace_.text(); !pace.empty())
        status.add(pace);
    for (const std::string& line : lines)
        status.add(line);
    return status;
}

/// Draws a ring around each place that was clicked on, and a line between two such places. Dark
/// rims make rings and lines visible on any ground.
void l3d_viewer_controls::draw_marks(l3d_rasterizer_2d& rasterizer) const {
    const double unit = std::max(1.0, screen_.text_scale());
    l3d_path path;
    std::optional<l3d_point_2d> before;
    for (const l3d_camera::vector& place : marks_) {
        const std::optional<l3d_point_2d> there = steering_.position(place);
        if (there)
            path.add_circle(*there, 5 * unit);
        if (there && before) {
            path.move_to(*before);
            path.line_to(*there);
        }
        before = there;
    }
    const l3d_panel_style style = panel_style();
    rasterizer.draw_path(l3d_stroked(path, {.width = 4 * unit}), {.color = style.ground});
    rasterizer.draw_path(l3d_stroked(path, {.width = 2 * unit}), {.color = style.key});
}

/// Places and draws the panels. The message gets its place first. The help gets its place next, if
/// too little room would be left after all other panels.
void l3d_viewer_controls::draw(l3d_rasterizer_2d& rasterizer, std::span<const std::string> lines,
                               const l3d_panel& legend, const l3d_standing_panel& standing) const {
    draw_marks(rasterizer);
    l3d_pixel_box room = l3d_whole(screen_.pixels().size());
    room.left = std::min(left_margin_, room.right - 1);
    l3d_detail::panel_places places(room, panel_style());
    const std::array first{l3d_standing_panel{message_panel(), l3d_corner::bottom_left}, standing,
                           l3d_standing_panel{legend, l3d_corner::bottom_right},
                           l3d_standing_panel{status_panel(lines), l3d_corner::top_left}};
    l3d_panel help;
    if (help_page_ > 0) {
        const std::vector<l3d_panel> pages = help_pages();
        help = pages[std::min(help_page_, pages.size()) - 1];
    }
    l3d_detail::panel_places beside = places;
    for (const auto& [panel, corner] : first)
        beside.take(panel, corner);
    const bool help_has_room = beside.take(help, l3d_corner::top_left);
    std::vector<l3d_pixel_box> texts;
    const auto draw = [&](const l3d_panel& panel, l3d_corner corner) {
        if (const l3d_pixel_box box = places.draw(rasterizer, panel, corner); !box.empty())
            texts.push_back(box);
    };
    for (const auto& [panel, corner] : first) {
        const bool is_message = &panel == &first[0].panel;
        if (is_message || help_has_room || l3d_detail::panel_places(places).take(panel, corner))
            draw(panel, corner);
        if (is_message && !help_has_room)
            draw(help, l3d_corner::top_left);
    }
    if (help_has_room)
        draw(help, l3d_corner::top_left);
    screen_.set_text(std::move(texts));
}

namespace {

constexpr std::chrono::seconds span{1};

/// The number of pictures that count for the means. These are the pictures that began before
/// `begin`, the last beginning of a picture. A single picture counts in any case.
template <class Pictures>
std::size_t counted(const Pictures& done, l3d_picture_pace::clock::time_point begin) {
    return done.size() - (done.size() > 1 && done.back().begin == begin ? 1 : 0);
}

} // namespace

/// Notes the beginning of a picture, and drops pictures of more than a second ago. The last picture
/// is kept in any case, since it tells how long drawing takes.
void l3d_picture_pace::begin() {
    begin_ = now_();
    follows_ = !done_.empty() && begin_ - done_.back().end <= span;
    while (done_.size() > 1 && (!follows_ || begin_ - done_.front().begin > span))
        done_.pop_front();
}

void l3d_picture_pace::end() {
    if (!follows_)
        done_.clear();
    done_.push_back({begin_, now_()});
}

double l3d_picture_pace::milliseconds() const {
    std::chrono::duration<double, std::milli> sum{0};
    const std::size_t count = counted(done_, begin_);
    for (std::size_t i = 0; i < count; ++i)
        sum += done_[i].end - done_[i].begin;
    return count == 0 ? 0 : sum.count() / static_cast<double>(count);
}

double l3d_picture_pace::per_second() const {
    if (!follows_ || !(begin_ > done_.front().begin))
        return 0;
    const std::chrono::duration<double> passed = begin_ - done_.front().begin;
    return static_cast<double>(counted(done_, begin_)) / passed.count();
}

std::string l3d_picture_pace::text() const {
    using l3d_detail::formatted;
    if (done_.empty())
        return "";
    const double rate = per_second();
    if (rate == 0)
        return formatted("drawn in %.1f ms", milliseconds());
    constexpr double few = 10; // tenths matter below this rate
    return formatted("%.*f pictures a second, each drawn in %.1f ms", rate < few ? 1 : 0, rate,
                     milliseconds());
}
