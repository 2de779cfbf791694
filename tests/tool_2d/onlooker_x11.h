// SPDX-License-Identifier: MIT
// The fixture that the tests of X11 windows share: a server, a screen, and a second program on the
// same display.
#ifndef L3D_TEST_TOOL_2D_ONLOOKER_X11_H
#define L3D_TEST_TOOL_2D_ONLOOKER_X11_H

// Before Xlib, whose macros would change it.
#include <gtest/gtest.h>

#include "tool_2d/x11/screen_x11.h"
#include "shown_pixel.h"
#include "xvfb.h"

#include <initializer_list>
#include <random>

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#define L3D_REQUIRE_SERVER(server)                                                                 \
    if (!(server).started())                                                                       \
    GTEST_SKIP() << "Xvfb is not installed"

inline constexpr l3d_size odd_size{141, 83};
// Longer than any of this takes; no test passes because it is over.
inline constexpr std::chrono::seconds patience{20};

template <class Factory = l3d_screen_factory_ximage>
std::unique_ptr<l3d_screen> make(const std::string& title = "Teekanne für Öl",
                                 l3d_size size = odd_size) {
    l3d_service refusal;
    auto screen = Factory().create({size, title}, refusal);
    EXPECT_NE(screen, nullptr) << refusal.why;
    return screen;
}

/// The other program.
class onlooker {
public:
    onlooker() : display_(XOpenDisplay(nullptr)) {}
    onlooker(const onlooker&) = delete;
    onlooker& operator=(const onlooker&) = delete;
    ~onlooker() { XCloseDisplay(display_); }

    Display* display() const { return display_; }
    Window root() const { return DefaultRootWindow(display_); }

    /// The newest window of the display.
    Window window() const {
        Window root = 0, parent = 0, *children = nullptr;
        unsigned count = 0;
        XQueryTree(display_, DefaultRootWindow(display_), &root, &parent, &children, &count);
        const Window last = count == 0 ? 0 : children[count - 1];
        XFree(children);
        return last;
    }

    Atom atom(const char* name) const { return XInternAtom(display_, name, False); }

    std::uint32_t pixel(const XImage& image, int x, int y) const {
        return static_cast<std::uint32_t>(XGetPixel(const_cast<XImage*>(&image), x, y));
    }

    std::string property(const char* name) const {
        Atom type = 0;
        int format = 0;
        unsigned long count = 0, after = 0;
        unsigned char* data = nullptr;
        XGetWindowProperty(display_, window(), atom(name), 0, 1024, False, AnyPropertyType, &type,
                           &format, &count, &after, &data);
        // Xlib hands out 32-bit items as longs.
        const auto item = format == 32 ? sizeof(long) : static_cast<std::size_t>(format) / 8;
        std::string text(reinterpret_cast<const char*>(data), count * item);
        XFree(data);
        return text;
    }

    void send(XEvent event, long mask = NoEventMask) const {
        event.xany.window = window();
        event.xany.display = display_;
        XSendEvent(display_, window(), False, mask, &event);
        XSync(display_, False);
    }

    void send_protocol(const char* protocol) const {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.message_type = atom("WM_PROTOCOLS");
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(atom(protocol));
        event.xclient.data.l[1] = 4711;
        event.xclient.data.l[2] = static_cast<long>(window());
        send(event);
    }

    void send_key(int type, KeySym keysym, unsigned state = 0, Time time = 77) const {
        XEvent event{};
        event.xkey.type = type;
        event.xkey.root = root();
        event.xkey.keycode = XKeysymToKeycode(display_, keysym);
        event.xkey.state = state;
        event.xkey.time = time;
        send(event, type == KeyPress ? KeyPressMask : KeyReleaseMask);
    }

    struct key_change {
        int type;
        KeySym keysym;
        Time time;
    };

    /// In one piece, which the server takes and hands on as one.
    void send_keys(std::initializer_list<key_change> changes) const {
        const Window to = window();
        for (const auto& [type, keysym, time] : changes) {
            XEvent event{};
            event.xkey.type = type;
            event.xkey.display = display_;
            event.xkey.window = to;
            event.xkey.root = root();
            event.xkey.keycode = XKeysymToKeycode(display_, keysym);
            event.xkey.time = time;
            XSendEvent(display_, to, False, type == KeyPress ? KeyPressMask : KeyReleaseMask,
                       &event);
        }
        XSync(display_, False);
    }

    void send_button(int type, unsigned button, int x, int y, Time time = 0,
                     unsigned state = 0) const {
        XEvent event{};
        event.xbutton.type = type;
        event.xbutton.root = root();
        event.xbutton.button = button;
        event.xbutton.x = x;
        event.xbutton.y = y;
        event.xbutton.time = time;
        event.xbutton.state = state;
        send(event, type == ButtonPress ? ButtonPressMask : ButtonReleaseMask);
    }

    void send_motion(unsigned state, int x, int y) const {
        XEvent event{};
        event.xmotion.type = MotionNotify;
        event.xmotion.root = root();
        event.xmotion.state = state;
        event.xmotion.x = x;
        event.xmotion.y = y;
        send(event, Button1MotionMask);
    }

private:
    Display* display_;
};

/// Sleeps until the next event of a type; others are dropped. Null if patience runs out.
inline std::unique_ptr<l3d_event> next(l3d_screen& screen, l3d_event_type type) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    auto event = std::make_unique<l3d_event>();
    while (std::chrono::steady_clock::now() < deadline) {
        while (screen.next_event(*event)) {
            if (event->type == type)
                return event;
        }
        screen.wait(deadline - std::chrono::steady_clock::now());
    }
    return nullptr;
}

inline void drop_events(l3d_screen& screen) {
    l3d_event event;
    while (screen.next_event(event)) {
    }
}

/// Random colours; the seed is told if the test fails.
inline void draw_random(const l3d_pixels& pixels, unsigned seed) {
    std::mt19937 random(seed);
    for (int y = 0; y < pixels.height; ++y) {
        for (auto& word : pixels.row(y))
            word = static_cast<std::uint32_t>(random()) & 0xFFFFFF;
    }
}

/// Shows, and returns when the server has the picture: at most two are under way, so that the third
/// waits for the first.
inline void show_for_certain(l3d_screen& screen) {
    for (int i = 0; i < 3; ++i)
        screen.show();
}

/// What a window tells only after its first picture.
inline std::string late_property(l3d_screen& screen, const onlooker& other, const char* name) {
    show_for_certain(screen);
    std::string found;
    for (int i = 0; i < 1000 && found.empty(); ++i) {
        drop_events(screen);
        screen.wait(std::chrono::milliseconds(10));
        found = other.property(name);
    }
    return found;
}

inline int wrong_pixels(const onlooker& other, const l3d_pixels& pixels,
                        const l3d_screen_info& info) {
    XImage* shown =
        XGetImage(other.display(), other.window(), 0, 0, static_cast<unsigned>(pixels.width),
                  static_cast<unsigned>(pixels.height), AllPlanes, ZPixmap);
    if (shown == nullptr)
        return -1;
    int wrong = 0;
    for (int y = 0; y < pixels.height; ++y) {
        for (int x = 0; x < pixels.width; ++x)
            wrong += other.pixel(*shown, x, y) !=
                     shown_pixel(info, pixels.row(y)[static_cast<std::size_t>(x)], x, y);
    }
    XDestroyImage(shown);
    return wrong;
}

#endif
