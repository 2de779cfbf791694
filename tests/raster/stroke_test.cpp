// SPDX-License-Identifier: MIT
// l3d_stroked: what a pen covers, against the distance of each place from the path.
#include "raster/canvas_2d.h"
#include "raster/paths/flat_curve_p.h"
#include "raster/paths/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <utility>

namespace {

constexpr int width = 40, height = 30;

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

struct chord {
    l3d_point_2d a, b;

    double distance(l3d_point_2d p) const {
        const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
        const double along = (p.x - a.x) * dx + (p.y - a.y) * dy;
        const double t = length > 0 ? std::clamp(along / length, 0.0, 1.0) : 0;
        return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
    }
};

std::vector<chord> chords_of(const l3d_path& path) {
    std::vector<chord> result;
    l3d_point_2d begin{}, last{};
    const auto go = [&](l3d_point_2d to) { result.push_back({std::exchange(last, to), to}); };
    l3d_detail::flat_room room;
    l3d_detail::visit_flat(
        path, l3d_flat_enough, {-1e9, -1e9, 1e9, 1e9}, room,
        [&](l3d_point_2d p) { begin = last = p; },
        [&](std::span<const l3d_point_2d> ends) { std::ranges::for_each(ends, go); },
        [&](bool closed) {
            if (closed)
                go(begin);
        });
    return result;
}

l3d_path random_path(std::mt19937& random) {
    const auto place = [&] {
        return l3d_point_2d{uniform(random, 2, width - 2), uniform(random, 2, height - 2)};
    };
    l3d_path path;
    path.move_to(place());
    for (int i = 1 + static_cast<int>(random() % 4); i > 0; --i) {
        if (random() % 2 == 0)
            path.cubic_to(place(), place(), place());
        else
            path.line_to(place());
    }
    if (random() % 2 == 0)
        path.close();
    return path;
}

/// Around a pixel's sample nothing changes within 3/4 pixel unless the rim of the pen is so near.
TEST(stroke, with_round_joins_covers_what_is_within_half_its_width_of_the_path) {
    std::mt19937 random(1);
    std::size_t inside = 0, outside = 0;
    for (int n = 0; n < 120; ++n) {
        const l3d_path path = random_path(random);
        const double pen_width = std::pow(2, uniform(random, -2, 5));
        const l3d_path stroked =
            l3d_stroked(path, {.width = pen_width, .cap = l3d_cap::round, .join = l3d_join::round});
        const std::vector<chord> chords = chords_of(path);
        canvas c(width, height);
        c.draw.draw_path(stroked, {.color = 0x00ffffff});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                double nearest = 1e9;
                for (const chord& e : chords)
                    nearest = std::min(nearest, e.distance({double(x), double(y)}));
                const double beyond = nearest - pen_width / 2;
                constexpr double half_diagonal = std::numbers::sqrt2 / 2 + 0.003;
                if (beyond > half_diagonal) {
                    ASSERT_EQ(c.at(x, y) & 255, 0u) << n << ": " << x << ' ' << y;
                    ++outside;
                } else if (beyond < -half_diagonal) {
                    ASSERT_EQ(c.at(x, y) & 255, 255u) << n << ": " << x << ' ' << y;
                    ++inside;
                }
            }
    }
    EXPECT_GT(inside, 20000u);
    EXPECT_GT(outside, 20000u);
}

double cross(l3d_point_2d a, l3d_point_2d b) {
    return a.x * b.y - a.y * b.x;
}

/// Signed, of what a disc about (0, 0) shares with the triangle of its middle and an edge.
double shared_area(double radius, l3d_point_2d a, l3d_point_2d b) {
    const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
    const double middle = -(a.x * dx + a.y * dy) / length;
    const double rest = radius * radius - std::pow(cross(a, b), 2) / length;
    const double half = rest > 0 ? std::sqrt(rest / length) : 0;
    const auto at = [&](double t) {
        const double within = std::clamp(t, 0.0, 1.0);
        return l3d_point_2d{a.x + within * dx, a.y + within * dy};
    };
    const auto sector = [radius](l3d_point_2d from, l3d_point_2d to) {
        return radius * radius * std::atan2(cross(from, to), from.x * to.x + from.y * to.y);
    };
    const l3d_point_2d enters = at(middle - half), leaves = at(middle + half);
    return (sector(a, enters) + cross(enters, leaves) + sector(leaves, b)) / 2;
}

/// Of a square of side 1 about a place.
std::array<l3d_point_2d, 4> square_about(l3d_point_2d c) {
    return {{{c.x - 0.5, c.y - 0.5},
             {c.x + 0.5, c.y - 0.5},
             {c.x + 0.5, c.y + 0.5},
             {c.x - 0.5, c.y + 0.5}}};
}

/// The signed area of an outline's part in that square: its edges, moved to the square's sides.
double area_in_square(const std::vector<chord>& outline, l3d_point_2d c) {
    double sum = 0;
    for (const chord& e : outline) {
        std::vector<double> cuts{0, 1};
        const auto cut = [&cuts](double from, double to, double side) {
            if (const double t = (side - from) / (to - from); t > 0 && t < 1)
                cuts.push_back(t);
        };
        for (const double side : {-0.5, 0.5}) {
            cut(e.a.x, e.b.x, c.x + side);
            cut(e.a.y, e.b.y, c.y + side);
        }
        std::ranges::sort(cuts);
        const auto inside = [&](double t) {
            return l3d_point_2d{std::clamp(std::lerp(e.a.x, e.b.x, t) - c.x, -0.5, 0.5),
                                std::clamp(std::lerp(e.a.y, e.b.y, t) - c.y, -0.5, 0.5)};
        };
        for (std::size_t i = 1; i < cuts.size(); ++i)
            sum += cross(inside(cuts[i - 1]), inside(cuts[i])) / 2;
    }
    return sum;
}

/// Pixels on the rim of a segment's round cap, anywhere, and with the rim along a side.
TEST(stroke, has_round_caps_that_change_no_pixel_by_a_thousandth) {
    std::mt19937 random(3);
    double worst = 0;
    for (int n = 0; n < 3000; ++n) {
        const double radius = std::pow(2, uniform(random, -3, 12));
        const double turn = uniform(random, -3, 3), length = uniform(random, 0.1, 50);
        const l3d_point_2d along{std::cos(turn), std::sin(turn)};
        l3d_path line;
        line.move_to({-length * along.x, -length * along.y});
        line.line_to({0, 0});
        const std::vector<chord> outline =
            chords_of(l3d_stroked(line, {.width = 2 * radius, .cap = l3d_cap::round}));
        for (int i = 0; i < 16; ++i) {
            const double level = std::numbers::pi / 2 * std::floor(uniform(random, 0, 4));
            const double angle = i % 2 == 0 ? uniform(random, -3, 3) : level;
            l3d_point_2d place{radius * std::cos(angle), radius * std::sin(angle)};
            place.x += uniform(random, -0.5, 0.5);
            place.y += uniform(random, -0.5, 0.5);
            if (i % 4 == 1)
                place = {(radius + 0.5) * std::cos(angle), (radius + 0.5) * std::sin(angle)};
            if (place.x * along.x + place.y * along.y < std::numbers::sqrt2 / 2)
                continue;
            const auto square = square_about(place);
            double exact = 0;
            for (std::size_t k = 0; k < 4; ++k)
                exact += shared_area(radius, square[k], square[(k + 1) % 4]);
            const double off = std::abs(area_in_square(outline, place) - exact);
            ASSERT_LE(off, l3d_flat_enough) << n << ": " << radius << ' ' << angle;
            worst = std::max(worst, off);
        }
    }
    EXPECT_GT(worst, l3d_flat_enough / 4); // no more points than needed
}

/// The area that is covered, from coverage.
double area(const l3d_path& path, const l3d_stroke& pen) {
    canvas c(width, height);
    c.draw.draw_path(l3d_stroked(path, pen), {.color = 0x00ffffff});
    double sum = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            sum += (c.at(x, y) & 255) / 255.0;
    return sum;
}

TEST(stroke, has_the_areas_of_its_caps_and_joins) {
    l3d_path line;
    line.move_to({10.5, 10.5});
    line.line_to({30.5, 10.5});
    const double pi = std::numbers::pi;
    EXPECT_NEAR(area(line, {.width = 6}), 120, 0.05);
    EXPECT_NEAR(area(line, {.width = 6, .cap = l3d_cap::square}), 156, 0.05);
    EXPECT_NEAR(area(line, {.width = 6, .cap = l3d_cap::round}), 120 + 9 * pi, 0.1);
    l3d_path corner = line;
    corner.line_to({30.5, 25.5});
    const double legs = 6 * 20 + 6 * 15 - 9; // they share a square of 3 x 3
    EXPECT_NEAR(area(corner, {.width = 6, .join = l3d_join::miter}), legs + 9, 0.05);
    EXPECT_NEAR(area(corner, {.width = 6, .join = l3d_join::bevel}), legs + 4.5, 0.05);
    EXPECT_NEAR(area(corner, {.width = 6, .join = l3d_join::round}), legs + 9 * pi / 4, 0.1);
    // a right angle's miter is sqrt(2) widths long
    EXPECT_NEAR(area(corner, {.width = 6, .miter_limit = 1.42}), legs + 9, 0.05);
    EXPECT_NEAR(area(corner, {.width = 6, .miter_limit = 1.41}), legs + 4.5, 0.05);
    l3d_path square = corner;
    square.line_to({10.5, 25.5});
    square.close();
    EXPECT_NEAR(area(square, {.width = 4}), 24 * 19 - 16 * 11, 0.1);
    EXPECT_NEAR(area(square, {.width = 4, .join = l3d_join::bevel}), 24 * 19 - 16 * 11 - 4 * 2,
                0.1);
    l3d_path dot;
    dot.move_to({20.5, 15.5});
    dot.close();
    EXPECT_EQ(area(dot, {.width = 6}), 0);
    EXPECT_NEAR(area(dot, {.width = 6, .cap = l3d_cap::square}), 36, 0.01);
    EXPECT_NEAR(area(dot, {.width = 6, .cap = l3d_cap::round}), 9 * pi, 0.1);
}

std::size_t edges_of(const l3d_path& path) {
    return chords_of(path).size();
}

/// A plot is a line of many points. Each has one of the outline's on either side, as there is no
/// corner to be seen, and joins of all kinds cover the same. Ends are square to the curve, those of
/// dashes, too.
TEST(stroke, of_many_points_of_a_curve_covers_what_that_of_the_curve_does) {
    std::mt19937 random(11);
    for (int n = 0; n < 400; ++n) {
        // A quarter of a circle, nearly.
        const double radius = uniform(random, 8, 24), way = 0.55 * radius;
        const double left = uniform(random, 2, 10), top = uniform(random, 2, 6);
        const std::array<l3d_point_2d, 4> net{{{left, top + radius},
                                               {left, top + radius - way},
                                               {left + radius - way, top},
                                               {left + radius, top}}};
        l3d_path curve, points;
        curve.move_to(net[0]);
        curve.line_to(net[0]);
        curve.cubic_to(net[1], net[2], net[3]);
        points.move_to(net[0]);
        constexpr int count = 1000;
        for (int i = 1; i <= count; ++i) {
            const double t = double(i) / count, s = 1 - t;
            const auto at = [&](double l3d_point_2d::*of) {
                return s * s * (s * net[0].*of + 3 * t * net[1].*of) +
                       t * t * (3 * s * net[2].*of + t * net[3].*of);
            };
            points.line_to({at(&l3d_point_2d::x), at(&l3d_point_2d::y)});
        }
        // At most three quarters of the circle.
        l3d_stroke pen{.width = std::pow(2, uniform(random, -2, 3.5)),
                       .join = static_cast<l3d_join>(n % 3)};
        if (n % 2 == 1)
            pen.dashes = {3, 2};
        const l3d_path stroked = l3d_stroked(points, pen);
        EXPECT_LT(edges_of(stroked), 2.3 * count) << n;
        canvas one(width, height), other(width, height);
        one.draw.draw_path(l3d_stroked(curve, pen), {.color = 0x00ffffff});
        other.draw.draw_path(stroked, {.color = 0x00ffffff});
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                ASSERT_NEAR(one.at(x, y) & 255, other.at(x, y) & 255, pen.dashes.empty() ? 1 : 2)
                    << n << ": " << x << ' ' << y;
    }
}

TEST(stroke, cuts_dashes_by_length_along_lines_and_curves) {
    l3d_path line;
    line.move_to({2.5, 10.5});
    line.line_to({12.5, 10.5});
    line.line_to({38.5, 10.5});
    const double dash = area(line, {.width = 2, .dashes = {3, 2}});
    EXPECT_NEAR(dash, 2 * (7 * 3 + 1), 0.05); // 36 = 7 (3 + 2) + 1
    EXPECT_NEAR(area(line, {.width = 2, .dashes = {3, 2}, .dash_begin = 4}), 2 * (7 * 3), 0.05);
    EXPECT_NEAR(area(line, {.width = 2, .dashes = {3, 2}, .dash_begin = -1}), 2 * (7 * 3), 0.05);
    EXPECT_NEAR(area(line, {.width = 2, .dashes = {4}}), 2 * (4 * 4 + 4), 0.05);
    l3d_path circle;
    circle.add_circle({20.5, 15.5}, 10);
    const double half = area(circle, {.width = 2, .dashes = {std::numbers::pi}});
    EXPECT_NEAR(half, 20 * std::numbers::pi, 0.1);
    EXPECT_TRUE(l3d_stroked(line, {.dashes = {0, 0}}).empty());
    EXPECT_TRUE(l3d_stroked(line, {.dashes = {2, -1}}).empty());
    EXPECT_TRUE(l3d_stroked(line, {.width = 0}).empty());
}

/// Millions of dashes are far from every picture.
TEST(stroke, shows_the_dashes_of_lines_that_are_mostly_far_away) {
    const auto line = [](l3d_point_2d from, l3d_point_2d to) {
        l3d_path path;
        path.move_to(from);
        path.line_to(to);
        return path;
    };
    const l3d_stroke pen{.width = 8, .dashes = {20, 5}}, thirds{.width = 8, .dashes = {2, 5, 1}};
    for (const l3d_stroke& each : {pen, thirds}) {
        const l3d_path near = line({-16, 15}, {64, 15}), far = line({-1e8, 15}, {1e8, 15});
        l3d_stroke shifted = each;
        shifted.dash_begin = std::fmod(1e8 - 16, each.dashes.size() == 2 ? 25.0 : 16.0);
        ASSERT_GT(area(near, shifted), 100);
        EXPECT_NEAR(area(far, each), area(near, shifted), 0.05);
    }
    l3d_path detour; // what is seen comes after as much that is not
    detour.move_to({-1e8, -1e8});
    detour.line_to({1e8, -1e8});
    detour.line_to({1e8, 15});
    detour.line_to({-1e8, 15});
    l3d_stroke shifted = pen;
    shifted.dash_begin = 15; // 4e8 + 15 - 100, but for whole turns of 25
    EXPECT_NEAR(area(detour, pen), area(line({100, 15}, {-100, 15}), shifted), 0.05);
    const l3d_path slanted = line({-5e7, -5e7}, {5e7, 5e7});
    EXPECT_GT(area(slanted, pen), 0.7 * area(line({-9, -9}, {60, 60}), {.width = 8}));
}

/// What is drawn of dashes on both sides of where an outline is closed is one dash with a corner.
TEST(stroke, joins_the_first_and_the_last_dash_of_a_closed_outline) {
    l3d_path square; // 70 pixels around
    square.add_polygon(
        std::array<l3d_point_2d, 4>{{{10.5, 10.5}, {30.5, 10.5}, {30.5, 25.5}, {10.5, 25.5}}});
    EXPECT_NEAR(area(square, {.width = 4, .dashes = {10, 10}}), 4 * 40, 0.05);
    EXPECT_NEAR(area(square, {.width = 4, .join = l3d_join::bevel, .dashes = {10, 10}}), 4 * 40 - 2,
                0.05);
    EXPECT_NEAR(area(square, {.width = 4, .dashes = {10, 12, 48}}), 4 * 58, 0.05);
    EXPECT_NEAR(area(square, {.width = 4, .dashes = {100, 1}}), area(square, {.width = 4}), 0.01);
    // it begins in the middle of a gap: nothing is joined
    EXPECT_NEAR(area(square, {.width = 4, .dashes = {5, 5}, .dash_begin = 7.5}), 4 * 35, 0.2);
}

TEST(stroke, turns_the_squares_of_dashes_without_length_along_the_path) {
    l3d_path line, square;
    line.move_to({8, 4});
    line.line_to({23, 24}); // 25 pixels long: one dash in the middle, and one at the beginning
    for (const l3d_point_2d at : {l3d_point_2d{8, 4}, {15.5, 14}})
        square.add_polygon(std::array<l3d_point_2d, 4>{{{at.x + 1, at.y - 7},
                                                        {at.x + 7, at.y + 1},
                                                        {at.x - 1, at.y + 7},
                                                        {at.x - 7, at.y - 1}}});
    canvas dashes(width, height), squares(width, height);
    dashes.draw.draw_path(
        l3d_stroked(line, {.width = 10, .cap = l3d_cap::square, .dashes = {0, 12.5}}), {});
    squares.draw.draw_path(square, {});
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            EXPECT_NEAR(double(dashes.at(x, y) & 255), double(squares.at(x, y) & 255), 1)
                << x << ' ' << y;
    line.move_to({30.5, 20.5}); // a point alone has no direction
    line.close();
    canvas both(width, height);
    both.draw.draw_path(
        l3d_stroked(line, {.width = 10, .cap = l3d_cap::square, .dashes = {0, 12.5}}), {});
    EXPECT_EQ(both.at(26, 16) & 255, 255u);
}

TEST(stroke, draws_what_is_seen_behind_a_million_dashes_that_are_not) {
    l3d_path path;
    path.move_to({0, -100});
    path.line_to({3e6, -100});
    path.move_to({2.5, 10.5});
    path.line_to({38.5, 10.5});
    EXPECT_EQ(area(path, {.width = 2, .dashes = {1, 1}}), 18 * 2);
    path.close(); // the way back fills the gaps
    EXPECT_EQ(area(path, {.width = 2, .dashes = {1, 1}}), 36 * 2);
}

TEST(stroke, begins_dashes_as_far_along_as_numbers_reach) {
    l3d_path line;
    line.move_to({2.5, 10.5});
    line.line_to({38.5, 10.5});
    const double period = 7, rest = std::fmod(1e300, period);
    const double expected = area(line, {.width = 2, .dashes = {5, 2}, .dash_begin = rest});
    EXPECT_EQ(area(line, {.width = 2, .dashes = {5, 2}, .dash_begin = 1e300}), expected);
    EXPECT_EQ(area(line, {.width = 2, .dashes = {5, 2}, .dash_begin = rest - period}), expected);
    EXPECT_TRUE(l3d_stroked(line, {.dashes = {1e308, 1e308}, .dash_begin = -1}).empty());
}

TEST(stroke, of_any_width_covers_what_is_beside_the_path) {
    l3d_path line;
    line.move_to({10.5, 10.5});
    line.line_to({30.5, 14.5});
    for (const double pen_width : {1e4, 1e9, 1e12, 1e300})
        EXPECT_EQ(area(line, {.width = pen_width, .cap = l3d_cap::round}), width * height)
            << pen_width;
}

} // namespace
