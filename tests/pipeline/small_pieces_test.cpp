// SPDX-License-Identifier: MIT
// Triangles of a few pixels: which pixels they cover, in which order they come, how they are lit.
#include "pipeline/zsort/painter_items_p.h"
#include "pipeline/zsort/painter_order.h"
#include "pipeline/zsort/tile_cover_p.h"
#include "pipeline/zsort/tile_sight_p.h"

#include "painter_scenes.h"
#include "raster/parallel/simd_target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

namespace pipeline_tests {
namespace {

using namespace l3d_detail;

constexpr l3d_size window{75, 52};

/// Triangles of at most `reach` pixels that lie anywhere in the picture and a little beyond,
/// through each other. Some have no area, some corners on pixel centres. Materials are numbers
/// from 1.
std::vector<l3d_painter_triangle> small_triangles(unsigned count, int reach, unsigned seed) {
    std::mt19937 random(seed);
    const auto between = [&](int least, int most) {
        return least + static_cast<int>(random() % static_cast<unsigned>(most - least));
    };
    std::vector<l3d_painter_triangle> triangles(count);
    for (unsigned i = 0; i < count; ++i) {
        l3d_painter_triangle& triangle = triangles[i];
        triangle.material = i + 1;
        const int x = between(-4, window.width + 2), y = between(-4, window.height + 2);
        const auto inv_w = static_cast<float>(between(1 << 18, 1 << 20));
        for (l3d_micro_vertex& v : triangle.v) {
            v = {256 * x + between(0, 256 * reach),
                 256 * y + between(0, 256 * reach),
                 (inv_w + static_cast<float>(between(0, 1 << 16))) / (1 << 21),
                 {static_cast<float>(between(-99, 99)) / 99,
                  static_cast<float>(between(-99, 99)) / 99,
                  static_cast<float>(between(1, 99)) / 99}};
            if (i % 5 == 0) { // on a raster of half pixels
                v.x = v.x / 128 * 128;
                v.y = v.y / 128 * 128;
            }
        }
        if (i % 17 == 0)
            triangle.v[2] = triangle.v[1];
    }
    return triangles;
}

/// The fill rule, pixel by pixel: a centre on a left or top edge is inside.
bool covers_pixel(const std::array<l3d_micro_vertex, 3>& v, int column, int row) {
    const auto side = [](const l3d_micro_vertex& a, const l3d_micro_vertex& b, long x, long y) {
        return (long(b.x) - a.x) * (y - a.y) - (long(b.y) - a.y) * (x - a.x);
    };
    const long area = side(v[0], v[1], v[2].x, v[2].y);
    for (std::size_t k = 0; k < 3 && area != 0; ++k) {
        const l3d_micro_vertex &a = v[area > 0 ? k : (k + 1) % 3],
                               &b = v[area > 0 ? (k + 1) % 3 : k];
        const bool is_left_or_top = b.y < a.y || (b.y == a.y && b.x > a.x);
        if (side(a, b, 256L * column + 128, 256L * row + 128) < (is_left_or_top ? 0 : 1))
            return false;
    }
    return area != 0;
}

/// Pixels of the picture that a triangle covers.
int covered(const std::array<l3d_micro_vertex, 3>& v) {
    int count = 0;
    for (int row = 0; row < window.height; ++row)
        for (int column = 0; column < window.width; ++column)
            count += covers_pixel(v, column, row);
    return count;
}

void expect_cover(const painter_item& item, const std::array<l3d_micro_vertex, 3>& v) {
    constexpr int side = painter_item::small_side;
    int count = 0;
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column) {
            const bool bit = (item.cover >> (side * row + column) & 1) != 0;
            ASSERT_EQ(bit, covers_pixel(v, item.left + column, item.top + row))
                << column << ", " << row;
            count += bit;
        }
    ASSERT_EQ(count, covered(v));
}

TEST(small_pieces, items_know_the_pixels_that_a_small_triangle_covers) {
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        std::size_t known = 0, left_out = 0;
        for (unsigned seed = 1; seed <= 12; ++seed) {
            const auto triangles = small_triangles(200 + seed, 1 + static_cast<int>(seed), seed);
            const std::array<std::size_t, 2> ends{77, triangles.size()};
            painter_items items;
            items.begin(triangles, ends, window, false);
            items.make(1);
            items.make(0);
            items.finish();
            std::vector<bool> is_there(triangles.size());
            for (std::size_t chunk = 0; chunk < items.chunks(); ++chunk)
                for (const painter_item& item : items.of_chunk(chunk)) {
                    is_there[item.triangle] = true;
                    if (item.cover == 0)
                        continue;
                    ++known;
                    expect_cover(item, triangles[item.triangle].v);
                }
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                left_out += !is_there[i];
                ASSERT_TRUE(is_there[i] || covered(triangles[i].v) == 0) << target << " " << i;
            }
        }
        EXPECT_GT(known, 700u) << target;
        EXPECT_GT(left_out, 300u) << target;
    }
    l3d_set_simd_target("");
}

TEST(small_pieces, tiles_know_the_pixels_that_a_triangle_covers) {
    constexpr int side = 8;
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        int count = 0, without = 0;
        for (const int reach : {3, 9, 30, tile_cover_reach})
            for (const l3d_painter_triangle& triangle : small_triangles(200, reach, 7)) {
                const int left = (triangle.v[0].x >> 8) / side * side - 4 * side;
                const int top = (triangle.v[0].y >> 8) / side * side - 3 * side;
                const cover_tiles tiles{left, top, 7, 6};
                std::array<std::uint64_t, std::size_t{7} * 6> covers;
                tile_cover(triangle.v, tiles, covers.data());
                for (int row = 0; row < side * tiles.rows; ++row)
                    for (int column = 0; column < side * tiles.columns; ++column) {
                        const int tile = row / side * tiles.columns + column / side;
                        const int bit = side * (row % side) + column % side;
                        const bool is_covered = (covers[std::size_t(tile)] >> bit & 1) != 0;
                        ASSERT_EQ(is_covered, covers_pixel(triangle.v, left + column, top + row))
                            << target << ": " << column << ", " << row;
                        ++(is_covered ? count : without);
                    }
            }
        EXPECT_GT(count, 5000);
        EXPECT_GT(without, 50000);
    }
    l3d_set_simd_target("");
}

/// What find_sight says of each member and cell, against the plainest search.
void check_sight(std::span<const painter_entry> members) {
    tile_fronts fronts;
    std::vector<cell_sight> sight(members.size());
    find_sight(members, fronts, sight.data());
    for (std::size_t cell = 0; cell < fronts.size(); ++cell) {
        const auto is_in = [&](std::uint64_t cells) { return (cells >> cell & 1) != 0; };
        const painter_entry* last = nullptr;
        for (const painter_entry& member : members)
            if (is_in(member.cells) && (last == nullptr || member.node() > last->node()))
                last = &member;
        ASSERT_EQ(fronts[cell], last == nullptr ? -1 : last - members.data());
        for (std::size_t i = 0; i < members.size(); ++i) {
            const bool is_last = &members[i] == last;
            const bool is_near =
                is_in(members[i].cells) && !is_last && last->farthest < members[i].nearest;
            ASSERT_EQ(is_in(sight[i].shown), is_last) << i;
            ASSERT_EQ(is_in(sight[i].doubtful), is_near) << i;
        }
    }
}

TEST(small_pieces, what_the_sort_shows_of_a_tile_is_found_with_any_instructions) {
    std::mt19937 random(5);
    std::vector<painter_entry> members;
    for (std::uint32_t i = 0; i < 90; ++i) {
        const std::uint64_t some = std::uint64_t{random()} << 32 | random();
        const float farthest = 1 + static_cast<float>(random() % 16); // many are equally far
        members.push_back({farthest, farthest + static_cast<float>(random() % 4),
                           some & some >> (1 + i % 7), 3 * i, 0, 1});
    }
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        SCOPED_TRACE(target);
        for (const std::size_t count : {1u, 7u, 16u, 17u, 90u})
            check_sight(std::span(members).first(count));
    }
    l3d_set_simd_target("");
}

/// Squares of some pixels beside each other that fill the picture, two triangles each.
void add_layer(int pixels, float inv_w, std::vector<l3d_painter_triangle>& to) {
    const auto corner = [&](int x, int y) {
        return l3d_micro_vertex{256 * x, 256 * y, inv_w, {0, 0, 1}};
    };
    for (int y = 0; y < window.height; y += pixels)
        for (int x = 0; x < window.width; x += pixels) {
            const l3d_micro_vertex a = corner(x, y), b = corner(x + pixels, y),
                                   c = corner(x + pixels, y + pixels), d = corner(x, y + pixels);
            for (const std::array<l3d_micro_vertex, 3>& v : {std::array{a, b, c}, {a, c, d}})
                to.push_back({.v = v});
        }
}

TEST(small_pieces, behind_others_are_no_pieces_and_those_before_all_keep_their_order) {
    for (const int pixels : {3, 11}) { // those that know their pixels, and larger ones
        std::vector<l3d_painter_triangle> triangles;
        add_layer(pixels, 0.5f, triangles);
        const std::size_t in_front = triangles.size();
        add_layer(pixels, 0.25f, triangles);
        l3d_workers worker(1);
        l3d_painter_order order(worker);
        order.make(triangles, window, {.sides = false});
        std::vector<std::uint32_t> painted;
        for (const l3d_painter_piece& piece : order.pieces())
            painted.push_back(piece.triangle);
        EXPECT_EQ(order.counts().pairs, 0);
        EXPECT_TRUE(std::ranges::is_sorted(painted));
        EXPECT_FALSE(painted.empty());
        EXPECT_LE(painted.size(), in_front);
        EXPECT_LT(painted.back(), in_front);
    }
}

/// Words that tell the triangle of each pixel.
std::vector<std::uint32_t> numbers_of(const std::vector<l3d_painter_triangle>& triangles,
                                      int threads, l3d_painter_order_counts& counts) {
    l3d_workers workers(threads);
    l3d_painter_order order(workers);
    order.make(triangles, window, {.sides = false});
    counts = order.counts();
    std::vector<std::uint32_t> words(std::size_t{window.width} * std::size_t{window.height});
    const std::vector<l3d_material> materials = materials_of(show_numbers(), triangles.size());
    l3d_painter(workers).paint({words.data(), window.width, window.height, window.width},
                               show_numbers(), materials, order.triangles(), order.pieces(),
                               order.cuts());
    return words;
}

TEST(small_pieces, come_in_an_order_that_is_right_in_every_pixel) {
    std::int64_t pairs = 0, cuts = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        // Of the larger ones, tiles are larger than eight pixels.
        const auto triangles = small_triangles(400, 1 + static_cast<int>(3 * seed % 70), seed);
        const nearest_triangles exact = find_nearest(triangles, window);
        l3d_painter_order_counts counts;
        const auto numbers = numbers_of(triangles, 1, counts);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            ASSERT_TRUE(numbers[i] == exact.number[i] || exact.tied[i])
                << seed << ": " << i % window.width << ", " << i / window.width;
        pairs += counts.pairs;
        cuts += counts.cuts;
        EXPECT_EQ(numbers_of(triangles, 3, counts), numbers);
    }
    EXPECT_GT(pairs, 1000);
    EXPECT_GT(cuts, 100);
}

} // namespace
} // namespace pipeline_tests
