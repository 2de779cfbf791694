// SPDX-License-Identifier: MIT
// l3d_path: arcs against the ellipses that they are of; coordinates that are moved.
#include "raster/paths/path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace {

struct curve_list {
    std::vector<l3d_curve_2d> curves;
    l3d_point_2d first{}, last{};

    void move(l3d_point_2d to) { first = last = to; }
    void line(l3d_point_2d to) { last = to; }
    void curve(const l3d_curve_2d& c) {
        curves.push_back(c);
        last = {c.points[3][0] / c.points[3][2], c.points[3][1] / c.points[3][2]};
    }
    void close() {}
};

struct corner_list {
    std::vector<l3d_point_2d> corners;

    void move(l3d_point_2d to) { corners.push_back(to); }
    void lines(std::span<const l3d_point_2d> to) {
        corners.insert(corners.end(), to.begin(), to.end());
    }
    void curve(const l3d_curve_2d&) {}
    void close() {}
};

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Each of n curves leads through an n-th of the angles, and is in the middle of them at 1/2.
void expect_arc(const curve_list& found, l3d_point_2d center, l3d_point_2d radii, double turn,
                double begin, double sweep) {
    constexpr double degree = std::numbers::pi / 180;
    const double cosine = std::cos(turn * degree), sine = std::sin(turn * degree);
    const auto pieces = static_cast<double>(found.curves.size());
    for (std::size_t i = 0; i < found.curves.size(); ++i)
        for (const double t : {0.0, 0.2, 0.5, 0.7, 1.0}) {
            const auto p = found.curves[i].evaluate(t);
            const double dx = p[0] / p[2] - center.x, dy = p[1] / p[2] - center.y;
            const double x = (dx * cosine + dy * sine) / radii.x;
            const double y = (dy * cosine - dx * sine) / radii.y;
            ASSERT_NEAR(std::hypot(x, y), 1, 1e-12);
            if (t == 0.2 || t == 0.7)
                continue;
            const double angle = degree * (begin + sweep * (static_cast<double>(i) + t) / pieces);
            ASSERT_NEAR(x, std::cos(angle), 1e-12);
            ASSERT_NEAR(y, std::sin(angle), 1e-12);
        }
}

TEST(path, has_arcs_that_are_on_their_ellipse) {
    std::mt19937 random(5);
    for (int n = 0; n < 2000; ++n) {
        const l3d_point_2d center{uniform(random, -9, 9), uniform(random, -9, 9)};
        const l3d_point_2d radii{uniform(random, 0.5, 30), uniform(random, 0.5, 30)};
        const double turn = uniform(random, -230, 230), begin = uniform(random, -520, 520);
        const double sweep = uniform(random, -745, 745);
        l3d_path path;
        path.arc_to(center, radii, turn, begin, sweep);
        curve_list found;
        path.visit(found);
        const double quarters = std::abs(sweep) / 90;
        ASSERT_EQ(found.curves.size(), static_cast<std::size_t>(std::ceil(quarters))) << n;
        expect_arc(found, center, radii, turn, begin, sweep);
    }
}

TEST(path, tells_what_is_no_number_in_arcs) {
    const double nan = std::nan("");
    for (std::size_t bad = 0; bad < 7; ++bad) {
        std::vector<double> numbers(7, 1.0);
        numbers[bad] = nan;
        l3d_path path;
        path.arc_to({numbers[0], numbers[1]}, {numbers[2], numbers[3]}, numbers[4], numbers[5],
                    numbers[6]);
        EXPECT_FALSE(path.is_number()) << bad;
    }
}

TEST(path, has_circles_that_end_exactly_where_they_begin) {
    std::mt19937 random(6);
    for (int n = 0; n < 200; ++n) {
        const l3d_point_2d center{uniform(random, -900, 900), uniform(random, -900, 900)};
        const double radius = uniform(random, 100, 300);
        l3d_path path;
        path.add_circle(center, radius);
        curve_list found;
        path.visit(found);
        ASSERT_EQ(found.curves.size(), 4u);
        expect_arc(found, center, {radius, radius}, 0, 0, 360);
        EXPECT_EQ(found.first.x, found.last.x);
        EXPECT_EQ(found.first.y, found.last.y);
    }
}

/// Wherever the point is, and in both coordinates.
TEST(path, moves_what_is_beyond_its_reach_and_tells_what_is_no_number) {
    constexpr double most = 1 << 30, infinity = std::numeric_limits<double>::infinity();
    const double beyond = std::nextafter(most, infinity);
    for (std::size_t place = 0; place < 14; ++place)
        for (const double value : {0.0, -0.0, 1e-320, most, beyond, infinity, std::nan("")})
            for (const double sign : {1.0, -1.0}) {
                std::vector<l3d_point_2d> corners(7);
                for (std::size_t i = 0; i < corners.size(); ++i)
                    corners[i] = {double(i) + 0.5, double(i) - 0.5};
                auto& [x, y] = corners[place / 2];
                double& coordinate = place % 2 == 0 ? x : y;
                coordinate = std::copysign(value, sign);
                l3d_path path;
                path.add_polygon(corners);
                ASSERT_EQ(path.is_number(), !std::isnan(value)) << place << ", " << value;
                if (std::isnan(value))
                    continue;
                coordinate = std::clamp(coordinate, -most, most);
                corner_list found;
                path.visit(found);
                ASSERT_EQ(found.corners.size(), corners.size());
                for (std::size_t i = 0; i < corners.size(); ++i) {
                    ASSERT_EQ(found.corners[i].x, corners[i].x) << place << ", " << value;
                    ASSERT_EQ(found.corners[i].y, corners[i].y) << place << ", " << value;
                }
            }
}

} // namespace
