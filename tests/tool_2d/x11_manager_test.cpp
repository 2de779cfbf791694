// SPDX-License-Identifier: MIT
// X11 windows and their window manager: the whole screen, resizes that wait for pictures.
#include "onlooker_x11.h"

#include "tool_2d/x11_window/x11_fullscreen_p.h"
#include "tool_2d/x11_window/x11_sync_p.h"

#include <array>
#include <atomic>
#include <cstring>
#include <functional>
#include <optional>
#include <thread>
#include <vector>

#include <X11/Xatom.h>

namespace {

using namespace l3d_detail;
using namespace std::chrono_literals;

constexpr l3d_size whole{301, 207};

/// The least window manager: lets windows have what they ask for, and knows fullscreen.
class manager {
public:
    /// `knows_fullscreen`: it is one of today's.
    explicit manager(bool knows_fullscreen = true)
        : state_(atom("_NET_WM_STATE")), fullscreen_(atom("_NET_WM_STATE_FULLSCREEN")),
          // A window may be gone by the time its wish is granted.
          handler_(XSetErrorHandler([](Display*, XErrorEvent*) { return 0; })) {
        XSelectInput(display(), eyes_.root(), SubstructureRedirectMask);
        if (knows_fullscreen) {
            XChangeProperty(display(), eyes_.root(), atom("_NET_SUPPORTED"), XA_ATOM, 32,
                            PropModeReplace, reinterpret_cast<const unsigned char*>(&fullscreen_),
                            1);
            show_that_it_lives();
        }
        XSync(display(), False);
        thread_ = std::thread([this] { run(); });
    }
    manager(const manager&) = delete;
    manager& operator=(const manager&) = delete;
    ~manager() {
        over_ = true;
        thread_.join();
        XSetErrorHandler(handler_);
    }

    int asked() const { return asked_; }

    /// The window that shows that it lives.
    Window check() const { return check_; }

private:
    Display* display() const { return eyes_.display(); }
    Atom atom(const char* name) const { return eyes_.atom(name); }

    void show_that_it_lives() {
        check_ = XCreateSimpleWindow(display(), eyes_.root(), -9, -9, 1, 1, 0, 0, 0);
        for (const Window window : {eyes_.root(), check_})
            XChangeProperty(display(), window, atom("_NET_SUPPORTING_WM_CHECK"), XA_WINDOW, 32,
                            PropModeReplace, reinterpret_cast<const unsigned char*>(&check_), 1);
    }

    void run() {
        while (!over_) {
            if (XPending(display()) == 0) {
                std::this_thread::sleep_for(1ms);
                continue;
            }
            XEvent event;
            XNextEvent(display(), &event);
            if (event.type == MapRequest)
                XMapWindow(display(), event.xmaprequest.window);
            if (event.type == ConfigureRequest)
                configure(event.xconfigurerequest);
            if (event.type == ClientMessage && event.xclient.message_type == state_)
                change_state(event.xclient);
            XSync(display(), False);
        }
    }

    void configure(const XConfigureRequestEvent& request) {
        XWindowChanges changes{};
        changes.x = request.x;
        changes.y = request.y;
        changes.width = request.width;
        changes.height = request.height;
        XConfigureWindow(
            display(), request.window,
            static_cast<unsigned>(request.value_mask) & (CWX | CWY | CWWidth | CWHeight), &changes);
    }

    void change_state(const XClientMessageEvent& message) {
        ++asked_;
        if (static_cast<Atom>(message.data.l[1]) != fullscreen_ || message.data.l[3] != 1)
            return;
        const bool on = message.data.l[0] == 1;
        XChangeProperty(display(), message.window, state_, XA_ATOM, 32, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(&fullscreen_), on ? 1 : 0);
        const l3d_size size = on ? whole : odd_size;
        XMoveResizeWindow(display(), message.window, 0, 0, static_cast<unsigned>(size.width),
                          static_cast<unsigned>(size.height));
    }

    onlooker eyes_;
    Atom state_, fullscreen_;
    Window check_ = 0;
    XErrorHandler handler_;
    std::atomic<bool> over_ = false;
    std::atomic<int> asked_ = 0;
    std::thread thread_;
};

/// Place and size, asked of the server.
std::array<int, 4> place_of(const onlooker& other) {
    XWindowAttributes window{};
    XGetWindowAttributes(other.display(), other.window(), &window);
    return {window.x, window.y, window.width, window.height};
}

/// Whether the screen comes to believe this; it asks, and the answer takes its time.
bool comes_to_be(l3d_screen& screen, bool fullscreen) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    screen.show(); // it asks for the first time after the first picture
    while (screen.is_fullscreen() != fullscreen && std::chrono::steady_clock::now() < deadline) {
        screen.wait(1ms);
        drop_events(screen);
    }
    return screen.is_fullscreen() == fullscreen;
}

TEST(x11_fullscreen, covers_the_screen_and_goes_back) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const onlooker other;
    // Properties that a window manager left behind when it ended are not to be believed.
    const Atom supported = other.atom("_NET_WM_STATE_FULLSCREEN");
    XChangeProperty(other.display(), other.root(), other.atom("_NET_SUPPORTED"), XA_ATOM, 32,
                    PropModeReplace, reinterpret_cast<const unsigned char*>(&supported), 1);
    XSync(other.display(), False);
    const auto screen = make();
    XMoveWindow(other.display(), other.window(), 31, 17);
    XSync(other.display(), False);
    drop_events(*screen);
    EXPECT_FALSE(screen->is_fullscreen());
    screen->set_fullscreen(true);
    EXPECT_TRUE(screen->is_fullscreen());
    EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, whole);
    EXPECT_EQ(place_of(other), (std::array{0, 0, 301, 207}));
    screen->set_fullscreen(false);
    EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, odd_size);
    EXPECT_EQ(place_of(other), (std::array{31, 17, odd_size.width, odd_size.height}));
    EXPECT_FALSE(screen->is_fullscreen());
}

TEST(x11_fullscreen, is_asked_of_the_window_manager) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const manager theirs;
    const auto screen = make();
    drop_events(*screen);
    screen->set_fullscreen(true);
    EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, whole);
    EXPECT_TRUE(comes_to_be(*screen, true));
    screen->set_fullscreen(false);
    EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, odd_size);
    EXPECT_TRUE(comes_to_be(*screen, false));
    EXPECT_EQ(theirs.asked(), 2);
}

TEST(x11_fullscreen, an_old_window_manager_moves_the_window) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const manager theirs(false);
    const auto screen = make();
    drop_events(*screen);
    screen->set_fullscreen(true);
    EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, whole);
    EXPECT_EQ(theirs.asked(), 0);
}

/// Its own keys may end it, and a program that believed otherwise would need F11 twice.
TEST(x11_fullscreen, the_window_manager_may_change_its_mind) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const manager theirs;
    const auto screen = make();
    screen->set_fullscreen(true);
    next(*screen, l3d_event_type::resize);
    EXPECT_TRUE(comes_to_be(*screen, true));
    const onlooker other;
    XDeleteProperty(other.display(), other.window(), other.atom("_NET_WM_STATE"));
    XResizeWindow(other.display(), other.window(), 77, 55);
    XSync(other.display(), False);
    next(*screen, l3d_event_type::resize);
    EXPECT_TRUE(comes_to_be(*screen, false));
}

/// The news may come while a picture is drawn, which is then asked whether it is still wanted.
TEST(x11_fullscreen, the_end_of_its_window_manager_does_not_close_a_window) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const manager theirs;
    const auto screen = make();
    screen->set_fullscreen(true);
    EXPECT_EQ(next(*screen, l3d_event_type::resize)->size, whole);
    const onlooker other;
    XDestroyWindow(other.display(), theirs.check());
    XSync(other.display(), False);
    EXPECT_FALSE(screen->is_to_close());
    XDestroyWindow(other.display(), other.window());
    XSync(other.display(), False);
    EXPECT_TRUE(screen->is_to_close());
}

TEST(x11_fullscreen, hides_a_pointer_that_rests) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    std::string why;
    auto connection = x11_connection::open(why);
    const auto visual = choose_x11_visual(*connection, why);
    l3d_service refusal;
    const auto window =
        x11_window::open(std::move(connection), *visual, {odd_size, "pointer"}, refusal);
    ASSERT_NE(window, nullptr) << refusal.why;
    x11_wm_facts state(*window);
    x11_fullscreen fullscreen(*window, state, odd_size);
    const auto set = [&](bool on) {
        fullscreen.set(on);
        while (state.is_asking()) {
            XEvent event;
            XNextEvent(window->display(), &event);
            if (state.take(event))
                fullscreen.follow();
        }
    };
    const auto requests = [&](const std::function<void()>& action) {
        const auto before = XNextRequest(window->display());
        action();
        return XNextRequest(window->display()) - before;
    };
    const auto rest = [&](auto time) {
        return requests([&] { fullscreen.rest(x11_fullscreen::clock::now() + time); });
    };
    XEvent motion{};
    motion.type = MotionNotify;
    EXPECT_EQ(rest(1h), 0U) << "it is the desktop's";
    set(true);
    EXPECT_EQ(rest(1500ms), 0U);
    EXPECT_GT(rest(2s), 0U);
    EXPECT_EQ(rest(3s), 0U) << "hidden already";
    EXPECT_EQ(requests([&] { fullscreen.take(motion); }), 1U) << "shown again";
    EXPECT_EQ(requests([&] { fullscreen.take(motion); }), 0U);
    EXPECT_GT(rest(2s), 0U);
    EXPECT_GT(requests([&] { set(false); }), 1U) << "moved, and shown again";
    EXPECT_EQ(rest(1h), 0U);
    XSync(window->display(), False);
    EXPECT_FALSE(window->connection().lost());
}

// ---- _NET_WM_SYNC_REQUEST -----------------------------------------------------------------------

/// The counter's number now; -1 if the window has none.
long counted(const onlooker& other) {
    const std::string property = other.property("_NET_WM_SYNC_REQUEST_COUNTER");
    int first_event = 0, first_error = 0;
    if (property.size() != sizeof(long) ||
        XSyncQueryExtension(other.display(), &first_event, &first_error) == 0)
        return -1;
    XSyncCounter counter = 0;
    std::memcpy(&counter, property.data(), sizeof counter);
    XSyncValue value{};
    XSyncQueryCounter(other.display(), counter, &value);
    return static_cast<long>(XSyncValueHigh32(value)) << 32 | XSyncValueLow32(value);
}

void announce(const onlooker& other, long number) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.message_type = other.atom("WM_PROTOCOLS");
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(other.atom("_NET_WM_SYNC_REQUEST"));
    event.xclient.data.l[2] = number & 0xFFFFFFFF;
    event.xclient.data.l[3] = number >> 32;
    other.send(event);
}

void resize(const onlooker& other, unsigned width, unsigned height) {
    XResizeWindow(other.display(), other.window(), width, height);
    XSync(other.display(), False);
}

class x11_sync_managed : public testing::Test {
protected:
    void SetUp() override {
        L3D_REQUIRE_SERVER(server_);
        manager_.emplace();
        screen_ = make();
        other_.emplace();
        drop_events(*screen_);
    }

    const xvfb server_{"301x207x24"};
    std::optional<manager> manager_;
    std::unique_ptr<l3d_screen> screen_;
    std::optional<onlooker> other_;
};

TEST_F(x11_sync_managed, tells_when_the_new_size_is_shown) {
    EXPECT_EQ(counted(*other_), 0);
    constexpr long number = (5L << 32) + 7;
    announce(*other_, number);
    resize(*other_, 97, 61);
    screen_->wait(patience);
    show_for_certain(*screen_);
    EXPECT_EQ(counted(*other_), 0) << "those were pictures of the old size";
    EXPECT_EQ(next(*screen_, l3d_event_type::resize)->size, (l3d_size{97, 61}));
    screen_->wait(1ms);
    EXPECT_EQ(counted(*other_), 0) << "nothing was drawn yet";
    show_for_certain(*screen_);
    EXPECT_EQ(counted(*other_), number);
    show_for_certain(*screen_);
    announce(*other_, number + 4);
    show_for_certain(*screen_);
    EXPECT_EQ(counted(*other_), number) << "no size has followed yet";
}

TEST_F(x11_sync_managed, of_several_sizes_the_last_counts) {
    announce(*other_, 3);
    resize(*other_, 97, 61);
    EXPECT_EQ(next(*screen_, l3d_event_type::resize)->size, (l3d_size{97, 61}));
    announce(*other_, 9);
    resize(*other_, 131, 59);
    screen_->show();
    EXPECT_NE(counted(*other_), 9);
    EXPECT_EQ(next(*screen_, l3d_event_type::resize)->size, (l3d_size{131, 59}));
    EXPECT_NE(counted(*other_), 9);
    show_for_certain(*screen_);
    EXPECT_EQ(counted(*other_), 9);
}

/// The manager must not wait for a picture that a resting program has no reason to draw.
TEST_F(x11_sync_managed, a_size_that_is_the_old_one_is_shown_already) {
    announce(*other_, 3);
    XMoveWindow(other_->display(), other_->window(), 31, 17);
    XSync(other_->display(), False);
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (counted(*other_) != 3 && std::chrono::steady_clock::now() < deadline) {
        screen_->wait(1ms);
        drop_events(*screen_);
    }
    EXPECT_EQ(counted(*other_), 3);
}

TEST(x11_sync, is_not_offered_to_nobody) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make();
    const onlooker other;
    EXPECT_EQ(counted(other), -1);
    EXPECT_EQ(other.property("WM_PROTOCOLS").size(), 2 * sizeof(long));
}

} // namespace
