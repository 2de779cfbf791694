// SPDX-License-Identifier: MIT
// X11 windows: what happens to them becomes events.
#include "onlooker_x11.h"

#include <array>
#include <cstdlib>
#include <thread>
#include <vector>

namespace {

using namespace std::chrono_literals;

using enum l3d_event_type;

TEST(screen_x11_events, close_button_is_an_event) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    EXPECT_FALSE(screen->is_to_close());
    other.send_protocol("WM_DELETE_WINDOW");
    EXPECT_TRUE(screen->is_to_close());
    EXPECT_TRUE(screen->is_to_close()) << "the event was taken";
    EXPECT_NE(next(*screen, l3d_event_type::close), nullptr);
    EXPECT_NE(other.window(), 0U) << "closing is the program's decision";
}

TEST(screen_x11_events, destroyed_by_another_is_an_event) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    XDestroyWindow(other.display(), other.window());
    XSync(other.display(), False);
    // The screen does not know yet: these go to a window that is gone.
    screen->show();
    screen->show();
    EXPECT_NE(next(*screen, l3d_event_type::close), nullptr);
    screen->show();
}

TEST(screen_x11_events, a_ping_comes_back_on_the_root) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    XSelectInput(other.display(), other.root(), SubstructureNotifyMask);
    other.send_protocol("_NET_WM_PING");
    // Nothing for the program itself; asked for its events it answers.
    l3d_event event;
    XEvent answer{};
    while (answer.type != ClientMessage) {
        EXPECT_FALSE(screen->next_event(event));
        if (XCheckTypedEvent(other.display(), ClientMessage, &answer) == 0)
            std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(answer.xclient.window, other.root());
    EXPECT_EQ(answer.xclient.data.l[0], static_cast<long>(other.atom("_NET_WM_PING")));
    EXPECT_EQ(answer.xclient.data.l[1], 4711);
}

TEST(screen_x11_events, buttons_wheel_and_motion) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    other.send_button(ButtonPress, 3, 17, 29);
    for (int i = 0; i < 5; ++i)
        other.send_motion(Button3Mask, 20 + i, 30 - i);
    other.send_button(ButtonRelease, 3, 24, 26);
    for (const unsigned wheel : {4U, 5U, 6U, 7U}) {
        other.send_button(ButtonPress, wheel, 5, 6);
        other.send_button(ButtonRelease, wheel, 5, 6);
    }
    std::vector<std::array<int, 4>> seen;
    std::vector<int> notches;
    std::vector<double> turns;
    l3d_event event;
    while (screen->next_event(event)) {
        seen.push_back({static_cast<int>(event.type), event.button, event.x, event.y});
        notches.push_back(event.notches);
        turns.push_back(event.turn);
    }
    const auto row = [](l3d_event_type type, int button, int x, int y) {
        return std::array{static_cast<int>(type), button, x, y};
    };
    EXPECT_EQ(seen, (std::vector{row(button_press, 3, 17, 29), row(pointer_motion, 3, 24, 26),
                                 row(button_release, 3, 24, 26), row(wheel, 0, 5, 6),
                                 row(wheel, 0, 5, 6)}));
    EXPECT_EQ(notches, (std::vector{0, 0, 0, 1, -1}));
    EXPECT_EQ(turns, (std::vector<double>{0, 0, 0, 1, -1}));
}

/// The motion that comes until the pointer has gone so far to the right, all added up.
l3d_event moved(l3d_screen& screen, double right) {
    l3d_event sum, event;
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (sum.right < right && std::chrono::steady_clock::now() < deadline) {
        while (screen.next_event(event))
            if (event.type == pointer_motion) {
                sum.right += event.right;
                sum.down += event.down;
            }
        screen.wait(10ms);
    }
    return sum;
}

TEST(screen_x11_events, motion_without_a_button_is_told_to_who_wants_it) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    show_for_certain(*screen);
    screen->set_pointer(l3d_pointer::followed);
    drop_events(*screen);
    ASSERT_EQ(std::system("xdotool mousemove 30 20"), 0);
    const auto event = next(*screen, pointer_motion);
    ASSERT_NE(event, nullptr);
    EXPECT_EQ(event->button, 0);
    EXPECT_EQ(event->right, 0);
    screen->set_pointer(l3d_pointer::dragged);
    drop_events(*screen);
    ASSERT_EQ(std::system("xdotool mousemove 40 30 key x"), 0);
    l3d_event other;
    while (!screen->next_event(other) || other.type == key_release)
        screen->wait(10ms);
    EXPECT_EQ(other.type, key_press) << "motion that nobody asked for";
}

/// The way is twice as wide as the display.
TEST(screen_x11_events, a_held_pointer_moves_without_end) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    show_for_certain(*screen);
    screen->set_pointer(l3d_pointer::held);
    const auto is_held = [&] {
        const int answer = XGrabPointer(other.display(), other.root(), False, 0, GrabModeAsync,
                                        GrabModeAsync, None, None, CurrentTime);
        XUngrabPointer(other.display(), CurrentTime);
        XSync(other.display(), False);
        return answer == AlreadyGrabbed;
    };
    for (int i = 0; i < 500 && !is_held(); ++i) {
        drop_events(*screen);
        screen->wait(10ms);
    }
    ASSERT_TRUE(is_held());
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(std::system("xdotool mousemove_relative 30 5"), 0);
        const l3d_event way = moved(*screen, 30);
        ASSERT_EQ(way.right, 30) << i;
        ASSERT_EQ(way.down, 5) << i;
    }
    XSetInputFocus(other.display(), other.root(), RevertToParent, CurrentTime);
    XSync(other.display(), False);
    for (int i = 0; i < 500 && is_held(); ++i) {
        drop_events(*screen);
        screen->wait(10ms);
    }
    EXPECT_FALSE(is_held()) << "without the keyboard";
}

TEST(screen_x11_events, two_clicks_soon_at_one_place_are_a_double_click) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    const auto click = [&](unsigned button, int x, Time time, unsigned state = 0) {
        other.send_button(ButtonPress, button, x, 29, time, state);
        other.send_button(ButtonRelease, button, x, 29, time + 10, state);
    };
    click(1, 17, 5000);
    click(1, 20, 5400); // soon enough, near enough
    click(1, 20, 5401); // a third one begins anew
    click(1, 20, 5802); // too late
    click(1, 25, 5803); // too far away
    click(3, 25, 5804); // another button
    click(3, 25, 5805, ShiftMask | ControlMask);
    std::vector<int> clicks;
    l3d_event event;
    while (screen->next_event(event))
        if (event.type == button_press)
            clicks.push_back(event.clicks);
    EXPECT_EQ(clicks, (std::vector{1, 2, 1, 1, 1, 1, 2}));
    EXPECT_TRUE(event.shift);
    EXPECT_TRUE(event.control);
}

TEST(screen_x11_events, a_storm_of_sizes_ends_at_the_last) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server("701x507x16");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    std::mt19937 random(seed);
    int resizes = 0;
    l3d_event event;
    for (int i = 0; i < 300; ++i) {
        XResizeWindow(other.display(), other.window(), 1 + static_cast<unsigned>(random() % 600),
                      1 + static_cast<unsigned>(random() % 400));
        XSync(other.display(), False);
        if (i % 10 != 9)
            continue;
        while (screen->next_event(event)) {
            resizes += event.type == l3d_event_type::resize;
            EXPECT_EQ(event.type == l3d_event_type::resize ? event.size : screen->pixels().size(),
                      screen->pixels().size());
        }
        draw_random(screen->pixels(), seed);
        screen->show();
    }
    EXPECT_LE(resizes, 30) << "more than one per batch of ten";
    XResizeWindow(other.display(), other.window(), 321, 123);
    XSync(other.display(), False);
    drop_events(*screen);
    ASSERT_EQ(screen->pixels().size(), (l3d_size{321, 123}));
    draw_random(screen->pixels(), seed + 1);
    show_for_certain(*screen);
    EXPECT_EQ(wrong_pixels(other, screen->pixels(), screen->info()), 0);
}

TEST(screen_x11_events, the_same_size_again_is_no_event) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    const auto* words = screen->pixels().words;
    XMoveWindow(other.display(), other.window(), 31, 17);
    XResizeWindow(other.display(), other.window(), 50, 60);
    XResizeWindow(other.display(), other.window(), static_cast<unsigned>(odd_size.width),
                  static_cast<unsigned>(odd_size.height));
    XSync(other.display(), False);
    l3d_event event;
    while (screen->next_event(event))
        EXPECT_NE(event.type, l3d_event_type::resize);
    EXPECT_EQ(screen->pixels().words, words);
}

TEST(screen_x11_events, pixels_stay_until_the_resize_is_told) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    const auto before = screen->pixels();
    XResizeWindow(other.display(), other.window(), 60, 70);
    XSync(other.display(), False);
    screen->wait(patience);
    screen->show();
    // Under the address sanitizer this is the proof.
    draw_random(before, 1);
    EXPECT_EQ(screen->pixels().words, before.words);
    EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, (l3d_size{60, 70}));
    EXPECT_EQ(screen->pixels().size(), (l3d_size{60, 70}));
}

TEST(screen_x11_events, a_window_that_nobody_sees_says_so) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    screen->show();
    drop_events(*screen);
    const Window ours = other.window();
    // The server may say that a window can be seen before it says that the window lost its picture.
    const auto told = [&] {
        XSync(other.display(), False);
        screen->wait(patience);
        std::vector<l3d_event_type> types;
        for (l3d_event event; screen->next_event(event);)
            if (event.type != reveal)
                types.push_back(event.type);
        return types;
    };
    const auto only = [&](l3d_event_type type) { return told() == std::vector{type}; };
    const Window cover = XCreateSimpleWindow(other.display(), other.root(), 0, 0, 200, 99, 0, 0, 7);
    XMapRaised(other.display(), cover);
    EXPECT_TRUE(only(hide)) << "covered";
    XMoveWindow(other.display(), cover, 40, 0);
    EXPECT_TRUE(only(expose)) << "partly uncovered";
    XMoveWindow(other.display(), cover, 0, 0);
    EXPECT_TRUE(only(hide)) << "covered again";
    XDestroyWindow(other.display(), cover);
    EXPECT_TRUE(only(expose)) << "uncovered";
    XUnmapWindow(other.display(), ours);
    EXPECT_TRUE(only(hide)) << "taken from the screen";
    XMapWindow(other.display(), ours);
    EXPECT_TRUE(only(expose)) << "back";
    XUnmapWindow(other.display(), ours);
    XMapWindow(other.display(), ours);
    EXPECT_TRUE(only(expose)) << "gone and back";
    XUnmapWindow(other.display(), ours);
    EXPECT_TRUE(only(hide)) << "gone";
    XMapWindow(other.display(), ours);
    XUnmapWindow(other.display(), ours);
    EXPECT_EQ(told(), (std::vector{expose, hide})) << "back and gone, and not shown again yet";
}

/// A server that keeps what is covered does not ask for it.
TEST(screen_x11_events, a_window_that_is_seen_again_says_so) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    XEvent event{};
    event.type = VisibilityNotify;
    event.xvisibility.state = VisibilityFullyObscured;
    other.send(event, VisibilityChangeMask);
    EXPECT_NE(next(*screen, hide), nullptr);
    event.xvisibility.state = VisibilityPartiallyObscured;
    other.send(event, VisibilityChangeMask);
    EXPECT_NE(next(*screen, reveal), nullptr);
    other.send(event, VisibilityChangeMask);
    l3d_event another;
    EXPECT_FALSE(screen->next_event(another)) << "nothing new";
}

TEST(screen_x11_events, uncovering_is_an_event) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    const Window ours = other.window();
    const Window cover =
        XCreateSimpleWindow(other.display(), other.root(), 11, 13, 50, 40, 0, 0, 7);
    XMapRaised(other.display(), cover);
    XSync(other.display(), False);
    XDestroyWindow(other.display(), cover);
    XSync(other.display(), False);
    EXPECT_EQ(other.window(), ours);
    EXPECT_NE(next(*screen, l3d_event_type::expose), nullptr);
}

} // namespace
