// SPDX-License-Identifier: MIT
// X11 windows: every pixel right on every display, refusals, and what other programs are told.
#include "onlooker_x11.h"

#include "tool_2d/x11_image_p.h"

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
                    server_kind{"direct_color_16", "301x207x16", {"-cc", "5"}, 32, 32},
                    server_kind{"palette_8", "301x207x8", {"-cc", "3"}, 8, 8},
                    server_kind{"depth_24", "301x207x24", {}, 24, 32},
                    server_kind{"direct_color_24", "301x207x24", {"-cc", "5"}, 24, 32},
                    server_kind{"depth_30", "301x207x30", {}, 30, 32}),
    [](const auto& kind) { return std::string(kind.param.name); });

/// Every TrueColor visual of a display, with alpha too, takes a window and shows it right.
TEST(screen_x11, every_visual_serves) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const onlooker other;
    std::size_t tried = 0, with_alpha = 0;
    std::string why;
    // Visuals belong to a connection: the list is asked for anew, and its next entry tried.
    for (std::size_t next = 0;; ++next) {
        auto connection = x11_connection::open(why);
        ASSERT_NE(connection, nullptr) << why;
        const auto offered = offered_x11_visuals(*connection);
        if (next == offered.size())
            break;
        const auto visual = offered[next];
        if (visual.color_class != TrueColor)
            continue;
        const auto window = x11_window::open(std::move(connection), visual, {odd_size, "v"}, why);
        ASSERT_NE(window, nullptr) << why;
        const auto image = make_x11_image_put(*window, odd_size);
        draw_random(image->pixels(), seed);
        window->map();
        image->put();
        XSync(window->display(), False);
        EXPECT_EQ(wrong_pixels(other, image->pixels(), window->info()), 0) << visual.layout.depth;
        ++tried;
        with_alpha += window->info().opaque_bits() != 0;
    }
    EXPECT_GT(tried, with_alpha);
    EXPECT_GT(with_alpha, 0U);
}

class visual_choice : public testing::Test {
protected:
    /// A visual that is never used, only told from others.
    x11_visual make_visual(std::size_t number, int color_class, const l3d_pixel_layout& layout) {
        return {&visuals_[number], color_class, layout};
    }
    Visual* visual(std::size_t number) { return &visuals_[number]; }

    static constexpr l3d_pixel_layout deep{.depth = 32};
    static constexpr l3d_pixel_layout ten_bits{
        .depth = 30, .red_mask = 0x3FF00000, .green_mask = 0xFFC00, .blue_mask = 0x3FF};
    static constexpr l3d_pixel_layout sixteen{.depth = 16,
                                              .bits_per_pixel = 16,
                                              .red_mask = 0xF800,
                                              .green_mask = 0x07E0,
                                              .blue_mask = 0x001F};
    static constexpr l3d_pixel_layout palette{
        .depth = 8, .bits_per_pixel = 8, .red_mask = 0, .green_mask = 0, .blue_mask = 0};

private:
    std::array<Visual, 8> visuals_{};
};

TEST_F(visual_choice, the_default_if_it_can_serve) {
    const std::array offered{make_visual(0, TrueColor, {}), make_visual(1, TrueColor, sixteen)};
    std::string why;
    EXPECT_EQ(choose_x11_visual(offered, visual(1), why)->visual, visual(1));
}

TEST_F(visual_choice, else_the_one_that_loses_least) {
    const std::array offered{
        make_visual(0, PseudoColor, palette), make_visual(1, TrueColor, sixteen),
        make_visual(2, TrueColor, deep),      make_visual(3, TrueColor, {}),
        make_visual(4, TrueColor, ten_bits),  make_visual(5, DirectColor, ten_bits)};
    std::string why;
    const auto best_of = [&](std::size_t count) {
        return choose_x11_visual(std::span(offered).first(count), visual(0), why)->visual;
    };
    EXPECT_EQ(best_of(2), visual(1));
    EXPECT_EQ(best_of(3), visual(2));
    EXPECT_EQ(best_of(4), visual(3));
    EXPECT_EQ(best_of(6), visual(4));
}

TEST_F(visual_choice, a_refusal_is_one_line) {
    l3d_pixel_layout nibbles = sixteen, gaps = sixteen, empty = sixteen;
    nibbles.bits_per_pixel = 4;
    gaps.red_mask = 0xA800;
    empty.green_mask = 0;
    const std::array offered{make_visual(0, TrueColor, nibbles), make_visual(1, TrueColor, gaps),
                             make_visual(2, TrueColor, empty), make_visual(3, DirectColor, {}),
                             make_visual(4, PseudoColor, palette)};
    std::string why;
    EXPECT_FALSE(choose_x11_visual(offered, visual(4), why));
    EXPECT_EQ(why, "no usable TrueColor visual on this display; its default is PseudoColor, "
                   "depth 8, masks 0/0/0");
    EXPECT_FALSE(choose_x11_visual(offered, visual(3), why));
    EXPECT_EQ(why, "no usable TrueColor visual on this display; its default is DirectColor, "
                   "depth 24, masks ff0000/ff00/ff");
}

TEST(screen_x11, says_which_display_is_not_there) {
    const l3d_screen_factory_ximage factory;
    l3d_service refusal;
    unsetenv("DISPLAY");
    EXPECT_EQ(factory.service().how, l3d_service::level::no_display);
    EXPECT_EQ(factory.service().why, "DISPLAY is not set");
    for (const char* name : {":987", "nonsense", ":", "unix:987.3"}) {
        setenv("DISPLAY", name, 1);
        EXPECT_EQ(factory.service().how, l3d_service::level::no_display);
        EXPECT_EQ(factory.service().why,
                  std::string("cannot open the display that DISPLAY names, '") + name + "'");
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
    std::memcpy(&process, other.property("_NET_WM_PID").data(), sizeof process);
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
