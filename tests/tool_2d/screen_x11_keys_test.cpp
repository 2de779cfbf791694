// SPDX-License-Identifier: MIT
// X11 windows: keys, under every layout, held, repeated and let go.
#include "onlooker_x11.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include <X11/keysym.h>

namespace {

using enum l3d_event_type;

/// Events as type and key.
using told = std::vector<std::pair<l3d_event_type, int>>;

/// What has come, but at least so many: the server may answer the other program before it writes
/// to us.
told drained(l3d_screen& screen, std::size_t count) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    told events;
    l3d_event event;
    while (true) {
        while (screen.next_event(event))
            events.emplace_back(event.type, event.key);
        const auto now = std::chrono::steady_clock::now();
        if (events.size() >= count || now >= deadline)
            return events;
        screen.wait(deadline - now);
    }
}

TEST(screen_x11_keys, keys) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    const auto pressed = [&](KeySym keysym, unsigned state) {
        other.send_key(KeyPress, keysym, state);
        const auto event = next(*screen, l3d_event_type::key_press);
        return event ? event->key : -1;
    };
    EXPECT_EQ(pressed(XK_q, 0), 'q');
    EXPECT_EQ(pressed(XK_q, ShiftMask), 'Q');
    EXPECT_EQ(pressed(XK_q, LockMask), 'q');
    EXPECT_EQ(pressed(XK_q, ControlMask), 'q');
    EXPECT_EQ(pressed(XK_1, ShiftMask), '!');
    EXPECT_EQ(pressed(XK_space, 0), ' ');
    EXPECT_EQ(pressed(XK_KP_Add, 0), '+');
    EXPECT_EQ(pressed(XK_KP_4, 0), l3d_key_left);
    EXPECT_EQ(pressed(XK_Escape, 0), l3d_key_escape);
    EXPECT_EQ(pressed(XK_Return, 0), l3d_key_return);
    EXPECT_EQ(pressed(XK_BackSpace, 0), l3d_key_backspace);
    EXPECT_EQ(pressed(XK_Left, 0), l3d_key_left);
    EXPECT_EQ(pressed(XK_Page_Down, 0), l3d_key_page_down);
    EXPECT_EQ(pressed(XK_End, 0), l3d_key_end);
    EXPECT_EQ(pressed(XK_F1, 0), l3d_key_f1);
    EXPECT_EQ(pressed(XK_F7, 0), l3d_key_f1 + 6);
    EXPECT_EQ(pressed(XK_F10, 0), l3d_key_f1 + 9);
}

TEST(screen_x11_keys, a_modifier_alone_is_a_key) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    other.send_keys({{KeyPress, XK_Shift_L, 100},
                     {KeyRelease, XK_Shift_L, 110},
                     {KeyPress, XK_Control_R, 120},
                     {KeyPress, XK_Alt_L, 130},
                     {KeyPress, XK_F12, 140}, // none of ours
                     {KeyPress, XK_Delete, 150},
                     {KeyPress, XK_Insert, 160}});
    EXPECT_EQ(drained(*screen, 6), (told{{key_press, l3d_key_shift},
                                         {key_release, l3d_key_shift},
                                         {key_press, l3d_key_control},
                                         {key_press, l3d_key_alt},
                                         {key_press, l3d_key_delete},
                                         {key_press, l3d_key_insert}}));
}

TEST(screen_x11_keys, tell_what_they_type_whether_they_repeat_and_when) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    const auto pressed = [&](KeySym keysym, unsigned state, Time time) {
        other.send_key(KeyPress, keysym, state, time);
        const auto event = next(*screen, key_press);
        return event ? *event : l3d_event{};
    };
    const l3d_event a = pressed(XK_a, 0, 1000), again = pressed(XK_a, 0, 1500);
    EXPECT_EQ(a.text, "a");
    EXPECT_FALSE(a.repeat);
    EXPECT_TRUE(again.repeat);
    EXPECT_EQ(again.time - a.time, std::chrono::milliseconds(500));
    EXPECT_EQ(pressed(XK_b, ShiftMask, 1600).text, "B");
    EXPECT_EQ(pressed(XK_c, ControlMask, 1700).text, "");
    EXPECT_TRUE(pressed(XK_c, ControlMask, 1800).control);
    EXPECT_EQ(pressed(XK_Return, 0, 1900).text, "");
    EXPECT_EQ(pressed(XK_Left, 0, 2000).text, "");
}

/// The milliseconds of X begin anew after 49.7 days.
TEST(screen_x11_keys, their_time_goes_on_where_that_of_x_begins_anew) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    const auto time_of = [&](Time time) {
        other.send_key(KeyPress, XK_a, 0, time);
        const auto event = next(*screen, key_press);
        return event ? event->time : std::chrono::milliseconds(-1);
    };
    const auto before = time_of(0xFFFFFF00);
    EXPECT_EQ(time_of(0x100) - before, std::chrono::milliseconds(0x200));
}

TEST(screen_x11_keys, of_other_scripts_and_dead_keys_type_in_utf_8) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    setenv("LC_ALL", "en_US.UTF-8", 1); // names the table of sequences
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    std::array<KeySym, 2> dead{XK_dead_acute, XK_dead_acute}, euro{XK_EuroSign, XK_EuroSign};
    XChangeKeyboardMapping(other.display(), XKeysymToKeycode(other.display(), XK_y), 2, dead.data(),
                           1);
    XChangeKeyboardMapping(other.display(), XKeysymToKeycode(other.display(), XK_z), 2, euro.data(),
                           1);
    XSync(other.display(), False);
    drop_events(*screen);
    const auto typed = [&](KeySym keysym) {
        other.send_key(KeyPress, keysym);
        const auto event = next(*screen, key_press);
        return event ? event->text : "nothing";
    };
    EXPECT_EQ(typed(XK_EuroSign), "\u20ac");
    EXPECT_EQ(typed(XK_dead_acute), "");
    EXPECT_EQ(typed(XK_e), "\u00e9");
    EXPECT_EQ(typed(XK_e), "e");
    unsetenv("LC_ALL");
}

TEST(screen_x11_keys, a_held_key_is_released_once) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    // A server that repeats in pairs hands out each of them in one piece, too.
    other.send_keys({{KeyPress, XK_w, 100},
                     {KeyRelease, XK_w, 200},
                     {KeyPress, XK_w, 200},
                     {KeyRelease, XK_w, 230},
                     {KeyPress, XK_w, 230},
                     {KeyRelease, XK_w, 260},
                     {KeyPress, XK_w, 260},
                     {KeyRelease, XK_w, 300},
                     {KeyPress, XK_w, 301}});
    EXPECT_EQ(drained(*screen, 6), (told{{key_press, 'w'},
                                         {key_press, 'w'},
                                         {key_press, 'w'},
                                         {key_press, 'w'},
                                         {key_release, 'w'},
                                         {key_press, 'w'}}));
}

TEST(screen_x11_keys, the_server_repeats_a_key_but_does_not_release_it) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    // Repeats begin after 0.66 s, 25 a second.
    ASSERT_EQ(std::system("xdotool keydown w sleep 1 keyup w"), 0);
    told events;
    while (events.empty() || events.back().first != key_release) {
        const told more = drained(*screen, 1);
        ASSERT_FALSE(more.empty()) << "it was never released";
        events.insert(events.end(), more.begin(), more.end());
    }
    ASSERT_GE(events.size(), 3U);
    for (const auto& event : events)
        EXPECT_EQ(event, std::pair(&event == &events.back() ? key_release : key_press, int('w')));
}

TEST(screen_x11_keys, keys_go_up_when_the_keyboard_goes_away) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    show_for_certain(*screen); // It has the keyboard by now.
    drop_events(*screen);
    other.send_key(KeyPress, XK_w);
    other.send_key(KeyPress, XK_Left);
    XSetInputFocus(other.display(), other.root(), RevertToParent, CurrentTime);
    XSync(other.display(), False);
    auto events = drained(*screen, 4);
    ASSERT_EQ(events.size(), 4U);
    std::sort(events.begin() + 2, events.end());
    EXPECT_EQ(events[2], std::pair(key_release, int('w')));
    EXPECT_EQ(events[3], std::pair(key_release, int(l3d_key_left)));
    other.send_key(KeyRelease, XK_w);
    other.send_key(KeyPress, XK_x);
    EXPECT_EQ(drained(*screen, 1), (told{{key_press, 'x'}})) << "w is up already";
}

/// Shift may go up before the letter does.
TEST(screen_x11_keys, the_key_that_was_pressed_is_the_one_released) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    other.send_key(KeyPress, XK_q, ShiftMask, 100);
    other.send_key(KeyRelease, XK_q, 0, 200);
    EXPECT_EQ(drained(*screen, 2), (told{{key_press, 'Q'}, {key_release, 'Q'}}));
}

TEST(screen_x11_keys, f11_and_alt_enter_ask_for_the_whole_screen) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    other.send_key(KeyPress, XK_F11, 0, 100);
    other.send_key(KeyPress, XK_F11, 0, 200); // held, it repeats
    other.send_key(KeyRelease, XK_F11, 0, 300);
    other.send_key(KeyPress, XK_Return, Mod1Mask, 400);
    other.send_key(KeyRelease, XK_Return, Mod1Mask, 500);
    other.send_key(KeyPress, XK_Return, 0, 600);
    other.send_key(KeyPress, XK_F11, 0, 700);
    EXPECT_EQ(
        drained(*screen, 4),
        (told{{fullscreen, 0}, {fullscreen, 0}, {key_press, l3d_key_return}, {fullscreen, 0}}));
}

/// A layout that has no Latin letters at all.
TEST(screen_x11_keys, letters_in_their_place_on_a_cyrillic_keyboard) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    drop_events(*screen);
    const auto code = XKeysymToKeycode(other.display(), XK_q);
    std::array<KeySym, 2> cyrillic{XK_Cyrillic_shorti, XK_Cyrillic_SHORTI};
    XChangeKeyboardMapping(other.display(), code, 2, cyrillic.data(), 1);
    XSync(other.display(), False);
    ASSERT_EQ(XKeysymToKeycode(other.display(), XK_Cyrillic_shorti), code);
    drop_events(*screen);
    other.send_key(KeyPress, XK_Cyrillic_shorti);
    EXPECT_EQ(next(*screen, key_press)->key, 'q');
}

} // namespace
