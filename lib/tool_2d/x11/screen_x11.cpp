// SPDX-License-Identifier: MIT
// l3d_screen_x11: shows an image in an X11 window. Its factories choose how the image gets there.
#include "tool_2d/x11/screen_x11.h"

#include "tool_2d/image.h"
#include "tool_2d/x11/x11_diagnosis_p.h"
#include "tool_2d/x11/x11_image_p.h"
#include "tool_2d/x11/x11_shm_segment_p.h"
#include "tool_2d/x11/x11_window_p.h"
#include "tool_2d/x11_window/x11_events_p.h"
#include "tool_2d/x11_window/x11_fullscreen_p.h"
#include "tool_2d/x11_window/x11_resolution_p.h"
#include "tool_2d/x11_window/x11_scroll_p.h"
#include "tool_2d/x11_window/x11_sync_p.h"
#include "tool_2d/x11_window/x11_wm_facts_p.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <optional>
#include <utility>
#include <vector>

namespace {

using namespace l3d_detail;
using namespace std::chrono_literals;
using std::chrono::steady_clock;

// The longest wait for a window manager to show the window. After that, drawing begins anyway.
constexpr auto longest_map = 2s;
// The longest wait for a slow connection before input gets its turn.
constexpr auto longest_put = 100ms;
// The longest time between two looks while the server owes an answer.
constexpr auto longest_without_look = 1s;
// Pictures per second. More of them over a network would fill the line, and input would wait behind
// them.
constexpr double local_fps = 60, network_fps = 15;
// Keeps a deadline inside the clock's range.
constexpr std::chrono::nanoseconds longest_wait = 24h;

/// The colour for the part of the window right of the picture: the mean of the picture's last
/// column. Backgrounds may differ from row to row, but a window has one colour.
std::uint32_t margin_word(const l3d_pixels& picture) {
    std::uint64_t sums[3]{};
    for (int y = 0; y < picture.height; ++y)
        for (int i = 0; i < 3; ++i)
            sums[i] += picture.row(y).back() >> 8 * i & 255;
    std::uint32_t word = 0;
    for (int i = 0; i < 3; ++i)
        word |= static_cast<std::uint32_t>(sums[i] / static_cast<std::uint64_t>(picture.height))
                << 8 * i;
    return word;
}

/// A screen with the window, the image and the events of one display.
///
/// If no buffer is free for a picture, show waits a little. Then the next call that asks for events
/// shows the picture.
class l3d_screen_x11 final : public l3d_screen {
public:
    /// If `no_shm` is empty, memory is shared; else it is the reason why not. If `sparing` is set,
    /// pictures that go over the connection are sent by x11_image_sparing.
    /// Errors:  std::bad_alloc.
    l3d_screen_x11(std::unique_ptr<x11_window> window, l3d_size size, std::string no_shm,
                   bool sparing)
        : window_(std::move(window)),
          pointer_(*window_, {size.width * window_->scale(), size.height * window_->scale()}),
          events_(*window_, size, pointer_), state_(*window_), scroll_(*window_), sync_(*window_),
          fullscreen_(*window_, state_,
                      {size.width * window_->scale(), size.height * window_->scale()}),
          no_shm_(std::move(no_shm)), is_sparing_(sparing), image_(make_image(size)),
          picture_(make_picture(size)) {}

    /// Puts the window on the screen and waits until the server wants it drawn.
    void open();

private:
    l3d_pixels do_pixels() override { return picture_.pixels(); }
    const l3d_screen_info& do_info() const override { return window_->info(); }
    void do_show(const l3d_pixel_box& part) override;
    bool do_is_busy() const override { return !due_.empty(); }
    bool do_is_to_close() override {
        return window_->connection().lost() || events_.has_close() || window_->connection().lost();
    }
    bool do_is_window() const override { return true; }
    double do_usual_fps() const override;
    double do_text_scale() const override { return window_->text_scale(); }
    bool do_is_slow() const override { return is_sparing_ && !no_shm_.empty(); }
    void do_set_text(std::vector<l3d_pixel_box> boxes) override {
        text_ = std::move(boxes);
        image_->set_text(text_);
    }
    void do_set_pointer(l3d_pointer how) override { pointer_.set(how); }
    void do_set_fullscreen(bool on) override { fullscreen_.set(on); }
    bool do_is_fullscreen() const override { return fullscreen_.is_on(); }
    std::string do_describe() const override;
    std::string do_take_remark() override { return std::exchange(remark_, {}); }
    bool do_next_event(l3d_event& event) override;
    void do_wait(std::chrono::nanoseconds longest, int waker) override;

    void read_events(steady_clock::time_point put_deadline = {});
    void take_events(steady_clock::time_point put_deadline);
    void take(XEvent& event);
    void put_if_due(steady_clock::time_point deadline);
    void tell_shown();
    void look_around();
    bool sleep(steady_clock::time_point deadline, int waker = -1) const;
    /// Whether the program can have an event. An event about fullscreen waits if earlier news about
    /// fullscreen may still be on the way from the server.
    bool has_event() const {
        const bool knows = !state_.is_asking() || window_->connection().lost();
        return !events_.empty() && (knows || !events_.is_about_fullscreen());
    }
    bool resized_to(l3d_size size);
    std::unique_ptr<x11_image> make_image(l3d_size size);
    std::unique_ptr<x11_image> make_wired_image(l3d_size size) const;
    l3d_image make_picture(l3d_size size) const;
    void stop_sharing(const std::string& why);
    bool replaced_failed_image();

    std::unique_ptr<x11_window> window_;
    x11_pointer pointer_;
    x11_events events_; // after the pointer, which it uses
    x11_wm_facts state_;
    x11_scroll scroll_;
    x11_sync sync_;
    x11_fullscreen fullscreen_;
    std::string no_shm_; ///< why memory is not shared; empty if it is
    bool is_sparing_;
    std::string remark_;
    std::vector<l3d_pixel_box> text_; ///< boxes of text in the picture; declared before its readers
    std::unique_ptr<x11_image> image_;
    l3d_image picture_;
    l3d_pixel_box due_; ///< the part that waits for a buffer
    /// The window's contents are unknown, so the whole picture is to be put.
    bool is_forgotten_ = true;
    bool ground_is_due_ =
        false;                 ///< a whole picture was put, to which the window's ground has to fit
    bool sync_is_due_ = false; ///< a picture was put, and perhaps waits to be sent
    bool window_is_gone_ = false; ///< another program destroyed the window
    bool lost_is_told_ = false;
    bool letters_changed_ = false; ///< letters have a new size, so the program shall draw anew
};

void l3d_screen_x11::open() {
    window_->map();
    const auto deadline = steady_clock::now() + longest_map;
    do {
        read_events();
    } while (!events_.was_exposed() && window_->connection().wait_readable(deadline));
    if (events_.is_mapped() && !window_->was_managed())
        window_->take_focus();
}

/// Makes an image in shared memory, as long as sharing works. Once sharing fails, all images go
/// over the connection.
std::unique_ptr<x11_image> l3d_screen_x11::make_image(l3d_size size) {
    if (no_shm_.empty()) {
        std::string why;
        if (auto image = make_x11_image_shm(*window_, size, why))
            return image;
        stop_sharing(why);
    }
    return make_wired_image(size);
}

std::unique_ptr<x11_image> l3d_screen_x11::make_wired_image(l3d_size size) const {
    auto image =
        is_sparing_ ? make_x11_image_sparing(*window_, size) : make_x11_image_put(*window_, size);
    image->set_text(text_);
    return image;
}

/// Makes the memory of a picture. Shared memory gets copies, so any stride will do. Over the
/// connection, a picture needs no copy if its rows lie as Xlib wants them.
l3d_image l3d_screen_x11::make_picture(l3d_size size) const {
    return {size, no_shm_.empty() ? l3d_padded_stride(size.width) : size.width};
}

void l3d_screen_x11::stop_sharing(const std::string& why) {
    no_shm_ = why;
    if (!window_->connection().lost())
        remark_ = "xshm: pictures now go over the wire: " + why;
}

/// Replaces a failed image by one that goes over the connection. The last picture is put again, as
/// it may not have been seen.
bool l3d_screen_x11::replaced_failed_image() {
    std::string why;
    if (window_is_gone_ || window_->connection().lost() || !image_->has_failed(why))
        return false;
    try {
        auto image = make_wired_image(picture_.pixels().size());
        image_ = std::move(image);
    } catch (const std::bad_alloc&) {
        return false;
    }
    stop_sharing(why);
    due_ = l3d_whole(picture_.pixels().size());
    is_forgotten_ = true;
    return true;
}

void l3d_screen_x11::do_show(const l3d_pixel_box& part) {
    due_ = due_.united(part);
    const auto deadline = steady_clock::now() + longest_put;
    do {
        read_events(deadline);
    } while (!due_.empty() && sleep(deadline));
}

void l3d_screen_x11::put_if_due(steady_clock::time_point deadline) {
    if (due_.empty() || !image_->is_free())
        return;
    const l3d_pixel_box part = std::exchange(due_, {});
    if (window_->connection().lost() || window_is_gone_)
        return;
    const l3d_pixels picture = picture_.pixels();
    image_->put(picture, is_forgotten_ ? l3d_whole(picture.size()) : part, deadline);
    ground_is_due_ |= std::exchange(is_forgotten_, false);
    sync_is_due_ = true;
}

/// Reads everything that the server has sent. The last call is XPending, since Xlib may read events
/// also while it writes. A sleeper would not wake up for events that were read already.
void l3d_screen_x11::read_events(steady_clock::time_point put_deadline) {
    do {
        image_->look_after();
        fullscreen_.rest(steady_clock::now());
        put_if_due(put_deadline);
        tell_shown();
        look_around();
        take_events(put_deadline);
    } while (replaced_failed_image());
    if (window_->connection().lost() && !std::exchange(lost_is_told_, true))
        events_.take_display_lost();
}

/// Asks the server for further facts. Most of these questions are asked after the first picture, so
/// that the picture comes sooner.
void l3d_screen_x11::look_around() {
    if (image_->is_sending())
        return;
    events_.look_after();
    pointer_.look_after();
    if (is_forgotten_)
        return;
    if (std::exchange(ground_is_due_, false))
        window_->set_ground(margin_word(picture_.pixels()));
    state_.look_after();
    scroll_.look_after();
    events_.want_keyboard();
}

void l3d_screen_x11::tell_shown() {
    if (!sync_is_due_ || image_->is_sending() || window_->connection().lost())
        return;
    sync_is_due_ = false;
    sync_.shown(picture_.pixels().size());
}

void l3d_screen_x11::take_events(steady_clock::time_point put_deadline) {
    while (!window_->connection().lost() && XPending(window_->display()) > 0) {
        XEvent event;
        XNextEvent(window_->display(), &event);
        if (image_->take(event))
            put_if_due(put_deadline);
        else
            take(event);
    }
}

void l3d_screen_x11::take(XEvent& event) {
    if (pointer_.take(event))
        return;
    if (state_.take(event)) {
        events_.set_away(state_.facts().away);
        fullscreen_.follow();
        letters_changed_ = window_->set_fineness(state_.facts().fineness) || letters_changed_;
    }
    if (letters_changed_)
        events_.tell_size();
    if (const auto turn = scroll_.take(event)) {
        event.xmotion = turn->motion;
        if (turn->notches != 0)
            events_.take_turn(turn->motion, turn->notches);
    }
    if (state_.is_foreign(event) || window_->connection().lost())
        return;
    if (event.type == Expose) {
        image_->forget_shown();
        is_forgotten_ = true;
    }
    if (event.type == DestroyNotify)
        window_is_gone_ = true;
    sync_.take(event);
    fullscreen_.take(event);
    events_.take(event);
    if (!image_->is_sending())
        events_.look_after(); // at once, as nothing else may wake a resting program
}

/// Sleeps until there is something to do. Returns false at the deadline, at a signal, or if the
/// waker can be read.
bool l3d_screen_x11::sleep(steady_clock::time_point deadline, int waker) const {
    const auto& connection = window_->connection();
    if (image_->is_sending())
        return connection.wait_ready(deadline, waker);
    const auto look = steady_clock::now() + longest_without_look;
    if (image_->is_idle() || deadline <= look)
        return connection.wait_readable(deadline, waker);
    return connection.wait_readable(look, waker) || steady_clock::now() >= look;
}

bool l3d_screen_x11::do_next_event(l3d_event& event) {
    read_events();
    while (has_event() && events_.next(event)) {
        if (event.type != l3d_event_type::resize || resized_to(event.size) ||
            std::exchange(letters_changed_, false))
            return true;
    }
    return false;
}

/// Makes new pixels, when the program learns of a new size. Until then the program may draw into
/// the old pixels.
bool l3d_screen_x11::resized_to(l3d_size size) {
    if (size == picture_.pixels().size()) {
        sync_.shown(size);
        return false;
    }
    try {
        auto image = make_image(size);
        picture_ = make_picture(size);
        image_ = std::move(image);
    } catch (const std::bad_alloc&) {
        return false; // The old picture goes on, in a part of the window.
    }
    due_ = {};
    is_forgotten_ = true;
    sync_is_due_ = false;
    return true;
}

void l3d_screen_x11::do_wait(std::chrono::nanoseconds longest, int waker) {
    const auto deadline = steady_clock::now() + std::min(longest, longest_wait);
    bool has_slept_well = true;
    while (read_events(), !has_event() && has_slept_well) {
        const auto look = image_->is_idle() ? image_->next_look() : steady_clock::time_point::max();
        const auto next = std::min({deadline, fullscreen_.next_rest(), look});
        has_slept_well = sleep(next, waker) || (next < deadline && steady_clock::now() >= next);
    }
}

double l3d_screen_x11::do_usual_fps() const {
    return do_is_slow() ? network_fps : local_fps;
}

std::string l3d_screen_x11::do_describe() const {
    return "X11 window: " + info().describe() + ", " + image_->describe() +
           ", shared memory: " + (no_shm_.empty() ? "yes" : "no, " + no_shm_);
}

/// Chooses the window's visual.
/// Errors:  nothing, and the reason in `refusal`.
std::optional<x11_visual> choose_visual(const x11_connection* connection, l3d_service& refusal) {
    if (connection == nullptr) {
        refusal.how = l3d_service::level::no_display;
        return {};
    }
    std::optional<x11_visual> visual;
    if (!connection->lost())
        visual = choose_x11_visual(*connection, refusal.why);
    if (connection->lost()) {
        refusal = {l3d_service::level::display_lost, x11_server_went_away};
        return {};
    }
    if (!visual)
        refusal.how = l3d_service::level::not_here;
    return visual;
}

/// Whether pictures that go over the connection are sent by x11_image_sparing.
bool is_sparing(const x11_connection& connection, l3d_remote wish) {
    return wish == l3d_remote::on || (wish == l3d_remote::automatic && !connection.is_local());
}

/// Puts a window on the screen, and waits until the server wants it drawn.
/// Shape:   if `no_shm` is empty, memory is shared; else it is the reason why not.
/// Cost:    returns after two seconds at the latest.
std::unique_ptr<l3d_screen> open_screen(std::unique_ptr<x11_connection> connection,
                                        const l3d_screen_request& request, std::string no_shm,
                                        l3d_service& refusal) {
    const auto visual = choose_visual(connection.get(), refusal);
    if (!visual)
        return nullptr;
    auto window = x11_window::open(std::move(connection), *visual, request, refusal);
    if (!window)
        return nullptr;
    try {
        const l3d_size size = x11_picture_size(window->connection(), request);
        const bool sparing = is_sparing(window->connection(), request.remote);
        auto screen =
            std::make_unique<l3d_screen_x11>(std::move(window), size, std::move(no_shm), sparing);
        screen->open();
        return screen;
    } catch (const std::bad_alloc&) {
        refusal = {l3d_service::level::not_here, "not enough memory for a picture of " +
                                                     std::to_string(request.size.width) + "x" +
                                                     std::to_string(request.size.height)};
        return nullptr;
    }
}

} // namespace

l3d_screen_factory_x11::l3d_screen_factory_x11(bool shares_memory)
    : shares_memory_(shares_memory) {}
l3d_screen_factory_x11::~l3d_screen_factory_x11() = default;

void l3d_screen_factory_x11::do_release() const {
    kept_.reset();
}

l3d_service l3d_screen_factory_x11::do_service() const {
    l3d_service service;
    auto connection = x11_connection::open(service.why);
    const auto visual = choose_visual(connection.get(), service);
    if (!visual)
        return service;
    std::string why;
    if (shares_memory_ &&
        !x11_shm_segment::make(*connection, visual->visual, visual->layout, 1, why))
        service = {l3d_service::level::partly, "pictures go over the wire: " + why};
    if (connection->lost())
        return {l3d_service::level::display_lost, why};
    kept_ = std::move(connection);
    return service;
}

std::unique_ptr<l3d_screen> l3d_screen_factory_x11::do_create(const l3d_screen_request& request,
                                                              l3d_service& refusal) const {
    auto connection = std::exchange(kept_, nullptr);
    const char* const name = std::getenv("DISPLAY");
    if (!connection || name == nullptr || connection->name() != name)
        connection = x11_connection::open(refusal.why);
    const char* const no_shm = !shares_memory_                    ? "not asked for"
                               : request.remote == l3d_remote::on ? "--remote on"
                                                                  : "";
    return open_screen(std::move(connection), request, no_shm, refusal);
}

void l3d_screen_factory_x11::do_diagnose(l3d_probes& probes) const {
    diagnose_x11(probes, shares_memory_);
}
