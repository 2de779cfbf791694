// SPDX-License-Identifier: MIT
// Our screens against bare Xlib: how many pictures of 1024 x 768 reach a window in a second, and
// what one costs at 60 a second.
//
// Ours copy each picture, since the program may go on drawing; the peer always sends the same
// memory and waits for the server each time. Both run in turn on a server of their own, and the
// medians are compared. A mark in each picture's first pixel proves that the last has arrived.
#include "bench/bare_x11.h"
#include "processor_time.h"
#include "tool_2d/image.h"
#include "tool_2d/x11/screen_x11.h"
#include "tool_2d/xvfb.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <thread>
#include <vector>

namespace {

using std::chrono::steady_clock;

constexpr l3d_size size{1024, 768};
constexpr int rounds = 21, pictures_per_round = 100;

double seconds_since(steady_clock::time_point start) {
    return std::chrono::duration<double>(steady_clock::now() - start).count();
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::ranges::nth_element(values, middle);
    return *middle;
}

/// Each picture is another, and none is black.
std::uint32_t next_mark() {
    static std::uint32_t mark = 0;
    return ++mark;
}

/// Shows as a program does: a picture, then the events.
void show(l3d_screen& screen, std::uint32_t mark) {
    screen.pixels().row(0)[0] = mark;
    screen.show();
    l3d_event event;
    while (screen.next_event(event)) {
    }
}

/// Pictures per second of one round.
double rate(const std::function<void(std::uint32_t)>& put,
            const std::function<void(std::uint32_t)>& wait_for) {
    const auto start = steady_clock::now();
    std::uint32_t mark = 0;
    for (int i = 0; i < pictures_per_round; ++i)
        put(mark = next_mark());
    wait_for(mark);
    return pictures_per_round / seconds_since(start);
}

/// Processor time of this process per picture, at 60 pictures a second.
double cost_at_60(const std::function<void(std::uint32_t)>& put) {
    constexpr int pictures = 120;
    const double before = processor_seconds();
    auto due = steady_clock::now();
    for (int i = 0; i < pictures; ++i) {
        put(next_mark());
        due += std::chrono::nanoseconds(1000000000 / 60);
        std::this_thread::sleep_until(due);
    }
    return (processor_seconds() - before) / pictures;
}

/// Median time from a picture to the server's answer, at 60 a second.
double latency(bool shared) {
    const auto timer = image_timer::open(size, shared);
    if (!timer)
        return 0;
    l3d_image picture(size);
    std::vector<double> times;
    for (int i = 0; i < 60; ++i) {
        const auto start = steady_clock::now();
        timer->put(picture.pixels());
        times.push_back(seconds_since(start));
        std::this_thread::sleep_until(start + std::chrono::nanoseconds(1000000000 / 60));
    }
    return median(times);
}

/// One row of the table. False if our screen cannot be had.
bool compare(const char* name, const l3d_screen_factory& factory, bare_x11& bare, bool shared) {
    l3d_service refusal;
    const auto screen = factory.create({size, "bench", "", 1}, refusal);
    if (!screen) {
        std::fprintf(stderr, "blit_bench: %s\n", refusal.why.c_str());
        return false;
    }
    if (const auto remark = screen->take_remark(); !remark.empty()) {
        std::fprintf(stderr, "blit_bench: %s\n", remark.c_str());
        return false;
    }
    const window_watcher watcher;
    const auto our_put = [&](std::uint32_t mark) { show(*screen, mark); };
    const auto our_wait = [&](std::uint32_t mark) {
        screen->wait(std::chrono::nanoseconds(0));
        watcher.wait_for(mark);
    };
    const auto their_put = [&](std::uint32_t mark) {
        shared ? bare.put_shared(mark) : bare.put_wired(mark);
    };
    std::vector<double> ours, theirs;
    for (int i = 0; i < rounds; ++i) {
        ours.push_back(rate(our_put, our_wait));
        theirs.push_back(rate(their_put, [](std::uint32_t) {}));
    }
    const double mine = median(ours), peer = median(theirs);
    const double my_cost = cost_at_60(our_put), their_cost = cost_at_60(their_put);
    std::printf("%-7s %8.0f %8.0f %7.3f %11.3f %11.3f %10.3f\n", name, mine, peer, mine / peer,
                1e3 * my_cost, 1e3 * their_cost, 1e3 * latency(shared));
    return true;
}

} // namespace

int main() {
    // Room for two windows side by side: what is covered costs nothing to draw.
    const xvfb server("2100x800x24");
    const auto bare = server.started() ? bare_x11::open(size, size.width + 16) : nullptr;
    if (!bare) {
        std::fprintf(stderr, "blit_bench: no Xvfb with shared memory\n");
        return 1;
    }
    std::printf("pictures of %dx%d, 32 bits per pixel; medians of %d rounds of %d in turn\n\n",
                size.width, size.height, rounds, pictures_per_round);
    std::printf("%-7s %8s %8s %7s %11s %11s %10s\n", "", "l3d/s", "Xlib/s", "ratio", "l3d CPU ms",
                "Xlib CPU ms", "latency ms");
    const bool shared = compare("xshm", l3d_screen_factory_xshm(), *bare, true);
    const bool wired = compare("ximage", l3d_screen_factory_ximage(), *bare, false);
    return shared && wired ? 0 : 1;
}
