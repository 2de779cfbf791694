// SPDX-License-Identifier: MIT
// Paths of cells: how they touch, how many steps they take, and what they miss.
#include "compare/cells/cell_path.h"
#include "compare/cells/cubic_frame_buffer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace {

using enum l3d_cell_touch;
using enum l3d_cell_order;

constexpr l3d_cell_touch touches[] = {face, edge, corner};

std::vector<l3d_cell> path(const l3d_cell& from, const l3d_cell& to, l3d_cell_touch touch,
                           l3d_cell_order order) {
    std::vector<l3d_cell> cells;
    const int steps = l3d_walk_cells(from, to, touch, order, [&](const l3d_cell& cell) {
        cells.push_back(cell);
        return true;
    });
    EXPECT_EQ(static_cast<std::size_t>(steps) + 1, cells.size());
    return cells;
}

/// Ways along the axes, largest first.
std::array<int, 3> ways(const l3d_cell& a, const l3d_cell& b) {
    std::array<int, 3> result;
    for (std::size_t i = 0; i < 3; ++i)
        result[i] = std::abs(a[i] - b[i]);
    std::sort(result.rbegin(), result.rend());
    return result;
}

int axes_of(const l3d_cell& a, const l3d_cell& b) {
    const auto way = ways(a, b);
    EXPECT_LE(way[0], 1);
    return way[0] + way[1] + way[2];
}

class some_cells {
public:
    l3d_cell next() { return {coordinate(), coordinate(), coordinate()}; }

private:
    int coordinate() { return static_cast<int>(random_() % 41) - 20; }

    std::mt19937 random_{11};
};

/// How the line from centre to centre meets a cell.
enum class meeting { none, touched, pierced };

/// Exact, in whole numbers. With s = 2 N t, the line is inside of slab i while 2 (c - from) - 1 <=
/// 2 d t <= ... + 1.
meeting line_meets(const l3d_cell& from, const l3d_cell& to, const l3d_cell& cell) {
    // t between low and high, both fractions: n / d.
    long low_n = 0, low_d = 1, high_n = 1, high_d = 1;
    for (std::size_t i = 0; i < 3; ++i) {
        const long d = to[i] - from[i], at = cell[i] - from[i];
        if (d == 0) {
            if (at != 0)
                return meeting::none;
            continue;
        }
        const long sign = d < 0 ? -1 : 1;
        const long enters = 2 * at * sign - 1, leaves = 2 * at * sign + 1, way = 2 * d * sign;
        if (enters * low_d > low_n * way) {
            low_n = enters;
            low_d = way;
        }
        if (leaves * high_d < high_n * way) {
            high_n = leaves;
            high_d = way;
        }
    }
    const long low = low_n * high_d, high = high_n * low_d;
    return low < high ? meeting::pierced : low == high ? meeting::touched : meeting::none;
}

TEST(cell_path, goes_from_end_to_end_by_touches_of_its_kind) {
    some_cells cells;
    for (int line = 0; line < 3000; ++line) {
        const l3d_cell from = cells.next(), to = cells.next();
        for (const l3d_cell_touch touch : touches)
            for (const l3d_cell_order order : {near_line, diagonal_first}) {
                const auto all = path(from, to, touch, order);
                ASSERT_EQ(all.front(), from);
                ASSERT_EQ(all.back(), to);
                for (std::size_t i = 1; i < all.size(); ++i) {
                    const int axes = axes_of(all[i - 1], all[i]);
                    ASSERT_GE(axes, 1);
                    ASSERT_LE(axes, static_cast<int>(touch));
                }
            }
    }
}

TEST(cell_path, takes_as_many_steps_as_the_ways_say) {
    some_cells cells;
    for (int line = 0; line < 3000; ++line) {
        const l3d_cell from = cells.next(), to = cells.next();
        const auto [a, b, c] = ways(from, to);
        const auto steps = [&](l3d_cell_touch touch, l3d_cell_order order) {
            return static_cast<int>(path(from, to, touch, order).size()) - 1;
        };
        EXPECT_EQ(steps(face, near_line), a + b + c);
        EXPECT_EQ(steps(corner, near_line), a);
        EXPECT_EQ(steps(corner, diagonal_first), a);
        EXPECT_EQ(steps(edge, diagonal_first), std::max(a, (a + b + c + 1) / 2));
        EXPECT_GE(steps(edge, near_line), a);
        EXPECT_LE(steps(edge, near_line), a + c);
    }
}

TEST(cell_path, of_a_knights_move_saves_a_third) {
    const l3d_cell from{3, 5, 7}, to{5, 5, 8};
    EXPECT_EQ(path(from, to, face, near_line).size(), 4u);
    const auto saved = path(from, to, corner, diagonal_first);
    EXPECT_EQ(saved, (std::vector<l3d_cell>{from, {4, 5, 8}, to}));
}

TEST(cell_path, across_faces_meets_all_cells_that_the_line_pierces_and_none_that_it_misses) {
    some_cells cells;
    for (int line = 0; line < 300; ++line) {
        const l3d_cell from = cells.next(), to = cells.next();
        const auto all = path(from, to, face, near_line);
        for (int x = std::min(from[0], to[0]); x <= std::max(from[0], to[0]); ++x)
            for (int y = std::min(from[1], to[1]); y <= std::max(from[1], to[1]); ++y)
                for (int z = std::min(from[2], to[2]); z <= std::max(from[2], to[2]); ++z) {
                    const l3d_cell cell{x, y, z};
                    const meeting how = line_meets(from, to, cell);
                    const bool is_visited = std::find(all.begin(), all.end(), cell) != all.end();
                    ASSERT_TRUE(how == meeting::touched || is_visited == (how == meeting::pierced));
                }
    }
}

/// Near the line: half a cell along each axis, at the places of the longest way.
TEST(cell_path, across_corners_stays_within_half_a_cell_of_the_line) {
    some_cells cells;
    for (int line = 0; line < 1000; ++line) {
        const l3d_cell from = cells.next(), to = cells.next();
        const int n = ways(from, to)[0];
        const auto all = path(from, to, corner, near_line);
        for (int k = 0; k <= n && n > 0; ++k)
            for (std::size_t i = 0; i < 3; ++i)
                ASSERT_LE(2 * std::abs((all[static_cast<std::size_t>(k)][i] - from[i]) * n -
                                       k * (to[i] - from[i])),
                          n);
    }
}

TEST(cell_path, ends_where_the_visitor_says_so) {
    int seen = 0;
    const int steps = l3d_walk_cells({0, 0, 0}, {9, 4, 2}, corner, near_line,
                                     [&](const l3d_cell&) { return ++seen < 4; });
    EXPECT_EQ(seen, 4);
    EXPECT_EQ(steps, 3);
}

/// A plane of all cells that it pierces stops every path, whatever its steps. One of a single cell
/// for each column is thinner: paths across corners slip through it.
TEST(cell_path, misses_no_surface_of_all_the_cells_that_it_pierces) {
    constexpr int side = 40;
    const auto height = [](double x, double y) { return 20 + 0.37 * (x - 20) - 0.61 * (y - 20); };
    std::set<l3d_cell> thick, thin;
    for (int x = 0; x < side; ++x)
        for (int y = 0; y < side; ++y) {
            // Over a column's square the plane reaches from corner to corner.
            const double low = height(x, y + 1), high = height(x + 1, y);
            for (int z = static_cast<int>(std::floor(low)); z <= static_cast<int>(high); ++z)
                thick.insert({x, y, z});
            thin.insert({x, y, static_cast<int>(std::floor(height(x + 0.5, y + 0.5)))});
        }
    std::mt19937 random(5);
    const auto coordinate = [&] { return 10 + static_cast<int>(random() % 20); };
    std::array<int, 4> missed_thick{}, missed_thin{};
    for (int ray = 0; ray < 4000; ++ray) {
        const l3d_cell from{coordinate(), coordinate(), 60}, to{coordinate(), coordinate(), -20};
        for (const l3d_cell_touch touch : touches) {
            const auto misses = [&](const std::set<l3d_cell>& surface) {
                bool hit = false;
                l3d_walk_cells(from, to, touch, near_line, [&](const l3d_cell& cell) {
                    hit = surface.contains(cell);
                    return !hit;
                });
                return !hit;
            };
            missed_thick[static_cast<std::size_t>(touch)] += misses(thick);
            missed_thin[static_cast<std::size_t>(touch)] += misses(thin);
        }
    }
    EXPECT_EQ(missed_thick, (std::array<int, 4>{}));
    EXPECT_EQ(missed_thin[1], 0);
    EXPECT_GT(missed_thin[3], 0);
}

TEST(cell_path, meets_the_same_cells_as_a_ray_in_the_cubic_frame_buffer) {
    std::mt19937 random(3);
    const auto coordinate = [&] { return static_cast<int>(random() % 30); };
    l3d_cubic_frame_buffer buffer;
    buffer.reset(30);
    std::vector<l3d_cell> filled;
    for (int i = 0; i < 700; ++i) {
        filled.push_back({coordinate(), coordinate(), coordinate()});
        const l3d_cell& cell = filled.back();
        buffer.fill({cell[0] + 0.5, cell[1] + 0.5, cell[2] + 0.5}, {0, 0, 1});
    }
    int met = 0;
    for (int ray = 0; ray < 2000; ++ray) {
        const l3d_cell from{0, coordinate(), coordinate()}, to{29, coordinate(), coordinate()};
        l3d_cell first{-1, -1, -1};
        bool is_clear = true; // rounding decides on what the line only touches
        l3d_walk_cells(from, to, face, near_line, [&](const l3d_cell& cell) {
            if (!buffer.is_filled(cell))
                return true;
            first = cell;
            return false;
        });
        for (const l3d_cell& cell : filled)
            is_clear = is_clear && line_meets(from, to, cell) != meeting::touched;
        const auto hit = buffer.first({0.5, from[1] + 0.5, from[2] + 0.5},
                                      {29, double(to[1] - from[1]), double(to[2] - from[2])}, 0);
        if (!is_clear || first[0] < 0)
            continue;
        ASSERT_TRUE(hit);
        ++met;
        EXPECT_NEAR(hit->t,
                    (29.0 * first[0] + (to[1] - from[1]) * (first[1] - from[1]) +
                     (to[2] - from[2]) * (first[2] - from[2])) /
                        (29.0 * 29 + std::pow(to[1] - from[1], 2) + std::pow(to[2] - from[2], 2)),
                    1e-9);
    }
    EXPECT_GT(met, 500);
}

} // namespace
