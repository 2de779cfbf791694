// SPDX-License-Identifier: MIT
// mesh_steps: more steps where a patch bends more, and the same ones on both sides of a border.
#include "raster/paths/mesh_steps_p.h"

#include "raster/mesh_patches.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <span>

namespace {

std::array<int, 4> quarters_along(const l3d_detail::mesh_dicing& dicing) {
    return dicing.along.of_quarter;
}

/// A patch whose upper border bends in its last quarter most.
l3d_mesh_patch bent_in_a_corner() {
    l3d_mesh_patch result;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result.points[i][j] = {100 * double(j), 100 * double(i)};
    result.points[0][3] = {330, 60};
    return result;
}

TEST(mesh_steps, are_more_where_a_patch_bends_more) {
    const l3d_mesh_patch patch = bent_in_a_corner();
    const auto dicing =
        l3d_detail::dicings_of({&patch, 1}, l3d_detail::mesh_colors::bilinear).front();
    ASSERT_TRUE(dicing.along.is_quartered());
    const std::array<int, 4> steps = quarters_along(dicing);
    EXPECT_LT(steps[0], steps[3]);
    EXPECT_LT(dicing.down.of_quarter[3], dicing.down.of_quarter[0]);
}

/// A Coons patch whose borders are quarters of a circle.
TEST(mesh_steps, keep_the_bound_up_to_the_stated_radius) {
    const auto disc = [](double r) {
        const double k = 0.5523 * r;
        return l3d_mesh_patch::coons({{{-r, 0},
                                       {-r, -k},
                                       {-k, -r},
                                       {0, -r},
                                       {k, -r},
                                       {r, -k},
                                       {r, 0},
                                       {r, k},
                                       {k, r},
                                       {0, r},
                                       {-k, r},
                                       {-r, k}}},
                                     {});
    };
    for (const double radius : {1e2, 1e3, 1e4, 4e4, 1e6}) {
        const std::array patches{disc(radius)};
        const auto dicing =
            l3d_detail::dicings_of(patches, l3d_detail::mesh_colors::bilinear).front();
        for (const l3d_detail::mesh_steps& steps : {dicing.along, dicing.down}) {
            const double n = steps.is_quartered() ? 4 * steps.of_quarter[0] : steps.whole;
            const double off = 2.76 * radius / (8 * n * n);
            EXPECT_LE(off, radius <= 4e4 ? 1.0 / 16 : 1.4) << radius;
        }
    }
}

TEST(mesh_steps, are_the_same_on_both_sides_of_a_border) {
    const l3d_mesh_patch patch = bent_in_a_corner();
    const auto dicings = [](std::span<const l3d_mesh_patch> patches) {
        return l3d_detail::dicings_of(patches, l3d_detail::mesh_colors::bilinear);
    };
    const std::array<int, 4> alone = quarters_along(dicings({&patch, 1}).front());
    // a straight patch below, whose upper border runs the other way
    l3d_mesh_patch below;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            below.points[i][j] = {300 - 100 * double(j), 300 + 100 * double(i)};
    const auto both = dicings(std::array{patch, below});
    EXPECT_EQ(quarters_along(both[0]), alone);
    EXPECT_EQ(quarters_along(both[1]), (std::array{alone[3], alone[2], alone[1], alone[0]}));
    // and one to its right, whose columns are rows
    const auto turned_too = dicings(std::array{turned(patch), turned(below)});
    EXPECT_EQ(turned_too[1].down.of_quarter, quarters_along(both[1]));
    const auto other_order = dicings(std::array{below, patch});
    EXPECT_EQ(quarters_along(other_order[0]), quarters_along(both[1]));
    EXPECT_EQ(quarters_along(other_order[1]), alone);
    // a strip that bends in one place is glued to itself the other way round
    l3d_mesh_patch twisted = patch;
    for (std::size_t j = 0; j < 4; ++j) {
        twisted.points[0][j] = {100 * double(j), 0};
        twisted.points[3][j] = {100 * double(j), 300};
    }
    twisted.points[1][2].x += 80;
    const std::array<int, 4> one_way = quarters_along(dicings({&twisted, 1}).front());
    EXPECT_NE(one_way[0], one_way[3]);
    for (std::size_t j = 0; j < 4; ++j)
        twisted.points[3][j] = twisted.points[0][3 - j];
    const std::array<int, 4> both_ways = quarters_along(dicings({&twisted, 1}).front());
    EXPECT_EQ(both_ways[0], both_ways[3]);
    EXPECT_EQ(both_ways[1], both_ways[2]);
}

TEST(mesh_steps, need_not_agree_about_a_pole) {
    l3d_mesh_patch pole = bent_in_a_corner(), other;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            other.points[i][j] = {-100 * double(j), 10 * double(i)};
    for (std::size_t i = 0; i < 4; ++i)
        pole.points[i][0] = other.points[i][0] = {0, 0};
    const auto dicings =
        l3d_detail::dicings_of(std::array{pole, other}, l3d_detail::mesh_colors::bilinear);
    EXPECT_GT(dicings[0].down.whole, dicings[1].down.whole);
}

} // namespace
