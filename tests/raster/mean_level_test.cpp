// SPDX-License-Identifier: MIT
// mean_level against the plain sum over samples, in double.
#include "raster/parallel/simd_target.h"
#include "raster/refine/mean_level_p.h"
#include "raster/refine/pair_measures_p.h"
#include "raster/srgb_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

namespace {

using namespace l3d_detail;

constexpr scan_point pixel{37 * l3d_subpixel_one, 21 * l3d_subpixel_one};

/// A random quad or triangle round the pixel, up to 6 pixels wide.
fragment_polygon random_polygon(std::mt19937& random, bool is_quad) {
    const auto from = [&](double least, double most) {
        return std::uniform_real_distribution<double>(least, most)(random);
    };
    fragment_polygon result{};
    result.corners = is_quad ? 4 : 3;
    const double first = from(0, 6.28), turn = is_quad ? 1.57 : 2.09;
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t corner = is_quad || i < 3 ? i : 2;
        if (corner < i) {
            result.x[i] = result.x[corner];
            result.y[i] = result.y[corner];
            result.light[0][i] = result.light[0][corner];
            continue;
        }
        const double angle = first + turn * double(i), radius = 256 * from(0.5, 3);
        result.x[i] = pixel.x + 128 + std::int32_t(radius * std::cos(angle));
        result.y[i] = pixel.y + 128 + std::int32_t(radius * std::sin(angle));
        result.light[0][i] = float(from(-150, 300));
    }
    for (const auto& [number, corner] : {std::pair{1, 0}, {2, 0}, {2, 1}, {1, 3}})
        result.light[number][corner] = float(from(-12, 12));
    return result;
}

/// The lit level at a place: the bilinear map of a quad's levels, with what sides bend by, and the
/// parabola over a triangle.
double lit_at(const fragment_polygon& of, double x, double y) {
    const auto mean = [](const std::int32_t(&c)[4]) {
        return 0.25 * (double(c[0]) + c[1] + c[2] + c[3]);
    };
    const double ax = of.x[2] - of.x[0], ay = of.y[2] - of.y[0];
    const double bx = of.x[3] - of.x[1], by = of.y[3] - of.y[1];
    const double hx = x - mean(of.x), hy = y - mean(of.y), area = ax * by - ay * bx;
    const double s = (hx * by - hy * bx) / area, t = (ax * hy - ay * hx) / area;
    const auto held = [](double part) { return std::clamp(part, 0.0, 1.0); };
    const auto& l = of.light[0];
    const double ab = of.light[1][0], ad = of.light[2][0], bc = of.light[2][1], dc = of.light[1][3];
    if (of.corners == 3) {
        const double b = held(0.25 - t), c = held(0.5 + s + t), a = 1 - b - c;
        return a * l[0] + b * l[1] + c * l[2] + 4 * (a * b * ab + a * c * ad + b * c * bc);
    }
    const double u = held(0.5 + s - t), v = held(0.5 + s + t);
    return (1 - v) * ((1 - u) * l[0] + u * l[1]) + v * ((1 - u) * l[3] + u * l[2]) +
           4 * u * (1 - u) * ((1 - v) * ab + v * dc) + 4 * v * (1 - v) * ((1 - u) * ad + u * bc);
}

/// The light of the level that mean_level gives is the mean of the samples' light.
TEST(mean_level, has_the_mean_of_the_light_at_samples) {
    std::mt19937 random(7);
    for (int n = 0; n < 4000; ++n) {
        const fragment_polygon polygon = random_polygon(random, n % 2 == 0);
        std::uint64_t samples = std::uint64_t{random()} << 32 | random();
        if (n % 3 == 0) // few
            samples &= std::uint64_t{random()} << 32 | random() % 256;
        if (samples == 0 || polygon.area2() == 0)
            continue;
        double light = 0, count = 0;
        for (int i = 0; i < mask_side * mask_side; ++i) {
            if ((samples >> i & 1) == 0)
                continue;
            const int row = i / mask_side, column = i % mask_side;
            const double x = pixel.x + 32 * (column + 0.5), y = pixel.y + 32 * (row + 0.5);
            const double lit = std::clamp(lit_at(polygon, x, y), 0.0, 229.5);
            light += l3d_light_of_level(25.5 + lit);
            ++count;
        }
        const double found = 25.5 + double(mean_level(polygon, pixel, samples));
        // Tables are straight between whole levels; floats have 24 bits.
        ASSERT_NEAR(l3d_light_of_level(found), light / count, 2e-5) << n;
    }
}

TEST(mean_level, is_the_same_number_with_every_instruction_set) {
    std::mt19937 random(8);
    for (int n = 0; n < 500; ++n) {
        const fragment_polygon polygon = random_polygon(random, n % 2 == 0);
        const std::uint64_t samples = std::uint64_t{random()} << 32 | random() | 1;
        if (polygon.area2() == 0)
            continue;
        ASSERT_TRUE(l3d_set_simd_target(""));
        const float best = mean_level(polygon, pixel, samples);
        for (const std::string& target : l3d_simd_targets()) {
            ASSERT_TRUE(l3d_set_simd_target(target));
            ASSERT_EQ(mean_level(polygon, pixel, samples), best) << target << ": " << n;
        }
    }
    ASSERT_TRUE(l3d_set_simd_target(""));
}

} // namespace
