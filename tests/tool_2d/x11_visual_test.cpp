// SPDX-License-Identifier: MIT
// x11_visual: which visual is chosen, what is said if none will do; and a window on every one.
#include "onlooker_x11.h"

#include "tool_2d/image.h"
#include "tool_2d/pixel_writer_p.h"
#include "tool_2d/x11_window_p.h"

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
        make_visual(0, pseudo_color, map),     make_visual(1, true_color, sixteen),
        make_visual(2, true_color, deep),      make_visual(3, direct_color, {}),
        make_visual(4, true_color, {}),        make_visual(5, true_color, ten_bits),
        make_visual(6, direct_color, ten_bits)};
    const std::array<std::size_t, 8> best{0, 0, 1, 2, 3, 4, 5, 5};
    for (std::size_t count = 1; count < best.size(); ++count)
        EXPECT_EQ(choice(std::span(offered).first(count), 0), visual(best[count])) << count;
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
    pixel_writer(window.info()).write(picture, picture.size(), bytes.data(), image->bytes_per_line);
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

} // namespace
