// SPDX-License-Identifier: MIT
// Edges: the same from both sides, clipped the same from both sides, and near enough.
#include "nasty.h"
#include "odd_view.h"
#include "dice/edges/edge_polyline.h"
#include "dice/edges/gap_filler.h"
#include "raster/parallel/simd_target.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <string>

namespace dice_tests {
namespace {

l3d_dice_view view_with(double tolerance) {
    return odd_view(tolerance, 0.3);
}

/// Through the window, or at any side of it and of the near plane.
l3d_image_curve random_edge(random_numbers& random) {
    l3d_image_curve result;
    const bool crossing = random.between(0, 1) < 0.3;
    for (auto& point : result.points) {
        const double w = crossing ? random.between(-1, 3) : random.between(0.4, 4);
        point = {random.between(-500, 500) * w, random.between(-400, 400) * w, w};
    }
    return result;
}

bool same(const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
    return a.x == b.x && a.y == b.y && a.inv_w == b.inv_w;
}

bool same_point(const l3d_edge_polyline& a, std::size_t i, const l3d_edge_polyline& b,
                std::size_t j, const l3d_dice_view& view) {
    const l3d_clip_vertex p = a.clip_vertex(i, view), q = b.clip_vertex(j, view);
    return p.drawable == q.drawable && p.h == q.h && same(p.dice.vertex, q.dice.vertex);
}

/// Whether a point of the line is where everybody has this homogeneous point.
bool is_at(const l3d_edge_polyline& line, std::size_t i, const l3d_image_point& h,
           const l3d_dice_view& view) {
    const l3d_clip_vertex mine = line.clip_vertex(i, view), its = l3d_canonical_vertex(h, view);
    return mine.drawable == its.drawable && same(mine.dice.vertex, its.dice.vertex);
}

/// The point that is drawn at a vertex.
l3d_image_point placed(const l3d_clip_vertex& v, const l3d_dice_view& view) {
    const double w = 1 / static_cast<double>(v.dice.vertex.inv_w);
    return {(v.dice.vertex.x - view.centre_x()) * w / l3d_subpixel_one,
            (v.dice.vertex.y - view.centre_y()) * w / l3d_subpixel_one, w};
}

TEST(edge_polyline, is_the_same_backwards_bit_for_bit) {
    std::size_t points = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        random_numbers random(seed);
        const auto edge = random_edge(random);
        const l3d_dice_view view = view_with(random.of_any_size(0.02, 2));
        l3d_edge_polyline forth, back;
        forth.build(edge, view);
        back.build(edge.reversed(), view);
        ASSERT_EQ(forth.size(), back.size()) << "seed " << seed;
        const std::size_t last = forth.size() - 1;
        for (std::size_t i = 0; i <= last; ++i) {
            ASSERT_TRUE(same_point(forth, i, back, last - i, view))
                << "seed " << seed << " point " << i;
            ASSERT_NEAR(forth.t()[i], 1 - back.t()[last - i], 1e-15);
        }
        EXPECT_EQ(forth.bound(), back.bound());
        points += last + 1;
    }
    EXPECT_GT(points, 3000u);
}

/// Fails where two lines differ in a bit.
void expect_equal(const l3d_edge_polyline& a, const l3d_edge_polyline& b,
                  const l3d_dice_view& view) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_TRUE(same_point(a, i, b, i, view)) << "point " << i;
        ASSERT_EQ(a.t()[i], b.t()[i]) << "point " << i;
    }
    EXPECT_EQ(a.strips().blocks, b.strips().blocks);
    EXPECT_EQ(a.strips().first, b.strips().first);
    EXPECT_EQ(a.chord_error(), b.chord_error());
    EXPECT_EQ(a.vertex_error(), b.vertex_error());
}

TEST(edge_polyline, is_the_same_alone_and_among_four_on_every_simd_target) {
    int in_lanes = 0, cut = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        std::array<l3d_image_curve, 4> edges;
        for (l3d_image_curve& edge : edges)
            edge = random_edge(random);
        const l3d_dice_view view = view_with(random.of_any_size(0.002, 2));
        std::array<l3d_edge_polyline, 4> first;
        l3d_edge_polyline::build(first, edges, view);
        for (const std::string& target : l3d_simd_targets()) {
            SCOPED_TRACE(target);
            ASSERT_TRUE(l3d_set_simd_target(target));
            std::array<l3d_edge_polyline, 4> four;
            l3d_edge_polyline::build(four, edges, view);
            for (std::size_t e = 0; e < 4; ++e) {
                l3d_edge_polyline alone;
                alone.build(edges[e], view);
                expect_equal(first[e], four[e], view);
                expect_equal(first[e], alone, view);
            }
        }
        l3d_set_simd_target("");
        for (const l3d_edge_polyline& line : first)
            ++(line.strips().blocks > 0 ? in_lanes : cut);
    }
    EXPECT_GT(in_lanes, 300);
    EXPECT_GT(cut, 300);
}

/// A quarter of a curve.
l3d_image_curve quarter(const l3d_image_curve& edge, int which) {
    const auto [low, high] = edge.split();
    const auto [first, second] = (which < 2 ? low : high).split();
    return which % 2 == 0 ? first : second;
}

/// Edges in the window that 32 steps a strip are enough for.
TEST(edge_polyline, strips_are_one_or_four_and_hold_the_balanced_points_of_their_parameters) {
    std::array<int, 5> seen{};
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        const double size = random.of_any_size(1, 400);
        l3d_image_curve edge;
        for (auto& point : edge.points) {
            const double w = random.between(2, 3);
            point = {random.between(-size, size) * w, random.between(-size, size) * w, w};
        }
        const l3d_dice_view view = view_with(random.of_any_size(0.3, 1));
        l3d_edge_polyline line;
        line.build(edge, view);
        const l3d_block_starts& strips = line.strips();
        ASSERT_TRUE(strips.blocks == 1 || strips.blocks == 4);
        ++seen[static_cast<std::size_t>(strips.blocks)];
        EXPECT_EQ(strips.first[0], 0);
        for (int s = 0; s < strips.blocks; ++s) {
            const int low = strips.first[static_cast<std::size_t>(s)];
            const int n = strips.first[static_cast<std::size_t>(s) + 1] - low;
            ASSERT_GE(n, 1);
            const l3d_image_curve strip = strips.blocks == 1 ? edge : quarter(edge, s);
            for (int i = 0; i <= n; ++i) {
                const auto at = static_cast<std::size_t>(low + i);
                const double t = static_cast<double>(i) / n;
                EXPECT_NEAR(line.t()[at], (s + t) / strips.blocks, 1e-15);
                const bool moved = strips.blocks == 4 && i > 0 && i < n;
                const l3d_image_point h =
                    moved ? l3d_balanced(strip, n).evaluate(t) : strip.evaluate(t);
                const l3d_micro_vertex exact = l3d_canonical_vertex(h, view).dice.vertex;
                EXPECT_NEAR(line.x()[at], exact.x, 1);
                EXPECT_NEAR(line.y()[at], exact.y, 1);
                EXPECT_NEAR(line.inv_w()[at], exact.inv_w, 1e-7);
            }
        }
        EXPECT_EQ(line.size(), static_cast<std::size_t>(
                                   strips.first[static_cast<std::size_t>(strips.blocks)] + 1));
    }
    EXPECT_GT(seen[1], 50);
    EXPECT_GT(seen[4], 100);
}

/// The part of a curve from `index` / `count` on, by halves.
l3d_image_curve part_of(const l3d_image_curve& edge, std::size_t index, std::size_t count) {
    if (count == 1)
        return edge;
    const auto [low, high] = edge.split();
    return index < count / 2 ? part_of(low, index, count / 2)
                             : part_of(high, index - count / 2, count / 2);
}

/// Edges that need more than 32 steps in one of four strips; the same from both ends.
TEST(edge_polyline, parts_are_edges_of_their_own) {
    std::array<int, l3d_edge_polyline::most_parts + 1> seen{};
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        const double size = random.of_any_size(30, 400);
        l3d_image_curve edge;
        for (auto& point : edge.points) {
            const double w = random.between(2, 3);
            point = {random.between(-size, size) * w, random.between(-size, size) * w, w};
        }
        const l3d_dice_view view = view_with(random.of_any_size(0.001, 0.02));
        l3d_edge_polyline line, back;
        line.build(edge, view);
        back.build(edge.reversed(), view);
        if (line.strips().blocks == 0)
            continue; // 16 parts are too few
        const std::size_t parts = line.parts(), last = line.size() - 1;
        ++seen[parts];
        ASSERT_EQ(back.parts(), parts);
        ASSERT_EQ(back.size(), line.size());
        EXPECT_EQ(line.bound(), back.bound());
        for (std::size_t i = 0; i <= last; ++i) {
            ASSERT_TRUE(same_point(line, i, back, last - i, view)) << "point " << i;
            ASSERT_NEAR(line.t()[i], 1 - back.t()[last - i], 1e-15);
        }
        double chord_error = 0;
        std::size_t from = 0;
        for (std::size_t k = 0; k < parts; ++k) {
            l3d_edge_polyline alone;
            alone.build(part_of(edge, k, parts), view);
            ASSERT_EQ(alone.parts(), 1u);
            const l3d_block_starts& strips = line.strips(k);
            ASSERT_EQ(strips.blocks, alone.strips().blocks);
            for (std::size_t s = 0; s <= static_cast<std::size_t>(strips.blocks); ++s)
                EXPECT_EQ(strips.first[s], alone.strips().first[s] + static_cast<int>(from));
            for (std::size_t i = 0; i < alone.size(); ++i) {
                ASSERT_TRUE(same_point(line, from + i, alone, i, view));
                ASSERT_NEAR(line.t()[from + i] * static_cast<double>(parts),
                            static_cast<double>(k) + alone.t()[i], 1e-14);
            }
            // At the parts' ends exactly, where corners of cut patches are.
            const auto whole = static_cast<double>(parts);
            EXPECT_EQ(line.t()[from], static_cast<double>(k) / whole);
            EXPECT_EQ(line.strips_between(static_cast<double>(k) / whole,
                                          static_cast<double>(k + 1) / whole),
                      &strips);
            EXPECT_EQ(line.point_before(static_cast<double>(k) / whole), from);
            EXPECT_TRUE(is_at(line, from, part_of(edge, k, parts).points[0], view));
            chord_error = std::max(chord_error, alone.chord_error());
            from += alone.size() - 1;
        }
        EXPECT_EQ(from, last);
        EXPECT_EQ(line.chord_error(), chord_error);
    }
    for (const std::size_t parts : {1U, 2U, 4U, 8U})
        EXPECT_GT(seen[parts], 10) << parts << " parts";
}

TEST(edge_polyline, of_two_halves_has_the_points_of_both) {
    int whole = 0, cut = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        const auto [first, second] = random_edge(random).split();
        const l3d_dice_view view = view_with(random.of_any_size(0.02, 2));
        l3d_edge_polyline low, high, joined;
        low.build(first, view);
        high.build(second, view);
        joined.join(low, high, view);
        const std::size_t middle = low.size() - 1;
        ASSERT_EQ(joined.size(), middle + high.size());
        for (std::size_t i = 0; i < joined.size(); ++i) {
            const l3d_clip_vertex mine = joined.clip_vertex(i, view);
            const l3d_clip_vertex its =
                i < middle ? low.clip_vertex(i, view) : high.clip_vertex(i - middle, view);
            ASSERT_EQ(mine.drawable, its.drawable) << "point " << i;
            ASSERT_EQ(mine.h, its.h) << "point " << i;
            ASSERT_TRUE(same(mine.dice.vertex, its.dice.vertex)) << "point " << i;
        }
        const bool has_strips = low.strips().blocks > 0 && high.strips().blocks > 0;
        ASSERT_EQ(joined.strips().blocks > 0, has_strips);
        ++(has_strips ? whole : cut);
    }
    EXPECT_GT(whole, 50);
    EXPECT_GT(cut, 50);
}

TEST(edge_polyline, runs_from_end_to_end_within_its_bound) {
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= 500; ++seed) {
        random_numbers random(seed);
        const auto edge = random_edge(random);
        const l3d_dice_view view = view_with(random.of_any_size(0.02, 2));
        l3d_edge_polyline line;
        line.build(edge, view);
        EXPECT_LE(line.bound(), view.tolerance) << "seed " << seed;
        EXPECT_EQ(line.t()[0], 0);
        EXPECT_EQ(line.t()[line.size() - 1], 1);
        EXPECT_TRUE(is_at(line, 0, edge.points[0], view));
        EXPECT_TRUE(is_at(line, line.size() - 1, edge.points[3], view));
        for (std::size_t i = 1; i < line.size(); ++i) {
            const l3d_clip_vertex a = line.clip_vertex(i - 1, view), b = line.clip_vertex(i, view);
            const double t = line.t()[i - 1], step = line.t()[i] - t;
            ASSERT_GT(step, 0) << "seed " << seed;
            if (!a.drawable || !b.drawable)
                continue;
            const l3d_image_box window = view.window();
            for (const double s : {0.0, 0.23, 0.5, 0.81}) {
                const auto drawn = l3d_lerp<double, 3>(placed(a, view), placed(b, view), s);
                const double x = drawn[0] / drawn[2], y = drawn[1] / drawn[2];
                if (x < window.left || x > window.right || y < window.top || y > window.bottom)
                    continue;
                const auto at = edge.evaluate(t + s * step);
                const double off = std::hypot(at[0] / at[2] - x, at[1] / at[2] - y);
                EXPECT_LE(off, line.bound()) << "seed " << seed << " t " << t;
                worst = std::max(worst, off / line.bound());
            }
        }
    }
    EXPECT_GT(worst, 0.5); // else the bound would be useless
}

/// A corner of a triangle to be clipped, drawable or not.
l3d_clip_vertex corner_at(random_numbers& random, const l3d_dice_view& view) {
    const double w = random.between(-2, 3);
    l3d_clip_vertex result = l3d_canonical_vertex(
        {random.between(-500, 500) * w, random.between(-400, 400) * w, w}, view);
    result.dice.u = random.between(0, 1);
    result.dice.v = random.between(0, 1);
    return result;
}

TEST(near_clip, triangles_that_share_an_edge_get_the_same_corners_on_it) {
    const l3d_dice_view view = view_with(0.25);
    int crossings = 0;
    for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        random_numbers random(seed);
        const l3d_clip_vertex a = corner_at(random, view), b = corner_at(random, view),
                              c = corner_at(random, view), d = corner_at(random, view);
        l3d_diced_piece left, right;
        left.keep_parameters = right.keep_parameters = true;
        l3d_clip_triangle(a, b, c, view, left);
        l3d_clip_triangle(b, a, d, view, right);
        for (const auto* side : {&left, &right})
            for (std::size_t n = 0; n < 3 * side->part.triangles.count; ++n) {
                const l3d_micro_vertex v = side->part.triangles.vertex(n / 3, n % 3);
                EXPECT_GT(v.inv_w, 0);
                EXPECT_LE(v.inv_w, static_cast<float>(1 / view.near) * 1.000001f);
                EXPECT_LE(std::abs(v.x - view.centre_x()), 1 << 22);
                EXPECT_LE(std::abs(v.y - view.centre_y()), 1 << 22);
            }
        // Corners on a b cut at the near plane are those whose parameters lie between a's and b's.
        if ((a.h[2] > view.near) == (b.h[2] > view.near))
            continue;
        const double t = (view.near - a.h[2]) / (b.h[2] - a.h[2]);
        const double u = a.dice.u + t * (b.dice.u - a.dice.u);
        const auto on_edge = [&](const l3d_diced_piece& side) {
            for (std::size_t n = 0; n < 3 * side.part.triangles.count; ++n) {
                const auto& at = side.triangle_uv[n % 3][n / 3];
                if (std::abs(at.u - u) < 1e-12)
                    return std::optional(
                        l3d_dice_vertex{side.part.triangles.vertex(n / 3, n % 3), at.u, at.v});
            }
            return std::optional<l3d_dice_vertex>();
        };
        const auto from_left = on_edge(left), from_right = on_edge(right);
        if (!from_left || !from_right)
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
        return l3d_canonical_vertex({x * w, y * w, w}, view);
    };
    const l3d_clip_vertex a = at(-30, 20, 2), b = at(80, 35, 3), c = at(11, -70, 4);
    l3d_diced_piece out;
    l3d_clip_triangle(a, b, c, view, out);
    ASSERT_EQ(out.part.triangles.count, 1u);
    EXPECT_TRUE(same(out.part.triangles.vertex(0, 0), a.dice.vertex));
    EXPECT_TRUE(same(out.part.triangles.vertex(0, 1), b.dice.vertex));
    EXPECT_TRUE(same(out.part.triangles.vertex(0, 2), c.dice.vertex));
}

} // namespace
} // namespace dice_tests
