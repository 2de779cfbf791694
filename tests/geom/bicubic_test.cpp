// SPDX-License-Identifier: MIT
// Patches of other degrees as bicubic ones: raised, and reduced where that changes nothing.
#include "patch_points.h"

#include <gtest/gtest.h>

#include <random>

namespace {

l3d_patch_points random_patch(int degree_u, int degree_v, std::mt19937& random) {
    l3d_patch_points patch{degree_u, degree_v, {}};
    std::uniform_real_distribution<double> number(1, 9);
    for (int i = 0; i < (degree_u + 1) * (degree_v + 1); ++i)
        patch.points.push_back({number(random), number(random), number(random)});
    return patch;
}

TEST(elevation, keeps_the_surface) {
    std::mt19937 random(17);
    for (int degree_u = 1; degree_u <= 3; ++degree_u)
        for (int degree_v = 1; degree_v <= 3; ++degree_v) {
            const l3d_patch_points patch = random_patch(degree_u, degree_v, random);
            const auto net = l3d_as_bicubic(patch);
            ASSERT_TRUE(net);
            const l3d_patch_points bicubic{3, 3, {net->begin(), net->end()}};
            for (const double u : {0.0, 0.3, 0.8, 1.0})
                for (const double v : {0.0, 0.2, 0.6, 1.0})
                    for (std::size_t k = 0; k < 3; ++k)
                        EXPECT_NEAR(on_surface(bicubic, u, v)[k], on_surface(patch, u, v)[k],
                                    1e-14 * 9)
                            << degree_u << degree_v;
            EXPECT_EQ(bicubic.points.front(), patch.points.front());
            EXPECT_EQ(bicubic.points.back(), patch.points.back());
        }
}

TEST(elevation, keeps_a_common_boundary_common) {
    std::mt19937 random(23);
    for (int degree = 1; degree <= 3; ++degree)
        for (int i = 0; i < 100; ++i) {
            // The row v = 0 of one patch is the column u = 1 of the other, backwards.
            const l3d_patch_points a = random_patch(degree, 2, random);
            l3d_patch_points b = random_patch(3, degree, random);
            const std::size_t last = points_along(degree) - 1;
            for (std::size_t k = 0; k <= last; ++k)
                b.points[4 * k + 3] = a.points[last - k];
            const auto net_a = l3d_as_bicubic(a);
            const auto net_b = l3d_as_bicubic(b);
            ASSERT_TRUE(net_a && net_b);
            for (std::size_t k = 0; k < 4; ++k)
                ASSERT_EQ((*net_b)[4 * k + 3], (*net_a)[3 - k]) << degree << " " << k;
        }
}

/// The same curve in the next degree, the plainest way.
std::vector<triple> raised(const std::vector<triple>& b) {
    const auto n = static_cast<double>(b.size());
    std::vector<triple> result{b[0]};
    for (std::size_t i = 1; i < b.size(); ++i) {
        const double t = static_cast<double>(i) / n;
        triple& p = result.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            p[k] = t * b[i - 1][k] + (1 - t) * b[i][k];
    }
    result.push_back(b.back());
    return result;
}

/// A bicubic patch written as one of higher degrees.
l3d_patch_points raised_patch(const l3d_patch_points& bicubic, int degree_u, int degree_v) {
    std::vector<std::vector<triple>> columns(points_along(degree_u));
    for (auto row = bicubic.points.begin(); row != bicubic.points.end(); row += 4) {
        std::vector<triple> line(row, row + 4);
        while (line.size() < columns.size())
            line = raised(line);
        for (std::size_t i = 0; i < line.size(); ++i)
            columns[i].push_back(line[i]);
    }
    l3d_patch_points result{degree_u, degree_v, {}};
    for (std::vector<triple>& column : columns)
        while (column.size() < points_along(degree_v))
            column = raised(column);
    for (std::size_t row = 0; row < points_along(degree_v); ++row)
        for (const std::vector<triple>& column : columns)
            result.points.push_back(column[row]);
    return result;
}

TEST(reduction, finds_the_bicubic_patch_that_was_raised) {
    std::mt19937 random(37);
    for (int degree_u = 3; degree_u <= 15; ++degree_u)
        for (int degree_v = 4; degree_v <= 15; ++degree_v) {
            const l3d_patch_points bicubic = random_patch(3, 3, random);
            const auto net = l3d_as_bicubic(raised_patch(bicubic, degree_u, degree_v));
            ASSERT_TRUE(net) << degree_u << " by " << degree_v;
            for (std::size_t i = 0; i < 16; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_NEAR((*net)[i][k], bicubic.points[i][k], 0x1p-46 * 9 * 25);
        }
}

TEST(reduction, refuses_what_is_not_bicubic) {
    std::mt19937 random(43);
    for (int degree = 4; degree <= 15; ++degree) {
        l3d_patch_points patch = raised_patch(random_patch(3, 3, random), degree, degree);
        ASSERT_TRUE(l3d_as_bicubic(patch));
        patch.points[patch.points.size() / 2][1] += 1e-11;
        EXPECT_FALSE(l3d_as_bicubic(patch)) << degree;
    }
}

TEST(elevation, refuses_what_it_cannot_do) {
    std::mt19937 random(29);
    EXPECT_FALSE(l3d_as_bicubic(random_patch(4, 1, random)));
    EXPECT_FALSE(l3d_as_bicubic(random_patch(2, 15, random)));
    EXPECT_FALSE(l3d_as_bicubic(random_patch(16, 1, random)));
    EXPECT_FALSE(l3d_as_bicubic(l3d_patch_points{}));
    EXPECT_FALSE(l3d_as_bicubic(random_patch(0, 2, random)));
    l3d_patch_points patch = random_patch(2, 3, random);
    patch.points.pop_back();
    EXPECT_FALSE(l3d_as_bicubic(patch));
}

} // namespace
