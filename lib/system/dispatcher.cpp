// SPDX-License-Identifier: MIT
// l3d_dispatcher: does the work that all kinds of dispatchers share.
#include "system/dispatcher.h"

#include "base/error.h"
#include "pipeline/captioned_p.h"

#include <string>

void l3d_dispatcher::plug(l3d_pipeline& pipeline, l3d_screen& screen) {
    pipeline_ = &pipeline;
    screen_ = &screen;
}

l3d_exit l3d_dispatcher::start() {
    if (pipeline_ == nullptr)
        throw l3d_error(l3d_exit::failure, "dispatcher: no pipeline is plugged in");
    if (!caption_.what.empty() && screen_->is_window())
        return start_with_caption();
    return do_start(*pipeline_, *screen_);
}

l3d_exit l3d_dispatcher::start_with_caption() {
    std::string why; // ignored, as the canvas's maker has told the reason
    const l3d_font font = l3d_font::of_system(why);
    const double hint_seconds = caption_.teaches.empty() ? 8 : 15; // two lines are read in 4 s
    l3d_detail::captioned shown(*pipeline_, *screen_, caption_, font, hint_seconds);
    const l3d_exit result = do_start(shown, *screen_);
    pipeline_->done |= shown.done;
    return result;
}

namespace {

/// Whether the pipeline gets a press of a key as a key_event. A key with Alt or Super held, or a
/// letter with Ctrl held, counts as another key, which has no key_event. For digits and keys that
/// are no character, any_event tells whether Ctrl is held. The keys Shift, Ctrl and Alt themselves
/// have no key_event, and neither have presses that only type text.
bool is_plain(const l3d_event& press) {
    if (press.key == 0 || press.key == l3d_key_shift || press.key == l3d_key_control ||
        press.key == l3d_key_alt)
        return false;
    const bool is_letter =
        (press.key >= 'a' && press.key <= 'z') || (press.key >= 'A' && press.key <= 'Z');
    return !press.alt && !press.logo && !(press.control && is_letter);
}

} // namespace

void l3d_dispatcher::deliver(const l3d_event& event, l3d_pipeline& pipeline) {
    pipeline.any_event(event);
    switch (event.type) {
    case l3d_event_type::key_press:
        if (is_plain(event))
            pipeline.key_event(event.key);
        break;
    case l3d_event_type::button_press:
    case l3d_event_type::button_release:
    case l3d_event_type::pointer_motion:
    case l3d_event_type::wheel:
        pipeline.pointer_event(event);
        break;
    case l3d_event_type::resize:
        pipeline.resize_event(event.size);
        break;
    case l3d_event_type::close:
        pipeline.done = true;
        break;
    case l3d_event_type::key_release:
    case l3d_event_type::expose:
    case l3d_event_type::hide:
    case l3d_event_type::reveal:
    case l3d_event_type::fullscreen:
    case l3d_event_type::display_lost:
        break;
    }
}
