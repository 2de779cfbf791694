// SPDX-License-Identifier: MIT
// X11 windows: slow and dead servers, and errors.
#include "cut_wire.h"
#include "onlooker_x11.h"

#include "tool_2d/x11/x11_connection_p.h"

#include <thread>

#include <X11/Xlib-xcb.h>
#include <X11/extensions/XShm.h>
#include <X11/keysym.h>

namespace {

/// A server that does not answer: show comes back, and the last picture arrives in the end,
/// although the program only sleeps.
TEST(screen_x11_loss, one_picture_under_way_at_most) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    drop_events(*screen);
    const onlooker other;
    server.pause();
    for (unsigned frame = 1; frame <= 4; ++frame) {
        draw_random(screen->pixels(), frame);
        screen->show();
    }
    server.resume();
    int wrong = 1;
    std::thread looking([&] {
        for (int tries = 0; wrong != 0 && tries < 20000; ++tries)
            wrong = wrong_pixels(other, screen->pixels(), screen->info());
        other.send_key(KeyPress, XK_y);
    });
    screen->wait(patience);
    EXPECT_NE(next(*screen, l3d_event_type::key_press), nullptr);
    looking.join();
    EXPECT_EQ(wrong, 0);
}

TEST(screen_x11_loss, a_dead_server_is_an_event) {
    xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    drop_events(*screen);
    screen->show();
    server.end(SIGKILL);
    EXPECT_NE(next(*screen, l3d_event_type::display_lost), nullptr);
    // Nothing of this may reach the server, wait for it, or end the program.
    l3d_event event;
    EXPECT_FALSE(screen->next_event(event)) << "told twice";
    draw_random(screen->pixels(), 5);
    screen->show();
    screen->wait(patience * 100);
}

TEST(screen_x11_loss, a_dead_server_shows_itself_while_drawing) {
    xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    server.end(SIGKILL);
    for (int i = 0; i < 10; ++i)
        screen->show();
    EXPECT_NE(next(*screen, l3d_event_type::display_lost), nullptr);
}

/// The end of a program whose server dies: its exit code.
int draw_until_lost() {
    l3d_service refusal;
    const auto screen = l3d_screen_factory_ximage().create({odd_size, "cut"}, refusal);
    if (!screen)
        return refusal.how == l3d_service::level::no_display     ? 3
               : refusal.how == l3d_service::level::display_lost ? 6
                                                                 : 1;
    for (int frame = 0; frame < 9; ++frame) {
        screen->show();
        l3d_event event;
        while (screen->next_event(event)) {
            if (event.type == l3d_event_type::display_lost)
                return 6;
        }
    }
    return 0;
}

TEST(screen_x11_loss, a_server_may_die_at_any_byte) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    // 9 pictures of 141 x 83 words are some 420000 bytes; the start is where all differs.
    int declined = 0, lost = 0, well = 0;
    for (std::size_t bytes = 1; bytes < 1000000; bytes += 3 + bytes / 9) {
        const cut_wire wire(server.display(), bytes);
        ASSERT_TRUE(wire.ready());
        // In a process of its own, since what is tested is whether the process ends.
        const pid_t child = fork();
        if (child == 0) {
            setenv("DISPLAY", wire.display().c_str(), 1);
            _exit(draw_until_lost());
        }
        int status = 0;
        waitpid(child, &status, 0);
        ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status) << " at " << bytes;
        const int code = WEXITSTATUS(status);
        declined += code == 3;
        lost += code == 6;
        well += code == 0;
        EXPECT_TRUE(code == 3 || code == 6 || code == 0) << code << " at " << bytes;
    }
    EXPECT_GT(declined, 2); // within the 12 bytes that connecting takes
    EXPECT_GT(lost, 10);
    EXPECT_GT(well, 0);
}

/// XCB knows that the server is gone, but Xlib does not yet, and wants the connection back.
TEST(screen_x11_loss, a_server_may_die_between_two_libraries) {
    xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    std::string why;
    const auto connection = l3d_detail::x11_connection::open(why);
    ASSERT_NE(connection, nullptr) << why;
    ASSERT_TRUE(XShmQueryExtension(connection->display()));
    server.end(SIGKILL);
    xcb_get_input_focus(XGetXCBConnection(connection->display()));
    // A request of an extension: those are the ones that do not look whether there is room.
    XShmSegmentInfo segment{};
    XShmDetach(connection->display(), &segment);
    EXPECT_TRUE(connection->lost());
}

int foreign_errors = 0;
int count_error(Display*, XErrorEvent*) {
    return ++foreign_errors;
}

TEST(screen_x11_loss, errors_of_others_go_to_their_handler) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    foreign_errors = 0;
    const auto before = XSetErrorHandler(count_error);
    {
        const auto screen = make();
        const onlooker other;
        XDestroyWindow(other.display(), other.window());
        XSync(other.display(), False);
        screen->show();
        screen->show();
        EXPECT_EQ(foreign_errors, 0) << "the screen's own error went to the host program";
        XMapWindow(other.display(), 0x1234);
        XSync(other.display(), False);
        EXPECT_EQ(foreign_errors, 1);
    }
    EXPECT_EQ(XSetErrorHandler(before), count_error) << "the host program's handler is back";
}

TEST(screen_x11_loss, a_handler_that_came_later_stays) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    auto screen = make();
    const auto ours = XSetErrorHandler(count_error);
    screen.reset();
    EXPECT_EQ(XSetErrorHandler(nullptr), count_error);
    EXPECT_NE(ours, count_error);
}

using signal_handler = void (*)(int);

signal_handler handler_of(int signal) {
    struct sigaction action {};
    sigaction(signal, nullptr, &action);
    return action.sa_handler;
}

/// Writing to a server that died in just this moment.
TEST(screen_x11_loss, a_broken_pipe_does_not_end_the_program) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    ASSERT_EQ(handler_of(SIGPIPE), SIG_DFL);
    {
        const auto screen = make();
        raise(SIGPIPE);
    }
    EXPECT_EQ(handler_of(SIGPIPE), SIG_DFL);
    std::signal(SIGPIPE, SIG_IGN);
    {
        const auto screen = make();
        EXPECT_EQ(handler_of(SIGPIPE), SIG_IGN) << "the program's own choice stays";
    }
    EXPECT_EQ(handler_of(SIGPIPE), SIG_IGN);
    std::signal(SIGPIPE, SIG_DFL);
}

} // namespace
