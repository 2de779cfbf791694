// SPDX-License-Identifier: MIT
// X11 windows: names, scale, and what several of a display's pixels for one of ours change.
#include "onlooker_x11.h"

#include "tool_2d/x11_window/x11_resolution_p.h"
#include "tool_2d/x11/x11_visual_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <utility>
#include <vector>

#include <X11/Xatom.h>

namespace {

using namespace l3d_detail;

std::unique_ptr<l3d_screen> make_scaled(int scale) {
    l3d_screen_request request{odd_size, "scaled"};
    request.scale = scale;
    l3d_service refusal;
    auto screen = l3d_screen_factory_ximage().create(request, refusal);
    EXPECT_NE(screen, nullptr) << refusal.why;
    return screen;
}

XWindowAttributes attributes_of(const onlooker& other) {
    XWindowAttributes attributes{};
    XGetWindowAttributes(other.display(), other.window(), &attributes);
    return attributes;
}

TEST(x11_window, tells_which_program_it_is) {
    const xvfb server("601x407x24");
    L3D_REQUIRE_SERVER(server);
    l3d_screen_request request{odd_size, "Чайник"};
    request.name = "kettle";
    l3d_service refusal;
    const auto screen = l3d_screen_factory_ximage().create(request, refusal);
    const onlooker other;
    EXPECT_EQ(other.property("WM_CLASS"), std::string("kettle\0L3d\0", 11));
    EXPECT_EQ(other.property("_NET_WM_NAME"), "Чайник");
    EXPECT_FALSE(other.property("WM_NAME").empty()) << "in whatever encoding has these letters";
    std::array<char, 256> machine{};
    gethostname(machine.data(), machine.size());
    EXPECT_EQ(late_property(*screen, other, "WM_CLIENT_MACHINE"), machine.data());
    XSizeHints size{};
    long supplied = 0;
    XGetWMNormalHints(other.display(), other.window(), &size, &supplied);
    EXPECT_EQ(size.flags & (PSize | PMinSize), PSize | PMinSize);
    EXPECT_EQ(size.width, odd_size.width);
    EXPECT_EQ(size.height, odd_size.height);
}

TEST(x11_window, has_an_icon_that_desktops_show) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make<l3d_screen_factory_ximage>();
    const onlooker other;
    const std::string bytes = late_property(*screen, other, "_NET_WM_ICON");
    std::vector<long> items(bytes.size() / sizeof(long)); // the first of them
    std::memcpy(items.data(), bytes.data(), bytes.size());
    ASSERT_GT(items.size(), 1000u);
    EXPECT_EQ(items[0], 48);
    EXPECT_EQ(items[1], 48);
    EXPECT_EQ(items[2], 0) << "the corner is transparent";
    const auto opaque =
        std::ranges::count_if(items, [](long item) { return (item >> 24 & 255) == 255; });
    EXPECT_GT(opaque, 200);
}

TEST(x11_window, pixels_are_squares_of_the_displays) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server("601x407x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make_scaled(3);
    const onlooker other;
    const auto native = attributes_of(other);
    EXPECT_EQ((l3d_size{native.width, native.height}), (l3d_size{3 * 141, 3 * 83}));
    ASSERT_EQ(screen->pixels().size(), odd_size);
    draw_random(screen->pixels(), seed);
    show_for_certain(*screen);
    XImage* shown =
        XGetImage(other.display(), other.window(), 0, 0, 3 * 141, 3 * 83, AllPlanes, ZPixmap);
    ASSERT_NE(shown, nullptr);
    int wrong = 0;
    for (int y = 0; y < 3 * 83; ++y)
        for (int x = 0; x < 3 * 141; ++x)
            wrong += other.pixel(*shown, x, y) !=
                     screen->pixels().row(y / 3)[static_cast<std::size_t>(x / 3)];
    XDestroyImage(shown);
    EXPECT_EQ(wrong, 0);
}

TEST(x11_window, events_are_in_our_pixels) {
    const xvfb server("601x407x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make_scaled(3);
    const onlooker other;
    drop_events(*screen);
    for (const auto& [native, ours] : {std::pair{l3d_size{301, 203}, l3d_size{101, 68}},
                                       {{300, 202}, {100, 68}},
                                       {{1, 2}, {1, 1}}}) {
        XResizeWindow(other.display(), other.window(), static_cast<unsigned>(native.width),
                      static_cast<unsigned>(native.height));
        XSync(other.display(), False);
        EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, ours);
        EXPECT_EQ(screen->pixels().size(), ours);
    }
    // A drag may leave the window on the left and at the top.
    for (const auto& [native, ours] :
         {std::pair{0, 0}, {2, 0}, {3, 1}, {200, 66}, {-1, -1}, {-3, -1}, {-4, -2}}) {
        other.send_motion(Button1Mask, native, 7);
        const auto motion = next(*screen, l3d_event_type::pointer_motion);
        EXPECT_EQ(motion->x, ours) << native;
        EXPECT_EQ(motion->y, 2);
        other.send_button(ButtonPress, 2, 7, native);
        EXPECT_EQ(next(*screen, l3d_event_type::button_press)->y, ours) << native;
    }
}

TEST(x11_window, a_size_that_x_cannot_count_is_refused) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    l3d_screen_request request{{16383, 5}, "wide"};
    request.scale = 3;
    l3d_service refusal;
    EXPECT_EQ(l3d_screen_factory_ximage().create(request, refusal), nullptr);
    EXPECT_EQ(refusal.how, l3d_service::level::not_here);
    EXPECT_EQ(refusal.why, "the X server does not make a window of 16383x5 at scale 3");
}

TEST(x11_window, an_error_of_the_server_is_a_refusal) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    std::string why;
    auto connection = x11_connection::open(why);
    auto visual = choose_x11_visual(*connection, why);
    ASSERT_TRUE(visual) << why;
    visual->layout.depth = 32; // not this visual's
    l3d_service refusal;
    EXPECT_EQ(x11_window::open(std::move(connection), *visual, {odd_size, "no"}, refusal), nullptr);
    EXPECT_EQ(refusal.how, l3d_service::level::not_here);
    EXPECT_EQ(refusal.why, "the X server does not make a window of 141x83");
}

/// The width of a picture that shall have this one, on a display with these resources.
int width_with(const onlooker& other, const std::string& resources, int width) {
    XChangeProperty(other.display(), other.root(), XA_RESOURCE_MANAGER, XA_STRING, 8,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(resources.data()),
                    static_cast<int>(resources.size()));
    XSync(other.display(), False);
    std::string why;
    const auto connection = x11_connection::open(why);
    return connection ? x11_picture_size(*connection, {{width, 11}, "asked"}).width : -1;
}

TEST(x11_scale, pictures_are_as_much_larger_as_the_display_is_finer) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const onlooker other;
    struct expectation {
        const char* resources;
        int width, larger;
    };
    for (const auto& [resources, width, larger] :
         std::vector<expectation>{{"", 100, 100},
                                  {"Xft.dpi:\t96\n", 100, 100},
                                  {"Xft.dpi:\t120\n", 100, 125},
                                  {"Xft.dpi:\t144\n", 100, 150},
                                  {"Xcursor.size: 24\nXft.dpi: 192\nXft.hinting: 1\n", 100, 200},
                                  {"*dpi: 288.5\n", 100, 301},
                                  {"Xft.dpi: 100000\n", 100, 800},
                                  {"Xft.dpi: 48\n", 100, 100},
                                  {"Xft.dpi: -192\n", 100, 100},
                                  {"Xft.dpi: nan\n", 100, 100},
                                  {"Xft.dpi: inf\n", 100, 800},
                                  {"Xft.dpi: large\n", 100, 100},
                                  {"Xft.dpi:\n", 100, 100},
                                  {"Xft.dpi: 384\n", 10000, 32767}, // X counts no further
                                  {"Xft.dpi: 384\n", 40000, 40000}})
        EXPECT_EQ(width_with(other, resources, width), larger) << resources;
}

TEST(x11_scale, a_program_that_asks_for_a_scale_gets_its_size) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const onlooker other;
    EXPECT_EQ(width_with(other, "Xft.dpi: 192\n", 100), 200);
    std::string why;
    const auto connection = x11_connection::open(why);
    l3d_screen_request request{odd_size, "asked"};
    for (const int scale : {1, 5, l3d_largest_scale}) {
        request.scale = scale;
        EXPECT_EQ(x11_scale(request), scale);
        EXPECT_EQ(x11_picture_size(*connection, request), odd_size);
    }
}

/// By the display's dots an inch, as far as larger pixels do not make up for them.
TEST(x11_scale, leaves_to_letters_what_pixels_do_not_make_up_for) {
    const xvfb server("601x407x24");
    L3D_REQUIRE_SERVER(server);
    const onlooker other;
    EXPECT_EQ(width_with(other, "Xft.dpi: 192\n", 100), 200);
    for (const auto& [scale, text] : {std::pair(0, 2.0), std::pair(1, 2.0), std::pair(3, 1.0)})
        EXPECT_EQ(make_scaled(scale)->text_scale(), text) << scale;
    EXPECT_EQ(width_with(other, "Xft.dpi: 120\n", 100), 125);
    EXPECT_EQ(make_scaled(0)->text_scale(), 1.25);
}

/// A text of settings: Net/Name is words, Xft/Color a colour, and then the dots an inch.
std::string settings_text(bool is_low_first, std::int32_t dots) {
    std::string text;
    const auto number = [&](std::uint32_t value, int bytes) {
        for (int i = 0; i < bytes; ++i)
            text += static_cast<char>(value >> 8 * (is_low_first ? i : bytes - 1 - i) & 255);
    };
    const auto name = [&](int type, const std::string& called) {
        number(static_cast<std::uint32_t>(type), 1);
        number(0, 1);
        number(static_cast<std::uint32_t>(called.size()), 2);
        text += called + std::string((4 - called.size() % 4) % 4, '\0');
        number(7, 4); // its serial
    };
    number(is_low_first ? 0 : 1, 1);
    number(0, 3);
    number(12, 4);
    number(3, 4);
    name(1, "Net/Name");
    number(5, 4);
    text += std::string("Words\0\0\0", 8);
    name(2, "Xft/Color");
    number(1, 4);
    number(2, 4);
    name(0, "Xft/DPI");
    number(static_cast<std::uint32_t>(dots), 4);
    return text;
}

TEST(x11_resolution, reads_settings_in_either_order_of_bytes) {
    for (const bool is_low_first : {true, false}) {
        EXPECT_EQ(xsettings_dpi(settings_text(is_low_first, 144 * 1024)), 144);
        EXPECT_EQ(xsettings_dpi(settings_text(is_low_first, 98304 + 512)), 96.5);
        EXPECT_EQ(xsettings_dpi(settings_text(is_low_first, -1)), std::nullopt);
    }
}

TEST(x11_resolution, settings_that_are_cut_off_say_nothing) {
    const std::string whole = settings_text(true, 144 * 1024);
    for (std::size_t size = 0; size < whole.size(); ++size)
        EXPECT_EQ(xsettings_dpi(whole.substr(0, size)), std::nullopt) << size;
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string broken = whole;
        broken[at] = static_cast<char>(0xFF);
        xsettings_dpi(broken); // says whatever it says, and reads nothing beyond the end
    }
}

} // namespace
