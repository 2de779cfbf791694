// SPDX-License-Identifier: MIT
// x11_image: answers that come, come late or not at all; what travels over a network; and words
// that change while they are sent.
#include "onlooker_x11.h"

#include "tool_2d/image.h"
#include "tool_2d/x11/x11_image_p.h"

#include <thread>
#include <vector>

#include <linux/tcp.h>
#include <netinet/in.h>

#include <X11/extensions/XShm.h>

namespace {

using namespace l3d_detail;
using namespace std::chrono_literals;
using std::chrono::steady_clock;

constexpr l3d_size large{1021, 763};

/// A window on the screen.
std::unique_ptr<x11_window> open_window(l3d_size size) {
    l3d_service refusal;
    auto connection = x11_connection::open(refusal.why);
    if (!connection)
        return nullptr;
    const auto visual = choose_x11_visual(*connection, refusal.why);
    auto window = x11_window::open(std::move(connection), *visual, {size, "image"}, refusal);
    EXPECT_NE(window, nullptr) << refusal.why;
    window->map();
    XSync(window->display(), False);
    return window;
}

/// Hands all events that the server sent so far to the image. How many it took.
int give_events(const x11_window& window, x11_image& image, int but_none_of_type = 0) {
    int taken = 0;
    XSync(window.display(), False);
    while (XPending(window.display()) > 0) {
        XEvent event;
        XNextEvent(window.display(), &event);
        if (event.type != but_none_of_type)
            taken += image.take(event);
    }
    return taken;
}

l3d_image random_picture(l3d_size size, unsigned seed) {
    l3d_image picture(size, size.width);
    draw_random(picture.pixels(), seed);
    return picture;
}

TEST(x11_image, answers_to_an_image_that_was_replaced_are_ignored) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto window = open_window(odd_size);
    auto picture = random_picture(odd_size, 8);
    std::string why;
    const auto shared = [&] { return make_x11_image_shm(*window, odd_size, why); };
    const auto wired = [&] { return make_x11_image_put(*window, odd_size); };
    for (const bool was_shared : {false, true}) {
        for (const bool is_shared : {false, true}) {
            auto before = was_shared ? shared() : wired();
            ASSERT_NE(before, nullptr) << why;
            before->put(picture.pixels(), l3d_whole(picture.pixels().size()),
                        steady_clock::now() + patience);
            XSync(window->display(), False);
            before.reset();
            const auto after = is_shared ? shared() : wired();
            EXPECT_EQ(give_events(*window, *after), 0);
            after->put(picture.pixels(), l3d_whole(picture.pixels().size()),
                       steady_clock::now() + patience);
            EXPECT_FALSE(after->is_idle());
            EXPECT_EQ(give_events(*window, *after), 1) << was_shared << is_shared;
            EXPECT_TRUE(after->is_idle());
        }
    }
}

TEST(x11_image, an_old_answer_is_not_taken_for_a_new_one) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto window = open_window(odd_size);
    auto picture = random_picture(odd_size, 8);
    auto image = make_x11_image_put(*window, odd_size);
    image->put(picture.pixels(), l3d_whole(picture.pixels().size()),
               steady_clock::now() + patience);
    image = make_x11_image_put(*window, odd_size);
    image->put(picture.pixels(), l3d_whole(picture.pixels().size()),
               steady_clock::now() + patience);
    std::vector<bool> taken;
    XSync(window->display(), False);
    while (XPending(window->display()) > 0) {
        XEvent event;
        XNextEvent(window->display(), &event);
        if (event.type == ClientMessage)
            taken.push_back(image->take(event));
    }
    EXPECT_EQ(taken, (std::vector{false, true}));
}

TEST(x11_image, no_buffer_is_free_before_the_server_has_read_it) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto window = open_window(odd_size);
    auto picture = random_picture(odd_size, 8);
    std::string why;
    const auto shared = make_x11_image_shm(*window, odd_size, why);
    ASSERT_NE(shared, nullptr) << why;
    const auto wired = make_x11_image_put(*window, odd_size);
    server.pause();
    const auto puts_until_full = [&](x11_image& image) {
        int count = 0;
        while (image.is_free()) {
            image.put(picture.pixels(), l3d_whole(picture.pixels().size()), {});
            ++count;
        }
        return count;
    };
    EXPECT_EQ(puts_until_full(*shared), 2);
    EXPECT_EQ(puts_until_full(*wired), 1);
    server.resume();
    // All answers are there, and each image takes its own.
    XSync(window->display(), False);
    int by_shared = 0, by_wired = 0;
    while (XPending(window->display()) > 0) {
        XEvent event;
        XNextEvent(window->display(), &event);
        by_shared += shared->take(event);
        by_wired += wired->take(event);
    }
    EXPECT_EQ(by_shared, 2);
    EXPECT_EQ(by_wired, 1);
    EXPECT_TRUE(shared->is_free() && wired->is_free());
}

TEST(x11_image, a_server_that_forgets_to_tell_is_found_out) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto window = open_window(odd_size);
    auto picture = random_picture(odd_size, 8);
    const int completion = XShmGetEventBase(window->display()) + ShmCompletion;
    for (const bool forgets : {false, true}) {
        std::string why;
        const auto image = make_x11_image_shm(*window, odd_size, why);
        ASSERT_NE(image, nullptr) << why;
        image->put(picture.pixels(), l3d_whole(picture.pixels().size()), {});
        image->look_after();
        if (forgets) {
            EXPECT_EQ(give_events(*window, *image, completion), 0) << "asked too early";
        }
        std::this_thread::sleep_for(1100ms);
        image->look_after();
        image->look_after();
        EXPECT_EQ(give_events(*window, *image, forgets ? completion : 0), forgets ? 1 : 2);
        EXPECT_EQ(image->has_failed(why), forgets);
        EXPECT_EQ(why, forgets ? "the X server does not say when it has read a picture" : "");
    }
}

TEST(x11_image, a_picture_that_is_refused_is_found_out) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto window = open_window(odd_size);
    auto picture = random_picture(odd_size, 8);
    std::string why;
    const auto image = make_x11_image_shm(*window, odd_size, why);
    ASSERT_NE(image, nullptr) << why;
    // An error of another request is none of ours.
    XMapWindow(window->display(), 0x1234);
    image->put(picture.pixels(), l3d_whole(picture.pixels().size()), {});
    give_events(*window, *image);
    EXPECT_FALSE(image->has_failed(why)) << why;
    XDestroyWindow(window->display(), window->id());
    image->put(picture.pixels(), l3d_whole(picture.pixels().size()), {});
    give_events(*window, *image);
    EXPECT_TRUE(image->has_failed(why));
    EXPECT_EQ(why, "the X server refused a picture: BadDrawable (invalid Pixmap or Window "
                   "parameter)");
}

/// Bytes that have left for the server.
std::uint64_t bytes_sent(const x11_window& window) {
    XSync(window.display(), False);
    tcp_info info{};
    socklen_t size = sizeof info;
    getsockopt(ConnectionNumber(window.display()), IPPROTO_TCP, TCP_INFO, &info, &size);
    return info.tcpi_bytes_acked;
}

class x11_image_network : public testing::Test {
protected:
    void SetUp() override {
        L3D_REQUIRE_SERVER(server_);
        setenv("DISPLAY", ("127.0.0.1" + server_.display()).c_str(), 1);
        window_ = open_window(large);
        if (!window_)
            GTEST_SKIP() << "Xvfb does not listen to TCP here";
        image_ = make_x11_image_put(*window_, large);
    }

    /// Sends the picture, and returns how many bytes that took.
    std::uint64_t put(const l3d_pixels& picture) {
        const auto before = bytes_sent(*window_);
        image_->put(picture, l3d_whole(picture.size()), steady_clock::now() + patience);
        give_events(*window_, *image_);
        EXPECT_TRUE(image_->is_idle());
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
    EXPECT_GE(put(pixels), frame_bytes) << "the first is whole";
    EXPECT_LT(put(pixels), 1000U) << "nothing changed";
    // As high as a line of text, in the middle of nowhere.
    for (int y = 411; y < 411 + 16; ++y)
        std::ranges::fill(pixels.row(y).subspan(317, 200), 0xFFFFFF);
    EXPECT_LT(put(pixels), frame_bytes / 20);
    EXPECT_EQ(wrong_pixels(other, pixels, window_->info()), 0);
    image_->forget_shown();
    EXPECT_GE(put(pixels), frame_bytes) << "the window was covered";
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
    for (int change = 0; change < 20; ++change) {
        for (int pixel = below(5); pixel > 0; --pixel)
            picture.pixels().row(below(
                large.height))[static_cast<std::size_t>(below(large.width))] ^= 1U << below(24);
        put(picture.pixels());
        ASSERT_EQ(wrong_pixels(other, picture.pixels(), window_->info()), 0) << change;
    }
}

/// A part of a picture, at random, and other words in some of it.
l3d_pixel_box changed_part(const l3d_pixels& pixels, std::mt19937& random) {
    const auto below = [&](int end) {
        return static_cast<int>(random() % static_cast<unsigned>(end));
    };
    const int left = below(pixels.width), top = below(pixels.height);
    const l3d_pixel_box part{left, top, left + 1 + below(std::min(90, pixels.width - left)),
                             top + 1 + below(std::min(70, pixels.height - top))};
    for (int y = part.top; y < part.bottom; ++y)
        for (std::uint32_t& word : l3d_row(pixels, y, part))
            word ^= below(3) == 0 ? 0x010203U << below(16) & 0xFFFFFF : 0;
    return part;
}

/// Buffers of shared memory take turns, and each has missed what the other took.
TEST(x11_image, parts_make_the_picture) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto window = open_window(odd_size);
    const onlooker other;
    for (const bool shared : {false, true}) {
        std::string why;
        const auto image = shared ? make_x11_image_shm(*window, odd_size, why)
                                  : make_x11_image_put(*window, odd_size);
        ASSERT_NE(image, nullptr) << why;
        auto picture = random_picture(odd_size, seed);
        image->put(picture.pixels(), l3d_whole(odd_size), steady_clock::now() + patience);
        for (int change = 0; change < 60; ++change) {
            if (!image->is_free() || random() % 3 == 0)
                give_events(*window, *image);
            image->put(picture.pixels(), changed_part(picture.pixels(), random),
                       steady_clock::now() + patience);
            XSync(window->display(), False);
            ASSERT_EQ(wrong_pixels(other, picture.pixels(), window->info()), 0)
                << shared << ' ' << change;
        }
    }
}

TEST_F(x11_image_network, a_part_costs_in_proportion) {
    auto picture = random_picture(large, 3);
    put(picture.pixels());
    const l3d_pixel_box part{317, 411, 317 + 64, 411 + 48};
    for (int y = part.top; y < part.bottom; ++y)
        std::ranges::fill(l3d_row(picture.pixels(), y, part), 0xFFFFFF);
    const auto before = bytes_sent(*window_);
    image_->put(picture.pixels(), part, steady_clock::now() + patience);
    give_events(*window_, *image_);
    EXPECT_LT(bytes_sent(*window_) - before, 4U * 72 * 48 + 1000);
}

TEST(x11_image, words_may_change_while_the_rest_is_under_way) {
    const xvfb server("1100x800x24");
    L3D_REQUIRE_SERVER(server);
    const auto window = open_window(large);
    const auto image = make_x11_image_put(*window, large);
    auto picture = random_picture(large, 3);
    server.pause();
    image->put(picture.pixels(), l3d_whole(picture.pixels().size()), {});
    EXPECT_TRUE(image->is_sending()) << "larger than what a connection holds";
    EXPECT_FALSE(image->is_free());
    draw_random(picture.pixels(), 4);
    server.resume();
    const auto deadline = steady_clock::now() + patience;
    while (image->is_sending() && window->connection().wait_ready(deadline))
        image->look_after();
    EXPECT_EQ(give_events(*window, *image), 1);
    EXPECT_TRUE(image->is_free());
    const onlooker other;
    auto expected = random_picture(large, 3);
    EXPECT_EQ(wrong_pixels(other, expected.pixels(), window->info()), 0);
}

} // namespace
