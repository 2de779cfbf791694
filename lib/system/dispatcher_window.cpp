// SPDX-License-Identifier: MIT
// l3d_dispatcher_window: runs the event loop.
#include "system/dispatcher_window.h"

#include "raster/parallel/workers.h"
#include "system/frame_pacer.h"
#include "system/present_p.h"
#include "system/remark_p.h"

#include <algorithm>
#include <chrono>

namespace {

using std::chrono::steady_clock;

/// The longest sleep while nothing moves. Signals and events end a sleep earlier.
constexpr std::chrono::hours longest_rest{24};

double seconds_between(steady_clock::time_point from, steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

} // namespace

/// One run of the event loop, with its state from turn to turn.
class l3d_dispatcher_window::loop {
public:
    loop(l3d_dispatcher_window& dispatcher, l3d_pipeline& pipeline, l3d_screen& screen)
        : settings_(dispatcher.settings_), writer_(dispatcher.writer_),
          signals_(*dispatcher.signals_), pipeline_(pipeline), screen_(screen),
          last_update_(steady_clock::now()),
          pacer_(settings_.fps.value_or(screen.usual_fps()), last_update_) {
        // If files are written, the present frame belongs to one of them, so it is finished even
        // after a signal.
        if (settings_.output.empty())
            pipeline_.interrupt_when([this] { return signals_.caught() || screen_.is_to_close(); });
    }
    loop(const loop&) = delete;
    loop& operator=(const loop&) = delete;
    ~loop() { pipeline_.interrupt_when({}); }

    l3d_exit run();

private:
    bool frames_are_made() const { return settings_.frames > 0 && frames_ >= settings_.frames; }

    /// Whether nobody would see the next picture, so that it need not be drawn.
    bool is_unseen() const {
        return (hidden_ || screen_.is_busy()) && settings_.frames == 0 && settings_.output.empty();
    }

    bool rests() const;
    void sleep(steady_clock::time_point now);
    void rest(steady_clock::time_point now);
    void handle_events();
    void handle(const l3d_event& event);
    void show_again();
    void make_frames();
    void make_frame(steady_clock::time_point now);

    const l3d_frame_settings& settings_;
    l3d_frame_writer& writer_;
    const l3d_signal_watch& signals_;
    l3d_pipeline& pipeline_;
    l3d_screen& screen_;

    steady_clock::time_point last_update_;
    l3d_frame_pacer pacer_;
    int frames_ = 0;
    bool stale_ = true; ///< whether the pixels hold no picture of the present size yet
    bool exposed_ = false;
    bool hidden_ = false;
    bool display_lost_ = false;
};

void l3d_dispatcher_window::loop::handle(const l3d_event& event) {
    switch (event.type) {
    case l3d_event_type::resize:
        stale_ = true;
        break;
    case l3d_event_type::expose:
        exposed_ = true;
        hidden_ = false;
        break;
    case l3d_event_type::hide:
        hidden_ = true;
        break;
    case l3d_event_type::reveal:
        hidden_ = false;
        break;
    case l3d_event_type::fullscreen:
        screen_.set_fullscreen(!screen_.is_fullscreen());
        break;
    case l3d_event_type::display_lost:
        display_lost_ = true;
        break;
    default:
        break;
    }
    deliver(event, pipeline_);
}

void l3d_dispatcher_window::loop::handle_events() {
    for (l3d_event event; screen_.next_event(event);) {
        const bool is_escape =
            event.type == l3d_event_type::key_press && event.key == l3d_key_escape;
        if (is_escape && screen_.is_fullscreen())
            screen_.set_fullscreen(false);
        else
            handle(event);
    }
}

/// Whether no picture need be made until the next event. If frames are counted or written, each
/// turn of the loop makes a picture.
bool l3d_dispatcher_window::loop::rests() const {
    if (settings_.frames != 0 || !settings_.output.empty() || settings_.fixed_step)
        return false;
    return hidden_ || (!stale_ && !exposed_ && pipeline_.is_at_rest() && !pipeline_.needs_redraw());
}

/// Sleeps until the next picture is due, or until an event. If no picture is due, update_event does
/// not get the time of the sleep. For a hidden window, the time of the sleep does not count.
/// Otherwise rest() tells the pipeline how long the sleep was.
void l3d_dispatcher_window::loop::sleep(steady_clock::time_point now) {
    if (!rests())
        return screen_.wait(pacer_.due() - now, signals_.waker());
    if (hidden_)
        screen_.wait(longest_rest, signals_.waker());
    else
        rest(now);
    last_update_ = steady_clock::now();
}

/// Sleeps until an event, or until the pipeline's rest_left() is over, and tells the pipeline how
/// long the sleep was.
void l3d_dispatcher_window::loop::rest(steady_clock::time_point now) {
    // The time is rounded up, since a sleep that ends a little early would be followed by one of
    // length 0.
    const auto left = std::chrono::ceil<std::chrono::nanoseconds>(std::chrono::duration<double>(
        std::min(pipeline_.rest_left(), std::chrono::duration<double>(longest_rest).count())));
    screen_.wait(left, signals_.waker());
    pipeline_.rest_event(seconds_between(now, steady_clock::now()));
}

void l3d_dispatcher_window::loop::show_again() {
    if (!exposed_ || hidden_ || stale_)
        return;
    screen_.show();
    exposed_ = false;
}

void l3d_dispatcher_window::loop::make_frame(steady_clock::time_point now) {
    pipeline_.update_event(settings_.fixed_step ? settings_.step()
                                                : seconds_between(last_update_, now));
    last_update_ = now;
    if (l3d_detail::only_passes(frames_, settings_, writer_, screen_.pixels().size())) {
        stale_ = l3d_detail::skip(pipeline_, writer_, stale_);
        ++frames_;
        return;
    }
    const bool drawn = !is_unseen() && l3d_detail::present(pipeline_, screen_, writer_, stale_);
    if (drawn)
        stale_ = exposed_ = false;
    ++frames_;
    pacer_.frame_done(steady_clock::now(), !drawn);
}

l3d_exit l3d_dispatcher_window::loop::run() {
    try {
        make_frames();
    } catch (const l3d_interrupted&) {
        handle_events(); // one of the events tells the reason
    }
    l3d_detail::pass_on_remarks(pipeline_, screen_, settings_.program);
    if (stale_ && !settings_.output.empty())
        pipeline_.draw_event();
    writer_.finish(screen_.pixels());
    return display_lost_ ? l3d_exit::display_lost : l3d_exit::success;
}

void l3d_dispatcher_window::loop::make_frames() {
    while (!signals_.caught() && !frames_are_made()) {
        handle_events();
        l3d_detail::pass_on_remarks(pipeline_, screen_, settings_.program);
        if (pipeline_.done || display_lost_)
            break;
        show_again();
        const auto now = steady_clock::now();
        if (now < pacer_.due() || rests())
            sleep(now);
        else
            make_frame(now);
    }
}

l3d_dispatcher_window::l3d_dispatcher_window(const l3d_frame_settings& settings)
    : settings_(settings), writer_(settings.output, settings.alpha) {}

l3d_exit l3d_dispatcher_window::do_start(l3d_pipeline& pipeline, l3d_screen& screen) {
    signals_.emplace();
    return loop(*this, pipeline, screen).run();
}

std::unique_ptr<l3d_dispatcher>
l3d_dispatcher_factory_window::do_create(const l3d_frame_settings& settings) const {
    return std::make_unique<l3d_dispatcher_window>(settings);
}
