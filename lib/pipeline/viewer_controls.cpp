// SPDX-License-Identifier: MIT
// l3d_viewer_controls: the table, and what it is made for.
#include "pipeline/viewer_controls.h"

#include "pipeline/formatted_p.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <numbers>
#include <set>

namespace {

using l3d_detail::formatted;

constexpr double degree = std::numbers::pi / 180;
constexpr double key_turn = 5 * degree;
constexpr double zoom_factor = 1.1;
/// A drag across 360 pixels is one turn.
constexpr double drag_turn = degree;
/// The key t: a turn in six seconds.
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
                                         std::function<void()> reset)
    : screen_(screen), camera_(camera), rows_(first_rows()) {
    std::ranges::move(rows, std::back_inserter(rows_));
    std::ranges::move(last_rows(viewer, screen, std::move(reset)), std::back_inserter(rows_));
    assert(each_key_is_in_one_row(rows_));
}

/// Of the eye.
std::vector<l3d_viewer_row> l3d_viewer_controls::first_rows() {
    const auto turn = [this](double around_up, double around_right) {
        return [this, around_up, around_right] { camera_.orbit(around_up, around_right); };
    };
    const auto approach = [this](double factor) {
        return [this, factor] { camera_.approach(factor); };
    };
    return {{"arrows, drag",
             "turn",
             {{l3d_key_left, turn(key_turn, 0)},
              {l3d_key_right, turn(-key_turn, 0)},
              {l3d_key_up, turn(0, -key_turn)},
              {l3d_key_down, turn(0, key_turn)}}},
            {"wheel, Page",
             "zoom",
             {{l3d_key_page_up, approach(1 / zoom_factor)},
              {l3d_key_page_down, approach(zoom_factor)}}}};
}

/// Of the program.
std::vector<l3d_viewer_row> l3d_viewer_controls::last_rows(l3d_pipeline& viewer, l3d_screen& screen,
                                                           std::function<void()> reset) {
    const auto pause = [this] {
        paused_ = !paused_;
        say(paused_ ? "paused" : "");
    };
    const auto help = [this] { help_shown_ = !help_shown_; };
    const auto end = [&viewer] { viewer.done = true; };
    const auto first_view = [this, first = camera_, reset = std::move(reset)] {
        camera_ = first;
        if (reset)
            reset();
    };
    const auto save = [this, &screen] {
        if (save_)
            say(save_(screen.pixels()));
    };
    return {
        {"o", "status", {{'o', [this] { status_shown_ = !status_shown_; }}}},
        {"t",
         "turntable",
         {{'t', [this] { turntable_degrees_ = turntable_degrees_ == 0 ? usual_turntable : 0; }}}},
        {"p, space", "pause", {{'p', pause}, {' ', pause}}},
        {"r", "reset view", {{'r', first_view}}},
        {"s", "save a picture", {{'s', save}}},
        {"F11", "whole screen"},
        {"h, ?", "this help", {{'h', help}, {'?', help}}},
        {"q, Escape", "quit", {{'q', end}, {l3d_key_escape, end}}},
    };
}

bool l3d_viewer_controls::key(int key) {
    const bool said = !message_.empty() || hint_seconds_ > 0;
    message_.clear();
    hint_seconds_ = 0;
    for (const l3d_viewer_row& row : rows_)
        for (const auto& [code, action] : row.actions)
            if (code == key) {
                action();
                return true;
            }
    return said;
}

bool l3d_viewer_controls::pointer(const l3d_event& event) {
    if (event.type == l3d_event_type::wheel) {
        camera_.approach(event.y > 0 ? 1 / zoom_factor : zoom_factor);
        return true;
    }
    const bool drags = event.type == l3d_event_type::pointer_motion && event.button == 1;
    if (drags)
        camera_.orbit((pointer_x_ - event.x) * drag_turn, (pointer_y_ - event.y) * drag_turn);
    pointer_x_ = event.x;
    pointer_y_ = event.y;
    return drags;
}

bool l3d_viewer_controls::update(double seconds) {
    constexpr double memory = 0.9; // of the running mean, about ten frames long
    smoothed_seconds_ =
        smoothed_seconds_ == 0 ? seconds : memory * smoothed_seconds_ + (1 - memory) * seconds;
    const bool turns = turntable_degrees_ != 0 && !paused_ && !first_frame_;
    if (turns)
        camera_.orbit(turntable_degrees_ * seconds * degree, 0);
    first_frame_ = false;
    return passes_hint(seconds) || turns;
}

/// Whether its time is over now.
bool l3d_viewer_controls::passes_hint(double seconds) {
    const bool was_shown = hint_seconds_ > 0;
    hint_seconds_ -= seconds;
    return was_shown && !(hint_seconds_ > 0);
}

l3d_panel_style l3d_viewer_controls::panel_style() const {
    l3d_panel_style style;
    style.font = font_;
    style.size = l3d_panel_style::size_for(screen_.pixels().size(), screen_.text_scale());
    return style;
}

/// What a key was answered with has room first, help what is left.
void l3d_viewer_controls::draw(l3d_rasterizer_2d& rasterizer, double milliseconds,
                               std::span<const std::string> lines, const l3d_panel& legend) const {
    l3d_panel status, help, message;
    if (status_shown_) {
        constexpr double least_seconds = 1e-4; // that are told apart from none
        status.add(formatted("%.0f pictures a second, %.1f milliseconds each",
                             1 / std::max(smoothed_seconds_, least_seconds), milliseconds));
        for (const std::string& line : lines)
            status.add(line);
    }
    if (help_shown_)
        for (const l3d_viewer_row& row : rows_)
            help.add(row.keys, row.text);
    if (!message_.empty())
        message.add(message_);
    else if (hint_seconds_ > 0)
        message.add("h", "shows all keys");
    const l3d_panel_style style = panel_style();
    l3d_pixel_box free = l3d_whole(screen_.pixels().size());
    message.draw(rasterizer, free, l3d_corner::bottom_left, style);
    legend.draw(rasterizer, free, l3d_corner::bottom_right, style);
    status.draw(rasterizer, free, l3d_corner::top_left, style);
    help.draw(rasterizer, free, l3d_corner::top_left, style);
}
