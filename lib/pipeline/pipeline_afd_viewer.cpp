// SPDX-License-Identifier: MIT
// l3d_pipeline_afd_viewer: what each key does.
#include "pipeline/pipeline_afd_viewer.h"

#include "raster/text.h"
#include "tool_2d/event.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double key_turn = 5 * degree;
constexpr double zoom_factor = 1.1;
/// A drag across 360 pixels is one turn.
constexpr double drag_turn = degree;

constexpr double least_tolerance = 1.0 / 64, largest_tolerance = 64;

constexpr std::uint32_t text_color = 0x00ffe080, shadow_color = 0x00101010;
constexpr int text_scale = 2, text_margin = 8;

constexpr std::array<const char*, 14> help_lines{
    "arrows, drag  turn",           "wheel, Page   zoom",
    "+ -           detail",         "c             shading",
    "w             wireframe",      "n             control nets",
    "o             status",         "t             turntable",
    "p, space      pause",          "r             reset view",
    "s             save a picture", "F11           whole screen",
    "h ?           this help",      "q Esc         quit"};

const char* name_of(l3d_shade shade) {
    switch (shade) {
    case l3d_shade::lambert:
        return "lambert";
    case l3d_shade::gouraud:
        return "gouraud";
    case l3d_shade::flat:
        return "flat";
    case l3d_shade::normals:
        return "normals";
    case l3d_shade::error:
        return "error";
    }
    return "";
}

l3d_shade next_shade(l3d_shade shade) {
    return shade == l3d_shade::error ? l3d_shade::lambert
                                     : static_cast<l3d_shade>(static_cast<int>(shade) + 1);
}

template <class... Numbers> std::string formatted(const char* format, Numbers... numbers) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), format, numbers...);
    return text.data();
}

/// Text with a dark edge below and to the right, legible on any grey.
void draw_line_of_text(l3d_rasterizer_2d& rasterizer, int line, const std::string& text) {
    const int y = text_margin + line * l3d_text_line * text_scale;
    l3d_draw_text(rasterizer, text_margin + 1, y + 1, text, shadow_color, text_scale);
    l3d_draw_text(rasterizer, text_margin, y, text, text_color, text_scale);
}

} // namespace

void l3d_pipeline_afd_viewer::set_turntable(double degrees_per_frame, double fps) {
    turntable_degrees_ = degrees_per_frame * fps;
}

void l3d_pipeline_afd_viewer::set_tolerance(double pixels) {
    settings().tolerance = std::clamp(pixels, least_tolerance, largest_tolerance);
    say(formatted("error at most %.3g pixels", settings().tolerance));
}

void l3d_pipeline_afd_viewer::say(std::string line) {
    message_ = std::move(line);
    redraw();
}

void l3d_pipeline_afd_viewer::key_event(int key) {
    message_.clear();
    if (key == 'q' || key == l3d_key_escape)
        done = true;
    else if (view_key(key) || look_key(key))
        redraw();
}

/// Keys that move the eye or stop it.
bool l3d_pipeline_afd_viewer::view_key(int key) {
    switch (key) {
    case l3d_key_left:
        camera().orbit(key_turn, 0);
        return true;
    case l3d_key_right:
        camera().orbit(-key_turn, 0);
        return true;
    case l3d_key_up:
        camera().orbit(0, -key_turn);
        return true;
    case l3d_key_down:
        camera().orbit(0, key_turn);
        return true;
    case l3d_key_page_up:
        camera().approach(1 / zoom_factor);
        return true;
    case l3d_key_page_down:
        camera().approach(zoom_factor);
        return true;
    case 'r':
        reset_camera();
        return true;
    case 'p':
    case ' ':
        paused_ = !paused_;
        say(paused_ ? "paused" : "");
        return true;
    case 't':
        // A turn in six seconds, or none.
        turntable_degrees_ = turntable_degrees_ == 0 ? 60 : 0;
        return true;
    default:
        return false;
    }
}

/// Keys that change what is shown of the surface.
bool l3d_pipeline_afd_viewer::look_key(int key) {
    switch (key) {
    case '+':
    case '=':
        set_tolerance(settings().tolerance / 2);
        return true;
    case '-':
        set_tolerance(settings().tolerance * 2);
        return true;
    case 'c':
        settings().shade = next_shade(settings().shade);
        say(std::string("shading: ") + name_of(settings().shade));
        return true;
    case 'w':
        settings().wireframe = !settings().wireframe;
        return true;
    case 'n':
        settings().net = !settings().net;
        return true;
    case 'o':
        status_shown_ = !status_shown_;
        return true;
    case 'h':
    case '?':
        help_shown_ = !help_shown_;
        return true;
    case 's':
        if (save_)
            say(save_(pixels()));
        return true;
    default:
        return false;
    }
}

void l3d_pipeline_afd_viewer::pointer_event(const l3d_event& event) {
    if (event.type == l3d_event_type::wheel) {
        camera().approach(event.y > 0 ? 1 / zoom_factor : zoom_factor);
        return redraw();
    }
    if (event.type == l3d_event_type::pointer_motion && event.button == 1) {
        camera().orbit((pointer_x_ - event.x) * drag_turn, (pointer_y_ - event.y) * drag_turn);
        redraw();
    }
    pointer_x_ = event.x;
    pointer_y_ = event.y;
}

void l3d_pipeline_afd_viewer::update_event(double seconds) {
    constexpr double memory = 0.9; // of the running mean, about ten frames long
    smoothed_seconds_ =
        smoothed_seconds_ == 0 ? seconds : memory * smoothed_seconds_ + (1 - memory) * seconds;
    if (turntable_degrees_ != 0 && !paused_ && !first_frame_) {
        camera().orbit(turntable_degrees_ * seconds * degree, 0);
        redraw();
    }
    first_frame_ = false;
}

void l3d_pipeline_afd_viewer::draw_overlay() {
    int line = 0;
    if (status_shown_) {
        const l3d_frame_report& last = last_report();
        draw_line_of_text(rasterizer(), line++,
                          formatted("%.0f fps  %.2f ms", 1 / std::max(smoothed_seconds_, 1e-4),
                                    last.time_ms.total));
        draw_line_of_text(
            rasterizer(), line++,
            formatted("error at most %.3f px (tolerance %.3g)", bound(), settings().tolerance));
    }
    if (help_shown_)
        for (const char* text : help_lines)
            draw_line_of_text(rasterizer(), line++, text);
    if (!message_.empty())
        draw_line_of_text(rasterizer(), line, message_);
}
