// SPDX-License-Identifier: MIT
// Jumps of all channels side by side against each channel of each pixel by itself.
#include "raster/refine/depth_steps_p.h"

#include "geom/random.h"
#include "raster/parallel/simd_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;

struct picture {
    l3d_size size;
    std::vector<std::uint32_t> words;

    explicit picture(l3d_size of)
        : size(of),
          words(static_cast<std::size_t>(of.width) * static_cast<std::size_t>(of.height)) {}
    l3d_pixels pixels() { return {words.data(), size.width, size.height, size.width}; }

    /// A channel's level; beyond its ends, the picture goes on with its last pixels.
    int level(std::int32_t x, std::int32_t y, int shift) const {
        const auto column = static_cast<std::size_t>(std::clamp(x, 0, size.width - 1));
        const auto row = static_cast<std::size_t>(std::clamp(y, 0, size.height - 1));
        const auto width = static_cast<std::size_t>(size.width);
        return static_cast<int>(words[row * width + column] >> shift & 255);
    }

    /// Whether there is a jump from a pixel to the next one in a direction, as the rule says it.
    bool jumps(std::int32_t x, std::int32_t y, int dx, int dy) const {
        for (const int shift : {0, 8, 16}) {
            const auto at = [&](int i) { return level(x + i * dx, y + i * dy, shift); };
            const int up = at(1) >= at(0) ? 1 : -1, rise = up * (at(1) - at(0));
            const int before = std::max(up * (at(0) - at(-1)), 0);
            const int after = std::max(up * (at(2) - at(1)), 0);
            const int kink = std::min(std::max(before, after), most_kink_levels);
            if (rise - std::max(2 * std::min(before, after), kink) > jump_levels)
                return true;
        }
        return false;
    }
};

/// Runs of nearly one colour, with edges and slopes between them.
picture random_picture(l3d_random& random, l3d_size size) {
    picture result(size);
    std::uint32_t word = 0;
    for (std::uint32_t& to : result.words) {
        const auto next = static_cast<std::uint32_t>(random.next());
        if (next % 5 == 0)
            word = next >> 3;
        else if (next % 5 < 3)
            word += next >> 8 & 0x03070f07;
        to = word;
    }
    return result;
}

l3d_pixel_box random_box(l3d_random& random, l3d_size size) {
    l3d_pixel_box result{random.between(0, size.width - 1), random.between(0, size.height - 1), 0,
                         0};
    result.right = random.between(result.left + 1, size.width);
    result.bottom = random.between(result.top + 1, size.height);
    return result;
}

TEST(depth_steps, finds_those_of_each_channel_and_no_others) {
    l3d_random random(7);
    for (int i = 0; i < 600; ++i) {
        picture of = random_picture(random, {1 + i % 150, 1 + i % 7});
        const l3d_pixel_box where = random_box(random, of.size);
        const l3d_pixel_box band{0, where.top + i % 2, of.size.width, where.bottom};
        for (const std::string& target : l3d_simd_targets()) {
            ASSERT_TRUE(l3d_set_simd_target(target));
            l3d_pixel_bits marks;
            marks.begin(of.size);
            mark_jumps(of.pixels(), where, band, marks);
            const auto jumps = [&](std::int32_t x, std::int32_t y, int dx, int dy) {
                return x >= where.left && x < where.right && y >= where.top && y < where.bottom &&
                       x + dx < of.size.width && y + dy < of.size.height && of.jumps(x, y, dx, dy);
            };
            for (std::int32_t y = 0; y < of.size.height; ++y)
                for (std::int32_t x = 0; x < of.size.width; ++x) {
                    const bool inside = x < band.right && y >= band.top && y < band.bottom;
                    const bool any = jumps(x, y, 1, 0) || jumps(x - 1, y, 1, 0) ||
                                     jumps(x, y, 0, 1) || jumps(x, y - 1, 0, 1);
                    ASSERT_EQ(marks.has(x, y), inside && any)
                        << target << ": " << x << ", " << y << ", picture " << i;
                }
        }
        ASSERT_TRUE(l3d_set_simd_target(""));
    }
}

} // namespace
