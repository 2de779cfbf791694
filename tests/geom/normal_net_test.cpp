// SPDX-License-Identifier: MIT
// l3d_normal_net against cross products of derivatives: inside, at collapsed edges, of nothing.
#include "geom/bezier_oracle.h"
#include "geom/normal_net.h"
#include "geom/patch_part.h"
#include "geom/files/patch_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

using patch = l3d_bezier_patch<double, 3>;
using vector = l3d_vector<double, 3>;

constexpr std::uint64_t seed = 20260120;

/// dS/du x dS/dv, from derivatives that the net is not made of.
vector normal_at(const patch& p, double u, double v) {
    std::array<vector, 2> slopes;
    for (int k = 0; k < 3; ++k) {
        const auto jet = oracle::bicubic(oracle::component(p, k), u, v);
        slopes[0][k] = static_cast<double>(jet.by_u);
        slopes[1][k] = static_cast<double>(jet.by_v);
    }
    return l3d_cross<double>(slopes[0], slopes[1]);
}

double angle(const vector& a, const vector& b) {
    const vector across = l3d_cross<double>(a, b);
    return std::atan2(l3d_length<double, 3>(across), l3d_dot<double, 3>(a, b));
}

bool is_finite(const vector& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

bool is_zero(const l3d_normal_net& net) {
    for (int r = 0; r < 6; ++r)
        for (int c = 0; c < 6; ++c)
            if (net.at(r, c) != vector(0.0))
                return false;
    return true;
}

/// A sheet over a plane far from the origin, bent at random: its normals are within some 60
/// degrees of the plane's.
patch bent_sheet(oracle::random_values& random) {
    patch p;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            p.at(r, c) = {12 + 1.5 * c + random.within(-0.2, 0.2),
                          -7 + 2.0 * r + random.within(-0.2, 0.2), random.within(3, 4)};
    return p;
}

/// One of the four edges by number: its i-th point, in row `inward` counted from it.
vector& edge_point(patch& p, int edge, int i, int inward) {
    const int step = edge % 2 == 0 ? inward : 3 - inward;
    return edge < 2 ? p.at(step, i) : p.at(i, step);
}

/// The parameters of a point beside an edge: t along it, `inward` away from it.
std::array<double, 2> beside(int edge, double t, double inward) {
    const double step = edge % 2 == 0 ? inward : 1 - inward;
    return edge < 2 ? std::array<double, 2>{t, step} : std::array<double, 2>{step, t};
}

/// At the edge: finite, not zero, and what the normals inside tend to.
void expect_limit(const l3d_normal_net& net, const patch& p, int edge, double t, double tolerance) {
    const auto [u0, v0] = beside(edge, t, 0);
    const vector at_edge = net.evaluate(u0, v0);
    EXPECT_TRUE(is_finite(at_edge));
    EXPECT_GT(l3d_length(at_edge), 1e-6);
    const auto [u, v] = beside(edge, t, 1e-6);
    EXPECT_LT(angle(at_edge, normal_at(p, u, v)), tolerance) << "edge " << edge << " at " << t;
}

std::vector<patch> teapot(const std::string& name) {
    std::ifstream file("data/" + name, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::string why;
    const auto read = l3d_read_bpt(text, name, why);
    if (!read)
        throw std::runtime_error(why);
    std::vector<patch> patches;
    for (const auto& one : *read) {
        const auto points = l3d_as_bicubic(one);
        patches.emplace_back();
        for (std::size_t i = 0; i < 16; ++i)
            patches.back().points[i] = {(*points)[i][0], (*points)[i][1], (*points)[i][2]};
    }
    return patches;
}

/// Whether all points of an edge are one.
bool is_collapsed(patch& p, int edge) {
    for (int i = 1; i < 4; ++i)
        if (edge_point(p, edge, i, 0) != edge_point(p, edge, 0, 0))
            return false;
    return true;
}

TEST(normal_net, is_the_cross_product_of_the_derivatives) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (int round = 0; round < 300; ++round) {
        patch p = bent_sheet(random);
        if (round % 2 == 1) // folds and self-intersections: normals of any direction and length
            for (vector& point : p.points)
                point = {random.within(3, 9), random.within(-8, -1), random.within(2, 4)};
        const l3d_normal_net net(p);
        double scale = 0;
        for (int i = 0; i < 12; ++i) {
            const double u = random.within(0, 1), v = random.within(0, 1);
            const vector exact = normal_at(p, u, v), got = net.evaluate(u, v);
            if (i == 0)
                scale = l3d_length(exact) / l3d_length(got);
            // One scale for the whole net: this also compares lengths, near zeros too.
            EXPECT_LT(l3d_length(vector(got * scale - exact)), 1e-12 * (l3d_length(exact) + 100));
        }
    }
}

TEST(normal_net, has_its_largest_component_scaled_to_one) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (const double size : {1e-9, 1.0, 1e9}) {
        patch p = bent_sheet(random);
        for (vector& point : p.points)
            point = point * size;
        const l3d_normal_net net(p);
        double most = 0;
        for (int r = 0; r < 6; ++r)
            for (int c = 0; c < 6; ++c)
                for (int k = 0; k < 3; ++k)
                    most = std::max(most, std::abs(net.at(r, c)[k]));
        EXPECT_NEAR(most, 1, 1e-12);
    }
}

TEST(normal_net, has_the_limit_on_one_collapsed_edge) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (int round = 0; round < 100; ++round)
        for (int edge = 0; edge < 4; ++edge) {
            patch p = bent_sheet(random);
            const vector apex = edge_point(p, edge, 1, 0);
            for (int i = 0; i < 4; ++i)
                edge_point(p, edge, i, 0) = apex;
            const l3d_normal_net net(p);
            for (const double t : {0.0, 0.15, 0.5, 0.8, 1.0})
                expect_limit(net, p, edge, t, 1e-3);
            const double u = random.within(0.1, 0.9), v = random.within(0.1, 0.9);
            EXPECT_LT(angle(net.evaluate(u, v), normal_at(p, u, v)), 1e-9);
        }
}

TEST(normal_net, has_the_limits_on_two_collapsed_edges) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (int round = 0; round < 100; ++round)
        for (const auto& [first, second] : {std::pair{0, 1}, {2, 3}, {0, 2}, {1, 2}, {3, 0}}) {
            patch p = bent_sheet(random);
            for (const int edge : {first, second}) {
                const vector apex = edge_point(p, edge, 2, 0);
                for (int i = 0; i < 4; ++i)
                    edge_point(p, edge, i, 0) = apex;
            }
            // Neighbouring edges that collapse one after the other share the second one's apex.
            if (first / 2 != second / 2)
                for (int i = 0; i < 4; ++i)
                    edge_point(p, first, i, 0) = edge_point(p, second, 0, 0);
            const l3d_normal_net net(p);
            for (const int edge : {first, second})
                for (const double t : {0.2, 0.5, 0.85})
                    expect_limit(net, p, edge, t, 1e-3);
        }
}

/// Rows 0 and 1 in one line make the cross product vanish with the square of the distance.
TEST(normal_net, divides_as_often_as_the_factor_occurs) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    for (int round = 0; round < 100; ++round) {
        patch p = bent_sheet(random);
        for (int c = 0; c < 4; ++c) {
            p.at(0, c) = p.at(0, 1);
            p.at(1, c) = p.at(0, 1) + vector{0.5, 1.25, -0.25};
        }
        const l3d_normal_net net(p);
        for (const double t : {0.0, 0.3, 1.0})
            expect_limit(net, p, 0, t, 1e-3);
    }
}

TEST(normal_net, of_a_disc_of_collapsed_edges_points_along_the_axis) {
    constexpr double k = 0.55;
    patch p; // a quarter of a cap around (5, 6): all of row 0 is its top
    const double ring[4][2] = {{1, 0}, {1, k}, {k, 1}, {0, 1}};
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            p.at(r, c) = {5 + r * ring[c][0], 6 + r * ring[c][1], 2 - (r > 1 ? r * 0.4 : 0)};
    const l3d_normal_net net(p);
    const vector down{0, 0, -1}; // u runs counterclockwise seen from above, v outwards
    for (const double u : {0.0, 0.4, 1.0})
        EXPECT_LT(angle(net.evaluate(u, 0), down), 1e-7);
}

TEST(normal_net, is_finite_and_continuous_at_all_edges_of_the_teapots) {
    // The lid of teapot.bpt ends in a loop of 0.002 instead of a point: that is not collapsed.
    for (const auto& [name, expected] : {std::pair{"teapot.bpt", 0}, {"teapot_bottom.bpt", 4}}) {
        int collapsed = 0;
        auto patches = teapot(name);
        for (std::size_t i = 0; i < patches.size(); ++i) {
            SCOPED_TRACE(name + std::string(", patch ") + std::to_string(i));
            const l3d_normal_net net(patches[i]);
            for (int edge = 0; edge < 4; ++edge) {
                collapsed += is_collapsed(patches[i], edge);
                for (const double t : {0.05, 0.3, 0.5, 0.7, 0.95})
                    expect_limit(net, patches[i], edge, t, 1e-3);
            }
        }
        EXPECT_EQ(collapsed, expected) << name;
    }
}

/// The bottom's four patches meet in one point under the middle, seen from below as a disc.
TEST(normal_net, of_the_teapots_bottom_and_lid_points_along_the_axis_in_the_middle) {
    const auto patches = teapot("teapot_bottom.bpt");
    for (patch p : patches)
        for (int edge = 0; edge < 4; ++edge) {
            double farthest = 0; // of the edge from the teapot's axis
            for (int i = 0; i < 4; ++i) {
                const vector& q = edge_point(p, edge, i, 0);
                farthest = std::max({farthest, std::abs(q[0]), std::abs(q[2])});
            }
            if (farthest > 0.01)
                continue;
            const auto [u, v] = beside(edge, 0.4, 0);
            const vector n = l3d_normal_net(p).evaluate(u, v);
            EXPECT_LT(std::hypot(n[0], n[2]), 1e-3 * std::abs(n[1]));
        }
}

TEST(normal_net, of_patches_without_area_is_zero) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    oracle::random_values random(seed);
    patch point, line, row_only, column_only;
    const vector direction{0.3, -1.1, 0.7};
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            point.at(r, c) = {3.7, -2.1, 5.9};
            line.at(r, c) = vector{3.7, -2.1, 5.9} + direction * random.within(-1, 2);
        }
    const patch sheet = bent_sheet(random);
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) {
            row_only.at(r, c) = sheet.at(0, c);
            column_only.at(r, c) = sheet.at(r, 0);
        }
    for (const patch& p : {point, line, row_only, column_only}) {
        const l3d_normal_net net(p);
        EXPECT_TRUE(is_zero(net));
        EXPECT_EQ(net.evaluate(0.3, 0.6), vector(0.0));
    }
    EXPECT_TRUE(is_zero(l3d_normal_net()));
}

TEST(normal_net, blocks_of_its_polynomial_are_the_normals_of_the_patch_there) {
    oracle::random_values random(seed);
    patch p;
    for (vector& point : p.points)
        point = {random.within(-1, 1), random.within(-1, 1), random.within(-1, 1)};
    const l3d_normal_net net(p);
    const auto blocks = l3d_blocks_of(net.polynomial());
    const auto parts = l3d_blocks_of(p);
    for (std::size_t row = 0; row < 4; ++row)
        for (std::size_t column = 0; column < 4; ++column)
            for (const double end : {0.0, 1.0}) {
                const double u = 0.25 * (static_cast<double>(column) + end);
                const double v = 0.25 * (static_cast<double>(row) + end);
                const std::size_t block = 4 * row + column, corner = end > 0 ? 1 : 0;
                const vector normal = blocks[block].points[35 * corner] - net.evaluate(u, v);
                const vector place = parts[block].points[15 * corner] - p.evaluate(u, v);
                EXPECT_LT(l3d_length(normal) + l3d_length(place), 1e-14) << block;
            }
}

} // namespace
