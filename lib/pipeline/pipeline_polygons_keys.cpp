// SPDX-License-Identifier: MIT
// l3d_pipeline_polygons: what each key does, and the lines of text.
#include "pipeline/pipeline_polygons.h"

#include "raster/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double key_degrees = 5;
constexpr double zoom_factor = 1.1;

constexpr std::uint32_t text_color = 0x00ffe080, shadow_color = 0x00101010;
constexpr int text_scale = 2, text_margin = 8;

constexpr std::array<const char*, 15> help_lines{"arrows, drag  move the eye round",
                                                 "wheel, Page   zoom",
                                                 "x y z         turn the model (X Y Z back)",
                                                 "c             shading",
                                                 "w             solid, wires, hidden lines",
                                                 "b             faces seen from behind",
                                                 "v             perspective, parallel",
                                                 "o             status",
                                                 "t             turntable",
                                                 "p, space      pause",
                                                 "r             reset view",
                                                 "s             save a picture",
                                                 "F11           whole screen",
                                                 "h ?           this help",
                                                 "q Esc         quit"};

template <class... Numbers> std::string formatted(const char* format, Numbers... numbers) {
    std::array<char, 160> text{};
    std::snprintf(text.data(), text.size(), format, numbers...);
    return text.data();
}

constexpr std::array<std::pair<l3d_shade, const char*>, 4> shades{
    {{l3d_shade::flat, "flat"},
     {l3d_shade::gouraud, "gouraud"},
     {l3d_shade::lambert, "lambert"},
     {l3d_shade::normals, "normals"}}};

constexpr std::array<std::pair<l3d_polygon_style, const char*>, 3> styles{
    {{l3d_polygon_style::solid, "solid"},
     {l3d_polygon_style::wireframe, "wireframe"},
     {l3d_polygon_style::hidden_lines, "hidden lines removed"}}};

/// The entry after that of a value, round to the first.
template <class Table, class Value> const auto& next(const Table& table, Value value) {
    std::size_t i = 0;
    while (i < table.size() && table[i].first != value)
        ++i;
    return table[(i + 1) % table.size()];
}

} // namespace

void l3d_pipeline_polygons::say(std::string line) {
    message_ = std::move(line);
    stale_ = true;
}

void l3d_pipeline_polygons::key_event(int key) {
    message_.clear();
    if (key == 'q' || key == l3d_key_escape)
        done = true;
    else if (view_key(key) || turn_key(key) || look_key(key))
        stale_ = true;
}

/// Keys that move the eye or stop it.
bool l3d_pipeline_polygons::view_key(int key) {
    switch (key) {
    case l3d_key_left:
        camera_.orbit(key_degrees * degree, 0);
        return true;
    case l3d_key_right:
        camera_.orbit(-key_degrees * degree, 0);
        return true;
    case l3d_key_up:
        camera_.orbit(0, -key_degrees * degree);
        return true;
    case l3d_key_down:
        camera_.orbit(0, key_degrees * degree);
        return true;
    case l3d_key_page_up:
        camera_.approach(1 / zoom_factor);
        return true;
    case l3d_key_page_down:
        camera_.approach(zoom_factor);
        return true;
    case 'r':
        camera_ = first_camera_;
        settings_ = first_settings_;
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

/// Keys that turn the model about its middle.
bool l3d_pipeline_polygons::turn_key(int key) {
    const bool back = key >= 'X' && key <= 'Z';
    if (!back && !(key >= 'x' && key <= 'z'))
        return false;
    double& angle = settings_.rotation[back ? key - 'X' : key - 'x'];
    angle = std::remainder(angle + (back ? -key_degrees : key_degrees), 360.0);
    return true;
}

/// Keys that change what is shown of the model.
bool l3d_pipeline_polygons::look_key(int key) {
    switch (key) {
    case 'c':
        settings_.shade = next(shades, settings_.shade).first;
        say(std::string("shading: ") +
            std::ranges::find(shades, settings_.shade, [](const auto& s) {
                return s.first;
            })->second);
        return true;
    case 'w': {
        const auto& style = next(styles, settings_.style);
        settings_.style = style.first;
        say(style.second);
        return true;
    }
    case 'b':
        settings_.cull = !settings_.cull;
        say(settings_.cull ? "faces seen from behind are left out" : "all faces are drawn");
        return true;
    case 'v': {
        const bool parallel = settings_.projection == l3d_projection::parallel;
        settings_.projection = parallel ? l3d_projection::perspective : l3d_projection::parallel;
        say(parallel ? "perspective" : "parallel projection");
        return true;
    }
    case 'o':
        status_shown_ = !status_shown_;
        return true;
    case 'h':
    case '?':
        help_shown_ = !help_shown_;
        return true;
    case 's':
        if (save_)
            say(save_(screen_->pixels()));
        return true;
    default:
        return false;
    }
}

void l3d_pipeline_polygons::pointer_event(const l3d_event& event) {
    if (event.type == l3d_event_type::wheel) {
        camera_.approach(event.y > 0 ? 1 / zoom_factor : zoom_factor);
        stale_ = true;
        return;
    }
    if (event.type == l3d_event_type::pointer_motion && event.button == 1) {
        // A drag across 360 pixels is one turn.
        camera_.orbit((pointer_x_ - event.x) * degree, (pointer_y_ - event.y) * degree);
        stale_ = true;
    }
    pointer_x_ = event.x;
    pointer_y_ = event.y;
}

void l3d_pipeline_polygons::update_event(double seconds) {
    constexpr double memory = 0.9; // of the running mean, about ten frames long
    smoothed_seconds_ =
        smoothed_seconds_ == 0 ? seconds : memory * smoothed_seconds_ + (1 - memory) * seconds;
    if (turntable_degrees_ != 0 && !paused_ && !first_frame_) {
        camera_.orbit(turntable_degrees_ * seconds * degree, 0);
        stale_ = true;
    }
    first_frame_ = false;
}

/// Text with a dark edge below and to the right, legible on any grey.
void l3d_pipeline_polygons::draw_overlay() {
    int line = 0;
    const auto write = [&](const std::string& text) {
        const int y = text_margin + line++ * l3d_text_line * text_scale;
        l3d_draw_text(rasterizer_, text_margin + 1, y + 1, text, shadow_color, text_scale);
        l3d_draw_text(rasterizer_, text_margin, y, text, text_color, text_scale);
    };
    if (status_shown_) {
        const auto milliseconds =
            report_.time_ms.place + report_.time_ms.order + report_.time_ms.raster;
        write(formatted("%s  %lld of %lld polygons", name(),
                        static_cast<long long>(report_.polygons.drawn),
                        static_cast<long long>(report_.triangles)));
        write(formatted("%.0f fps  %.2f ms", 1 / std::max(smoothed_seconds_, 1e-4), milliseconds));
        if (report_.order.knots > 0)
            write(formatted("%lld knots, %lld cuts", static_cast<long long>(report_.order.knots),
                            static_cast<long long>(report_.order.cuts)));
    }
    if (help_shown_)
        for (const char* text : help_lines)
            write(text);
    if (!message_.empty())
        write(message_);
}
