// SPDX-License-Identifier: MIT
// l3d_dispatcher_window: its loop, on a screen whose events the test makes up.
#include "system/dispatcher_window.h"
#include "system/fakes.h"
#include "system/temporary_folder.h"

#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <csignal>
#include <numeric>

namespace {

using namespace std::chrono_literals;

struct window_run {
    explicit window_run(const l3d_frame_settings& settings) : dispatcher(settings) {
        dispatcher.plug(pipeline, screen);
    }

    call_log log;
    l3d_dispatcher_window dispatcher;
    fake_screen screen{log};
    fake_pipeline pipeline{log, screen};
};

/// Without a limit of frames per second nothing has to be waited for.
l3d_frame_settings frames(int count, double fps = 0) {
    l3d_frame_settings settings;
    settings.frames = count;
    settings.fps = fps;
    return settings;
}

TEST(dispatcher_window, drains_all_events_before_a_frame) {
    window_run run(frames(2));
    for (const char key : {'a', 'b', 'c', 'd'})
        run.screen.pending.push_back(make_key(key));
    EXPECT_EQ(run.dispatcher.start(), l3d_exit::success);
    EXPECT_EQ(run.log, (call_log{"key a", "key b", "key c", "key d", "update", "draw", "show",
                                 "frame", "update", "draw", "show", "frame"}));
}

TEST(dispatcher_window, expose_shows_without_drawing) {
    window_run run(frames(2, 100));
    run.pipeline.lazy = true;
    run.screen.arrivals.push_back({make_event(l3d_event_type::expose)});
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame", "show", "update"}));
}

/// The keys of help are the caption's, where somebody can see it.
TEST(dispatcher_window, shows_a_caption_in_windows_alone) {
    for (const bool in_window : {true, false}) {
        window_run run(frames(1));
        run.screen.window = in_window;
        run.dispatcher.set_caption({.what = "A test."});
        for (const char key : {'h', 'a', 'q'})
            run.screen.pending.push_back(make_key(key));
        run.dispatcher.start();
        EXPECT_EQ(count_of(run.log, "key h"), in_window ? 0 : 1);
        EXPECT_EQ(count_of(run.log, "key a"), 1);
        EXPECT_TRUE(run.pipeline.done);
    }
}

/// A picture that is also a file is finished.
TEST(dispatcher_window, a_close_ends_a_long_picture) {
    for (const bool with_file : {false, true}) {
        const temporary_folder folder;
        l3d_frame_settings settings = frames(0);
        if (with_file)
            settings.output = folder.file("last.png");
        window_run run(settings);
        run.pipeline.on_draw = [&] {
            run.screen.pending.push_back(make_event(l3d_event_type::close));
        };
        EXPECT_EQ(run.dispatcher.start(), l3d_exit::success);
        EXPECT_EQ(run.log, with_file ? (call_log{"update", "draw", "show", "frame"})
                                     : (call_log{"update", "draw"}));
        EXPECT_TRUE(run.pipeline.done);
    }
}

TEST(dispatcher_window, a_signal_ends_a_long_picture) {
    EXPECT_EXIT(
        {
            window_run run(frames(0));
            run.pipeline.on_draw = [] { raise(SIGTERM); };
            run.dispatcher.start();
            if (run.log == call_log{"update", "draw"})
                std::cerr << "as expected";
        },
        testing::KilledBySignal(SIGTERM), "as expected");
}

TEST(dispatcher_window, frames_before_the_first_pass_at_once) {
    l3d_frame_settings settings = frames(4, 1);
    settings.first_frame = 3;
    window_run run(settings);
    run.pipeline.skips = true;
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"update", "skip", "update", "skip", "update", "skip", "update",
                                 "draw", "show", "frame"}));
    EXPECT_EQ(run.screen.waits, 0);
}

TEST(dispatcher_window, expose_before_the_first_frame_shows_nothing_unfinished) {
    window_run run(frames(1));
    run.screen.pending.push_back(make_event(l3d_event_type::expose));
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame"}));
}

TEST(dispatcher_window, expose_with_resize_shows_only_the_new_picture) {
    window_run run(frames(2, 100));
    run.pipeline.lazy = true;
    l3d_event resize = make_event(l3d_event_type::resize);
    resize.size = {31, 17};
    run.screen.arrivals.push_back({resize, make_event(l3d_event_type::expose)});
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame", "resize 31x17", "update",
                                 "draw", "show", "frame"}));
}

TEST(dispatcher_window, draws_only_what_is_needed) {
    window_run run(frames(4));
    run.pipeline.lazy = true;
    run.dispatcher.start();
    EXPECT_EQ(count_of(run.log, "update"), 4);
    EXPECT_EQ(count_of(run.log, "draw"), 1);
    EXPECT_EQ(count_of(run.log, "show"), 1);
    EXPECT_GE(run.screen.waits, 2); // after each idle frame, even without a limit
}

TEST(dispatcher_window, shows_only_what_changed) {
    for (const l3d_pixel_box changes : {l3d_pixel_box{3, 4, 9, 7}, l3d_pixel_box{}}) {
        window_run run(frames(100));
        run.pipeline.changes = changes;
        run.dispatcher.start();
        EXPECT_EQ(count_of(run.log, "draw"), 100);
        EXPECT_EQ(count_of(run.log, "show"), 1) << "the first picture is all new";
        EXPECT_EQ(count_of(run.log, "show part"), changes.empty() ? 0 : 99);
    }
}

TEST(dispatcher_window, sleeps_between_frames) {
    window_run run(frames(2, 4));
    run.dispatcher.start();
    EXPECT_GE(run.screen.waits, 1);
    EXPECT_LE(run.screen.longest_wait, 250ms);
}

TEST(dispatcher_window, quits_without_another_frame) {
    window_run by_key(frames(0, 100));
    by_key.screen.arrivals.push_back({make_key('q'), make_key('x')});
    EXPECT_EQ(by_key.dispatcher.start(), l3d_exit::success);
    EXPECT_EQ(by_key.log, (call_log{"update", "draw", "show", "frame", "key q", "key x"}));
}

TEST(dispatcher_window, close_ends_well) {
    window_run run(frames(0, 100));
    run.screen.arrivals.push_back({make_event(l3d_event_type::close)});
    EXPECT_EQ(run.dispatcher.start(), l3d_exit::success);
    EXPECT_EQ(count_of(run.log, "draw"), 1);
}

TEST(dispatcher_window, lost_display_is_told_and_the_last_frame_kept) {
    const temporary_folder folder;
    l3d_frame_settings settings = frames(0, 100);
    settings.output = folder.file("last.png");
    window_run run(settings);
    run.screen.arrivals.push_back({make_event(l3d_event_type::display_lost)});
    EXPECT_EQ(run.dispatcher.start(), l3d_exit::display_lost);
    EXPECT_EQ(count_of(run.log, "show"), 1);
    l3d_image last = l3d_read_png(folder.file("last.png"));
    EXPECT_EQ(last.pixels().row(3)[5], 1u);
}

TEST(dispatcher_window, hidden_windows_are_neither_drawn_nor_shown) {
    window_run run(frames(0, 500));
    run.pipeline.on_update = [&](int update) {
        if (update == 2)
            run.screen.pending.push_back(make_event(l3d_event_type::hide));
        run.pipeline.done = update == 4;
    };
    run.screen.naps_until_arrival = true;
    run.screen.arrivals = {{}, {}, {}, {}, {make_event(l3d_event_type::expose)}};
    run.dispatcher.start();
    // Time stands still, and the last picture is back before the next is due.
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame", "update", "draw", "show",
                                 "frame", "show", "update", "draw", "show", "frame", "update",
                                 "draw", "show", "frame"}));
    EXPECT_GE(run.screen.longest_wait, 1h);
}

TEST(dispatcher_window, nothing_wakes_up_while_nothing_changes) {
    window_run run(frames(0, 500));
    run.pipeline.lazy = true;
    run.pipeline.rests = true;
    run.screen.naps_until_arrival = true;
    run.screen.arrivals = {{}, {make_key('a')}, {make_key('q')}};
    run.dispatcher.start();
    // Once the first picture is there, there are only sleeps.
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame", "rest", "rest", "key a", "rest",
                                 "key q"}));
    EXPECT_EQ(run.screen.waits, 3);
    EXPECT_GE(run.screen.longest_wait, 1h);
}

TEST(dispatcher_window, wakes_up_once_for_what_ends_a_rest_by_itself) {
    window_run run(frames(0, 500));
    run.pipeline.lazy = run.pipeline.rests = true;
    run.pipeline.rest = 0.1; // fifty frames
    run.pipeline.on_update = [&](int update) { run.pipeline.done = update == 2; };
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame", "rest", "update", "draw",
                                 "show", "frame"}));
    EXPECT_EQ(run.screen.waits, 1);
    EXPECT_LT(run.pipeline.steps.at(1), run.pipeline.rest) << "of a rest only rest_event tells";
    EXPECT_GE(run.pipeline.rested, run.pipeline.rest);
}

TEST(dispatcher_window, the_first_picture_after_a_rest_comes_at_once_and_no_time_has_passed) {
    window_run run(frames(0, 1)); // a second from picture to picture
    run.pipeline.lazy = run.pipeline.rests = true;
    run.screen.on_wait = [&] {
        std::this_thread::sleep_for(1100ms);
        run.pipeline.lazy = run.pipeline.rests = false;
    };
    run.pipeline.on_update = [&](int update) { run.pipeline.done = update == 2; };
    run.screen.arrivals = {{make_key('a')}};
    run.dispatcher.start();
    EXPECT_EQ(run.screen.waits, 1);
    EXPECT_LT(run.pipeline.steps.at(1), 1.0);
}

TEST(dispatcher_window, letters_with_modifiers_are_not_the_letters) {
    window_run run(frames(1));
    for (const auto held : {&l3d_event::control, &l3d_event::alt, &l3d_event::logo}) {
        l3d_event press = make_key('q');
        press.*held = true;
        run.screen.pending.push_back(press);
    }
    l3d_event sideways = make_key('s');
    sideways.shift = true;
    run.screen.pending.push_back(sideways);
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"key s", "update", "draw", "show", "frame"}));
}

TEST(dispatcher_window, what_can_be_seen_again_is_shown_again_only_if_it_was_lost) {
    for (const bool is_lost : {false, true}) {
        window_run run(frames(0, 500));
        run.pipeline.lazy = true;
        run.pipeline.on_update = [&](int update) {
            if (update == 2 && is_lost) // and covered before anybody came to it
                run.screen.pending.push_back(make_event(l3d_event_type::expose));
            if (update == 2)
                run.screen.pending.push_back(make_event(l3d_event_type::hide));
            run.pipeline.done = update == 3;
        };
        run.screen.naps_until_arrival = true;
        run.screen.arrivals = {{}, {}, {}, {make_event(l3d_event_type::reveal)}};
        run.dispatcher.start();
        call_log wanted{"update", "draw", "show", "frame", "update", "show", "update"};
        if (!is_lost)
            wanted.erase(wanted.end() - 2);
        EXPECT_EQ(run.log, wanted) << is_lost;
    }
}

TEST(dispatcher_window, pictures_that_wait_for_the_display_are_not_drawn_over) {
    window_run run(frames(0, 500));
    run.pipeline.on_update = [&](int update) {
        run.screen.busy = update == 2 || update == 3;
        run.pipeline.done = update == 4;
    };
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"update", "draw", "show", "frame", "update", "update", "update",
                                 "draw", "show", "frame"}));
}

TEST(dispatcher_window, frames_that_are_counted_or_written_are_drawn_unseen) {
    const temporary_folder folder;
    window_run counted(frames(2));
    counted.screen.pending.push_back(make_event(l3d_event_type::hide));
    counted.dispatcher.start();
    EXPECT_EQ(count_of(counted.log, "draw"), 2);

    l3d_frame_settings settings = frames(0);
    settings.output = folder.file("last.png");
    window_run written(settings);
    written.screen.pending.push_back(make_event(l3d_event_type::hide));
    written.pipeline.on_update = [&](int update) { written.pipeline.done = update == 3; };
    written.dispatcher.start();
    EXPECT_EQ(count_of(written.log, "draw"), 3);
}

TEST(dispatcher_window, fullscreen_comes_and_goes_and_escape_leaves_it) {
    window_run run(frames(1));
    const l3d_event toggle = make_event(l3d_event_type::fullscreen);
    const l3d_event escape = make_key(l3d_key_escape);
    run.screen.pending = {toggle, toggle, toggle, escape, make_key('a'), escape};
    run.dispatcher.start();
    EXPECT_EQ(run.log, (call_log{"fullscreen", "window again", "fullscreen", "window again",
                                 "key a", "key \x1B", "update", "draw", "show", "frame"}));
}

TEST(dispatcher_window, as_fast_as_the_screen_is_good_for) {
    l3d_frame_settings settings;
    settings.frames = 3;
    for (const auto& [asked, least] : {std::pair<std::optional<double>, double>{{}, 0.25},
                                       std::pair<std::optional<double>, double>{20, 0.05}}) {
        settings.fps = asked;
        window_run run(settings);
        run.screen.fps = 4;
        run.dispatcher.start();
        const auto& steps = run.pipeline.steps;
        EXPECT_GE(steps.at(1) + steps.at(2), 2 * least - 0.01);
        EXPECT_EQ(steps.at(1) + steps.at(2) < 0.4, asked.has_value());
    }
}

TEST(dispatcher_window, passes_on_what_screen_and_pipeline_have_to_say) {
    l3d_frame_settings settings = frames(2);
    settings.program = "tester";
    window_run run(settings);
    run.screen.remark = "slower from now on";
    run.pipeline.remark = "fewer threads";
    testing::internal::CaptureStderr();
    run.pipeline.on_update = [&](int update) {
        run.screen.remark = update == 2 ? "still slower" : run.screen.remark;
    };
    run.dispatcher.start();
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "tester: fewer threads\ntester: slower from now on\ntester: still slower\n");
}

TEST(dispatcher_window, fixed_steps) {
    l3d_frame_settings settings = frames(3, 200);
    settings.fixed_step = true;
    window_run run(settings);
    run.dispatcher.start();
    EXPECT_EQ(run.pipeline.steps, std::vector<double>(3, 1 / 200.0));
}

TEST(dispatcher_window, measured_steps_add_up_to_the_time_that_passed) {
    const auto before = std::chrono::steady_clock::now();
    window_run run(frames(6, 100));
    run.dispatcher.start();
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - before;
    const double sum = std::accumulate(run.pipeline.steps.begin(), run.pipeline.steps.end(), 0.0);
    EXPECT_LE(sum, passed.count());
    EXPECT_GE(sum, 5 * 0.01); // the last frame is due on the fifth tick after the first
}

/// A program that raises a signal while it runs; says so on stderr when its loop is over.
void run_with_signal(int signal) {
    std::signal(signal, SIG_DFL); // shells let background jobs ignore SIGINT
    l3d_frame_settings settings;
    call_log log;
    l3d_dispatcher_window dispatcher(settings);
    fake_screen screen(log);
    fake_pipeline pipeline(log, screen);
    pipeline.on_update = [signal](int update) {
        if (update == 2)
            raise(signal);
    };
    dispatcher.plug(pipeline, screen);
    dispatcher.start();
    fputs("loop over\n", stderr);
}

TEST(dispatcher_window_death_test, signals_end_the_loop_and_then_the_program) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT})
        EXPECT_EXIT(run_with_signal(signal), testing::KilledBySignal(signal), "loop over");
}

/// The first signal in vain, as in a program that hangs in a frame.
void insist_with_signal(int signal) {
    std::signal(signal, SIG_DFL);
    call_log log;
    l3d_dispatcher_window dispatcher{l3d_frame_settings{}};
    fake_screen screen(log);
    fake_pipeline pipeline(log, screen);
    pipeline.on_update = [signal](int) {
        for (;;)
            raise(signal);
    };
    dispatcher.plug(pipeline, screen);
    dispatcher.start();
}

/// One signal, in a frame that never ends.
void hang_with_signal(int signal) {
    std::signal(signal, SIG_DFL);
    call_log log;
    l3d_dispatcher_window dispatcher{l3d_frame_settings{}};
    fake_screen screen(log);
    fake_pipeline pipeline(log, screen);
    pipeline.on_update = [signal](int) {
        raise(signal);
        for (volatile bool goes_on = true; goes_on;) {
        }
    };
    dispatcher.plug(pipeline, screen);
    dispatcher.start();
}

TEST(dispatcher_window_death_test, one_signal_ends_a_frame_that_hangs_after_a_while) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(hang_with_signal(SIGTERM), testing::KilledBySignal(SIGTERM), "");
}

TEST(dispatcher_window_death_test, second_signal_ends_a_frame_that_hangs) {
    testing::FLAGS_gtest_death_test_style = "threadsafe";
    EXPECT_EXIT(insist_with_signal(SIGINT), testing::KilledBySignal(SIGINT), "");
}

TEST(signal_watch, leaves_ignored_signals_ignored) {
    const auto before = std::signal(SIGINT, SIG_IGN);
    {
        const l3d_signal_watch watch;
        raise(SIGINT);
        EXPECT_FALSE(watch.caught());
    }
    EXPECT_EQ(std::signal(SIGINT, before), SIG_IGN);
}

} // namespace
