// SPDX-License-Identifier: MIT
// Trimmed regions: triangles against the odd rule at random places, and loops against their curves.
#include "geom/trims/grid_trims.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <span>
#include <vector>

namespace {

using real = long double;

real turn(const l3d_trim_place& a, const l3d_trim_place& b, const l3d_trim_place& c) {
    return (real{b[0]} - a[0]) * (real{c[1]} - a[1]) - (real{b[1]} - a[1]) * (real{c[0]} - a[0]);
}

/// The distance of a place from a side.
real distance(const l3d_trim_place& p, const l3d_trim_place& a, const l3d_trim_place& b) {
    const real x = real{b[0]} - a[0], y = real{b[1]} - a[1], square = x * x + y * y;
    const real along = (p[0] - a[0]) * x + (p[1] - a[1]) * y;
    const real t = square > 0 ? std::clamp(along / square, real{0}, real{1}) : 0;
    return std::hypot(p[0] - a[0] - t * x, p[1] - a[1] - t * y);
}

template <class Visit> void for_sides(const l3d_trim_region& region, const Visit& visit) {
    for (const l3d_trim_polygon& polygon : region.polygons)
        for (std::size_t i = 0; i < polygon.size(); ++i)
            visit(polygon[i], polygon[(i + 1) % polygon.size()]);
}

/// The slow twin: the angle that each polygon winds around a place.
bool is_inside(const l3d_trim_region& region, const l3d_trim_place& p) {
    real angle = 0;
    for_sides(region, [&](const l3d_trim_place& a, const l3d_trim_place& b) {
        const real ax = a[0] - p[0], ay = a[1] - p[1], bx = b[0] - p[0], by = b[1] - p[1];
        angle += std::atan2(ax * by - ay * bx, ax * bx + ay * by);
    });
    return std::lround(angle / (2 * std::numbers::pi_v<real>)) % 2 != 0;
}

/// How many triangles hold a place; all of them turn left, but for those without area.
int count(const l3d_trim_triangles& all, const l3d_trim_place& p) {
    int result = 0;
    for (const auto& [a, b, c] : all.triangles()) {
        EXPECT_GE(turn(a, b, c), -1e-14L);
        result += turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0 ? 1 : 0;
    }
    return result;
}

/// Polygons that cross themselves and each other; some corners share coordinates.
l3d_trim_region random_region(std::mt19937& random, bool on_lattice) {
    std::uniform_real_distribution<double> any(-0.2, 1.2);
    l3d_trim_region result;
    for (int k = 0; k < 1 + static_cast<int>(random() % 4); ++k) {
        l3d_trim_polygon& polygon = result.polygons.emplace_back();
        for (int i = 0; i < 3 + static_cast<int>(random() % 12); ++i) {
            l3d_trim_place p{any(random), any(random)};
            if (on_lattice)
                p = {std::round(p[0] * 8) / 8, std::round(p[1] * 8) / 8};
            polygon.push_back({p});
        }
    }
    return result;
}

TEST(trim_triangles, cover_what_the_odd_rule_says) {
    std::mt19937 random(54);
    std::uniform_real_distribution<double> any(0, 1);
    int judged = 0;
    l3d_trim_triangles all;
    for (int round = 0; round < 400; ++round) {
        const l3d_trim_region region = random_region(random, round % 2 == 0);
        const l3d_trim_region inside = region.within({});
        all.cut(inside, {});
        for (int i = 0; i < 100; ++i) {
            const l3d_trim_place p{any(random), any(random)};
            real near = 1;
            for_sides(region, [&](const l3d_trim_place& a, const l3d_trim_place& b) {
                near = std::min(near, distance(p, a, b));
            });
            if (near < 1e-9L)
                continue;
            bool on_side = false; // of two triangles
            for (const auto& [a, b, c] : all.triangles())
                on_side = on_side || std::min({distance(p, a, b), distance(p, b, c),
                                               distance(p, c, a)}) < 1e-12L;
            if (on_side)
                continue;
            ++judged;
            ASSERT_EQ(count(all, p), is_inside(region, p) ? 1 : 0) << round;
            ASSERT_EQ(region.contains(p), is_inside(region, p)) << round;
        }
    }
    EXPECT_GT(judged, 39000);
}

TEST(trim_triangles, of_parts_fit_together) {
    std::mt19937 random(55);
    for (int round = 0; round < 200; ++round) {
        const l3d_trim_region region = random_region(random, round % 2 == 0).within({});
        const double at = round % 4 < 2 ? 0.5 : 0.3123;
        for (const std::size_t along : {std::size_t{0}, std::size_t{1}}) {
            const auto parts = region.halves(along, at);
            l3d_trim_box low, high;
            low.most[along] = high.least[along] = at;
            l3d_trim_triangles of_low, of_high, of_all;
            of_low.cut(parts[0], low);
            of_high.cut(parts[1], high);
            of_all.cut(region, {});
            const auto area = [](const l3d_trim_triangles& of) {
                real sum = 0;
                for (const auto& [a, b, c] : of.triangles())
                    sum += turn(a, b, c) / 2;
                return sum;
            };
            EXPECT_NEAR(double(area(of_low) + area(of_high)), double(area(of_all)), 1e-12);
            // Beside the line each ends where the other does, or the region ends.
            const auto stretches = region.stretches(along, at);
            const auto& of_line = of_low.sides()[along == 0 ? 3 : 1];
            for (const auto& part : of_line)
                EXPECT_TRUE(std::ranges::any_of(stretches, [&](const auto& s) {
                    return s[0] <= part[0] + 1e-12 && part[1] <= s[1] + 1e-12;
                })) << round;
        }
    }
}

/// A slanted strip between curved borders: no corners but those of its polygon.
TEST(trim_triangles, have_no_corners_but_those_of_simple_polygons) {
    l3d_trim_region region;
    l3d_trim_polygon& polygon = region.polygons.emplace_back();
    constexpr int sides = 12;
    for (int i = 0; i <= sides; ++i) {
        const double v = double(i) / sides;
        polygon.push_back({{0.2 + 0.3 * v + 0.1 * std::sin(5 * v), v}});
    }
    for (int i = sides; i >= 0; --i) {
        const double v = (i + 0.3 * std::sin(3 * i)) / sides;
        polygon.push_back({{0.5 + 0.3 * v, std::clamp(v, 0.0, 1.0)}});
    }
    l3d_trim_triangles all;
    all.cut(region, {});
    EXPECT_EQ(all.triangles().size(), polygon.size() - 2);
}

/// Each quad of a grid has what the region has there, and its corners are where they say.
TEST(grid_trims, leave_of_quads_what_the_region_has) {
    std::mt19937 random(56);
    std::uniform_real_distribution<double> any(0, 1);
    const std::vector<double> u{0, 0.125, 0.3, 0.5, 1}, v{0, 0.5, 0.61, 1};
    l3d_grid_trims grid;
    l3d_grid_trims::workshop in;
    int judged = 0;
    for (int round = 0; round < 200; ++round) {
        const l3d_trim_region region = random_region(random, round % 2 == 0);
        grid.make(region, u, v, in);
        EXPECT_TRUE(grid.is_for(u, v));
        EXPECT_FALSE(grid.is_for(u, u));
        real area = 0;
        std::size_t whole = 0;
        for (const l3d_grid_trims::part& part : grid.parts()) {
            const auto corners = grid.corners(part.corners);
            const l3d_trim_place least{u[part.of.column], v[part.of.row]},
                most{u[part.of.end_column], v[part.of.end_row]};
            for (const auto& [at, share] : corners)
                for (std::size_t k = 0; k < 2; ++k)
                    EXPECT_NEAR(least[k] + share[k] * (most[k] - least[k]), at[k], 1e-15);
            if (part.is_whole) {
                area += (real{most[0]} - least[0]) * (real{most[1]} - least[1]);
                whole += (part.of.end_row - part.of.row) * (part.of.end_column - part.of.column);
                continue;
            }
            real here = 0, around = 0;
            for (const auto& [a, b, c] : grid.triangles(part.triangles))
                here += turn(corners[a].at, corners[b].at, corners[c].at) / 2;
            area += here;
            for (const auto& sides : {grid.sides(part.border), grid.sides(part.inner)})
                for (const auto& side : sides)
                    around += turn({0, 0}, corners[side.from].at, corners[side.to].at) / 2;
            if (least[0] > 0 && least[1] > 0 && most[0] < 1 && most[1] < 1) {
                EXPECT_NEAR(double(around), double(here), 1e-12) << "by Green's theorem";
            }
        }
        EXPECT_EQ(whole + grid.cut().size(), (u.size() - 1) * (v.size() - 1));
        l3d_trim_triangles all;
        all.cut(region.within({}), {});
        real wanted = 0;
        for (const auto& [a, b, c] : all.triangles())
            wanted += turn(a, b, c) / 2;
        EXPECT_NEAR(double(area), double(wanted), 1e-12) << round;
        const auto length = [](std::span<const l3d_grid_trims::stretch> of) {
            double sum = 0;
            for (const auto& [from, to] : of)
                sum += to - from;
            return sum;
        };
        for (std::size_t side = 0; side < 4; ++side) {
            const std::vector<l3d_grid_trims::stretch>& kept = grid.kept()[side];
            EXPECT_NEAR(length(kept), length(all.sides()[side]), 1e-12) << round;
            for (std::size_t i = 1; i < kept.size(); ++i)
                EXPECT_LT(kept[i - 1][1], kept[i][0]) << "they are joined where they meet";
        }
        for (int i = 0; i < 20; ++i) {
            const l3d_trim_place p{any(random), any(random)};
            const auto index = [](const std::vector<double>& all_of, double at) {
                return static_cast<std::uint32_t>(std::ranges::upper_bound(all_of, at) -
                                                  all_of.begin() - 1);
            };
            const std::uint32_t row = index(v, p[1]), column = index(u, p[0]);
            const bool is_cut = std::ranges::binary_search(grid.cut(), std::array{row, column});
            if (!is_inside(region, p) && !is_cut)
                ADD_FAILURE() << round << ": a whole quad has a place outside";
            ++judged;
        }
    }
    EXPECT_EQ(judged, 4000);
}

/// A region with an edge along lines of the grid, below whole quads, and one across quads.
TEST(grid_trims, follow_edges_from_end_to_end) {
    const std::vector<double> u{0, 0.125, 0.3, 0.5, 1}, v{0, 0.5, 0.61, 1};
    l3d_trim_region region;
    l3d_flat_trims(std::vector<l3d_trim_loop>{{{{{0.125, 0.5, 1}, {0.5, 0.5, 1}}, 7, 2, 4},
                                               {{{0.5, 0.5, 1}, {0.8, 0.9, 1}}, 8, 0, 1},
                                               {{{0.8, 0.9, 1}, {0.125, 0.9, 1}}},
                                               {{{0.125, 0.9, 1}, {0.125, 0.5, 1}}}}},
                   {1, 1}, 1e-3, region);
    l3d_grid_trims grid;
    l3d_grid_trims::workshop in;
    grid.make(region, u, v, in);
    double of_line = 0, of_quads = 0;
    for (const l3d_grid_trims::part& part : grid.parts()) {
        for (const l3d_grid_trims::grid_side& side : grid.grid_sides(part.grid_sides)) {
            EXPECT_TRUE(part.is_whole);
            EXPECT_EQ(side.use.edge, 7U);
            EXPECT_EQ(side.from, (l3d_trim_place{u[side.column], v[side.row]}));
            EXPECT_EQ(side.to, (l3d_trim_place{u[side.end_column], v[side.end_row]}));
            EXPECT_EQ(side.row, 1U);
            EXPECT_EQ(side.end_row, 1U);
            EXPECT_EQ(side.quad_row, 1U);
            EXPECT_EQ(side.quad_column, side.column);
            of_line += side.use.to - side.use.from;
        }
        for (const l3d_grid_trims::corner_side& side : grid.sides(part.followed)) {
            EXPECT_EQ(side.use.edge, 8U);
            of_quads += side.use.to - side.use.from;
        }
    }
    EXPECT_NEAR(of_line, 2, 1e-12);
    EXPECT_NEAR(of_quads, 1, 1e-12);
}

/// A quarter of a circle and the way back, exact.
l3d_trim_loop quarter(double radius) {
    const double w = std::numbers::sqrt2 / 2;
    return {{{{radius, 0, 1}, {radius, radius, w}, {0, radius, 1}}},
            {{{0, radius, 1}, {0, 0, 1}}},
            {{{0, 0, 1}, {radius, 0, 1}}}};
}

TEST(flat_trims, are_as_near_as_they_say) {
    const std::vector<l3d_trim_loop> loops{quarter(0.7)};
    ASSERT_EQ(l3d_trims_complaint(loops), "");
    for (const double wanted : {1e-1, 1e-3, 1e-6}) {
        l3d_trim_region region;
        const double off = l3d_flat_trims(loops, {3, 3}, wanted, region);
        EXPECT_LE(off, wanted);
        ASSERT_EQ(region.polygons.size(), 1U);
        double worst = 0;
        for_sides(region, [&](const l3d_trim_place& a, const l3d_trim_place& b) {
            if (a[0] == 0 || a[1] == 0 || b[0] == 0 || b[1] == 0)
                return;
            worst = std::max(worst, 3 * (0.7 - std::hypot((a[0] + b[0]) / 2, (a[1] + b[1]) / 2)));
        });
        EXPECT_LE(worst, off);
        EXPECT_GT(worst, off / 20);
    }
}

TEST(flat_trims, are_as_fine_as_each_part_asks) {
    const std::vector<l3d_trim_loop> loops{quarter(0.7)};
    const double fine = 1e-5;
    // The arc goes from (0.7, 0) to (0, 0.7). Its low half is not shown.
    const auto wanted = [&](const l3d_trim_box& box) {
        return box.most[1] < 0.45 ? HUGE_VAL : fine;
    };
    l3d_trim_region whole, part;
    l3d_flat_trims(loops, {3, 3}, fine, whole);
    const l3d_flatness flat = l3d_flat_trims(loops, {3, 3}, wanted, part);
    EXPECT_LE(flat.off, fine);
    EXPECT_EQ(flat.share, flat.off / fine);
    EXPECT_GT(flat.off, 0);
    const auto corners = [](const l3d_trim_region& of, bool low) {
        return std::ranges::count_if(
            of.polygons.at(0), [&](const l3d_trim_corner& c) { return (c[1] < 0.45) == low; });
    };
    EXPECT_EQ(corners(part, false), corners(whole, false));
    EXPECT_LT(corners(part, true), corners(whole, true) / 4);
}

/// An arc and its chord, far below what is wanted: two corners would hold nothing.
TEST(flat_trims, keep_loops_that_hold_something) {
    l3d_trim_loop loop{quarter(0.7).front()};
    loop.push_back({{loop[0].points.back(), loop[0].points.front()}});
    l3d_trim_region region;
    l3d_flat_trims(std::array{loop}, {1, 1}, 10.0, region);
    EXPECT_TRUE(region.contains({0.45, 0.45}));
    EXPECT_FALSE(region.contains({0.3, 0.3}));
}

TEST(trim_region, is_none_of_a_box_that_two_polygons_fill) {
    const l3d_trim_polygon box{{{0.0, 0.0}}, {{1.0, 0.0}}, {{1.0, 1.0}}, {{0.0, 1.0}}};
    const l3d_trim_region one{{box}}, two{{box, box}}, three{{box, box, box}};
    EXPECT_TRUE(one.is_all_of({}) && three.is_all_of({}) && two.is_none_of({}));
    EXPECT_FALSE(one.is_none_of({}) || three.is_none_of({}) || two.is_all_of({}));
    EXPECT_TRUE(l3d_trim_region().is_none_of({}));
}

TEST(flat_trims, name_the_loop_at_fault) {
    const auto complaint = [](const l3d_trim_loop& loop) {
        return l3d_trims_complaint(std::array{quarter(0.5), loop});
    };
    EXPECT_EQ(complaint({}), "trim 2 has no curve");
    EXPECT_EQ(complaint({{{{0, 0, 1}}}}), "trim 2 has a curve of 1 control points");
    EXPECT_EQ(complaint({{{{0, 0, 1}, {1, 0, 1}}}}), "trim 2 is open from (1, 0) to (0, 0)");
    EXPECT_EQ(complaint({{{{0, 0, 1}, {1, 0, 0}, {0, 0, 1}}}}),
              "trim 2 has the weight 0, which is not from 1e-100 to 1e12");
    EXPECT_EQ(complaint({{{{0, 0, 1}, {NAN, 0, 1}, {0, 0, 1}}}}),
              "trim 2 has a coordinate that is not finite, or beyond 1e12");
}

/// Loops on a surface that is closed along u, from 0 to 4; v is from 0 to 2.
TEST(unrolled_trims, go_across_the_seam) {
    const l3d_trim_box box{{0, 0}, {4, 2}};
    const auto straight = [](double u0, double v0, double u1, double v1) {
        return l3d_trim_curve{{{u0, v0, 1}, {u1, v1, 1}}};
    };
    const auto holds = [&](const std::vector<l3d_trim_loop>& loops, double u, double v) {
        std::string why;
        const auto closed = l3d_unrolled(loops, box, {true, false}, why);
        EXPECT_TRUE(closed) << why;
        l3d_trim_region region;
        if (closed)
            l3d_flat_trims(*closed, {1, 1}, 1e-3, region);
        return region.within(box).contains({u, v});
    };
    const l3d_trim_loop right{straight(0, 0.5, 4, 0.5)}, left{straight(4, 1.5, 0, 1.5)};
    for (const double u : {0.1, 2.0, 3.9}) {
        EXPECT_TRUE(holds({right}, u, 1));
        EXPECT_FALSE(holds({right}, u, 0.3));
        EXPECT_TRUE(holds({left}, u, 1));
        EXPECT_FALSE(holds({left}, u, 1.7));
        EXPECT_TRUE(holds({left, right}, u, 1));
        EXPECT_FALSE(holds({right, left}, u, 0.3));
        EXPECT_FALSE(holds({right, left}, u, 1.7));
    }
    // A square about the seam: it goes on beyond it, or comes back at the other side.
    const l3d_trim_loop on{straight(3.5, 0.5, 4.5, 0.5), straight(4.5, 0.5, 4.5, 1.5),
                           straight(4.5, 1.5, 3.5, 1.5), straight(3.5, 1.5, 3.5, 0.5)};
    const l3d_trim_loop back{straight(3.5, 0.5, 4, 0.5),   straight(0, 0.5, 0.5, 0.5),
                             straight(0.5, 0.5, 0.5, 1.5), straight(0.5, 1.5, 0, 1.5),
                             straight(4, 1.5, 3.5, 1.5),   straight(3.5, 1.5, 3.5, 0.5)};
    for (const l3d_trim_loop& loop : {on, back}) {
        EXPECT_TRUE(holds({loop}, 0.2, 1));
        EXPECT_TRUE(holds({loop}, 3.8, 1));
        EXPECT_FALSE(holds({loop}, 0.7, 1));
        EXPECT_FALSE(holds({loop}, 3.3, 1));
    }
    std::string why;
    EXPECT_FALSE(l3d_unrolled(std::span(&right, 1), box, {false, false}, why));
    EXPECT_EQ(why, "trim 1 is open from (4, 0.5) to (0, 0.5)");
    EXPECT_FALSE(l3d_unrolled(std::vector<l3d_trim_loop>{{straight(0, 0.5, 8, 0.5)}}, box,
                              {true, false}, why));
    EXPECT_EQ(why, "a trim goes around the surface more than once");
    EXPECT_FALSE(l3d_unrolled(std::vector<l3d_trim_loop>{right, {straight(1, 0, 1, 2)}}, box,
                              {true, true}, why));
    EXPECT_EQ(why, "trims go around the surface along u and along v");
}

/// Parts of a polygon have the parameters of their edge, the same at the line that cuts them.
TEST(trim_region, keeps_edges_when_it_is_cut) {
    l3d_trim_region region;
    l3d_flat_trims(std::vector<l3d_trim_loop>{{{{{0.1, 0.1, 1}, {0.9, 0.1, 1}}, 7, 2, 4},
                                               {{{0.9, 0.1, 1}, {0.5, 0.9, 1}}, 8, 0, 1},
                                               {{{0.5, 0.9, 1}, {0.1, 0.1, 1}}}}},
                   {1, 1}, 1e-3, region);
    EXPECT_TRUE(region.follows_edges());
    std::vector<l3d_trim_use> uses;
    for (const l3d_trim_region& half : region.halves(0, 0.3))
        for (const l3d_trim_polygon& polygon : half.polygons)
            for (const l3d_trim_corner& corner : polygon)
                if (corner.side.edge == 7)
                    uses.push_back(corner.side);
    ASSERT_EQ(uses.size(), 2U);
    EXPECT_EQ(uses[0].from, 2);
    EXPECT_NEAR(uses[0].to, 2.5, 1e-12);
    EXPECT_EQ(uses[0].to, uses[1].from);
    EXPECT_EQ(uses[1].to, 4);
    EXPECT_FALSE(region.within({{0.4, 0.3}, {0.5, 0.4}}).follows_edges());
}

} // namespace
