// SPDX-License-Identifier: MIT
// A window without a screen's loop, for the tests of images.
#ifndef L3D_TEST_TOOL_2D_IMAGE_WINDOW_H
#define L3D_TEST_TOOL_2D_IMAGE_WINDOW_H

#include "onlooker_x11.h"

#include "tool_2d/image.h"
#include "tool_2d/x11/x11_image_p.h"

inline constexpr l3d_size large{1021, 763};

/// A window on the screen.
inline std::unique_ptr<l3d_detail::x11_window> open_window(l3d_size size) {
    l3d_service refusal;
    using namespace l3d_detail;
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
inline int give_events(const l3d_detail::x11_window& window, l3d_detail::x11_image& image,
                       int but_none_of_type = 0) {
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

inline l3d_image random_picture(l3d_size size, unsigned seed) {
    l3d_image picture(size);
    draw_random(picture.pixels(), seed);
    return picture;
}

#endif
