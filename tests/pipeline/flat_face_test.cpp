// SPDX-License-Identifier: MIT
// flat_face: its triangles against those of the plainest ear clipping, and faces of many corners.
#include "pipeline/polygons/flat_face_p.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

namespace {

using l3d_detail::flat_face;
using triangles = std::vector<flat_face::triangle>;

struct place {
    double u = 0, v = 0;
};
using places = std::vector<place>;

double turn(const place& a, const place& b, const place& p) {
    return (b.u - a.u) * (p.v - a.v) - (b.v - a.v) * (p.u - a.u);
}

triangles triangles_of(const places& face) {
    l3d_polygon_mesh mesh;
    std::vector<std::uint32_t> corners(face.size());
    std::iota(corners.begin(), corners.end(), 0u);
    for (const place& p : face)
        mesh.vertices.push_back({p.u, p.v, 0.0});
    return flat_face(mesh, corners).triangles();
}

double doubled_area(const places& face) {
    double sum = 0;
    for (std::size_t i = 2; i < face.size(); ++i)
        sum += turn(face[0], face[i - 1], face[i]);
    return sum;
}

/// The slow twin: after each cut all corners are looked at again, and all others for each. Expects:
/// counterclockwise, not convex, and no corner that touches another or a side.
triangles clipped_slowly(const places& face) {
    std::vector<std::size_t> left(face.size());
    std::iota(left.begin(), left.end(), std::size_t{0});
    const auto at = [&](std::size_t i) { return left[i % left.size()]; };
    const auto is_ear = [&](std::size_t i) {
        const place &a = face[at(i - 1)], &b = face[at(i)], &c = face[at(i + 1)];
        return turn(a, b, c) > 0 && std::ranges::none_of(left, [&](std::size_t p) {
                   return p != at(i - 1) && p != at(i) && p != at(i + 1) &&
                          turn(a, b, face[p]) >= 0 && turn(b, c, face[p]) >= 0 &&
                          turn(c, a, face[p]) >= 0;
               });
    };
    triangles result;
    while (left.size() >= 3) {
        std::size_t ear = 1;
        while (left.size() > 3 && ear < left.size() && !is_ear(ear))
            ++ear;
        ear = ear < left.size() ? ear : 1;
        result.push_back({at(ear - 1), at(ear), at(ear + 1)});
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return result;
}

double random_number(std::mt19937& random, double least, double most) {
    return least + (most - least) * static_cast<double>(random()) / 0x1p32;
}

/// Seen from the origin, one corner after the other; spikes of any length.
places random_star(std::mt19937& random, std::size_t corners) {
    places face;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle =
            2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        const double radius = random_number(random, 0.05, 1);
        face.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return face;
}

/// A chain from left to right and another back above it: simple, with corners one behind the other.
places random_band(std::mt19937& random, std::size_t corners) {
    places face;
    const std::size_t half = corners / 2;
    for (std::size_t i = 0; i < half; ++i)
        face.push_back({static_cast<double>(i), random_number(random, -9, -0.1)});
    for (std::size_t i = half; i > 0; --i)
        face.push_back({static_cast<double>(i) - 0.5, random_number(random, 0.1, 9)});
    return face;
}

/// A path that winds inwards and out again beside itself.
places spiral(std::size_t corners) {
    places face;
    const auto half = static_cast<double>(corners / 2);
    const auto at = [&](double i, double offset) {
        const double angle = 0.3 * i, radius = half + 9 - i + offset;
        return place{radius * std::cos(angle), radius * std::sin(angle)};
    };
    for (double i = 0; i < half; ++i)
        face.push_back(at(i, 0));
    for (double i = half - 1; i >= 0; --i)
        face.push_back(at(i, -3));
    return face;
}

places random_crossings(std::mt19937& random, std::size_t corners) {
    places face(corners);
    for (place& p : face)
        p = {random_number(random, -1, 1), random_number(random, -1, 1)};
    return face;
}

/// Whether the triangles are as many as there should be, name corners of the face, and cover it
/// once. Their signed areas cover each place as often as the border goes round it, whatever they
/// are. So if none is negative, none covers anything else.
void expect_covered(const places& face, const triangles& found) {
    ASSERT_EQ(found.size(), face.size() - 2);
    const double rounding = 1e-12 * doubled_area(face); // of places to a grid
    double sum = 0;
    std::vector<int> uses(face.size());
    for (const auto& [a, b, c] : found) {
        const double area = turn(face[a], face[b], face[c]);
        ASSERT_GE(area, -rounding) << a << ' ' << b << ' ' << c;
        sum += area;
        for (const std::size_t corner : {a, b, c})
            ++uses[corner];
    }
    EXPECT_NEAR(sum / doubled_area(face), 1, 1e-9);
    EXPECT_GT(*std::ranges::min_element(uses), 0);
}

TEST(flat_face, cuts_the_ears_that_the_slow_twin_cuts) {
    for (unsigned seed = 1; seed <= 300; ++seed) {
        std::mt19937 random(seed);
        const std::size_t corners = 4 + random() % 90;
        for (const places& face : {random_star(random, corners), random_band(random, corners)}) {
            if (doubled_area(face) <= 0)
                continue;
            const triangles found = triangles_of(face);
            ASSERT_EQ(found, clipped_slowly(face)) << "seed " << seed;
        }
    }
}

TEST(flat_face, of_many_corners_is_covered_once) {
    // Looking at all corners for each would take 4 * 10^9 comparisons for a cut, and weeks.
    std::mt19937 random(7);
    constexpr std::size_t many = 65536;
    for (const places& face : {random_star(random, many), random_band(random, many), spiral(many)})
        expect_covered(face, triangles_of(face));
}

/// Towers side by side: many corners in one line, and corners within sides.
places random_towers(std::mt19937& random, int towers) {
    places face{{0, 0}};
    for (int x = 1; x <= towers; ++x)
        face.push_back({0.1 * x, 0});
    int above = 0;
    for (int x = towers; x > 0; --x) {
        const int height = 1 + static_cast<int>(random() % 5);
        const double right = 0.1 * x, left = 0.1 * (x - 1);
        for (int y = above; y != height; y += above < height ? 1 : -1)
            if (y != above && random() % 2 == 0)
                face.push_back({right, 0.1 * y});
        face.push_back({right, 0.1 * height});
        if (random() % 2 == 0)
            face.push_back({(left + right) / 2, 0.1 * height});
        face.push_back({left, 0.1 * height});
        above = height;
    }
    return face;
}

/// Turned, and rounded to four decimals, so that lines are no longer straight.
places turned(const places& face, double angle) {
    const auto rounded = [](double x) { return std::round(x * 1e4) / 1e4; };
    places result;
    for (const place& p : face)
        result.push_back({rounded(p.u * std::cos(angle) - p.v * std::sin(angle)),
                          rounded(p.u * std::sin(angle) + p.v * std::cos(angle))});
    return result;
}

TEST(flat_face, with_many_corners_in_a_line_is_covered_once) {
    for (unsigned seed = 1; seed <= 2000; ++seed) {
        std::mt19937 random(seed);
        const places face = random_towers(random, 2 + static_cast<int>(random() % 12));
        SCOPED_TRACE(seed);
        for (const double angle : {0.0, 0.5236, 1.1, 2.5})
            expect_covered(turned(face, angle), triangles_of(turned(face, angle)));
    }
}

/// Ways lead from a corner of the border to a hole's and back, the usual way to write holes.
TEST(flat_face, with_holes_is_covered_once) {
    const places plain{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0},
                       {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}};
    for (std::size_t first = 0; first < plain.size(); ++first) {
        places face = plain;
        std::rotate(face.begin(), face.begin() + static_cast<std::ptrdiff_t>(first), face.end());
        EXPECT_NEAR(doubled_area(face), 24, 1e-12);
        expect_covered(face, triangles_of(face));
    }
    for (unsigned seed = 1; seed <= 500; ++seed) {
        std::mt19937 random(seed);
        places face;
        // holes in a row, each joined to the lower border; some touch a neighbour or the border
        const int holes = 1 + static_cast<int>(random() % 4);
        for (int i = 0; i < holes; ++i) {
            const place gate{2.0 * i + 1, 0};
            face.push_back(gate);
            places hole = random_star(random, 3 + random() % 6);
            if (random() % 3 == 0)
                hole = {{-1, 0}, {0, -1}, {1, 0}, {0, 1}};
            std::ranges::reverse(hole);
            const std::size_t lowest = static_cast<std::size_t>(
                std::ranges::min_element(hole, {}, &place::v) - hole.begin());
            for (std::size_t k = 0; k <= hole.size(); ++k) {
                const place& at = hole[(lowest + k) % hole.size()];
                face.push_back({gate.u + at.u, 1.25 + at.v});
            }
            face.push_back(gate);
        }
        face.insert(face.end(), {{2.0 * holes, 0}, {2.0 * holes, 2.5}, {0, 2.5}, {0, 0}});
        SCOPED_TRACE(seed);
        expect_covered(face, triangles_of(face));
    }
}

TEST(flat_face, with_spikes_is_covered_once) {
    expect_covered({{0, 0}, {4, 0}, {4, 4}, {4, 7}, {4, 4}, {0, 4}},
                   triangles_of({{0, 0}, {4, 0}, {4, 4}, {4, 7}, {4, 4}, {0, 4}}));
    expect_covered({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {4, 4}, {0, 4}},
                   triangles_of({{0, 0}, {4, 0}, {4, 4}, {2, 2}, {4, 4}, {0, 4}}));
}

TEST(flat_face, that_crosses_itself_becomes_as_many_triangles) {
    std::mt19937 random(11);
    for (const std::size_t corners : {4u, 5u, 9u, 100u, 65536u}) {
        const triangles found = triangles_of(random_crossings(random, corners));
        ASSERT_EQ(found.size(), corners - 2);
        for (const auto& [a, b, c] : found)
            ASSERT_TRUE(a != b && b != c && c != a && std::max({a, b, c}) < corners);
    }
}

TEST(flat_face, whose_corners_coincide_becomes_as_many_triangles) {
    std::mt19937 random(13);
    EXPECT_EQ(triangles_of(places(4096, {3, 4})).size(), 4094u);
    places few(20000);
    for (place& p : few)
        p = {static_cast<double>(random() % 5), static_cast<double>(random() % 5)};
    EXPECT_EQ(triangles_of(few).size(), 19998u);
    places line(20000);
    for (place& p : line)
        p = {random_number(random, -1, 1), 0};
    EXPECT_EQ(triangles_of(line).size(), 19998u);
}

} // namespace
