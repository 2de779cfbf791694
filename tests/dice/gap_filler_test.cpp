// SPDX-License-Identifier: MIT
// Slits along whole sides, against the way that clips and looks at every triangle.
#include "nasty.h"
#include "odd_view.h"
#include "dice/edges/gap_filler.h"
#include "raster/pixel_centres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace dice_tests {
namespace {

l3d_dice_view view_with(double tolerance) {
    return odd_view(tolerance, 0.3);
}

/// Steps of the strips of a row.
using steps = std::vector<int>;

/// A piece whose side `side` lies along `edge` in the given steps: points of the edge, moved by up
/// to a sub-pixel as another way to compute them would. Its other vertices do not matter.
l3d_diced_piece piece_along(const l3d_image_curve& edge, const steps& strips, std::size_t side,
                            double low, double high, const l3d_dice_view& view,
                            random_numbers& random) {
    l3d_diced_piece piece;
    piece.keep_parameters = true;
    const bool along_u = side < 2;
    std::vector<double>& along = along_u ? piece.u : piece.v;
    (along_u ? piece.v : piece.u) = {0.25, 0.75};
    l3d_block_starts& starts = along_u ? piece.part.block_columns : piece.part.block_rows;
    starts.blocks = static_cast<int>(strips.size());
    std::vector<double> t;
    for (std::size_t s = 0; s < strips.size(); ++s) {
        starts.first[s + 1] = starts.first[s] + strips[s];
        for (int i = 0; i < strips[s]; ++i)
            t.push_back((static_cast<double>(s) + static_cast<double>(i) / strips[s]) /
                        static_cast<double>(strips.size()));
    }
    t.push_back(1);
    const int count = static_cast<int>(t.size());
    l3d_micro_grid& grid = piece.part.grid;
    grid.resize(along_u ? count : 2, along_u ? 2 : count);
    for (int i = 0; i < count; ++i) {
        const double at = t[static_cast<std::size_t>(i)];
        along.push_back(low + (high - low) * at);
        const l3d_micro_vertex v = l3d_canonical_vertex(edge.evaluate(at), view).dice.vertex;
        const int across = static_cast<int>(side % 2);
        const std::size_t index = along_u ? grid.index(across, i) : grid.index(i, across);
        grid.x[index] = v.x + static_cast<int>(random.between(-1.5, 1.5));
        grid.y[index] = v.y + static_cast<int>(random.between(-1.5, 1.5));
        grid.inv_w[index] = v.inv_w;
        grid.normal[0][index] = static_cast<float>(std::sin(i));
        grid.normal[1][index] = static_cast<float>(std::cos(i));
        grid.normal[2][index] = 0;
    }
    return piece;
}

std::vector<l3d_boundary_point> boundary_of(const l3d_diced_piece& piece, std::size_t side,
                                            double t0 = 0, double t1 = 1) {
    const bool along_u = side < 2;
    const auto across = static_cast<int>(side % 2);
    const std::vector<double>& along = along_u ? piece.u : piece.v;
    std::vector<l3d_boundary_point> result;
    for (std::size_t i = 0; i < along.size(); ++i) {
        const auto k = static_cast<int>(i);
        l3d_boundary_point& point = result.emplace_back();
        point.t = t0 + (t1 - t0) * ((along[i] - along.front()) / (along.back() - along.front()));
        point.vertex.drawable = true;
        point.vertex.dice.vertex =
            along_u ? piece.part.grid.vertex(across, k) : piece.part.grid.vertex(k, across);
        point.vertex.dice.u = along_u ? along[i] : piece.u[side % 2];
        point.vertex.dice.v = along_u ? piece.v[side % 2] : along[i];
    }
    return result;
}

/// The last row or column of quads along a side ends there.
int strips_end(const l3d_diced_piece& piece, std::size_t side) {
    const l3d_block_starts& starts = side < 2 ? piece.part.block_columns : piece.part.block_rows;
    return starts.first[static_cast<std::size_t>(starts.blocks)];
}

void expect_same_triangles(const l3d_diced_piece& a, const l3d_diced_piece& b) {
    ASSERT_EQ(a.part.triangles.count, b.part.triangles.count);
    for (std::size_t i = 0; i < a.part.triangles.count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const l3d_micro_vertex p = a.part.triangles.vertex(i, k),
                                   q = b.part.triangles.vertex(i, k);
            ASSERT_EQ(p.x, q.x);
            ASSERT_EQ(p.y, q.y);
            ASSERT_EQ(p.inv_w, q.inv_w);
            for (std::size_t c = 0; c < 3; ++c)
                // One way makes unit vectors of those that the other hands on.
                ASSERT_NEAR(p.normal[c], q.normal[c], 0x1p-22F)
                    << "triangle " << i << " corner " << k;
            ASSERT_NEAR(a.triangle_uv[k].at(i).u, b.triangle_uv[k].at(i).u, 1e-15);
            ASSERT_NEAR(a.triangle_uv[k].at(i).v, b.triangle_uv[k].at(i).v, 1e-15);
        }
}

l3d_image_curve random_edge(random_numbers& random) {
    const double size = random.of_any_size(4, 300);
    l3d_image_curve edge;
    for (auto& point : edge.points) {
        const double w = random.between(2, 3);
        point = {random.between(-size, size) * w, random.between(-size, size) * w, w};
    }
    return edge;
}

/// An edge, how it is looked at, and its polyline.
struct seen_edge {
    seen_edge(random_numbers& random, double low, double high)
        : edge(random_edge(random)), view(view_with(random.of_any_size(low, high))) {
        line.build(edge, view);
    }

    l3d_image_curve edge;
    l3d_dice_view view;
    l3d_edge_polyline line;
};

TEST(slit, along_a_whole_side_is_that_of_any_row) {
    std::size_t triangles = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        const auto [edge, view, line] = seen_edge(random, 0.3, 3);
        ASSERT_GT(line.strips().blocks, 0);
        steps strips(random.between(0, 1) < 0.3 ? 1 : 4);
        for (int& n : strips)
            n = static_cast<int>(random.of_any_size(1, 32.9));
        const auto side = static_cast<std::size_t>(random.between(0, 3.99));
        // Whole patches, and halves of a patch that was cut along this edge.
        const double high = random.between(0, 1) < 0.5 ? 1 : 0.5;
        l3d_diced_piece quick = piece_along(edge, strips, side, 0, high, view, random);
        l3d_close_side(quick, side, line, view);
        l3d_diced_piece slow;
        slow.keep_parameters = true;
        l3d_fill_gap(boundary_of(quick, side), line, view, slow);
        expect_same_triangles(quick, slow);
        triangles += slow.part.triangles.count;
    }
    EXPECT_GT(triangles, 5000u);
}

/// Pieces of a patch that was cut lie along stretches of its edges, which may be made of parts,
/// too.
TEST(slit, along_a_stretch_is_that_of_any_row) {
    std::size_t triangles = 0, at_parts = 0, between_points = 0;
    for (std::uint64_t seed = 1; seed <= 2000; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        const auto [edge, view, line] = seen_edge(random, 0.006, 3);
        if (line.strips().blocks == 0)
            continue; // 16 parts are too few
        const double length = std::exp2(-std::floor(random.between(1, 6.99)));
        const double t0 = length * std::floor(random.between(0, 0.999) / length), t1 = t0 + length;
        l3d_image_curve stretch = edge;
        for (double from = 0, size = 1; size > length;) {
            size /= 2;
            const auto halves = stretch.split();
            stretch = t0 >= from + size ? halves.second : halves.first;
            from = t0 >= from + size ? from + size : from;
        }
        steps strips(random.between(0, 1) < 0.3 ? 1 : 4);
        for (int& n : strips)
            n = static_cast<int>(random.of_any_size(1, 32.9));
        const auto side = static_cast<std::size_t>(random.between(0, 3.99));
        l3d_diced_piece quick = piece_along(stretch, strips, side, t0, t1, view, random);
        // Ends are where everybody has them.
        const bool along_u = side < 2;
        l3d_micro_grid& grid = quick.part.grid;
        const auto across = static_cast<int>(side % 2), last = strips_end(quick, side);
        for (const int at : {0, last}) {
            const auto h = stretch.points[at == 0 ? 0 : 3];
            const l3d_micro_vertex v = l3d_canonical_vertex(h, view).dice.vertex;
            const std::size_t index = along_u ? grid.index(across, at) : grid.index(at, across);
            grid.x[index] = v.x;
            grid.y[index] = v.y;
            grid.inv_w[index] = v.inv_w;
        }
        const l3d_diced_piece before = quick;
        l3d_close_side(quick, side, line, view, t0, t1);
        for (const int at : {0, last}) {
            const std::size_t index = along_u ? grid.index(across, at) : grid.index(at, across);
            EXPECT_EQ(grid.x[index], before.part.grid.x[index]);
            EXPECT_EQ(grid.y[index], before.part.grid.y[index]);
            EXPECT_EQ(grid.inv_w[index], before.part.grid.inv_w[index]);
        }
        l3d_diced_piece slow;
        slow.keep_parameters = true;
        l3d_fill_gap(boundary_of(quick, side, t0, t1), line, view, slow);
        expect_same_triangles(quick, slow);
        triangles += slow.part.triangles.count;
        at_parts += line.strips_between(t0, t1) != nullptr;
        between_points += line.t()[line.point_before(t0)] != t0;
    }
    EXPECT_GT(triangles, 2000u);
    EXPECT_GT(at_parts, 20u);
    EXPECT_GT(between_points, 200u);
}

TEST(slit, is_empty_where_the_row_has_the_steps_of_the_edge) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        const auto [edge, view, line] = seen_edge(random, 0.3, 3);
        steps strips;
        for (int s = 0; s < line.strips().blocks; ++s)
            strips.push_back(line.strips().first[static_cast<std::size_t>(s) + 1] -
                             line.strips().first[static_cast<std::size_t>(s)]);
        const auto side = static_cast<std::size_t>(seed % 4);
        l3d_diced_piece piece = piece_along(edge, strips, side, 0, 1, view, random);
        l3d_close_side(piece, side, line, view);
        EXPECT_EQ(piece.part.triangles.count, 0u);
        const auto row = boundary_of(piece, side);
        ASSERT_EQ(row.size(), line.size());
        for (std::size_t i = 0; i < row.size(); ++i) {
            const l3d_micro_vertex& v = row[i].vertex.dice.vertex;
            EXPECT_EQ(v.x, line.x()[i]);
            EXPECT_EQ(v.y, line.y()[i]);
            EXPECT_EQ(v.inv_w, line.inv_w()[i]);
            EXPECT_EQ(v.normal[0], static_cast<float>(std::sin(static_cast<int>(i))));
        }
    }
}

/// Twice the signed area of a closed polygon of vertices.
std::int64_t doubled_area(const std::vector<l3d_micro_vertex>& polygon) {
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const l3d_micro_vertex &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
    }
    return sum;
}

/// Whether a pixel's centre lies in a triangle or on its sides, looked for in all of its box.
bool holds_centre(const l3d_micro_triangles& triangles, std::size_t i) {
    const l3d_micro_vertex a = triangles.vertex(i, 0), b = triangles.vertex(i, 1),
                           c = triangles.vertex(i, 2);
    const auto columns = l3d_centres_in(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}));
    const auto rows = l3d_centres_in(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
    const auto centre = [](std::int32_t at) {
        return at * l3d_subpixel_one + l3d_subpixel_one / 2;
    };
    for (std::int32_t y = rows.first; y <= rows.last; ++y)
        for (std::int32_t x = columns.first; x <= columns.last; ++x) {
            const l3d_micro_vertex at{centre(x), centre(y), 0, {}};
            const std::array turns{doubled_area({a, b, at}), doubled_area({b, c, at}),
                                   doubled_area({c, a, at})};
            if (std::ranges::min(turns) >= 0 || std::ranges::max(turns) <= 0)
                return true;
        }
    return false;
}

/// The switch keeps triangles that hold no centre. Boxes of more than 32 lines are not looked at.
TEST(slit, has_only_triangles_that_hold_a_centre_unless_a_switch_keeps_the_others) {
    std::size_t all = 0, kept = 0;
    for (std::uint64_t seed = 1; seed <= 400; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        std::array<l3d_diced_piece, 2> pieces;
        for (const bool keeps : {false, true}) {
            random_numbers random(seed);
            auto [edge, view, line] = seen_edge(random, 0.3, 3);
            view.keep.centreless = keeps;
            l3d_diced_piece& piece = pieces[keeps ? 1 : 0];
            piece = piece_along(edge, {2, 3, 5, 4}, seed % 4, 0, 1, view, random);
            l3d_close_side(piece, seed % 4, line, view);
        }
        const l3d_micro_triangles &few = pieces[0].part.triangles, &many = pieces[1].part.triangles;
        std::size_t next = 0;
        for (std::size_t i = 0; i < many.count; ++i) {
            const auto is_next = [&](std::size_t k) {
                return next < few.count && few.vertex(next, k).x == many.vertex(i, k).x &&
                       few.vertex(next, k).y == many.vertex(i, k).y;
            };
            if (is_next(0) && is_next(1) && is_next(2))
                ++next;
            else
                EXPECT_FALSE(holds_centre(many, i)) << "triangle " << i << " is missing";
        }
        EXPECT_EQ(next, few.count);
        kept += few.count;
        all += many.count;
    }
    EXPECT_GT(kept, 100u);
    EXPECT_LT(kept, all / 2);
}

/// Only what covers no pixel is missing: all of a large slit is there.
TEST(slit, triangles_add_up_to_the_area_between_row_and_edge) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        random_numbers random(seed);
        const auto [edge, view, line] = seen_edge(random, 1, 1);
        l3d_diced_piece piece = piece_along(edge, {1, 2, 3, 1}, seed % 4, 0, 1, view, random);
        // Moves the row far off, so that no triangle is small; the ends stay.
        l3d_micro_grid& grid = piece.part.grid;
        for (std::int32_t& x : grid.x)
            x += 300 * l3d_subpixel_one;
        for (std::int32_t& y : grid.y)
            y += 700 * l3d_subpixel_one;
        l3d_close_side(piece, seed % 4, line, view);
        std::vector<l3d_micro_vertex> outline;
        for (const l3d_boundary_point& point : boundary_of(piece, seed % 4))
            outline.push_back(point.vertex.dice.vertex);
        for (std::size_t j = line.size(); j-- > 0;)
            outline.push_back(line.clip_vertex(j, view).dice.vertex);
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < piece.part.triangles.count; ++i)
            sum +=
                doubled_area({piece.part.triangles.vertex(i, 0), piece.part.triangles.vertex(i, 1),
                              piece.part.triangles.vertex(i, 2)});
        // Twice 256 by 256 to a pixel. Triangles that cover no centre are long, but thin.
        const double area = static_cast<double>(std::abs(doubled_area(outline)));
        EXPECT_NEAR(static_cast<double>(std::abs(sum)), area, 1e-3 * area + 2 * 0x1p17);
    }
}

} // namespace
} // namespace dice_tests
