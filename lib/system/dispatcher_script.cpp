// SPDX-License-Identifier: MIT
// l3d_dispatcher_script: loops over frames, with events from a script.
#include "system/dispatcher.h"

#include "system/present_p.h"
#include "system/progress_p.h"
#include "system/remark_p.h"
#include "system/signal_watch.h"

#include <algorithm>
#include <cassert>
#include <iostream>
#include <unistd.h>
#include <utility>

l3d_dispatcher_script::l3d_dispatcher_script(const l3d_frame_settings& settings,
                                             std::vector<l3d_script_event> script)
    : settings_(settings), script_(std::move(script)), writer_(settings.output, settings.alpha) {
    assert(std::is_sorted(script_.begin(), script_.end(),
                          [](const auto& a, const auto& b) { return a.frame < b.frame; }));
}

l3d_exit l3d_dispatcher_script::do_start(l3d_pipeline& pipeline, l3d_screen& screen) {
    const int frames = std::max(settings_.frames, 1);
    auto next = script_.begin();
    bool stale = true;
    l3d_exit result = l3d_exit::success;
    l3d_detail::progress progress(std::cerr, isatty(STDERR_FILENO) != 0, settings_.program, frames,
                                  l3d_detail::progress::clock::now());
    // If a signal comes, the present frame and its file are finished first, so that no part of a
    // file is left behind.
    const l3d_signal_watch signals;
    for (int frame = 0; frame < frames && !signals.caught(); ++frame) {
        progress.done(frame, l3d_detail::progress::clock::now());
        for (; next != script_.end() && next->frame <= frame; ++next) {
            deliver(next->event, pipeline);
            stale |= next->event.type == l3d_event_type::resize;
            if (next->event.type == l3d_event_type::display_lost)
                result = l3d_exit::display_lost;
        }
        if (pipeline.done || result != l3d_exit::success)
            break;
        pipeline.update_event(settings_.step());
        if (l3d_detail::only_passes(frame, settings_, writer_, screen.pixels().size())) {
            stale = l3d_detail::skip(pipeline, writer_, stale);
            continue;
        }
        l3d_detail::present(pipeline, screen, writer_, stale);
        l3d_detail::pass_on_remarks(pipeline, screen, settings_.program);
        stale = false;
    }
    if (signals.caught())
        return result;
    if (stale && !settings_.output.empty())
        pipeline.draw_event();
    writer_.finish(screen.pixels());
    return result;
}

std::unique_ptr<l3d_dispatcher>
l3d_dispatcher_factory_script::do_create(const l3d_frame_settings& settings) const {
    return std::make_unique<l3d_dispatcher_script>(settings);
}
