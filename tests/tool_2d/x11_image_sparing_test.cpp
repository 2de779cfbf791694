// SPDX-License-Identifier: MIT
// x11_image over a slow line: what travels, what is shown meanwhile, and what in the end.
#include "image_window.h"

#include "tool_2d/x11/x11_tiles_p.h"

#include <thread>

#include <linux/tcp.h>
#include <netinet/in.h>

namespace {

using namespace l3d_detail;
using std::chrono::steady_clock;

/// Bytes that have left for the server.
std::uint64_t bytes_sent(const x11_window& window) {
    XSync(window.display(), False);
    tcp_info info{};
    socklen_t size = sizeof info;
    getsockopt(ConnectionNumber(window.display()), IPPROTO_TCP, TCP_INFO, &info, &size);
    return info.tcpi_bytes_acked;
}

void put_part(const x11_window& window, x11_image& image, const l3d_pixels& picture,
              const l3d_pixel_box& part) {
    image.put(picture, part, steady_clock::now() + patience);
    give_events(window, image);
    EXPECT_TRUE(image.is_idle());
}

/// Comes to rest, until all is fine.
void rest(const x11_window& window, x11_image& image) {
    while (image.next_look() != x11_image::time_point::max()) {
        std::this_thread::sleep_until(image.next_look());
        image.look_after();
        give_events(window, image);
        ASSERT_TRUE(image.is_idle());
    }
}

class x11_image_network : public testing::Test {
protected:
    void SetUp() override {
        L3D_REQUIRE_SERVER(server_);
        setenv("DISPLAY", ("127.0.0.1" + server_.display()).c_str(), 1);
        window_ = open_window(large);
        if (!window_)
            GTEST_SKIP() << "Xvfb does not listen to TCP here";
        image_ = make_x11_image_sparing(*window_, large);
    }

    /// Sends a part of the picture, and returns how many bytes that took.
    std::uint64_t put(const l3d_pixels& picture, const l3d_pixel_box& part = l3d_whole(large)) {
        const auto before = bytes_sent(*window_);
        put_part(*window_, *image_, picture, part);
        return bytes_sent(*window_) - before;
    }

    std::uint64_t come_to_rest() {
        const auto before = bytes_sent(*window_);
        rest(*window_, *image_);
        return bytes_sent(*window_) - before;
    }

    static constexpr std::uint64_t frame_bytes = 4ULL * large.width * large.height;

    xvfb server_{"1100x800x24", {"-ac", "-listen", "tcp"}};
    std::unique_ptr<x11_window> window_;
    std::unique_ptr<x11_image> image_;
};

TEST_F(x11_image_network, only_what_changed_travels) {
    const onlooker other;
    auto picture = random_picture(large, 3);
    const auto pixels = picture.pixels();
    EXPECT_LT(put(pixels), frame_bytes / 14)
        << "a sixteenth of the pixels, and how to enlarge them";
    EXPECT_GE(come_to_rest(), frame_bytes) << "then all are fine";
    EXPECT_EQ(wrong_pixels(other, pixels, window_->info()), 0);
    EXPECT_LT(put(pixels), 1000U) << "nothing changed";
    EXPECT_LT(come_to_rest(), 1000U);
    // As high as a line of text, in the middle of nowhere, and another far from it.
    for (int y = 411; y < 411 + 16; ++y) {
        std::ranges::fill(pixels.row(y).subspan(17, 200), 0xFFFFFF);
        std::ranges::fill(pixels.row(y).subspan(800, 200), 0xFFFFFF);
    }
    const auto sent = put(pixels);
    EXPECT_GE(sent, 2U * 200 * 16 * 4);
    EXPECT_LT(sent, 2U * 200 * 16 * 4 + 1000);
    EXPECT_EQ(wrong_pixels(other, pixels, window_->info()), 0) << "little is fine at once";
    image_->forget_shown();
    EXPECT_GE(put(pixels) + come_to_rest(), frame_bytes) << "the window was covered";
}

TEST_F(x11_image_network, what_makes_it_fine_goes_in_pieces) {
    auto picture = random_picture(large, 3);
    put(picture.pixels());
    EXPECT_LT(image_->next_look(), x11_image::time_point::max());
    std::this_thread::sleep_until(image_->next_look());
    const auto before = bytes_sent(*window_);
    image_->look_after();
    EXPECT_FALSE(image_->is_free()) << "another picture waits for this one piece";
    give_events(*window_, *image_);
    EXPECT_TRUE(image_->is_free());
    constexpr auto tile = 4U * x11_tiles::width * x11_tiles::height;
    EXPECT_LT(bytes_sent(*window_) - before, 80'000U + tile + 1000);
    // A picture comes first, and what was coarse becomes fine after it, as it is then.
    draw_random(picture.pixels(), 4);
    EXPECT_LT(put(picture.pixels()), frame_bytes / 14);
    come_to_rest();
    EXPECT_EQ(wrong_pixels(onlooker(), picture.pixels(), window_->info()), 0);
}

TEST_F(x11_image_network, every_change_arrives) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto below = [&](int end) {
        return static_cast<int>(random() % static_cast<unsigned>(end));
    };
    const onlooker other;
    auto picture = random_picture(large, seed);
    put(picture.pixels());
    come_to_rest();
    for (int change = 0; change < 20; ++change) {
        for (int pixel = below(5); pixel > 0; --pixel)
            picture.pixels().row(below(
                large.height))[static_cast<std::size_t>(below(large.width))] ^= 1U << below(24);
        put(picture.pixels());
        ASSERT_EQ(wrong_pixels(other, picture.pixels(), window_->info()), 0) << change;
    }
}

TEST_F(x11_image_network, a_part_costs_in_proportion) {
    auto picture = random_picture(large, 3);
    put(picture.pixels());
    come_to_rest();
    const l3d_pixel_box part{317, 411, 317 + 64, 411 + 48};
    for (int y = part.top; y < part.bottom; ++y)
        std::ranges::fill(l3d_row(picture.pixels(), y, part), 0xFFFFFF);
    EXPECT_LT(put(picture.pixels(), part), 4U * 72 * 48 + 1000);
}

/// The slow twin: each pixel asks for the mean of its square.
l3d_image in_squares(const l3d_pixels& picture, int side) {
    l3d_image coarse(picture.size(), picture.width);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const l3d_pixel_box square =
                l3d_pixel_box{x / side, y / side, x / side + 1, y / side + 1}
                    .scaled(side)
                    .intersected(l3d_whole(picture.size()));
            std::uint32_t mean = 0;
            for (const int shift : {0, 8, 16}) {
                double sum = 0;
                for (int v = square.top; v < square.bottom; ++v)
                    for (int u = square.left; u < square.right; ++u)
                        sum += picture.row(v)[static_cast<std::size_t>(u)] >> shift & 255;
                mean |= static_cast<std::uint32_t>(sum / static_cast<double>(square.area()) + 0.5)
                        << shift;
            }
            coarse.pixels().row(y)[static_cast<std::size_t>(x)] = mean;
        }
    }
    return coarse;
}

TEST(x11_image_sparing, coarse_pictures_show_means_of_squares) {
    struct kind {
        l3d_size size;
        int side;
    };
    // 80 000 bytes are 20 000 pixels: so many squares at most, but for the last one.
    for (const kind each : {kind{{141, 83}, 1}, {{203, 151}, 2}, {{501, 379}, 4}, {large, 4}}) {
        const xvfb server("1100x800x24");
        L3D_REQUIRE_SERVER(server);
        const auto window = open_window(each.size);
        const auto image = make_x11_image_sparing(*window, each.size);
        auto picture = random_picture(each.size, 5);
        put_part(*window, *image, picture.pixels(), l3d_whole(each.size));
        auto wanted = in_squares(picture.pixels(), each.side);
        EXPECT_EQ(wrong_pixels(onlooker(), wanted.pixels(), window->info()), 0) << each.side;
        rest(*window, *image);
        EXPECT_EQ(wrong_pixels(onlooker(), picture.pixels(), window->info()), 0) << each.side;
    }
}

/// A random picture that was sent, coarse.
class x11_sent_picture : public testing::Test {
protected:
    void SetUp() override {
        L3D_REQUIRE_SERVER(server_);
        window_ = open_window(large);
        image_ = make_x11_image_sparing(*window_, large);
        put_part(*window_, *image_, pixels_, l3d_whole(large));
    }

    const xvfb server_{"1100x800x24"};
    std::unique_ptr<x11_window> window_;
    std::unique_ptr<x11_image> image_;
    l3d_image picture_ = random_picture(large, 5);
    const l3d_pixels pixels_ = picture_.pixels();
};

TEST_F(x11_sent_picture, what_stands_still_beside_what_moves_stays_fine) {
    const onlooker other;
    rest(*window_, *image_);
    // Two parts that move; between them nothing does.
    auto wanted = random_picture(large, 5);
    auto moved = random_picture(large, 6);
    auto squares = in_squares(moved.pixels(), 2);
    for (const l3d_pixel_box& part : {l3d_pixel_box{64, 64, 192, 192}, {320, 256, 448, 384}}) {
        for (int y = part.top; y < part.bottom; ++y) {
            std::ranges::copy(l3d_row(moved.pixels(), y, part), l3d_row(pixels_, y, part).begin());
            std::ranges::copy(l3d_row(squares.pixels(), y, part),
                              l3d_row(wanted.pixels(), y, part).begin());
        }
    }
    put_part(*window_, *image_, pixels_, l3d_whole(large));
    EXPECT_EQ(wrong_pixels(other, wanted.pixels(), window_->info()), 0);
    rest(*window_, *image_);
    EXPECT_EQ(wrong_pixels(other, pixels_, window_->info()), 0);
}

/// Without a rest: the next pictures, in which little changes, have room for it.
TEST_F(x11_sent_picture, what_has_come_to_rest_becomes_fine_beside_what_moves) {
    const auto pieces = 4 * large.width * large.height / 80'000 + 1;
    for (int i = 0; i < 2 * pieces && image_->next_look() != x11_image::time_point::max(); ++i) {
        const l3d_pixel_box part{320, 256, 352, 272};
        for (int y = part.top; y < part.bottom; ++y)
            for (std::uint32_t& word : l3d_row(pixels_, y, part))
                word ^= 0xFFFFFF;
        put_part(*window_, *image_, pixels_, part);
    }
    EXPECT_EQ(image_->next_look(), x11_image::time_point::max());
    EXPECT_EQ(wrong_pixels(onlooker(), pixels_, window_->info()), 0);
}

/// Changes at random all that lies beside a box.
void draw_beside(const l3d_pixels& picture, const l3d_pixel_box& box, unsigned seed) {
    auto other = random_picture(picture.size(), seed);
    for (int y = box.top; y < box.bottom; ++y)
        std::ranges::copy(l3d_row(picture, y, box), l3d_row(other.pixels(), y, box).begin());
    for (int y = 0; y < picture.height; ++y)
        std::ranges::copy(other.pixels().row(y), picture.row(y).begin());
}

/// How many pixels of a box are not as in the picture.
int wrong_pixels_in(const l3d_pixels& picture, const l3d_pixel_box& box, const x11_window& window) {
    const onlooker other;
    auto none = random_picture(picture.size(), 99);
    int wrong_beside = wrong_pixels(other, none.pixels(), window.info());
    for (int y = box.top; y < box.bottom; ++y)
        std::ranges::copy(l3d_row(picture, y, box), l3d_row(none.pixels(), y, box).begin());
    return static_cast<int>(box.area()) -
           (wrong_beside - wrong_pixels(other, none.pixels(), window.info()));
}

/// More moves beside than has room even with a sixteenth of the pixels.
TEST_F(x11_sent_picture, what_has_come_to_rest_becomes_fine_however_much_moves) {
    const l3d_pixel_box resting{800, 96, 992, 496}; // whole tiles
    EXPECT_GT(wrong_pixels_in(pixels_, resting, *window_), 1000);
    const auto puts = static_cast<unsigned>(6 * resting.area() / 20'000);
    for (unsigned i = 0; i < puts; ++i) {
        draw_beside(pixels_, resting, 100 + i);
        put_part(*window_, *image_, pixels_, l3d_whole(large));
    }
    EXPECT_EQ(wrong_pixels_in(pixels_, resting, *window_), 0);
}

/// A panel: a ground, and something on it in every third row.
void draw_text(const l3d_pixels& picture, const l3d_pixel_box& box, unsigned seed) {
    std::mt19937 random(seed);
    for (int y = box.top; y < box.bottom; ++y)
        for (std::uint32_t& word : l3d_row(picture, y, box))
            word = y % 24 < 8 ? static_cast<std::uint32_t>(random() & 0xFFFFFF) : 0x12161B;
}

TEST_F(x11_sent_picture, text_is_fine_at_once_and_stays_so_while_all_else_moves) {
    const l3d_pixel_box text{101, 53, 301, 203}; // across cells and tiles
    image_->set_text({text});
    draw_text(pixels_, text, 7);
    for (unsigned i = 0; i < 5; ++i) {
        image_->set_text({text});
        draw_beside(pixels_, text, 100 + i);
        put_part(*window_, *image_, pixels_, l3d_whole(large));
        EXPECT_EQ(wrong_pixels_in(pixels_, text, *window_), 0) << i;
    }
    rest(*window_, *image_);
    EXPECT_EQ(wrong_pixels(onlooker(), pixels_, window_->info()), 0);
    // Where text goes away, the picture below moves again.
    image_->set_text({});
    draw_random(pixels_, 8);
    put_part(*window_, *image_, pixels_, l3d_whole(large));
    rest(*window_, *image_);
    EXPECT_EQ(wrong_pixels(onlooker(), pixels_, window_->info()), 0);
}

TEST_F(x11_image_network, much_text_goes_alone_and_its_ground_costs_nothing) {
    auto picture = random_picture(large, 5);
    put(picture.pixels());
    come_to_rest();
    const l3d_pixel_box text{100, 50, 500, 650};
    image_->set_text({text});
    draw_text(picture.pixels(), text, 7);
    draw_beside(picture.pixels(), text, 9);
    std::uint64_t sent = 0;
    int puts = 0;
    for (; wrong_pixels_in(picture.pixels(), text, *window_) > 0 && puts < 50; ++puts) {
        image_->set_text({text}); // as each picture does
        sent += put(picture.pixels());
    }
    EXPECT_GT(puts, 1) << "in pieces";
    EXPECT_LT(sent, 4U * static_cast<std::uint64_t>(text.area()) * 3 / 4 + 80'000);
    come_to_rest();
    EXPECT_EQ(wrong_pixels(onlooker(), picture.pixels(), window_->info()), 0);
}

TEST(x11_image_sparing, every_kind_of_display_shows_the_picture_in_the_end) {
    for (const char* const screen : {"1100x800x8", "1100x800x15", "1100x800x16", "1100x800x30"}) {
        const xvfb server(screen);
        L3D_REQUIRE_SERVER(server);
        const auto window = open_window(large);
        const auto image = make_x11_image_sparing(*window, large);
        auto picture = random_picture(large, 7);
        put_part(*window, *image, picture.pixels(), l3d_whole(large));
        rest(*window, *image);
        EXPECT_EQ(wrong_pixels(onlooker(), picture.pixels(), window->info()), 0) << screen;
    }
}

} // namespace
