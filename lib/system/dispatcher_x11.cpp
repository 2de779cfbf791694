// SPDX-License-Identifier: MIT
// l3d_dispatcher_x11: the event loop.
#include "system/dispatcher_x11.h"

#include "system/frame_pacer.h"
#include "system/present_p.h"

#include <algorithm>
#include <chrono>

namespace {

using std::chrono::steady_clock;

/// A signal that arrives just before the sleep does not end it, so that no sleep is longer; half
/// of the 0.2 s within which a signal ends the loop.
constexpr std::chrono::milliseconds longest_sleep{100};

/// What the events since the last frame ask for.
struct requests {
    bool stale = true; ///< the pixels are not a drawn picture: none was made, or none of this size
    bool exposed = false;
    bool display_lost = false;
};

void note(const l3d_event& event, requests& wanted) {
    wanted.stale |= event.type == l3d_event_type::resize;
    wanted.exposed |= event.type == l3d_event_type::expose;
    wanted.display_lost |= event.type == l3d_event_type::display_lost;
}

double seconds_between(steady_clock::time_point from, steady_clock::time_point to) {
    return std::chrono::duration<double>(to - from).count();
}

} // namespace

l3d_dispatcher_x11::l3d_dispatcher_x11(const l3d_frame_settings& settings)
    : settings_(settings), writer_(settings.output) {}

l3d_exit l3d_dispatcher_x11::do_start(l3d_pipeline& pipeline, l3d_screen& screen) {
    signals_.emplace();
    auto last_update = steady_clock::now();
    l3d_frame_pacer pacer(settings_.fps, last_update);
    requests wanted;
    int frames = 0;

    while (!signals_->caught() && (settings_.frames == 0 || frames < settings_.frames)) {
        for (l3d_event event; screen.next_event(event);) {
            note(event, wanted);
            deliver(event, pipeline);
        }
        if (pipeline.done || wanted.display_lost)
            break;
        if (wanted.exposed && !wanted.stale) {
            screen.show();
            wanted.exposed = false;
        }
        const auto now = steady_clock::now();
        if (now < pacer.due()) {
            screen.wait(std::min<std::chrono::nanoseconds>(pacer.due() - now, longest_sleep));
            continue;
        }
        pipeline.update_event(settings_.fixed_step ? settings_.step()
                                                   : seconds_between(last_update, now));
        last_update = now;
        const bool drawn = l3d_detail::present(pipeline, screen, writer_, wanted.stale);
        if (drawn)
            wanted.stale = wanted.exposed = false;
        ++frames;
        pacer.frame_done(steady_clock::now(), !drawn);
    }
    if (wanted.stale && !settings_.output.empty())
        pipeline.draw_event();
    writer_.finish(screen.pixels());
    return wanted.display_lost ? l3d_exit::display_lost : l3d_exit::well;
}

std::unique_ptr<l3d_dispatcher>
l3d_dispatcher_factory_x11::do_create(const l3d_frame_settings& settings) const {
    return std::make_unique<l3d_dispatcher_x11>(settings);
}
