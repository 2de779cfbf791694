// SPDX-License-Identifier: MIT
// l3d_dispatcher_fitting: a loop for windows, frames without waiting for the rest.
#include "system/dispatcher.h"
#include "system/fakes.h"

#include <gtest/gtest.h>

namespace {

struct fitting_run {
    explicit fitting_run(const l3d_frame_settings& settings)
        : dispatcher(l3d_dispatcher_factory_fitting().create(settings)) {
        dispatcher->plug(pipeline, screen);
    }

    call_log log;
    std::unique_ptr<l3d_dispatcher> dispatcher;
    fake_screen screen{log};
    fake_pipeline pipeline{log, screen};
};

TEST(dispatcher_fitting, a_window_has_its_events_handled) {
    fitting_run run({});
    run.screen.pending.push_back(make_key('q'));
    EXPECT_EQ(run.dispatcher->start(), l3d_exit::success);
    EXPECT_EQ(run.log, (call_log{"key q"}));
}

TEST(dispatcher_fitting, without_a_window_one_frame_is_made) {
    fitting_run run({});
    run.screen.window = false;
    run.screen.pending.push_back(make_key('q'));
    EXPECT_EQ(run.dispatcher->start(), l3d_exit::success);
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame"}));
}

TEST(dispatcher_fitting, tells_what_the_one_tells_that_it_became) {
    fitting_run run({});
    run.screen.pending.push_back(make_event(l3d_event_type::display_lost));
    EXPECT_EQ(run.dispatcher->start(), l3d_exit::display_lost);
}

TEST(dispatcher_fitting, complains_of_an_output_before_there_is_a_screen) {
    l3d_frame_settings settings;
    settings.output = "picture.gif";
    EXPECT_THROW(l3d_dispatcher_factory_fitting().create(settings), l3d_error);
}

} // namespace
