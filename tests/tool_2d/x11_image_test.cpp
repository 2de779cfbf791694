// SPDX-License-Identifier: MIT
// x11_image: answers that come, come late or not at all; and words that change while they are sent.
#include "image_window.h"

#include <thread>
#include <vector>

#include <X11/extensions/XShm.h>

namespace {

using namespace l3d_detail;
using namespace std::chrono_literals;
using std::chrono::steady_clock;

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
