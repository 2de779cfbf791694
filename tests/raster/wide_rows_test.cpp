// SPDX-License-Identifier: MIT
// Rows of large polygons in lanes against the same polygons pixel by pixel.
#include "raster/parallel/simd_target.h"
#include "raster/surfaces/band_scalar_p.h"
#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;

constexpr l3d_size size{131, 67};

l3d_shading tilted(l3d_shade mode) {
    return {mode, {0.36f, 0.48f, 0.8f}, {-0.3f, 0.2f, -1}, {0.01f, 0, 0}, {0, -0.02f, 0.003f}};
}

/// Random triangles that reach far out of the picture, slivers and points among them, with normals
/// of any length. Some are zero or no numbers.
l3d_micro_triangles random_triangles(unsigned seed, int count) {
    random_polygons random(seed, size);
    l3d_micro_triangles all;
    for (int i = 0; i < count; ++i) {
        std::array<l3d_micro_vertex, 3> v;
        const int reach = 256 * (i % 3 == 0 ? 12 : 300);
        for (l3d_micro_vertex& corner : v) {
            corner.x = random.number(-reach, 256 * size.width + reach);
            corner.y = random.number(-reach, 256 * size.height + reach);
            corner.inv_w = random.real(0.05f, 2.0f);
            for (float& number : corner.normal)
                number = i % 7 == 0 ? 0 : random.real(-2, 2);
        }
        if (i % 11 == 0)
            v[1].normal[1] = std::numeric_limits<float>::quiet_NaN();
        if (i % 5 == 0)
            v[2] = {v[1].x + 3, v[1].y + 1, v[2].inv_w, {0, 0, 1}};
        all.add(v[0], v[1], v[2], static_cast<std::uint32_t>(i % 4));
        if (i % 9 == 0) // of equals, the first is seen
            all.add(v[0], v[1], v[2], static_cast<std::uint32_t>((i + 1) % 4));
    }
    return all;
}

/// Words, depths and normals, with guards behind each row.
struct drawn_band {
    static constexpr int gap = 5;
    static constexpr std::size_t words_of_all =
        std::size_t{size.width + gap} * std::size_t{size.height};

    std::vector<std::uint32_t> words = std::vector<std::uint32_t>(words_of_all, 0xdeadbeef);
    std::vector<std::uint32_t> normals = std::vector<std::uint32_t>(words_of_all, 0xdeadbeef);
    std::vector<float> depths = std::vector<float>(words_of_all);
    fill_counts counts;

    drawn_band(const l3d_micro_triangles& triangles, l3d_shade mode, const fill_words& coding,
               bool by_lanes) {
        const l3d_shading shading = tilted(mode);
        const fill_band band{words.data(),     size.width + gap, depths.data(),
                             size.width + gap, size.width,       0,
                             size.height,      normals.data()};
        const std::vector<l3d_material> materials(4);
        l3d_surface_part part;
        part.triangles = triangles;
        fill_rest rest;
        for (std::size_t i = 0; i < triangles.count; ++i)
            rest.triangles.push_back({&triangles, i, coding.of_material(part.material_of(i))});
        band_scalar scalar;
        scalar.begin(band, shading, {}, coding);
        if (by_lanes)
            scalar.fill(rest);
        else
            scalar.fill(part, 0, triangles.count);
        counts = scalar.counts();
    }

    void expect_same(const drawn_band& other, const std::string& what) const {
        EXPECT_EQ(words, other.words) << what;
        EXPECT_EQ(normals, other.normals) << what;
        EXPECT_EQ(std::memcmp(depths.data(), other.depths.data(), depths.size() * sizeof(float)), 0)
            << what;
        EXPECT_EQ(counts.samples, other.counts.samples) << what;
        EXPECT_EQ(counts.written, other.counts.written) << what;
    }
};

TEST(WideRows, AreTheTwinsBitsWithAnyInstructions) {
    constexpr std::array modes{l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat,
                               l3d_shade::levels};
    for (unsigned n = 0; n < 20; ++n) {
        const l3d_micro_triangles triangles = random_triangles(n, 60);
        for (const l3d_shade mode : modes)
            for (const fill_words coding :
                 {fill_words{}, fill_words{true}, fill_words{true, true}}) {
                const drawn_band slow(triangles, mode, coding, false);
                EXPECT_GT(slow.counts.written, 0);
                for (const std::string& target : l3d_simd_targets()) {
                    ASSERT_TRUE(l3d_set_simd_target(target));
                    const drawn_band fast(triangles, mode, coding, true);
                    ASSERT_TRUE(l3d_set_simd_target(""));
                    fast.expect_same(slow, target + ", shade " + std::to_string(int(mode)) +
                                               ", seed " + std::to_string(n));
                }
            }
    }
}

} // namespace
