// SPDX-License-Identifier: MIT
// Edges: the same from both sides, clipped the same from both sides, and near enough.
#include "nasty.h"
#include "pipeline/edge_polyline.h"
#include "pipeline/slit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pipeline_tests {
namespace {

using fixed = l3d_fixed<std::int64_t, 32>;

l3d_dice_view view_with(double tolerance) {
    l3d_dice_view view;
    view.size = {640, 481};
    view.near = 0.3;
    view.tolerance = tolerance;
    return view;
}

/// Through the window, or at any side of it and of the near plane.
template <class Wide> l3d_bezier_curve<Wide, 3> random_edge(number_source& random) {
    l3d_bezier_curve<Wide, 3> result;
    const bool crossing = random.between(0, 1) < 0.3;
    for (auto& point : result.points) {
        const double w = crossing ? random.between(-1, 3) : random.between(0.4, 4);
        point = {l3d_from_double<Wide>(random.between(-500, 500) * w),
                 l3d_from_double<Wide>(random.between(-400, 400) * w), l3d_from_double<Wide>(w)};
    }
    return result;
}

bool same(const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
    return a.x == b.x && a.y == b.y && a.inv_w == b.inv_w;
}

template <class Wide> class edge_polyline : public ::testing::Test {};
using wide_types = ::testing::Types<double, fixed>;
TYPED_TEST_SUITE(edge_polyline, wide_types, );

TYPED_TEST(edge_polyline, is_the_same_backwards_bit_for_bit) {
    std::size_t points = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        number_source random(seed);
        const auto edge = random_edge<TypeParam>(random);
        const l3d_dice_view view = view_with(random.of_any_size(0.02, 2));
        l3d_edge_polyline forth, back;
        forth.build(edge, view);
        back.build(edge.reversed(), view);
        ASSERT_EQ(forth.points().size(), back.points().size()) << "seed " << seed;
        const std::size_t last = forth.points().size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            const l3d_edge_point &a = forth.points()[i], &b = back.points()[last - i];
            ASSERT_EQ(a.vertex.drawable, b.vertex.drawable) << "seed " << seed << " point " << i;
            ASSERT_TRUE(a.vertex.h == b.vertex.h) << "seed " << seed << " point " << i;
            ASSERT_TRUE(same(a.vertex.dice.vertex, b.vertex.dice.vertex));
            ASSERT_NEAR(a.t, 1 - b.t, 1e-15);
        }
        EXPECT_EQ(forth.bound(), back.bound());
        points += last + 1;
    }
    EXPECT_GT(points, 3000u);
}

TYPED_TEST(edge_polyline, runs_from_end_to_end_within_its_bound) {
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        number_source random(seed);
        const auto edge = random_edge<TypeParam>(random);
        l3d_image_curve exact;
        for (std::size_t i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k)
                exact.points[i][k] = l3d_to_double(edge.points[i][k]);
        const l3d_dice_view view = view_with(random.of_any_size(0.02, 2));
        l3d_edge_polyline line;
        line.build(edge, view);
        EXPECT_LE(line.bound(), view.tolerance) << "seed " << seed;
        const auto& points = line.points();
        EXPECT_EQ(points.front().t, 0);
        EXPECT_EQ(points.back().t, 1);
        EXPECT_TRUE(points.front().vertex.h == exact.points[0]);
        EXPECT_TRUE(points.back().vertex.h == exact.points[3]);
        for (std::size_t i = 1; i < points.size(); ++i) {
            const l3d_edge_point &a = points[i - 1], &b = points[i];
            ASSERT_LT(a.t, b.t) << "seed " << seed;
            if (!a.vertex.drawable || !b.vertex.drawable)
                continue;
            const l3d_image_box window = view.window();
            for (const double s : {0.0, 0.23, 0.5, 0.81}) {
                const auto drawn = l3d_lerp<double, 3>(a.vertex.h, b.vertex.h, s);
                const double x = drawn[0] / drawn[2], y = drawn[1] / drawn[2];
                if (x < window.left || x > window.right || y < window.top || y > window.bottom)
                    continue;
                const auto at = exact.evaluate(a.t + s * (b.t - a.t));
                const double off = std::hypot(at[0] / at[2] - x, at[1] / at[2] - y);
                EXPECT_LE(off, line.bound()) << "seed " << seed << " t " << a.t;
                worst = std::max(worst, off / line.bound());
            }
        }
    }
    EXPECT_GT(worst, 0.5); // else the bound would be useless
}

/// A corner of a triangle to be clipped, drawable or not.
l3d_clip_vertex corner_at(number_source& random, const l3d_dice_view& view) {
    const double w = random.between(-2, 3);
    l3d_clip_vertex result = l3d_canonical_vertex<double>(
        {random.between(-500, 500) * w, random.between(-400, 400) * w, w}, view);
    result.dice.u = random.between(0, 1);
    result.dice.v = random.between(0, 1);
    return result;
}

TEST(near_clip, triangles_that_share_an_edge_get_the_same_corners_on_it) {
    const l3d_dice_view view = view_with(0.25);
    int crossings = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        number_source random(seed);
        const l3d_clip_vertex a = corner_at(random, view), b = corner_at(random, view),
                              c = corner_at(random, view), d = corner_at(random, view);
        std::vector<l3d_dice_vertex> left, right;
        l3d_clip_triangle(a, b, c, view, left);
        l3d_clip_triangle(b, a, d, view, right);
        for (const auto* side : {&left, &right}) {
            EXPECT_EQ(side->size() % 3, 0u);
            for (const l3d_dice_vertex& v : *side) {
                EXPECT_GT(v.vertex.inv_w, 0);
                EXPECT_LE(v.vertex.inv_w, static_cast<float>(1 / view.near) * 1.000001f);
                EXPECT_LE(std::abs(v.vertex.x - view.centre_x()), 1 << 22);
                EXPECT_LE(std::abs(v.vertex.y - view.centre_y()), 1 << 22);
            }
        }
        // Corners on a b cut at the near plane are those whose parameters lie between a's and b's.
        if ((a.h[2] > view.near) == (b.h[2] > view.near))
            continue;
        const double t = (view.near - a.h[2]) / (b.h[2] - a.h[2]);
        const double u = a.dice.u + t * (b.dice.u - a.dice.u);
        const auto on_edge = [&](const l3d_dice_vertex& v) { return std::abs(v.u - u) < 1e-12; };
        const auto from_left = std::find_if(left.begin(), left.end(), on_edge);
        const auto from_right = std::find_if(right.begin(), right.end(), on_edge);
        if (from_left == left.end() || from_right == right.end())
            continue; // beyond the guard band
        EXPECT_TRUE(same(from_left->vertex, from_right->vertex)) << "seed " << seed;
        EXPECT_EQ(from_left->u, from_right->u) << "seed " << seed;
        EXPECT_EQ(from_left->v, from_right->v) << "seed " << seed;
        ++crossings;
    }
    EXPECT_GT(crossings, 300);
}

TEST(near_clip, what_is_drawable_stays_as_it_is) {
    const l3d_dice_view view = view_with(0.25);
    const auto at = [&](double x, double y, double w) {
        return l3d_canonical_vertex<double>({x * w, y * w, w}, view);
    };
    const l3d_clip_vertex a = at(-30, 20, 2), b = at(80, 35, 3), c = at(11, -70, 4);
    std::vector<l3d_dice_vertex> out;
    l3d_clip_triangle(a, b, c, view, out);
    ASSERT_EQ(out.size(), 3u);
    EXPECT_TRUE(same(out[0].vertex, a.dice.vertex));
    EXPECT_TRUE(same(out[1].vertex, b.dice.vertex));
    EXPECT_TRUE(same(out[2].vertex, c.dice.vertex));
}

} // namespace
} // namespace pipeline_tests
