// SPDX-License-Identifier: MIT
// The fill kernel against edge functions and planes evaluated pixel by pixel, against itself in
// bands, and every instruction set against the others.
#include "raster/away_from_eye_p.h"
#include "raster/fill_kernel_p.h"
#include "raster/simd_target.h"
#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace {

using namespace l3d_detail;

constexpr unsigned seed = 20060702;

l3d_shading tilted() {
    return {l3d_shade::lambert,
            {0.36f, 0.48f, 0.8f},
            {-0.3f, 0.2f, -1},
            {0.01f, 0, 0},
            {0, -0.02f, 0.003f}};
}

/// Picture and depth with guards around every row, filled band by band.
struct filled {
    static constexpr std::uint32_t guard = 0xdeadbeef;
    static constexpr float depth_guard = 12345;
    static constexpr int word_gap = 3, depth_gap = 5;

    filled(int width, int height) : size{width, height} {
        words.assign(std::size_t(width + word_gap) * std::size_t(height), guard);
        depths.assign(std::size_t(width + depth_gap) * std::size_t(height), depth_guard);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                word(x, y) = 0, inv_w(x, y) = 0;
    }

    std::uint32_t& word(int x, int y) {
        return words[std::size_t(y * (size.width + word_gap) + x)];
    }
    float& inv_w(int x, int y) { return depths[std::size_t(y * (size.width + depth_gap) + x)]; }

    template <class Fill> void in_bands(int rows, const Fill& fill) {
        for (int top = 0; top < size.height; top += rows)
            fill(fill_band{&word(0, top), size.width + word_gap, &inv_w(0, top),
                           size.width + depth_gap, size.width, top,
                           std::min(top + rows, size.height)});
    }

    void draw(const l3d_micro_grid& grid, int rows = 1 << 20) {
        in_bands(std::min(rows, size.height), [&](const fill_band& band) {
            fill_quads(band, shading, grid, 0, grid.rows - 1, 0, grid.columns - 1, counts, rest);
        });
    }

    void draw(const l3d_micro_triangles& triangles, int rows = 1 << 20) {
        in_bands(std::min(rows, size.height), [&](const fill_band& band) {
            fill_triangles(band, shading, triangles, 0, triangles.count, counts, rest);
        });
    }

    bool guards_intact() const {
        for (std::size_t i = 0; i < words.size(); ++i)
            if (int(i % std::size_t(size.width + word_gap)) >= size.width && words[i] != guard)
                return false;
        for (std::size_t i = 0; i < depths.size(); ++i)
            if (int(i % std::size_t(size.width + depth_gap)) >= size.width &&
                depths[i] != depth_guard)
                return false;
        return true;
    }

    bool same_bits(const filled& other) const {
        return words == other.words &&
               std::memcmp(depths.data(), other.depths.data(), depths.size() * sizeof(float)) == 0;
    }

    l3d_size size;
    std::vector<std::uint32_t> words;
    std::vector<float> depths;
    fill_shading shading{tilted()};
    fill_counts counts;
    fill_rest rest;
};

void normalize(l3d_micro_vertex& v) {
    const float length = std::sqrt(v.normal[0] * v.normal[0] + v.normal[1] * v.normal[1] +
                                   v.normal[2] * v.normal[2]);
    for (float& component : v.normal)
        component = length > 0 ? component / length : 0.0f;
}

std::string described(const reference::corners& v) {
    std::string text;
    for (const l3d_micro_vertex& c : v)
        text += "(" + std::to_string(c.x) + ", " + std::to_string(c.y) + ") ";
    return text;
}

/// Polygons as the lanes are to take them: unit normals, more or less parallel.
class unit_polygons {
public:
    explicit unit_polygons(l3d_size size) : random_(seed, size) {}

    reference::corners next() {
        reference::corners v = random_.next();
        const float spread = random_.real(0, 0.4f);
        std::array<float, 3> common{random_.real(-1, 1), random_.real(-1, 1), random_.real(-1, 1)};
        const bool none = random_.number(0, 19) == 0;
        for (l3d_micro_vertex& corner : v) {
            for (std::size_t k = 0; k < 3; ++k)
                corner.normal[k] = none ? 0 : common[k] + spread * corner.normal[k];
            normalize(corner);
        }
        return v;
    }

    random_polygons& random() { return random_; }

private:
    random_polygons random_;
};

/// How far a number is from the reference's, which is clamped to the corners'.
double depth_error(const reference::corners& v, float inv_w, int x, int y) {
    std::vector<float> at_corners;
    for (const l3d_micro_vertex& c : v)
        at_corners.push_back(c.inv_w);
    const auto [least, most] = std::minmax_element(at_corners.begin(), at_corners.end());
    const double exact = std::clamp(static_cast<double>(reference::at_centre(v, at_corners, x, y)),
                                    double(*least), double(*most));
    return std::abs(double(inv_w) - exact) - 4e-7 * exact;
}

/// The exact grey before rounding, or a negative number where the side that is seen is a matter of
/// rounding.
double grey_of(const reference::corners& v, const l3d_shading& s, int x, int y) {
    std::vector<float> number(v.size());
    double lit = 0, square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < v.size(); ++i)
            number[i] = v[i].normal[k];
        const auto n = static_cast<double>(reference::at_centre(v, number, x, y));
        lit += n * double(s.light[k]);
        square += n * n;
    }
    for (std::size_t i = 0; i < v.size(); ++i)
        number[i] = away_from_eye(v[i], s);
    const auto away = static_cast<double>(reference::at_centre(v, number, x, y));
    if (std::abs(away) < 1e-5)
        return -1;
    const double cosine = square > 1e-30 ? lit / std::sqrt(square) : 0;
    return 255 * (0.1 + 0.9 * std::clamp(away > 0 ? -cosine : cosine, 0.0, 1.0));
}

/// One polygon alone in a picture.
void compare(filled& picture, const reference::corners& v) {
    const l3d_shading shading = tilted();
    if (!picture.rest.quads.empty() || !picture.rest.triangles.empty()) {
        EXPECT_EQ(picture.counts.samples, 0);
        return;
    }
    const std::vector<reference::corners> pieces = reference::pieces(v);
    std::int64_t samples = 0;
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            const bool covered = pieces.size() == 1 && reference::covers(v, x, y);
            samples += covered;
            ASSERT_EQ(picture.inv_w(x, y) > 0, covered) << described(v) << "at " << x << ", " << y;
            if (!covered) {
                ASSERT_EQ(picture.word(x, y), 0u);
                continue;
            }
            float least = v[0].inv_w, most = v[0].inv_w;
            for (const l3d_micro_vertex& c : v) {
                least = std::min(least, c.inv_w);
                most = std::max(most, c.inv_w);
            }
            // Where a run begins left of a sliver it begins outside, many times the range away.
            const double part = x < picture.size.width - fill_least_width ? 1e-5 : 1e-3;
            ASSERT_LE(depth_error(v, picture.inv_w(x, y), x, y), part * double(most - least))
                << described(v) << "at " << x << ", " << y;
            ASSERT_GE(picture.inv_w(x, y), least);
            ASSERT_LE(picture.inv_w(x, y), most);
            const double grey = grey_of(v, shading, x, y);
            const std::uint32_t word = picture.word(x, y);
            ASSERT_EQ(word, (word & 0xff) * 0x010101);
            if (grey >= 0) {
                ASSERT_NEAR(word & 0xff, grey, 1.5) << described(v) << "at " << x << ", " << y;
            }
        }
    ASSERT_EQ(picture.counts.samples, samples) << described(v);
    ASSERT_EQ(picture.counts.written, samples) << described(v);
}

TEST(FillKernel, DrawsRandomPolygonsLikeTheTwin) {
    RecordProperty("seed", static_cast<int>(seed));
    const l3d_size size{61, 31};
    unit_polygons polygons(size);
    std::int64_t taken = 0, samples = 0;
    for (int n = 0; n < 60000; ++n) {
        const reference::corners v = polygons.next();
        filled picture(size.width, size.height);
        if (v.size() == 3) {
            l3d_micro_triangles triangles;
            triangles.add(v[0], v[1], v[2]);
            picture.draw(triangles);
        } else {
            l3d_micro_grid grid;
            grid.resize(2, 2);
            surface_picture::set(grid, 0, 0, v[0]);
            surface_picture::set(grid, 0, 1, v[1]);
            surface_picture::set(grid, 1, 1, v[2]);
            surface_picture::set(grid, 1, 0, v[3]);
            picture.draw(grid);
        }
        compare(picture, v);
        ASSERT_TRUE(picture.guards_intact()) << described(v);
        if (HasFatalFailure())
            FAIL() << "seed " << seed << ", polygon " << n;
        taken += picture.counts.samples > 0;
        samples += picture.counts.samples;
    }
    EXPECT_GT(taken, 10000);
    EXPECT_GT(samples, 500000);
}

} // namespace
