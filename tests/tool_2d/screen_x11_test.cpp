// SPDX-License-Identifier: MIT
// X11 windows: every pixel right on every display, refusals, and what other programs are told.
#include "onlooker_x11.h"

#include "tool_2d/x11/x11_image_p.h"

#include <array>
#include <cstring>
#include <thread>

namespace {

using namespace l3d_detail;

struct server_kind {
    const char* name;
    const char* screen;
    std::vector<std::string> more;
    int depth;
    int bits_per_pixel;
};

class screen_x11_depth : public testing::TestWithParam<server_kind> {};

TEST_P(screen_x11_depth, every_pixel_is_right) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server(GetParam().screen, GetParam().more);
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    ASSERT_NE(screen, nullptr);
    EXPECT_EQ(screen->info().layout().depth, GetParam().depth);
    EXPECT_EQ(screen->info().layout().bits_per_pixel, GetParam().bits_per_pixel);
    draw_random(screen->pixels(), seed);
    show_for_certain(*screen);
    const onlooker other;
    EXPECT_EQ(wrong_pixels(other, screen->pixels(), screen->info()), 0) << screen->describe();
}

INSTANTIATE_TEST_SUITE_P(
    servers, screen_x11_depth,
    testing::Values(server_kind{"true_color_8", "301x207x8", {"-cc", "4"}, 8, 8},
                    server_kind{"depth_15", "301x207x15", {}, 15, 16},
                    server_kind{"depth_16", "301x207x16", {}, 16, 16},
                    server_kind{"direct_color_16", "301x207x16", {"-cc", "5"}, 16, 16},
                    server_kind{"palette_8", "301x207x8", {"-cc", "3"}, 8, 8},
                    server_kind{"depth_24", "301x207x24", {}, 24, 32},
                    server_kind{"direct_color_24", "301x207x24", {"-cc", "5"}, 24, 32},
                    server_kind{"depth_30", "301x207x30", {}, 30, 32}),
    [](const auto& kind) { return std::string(kind.param.name); });

TEST(screen_x11, says_which_display_is_not_there) {
    const l3d_screen_factory_ximage factory;
    l3d_service refusal;
    unsetenv("DISPLAY");
    EXPECT_EQ(factory.service().how, l3d_service::level::no_display);
    EXPECT_EQ(factory.service().why, "DISPLAY is not set");
    for (const char* name : {":987", "nonsense", ":", "unix:987.3"}) {
        setenv("DISPLAY", name, 1);
        EXPECT_EQ(factory.service().how, l3d_service::level::no_display);
        const std::string why =
            std::string("cannot open the display that DISPLAY names, '") + name + "': ";
        EXPECT_TRUE(factory.service().why.starts_with(why)) << factory.service().why;
        EXPECT_EQ(factory.create({odd_size, "nowhere"}, refusal), nullptr);
    }
    unsetenv("DISPLAY");
}

TEST(screen_x11, asking_leaves_no_connection) {
    const xvfb server("301x207x24", {"-maxclients", "64"});
    L3D_REQUIRE_SERVER(server);
    const l3d_screen_factory_ximage factory;
    for (int i = 0; i < 100; ++i) {
        const auto service = factory.service();
        ASSERT_EQ(service.how, l3d_service::level::fully) << service.why << " at " << i;
    }
}

TEST(screen_x11, tells_others_who_it_is) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    EXPECT_EQ(other.property("_NET_WM_NAME"), "Teekanne für Öl");
    EXPECT_EQ(other.property("WM_NAME"), "Teekanne f\xFCr \xD6l");
    EXPECT_EQ(other.property("WM_CLASS"), std::string("l3d\0L3d\0", 8));
    long process = 0;
    const std::string told = late_property(*screen, other, "_NET_WM_PID");
    ASSERT_FALSE(told.empty());
    std::memcpy(&process, told.data(), sizeof process);
    EXPECT_EQ(process, getpid());
    EXPECT_FALSE(other.property("WM_CLIENT_MACHINE").empty());
    XWMHints* hints = XGetWMHints(other.display(), other.window());
    ASSERT_NE(hints, nullptr);
    EXPECT_EQ(hints->input, True);
    XFree(hints);
    XSizeHints size{};
    long supplied = 0;
    XGetWMNormalHints(other.display(), other.window(), &size, &supplied);
    EXPECT_EQ(size.min_width, 1);
    EXPECT_EQ(size.min_height, 1);
}

TEST(screen_x11, takes_the_keyboard_without_a_window_manager) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    show_for_certain(*screen);
    const onlooker other;
    Window focus = 0;
    int revert = 0;
    XGetInputFocus(other.display(), &focus, &revert);
    EXPECT_EQ(focus, other.window());
}

TEST(screen_x11, leaves_the_keyboard_to_the_window_manager) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const onlooker manager;
    XSelectInput(manager.display(), manager.root(), SubstructureRedirectMask);
    XSync(manager.display(), False);
    std::thread mapping([&] {
        XEvent event;
        XIfEvent(
            manager.display(), &event,
            [](Display*, XEvent* candidate, XPointer) -> Bool {
                return candidate->type == MapRequest;
            },
            nullptr);
        XMapWindow(manager.display(), event.xmaprequest.window);
        XSync(manager.display(), False);
    });
    const auto screen = make();
    mapping.join();
    show_for_certain(*screen);
    Window focus = 0;
    int revert = 0;
    XGetInputFocus(manager.display(), &focus, &revert);
    EXPECT_NE(focus, manager.window());
}

} // namespace
