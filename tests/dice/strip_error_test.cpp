// SPDX-License-Identifier: MIT
// Strips between borders and edges: no point is farther from the edge than the strip says, wherever
// the border is and whatever its parameters say.
#include "dice/edges/shared_polylines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

namespace {

using vector = l3d_vector<double, 3>;
using any = std::uniform_real_distribution<double>;

constexpr double focal = 200;

l3d_dice_view view_of(double tolerance) {
    l3d_dice_view view;
    view.size = {160, 120};
    view.near = 0.5;
    view.tolerance = tolerance;
    view.focal = focal;
    return view;
}

/// The eye is in the origin and looks along z.
l3d_matrix<double> to_image() {
    l3d_matrix<double> result{};
    result(0, 0) = result(1, 1) = focal;
    result(2, 2) = result(3, 3) = 0;
    result(3, 2) = 1;
    return result;
}

l3d_space_curve::bezier random_cubic(std::mt19937& random) {
    l3d_space_curve::bezier result;
    for (int i = 0; i < 4; ++i) {
        const double w = any(0.5, 2)(random), z = any(2, 6)(random);
        result.push_back(
            {w * any(-0.6, 0.6)(random) * z, w * any(-0.4, 0.4)(random) * z, w * z, w});
    }
    return result;
}

vector place_of(l3d_space_curve::bezier points, double t) {
    for (std::size_t left = points.size(); --left > 0;)
        for (std::size_t i = 0; i < left; ++i)
            points[i] = points[i] * (1 - t) + points[i + 1] * t;
    return vector{points[0][0], points[0][1], points[0][2]} / points[0][3];
}

l3d_shared_polyline polyline_of(const l3d_space_curve::bezier& points, const l3d_dice_view& view,
                                double off = 0) {
    const vector from = place_of(points, 0), to = place_of(points, 1);
    const l3d_shared_edge edge{.curve = l3d_nurbs_curve::polyline({from, to}),
                               .spans = {{0, 1, points}},
                               .ends = {from, to},
                               .off = off};
    l3d_shared_polyline result;
    result.make(edge, to_image(), view);
    return result;
}

/// A place in the picture with z = 0, and in space as l3d_strip_corner has it.
std::array<vector, 2> seen(const vector& p) {
    return {vector{p[0], p[1], 0.0} * (focal / p[2]), p * focal};
}

/// The distance from a line of many places.
double distance(const vector& p, const std::vector<std::array<vector, 2>>& line, std::size_t in) {
    double result = HUGE_VAL;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        const vector from = line[i][in], way = line[i + 1][in] - from;
        const double part = std::clamp(l3d_dot(p - from, way) / l3d_dot(way, way), 0.0, 1.0);
        result = std::min(result, l3d_length(p - from - way * part));
    }
    return result;
}

TEST(strip_error, is_what_no_point_exceeds) {
    std::mt19937 random(547);
    long points = 0;
    double worst_place = 0, worst_depth = 0;
    for (int scene = 0; scene < 300; ++scene) {
        const l3d_dice_view view = view_of(scene % 2 == 0 ? 0.25 : 0.05);
        const l3d_space_curve::bezier cubic = random_cubic(random);
        const l3d_shared_polyline line = polyline_of(cubic, view);
        std::vector<std::array<vector, 2>> exact;
        for (int i = 0; i <= 2000; ++i)
            exact.push_back(seen(place_of(cubic, i / 2000.0)));
        // A border beside a few chords, whose parameters are a bit wrong, too.
        const double begin = any(0, 1)(random), end = std::min(1.0, begin + any(0, 0.1)(random));
        const auto border = [&](double t) {
            const double off = any(0, 0.004)(random), wrong = any(-0.01, 0.01)(random);
            vector p = place_of(cubic, std::clamp(t + wrong, 0.0, 1.0));
            for (int k = 0; k < 3; ++k)
                p[k] += off * any(-1, 1)(random);
            const l3d_image_point h{focal * p[0], focal * p[1], p[2]};
            return l3d_border_point{l3d_canonical_vertex(h, view), t};
        };
        l3d_diced_piece piece;
        l3d_add_strip(line, border(begin), border(end), view, piece);
        for (std::size_t i = 0; i < piece.part.triangles.count; ++i)
            for (int k = 0; k < 20; ++k) {
                std::array<double, 3> share{any(0, 1)(random), any(0, 1)(random), 0};
                if (share[0] + share[1] > 1)
                    share = {1 - share[0], 1 - share[1], 0};
                share[2] = 1 - share[0] - share[1];
                double x = 0, y = 0, inv_w = 0;
                for (std::size_t c = 0; c < 3; ++c) {
                    const l3d_micro_vertex v = piece.part.triangles.vertex(i, c);
                    x += share[c] * (v.x - view.centre_x()) / l3d_subpixel_one;
                    y += share[c] * (v.y - view.centre_y()) / l3d_subpixel_one;
                    inv_w += share[c] * double{v.inv_w};
                }
                if (std::abs(x) > 80 || std::abs(y) > 60)
                    continue;
                ++points;
                const vector picture{x, y, 0.0}, space = vector{x, y, focal} / inv_w;
                const double off = distance(picture, exact, 0) / piece.strips.places;
                const double off_space = distance(space, exact, 1) * inv_w / piece.strips.depth;
                EXPECT_LE(off, 1) << scene;
                EXPECT_LE(off_space, 1) << scene;
                worst_place = std::max(worst_place, off);
                worst_depth = std::max(worst_depth, off_space);
            }
    }
    EXPECT_GT(points, 5000);
    EXPECT_GT(worst_place, 0.9) << "the bound is no larger than it has to be";
    EXPECT_GT(worst_depth, 0.9);
}

/// Where the edge leaves the picture its chords are long, and a border beside them has no bound
/// that anybody needs.
TEST(strip_error, is_finite_where_edge_and_border_leave_the_picture) {
    const l3d_dice_view view = view_of(0.25);
    const l3d_space_curve::bezier straight{{0.0, 0.0, 4.0, 1.0}, {0.5, 0.5, -8.0, 1.0}};
    const l3d_shared_polyline line = polyline_of(straight, view);
    const auto at = [&](double t) {
        const vector p = place_of(straight, t);
        return l3d_border_point{
            l3d_canonical_vertex({focal * p[0] + 0.1, focal * p[1], p[2]}, view), t};
    };
    l3d_diced_piece piece;
    l3d_add_strip(line, at(0), at(1), view, piece);
    EXPECT_GT(piece.part.triangles.count, 3U);
    EXPECT_GT(piece.strips.places, 0);
    EXPECT_LT(piece.strips.places, 0.5);
    EXPECT_LT(piece.strips.depth, 0.5);
}

/// An edge goes from the middle of the picture to 200 000 px beside it. If it is loose, its faces
/// may be anywhere. Its chords are known as far as faces are looked for, and no farther.
TEST(shared_polyline, is_known_beside_the_picture_where_it_is_loose) {
    constexpr double farthest = 4096;
    const l3d_dice_view view = view_of(0.25);
    const l3d_image_box seen = view.margin();
    const vector end{1e3, 0.0, 1.0};
    for (const double off : {0.0, 1e6}) {
        const l3d_shared_polyline line =
            polyline_of({{0.0, 0.0, 1.0, 1.0}, {end[0], end[1], end[2], 1.0}}, view, off);
        double known = 0; // the places before are, too
        std::size_t chords = 1;
        for (; chords < line.chords.size() && std::isfinite(line.chords[chords].places); ++chords)
            known = line.points[chords].h[0] / line.points[chords].h[2];
        EXPECT_GE(known, seen.right + (off > 0 ? farthest : 0));
        EXPECT_LE(known, seen.right + (off > 0 ? farthest : 0) + 2 * l3d_longest_shared_chord);
        EXPECT_LT(chords, 2 * known / l3d_longest_shared_chord + 1);
        for (std::size_t i = chords; i < line.chords.size(); ++i)
            EXPECT_FALSE(std::isfinite(line.chords[i].places)) << i;
        EXPECT_LT(line.chords.size(), chords + 24) << "each is twice as long as the one before";
    }
}

/// An edge goes to and fro beside the picture 100 000 times, in chords that are too long to be
/// measured. Its strip, which reaches from the picture to there, is cut at each of them.
TEST(shared_polyline, of_many_unknown_chords_has_a_strip) {
    const l3d_dice_view view = view_of(0.25);
    constexpr int spans = 200000;
    const vector from{1.0, 0.0, 1.0}, to{2.0, 0.0, 1.0};
    l3d_shared_edge edge{
        .curve = l3d_nurbs_curve::polyline({from, to}), .spans = {}, .ends = {from, from}};
    for (int i = 0; i < spans; i += 2) {
        edge.spans.push_back({1.0 * i, i + 1.0, {{1.0, 0.0, 1.0, 1.0}, {2.0, 0.0, 1.0, 1.0}}});
        edge.spans.push_back({i + 1.0, i + 2.0, {{2.0, 0.0, 1.0, 1.0}, {1.0, 0.0, 1.0, 1.0}}});
    }
    l3d_shared_polyline line;
    line.make(edge, to_image(), view);
    ASSERT_EQ(line.t.size(), spans + 1U);
    EXPECT_FALSE(std::isfinite(line.chords[spans / 2].places));
    l3d_diced_piece piece;
    const auto border = [&](double x, double y, double t) {
        return l3d_border_point{l3d_canonical_vertex({x, y, 1.0}, view), t};
    };
    l3d_add_strip(line, border(0, 0, 0), border(0, 50, spans), view, piece);
    EXPECT_GT(piece.part.triangles.count, 100U);
    EXPECT_FALSE(std::isfinite(piece.strips.places));
}

} // namespace
