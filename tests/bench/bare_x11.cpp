// SPDX-License-Identifier: MIT
// bare_x11: the shortest way to a window that Xlib offers.
#include "bench/bare_x11.h"

#include "tool_2d/x11/x11_image_p.h"

#include <vector>

#include <sys/ipc.h>
#include <sys/shm.h>

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XShm.h>

using namespace l3d_detail;
using std::chrono::steady_clock;

struct bare_x11::state {
    Display* display = nullptr;
    Window window = 0;
    GC graphics = nullptr;
    XShmSegmentInfo segment{};
    XImage* shared = nullptr;
    XImage* wired = nullptr;
    std::vector<std::uint32_t> words;
    int completion = 0;
};

bare_x11::bare_x11() : state_(std::make_unique<state>()) {}

std::unique_ptr<bare_x11> bare_x11::open(l3d_size size, int x) {
    auto bare = std::make_unique<bare_x11>();
    auto& s = *bare->state_;
    s.display = XOpenDisplay(nullptr);
    if (s.display == nullptr || XShmQueryExtension(s.display) == 0)
        return nullptr;
    const int screen = DefaultScreen(s.display);
    const auto width = static_cast<unsigned>(size.width);
    const auto height = static_cast<unsigned>(size.height);
    const auto depth = static_cast<unsigned>(DefaultDepth(s.display, screen));
    auto* const visual = DefaultVisual(s.display, screen);
    s.window =
        XCreateSimpleWindow(s.display, RootWindow(s.display, screen), x, 0, width, height, 0, 0, 0);
    XMapWindow(s.display, s.window);
    s.graphics = XCreateGC(s.display, s.window, 0, nullptr);
    s.shared =
        XShmCreateImage(s.display, visual, depth, ZPixmap, nullptr, &s.segment, width, height);
    if (s.shared->bits_per_pixel != 32)
        return nullptr;
    const auto count = static_cast<std::size_t>(width) * height;
    s.segment.shmid = shmget(IPC_PRIVATE, 4 * count, IPC_CREAT | 0600);
    s.segment.shmaddr = s.shared->data = static_cast<char*>(shmat(s.segment.shmid, nullptr, 0));
    shmctl(s.segment.shmid, IPC_RMID, nullptr);
    XShmAttach(s.display, &s.segment);
    s.completion = XShmGetEventBase(s.display) + ShmCompletion;
    s.words.assign(count, 0);
    s.wired = XCreateImage(s.display, visual, depth, ZPixmap, 0,
                           reinterpret_cast<char*>(s.words.data()), width, height, 32, 0);
    XSync(s.display, False);
    return bare;
}

bare_x11::~bare_x11() {
    if (state_->wired != nullptr) {
        state_->wired->data = nullptr;
        XDestroyImage(state_->wired);
    }
    if (state_->shared != nullptr)
        XDestroyImage(state_->shared);
    if (state_->segment.shmaddr != nullptr)
        shmdt(state_->segment.shmaddr);
    if (state_->display != nullptr)
        XCloseDisplay(state_->display);
}

void bare_x11::put_shared(std::uint32_t mark) {
    auto& s = *state_;
    *reinterpret_cast<std::uint32_t*>(s.shared->data) = mark;
    XShmPutImage(s.display, s.window, s.graphics, s.shared, 0, 0, 0, 0,
                 static_cast<unsigned>(s.shared->width), static_cast<unsigned>(s.shared->height),
                 True);
    XEvent event;
    do {
        XNextEvent(s.display, &event);
    } while (event.type != s.completion);
}

void bare_x11::put_wired(std::uint32_t mark) {
    auto& s = *state_;
    s.words[0] = mark;
    XPutImage(s.display, s.window, s.graphics, s.wired, 0, 0, 0, 0,
              static_cast<unsigned>(s.wired->width), static_cast<unsigned>(s.wired->height));
    XSync(s.display, False);
}

struct window_watcher::state {
    Display* display = nullptr;
    Window window = 0;
};

window_watcher::window_watcher() : state_(std::make_unique<state>()) {
    auto& s = *state_;
    s.display = XOpenDisplay(nullptr);
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    XQueryTree(s.display, DefaultRootWindow(s.display), &root, &parent, &children, &count);
    s.window = children[count - 1];
    XFree(children);
}

window_watcher::~window_watcher() {
    XCloseDisplay(state_->display);
}

void window_watcher::wait_for(std::uint32_t mark) const {
    for (unsigned long pixel = ~0UL; pixel != mark;) {
        XImage* const seen =
            XGetImage(state_->display, state_->window, 0, 0, 1, 1, AllPlanes, ZPixmap);
        pixel = XGetPixel(seen, 0, 0);
        XDestroyImage(seen);
    }
}

struct image_timer::state {
    std::unique_ptr<x11_window> window;
    std::unique_ptr<x11_image> image;
};

image_timer::image_timer() : state_(std::make_unique<state>()) {}
image_timer::~image_timer() = default;

std::unique_ptr<image_timer> image_timer::open(l3d_size size, bool shared) {
    l3d_service refusal;
    auto connection = x11_connection::open(refusal.why);
    if (!connection)
        return nullptr;
    const auto visual = choose_x11_visual(*connection, refusal.why);
    if (!visual)
        return nullptr;
    auto timer = std::make_unique<image_timer>();
    auto& s = *timer->state_;
    s.window = x11_window::open(std::move(connection), *visual, {size, "timer"}, refusal);
    if (!s.window)
        return nullptr;
    s.window->map();
    s.image = shared ? make_x11_image_shm(*s.window, size, refusal.why)
                     : make_x11_image_put(*s.window, size);
    return s.image ? std::move(timer) : nullptr;
}

void image_timer::put(const l3d_pixels& picture) {
    auto& s = *state_;
    constexpr std::chrono::seconds long_enough{10};
    const auto deadline = steady_clock::now() + long_enough;
    s.image->put(picture, l3d_whole(picture.size()), deadline);
    for (;;) {
        while (XPending(s.window->display()) > 0) {
            XEvent event;
            XNextEvent(s.window->display(), &event);
            s.image->take(event);
        }
        if (s.image->is_idle())
            return;
        s.window->connection().wait_readable(deadline);
    }
}
