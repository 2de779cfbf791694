// SPDX-License-Identifier: MIT
// Grids that show both sides of a surface, and quads that triangles stand for.
#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "raster/surfaces/surface_rasterizer_sw.h"
#include "tool_2d/image.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace {

constexpr l3d_size size{64, 48};

struct place {
    int x, y;
};

/// A grid of a row of quads whose light is the same everywhere: the level 100, or a normal with
/// that level.
l3d_surface_part grid_of(const std::array<place, 6>& corners, l3d_shade mode) {
    l3d_surface_part part;
    part.grid.resize(3, 2);
    part.grid.shows_both = true;
    part.block_rows.first[1] = 1;
    part.block_columns.first[1] = 2;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const std::size_t at = part.grid.index(static_cast<int>(i) / 3, static_cast<int>(i) % 3);
        part.grid.x[at] = 256 * corners[i].x;
        part.grid.y[at] = 256 * corners[i].y;
        part.grid.inv_w[at] = 1;
        for (auto& component : part.grid.normal)
            component[at] = 0;
        if (mode == l3d_shade::levels)
            part.grid.normal[0][at] = 100;
        else
            part.grid.normal[2][at] = 1;
    }
    return part;
}

int level_at(l3d_surface_rasterizer& rasterizer, const l3d_surface_part& part, l3d_shade mode,
             place where) {
    l3d_image picture(size);
    constexpr float cosine = 100 / 229.5F;
    const l3d_shading shading{
        .mode = mode, .light = {0, std::sqrt(1 - cosine * cosine), cosine}, .ray = {0, 0, 0}};
    rasterizer.begin(picture.pixels(), nullptr, shading);
    const l3d_surface_part* const parts[] = {&part};
    rasterizer.draw(parts);
    rasterizer.finish();
    return static_cast<int>(picture.pixels().row(where.y)[static_cast<std::size_t>(where.x)] & 255);
}

constexpr std::array modes{l3d_shade::levels, l3d_shade::lambert, l3d_shade::gouraud,
                           l3d_shade::flat};

template <class Check> void for_rasterizers(const Check& check) {
    l3d_workers workers(1);
    l3d_surface_rasterizer_sw fast(workers);
    l3d_surface_rasterizer_scalar slow;
    for (const l3d_shade mode : modes) {
        check(fast, mode);
        check(slow, mode);
    }
}

constexpr int lit = 126, unlit = 26;

TEST(shown_sides, are_those_that_quads_turn) {
    // The second quad comes back below the first one, so it turns the other way.
    const std::array<place, 6> right{{{10, 10}, {30, 10}, {10, 22}, {10, 20}, {30, 20}, {10, 32}}};
    const std::array<place, 6> left{{{10, 20}, {30, 20}, {10, 32}, {10, 10}, {30, 10}, {10, 22}}};
    for_rasterizers([&](l3d_surface_rasterizer& by, l3d_shade mode) {
        EXPECT_NEAR(level_at(by, grid_of(right, mode), mode, {20, 12}), unlit, 1);
        EXPECT_NEAR(level_at(by, grid_of(right, mode), mode, {14, 25}), lit, 1);
        EXPECT_NEAR(level_at(by, grid_of(left, mode), mode, {20, 12}), lit, 1);
        EXPECT_NEAR(level_at(by, grid_of(left, mode), mode, {14, 25}), unlit, 1);
    });
}

TEST(shown_sides, of_a_folded_quad_are_both) {
    // Its sides cross in (20, 20): what is above turns to the right, what is below to the left.
    const std::array<place, 6> crossed{{{10, 10}, {30, 10}, {31, 10}, {30, 30}, {10, 30}, {9, 30}}};
    for_rasterizers([&](l3d_surface_rasterizer& by, l3d_shade mode) {
        EXPECT_NEAR(level_at(by, grid_of(crossed, mode), mode, {19, 12}), unlit, 1);
        EXPECT_NEAR(level_at(by, grid_of(crossed, mode), mode, {19, 27}), lit, 1);
    });
}

TEST(shown_sides, of_a_quad_whose_narrow_end_is_folded_are_one) {
    // Its sides cross in (20, 11), and the piece at that end goes on to (20, 18).
    const std::array<place, 6> pole{{{21, 10}, {19, 10}, {18, 10}, {4, 26}, {36, 26}, {37, 26}}};
    const std::array<place, 6> turned{{{19, 10}, {21, 10}, {22, 10}, {36, 26}, {4, 26}, {3, 26}}};
    for_rasterizers([&](l3d_surface_rasterizer& by, l3d_shade mode) {
        for (const place where : {place{19, 12}, {20, 12}, {19, 13}, {20, 20}}) {
            EXPECT_NEAR(level_at(by, grid_of(pole, mode), mode, where), unlit, 1);
            EXPECT_NEAR(level_at(by, grid_of(turned, mode), mode, where), lit, 1);
        }
    });
}

TEST(shown_sides, of_quads_too_large_for_the_lanes_are_right_too) {
    const std::array<place, 6> large{
        {{-300, -200}, {300, -200}, {301, -200}, {-300, 200}, {300, 200}, {301, 200}}};
    for_rasterizers([&](l3d_surface_rasterizer& by, l3d_shade mode) {
        EXPECT_NEAR(level_at(by, grid_of(large, mode), mode, {20, 15}), unlit, 1);
    });
}

TEST(cut_quads, are_not_drawn) {
    const std::array<place, 6> flat{{{10, 20}, {30, 20}, {50, 20}, {10, 10}, {30, 10}, {50, 10}}};
    for_rasterizers([&](l3d_surface_rasterizer& by, l3d_shade mode) {
        l3d_surface_part part = grid_of(flat, mode);
        part.grid.cut = {static_cast<std::uint32_t>(part.grid.index(0, 1))};
        EXPECT_NEAR(level_at(by, part, mode, {20, 15}), lit, 1);
        EXPECT_EQ(level_at(by, part, mode, {40, 15}), 0);
        part.grid.cut = {static_cast<std::uint32_t>(part.grid.index(0, 0))};
        EXPECT_EQ(level_at(by, part, mode, {20, 15}), 0);
        EXPECT_NEAR(level_at(by, part, mode, {40, 15}), lit, 1);
    });
}

} // namespace
