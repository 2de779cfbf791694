// SPDX-License-Identifier: MIT
// The depths that a depth buffer tells apart: ours by its bound, and against 24 and 32 bits of
// whole numbers.
#include "raster/surfaces/surface_rasterizer_scalar.h"
#include "raster/surfaces/surface_rasterizer_sw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace {

constexpr l3d_size window{97, 61};

struct triangle {
    std::array<l3d_micro_vertex, 3> v;

    long double exact(int column, int row) const {
        using real = long double;
        const real x = 256 * column + 128 - v[0].x, y = 256 * row + 128 - v[0].y;
        const real x1 = v[1].x - v[0].x, y1 = v[1].y - v[0].y;
        const real x2 = v[2].x - v[0].x, y2 = v[2].y - v[0].y;
        const real all = x1 * y2 - y1 * x2;
        return v[0].inv_w + (x * y2 - y * x2) / all * (real(v[1].inv_w) - v[0].inv_w) +
               (x1 * y - y1 * x) / all * (real(v[2].inv_w) - v[0].inv_w);
    }
};

triangle random_triangle(std::mt19937& random, double ratio) {
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    triangle t;
    for (l3d_micro_vertex& v : t.v) {
        v.x = static_cast<std::int32_t>(unit() * 256 * 1.5 * window.width) - 6000;
        v.y = static_cast<std::int32_t>(unit() * 256 * 1.5 * window.height) - 4000;
        v.inv_w = static_cast<float>(std::pow(ratio, -unit()));
        v.normal[2] = 1;
    }
    return t;
}

std::vector<float> depths_of(l3d_surface_rasterizer& rasterizer, const triangle& t) {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(window.width * window.height));
    l3d_depth_buffer depth;
    depth.resize(window);
    rasterizer.begin({words.data(), window.width, window.height, window.width}, &depth, {});
    l3d_surface_part part;
    part.triangles.add(t.v[0], t.v[1], t.v[2]);
    const std::array<const l3d_surface_part*, 1> parts{&part};
    rasterizer.draw(parts);
    rasterizer.finish();
    std::vector<float> result;
    for (int y = 0; y < window.height; ++y)
        result.insert(result.end(), depth.row(y).begin(), depth.row(y).end());
    return result;
}

/// docs/POLYGONS.md: an error of at most 2^-22 of the nearest corner's 1/w, and in lanes 10^-5 of
/// the corners' range more. Triangles of at least a pixel's area, so that none is a sliver.
TEST(depth_precision, stored_depth_is_within_its_bound) {
    std::mt19937 random(911);
    l3d_surface_rasterizer_scalar scalar;
    l3d_workers workers(1);
    l3d_surface_rasterizer_sw lanes(workers);
    double worst = 0, worst_in_lanes = 0;
    for (int i = 0; i < 1500; ++i) {
        const triangle t = random_triangle(
            random, std::array{100.0, 1000.0, 1e6}[static_cast<std::size_t>(i % 3)]);
        const auto [far, near] = std::minmax({t.v[0].inv_w, t.v[1].inv_w, t.v[2].inv_w});
        const double bound = 0x1p-22 * double(near);
        const double in_lanes = bound + 1e-5 * (double(near) - far);
        const auto by_scalar = depths_of(scalar, t), by_lanes = depths_of(lanes, t);
        for (int y = 0; y < window.height; ++y)
            for (int x = 0; x < window.width; ++x) {
                const auto at = static_cast<std::size_t>(y * window.width + x);
                if (by_scalar[at] == 0)
                    continue;
                const auto exact = t.exact(x, y);
                worst = std::max(worst, double(std::abs(by_scalar[at] - exact)) / bound);
                worst_in_lanes =
                    std::max(worst_in_lanes, double(std::abs(by_lanes[at] - exact)) / in_lanes);
            }
    }
    EXPECT_LE(worst, 1);
    EXPECT_LE(worst_in_lanes, 1);
    EXPECT_GT(worst, 0.1); // a bound that is ten times too large would say little
}

/// Grey levels of two triangles, the first of which faces the light and the second does not.
std::vector<std::uint32_t> picture_of(l3d_surface_rasterizer& rasterizer, triangle bright,
                                      triangle dark, bool bright_first) {
    std::vector<std::uint32_t> words(static_cast<std::size_t>(window.width * window.height));
    for (l3d_micro_vertex& v : dark.v) {
        v.normal[2] = 0;
        v.normal[0] = 1;
    }
    if (!bright_first)
        std::swap(bright, dark);
    l3d_surface_part part;
    part.triangles.add(bright.v[0], bright.v[1], bright.v[2]);
    part.triangles.add(dark.v[0], dark.v[1], dark.v[2]);
    const std::array<const l3d_surface_part*, 1> parts{&part};
    l3d_depth_buffer depth;
    depth.resize(window);
    rasterizer.begin({words.data(), window.width, window.height, window.width}, &depth, {});
    rasterizer.draw(parts);
    rasterizer.finish();
    return words;
}

/// Two surfaces close behind each other are seen in the right order wherever they are farther
/// apart than their bounds together, whichever is drawn first, at any distance. The last ratio is
/// that of a parallel projection's values, 2 to 1.
TEST(depth_precision, surfaces_farther_apart_than_their_bounds_are_told_apart) {
    std::mt19937 random(407);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    l3d_surface_rasterizer_scalar scalar;
    l3d_workers workers(1);
    l3d_surface_rasterizer_sw lanes(workers);
    long decided = 0, closely = 0, wrong = 0;
    for (int i = 0; i < 1200; ++i) {
        const double ratio = std::array{100.0, 1000.0, 1e6, 2.0}[static_cast<std::size_t>(i % 4)];
        const double scale = std::pow(ratio, -unit()), slope = std::pow(10, -6 * unit());
        triangle a = random_triangle(random, 1), b = a;
        for (std::size_t k = 0; k < 3; ++k) {
            const double at = scale * (1 - 0.5 * slope * unit());
            a.v[k].inv_w = static_cast<float>(at);
            b.v[k].inv_w = static_cast<float>(at * (1 + (unit() - 0.5) * 0x1p-18));
        }
        const auto bounds_of = [](const triangle& t) {
            const auto [far, near] = std::minmax({t.v[0].inv_w, t.v[1].inv_w, t.v[2].inv_w});
            const double by_scalar = 0x1p-22 * double(near);
            return std::array{by_scalar, by_scalar + 1e-5 * (double(near) - far)};
        };
        const auto of_a = bounds_of(a), of_b = bounds_of(b);
        for (const bool in_lanes : {false, true})
            for (const bool a_first : {false, true}) {
                l3d_surface_rasterizer& by =
                    in_lanes ? static_cast<l3d_surface_rasterizer&>(lanes) : scalar;
                const auto picture = picture_of(by, a, b, a_first);
                for (int y = 0; y < window.height; ++y)
                    for (int x = 0; x < window.width; ++x) {
                        const auto word = picture[static_cast<std::size_t>(y * window.width + x)];
                        const auto apart = static_cast<double>(a.exact(x, y) - b.exact(x, y));
                        const double least = of_a[in_lanes] + of_b[in_lanes];
                        if (word == 0 || !(std::abs(apart) > least))
                            continue;
                        ++decided;
                        closely += std::abs(apart) < 2 * least;
                        wrong += ((word & 255) > 128) != (apart > 0);
                    }
            }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(closely, 100000);
    std::printf("  %ld pixels of pairs, %ld of them less than twice the bounds apart\n", decided,
                closely);
}

/// How far behind a distance another one must be to be stored as farther, relative to it; infinite
/// if nothing is.
template <class Encode> double told_apart(const Encode& encode, double distance) {
    constexpr double farthest = 1e15;
    double least = 0, enough = distance;
    while (encode(distance + enough) == encode(distance)) {
        enough *= 2;
        if (enough > farthest)
            return std::numeric_limits<double>::infinity();
    }
    // The worst place of a step: another surface just behind the one before it.
    for (int i = 0; i < 60; ++i) {
        const double middle = (least + enough) / 2;
        (encode(distance + middle) == encode(distance) ? least : enough) = middle;
    }
    return enough / distance;
}

/// The largest such gap among many distances up to a tenth before one: the largest step there is.
template <class Encode> double worst_gap(const Encode& encode, double distance) {
    double worst = 0;
    for (int i = 0; i < 400; ++i)
        worst = std::max(worst, told_apart(encode, distance * (1 - 0.1 * i / 400)));
    return worst;
}

TEST(depth_precision, floats_of_reciprocal_depth_hold_at_every_ratio) {
    std::printf("  far/near  at         16 bits      24 bits      32 bits      float 1/w\n");
    for (const double ratio : {1e2, 1e3, 1e6}) {
        // The depth that GL stores in whole numbers: 0 at near, 1 at far, linear in 1/w.
        const auto whole = [ratio](int bits) {
            return [ratio, bits](double w) {
                return std::floor((1 - 1 / w) / (1 - 1 / ratio) * (std::exp2(bits) - 1) + 0.5);
            };
        };
        const auto reciprocal = [](double w) { return static_cast<float>(1 / w); };
        for (const double place : {0.0, 0.5, 1.0}) {
            const double w = std::max(std::pow(ratio, place), 1.002);
            const double a = worst_gap(whole(24), w), b = worst_gap(whole(32), w),
                         c = worst_gap(reciprocal, w), d = worst_gap(whole(16), w);
            std::printf("  %8.0e  %-8.4g %12.2e %12.2e %12.2e %12.2e\n", ratio, w, d, a, b, c);
            // A step of n bits is w (1 - 1 / ratio) 2^-n of the distance, of floats 2^-23 at most.
            EXPECT_LE(c, 0x1p-23 * 1.01);
            EXPECT_NEAR(a / (w * (1 - 1 / ratio) * 0x1p-24), 1, 0.07);
            EXPECT_NEAR(b / (w * (1 - 1 / ratio) * 0x1p-32), 1, 0.1);
        }
    }
}

} // namespace
