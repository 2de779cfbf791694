// SPDX-License-Identifier: MIT
// X11 windows in shared memory: the right picture whatever becomes of the sharing, and nothing
// left behind.
#include "onlooker_x11.h"

#include <atomic>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <sstream>
#include <thread>

#include <sched.h>
#include <sys/ipc.h>
#include <sys/resource.h>
#include <sys/shm.h>
#include <sys/time.h>

#include <X11/extensions/XShm.h>

namespace {

using level = l3d_service::level;

bool is_shared(const l3d_screen& screen) {
    return screen.describe().ends_with("shared memory: yes");
}

/// Random pictures in a new window: how many pixels of the last are wrong. Three fill both buffers.
int wrong_after_pictures(l3d_screen& screen, unsigned seed) {
    const onlooker other;
    drop_events(screen);
    int wrong = 0;
    for (unsigned picture = 0; picture < 3; ++picture) {
        draw_random(screen.pixels(), seed + picture);
        show_for_certain(screen);
        wrong += std::abs(wrong_pixels(other, screen.pixels(), screen.info()));
    }
    return wrong;
}

/// Runs what must not happen to the test itself. The function's result, or -1 after a signal.
int in_process_of_its_own(const std::function<int()>& function) {
    const pid_t child = fork();
    if (child == 0)
        _exit(function());
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// What the functions above return, besides 0 for well.
constexpr int not_permitted = 77;

#define L3D_EXPECT_WELL(result)                                                                    \
    if ((result) == not_permitted)                                                                 \
        GTEST_SKIP() << "needs a namespace of its own, which is not permitted here";               \
    EXPECT_EQ(result, 0)

struct display_kind {
    const char* name;
    const char* screen;
    std::vector<std::string> more;
};

class screen_x11_shm_depth : public testing::TestWithParam<display_kind> {};

TEST_P(screen_x11_shm_depth, every_pixel_is_right) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server(GetParam().screen, GetParam().more);
    L3D_REQUIRE_SERVER(server);
    const auto screen = make<l3d_screen_factory_xshm>();
    ASSERT_NE(screen, nullptr);
    EXPECT_TRUE(is_shared(*screen)) << screen->describe();
    EXPECT_EQ(screen->take_remark(), "");
    EXPECT_EQ(wrong_after_pictures(*screen, seed), 0) << screen->describe();
}

INSTANTIATE_TEST_SUITE_P(servers, screen_x11_shm_depth,
                         testing::Values(display_kind{"true_color_8", "301x207x8", {"-cc", "4"}},
                                         display_kind{"palette_8", "301x207x8", {"-cc", "3"}},
                                         display_kind{"depth_15", "301x207x15", {}},
                                         display_kind{"depth_16", "301x207x16", {}},
                                         display_kind{"depth_24", "301x207x24", {}},
                                         display_kind{"depth_30", "301x207x30", {}}),
                         [](const auto& kind) { return std::string(kind.param.name); });

TEST(screen_x11_shm, odd_sizes) {
    const xvfb server("4211x97x16");
    L3D_REQUIRE_SERVER(server);
    for (const l3d_size size : {l3d_size{1, 1}, {3, 1}, {1, 89}, {4097, 3}}) {
        const auto screen = make<l3d_screen_factory_xshm>("odd", size);
        ASSERT_NE(screen, nullptr);
        EXPECT_TRUE(is_shared(*screen));
        EXPECT_EQ(wrong_after_pictures(*screen, 3), 0) << size.width << "x" << size.height;
    }
}

TEST(screen_x11_shm, a_window_may_change_its_size_at_any_time) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make<l3d_screen_factory_xshm>();
    const onlooker other;
    std::mt19937 random(seed);
    for (int change = 0; change < 100; ++change) {
        const auto any_up_to = [&](unsigned most) {
            return 1 + static_cast<unsigned>(random()) % most;
        };
        XResizeWindow(other.display(), other.window(), any_up_to(290), any_up_to(190));
        XSync(other.display(), False);
        if (change % 3 == 0)
            drop_events(*screen);
        draw_random(screen->pixels(), seed);
        screen->show();
    }
    // The last size has certainly been told by now.
    EXPECT_EQ(wrong_after_pictures(*screen, seed), 0);
    EXPECT_TRUE(is_shared(*screen)) << screen->describe();
}

/// A window that shows the right picture although memory cannot be shared, and says why not.
void expect_wire(const std::string& why) {
    const auto service = l3d_screen_factory_xshm().service();
    EXPECT_EQ(service.how, level::partly);
    EXPECT_NE(service.why.find(why), std::string::npos) << service.why;
    const auto screen = make<l3d_screen_factory_xshm>();
    ASSERT_NE(screen, nullptr);
    EXPECT_NE(screen->describe().find("shared memory: no, "), std::string::npos);
    EXPECT_NE(screen->describe().find(why), std::string::npos) << screen->describe();
    const auto remark = screen->take_remark();
    EXPECT_TRUE(remark.starts_with("xshm: ")) << remark;
    EXPECT_NE(remark.find(why), std::string::npos) << remark;
    EXPECT_EQ(screen->take_remark(), "") << "told twice";
    EXPECT_EQ(wrong_after_pictures(*screen, 11), 0);
}

TEST(screen_x11_shm, without_the_extension) {
    const xvfb server("301x207x24", {"-extension", "MIT-SHM"});
    L3D_REQUIRE_SERVER(server);
    expect_wire("the X server does not have MIT-SHM");
}

TEST(screen_x11_shm, not_if_the_user_says_no) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    setenv("L3D_NO_SHM", "1", 1);
    expect_wire("L3D_NO_SHM is set");
    setenv("L3D_NO_SHM", "", 1);
    EXPECT_EQ(l3d_screen_factory_xshm().service().how, level::fully);
    unsetenv("L3D_NO_SHM");
}

TEST(screen_x11_shm, not_over_a_network) {
    const xvfb server("301x207x24", {"-ac", "-listen", "tcp"});
    L3D_REQUIRE_SERVER(server);
    EXPECT_EQ(make<l3d_screen_factory_xshm>()->usual_fps(), 60);
    setenv("DISPLAY", ("127.0.0.1" + server.display()).c_str(), 1);
    expect_wire("the X server is reached over a network");
    EXPECT_EQ(make<l3d_screen_factory_xshm>()->usual_fps(), 15);
    EXPECT_EQ(make<l3d_screen_factory_ximage>()->usual_fps(), 15);
}

/// The kernel's own reason, in a namespace whose limits are ours to set.
int declines_within_limit(const std::string& limit, const std::string& value,
                          const std::string& why) {
    const xvfb server("301x207x24");
    if (!server.started() || unshare(CLONE_NEWIPC) != 0)
        return not_permitted;
    std::ofstream file("/proc/sys/kernel/" + limit);
    if (!(file << value << std::flush))
        return not_permitted;
    expect_wire(why);
    return testing::Test::HasFailure() ? 1 : 0;
}

TEST(screen_x11_shm, no_segment_left) {
    L3D_EXPECT_WELL(in_process_of_its_own(
        [] { return declines_within_limit("shmmni", "0", "shmget: No space left on device"); }));
}

TEST(screen_x11_shm, no_segment_so_large) {
    L3D_EXPECT_WELL(in_process_of_its_own(
        [] { return declines_within_limit("shmmax", "100", "shmget: Invalid argument"); }));
}

/// The server is in one namespace, where other programs' segments have the first numbers; we are
/// in another, where ours has.
int declines_foreign_memory() {
    if (unshare(CLONE_NEWIPC) != 0)
        return not_permitted;
    constexpr std::size_t large = 4 << 20;
    for (int i = 0; i < 8; ++i)
        shmat(shmget(IPC_PRIVATE, large, IPC_CREAT | 0666), nullptr, 0);
    const xvfb server("301x207x24");
    if (!server.started() || unshare(CLONE_NEWIPC) != 0)
        return not_permitted;
    expect_wire("the X server sees other memory than ours");
    return testing::Test::HasFailure() ? 1 : 0;
}

TEST(screen_x11_shm, another_programs_memory_under_our_number) {
    L3D_EXPECT_WELL(in_process_of_its_own(declines_foreign_memory));
}

/// One line of the kernel's table of segments.
struct segment_row {
    int mode = 0; ///< with 01000 if it goes with its last user
    long attached = 0;
};

std::vector<segment_row> segments_of(pid_t process) {
    std::vector<segment_row> rows;
    std::ifstream table("/proc/sysvipc/shm");
    std::string line;
    std::getline(table, line);
    while (std::getline(table, line)) {
        std::istringstream words(line);
        std::string key, number, size;
        segment_row row;
        pid_t creator = 0, last = 0;
        words >> key >> number >> std::oct >> row.mode >> std::dec >> size >> creator >> last >>
            row.attached;
        if (creator == process)
            rows.push_back(row);
    }
    return rows;
}

TEST(screen_x11_shm, nothing_outlives_a_program_that_is_killed) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const pid_t child = fork();
    if (child == 0) {
        const auto screen = make<l3d_screen_factory_xshm>();
        screen->show();
        raise(SIGSTOP);
        _exit(0);
    }
    waitpid(child, nullptr, WUNTRACED);
    const auto while_it_lives = segments_of(child);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    ASSERT_EQ(while_it_lives.size(), 1U);
    EXPECT_EQ(while_it_lives[0].mode, 01600);
    EXPECT_EQ(while_it_lives[0].attached, 2) << "by us and by the server";
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!segments_of(child).empty() && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    EXPECT_TRUE(segments_of(child).empty());
}

/// Reads the window over and over; counts the pictures that are not of one colour.
class reader {
public:
    explicit reader(l3d_size size) : size_(size), thread_([this] { read(); }) {}
    reader(const reader&) = delete;
    reader& operator=(const reader&) = delete;
    ~reader() { thread_.join(); }

    std::atomic<bool> done = false;
    std::atomic<int> pictures = 0, torn = 0;

private:
    void read() {
        const onlooker other;
        const Window window = other.window();
        while (!done) {
            XImage* const seen =
                XGetImage(other.display(), window, 0, 0, static_cast<unsigned>(size_.width),
                          static_cast<unsigned>(size_.height), AllPlanes, ZPixmap);
            const std::span pixels(reinterpret_cast<std::uint32_t*>(seen->data),
                                   static_cast<std::size_t>(size_.width) *
                                       static_cast<std::size_t>(size_.height));
            ++pictures;
            torn += std::ranges::any_of(pixels, [&](auto pixel) { return pixel != pixels[0]; });
            XDestroyImage(seen);
        }
    }

    l3d_size size_;
    std::thread thread_;
};

TEST(screen_x11_shm, no_picture_is_overwritten_while_the_server_reads_it) {
    const xvfb server("1100x800x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make<l3d_screen_factory_xshm>("one colour", {1021, 763});
    drop_events(*screen);
    const auto fill = [&](std::uint32_t color) {
        const auto pixels = screen->pixels();
        for (int y = 0; y < pixels.height; ++y)
            std::ranges::fill(pixels.row(y), color);
    };
    fill(0x123456);
    show_for_certain(*screen);
    reader looking(screen->pixels().size());
    for (std::uint32_t frame = 0; frame < 400 || looking.pictures < 20; ++frame) {
        fill(frame * 0x010307 & 0xFFFFFF);
        screen->show();
        drop_events(*screen);
    }
    looking.done = true;
    EXPECT_EQ(looking.torn, 0) << "of " << looking.pictures;
}

/// Takes our segment away from the server, as its own restart or an operator could.
void detach_all_segments(const onlooker& other) {
    const auto before = XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    // A client's resources have numbers from its base on; the window is one of the first.
    const auto base = other.window() & ~0xFFFFUL;
    for (ShmSeg number = base; number < base + 64; ++number) {
        XShmSegmentInfo info{};
        info.shmseg = number;
        XShmDetach(other.display(), &info);
    }
    XSync(other.display(), False);
    XSetErrorHandler(before);
}

TEST(screen_x11_shm, goes_on_over_the_wire_when_the_server_refuses_a_picture) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make<l3d_screen_factory_xshm>();
    const onlooker other;
    EXPECT_EQ(wrong_after_pictures(*screen, 5), 0);
    EXPECT_TRUE(is_shared(*screen));
    detach_all_segments(other);
    // One show, and then the program only looks for events: this picture must not be lost.
    draw_random(screen->pixels(), 99);
    screen->show();
    other.send_key(KeyPress, 'y');
    EXPECT_NE(next(*screen, l3d_event_type::key_press), nullptr);
    show_for_certain(*screen);
    EXPECT_EQ(wrong_pixels(other, screen->pixels(), screen->info()), 0);
    EXPECT_FALSE(is_shared(*screen)) << screen->describe();
    EXPECT_EQ(screen->take_remark(),
              "xshm: pictures now go over the wire: the X server refused a picture: BadShmSeg "
              "(invalid shared segment parameter)");
    EXPECT_EQ(wrong_after_pictures(*screen, 6), 0);
}

TEST(screen_x11_shm, a_window_that_is_gone_is_no_failure_of_sharing) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make<l3d_screen_factory_xshm>();
    const onlooker other;
    XDestroyWindow(other.display(), other.window());
    XSync(other.display(), False);
    screen->show();
    screen->show();
    EXPECT_NE(next(*screen, l3d_event_type::close), nullptr);
    EXPECT_EQ(screen->take_remark(), "");
}

double processor_seconds() {
    rusage used{};
    getrusage(RUSAGE_SELF, &used);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(used.ru_utime) + seconds(used.ru_stime);
}

TEST(screen_x11_shm, a_stopped_server_is_waited_for_in_sleep) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto screen = make<l3d_screen_factory_xshm>();
    const onlooker other;
    EXPECT_EQ(wrong_after_pictures(*screen, 5), 0);
    server.pause();
    for (unsigned picture = 0; picture < 3; ++picture) {
        draw_random(screen->pixels(), 60 + picture);
        screen->show();
    }
    // Longer than a server that works may be silent.
    const double before = processor_seconds();
    screen->wait(std::chrono::milliseconds(2500));
    EXPECT_LT(processor_seconds() - before, 0.025);
    server.resume();
    other.send_key(KeyPress, 'y');
    EXPECT_NE(next(*screen, l3d_event_type::key_press), nullptr);
    show_for_certain(*screen);
    EXPECT_EQ(wrong_pixels(other, screen->pixels(), screen->info()), 0);
    EXPECT_TRUE(is_shared(*screen)) << "sleep is no failure: " << screen->describe();
}

volatile std::sig_atomic_t has_rung = 0;

TEST(screen_x11_shm, a_stopped_server_does_not_hold_up_signals_or_the_end) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto before = std::signal(SIGALRM, [](int) { has_rung = 1; });
    for (const bool shared : {true, false}) {
        // Larger than what a connection holds, so that writing it would block.
        const l3d_size large{1021, 763};
        auto screen = shared ? make<l3d_screen_factory_xshm>("stopped", large)
                             : make<l3d_screen_factory_ximage>("stopped", large);
        drop_events(*screen);
        server.pause();
        const auto start = std::chrono::steady_clock::now();
        for (int i = 0; i < 4; ++i)
            screen->show();
        has_rung = 0;
        const itimerval soon{{}, {0, 50000}};
        setitimer(ITIMER_REAL, &soon, nullptr);
        while (has_rung == 0)
            screen->wait(patience);
        screen.reset();
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(3)) << shared;
        server.resume();
    }
    std::signal(SIGALRM, before);
}

} // namespace
