// SPDX-License-Identifier: MIT
// bare_x11: windows drawn with nothing but Xlib, the peers of our screens; and one that looks at
// both.
#ifndef L3D_TEST_BENCH_BARE_X11_H
#define L3D_TEST_BENCH_BARE_X11_H

#include "tool_2d/pixels.h"

#include <cstdint>
#include <functional>
#include <memory>

/// A window with a picture in shared memory and another in ordinary memory.
class bare_x11 {
public:
    /// Errors:  null if there is no display with 32-bit pixels and shared memory.
    static std::unique_ptr<bare_x11> open(l3d_size size, int x);

    bare_x11();
    bare_x11(const bare_x11&) = delete;
    bare_x11& operator=(const bare_x11&) = delete;
    ~bare_x11();

    /// Marks the picture, has the server copy it, and waits until it has.
    void put_shared(std::uint32_t mark);
    void put_wired(std::uint32_t mark);

private:
    struct state;
    std::unique_ptr<state> state_;
};

/// A second program on the display.
class window_watcher {
public:
    /// Looks at the newest window.
    window_watcher();
    window_watcher(const window_watcher&) = delete;
    window_watcher& operator=(const window_watcher&) = delete;
    ~window_watcher();

    /// Returns once the window's first pixel is this word.
    void wait_for(std::uint32_t mark) const;

private:
    struct state;
    std::unique_ptr<state> state_;
};

/// How long our own image takes from put() to the server's answer, without a screen around it.
class image_timer {
public:
    /// Errors:  null if there is no display, or no shared memory if that is wanted.
    static std::unique_ptr<image_timer> open(l3d_size size, bool shared);

    image_timer();
    image_timer(const image_timer&) = delete;
    image_timer& operator=(const image_timer&) = delete;
    ~image_timer();

    /// Puts the picture and waits for the answer.
    void put(const l3d_pixels& picture);

private:
    struct state;
    std::unique_ptr<state> state_;
};

#endif
