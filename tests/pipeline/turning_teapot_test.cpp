// SPDX-License-Identifier: MIT
// A teapot that turns slowly: no pixel flickers by more than the bounds of both frames allow.
#include "hard_edged.h"
#include "certified_picture.h"
#include "words_of.h"

#include "raster/parallel/workers.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <string>
#include <thread>
#include <vector>

namespace {

using pipeline_tests::certified;
using pipeline_tests::certified_picture;
using pipeline_tests::certified_sum;

/// So much turns what is 40 pixels from the axis, as of 160 x 120, by a twelfth of a pixel. Units:
/// degrees.
constexpr double turn = 0.12;

struct frame {
    certified_picture drawn;
    std::vector<reference::box_pixel> exact;
    certified_sum sum;
};

dice_tests::scene turned(int number, l3d_size size) {
    reference::camera eye = reference::project_view("full").eye;
    const double angle = turn * number * 3.14159265358979 / 180;
    const double x = eye.eye.x - eye.target.x, z = eye.eye.z - eye.target.z;
    eye.eye.x = eye.target.x + x * std::cos(angle) - z * std::sin(angle);
    eye.eye.z = eye.target.z + x * std::sin(angle) + z * std::cos(angle);
    return {reference::load_bpt_plain("data/teapot.bpt"), eye, size};
}

l3d_afd_settings smooth() {
    l3d_afd_settings settings = hard_edged();
    settings.antialias = true;
    settings.light = {reference::project_light.x, reference::project_light.y,
                      reference::project_light.z};
    return settings;
}

frame frame_of(int number, l3d_size size) {
    const dice_tests::scene s = turned(number, size);
    const reference::box_image exact(s.patches, s.eye, s.picture(), reference::project_light);
    frame result{certified(s, smooth()), {exact.pixels().begin(), exact.pixels().end()}, {}};
    result.sum.add(result.drawn, exact);
    return result;
}

/// What changes from frame to frame, beside what should. Units: levels.
struct flicker {
    double largest = 0, squares = 0; ///< of what is drawn, less that of the exact picture
    double largest_change = 0;       ///< of the exact picture
    long pixels = 0;                 ///< that change in the exact picture
    long exceptions = 0;

    void add(const frame& before, const frame& after) {
        for (std::size_t i = 0; i < after.exact.size(); ++i) {
            const reference::box_pixel &p = before.exact[i], &q = after.exact[i];
            const double change = q.level - p.level;
            const double off = std::abs(after.drawn.levels[i] - before.drawn.levels[i] - change);
            const double bounds = static_cast<double>(before.drawn.bounds[i]) +
                                  static_cast<double>(after.drawn.bounds[i]);
            exceptions += !(off <= bounds + p.unsure + q.unsure);
            if (std::abs(change) < 1e-6)
                continue;
            ++pixels;
            largest = std::max(largest, off);
            largest_change = std::max(largest_change, std::abs(change));
            squares += off * off;
        }
    }
};

void expect_no_flicker(int frames, l3d_size size) {
    l3d_workers workers(static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
    std::vector<frame> all(static_cast<std::size_t>(frames));
    workers.for_each(frames,
                     [&](int n, int) { all[static_cast<std::size_t>(n)] = frame_of(n, size); });
    certified_sum sum;
    flicker between;
    for (std::size_t n = 0; n < all.size(); ++n) {
        sum.add(all[n].sum);
        if (n > 0)
            between.add(all[n - 1], all[n]);
    }
    sum.print(std::to_string(frames) + " frames");
    std::printf("%ld pixels change, by %.1f levels at most; what is drawn changes otherwise by "
                "%.2f at most, rms %.2f; %ld exceptions\n",
                between.pixels, between.largest_change, between.largest,
                std::sqrt(between.squares / static_cast<double>(std::max(1L, between.pixels))),
                between.exceptions);
    EXPECT_EQ(sum.exceptions, 0) << sum.where;
    EXPECT_EQ(between.exceptions, 0);
    EXPECT_GT(between.pixels, frames * size.width * size.height / 20);
}

TEST(turning_teapot, does_not_flicker) {
    expect_no_flicker(thorough ? 6 : 2, {40, 30});
}

/// Some minutes.
TEST(turning_teapot, DISABLED_does_not_flicker_in_two_hundred_frames) {
    expect_no_flicker(200, {160, 120});
}

/// A pixel that is far darker or brighter than in the frames before and after. The exact picture
/// changes by 29.4 levels a frame at most, and has none.
TEST(turning_teapot, has_no_sparks) {
    constexpr l3d_size size{160, 120};
    const int frames = thorough ? 200 : 20, spark = 40;
    std::array<std::vector<std::uint32_t>, 3> levels;
    for (int n = 0; n < frames; ++n) {
        const dice_tests::scene s = turned(n, size);
        l3d_patch_scene world;
        world.add(s.model, s.placement);
        l3d_pipeline_afd pipeline(l3d_memory_canvas(size), world, s.camera, smooth());
        pipeline.draw_event();
        std::rotate(levels.begin(), levels.begin() + 1, levels.end());
        levels[2] = words_of(pipeline.screen().pixels());
        for (std::size_t i = 0; i < levels[0].size(); ++i) {
            const auto level = [&](std::size_t of) {
                return static_cast<int>(levels[of][i] & 255);
            };
            const int rise = level(1) - level(0), fall = level(1) - level(2);
            EXPECT_FALSE((rise > spark && fall > spark) || (rise < -spark && fall < -spark))
                << "frame " << n - 1 << ", pixel " << i % 160 << ", " << i / 160 << ": " << level(0)
                << ", " << level(1) << ", " << level(2);
        }
    }
}

} // namespace
