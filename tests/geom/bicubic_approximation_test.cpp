// SPDX-License-Identifier: MIT
// The bounds of bicubic approximations against surfaces evaluated in long double.
#include "geom/nurbs/bicubic_approximation.h"

#include "rational_oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace {

using oracle::rational_jet;

/// How far the places and normals of a piece's approximation are off, at n by n places of
/// [a, a + h] by [b, b + h] of the patch that it is a part of.
struct measured {
    long double error = 0, normal_error = 0;

    measured(const l3d_patch_points& whole, const l3d_bicubic_approximation& by,
             const l3d_normal_approximation& normals, double a, double b, double h, int count) {
        for (int i = 0; i <= count; ++i)
            for (int j = 0; j <= count; ++j) {
                const long double s = static_cast<long double>(i) / count;
                const long double t = static_cast<long double>(j) / count;
                const rational_jet exact(whole, a + h * s, b + h * t);
                const rational_jet drawn(by.patch, s, t);
                error = std::max(error, oracle::distance(exact.place, drawn.place));
                const auto n = normals.net.evaluate(static_cast<double>(s), static_cast<double>(t));
                const oracle::place_3 n_drawn{n[0], n[1], n[2]};
                // At a pole, long double has nothing but rounding.
                if (oracle::length(exact.by_u) * h > 1e-12L * (1 + oracle::length(exact.place)))
                    normal_error =
                        std::max(normal_error, oracle::distance(oracle::unit(exact.normal()),
                                                                oracle::unit(n_drawn)));
            }
    }
};

/// A random part: halves, halves of these, and so on, in both directions.
struct part {
    l3d_rational_piece piece;
    double a = 0, b = 0, h = 1;

    part(const l3d_patch_points& patch, int depth, std::mt19937& random) : piece(patch) {
        for (int i = 0; i < depth; ++i) {
            h /= 2;
            for (const bool along_u : {true, false}) {
                auto halves = piece.halves(along_u);
                const bool second = random() % 2 == 1;
                piece = second ? halves.second : halves.first;
                (along_u ? a : b) += second ? h : 0;
            }
        }
    }
};

} // namespace

TEST(bicubic_approximation, keeps_its_bounds_on_random_patches_of_every_degree) {
    std::mt19937 random(2501);
    std::vector<double> ratios, of_normals;
    for (int trial = 0; trial < 3000; ++trial) {
        const l3d_patch_points patch = oracle::random_rational(random);
        const part of(patch, static_cast<int>(random() % 6), random);
        const l3d_bicubic_approximation by(of.piece);
        const l3d_normal_approximation normals(of.piece);
        const measured m(patch, by, normals, of.a, of.b, of.h, 6);
        ASSERT_LE(m.error, by.error) << trial;
        ratios.push_back(static_cast<double>(m.error / by.error));
        if (!std::isfinite(normals.error))
            continue;
        of_normals.push_back(static_cast<double>(m.normal_error / normals.error));
        ASSERT_LE(m.normal_error, normals.error + 1e-15) << trial;
    }
    EXPECT_GT(of_normals.size(), 300u);
    std::ranges::sort(ratios);
    std::ranges::sort(of_normals);
    std::printf("measured / bound: places: median %.2f, most %.2f; normals of %zu: %.2f, %.2f\n",
                ratios[ratios.size() / 2], ratios.back(), of_normals.size(),
                of_normals[of_normals.size() / 2], of_normals.back());
}

TEST(bicubic_approximation, keeps_its_bounds_for_weights_and_places_of_any_size) {
    std::mt19937 random(2502);
    std::uniform_real_distribution<double> any(-1, 1);
    int finite = 0;
    for (std::size_t trial = 0; trial < 400; ++trial) {
        l3d_patch_points patch = oracle::random_rational(random);
        const double least = std::array{-20, -40, -332, -332}[trial % 4];
        const double most = std::array{20, 40, -300, 40}[trial % 4];
        patch.weights.clear();
        for (auto& p : patch.points) {
            patch.weights.push_back(std::exp2(least + (most - least) * (0.5 + 0.5 * any(random))));
            if (trial % 3 == 0)
                for (double& x : p)
                    x *= 1e7;
        }
        const part of(patch, static_cast<int>(random() % 6), random);
        const l3d_bicubic_approximation by(of.piece);
        double size = 0, reach = 0;
        for (const auto& p : patch.points)
            for (const double x : p)
                size = std::max(size, std::abs(x));
        for (const auto& p : by.patch.points)
            for (int k = 0; k < 3; ++k) {
                ASSERT_TRUE(std::isfinite(p[k])) << trial;
                reach = std::max(reach, std::abs(p[k]));
            }
        EXPECT_TRUE(trial % 4 > 1 || reach < 1000 * size) << trial;
        if (!std::isfinite(by.error))
            continue;
        ++finite;
        ASSERT_LE(
            measured(patch, by, l3d_normal_approximation(of.piece), of.a, of.b, of.h, 6).error,
            by.error)
            << trial;
    }
    EXPECT_GT(finite, 200);
}

TEST(bicubic_approximation, converges_with_the_fourth_power_and_normals_faster_at_poles_too) {
    // An eighth of a sphere: quarter circles of degree 2 turn about the pole.
    const double c = std::sqrt(0.5);
    const l3d_patch_points octant{2,
                                  2,
                                  {{0, 1, 0},
                                   {0, 1, 0},
                                   {0, 1, 0}, //
                                   {1, 1, 0},
                                   {1, 1, 1},
                                   {0, 1, 1},
                                   {1, 0, 0},
                                   {1, 0, 1},
                                   {0, 0, 1}},
                                  {1, c, 1, c, c * c, c, 1, c, 1}};
    std::mt19937 random(1);
    double last = 0, last_normal = 0;
    for (int depth = 0; depth < 8; ++depth) {
        l3d_rational_piece piece(octant);
        const double h = std::ldexp(1, -depth);
        for (int i = 0; i < depth; ++i)
            piece = piece.halves(true).first.halves(false).first; // those at the pole
        const l3d_bicubic_approximation by(piece);
        const l3d_normal_approximation normals(piece);
        const measured m(octant, by, normals, 0, 0, h, 12);
        ASSERT_LE(m.error, by.error);
        ASSERT_LE(m.normal_error, normals.error + 1e-15);
        EXPECT_GT(m.error, by.error / 8) << depth;
        std::printf("depth %d: error %.3g of %.3g, normals %.3g of %.3g\n", depth,
                    static_cast<double>(m.error), by.error, static_cast<double>(m.normal_error),
                    normals.error);
        if (depth > 3) {
            EXPECT_NEAR(last / by.error, 16, 3);
        }
        if (depth > 1 && depth < 5) { // rounding is the most of smaller errors
            EXPECT_GT(last_normal / normals.error, 64) << depth;
        }
        last = by.error;
        last_normal = normals.error;
    }
}

TEST(bicubic_approximation, is_the_same_on_both_sides_of_a_boundary) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 300; ++trial) {
        // Two patches with one boundary, the row 0 of one and the column at the end of the other.
        const l3d_patch_points a = oracle::random_rational(random);
        l3d_patch_points b = oracle::random_rational(random);
        while (b.degree_v != a.degree_u)
            b = oracle::random_rational(random);
        b.weights.resize(b.points.size(), 1);
        for (int i = 0; i <= a.degree_u; ++i) {
            const auto from = static_cast<std::size_t>(a.degree_u - i);
            const auto to = static_cast<std::size_t>(i * (b.degree_u + 1) + b.degree_u);
            b.points[to] = a.points[from];
            b.weights[to] = a.weights.empty() ? 1 : a.weights[from];
        }
        // The first half of one is the last half of the other; they were cut in other ways.
        const l3d_bicubic_approximation of_a(
            l3d_rational_piece(a).halves(false).first.halves(true).first);
        const l3d_bicubic_approximation of_b(l3d_rational_piece(b).halves(false).second);
        for (int i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k)
                ASSERT_EQ(of_a.patch.at(0, i)[k], of_b.patch.at(3 - i, 3)[k]) << trial;
    }
}

TEST(bicubic_approximation, of_a_bicubic_patch_is_itself) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 100; ++trial) {
        l3d_patch_points patch = oracle::random_rational(random);
        while (patch.degree_u != 3 || patch.degree_v != 3)
            patch = oracle::random_rational(random);
        patch.weights.clear();
        const l3d_bicubic_approximation by{l3d_rational_piece(patch)};
        for (std::size_t i = 0; i < 16; ++i)
            for (int k = 0; k < 3; ++k)
                EXPECT_NEAR(by.patch.points[i][k], patch.points[i][static_cast<std::size_t>(k)],
                            1e-10);
        EXPECT_LT(by.error, 1e-9);
        const l3d_normal_net exact(by.patch);
        const l3d_normal_approximation normals{l3d_rational_piece(patch)};
        for (const double u : {0.1, 0.5, 0.7})
            EXPECT_NEAR(l3d_dot(l3d_normalized(normals.net.evaluate(u, 0.3)),
                                l3d_normalized(exact.evaluate(u, 0.3))),
                        1, 1e-9);
    }
}
