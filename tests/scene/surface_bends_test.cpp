// SPDX-License-Identifier: MIT
// Bounds of bends and turns, against exact values at many points.
#include "bodies.h"
#include "exact_bends.h"
#include "teapot_studio.h"

#include "effort.h"

#include "raster/parallel/simd_target.h"
#include "reference/random_numbers.h"
#include "reference/random_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace dice_tests {
namespace {

using patch = l3d_bezier_patch<double, 3>;
using reference::random_numbers;

patch library_patch(const reference::patch& of) {
    patch result;
    for (std::size_t i = 0; i < 16; ++i)
        result.points[i] = {of.points[i].x, of.points[i].y, of.points[i].z};
    return result;
}

/// Compares bounds with exact values, and keeps how much larger they are.
class tightness {
public:
    void compare(const bend_numbers& bound, const bend_numbers& exact) {
        const double bend = std::max(exact.uu, exact.vv);
        const double turn = std::max(exact.turn_u, exact.turn_v);
        for (std::size_t n = 0; n < all_bends.size(); ++n) {
            const double b = bound.*all_bends[n].of, e = exact.*all_bends[n].of;
            violations += !(b >= e);
            infinite += std::isinf(b);
            // Mixed bends that are next to nothing beside the others do not count: twists and all.
            const double of_bends = bend * std::pow(turn, all_bends[n].order - 2);
            const double of_turns = std::pow(turn, all_bends[n].order);
            if (!std::isinf(b) && e > 0.125 * (n < 7 ? of_bends : of_turns) && e > 1e-6)
                ratios_[n].push_back(b / e);
        }
    }
    void compare(const l3d_surface_bends& bounds, const exact_bends& exact) {
        for (std::size_t i = 0; i < exact.of_blocks.size(); ++i)
            compare(bends_of_block(bounds, i), exact.of_blocks[i]);
        compare(bends_of_whole(bounds), exact.of_whole);
    }
    double quantile(std::size_t n, double part) {
        auto& of = ratios_[n];
        if (of.empty())
            return 1;
        const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(of.size() - 1));
        std::nth_element(of.begin(), of.begin() + at, of.end());
        return of[static_cast<std::size_t>(at)];
    }
    void print(const char* what) {
        std::printf("%s: %ld infinite; bound / exact, median, nine tenths, most:\n", what,
                    infinite);
        for (std::size_t n = 0; n < all_bends.size(); ++n)
            std::printf("  %-6s %8.3f %8.3f %10.3f of %zu\n", all_bends[n].name, quantile(n, 0.5),
                        quantile(n, 0.9), quantile(n, 1), ratios_[n].size());
    }

    long violations = 0, infinite = 0;

private:
    std::vector<double> ratios_[17];
};

/// Bounds against exact values of patches' own normals.
tightness measured(const std::vector<patch>& patches, int points) {
    tightness result;
    for (const patch& p : patches) {
        const l3d_normal_net normals(p);
        result.compare(l3d_surface_bends(p, normals), exact_bends(p, normals, points));
    }
    return result;
}

std::vector<patch> library_patches(const std::vector<reference::patch>& of) {
    std::vector<patch> result;
    for (const reference::patch& p : of)
        result.push_back(library_patch(p));
    return result;
}

const int points = thorough ? 13 : 5;

TEST(surface_bends, of_the_teapot_hold_and_are_tight) {
    const l3d_patch_model model = teapot_model();
    tightness found;
    for (std::size_t p = 0; p < model.patches().size(); ++p)
        found.compare(model.bends(p), exact_bends(model.patches()[p], model.normals(p), points));
    found.print("teapot");
    EXPECT_EQ(found.violations, 0);
    for (std::size_t n = 0; n < all_bends.size(); ++n) {
        const bool of_bends = n < 7, first = all_bends[n].order == 1;
        EXPECT_LE(found.quantile(n, 0.5), of_bends ? 1.15 : first ? 1.3 : 2) << all_bends[n].name;
        if (of_bends) {
            EXPECT_LE(found.quantile(n, 0.9), 1.2) << all_bends[n].name;
        }
        EXPECT_GE(found.quantile(n, 0), 1) << all_bends[n].name;
    }
}

TEST(surface_bends, of_random_patches_of_every_kind_hold) {
    using reference::patch_kind;
    constexpr reference::camera view{{2.5, 3.1, 6.3}, {0.4, 0.2, -0.3}, {0.1, 1, 0.05}, 41, 0.2};
    for (const auto& [kind, name] : {std::pair{patch_kind::moderate, "moderate"},
                                     {patch_kind::thin, "thin"},
                                     {patch_kind::folded, "folded"},
                                     {patch_kind::coincident, "coincident"},
                                     {patch_kind::stiff, "stiff"}}) {
        const auto patches =
            reference::random_patches(7, kind, thorough ? 100 : 5, view, {640, 480});
        tightness found = measured(library_patches(patches), thorough ? 9 : 5);
        found.print(name);
        EXPECT_EQ(found.violations, 0) << name;
    }
}

/// A bicubic patch of points given by row and column, each from 0 to 3.
patch made(const auto& point) {
    patch result;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c)
            result.at(r, c) = point(r, c);
    return result;
}

using vector = l3d_vector<double, 3>;

TEST(surface_bends, of_a_plane_are_nothing_whatever_its_parameters) {
    random_numbers random(3);
    const patch plane = made([&](int r, int c) {
        const double x = c + random.between(-0.3, 0.3), y = r + random.between(-0.3, 0.3);
        return vector(x + 7, y - 2 * x, 3 * y + x);
    });
    const l3d_surface_bends bends(plane, l3d_normal_net(plane));
    EXPECT_GT(bends.of_whole().uuvv, 0.1F);
    for (std::size_t i = 0; i < 16; ++i)
        for (const named_bend& b : all_bends)
            if (b.of != &bend_numbers::uuvv) {
                EXPECT_LT(bends_of_block(bends, i).*b.of, 1e-6) << b.name;
            }
}

TEST(surface_bends, of_a_quarter_of_a_cylinder_are_those_of_a_circle) {
    // The usual cubic; its speed is even within 2 %, as is that of its turn.
    const double k = 4.0 / 3 * (std::sqrt(2.0) - 1);
    const double x[]{1, 1, k, 0}, y[]{0, k, 1, 1};
    const double radius = 5, turn = std::acos(-1) / 8;
    const patch cylinder =
        made([&](int r, int c) { return vector(radius * x[c], radius * y[c], 3.0 * r); });
    const l3d_surface_bends bends(cylinder, l3d_normal_net(cylinder));
    for (std::size_t i = 0; i < 16; ++i) {
        const bend_numbers of = bends_of_block(bends, i);
        EXPECT_NEAR(of.uu, radius * turn * turn, 0.12 * radius * turn * turn);
        EXPECT_NEAR(of.turn_u, turn, 0.05 * turn);
        EXPECT_NEAR(of.n_uu, turn * turn, 0.15 * turn * turn);
        EXPECT_LT(of.n_uuu, 4 * turn * turn * turn);
        for (const auto nothing :
             {&bend_numbers::uv, &bend_numbers::vv, &bend_numbers::uuv, &bend_numbers::uvv,
              &bend_numbers::vvv, &bend_numbers::uuvv, &bend_numbers::turn_v, &bend_numbers::n_uv,
              &bend_numbers::n_vv, &bend_numbers::n_uuv, &bend_numbers::n_uvv,
              &bend_numbers::n_vvv})
            EXPECT_LT(of.*nothing, 1e-6);
    }
}

TEST(surface_bends, of_a_unit_sphere_are_squares_of_turns) {
    // Where N = S, N . S_uu = - S_u . S_u = - N_u . N_u.
    for (const patch& p : library_patches(ball())) {
        const l3d_surface_bends bends(p, l3d_normal_net(p));
        for (std::size_t i = 0; i < 16; ++i) {
            const bend_numbers of = bends_of_block(bends, i);
            EXPECT_NEAR(of.uu, of.turn_u * of.turn_u, 0.2 * of.uu);
            EXPECT_NEAR(of.vv, of.turn_v * of.turn_v, 0.2 * of.vv);
        }
    }
}

TEST(surface_bends, hold_at_poles_where_edges_are_points) {
    tightness found = measured(library_patches(globe()), points);
    found.print("globe");
    EXPECT_EQ(found.violations, 0);
    EXPECT_EQ(found.infinite, 0);
}

TEST(surface_bends, are_infinite_in_a_corner_without_a_normal_and_only_there) {
    const patch singular = made([](int r, int c) {
        // Both neighbours of the first corner are in one line with it.
        if (r + c == 1)
            return vector(1 + r, 0, 0);
        return vector(c, r, 0.1 * c * r);
    });
    const l3d_normal_net normals(singular);
    ASSERT_EQ(l3d_length(normals.at(0, 0)), 0);
    const l3d_surface_bends bends(singular, normals);
    EXPECT_EQ(bends.of_blocks().turn_u[0], INFINITY);
    EXPECT_EQ(bends.of_blocks().uu[0], INFINITY);
    EXPECT_EQ(bends.of_whole().uu, INFINITY);
    EXPECT_TRUE(std::isfinite(bends.of_whole().uuvv));
    for (const std::size_t far : {3U, 7U, 11U, 12U, 13U, 14U, 15U})
        EXPECT_TRUE(std::isfinite(bends.of_blocks().n_uuu[far])) << far;
    EXPECT_EQ(measured({singular}, points).violations, 0);
}

TEST(surface_bends, of_no_surface_are_infinite) {
    const patch point = made([](int, int) { return vector(1, 2, 3); });
    const l3d_surface_bends bends(point, l3d_normal_net(point));
    EXPECT_EQ(bends.of_whole().uu, INFINITY);
    EXPECT_EQ(bends.of_whole().n_vvv, INFINITY);
    EXPECT_EQ(bends.of_whole().uuvv, 0);
}

patch moved(const patch& of, const l3d_matrix<double>& by) {
    patch result;
    for (std::size_t i = 0; i < 16; ++i) {
        const auto p = by * l3d_vector<double, 4>(of.points[i], 1.0);
        result.points[i] = {p[0], p[1], p[2]};
    }
    return result;
}

TEST(surface_bends, under_a_similarity_are_scaled) {
    const l3d_patch_model model = teapot_model();
    auto placement = l3d_rotation<double>({1, 2, -3}, 40);
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            placement(row, column) *= column == 1 ? -2.5 : 2.5; // and mirrored
    for (std::size_t p = 0; p < model.patches().size(); ++p) {
        const l3d_surface_bends under = model.bends(p).under(placement);
        for (std::size_t i = 0; i <= 16; ++i) {
            const auto get = [&](const l3d_surface_bends& of) {
                return i < 16 ? bends_of_block(of, i) : bends_of_whole(of);
            };
            const bend_numbers before = get(model.bends(p)), after = get(under);
            for (std::size_t n = 0; n < all_bends.size(); ++n) {
                const double wanted = before.*all_bends[n].of * (n < 8 ? 2.5 : 1);
                if (std::isinf(wanted)) {
                    EXPECT_EQ(after.*all_bends[n].of, wanted);
                } else {
                    EXPECT_GE(after.*all_bends[n].of, wanted);
                    EXPECT_LE(after.*all_bends[n].of, wanted * (1 + 1e-6) + 1e-9);
                }
            }
        }
    }
}

TEST(surface_bends, under_any_map_hold) {
    const l3d_patch_model model = teapot_model();
    random_numbers random(5);
    for (const double unlike : {0.01, 0.1, 1.0}) {
        tightness found;
        for (std::size_t p = 0; p < model.patches().size(); ++p) {
            auto map = l3d_rotation<double>({1, 0.5, 2}, random.between(0, 340));
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 3; ++column)
                    map(row, column) += unlike * random.between(-1, 1);
            const patch placed = moved(model.patches()[p], map);
            found.compare(model.bends(p).under(map),
                          exact_bends(placed, l3d_normal_net(placed), thorough ? 9 : 5));
        }
        std::printf("unlike a similarity by %.2f, ", unlike);
        found.print("teapot");
        EXPECT_EQ(found.violations, 0);
    }
    l3d_matrix<double> flat = l3d_identity<double>();
    flat(1, 1) = 0;
    EXPECT_EQ(model.bends(0).under(flat).of_whole().uu, INFINITY);
    EXPECT_EQ(model.bends(0).under(flat).of_whole().turn_u, INFINITY);
}

TEST(surface_bends, are_the_same_on_every_simd_target) {
    const l3d_patch_model model = teapot_model();
    for (const std::string& target : l3d_simd_targets()) {
        ASSERT_TRUE(l3d_set_simd_target(target));
        for (std::size_t p = 0; p < model.patches().size(); ++p) {
            const l3d_surface_bends bends(model.patches()[p], model.normals(p));
            for (std::size_t i = 0; i < 16; ++i)
                for (const named_bend& b : all_bends)
                    EXPECT_EQ(bends_of_block(bends, i).*b.of,
                              bends_of_block(model.bends(p), i).*b.of)
                        << target << " " << b.name;
        }
    }
    l3d_set_simd_target("");
}

TEST(surface_bends, cost_this_much) {
    const l3d_patch_model model = teapot_model();
    using clock = std::chrono::steady_clock;
    double least = HUGE_VAL;
    float sum = 0;
    for (int round = 0; round < (thorough ? 20 : 1); ++round) {
        const auto start = clock::now();
        for (std::size_t p = 0; p < model.patches().size(); ++p)
            sum += l3d_surface_bends(model.patches()[p], model.normals(p)).of_whole().uuvv;
        const std::chrono::duration<double, std::micro> took = clock::now() - start;
        least = std::min(least, took.count() / static_cast<double>(model.patches().size()));
    }
    EXPECT_GT(sum, 0);
    std::printf("%.1f us a patch of the teapot\n", least);
}

} // namespace
} // namespace dice_tests
