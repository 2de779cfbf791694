// SPDX-License-Identifier: MIT
// draw_path: exact areas of outlines that cross, fold and lie upon each other; curves; blending.
#include "effort.h"
#include "raster/canvas_2d.h"
#include "raster/paths/flat_curve_p.h"
#include "raster/paths/path.h"
#include "raster/parallel/simd_target.h"
#include "raster/slow_area.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <string>

namespace {

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

constexpr int width = 13, height = 9;

/// Positions that matter: on pixels' sides and corners, on a coarse lattice where edges coincide,
/// anywhere, and far away.
l3d_point_2d position(std::mt19937& random, int manner) {
    const auto along = [&](double size) {
        switch (manner) {
        case 0:
            return std::round(uniform(random, -3, size + 3)) + 0.5;
        case 1:
            return std::round(uniform(random, -2, size + 2) * 4) / 4;
        case 2:
            return uniform(random, -1, size);
        case 3:
            return uniform(random, 3, 6);
        case 4:
            return uniform(random, -1e5, 1e5);
        default:
            return uniform(random, -60, 60);
        }
    };
    return {along(width), along(height)};
}

slow_area::shape random_shape(std::mt19937& random) {
    slow_area::shape result;
    const int manner = static_cast<int>(random() % 6);
    result.inside = random() % 2 == 0 ? l3d_winding::nonzero : l3d_winding::even_odd;
    const std::size_t outlines = 1 + random() % 3;
    for (std::size_t o = 0; o < outlines; ++o) {
        std::vector<l3d_point_2d> outline(2 + random() % 7);
        for (l3d_point_2d& p : outline)
            p = position(random, random() % 8 == 0 ? static_cast<int>(random() % 4) : manner);
        for (std::size_t i = 1; i < outline.size(); ++i) {
            if (random() % 8 == 0)
                outline[i].x = outline[i - 1].x;
            if (random() % 8 == 0)
                outline[i].y = outline[i - 1].y;
            if (random() % 12 == 0)
                outline[i] = outline[random() % i];
        }
        // the same edges once more, there or back
        if (random() % 10 == 0)
            outline.insert(outline.end(), outline.begin(), outline.end());
        if (random() % 10 == 0)
            outline.insert(outline.end(), outline.rbegin(), outline.rend());
        result.outlines.push_back(outline);
    }
    return result;
}

l3d_path path_of(const slow_area::shape& shape) {
    l3d_path result;
    for (const auto& outline : shape.outlines)
        result.add_polygon(outline);
    return result;
}

void test_paths(int count, unsigned seed) {
    std::mt19937 random(seed);
    canvas c(width, height);
    double worst = 0;
    std::size_t partial = 0;
    for (int n = 0; n < count; ++n) {
        std::vector<slow_area::shape> shapes{random_shape(random)};
        if (n % 4 == 0)
            shapes.push_back(random_shape(random));
        const l3d_path path = path_of(shapes[0]), clip = path_of(shapes.back());
        l3d_fill fill{.color = 0x00ffffff, .inside = shapes[0].inside};
        if (shapes.size() > 1) {
            fill.clip = &clip;
            fill.clip_inside = shapes[1].inside;
        }
        if (n % 3 == 0)
            fill.alpha = uniform(random, 0, 1);
        if (n % 5 == 0)
            fill.box = {static_cast<int>(random() % 5) - 1, static_cast<int>(random() % 5) - 1,
                        static_cast<int>(random() % 16), static_cast<int>(random() % 12)};
        c.draw.clear_buffer();
        c.draw.draw_path(path, fill);
        ASSERT_TRUE(c.guards_intact()) << n;
        const slow_area::picture exact(shapes);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const bool in_box = x >= fill.box.left && x < fill.box.right && y >= fill.box.top &&
                                    y < fill.box.bottom;
                const double expected =
                    in_box ? 255 * fill.alpha * static_cast<double>(exact.share(x, y)) : 0;
                const double off = std::abs((c.at(x, y) & 255) - expected);
                ASSERT_LE(off, 0.5 + 1e-6)
                    << "seed " << seed << ", path " << n << ", pixel " << x << " " << y;
                worst = std::max(worst, off);
                partial += expected > 1 && expected < 254;
            }
    }
    EXPECT_GT(worst, 0.4);
    EXPECT_GT(partial, static_cast<std::size_t>(count) * 4);
}

TEST(draw_path, covers_the_exact_area_of_each_pixel) {
    test_paths(3000, 1);
}

/// Takes minutes: make stress.
TEST(draw_path, DISABLED_covers_the_exact_area_of_each_pixel_of_100_000_paths) {
    test_paths(100000, 2);
}

/// The area of a circle's part with x <= a and y <= b, from its corner integrals.
double disc_corner(double radius, double a, double b) {
    constexpr int steps = 20000;
    const double low = -radius, high = std::clamp(a, -radius, radius);
    double sum = 0;
    for (int i = 0; i < steps; ++i) {
        // substituted so that the ends of the circle are smooth
        const double from = std::asin(low / radius), to = std::asin(high / radius);
        const double angle = from + (to - from) * (i + 0.5) / steps;
        const double rise = radius * std::cos(angle);
        sum += std::max(std::min(b, rise) + rise, 0.0) * rise * (to - from) / steps;
    }
    return sum;
}

TEST(draw_path, fills_a_circle_within_one_level_of_its_area) {
    canvas c(24, 24);
    const double x0 = 11.3, y0 = 12.1, radius = 9.7;
    l3d_path path;
    path.add_circle({x0, y0}, radius);
    c.draw.draw_path(path, {.color = 0x00ffffff});
    for (int y = 0; y < 24; ++y)
        for (int x = 0; x < 24; ++x) {
            const double l = x - 0.5 - x0, t = y - 0.5 - y0;
            const double area = disc_corner(radius, l + 1, t + 1) - disc_corner(radius, l, t + 1) -
                                disc_corner(radius, l + 1, t) + disc_corner(radius, l, t);
            EXPECT_NEAR(c.at(x, y) & 255, 255 * area, 0.5 + 255.0 * 1.5 / 1024) << x << ' ' << y;
        }
}

l3d_curve_2d random_curve(std::mt19937& random, double size, bool rational) {
    l3d_curve_2d curve;
    for (auto& p : curve.points) {
        const double w = rational ? std::exp(uniform(random, -3, 3)) : 1;
        p = {w * uniform(random, -size, size), w * uniform(random, -size, size), w};
    }
    return curve;
}

double distance_to_segment(l3d_point_2d p, l3d_point_2d a, l3d_point_2d b) {
    const double dx = b.x - a.x, dy = b.y - a.y, length = dx * dx + dy * dy;
    const double t =
        length > 0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / length, 0.0, 1.0) : 0;
    return std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy);
}

TEST(flatten, keeps_curves_within_the_distance_of_their_chords) {
    std::mt19937 random(3);
    const l3d_detail::seen_box everything{-1e9, -1e9, 1e9, 1e9};
    l3d_detail::flat_room room;
    double worst = 0;
    for (int n = 0; n < 600; ++n) {
        const double size = std::pow(10, uniform(random, -3, 2.5));
        const l3d_curve_2d curve = random_curve(random, size, n % 2 == 1);
        std::vector<l3d_point_2d> points{l3d_detail::projected(curve.points[0])};
        l3d_detail::flatten(curve, l3d_flat_enough, everything, room,
                            [&](std::span<const l3d_point_2d> ends) {
                                points.insert(points.end(), ends.begin(), ends.end());
                            });
        for (int i = 0; i <= 300; ++i) {
            const l3d_point_2d at = l3d_detail::projected(curve.evaluate(i / 300.0));
            double nearest = 1e9;
            for (std::size_t k = 1; k < points.size(); ++k)
                nearest = std::min(nearest, distance_to_segment(at, points[k - 1], points[k]));
            ASSERT_LE(nearest, l3d_flat_enough * 1.0001) << n;
            worst = std::max(worst, nearest);
        }
    }
    EXPECT_GT(worst, l3d_flat_enough / 2); // no more steps than needed
}

/// Each pixel's share of the shapes, within the rounding of its level.
void expect_exact_areas(canvas& c, const std::vector<slow_area::shape>& shapes) {
    ASSERT_TRUE(c.guards_intact());
    const slow_area::picture exact(shapes);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            ASSERT_NEAR(c.at(x, y) & 255, 255 * static_cast<double>(exact.share(x, y)), 0.5 + 1e-6)
                << x << ' ' << y;
}

/// Many outlines upon each other, so pixels have many edges, with each set of vector instructions.
TEST(draw_path, has_exact_areas_where_many_outlines_meet) {
    std::mt19937 random(29);
    canvas c(width, height);
    const std::vector<std::string> targets = l3d_simd_targets();
    for (int n = 0; n < (thorough ? 60 : 20); ++n) {
        const std::string& target = targets[static_cast<std::size_t>(n / 2) % targets.size()];
        l3d_set_simd_target(target);
        std::vector<slow_area::shape> shapes(n % 4 == 0 ? 2 : 1);
        for (slow_area::shape& shape : shapes) {
            shape = random_shape(random);
            for (int more = 0; more < 12; ++more)
                for (const auto& outline : random_shape(random).outlines)
                    shape.outlines.push_back(outline);
        }
        const l3d_path path = path_of(shapes[0]), clip = path_of(shapes.back());
        c.draw.clear_buffer();
        c.draw.draw_path(path, {.color = 0x00ffffff,
                                .inside = shapes[0].inside,
                                .clip = shapes.size() > 1 ? &clip : nullptr,
                                .clip_inside = shapes.back().inside});
        SCOPED_TRACE(target + ' ' + std::to_string(n));
        ASSERT_NO_FATAL_FAILURE(expect_exact_areas(c, shapes));
    }
    l3d_set_simd_target("");
}

/// Plots of many values: each row has hundreds of edges side by side, which share pixels.
TEST(draw_path, has_exact_areas_where_a_row_has_hundreds_of_edges) {
    std::mt19937 random(23);
    for (int n = 0; n < 2; ++n) {
        std::vector<slow_area::shape> shapes(n % 3 == 0 ? 2 : 1);
        for (slow_area::shape& shape : shapes) {
            shape.inside = random() % 2 == 0 ? l3d_winding::nonzero : l3d_winding::even_odd;
            const int corners = 650;
            auto& outline = shape.outlines.emplace_back();
            for (int i = 0; i < corners; ++i) {
                const double x = double(width) * i / corners + uniform(random, -0.3, 0.3);
                const double y = uniform(random, 0, height);
                const double parts = n % 2 == 0 ? 4 : 1e6; // on sides of pixels, and anywhere
                outline.push_back(
                    {std::round(x * parts) / parts - 0.5, std::round(y * parts) / parts});
            }
        }
        const l3d_path path = path_of(shapes[0]), clip = path_of(shapes.back());
        canvas c(width, height);
        c.draw.draw_path(path, {.inside = shapes[0].inside,
                                .clip = shapes.size() > 1 ? &clip : nullptr,
                                .clip_inside = shapes.back().inside});
        SCOPED_TRACE(n);
        ASSERT_NO_FATAL_FAILURE(expect_exact_areas(c, shapes));
    }
}

/// Bands of a wide picture have few rows, and those of a small box hold it whole.
TEST(draw_path, fills_a_wide_picture_as_it_fills_its_parts) {
    std::mt19937 random(31);
    constexpr int wide = 3000, high = 90, part_wide = 331, part_high = 47;
    canvas whole(wide, high), parts(wide, high);
    for (const l3d_winding rule : {l3d_winding::nonzero, l3d_winding::even_odd}) {
        std::vector<l3d_point_2d> outline;
        for (int i = 0; i < 700; ++i)
            outline.push_back({uniform(random, -20, wide + 20), uniform(random, -9, high + 9)});
        for (int i = 0; i < 700; ++i) // short edges, many of them in a band
            outline.push_back({wide / 2 + i * 0.31, high / 2 + uniform(random, -3, 3)});
        l3d_path path, clip;
        path.add_polygon(outline);
        clip.add_polygon(std::span(outline).first(50));
        for (const l3d_path* const shown :
             {static_cast<const l3d_path*>(nullptr), &std::as_const(clip)}) {
            whole.draw.clear_buffer();
            parts.draw.clear_buffer();
            l3d_fill fill{.color = 0x00ffffff, .inside = rule, .clip = shown};
            whole.draw.draw_path(path, fill);
            for (int y = 0; y < high; y += part_high)
                for (int x = 0; x < wide; x += part_wide) {
                    fill.box = {x, y, x + part_wide, y + part_high};
                    parts.draw.draw_path(path, fill);
                }
            for (int y = 0; y < high; ++y)
                for (int x = 0; x < wide; ++x)
                    ASSERT_EQ(whole.at(x, y), parts.at(x, y)) << x << ' ' << y;
        }
    }
}

/// The steps of the whole curve would be as small everywhere as its smallest weight needs them.
TEST(flatten, takes_no_more_chords_the_more_weights_differ) {
    const l3d_detail::seen_box everything{-1e9, -1e9, 1e9, 1e9};
    l3d_detail::flat_room room;
    for (const double k : {1.0, 10.0, 1e3, 1e6}) {
        l3d_curve_2d curve;
        curve.points = {{{0, 0, 1}, {200 * k, 0, k}, {200 / k, 200 / k, 1 / k}, {0, 200, 1}}};
        std::size_t chords = 0;
        l3d_detail::flatten(curve, l3d_flat_enough, everything, room,
                            [&](std::span<const l3d_point_2d> to) { chords += to.size(); });
        EXPECT_LT(chords, 1000u) << k;
    }
}

/// Chords whose ends lie on a curve are only inside of it. Those of the library are as far outside,
/// and so sqrt 2 times as long.
TEST(flatten, takes_chords_that_err_to_both_sides_alike) {
    l3d_detail::flat_room room;
    for (const double radius : {5.0, 40.0, 300.0}) {
        l3d_path path;
        path.add_circle({0, 0}, radius);
        std::size_t chords = 0;
        double least = radius, most = 0;
        l3d_point_2d from{radius, 0};
        l3d_detail::visit_flat(
            path, l3d_flat_enough, {-1e9, -1e9, 1e9, 1e9}, room, [](l3d_point_2d) {},
            [&](std::span<const l3d_point_2d> ends) {
                for (const l3d_point_2d& to : ends) {
                    most = std::max(most, std::hypot(to.x, to.y));
                    least = std::min(least, std::hypot((from.x + to.x) / 2, (from.y + to.y) / 2));
                    from = to;
                }
                chords += ends.size();
            },
            [](bool) {});
        const double longest = 2 * std::sqrt(2 * radius * 2 * l3d_flat_enough);
        EXPECT_LT(double(chords), 1.25 * 2 * std::numbers::pi * radius / longest) << radius;
        EXPECT_GT(most, radius + l3d_flat_enough / 2) << radius;
        EXPECT_LE(most, radius + l3d_flat_enough * 1.0001) << radius;
        EXPECT_LT(least, radius - l3d_flat_enough / 2) << radius;
        EXPECT_GE(least, radius - l3d_flat_enough * 1.0001) << radius;
    }
}

TEST(draw_path, shows_of_a_curve_what_lies_in_the_picture_however_far_it_goes) {
    // the same curve, seen whole and from its middle
    std::mt19937 random(5);
    for (int n = 0; n < 200; ++n) {
        canvas whole(120, 90), part(30, 20);
        const int left = static_cast<int>(random() % 90), top = static_cast<int>(random() % 70);
        l3d_path path, moved;
        const auto go = [&](const std::array<l3d_point_2d, 4>& p, bool rational) {
            const std::array<double, 3> weights{2, 0.5, rational ? 3.0 : 1.0};
            path.move_to(p[0]);
            path.rational_to({p[1], p[2], p[3]}, weights);
            const auto shift = [&](l3d_point_2d q) { return l3d_point_2d{q.x - left, q.y - top}; };
            moved.move_to(shift(p[0]));
            moved.rational_to({shift(p[1]), shift(p[2]), shift(p[3])}, weights);
        };
        for (int k = 0; k < 2; ++k) {
            std::array<l3d_point_2d, 4> p;
            for (l3d_point_2d& q : p)
                q = {uniform(random, -100, 220), uniform(random, -100, 190)};
            go(p, n % 2 == 0);
        }
        whole.draw.draw_path(path, {.color = 0x00ffffff});
        part.draw.draw_path(moved, {.color = 0x00ffffff});
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 30; ++x)
                ASSERT_NEAR(whole.at(x + left, y + top) & 255, part.at(x, y) & 255, 1) << n;
        ASSERT_TRUE(part.guards_intact());
    }
}

/// Outlines of two sides are filled many rows at once, unless another one is near. Here that leads
/// across all of the picture and back, and has no area.
TEST(draw_path, fills_between_two_sides_as_it_fills_anything) {
    constexpr int columns = 90, rows = 70;
    std::mt19937 random(11);
    for (int n = 0; n < 4000; ++n) {
        canvas at_once(columns, rows), one_by_one(columns, rows);
        const double beyond = n % 3 == 0 ? 200 : 0, thin = n % 5 == 0 ? 0.02 : 1;
        const double x = uniform(random, 0, 60);
        const auto corner = [&]() {
            l3d_point_2d p{x + thin * uniform(random, -beyond - x, 85 + beyond - x),
                           uniform(random, -beyond, 65 + beyond)};
            return n % 4 == 0 ? l3d_point_2d{std::round(p.x), std::round(p.y)} : p;
        };
        l3d_path path;
        if (n % 8 < 4) {
            for (int k = 0; k < 3 + n % 2; ++k)
                k == 0 ? path.move_to(corner()) : path.line_to(corner());
        } else {
            const double radius = std::exp(uniform(random, -2, 4));
            path.arc_to(corner(), {radius, n % 5 == 0 ? radius / 20 : radius},
                        uniform(random, 0, 172), 0, n % 3 == 0 ? 172 : 360);
        }
        path.close();
        l3d_path more = path;
        more.add_polygon(std::array<l3d_point_2d, 2>{{{-1, -1}, {columns, rows}}});
        const l3d_fill fill{.color = 0x00ffffff, .alpha = n % 7 == 0 ? 0.5 : 1};
        at_once.draw.draw_path(path, fill);
        one_by_one.draw.draw_path(more, fill);
        for (int y = 0; y < rows; ++y)
            for (int column = 0; column < columns; ++column)
                ASSERT_NEAR(at_once.at(column, y) & 255, one_by_one.at(column, y) & 255, 1)
                    << n << ": " << column << ", " << y;
        ASSERT_TRUE(at_once.guards_intact());
    }
}

/// Those that meet no other are filled by themselves.
TEST(draw_path, fills_many_outlines_as_it_fills_each) {
    constexpr int columns = 60, rows = 40;
    std::mt19937 random(13);
    for (int n = 0; n < 400; ++n) {
        canvas together(columns, rows), each(columns, rows);
        const l3d_fill fill{.color = 0x00ffffff, .inside = l3d_winding::even_odd};
        l3d_path all;
        for (int y = 5; y < rows; y += 10)
            for (int x = 5; x < columns; x += 10) {
                l3d_path one;
                const l3d_point_2d center{x + uniform(random, -1, 1), y + uniform(random, -1, 1)};
                if (random() % 3 == 0) { // turns up or down twice
                    one.arc_to(center, {3, 3}, uniform(random, 0, 344), 0, 229);
                    one.line_to(center);
                    one.close();
                } else {
                    one.add_circle(center, uniform(random, 0, 3));
                }
                all.add(one);
                each.draw.draw_path(one, fill);
            }
        together.draw.draw_path(all, fill);
        for (int y = 0; y < rows; ++y)
            for (int x = 0; x < columns; ++x)
                ASSERT_NEAR(together.at(x, y) & 255, each.at(x, y) & 255, 1) << n;
    }
}

TEST(draw_path, shows_a_hole_where_outlines_overlap) {
    canvas c(40, 40);
    l3d_path path;
    path.add_circle({20, 20}, 15);
    path.add_circle({20, 20}, 5);
    c.draw.draw_path(path, {.color = 0x00ffffff, .inside = l3d_winding::even_odd});
    EXPECT_EQ(c.at(20, 20), 0u);
    EXPECT_EQ(c.at(30, 20), 0x00ffffffu);
}

TEST(draw_path, mixes_colours_alike_with_all_vector_instructions) {
    std::mt19937 random(7);
    for (int n = 0; n < 100; ++n) {
        l3d_path path;
        if (n % 4 < 2) {
            path.add_circle({uniform(random, 0, 60), uniform(random, 0, 40)},
                            uniform(random, 0, 40));
        } else {
            path.move_to({uniform(random, 0, 60), uniform(random, 0, 40)});
            for (int corner = 0; corner < 3; ++corner)
                path.line_to({uniform(random, 0, 60), uniform(random, 0, 40)});
        }
        const l3d_fill fill{.color = static_cast<std::uint32_t>(random()) & 0x00ffffff,
                            .alpha = n % 2 == 0 ? 1 : uniform(random, 0, 1)};
        std::vector<std::uint32_t> before(60 * 40), first;
        for (std::uint32_t& word : before)
            word = static_cast<std::uint32_t>(random()) & (n % 3 == 0 ? ~0u : 0x00ffffffu);
        for (const std::string& target : l3d_simd_targets()) {
            l3d_set_simd_target(target);
            std::vector<std::uint32_t> words = before;
            l3d_rasterizer_2d_sw_imp imp({words.data(), 60, 40, 60});
            l3d_rasterizer_2d(imp).draw_path(path, fill);
            if (first.empty())
                first = words;
            EXPECT_EQ(words, first) << target;
        }
        l3d_set_simd_target("");
    }
}

TEST(draw_path, draws_nothing_of_what_is_no_number_or_has_no_area) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    canvas c(20, 20);
    l3d_path path;
    c.draw.draw_path(path, {});
    path.move_to({2, 2});
    path.line_to({nan, 10});
    path.line_to({10, 4});
    c.draw.draw_path(path, {});
    path.clear();
    path.add_polygon(std::array<l3d_point_2d, 3>{{{2, 2}, {10, nan}, {10, 4}}});
    c.draw.draw_path(path, {});
    path.clear();
    path.close();
    path.line_to({18, 18});
    path.close();
    c.draw.draw_path(path, {});
    EXPECT_TRUE(c.lit().empty());
    path.clear();
    path.move_to({-infinity, -infinity});
    path.line_to({infinity, -infinity});
    path.line_to({infinity, infinity});
    path.line_to({-infinity, infinity});
    c.draw.draw_path(path, {.color = canvas::color});
    EXPECT_EQ(c.lit().size(), 400u);
    // the sides of a box that is turned over, as far apart as they can be
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    c.draw.clear_buffer();
    c.draw.draw_path(path, {.color = canvas::color, .box = {most, 0, least, 20}});
    c.draw.draw_path(path, {.color = canvas::color, .box = {0, most, 20, least}});
    EXPECT_TRUE(c.lit().empty());
}

} // namespace
