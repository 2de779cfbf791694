// SPDX-License-Identifier: MIT
// X11 windows in shared memory: the right picture, and a reason if it takes another way.
#include "shared_screen.h"

#include <fstream>
#include <functional>

#include <sched.h>
#include <sys/ipc.h>
#include <sys/resource.h>
#include <sys/shm.h>

namespace {

using level = l3d_service::level;

/// Runs what must not happen to the test itself. The function's result, or -1 after a signal.
int in_process_of_its_own(const std::function<int()>& function) {
    const pid_t child = fork();
    if (child == 0)
        _exit(function());
    int status = 0;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// The results of the functions above, besides 0 for success.
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

/// --remote decides whatever the display is.
TEST(screen_x11_shm, travels_sparingly_if_the_user_says_so) {
    const xvfb server("301x207x24", {"-ac", "-listen", "tcp"});
    L3D_REQUIRE_SERVER(server);
    const auto open = [](const l3d_screen_factory& factory, l3d_remote remote) {
        l3d_service refusal;
        return factory.create({.size = odd_size, .remote = remote}, refusal);
    };
    const auto is_sparing = [](const l3d_screen& screen) {
        const bool is_coarse = screen.describe().find("changed tiles") != std::string::npos;
        EXPECT_EQ(screen.usual_fps(), is_coarse ? 15 : 60);
        return is_coarse;
    };
    const l3d_screen_factory_xshm xshm;
    const l3d_screen_factory_ximage ximage;
    EXPECT_FALSE(is_sparing(*open(ximage, l3d_remote::automatic)));
    EXPECT_FALSE(is_sparing(*open(xshm, l3d_remote::off)));
    EXPECT_TRUE(is_sparing(*open(ximage, l3d_remote::on)));
    const auto screen = open(xshm, l3d_remote::on);
    EXPECT_TRUE(is_sparing(*screen));
    EXPECT_TRUE(screen->describe().ends_with("shared memory: no, --remote on"));
    EXPECT_EQ(wrong_after_pictures(*screen, 5), 0);
    setenv("DISPLAY", ("127.0.0.1" + server.display()).c_str(), 1);
    EXPECT_TRUE(is_sparing(*open(ximage, l3d_remote::automatic)));
    EXPECT_FALSE(is_sparing(*open(ximage, l3d_remote::off)));
}

/// In a namespace whose limits are ours to set.
bool limits_segments(const std::string& limit, const std::string& value) {
    if (unshare(CLONE_NEWIPC) != 0)
        return false;
    std::ofstream file("/proc/sys/kernel/" + limit);
    return static_cast<bool>(file << value << std::flush);
}

int shares_files_without_segments() {
    const xvfb server("301x207x24");
    if (!server.started() || !limits_segments("shmmni", "0"))
        return not_permitted;
    EXPECT_LT(shmget(IPC_PRIVATE, 1, IPC_CREAT | 0600), 0);
    EXPECT_EQ(l3d_screen_factory_xshm().service().how, level::fully);
    const auto screen = make<l3d_screen_factory_xshm>();
    EXPECT_TRUE(screen && is_shared(*screen));
    EXPECT_EQ(screen->take_remark(), "");
    EXPECT_EQ(wrong_after_pictures(*screen, 12), 0);
    return testing::Test::HasFailure() ? 1 : 0;
}

TEST(screen_x11_shm, needs_no_segments_of_system_v) {
    L3D_EXPECT_WELL(in_process_of_its_own(shares_files_without_segments));
}

/// Files that may not grow leave segments, as do servers that take no files.
int shares_segments_without_files() {
    const xvfb server("301x207x24");
    const rlimit no_files{0, 0};
    if (!server.started() || setrlimit(RLIMIT_FSIZE, &no_files) != 0)
        return not_permitted;
    const auto screen = make<l3d_screen_factory_xshm>();
    EXPECT_TRUE(screen && is_shared(*screen));
    EXPECT_EQ(wrong_after_pictures(*screen, 12), 0);
    return testing::Test::HasFailure() ? 1 : 0;
}

TEST(screen_x11_shm, segments_of_system_v_serve_where_files_do_not) {
    L3D_EXPECT_WELL(in_process_of_its_own(shares_segments_without_files));
}

/// The kernel's own reason, and that of files.
int declines_within_limit(const std::string& limit, const std::string& value,
                          const std::string& why) {
    const xvfb server("301x207x24");
    if (!server.started() || !limits_segments(limit, value))
        return not_permitted;
    const rlimit no_files{0, 0};
    setrlimit(RLIMIT_FSIZE, &no_files);
    expect_wire("the limit of file sizes (ulimit -f) is too small; " + why);
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
    const rlimit no_files{0, 0};
    if (!server.started() || unshare(CLONE_NEWIPC) != 0 || setrlimit(RLIMIT_FSIZE, &no_files) != 0)
        return not_permitted;
    expect_wire("the X server sees other memory than ours");
    return testing::Test::HasFailure() ? 1 : 0;
}

TEST(screen_x11_shm, another_programs_memory_under_our_number) {
    L3D_EXPECT_WELL(in_process_of_its_own(declines_foreign_memory));
}

} // namespace
