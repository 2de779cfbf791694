// SPDX-License-Identifier: MIT
// x11_visual: which visual is chosen, what is said if none will do; and a window on every one.
#include "onlooker_x11.h"

#include "tool_2d/image.h"
#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11/x11_window_p.h"

#include <algorithm>
#include <array>
#include <map>

namespace {

using namespace l3d_detail;
using enum l3d_color_class;

class visual_choice : public testing::Test {
protected:
    /// A visual that is never used, only told from others.
    x11_visual make_visual(std::size_t number, l3d_color_class color_class, l3d_pixel_layout layout,
                           int cells = 256) {
        layout.color_class = color_class;
        return {&visuals_[number], layout, cells};
    }
    Visual* visual(std::size_t number) { return &visuals_[number]; }

    /// What is chosen if entry `preferred` is the default; null if nothing is.
    Visual* choice(std::span<const x11_visual> offered, std::size_t preferred) {
        const auto chosen = choose_x11_visual(offered, visual(preferred), why_);
        return chosen ? chosen->visual : nullptr;
    }

    static constexpr l3d_pixel_layout deep{.depth = 32};
    static constexpr l3d_pixel_layout ten_bits{
        .depth = 30, .red_mask = 0x3FF00000, .green_mask = 0xFFC00, .blue_mask = 0x3FF};
    static constexpr l3d_pixel_layout sixteen{.depth = 16,
                                              .bits_per_pixel = 16,
                                              .red_mask = 0xF800,
                                              .green_mask = 0x07E0,
                                              .blue_mask = 0x001F};
    static constexpr l3d_pixel_layout eight{
        .depth = 8, .bits_per_pixel = 8, .red_mask = 0x07, .green_mask = 0x38, .blue_mask = 0xC0};
    static constexpr l3d_pixel_layout map{
        .depth = 8, .bits_per_pixel = 8, .red_mask = 0, .green_mask = 0, .blue_mask = 0};

    std::string why_;

private:
    std::array<Visual, 10> visuals_{};
};

TEST_F(visual_choice, the_default_if_it_loses_little) {
    for (const auto color_class : {true_color, direct_color}) {
        const std::array offered{make_visual(0, true_color, ten_bits),
                                 make_visual(1, color_class, sixteen),
                                 make_visual(2, true_color, {})};
        EXPECT_EQ(choice(offered, 1), visual(1));
    }
}

TEST_F(visual_choice, else_the_one_that_loses_least) {
    const std::array offered{
        make_visual(0, pseudo_color, map),    make_visual(1, true_color, sixteen),
        make_visual(2, direct_color, {}),     make_visual(3, true_color, {}),
        make_visual(4, true_color, ten_bits), make_visual(5, direct_color, ten_bits)};
    const std::array<std::size_t, 7> best{0, 0, 1, 2, 3, 4, 4};
    for (std::size_t count = 1; count < best.size(); ++count)
        EXPECT_EQ(choice(std::span(offered).first(count), 0), visual(best[count])) << count;
}

TEST_F(visual_choice, alpha_only_if_nothing_else_serves) {
    l3d_pixel_layout one_bit = map;
    one_bit.depth = one_bit.bits_per_pixel = 1;
    const std::array offered{make_visual(0, true_color, deep), make_visual(1, gray_scale, map),
                             make_visual(2, static_gray, one_bit, 2)};
    EXPECT_EQ(choice(offered, 0), visual(0));
    EXPECT_EQ(choice(offered, 1), visual(1));
    EXPECT_EQ(choice(offered, 2), visual(1));
    const std::array poorer{offered[0], offered[2]};
    EXPECT_EQ(choice(poorer, 2), visual(0));
}

/// All of these are likely to share one map in the hardware.
TEST_F(visual_choice, the_default_if_all_are_poor) {
    const std::array offered{
        make_visual(0, static_gray, map),  make_visual(1, gray_scale, map),
        make_visual(2, static_color, map), make_visual(3, pseudo_color, map),
        make_visual(4, true_color, eight), make_visual(5, direct_color, eight)};
    for (std::size_t i = 0; i < offered.size(); ++i)
        EXPECT_EQ(choice(offered, i), visual(i)) << i;
}

TEST_F(visual_choice, colours_if_the_default_will_not_do) {
    l3d_pixel_layout one_bit = map;
    one_bit.depth = one_bit.bits_per_pixel = 1;
    const std::array offered{make_visual(0, static_gray, one_bit, 2),
                             make_visual(1, gray_scale, map), make_visual(2, pseudo_color, map),
                             make_visual(3, true_color, eight)};
    EXPECT_EQ(choice(std::span(offered).first(2), 0), visual(1));
    EXPECT_EQ(choice(std::span(offered).first(3), 0), visual(2));
    EXPECT_EQ(choice(offered, 0), visual(3));
}

TEST_F(visual_choice, a_refusal_is_one_line) {
    l3d_pixel_layout nibbles = sixteen, gaps = sixteen, empty = sixteen, wide = map;
    nibbles.bits_per_pixel = 4;
    nibbles.byte_order = std::endian::big;
    gaps.red_mask = 0xA800;
    empty.green_mask = 0;
    wide.bits_per_pixel = 24;
    const std::array offered{
        make_visual(0, true_color, nibbles), make_visual(1, true_color, gaps),
        make_visual(2, direct_color, empty), make_visual(3, static_gray, map, 15),
        make_visual(4, pseudo_color, wide),  make_visual(5, pseudo_color, map, 4097)};
    EXPECT_EQ(choice(offered, 0), nullptr);
    EXPECT_EQ(why_, "no usable visual on this display; its default is TrueColor, depth 16, 4 bits "
                    "per pixel, high byte first, masks f800/7e0/1f; TrueColor or DirectColor of 8, "
                    "16, 24 or 32 bits per pixel would do, or a colormap of 16 to 4096 cells with "
                    "8 or 16");
    EXPECT_EQ(choice(offered, 3), nullptr);
    EXPECT_NE(why_.find("StaticGray, depth 8, 8 bits per pixel"), std::string::npos);
    EXPECT_EQ(why_.find('\n'), std::string::npos);
}

/// Writes the picture into the window, and returns how many of its pixels are not as they should
/// be. The window need not be on the screen: it has no ancestor but the root, which is viewable.
int wrong_pixels_after_put(const x11_window& window, const l3d_pixels& picture) {
    const auto& layout = window.info().layout();
    XImage* image =
        XCreateImage(window.display(), window.visual(), static_cast<unsigned>(layout.depth),
                     ZPixmap, 0, nullptr, static_cast<unsigned>(picture.width),
                     static_cast<unsigned>(picture.height), layout.scanline_pad, 0);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(image->bytes_per_line) *
                                    static_cast<std::size_t>(picture.height));
    pixel_writer(window.info())
        .write(picture, l3d_whole(picture.size()), picture.size(), bytes.data(),
               image->bytes_per_line);
    image->data = reinterpret_cast<char*>(bytes.data());
    XPutImage(window.display(), window.id(), window.graphics(), image, 0, 0, 0, 0,
              static_cast<unsigned>(picture.width), static_cast<unsigned>(picture.height));
    XSync(window.display(), False);
    image->data = nullptr;
    XDestroyImage(image);
    return wrong_pixels(onlooker(), picture, window.info());
}

class every_visual : public testing::TestWithParam<const char*> {};

/// Each visual of a display takes a window without an X error, and shows each word right; what
/// has alpha is opaque.
TEST_P(every_visual, serves) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server(GetParam());
    L3D_REQUIRE_SERVER(server);
    l3d_image picture({37, 23}, 41), black({37, 23}, 37);
    draw_random(picture.pixels(), seed);
    std::map<l3d_color_class, int> tried;
    int with_alpha = 0;
    // Visuals belong to a connection: the list is asked for anew, and its next entry tried.
    for (std::size_t next = 0;; ++next) {
        std::string why;
        auto connection = x11_connection::open(why);
        ASSERT_NE(connection, nullptr) << why;
        const auto offered = offered_x11_visuals(*connection);
        if (next == offered.size())
            break;
        l3d_service refusal;
        const auto window = x11_window::open(std::move(connection), offered[next],
                                             {picture.pixels().size(), "v"}, refusal);
        ASSERT_NE(window, nullptr) << refusal.why << "; " << offered[next].layout.describe();
        x11_error_trap trap(window->connection());
        window->map();
        XSync(window->display(), False);
        EXPECT_EQ(wrong_pixels(onlooker(), black.pixels(), window->info()), 0) << "background";
        EXPECT_EQ(wrong_pixels_after_put(*window, picture.pixels()), 0)
            << window->info().describe();
        EXPECT_EQ(trap.sync(), 0);
        ++tried[offered[next].layout.color_class];
        if (window->info().layout().depth == 32) {
            EXPECT_EQ(window->info().to_display(0x123456), 0xFF123456U);
            ++with_alpha;
        }
    }
    if (std::string(GetParam()).ends_with("x8"))
        EXPECT_EQ(tried.size(), 6U) << "classes";
    else
        EXPECT_TRUE(with_alpha > 0 && tried[true_color] > with_alpha && tried[direct_color] > 0);
}

INSTANTIATE_TEST_SUITE_P(servers, every_visual,
                         testing::Values("301x207x8", "301x207x15", "301x207x16", "301x207x24",
                                         "301x207x30"),
                         [](const auto& kind) {
                             return "depth_" + std::string(kind.param).substr(8);
                         });

/// A server whose screen is of one class.
struct screen_class {
    const char* screen;
    const char* number;
    l3d_color_class color_class;
};

class on_the_screen : public testing::TestWithParam<screen_class> {};

/// What a user sees: the screen's own pixels, through the map that the hardware uses. Nobody has
/// to put a window manager there for that.
TEST_P(on_the_screen, colours_are_near) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server(GetParam().screen, {"-cc", GetParam().number});
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    ASSERT_NE(screen, nullptr);
    const auto& info = screen->info();
    EXPECT_EQ(info.layout().color_class, GetParam().color_class) << info.describe();
    const auto picture = screen->pixels();
    draw_random(picture, seed);
    show_for_certain(*screen);

    const onlooker other;
    int count = 0, x = 0, y = 0;
    Window child = 0;
    Colormap* installed = XListInstalledColormaps(other.display(), other.root(), &count);
    ASSERT_EQ(count, 1);
    XTranslateCoordinates(other.display(), other.window(), other.root(), 0, 0, &x, &y, &child);
    XImage* root = XGetImage(other.display(), other.root(), x, y, odd_size.width, odd_size.height,
                             AllPlanes, ZPixmap);
    ASSERT_NE(root, nullptr);
    const bool ramp = info.has_palette() && info.palette().is_ramp();
    const auto gap = [&](int levels, l3d_channel channel) {
        return 255.0 / ((info.has_palette() ? levels : 1 << channel.width) - 1);
    };
    const std::array gaps{gap(info.palette().red, info.red()),
                          gap(ramp ? info.palette().red : info.palette().green, info.green()),
                          gap(ramp ? info.palette().red : info.palette().blue, info.blue())};
    for (int i = 0; i < 500; ++i) {
        const int at_x = i * 7 % odd_size.width, at_y = i % odd_size.height;
        const auto word = picture.row(at_y)[static_cast<std::size_t>(at_x)];
        XColor seen{};
        seen.pixel = other.pixel(*root, at_x, at_y);
        XQueryColor(other.display(), *installed, &seen);
        const std::array channels{seen.red, seen.green, seen.blue};
        for (std::size_t c = 0; c < 3; ++c) {
            const auto value = ramp ? l3d_screen_info::gray_of(word) : word >> (16 - 8 * c) & 255;
            // Levels are whole numbers of 255.
            EXPECT_LT(std::abs(channels[c] / 257.0 - value), gaps[c] + 0.5)
                << info.describe() << std::hex << ", " << word << ", channel " << c;
        }
    }
    XDestroyImage(root);
    XFree(installed);
}

INSTANTIATE_TEST_SUITE_P(servers, on_the_screen,
                         testing::Values(screen_class{"301x207x8", "0", static_gray},
                                         screen_class{"301x207x8", "1", gray_scale},
                                         screen_class{"301x207x8", "2", static_color},
                                         screen_class{"301x207x8", "3", pseudo_color},
                                         screen_class{"301x207x8", "4", true_color},
                                         screen_class{"301x207x8", "5", direct_color},
                                         screen_class{"301x207x16", "4", true_color},
                                         screen_class{"301x207x16", "5", direct_color},
                                         screen_class{"301x207x24", "4", true_color},
                                         screen_class{"301x207x24", "5", direct_color}),
                         [](const auto& kind) {
                             return std::string(l3d_name_of(kind.param.color_class)) + "_" +
                                    std::string(kind.param.screen).substr(8);
                         });

} // namespace
