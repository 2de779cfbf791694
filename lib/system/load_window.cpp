// SPDX-License-Identifier: MIT
// load_window: opens, draws and asks a small window while a file is read.
#include "system/load_window_p.h"

#include "base/printable_p.h"
#include "raster/text/panel.h"

#include <unistd.h>

namespace l3d_detail {

bool load_window::is_wanted() const {
    const l3d_common_options& common = options_.common();
    return isatty(STDERR_FILENO) == 0 && common.output.empty() && common.frames == 0 &&
           !options_.wants_result();
}

void load_window::open(const std::string& file) {
    l3d_screen_request request = options_.screen_request();
    request.size = {480, 64}; // a line of sixty letters, and one below
    request.title = printable(file) + " - " + request.title;
    screen_ = factories_.create_notice(options_, request);
    std::string why;
    font_ = l3d_font::of_system(why);
}

bool load_window::is_ended() {
    for (l3d_event event; screen_->next_event(event);)
        switch (event.type) {
        case l3d_event_type::close:
            return true;
        case l3d_event_type::key_press:
            if (event.key == l3d_key_escape || event.key == 'q')
                return true;
            break;
        case l3d_event_type::resize:
        case l3d_event_type::expose:
            shown_.clear();
            break;
        case l3d_event_type::display_lost:
            screen_.reset();
            return false;
        default:
            break;
        }
    return false;
}

void load_window::draw(const std::string& file, double share) {
    const auto time = std::chrono::duration_cast<std::chrono::seconds>(clock::now() - begin_);
    const std::string now = std::to_string(time.count()) + " s, " +
                            std::to_string(static_cast<int>(100 * share)) + " %";
    if (now == shown_)
        return;
    shown_ = now;
    const l3d_pixels pixels = screen_->pixels();
    const auto by_processor = l3d_rasterizer_factory_sw().create_2d(pixels);
    l3d_rasterizer_2d rasterizer(*by_processor);
    l3d_panel_style style;
    style.font = font_;
    style.size = l3d_panel_style::size_for({1024, 768}, screen_->text_scale());
    rasterizer.clear_buffer(style.ground);
    l3d_panel panel;
    panel.add_title("reading " + printable(file));
    panel.add(now, "Esc ends it");
    l3d_pixel_box free = l3d_whole(pixels.size());
    panel.draw(rasterizer, free, l3d_corner::top_left, style);
    const int bar = pixels.height / 12;
    const auto done = static_cast<int>(pixels.width * share);
    rasterizer.draw_box({0, pixels.height - bar, done, pixels.height}, style.key);
    screen_->show();
}

bool load_window::goes_on(const std::string& file, double share) {
    constexpr std::chrono::milliseconds soon(500); // a shorter wait needs no window
    if (share >= 1) {
        screen_.reset();
        return !is_stopped_;
    }
    if (!is_tried_ && clock::now() - begin_ > soon) {
        is_tried_ = true;
        if (is_wanted())
            open(file);
    }
    if (!screen_)
        return !is_stopped_;
    is_stopped_ = is_stopped_ || is_ended();
    if (is_stopped_) {
        screen_.reset();
        return false;
    }
    if (screen_)
        draw(file, share);
    return true;
}

} // namespace l3d_detail
