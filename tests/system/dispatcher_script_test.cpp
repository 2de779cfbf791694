// SPDX-License-Identifier: MIT
// l3d_dispatcher_script: order of calls, frames, steps of time, files.
#include "system/dispatcher.h"
#include "system/fakes.h"
#include "system/temporary_folder.h"

#include "tool_2d/image.h"

#include <gtest/gtest.h>

namespace {

struct script_run {
    explicit script_run(const l3d_frame_settings& settings,
                        std::vector<l3d_script_event> script = {})
        : dispatcher(settings, std::move(script)) {
        dispatcher.plug(pipeline, screen);
    }

    call_log log;
    l3d_dispatcher_script dispatcher;
    fake_screen screen{log};
    fake_pipeline pipeline{log, screen};
};

l3d_frame_settings frames(int count) {
    l3d_frame_settings settings;
    settings.frames = count;
    return settings;
}

TEST(dispatcher_script, one_frame_if_none_are_named) {
    script_run run(frames(0));
    EXPECT_EQ(run.dispatcher.start(), l3d_exit::success);
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame"}));
    EXPECT_EQ(run.screen.waits, 0);
}

TEST(dispatcher_script, says_that_nothing_is_plugged_in) {
    l3d_dispatcher_script dispatcher(frames(1));
    EXPECT_THROW(dispatcher.start(), l3d_error);
}

TEST(dispatcher_script, events_come_before_their_frame) {
    l3d_event pointer = make_event(l3d_event_type::pointer_motion);
    pointer.x = 7;
    pointer.y = 9;
    l3d_event resize = make_event(l3d_event_type::resize);
    resize.size = {31, 17};
    script_run run(frames(3), {{0, make_key('a')}, {2, pointer}, {2, resize}, {2, make_key('b')}});
    EXPECT_EQ(run.dispatcher.start(), l3d_exit::success);
    EXPECT_EQ(run.log, (call_log{"key a", "update", "draw", "show", "frame", "update", "draw",
                                 "show", "frame", "pointer 7,9", "resize 31x17", "key b", "update",
                                 "draw", "show", "frame"}));
}

TEST(dispatcher_script, every_event_is_told_and_first) {
    class listener final : public l3d_pipeline {
    public:
        call_log log;
        void any_event(const l3d_event& event) override {
            log.push_back("any " + std::to_string(static_cast<int>(event.type)));
        }
        void key_event(int) override { log.push_back("key"); }
    } pipeline;
    call_log ignored;
    fake_screen screen(ignored);
    l3d_dispatcher_script dispatcher({}, {{0, make_event(l3d_event_type::expose)},
                                          {0, make_key('x')},
                                          {0, make_event(l3d_event_type::hide)}});
    dispatcher.plug(pipeline, screen);
    dispatcher.start();
    const auto any = [](l3d_event_type type) {
        return "any " + std::to_string(static_cast<int>(type));
    };
    EXPECT_EQ(pipeline.log, (call_log{any(l3d_event_type::expose), any(l3d_event_type::key_press),
                                      "key", any(l3d_event_type::hide)}));
}

TEST(dispatcher_script, steps_are_fixed) {
    using rate = std::optional<double>;
    for (const auto& [fps, step] : {std::pair{rate(60), 1 / 60.0},
                                    {rate(25), 0.04},
                                    {rate(0), 1 / 60.0},
                                    {rate(), 1 / 60.0}}) {
        l3d_frame_settings settings = frames(4);
        settings.fps = fps;
        script_run run(settings);
        run.screen.fps = 15; // has no say
        run.dispatcher.start();
        EXPECT_EQ(run.pipeline.steps, std::vector<double>(4, step));
    }
}

TEST(dispatcher_script, draws_only_what_is_needed) {
    l3d_event resize = make_event(l3d_event_type::resize);
    script_run run(frames(5), {{3, resize}});
    run.pipeline.lazy = true;
    run.dispatcher.start();
    EXPECT_EQ(count_of(run.log, "update"), 5);
    EXPECT_EQ(count_of(run.log, "draw"), 2); // the first, and the one of the new size
    EXPECT_EQ(count_of(run.log, "show"), 2);
    EXPECT_EQ(count_of(run.log, "frame"), 2);
}

TEST(dispatcher_script, done_ends_it_before_the_frame) {
    script_run by_key(frames(100), {{2, make_key('q')}});
    EXPECT_EQ(by_key.dispatcher.start(), l3d_exit::success);
    EXPECT_EQ(count_of(by_key.log, "update"), 2);

    script_run by_close(frames(100), {{1, make_event(l3d_event_type::close)}});
    EXPECT_EQ(by_close.dispatcher.start(), l3d_exit::success);
    EXPECT_EQ(count_of(by_close.log, "draw"), 1);

    script_run by_loss(frames(100), {{4, make_event(l3d_event_type::display_lost)}});
    EXPECT_EQ(by_loss.dispatcher.start(), l3d_exit::display_lost);
    EXPECT_EQ(count_of(by_loss.log, "draw"), 4);
}

TEST(dispatcher_script, passes_on_what_screen_and_pipeline_have_to_say) {
    l3d_frame_settings settings = frames(1);
    settings.program = "tester";
    script_run run(settings);
    run.screen.remark = "another way";
    run.pipeline.remark = "fewer threads";
    testing::internal::CaptureStderr();
    run.dispatcher.start();
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "tester: fewer threads\ntester: another way\n");
}

TEST(dispatcher_script, done_in_update_ends_it_after_the_frame) {
    script_run run(frames(100));
    run.pipeline.on_update = [&](int update) { run.pipeline.done = update == 3; };
    run.dispatcher.start();
    EXPECT_EQ(count_of(run.log, "draw"), 3);
}

TEST(dispatcher_script, writes_frames) {
    const temporary_folder folder;
    l3d_frame_settings settings = frames(3);
    settings.output = folder.file("f%02d.png");
    script_run run(settings);
    run.dispatcher.start();
    EXPECT_EQ(folder.count(), 3);
    l3d_image second = l3d_read_png(folder.file("f01.png"));
    EXPECT_EQ(second.pixels().row(3)[5], 2u);
    ASSERT_EQ(run.pipeline.times.size(), 3u);
    EXPECT_GT(run.pipeline.times[1].write, 0);
}

TEST(dispatcher_script, frames_before_the_first_only_pass) {
    const temporary_folder folder;
    for (const bool skips : {true, false}) {
        l3d_frame_settings settings = frames(5);
        settings.first_frame = 3;
        settings.output = folder.file("f%d.png");
        script_run run(settings);
        run.pipeline.skips = skips;
        run.pipeline.lazy = true;
        run.dispatcher.start();
        EXPECT_EQ(run.pipeline.steps.size(), 5u);
        EXPECT_EQ(count_of(run.log, "skip"), 3);
        EXPECT_EQ(count_of(run.log, "draw"), 1) << "once, be it before or in frame 3";
        EXPECT_EQ(run.log[2], skips ? "update" : "draw");
        EXPECT_EQ(count_of(run.log, "show"), skips ? 1 : 0);
        EXPECT_EQ(folder.count(), 2);
        EXPECT_TRUE(folder.holds("f3.png") && folder.holds("f4.png"));
    }
}

TEST(dispatcher_script, resuming_makes_what_is_missing) {
    const temporary_folder folder;
    l3d_frame_settings settings = frames(4);
    settings.output = folder.file("f%d.png");
    settings.resume = true;
    script_run run(settings);
    const l3d_size size = run.screen.pixels().size();
    for (const char* present : {"f1.png", "f3.png"}) {
        l3d_image stranger(size);
        l3d_write_png(folder.file(present), stranger.pixels());
    }
    l3d_image of_another_size({3, 2}, 3);
    l3d_write_png(folder.file("f0.png"), of_another_size.pixels());
    run.pipeline.skips = true;
    run.dispatcher.start();
    EXPECT_EQ(folder.count(), 4);
    EXPECT_EQ(l3d_read_png(folder.file("f0.png")).pixels().width, size.width) << "written again";
    EXPECT_EQ(l3d_read_png(folder.file("f1.png")).pixels().row(3)[5], 0u) << "not written again";
    EXPECT_EQ(l3d_read_png(folder.file("f2.png")).pixels().row(3)[5], 2u);
    EXPECT_EQ(count_of(run.log, "update"), 4);
}

TEST(dispatcher_script, last_frame_is_drawn_even_if_none_was_due) {
    const temporary_folder folder;
    l3d_frame_settings settings = frames(3);
    settings.output = folder.file("last.png");
    script_run run(settings, {{0, make_key('q')}});
    run.dispatcher.start();
    l3d_image last = l3d_read_png(folder.file("last.png"));
    EXPECT_EQ(last.pixels().row(3)[5], 1u);
}

} // namespace
