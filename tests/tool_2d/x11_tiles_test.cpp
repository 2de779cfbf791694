// SPDX-License-Identifier: MIT
// x11_tiles: every pixel that was added comes out, once, in few boxes.
#include "tool_2d/x11/x11_tiles_p.h"

#include <gtest/gtest.h>

#include <random>
#include <set>
#include <utility>

namespace {

using namespace l3d_detail;
using boxes = std::vector<l3d_pixel_box>;

constexpr l3d_size size{101, 77};

std::set<std::pair<int, int>> pixels_of(const boxes& list) {
    std::set<std::pair<int, int>> pixels;
    std::int64_t area = 0;
    for (const l3d_pixel_box& box : list) {
        area += box.area();
        for (int y = box.top; y < box.bottom; ++y)
            for (int x = box.left; x < box.right; ++x)
                pixels.insert({x, y});
    }
    EXPECT_EQ(area, static_cast<std::int64_t>(pixels.size())) << "boxes overlap";
    return pixels;
}

TEST(x11_tiles, what_is_added_comes_out_and_stays_within_its_tiles) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto below = [&](int most) {
        return static_cast<int>(random() % static_cast<unsigned>(most));
    };
    for (int run = 0; run < 200; ++run) {
        x11_tiles tiles(size);
        boxes added;
        for (int count = below(6); count >= 0; --count) {
            const int left = below(size.width), top = below(size.height);
            added.push_back({left, top, left + 1 + below(size.width - left),
                             top + 1 + below(size.height - top)});
            tiles.add(added.back());
        }
        std::set<std::pair<int, int>> touched;
        boxes found;
        while (!tiles.empty())
            for (const l3d_pixel_box& box : tiles.take(1 + below(3000)))
                found.push_back(box);
        EXPECT_EQ(tiles.pixels(), 0);
        const auto out = pixels_of(found);
        for (const l3d_pixel_box& box : added)
            for (int y = box.top; y < box.bottom; ++y)
                for (int x = box.left; x < box.right; ++x) {
                    EXPECT_TRUE(out.contains({x, y})) << x << ' ' << y;
                    touched.insert({x / x11_tiles::width, y / x11_tiles::height});
                }
        for (const auto& [x, y] : out)
            EXPECT_TRUE(touched.contains({x / x11_tiles::width, y / x11_tiles::height}));
    }
}

TEST(x11_tiles, a_whole_picture_is_one_box) {
    x11_tiles tiles(size);
    EXPECT_TRUE(tiles.empty());
    tiles.add(l3d_whole(size));
    EXPECT_EQ(tiles.pixels(), l3d_whole(size).area());
    EXPECT_EQ(tiles.take(), (boxes{l3d_whole(size)}));
    EXPECT_TRUE(tiles.empty());
    EXPECT_EQ(tiles.take(), boxes{});
}

TEST(x11_tiles, boxes_far_apart_stay_apart) {
    x11_tiles tiles(size);
    const l3d_pixel_box left{1, 2, 4, 5}, right{98, 3, 101, 4}, below{30, 70, 40, 77};
    for (const l3d_pixel_box& box : {left, right, below})
        tiles.add(box);
    // The last one lies in two tiles beside each other.
    EXPECT_EQ(tiles.take(), (boxes{left, right, below}));
}

TEST(x11_tiles, what_a_box_holds_is_removed_and_nothing_else) {
    x11_tiles tiles(size);
    const l3d_pixel_box left{1, 2, 4, 5}, right{98, 3, 101, 4};
    tiles.add(left);
    tiles.add(right);
    tiles.remove({2, 0, 101, 10});
    EXPECT_EQ(tiles.pixels(), left.area());
    EXPECT_EQ(tiles.take(), (boxes{left})) << "a part of it is not enough";
}

TEST(x11_tiles, takes_no_more_than_a_tile_above_what_was_asked_for) {
    x11_tiles tiles(size);
    tiles.add(l3d_whole(size));
    constexpr std::int64_t tile = std::int64_t{x11_tiles::width} * x11_tiles::height;
    std::int64_t rest = tiles.pixels();
    while (!tiles.empty()) {
        tiles.take(1);
        EXPECT_LT(tiles.pixels(), rest);
        EXPECT_GE(tiles.pixels(), rest - tile);
        rest = tiles.pixels();
    }
}

} // namespace
