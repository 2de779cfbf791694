// SPDX-License-Identifier: MIT
// X11 windows in shared memory: buffers that the server reads, servers that stop or refuse,
// programs that are killed.
#include "processor_time.h"
#include "shared_screen.h"

#include <atomic>
#include <fstream>
#include <sstream>
#include <thread>

#include <sys/resource.h>
#include <sys/time.h>

#include <X11/extensions/XShm.h>

namespace {

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

/// A program that shows a picture and then sleeps. It shares memory by System V if files may have
/// no bytes.
pid_t start_program(rlim_t file_bytes) {
    const pid_t child = fork();
    if (child == 0) {
        const rlimit most{file_bytes, RLIM_INFINITY};
        setrlimit(RLIMIT_FSIZE, &most);
        const auto screen = make<l3d_screen_factory_xshm>();
        screen->show();
        raise(SIGSTOP);
        _exit(0);
    }
    waitpid(child, nullptr, WUNTRACED);
    return child;
}

template <class Question> bool comes_true(Question question) {
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (!question() && std::chrono::steady_clock::now() < deadline)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return question();
}

TEST(screen_x11_shm_loss, nothing_outlives_a_program_that_is_killed) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const pid_t child = start_program(0);
    const auto while_it_lives = segments_of(child);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    ASSERT_EQ(while_it_lives.size(), 1U);
    EXPECT_EQ(while_it_lives[0].mode, 01600);
    EXPECT_EQ(while_it_lives[0].attached, 2) << "by us and by the server";
    EXPECT_TRUE(comes_true([child] { return segments_of(child).empty(); }));
}

/// Whether a process has one of our files mapped, so that it cannot write into it.
bool maps_our_file(pid_t process) {
    std::ifstream maps("/proc/" + std::to_string(process) + "/maps");
    for (std::string line; std::getline(maps, line);)
        if (line.find("/memfd:l3d ") != std::string::npos &&
            line.find(" r--s ") != std::string::npos)
            return true;
    return false;
}

TEST(screen_x11_shm_loss, no_file_outlives_a_program_that_is_killed) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const pid_t child = start_program(RLIM_INFINITY);
    const bool is_mapped = maps_our_file(server.process());
    EXPECT_TRUE(segments_of(child).empty());
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    EXPECT_TRUE(is_mapped);
    EXPECT_TRUE(comes_true([&server] { return !maps_our_file(server.process()); }));
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

TEST(screen_x11_shm_loss, no_picture_is_overwritten_while_the_server_reads_it) {
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

TEST(screen_x11_shm_loss, goes_on_over_the_wire_when_the_server_refuses_a_picture) {
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
    const auto deadline = std::chrono::steady_clock::now() + patience;
    while (wrong_pixels(other, screen->pixels(), screen->info()) != 0) {
        ASSERT_LT(std::chrono::steady_clock::now(), deadline) << "a picture was lost";
        drop_events(*screen);
    }
    EXPECT_FALSE(is_shared(*screen)) << screen->describe();
    EXPECT_EQ(screen->take_remark(),
              "xshm: pictures now go over the wire: the X server refused a picture: BadShmSeg "
              "(invalid shared segment parameter)");
    EXPECT_EQ(wrong_after_pictures(*screen, 6), 0);
}

TEST(screen_x11_shm_loss, a_window_that_is_gone_is_no_failure_of_sharing) {
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

TEST(screen_x11_shm_loss, a_stopped_server_is_waited_for_in_sleep) {
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

/// Seconds from the stop of the server to the end of the screen, with a signal in between.
double seconds_to_leave(const xvfb& server, std::unique_ptr<l3d_screen> screen) {
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
    const auto end = std::chrono::steady_clock::now();
    server.resume();
    return std::chrono::duration<double>(end - start).count();
}

TEST(screen_x11_shm_loss, a_stopped_server_does_not_hold_up_signals_or_the_end) {
    const xvfb server("301x207x24");
    L3D_REQUIRE_SERVER(server);
    const auto before = std::signal(SIGALRM, [](int) { has_rung = 1; });
    // One is larger than what a connection holds, so that writing it at once would block. The other
    // leaves so little room that even a small request would.
    for (const l3d_size size : {l3d_size{1021, 763}, {157, 119}}) {
        EXPECT_LT(seconds_to_leave(server, make<l3d_screen_factory_xshm>("stopped", size)), 3);
        EXPECT_LT(seconds_to_leave(server, make<l3d_screen_factory_ximage>("stopped", size)), 3);
    }
    std::signal(SIGALRM, before);
}

} // namespace
