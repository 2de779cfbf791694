// SPDX-License-Identifier: MIT
// A screen that is an X11 window with an image, and the factories that pair them.
#include "tool_2d/screen_x11.h"

#include "tool_2d/image.h"
#include "tool_2d/x11_events_p.h"
#include "tool_2d/x11_image_p.h"
#include "tool_2d/x11_window_p.h"

#include <algorithm>
#include <new>
#include <sstream>
#include <utility>

namespace {

using namespace l3d_detail;
using namespace std::chrono_literals;
using std::chrono::steady_clock;

// A window manager may take this long before we give up waiting for the window and just draw.
constexpr auto longest_map = 2s;
// Input must not wait longer than this for a slow connection.
constexpr auto longest_put = 100ms;
// Keeps a deadline inside the clock's range.
constexpr std::chrono::nanoseconds longest_wait = 24h;

/// Window, image and events of one display.
///
/// At most one picture is under way to the server. If the next is to be shown before its arrival
/// was confirmed, show waits a little, and then leaves it to whoever next asks for events.
class l3d_screen_x11 final : public l3d_screen {
public:
    l3d_screen_x11(std::unique_ptr<x11_window> window, l3d_size size)
        : window_(std::move(window)), events_(*window_), picture_(size, size.width),
          image_(make_x11_image_put(*window_, size)) {}

    /// Puts the window on the screen and waits until the server wants it drawn.
    void open();

private:
    l3d_pixels do_pixels() override { return picture_.pixels(); }
    const l3d_screen_info& do_info() const override { return window_->info(); }
    void do_show() override;
    bool do_is_window() const override { return true; }
    std::string do_describe() const override;
    bool do_next_event(l3d_event& event) override;
    void do_wait(std::chrono::nanoseconds longest) override;

    void read_events();
    void put_if_due();
    bool resized_to(l3d_size size);

    std::unique_ptr<x11_window> window_;
    x11_events events_;
    l3d_image picture_;
    std::unique_ptr<x11_image> image_;
    bool put_is_due_ = false; ///< a picture is to be put once there is a buffer for it
    bool lost_is_told_ = false;
};

void l3d_screen_x11::open() {
    window_->map();
    const auto deadline = steady_clock::now() + longest_map;
    do {
        read_events();
    } while (!events_.was_exposed() && window_->connection().wait_readable(deadline));
    if (events_.is_mapped())
        window_->focus_if_unmanaged();
}

void l3d_screen_x11::do_show() {
    put_is_due_ = true;
    const auto deadline = steady_clock::now() + longest_put;
    do {
        read_events();
    } while (put_is_due_ && window_->connection().wait_readable(deadline));
}

void l3d_screen_x11::put_if_due() {
    if (!put_is_due_ || !image_->is_free())
        return;
    put_is_due_ = false;
    if (window_->connection().lost())
        return;
    image_->put(picture_.pixels());
}

/// Reads all that the server sent so far. Nothing follows the last XPending: writing may read
/// too, and what it read would not wake a sleeper.
void l3d_screen_x11::read_events() {
    auto* display = window_->display();
    put_if_due();
    while (!window_->connection().lost() && XPending(display) > 0) {
        XEvent event;
        XNextEvent(display, &event);
        if (image_->take(event))
            put_if_due();
        else
            events_.take(event);
    }
    if (window_->connection().lost() && !std::exchange(lost_is_told_, true))
        events_.take_display_lost();
}

bool l3d_screen_x11::do_next_event(l3d_event& event) {
    read_events();
    while (events_.next(event)) {
        if (event.type != l3d_event_type::resize || resized_to(event.size))
            return true;
    }
    return false;
}

/// New pixels only now, when the program learns of them: until then it may draw into the old.
bool l3d_screen_x11::resized_to(l3d_size size) {
    if (size == picture_.pixels().size())
        return false;
    try {
        auto image = make_x11_image_put(*window_, size);
        picture_ = l3d_image(size, size.width);
        image_ = std::move(image);
    } catch (const std::bad_alloc&) {
        return false; // The old picture goes on, in a part of the window.
    }
    put_is_due_ = false;
    return true;
}

void l3d_screen_x11::do_wait(std::chrono::nanoseconds longest) {
    const auto deadline = steady_clock::now() + std::min(longest, longest_wait);
    do {
        read_events();
    } while (events_.empty() && window_->connection().wait_readable(deadline));
}

std::string l3d_screen_x11::do_describe() const {
    const auto& layout = info().layout();
    std::ostringstream text;
    text << "X11 window: " << image_->describe() << ", TrueColor, depth " << layout.depth << ", "
         << layout.bits_per_pixel << " bits per pixel, "
         << (layout.byte_order == std::endian::little ? "low" : "high") << " byte first, masks "
         << std::hex << layout.red_mask << "/" << layout.green_mask << "/" << layout.blue_mask;
    return text.str();
}

std::unique_ptr<l3d_screen> open_screen(const l3d_screen_request& request, l3d_service& refusal) {
    auto connection = x11_connection::open(refusal.why);
    if (!connection) {
        refusal.how = l3d_service::level::no_display;
        return nullptr;
    }
    const auto visual = choose_x11_visual(*connection, refusal.why);
    if (!visual) {
        refusal.how = l3d_service::level::not_here;
        return nullptr;
    }
    auto window = x11_window::open(std::move(connection), *visual, request, refusal);
    if (!window)
        return nullptr;
    try {
        auto screen = std::make_unique<l3d_screen_x11>(std::move(window), request.size);
        screen->open();
        return screen;
    } catch (const std::bad_alloc&) {
        refusal = {l3d_service::level::not_here,
                   "not enough memory for a picture of " + std::to_string(request.size.width) +
                       "x" + std::to_string(request.size.height)};
        return nullptr;
    }
}

} // namespace

l3d_service l3d_screen_factory_ximage::do_service() const {
    l3d_service service;
    const auto connection = x11_connection::open(service.why);
    if (!connection)
        service.how = l3d_service::level::no_display;
    else if (!choose_x11_visual(*connection, service.why))
        service.how = l3d_service::level::not_here;
    return service;
}

std::unique_ptr<l3d_screen> l3d_screen_factory_ximage::do_create(const l3d_screen_request& request,
                                                                 l3d_service& refusal) const {
    return open_screen(request, refusal);
}
