// SPDX-License-Identifier: MIT
// What a depth buffer tells apart: ours by its bound, and against 24 and 32 bits of whole numbers.
#include "raster/surface_rasterizer_scalar.h"
#include "raster/surface_rasterizer_sw.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <random>
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
        const triangle t = random_triangle(random, std::array{100.0, 1000.0, 1e6}[i % 3]);
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

/// How far behind a distance another one must be to be stored as farther, relative to it.
template <class Encode> double told_apart(const Encode& encode, double distance) {
    double least = 0, enough = distance;
    while (encode(distance + enough) == encode(distance))
        enough *= 2;
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
    std::printf("  far/near  at         24 bits      32 bits      float 1/w\n");
    for (const double ratio : {1e2, 1e3, 1e6}) {
        // What GL stores in whole numbers: 0 at near, 1 at far, linear in 1/w.
        const auto whole = [ratio](int bits) {
            return [ratio, bits](double w) {
                return std::floor((1 - 1 / w) / (1 - 1 / ratio) * (std::exp2(bits) - 1) + 0.5);
            };
        };
        const auto reciprocal = [](double w) { return static_cast<float>(1 / w); };
        for (const double place : {0.0, 0.5, 1.0}) {
            const double w = std::max(std::pow(ratio, place), 1.002);
            const double a = worst_gap(whole(24), w), b = worst_gap(whole(32), w),
                         c = worst_gap(reciprocal, w);
            std::printf("  %8.0e  %-8.4g %12.2e %12.2e %12.2e\n", ratio, w, a, b, c);
            // A step of n bits is w (1 - 1 / ratio) 2^-n of the distance, of floats 2^-23 at most.
            EXPECT_LE(c, 0x1p-23 * 1.01);
            EXPECT_NEAR(a / (w * (1 - 1 / ratio) * 0x1p-24), 1, 0.07);
            EXPECT_NEAR(b / (w * (1 - 1 / ratio) * 0x1p-32), 1, 0.1);
        }
    }
}

} // namespace
