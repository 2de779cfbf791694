// SPDX-License-Identifier: MIT
// The fill kernel against edge functions and planes evaluated pixel by pixel, against itself in
// bands, and every instruction set against the others.
#include "raster/surfaces/fill_kernel_p.h"
#include "raster/parallel/simd_target.h"
#include "effort.h"
#include "reference_light.h"
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

constexpr std::array lane_modes{l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat};

l3d_shading tilted(l3d_shade mode) {
    return {mode, {0.36f, 0.48f, 0.8f}, {-0.3f, 0.2f, -1}, {0.01f, 0, 0}, {0, -0.02f, 0.003f}};
}

/// Picture and depth with guards around every row, filled band by band.
struct filled {
    static constexpr std::uint32_t guard = 0xdeadbeef;
    static constexpr float depth_guard = -1; ///< anything is nearer, even what covers nothing
    static constexpr int word_gap = 3, depth_gap = 5;

    filled(int width, int height, l3d_shade mode) : size{width, height}, shading(tilted(mode)) {
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
        for (int top = 0; top < size.height; top += rows) {
            const fill_band band{&word(0, top),
                                 size.width + word_gap,
                                 &inv_w(0, top),
                                 size.width + depth_gap,
                                 size.width,
                                 top,
                                 std::min(top + rows, size.height)};
            const fill_target target{band, shading, queue, counts, rest, leaves_out_hidden, {}};
            fill(target);
            fill_finish(target);
        }
    }

    /// Lives: until the next one.
    fill_grid lit(const l3d_micro_grid& grid) {
        levels.resize(grid.x.size());
        light_vertices(shading, grid, levels.data());
        return {grid, levels.data(), 0};
    }

    void draw(const l3d_micro_grid& grid, int rows = 1 << 20) {
        const fill_grid of = lit(grid);
        in_bands(std::min(rows, size.height), [&](const fill_target& target) {
            fill_quads(target, of, 0, grid.rows - 1, 0, grid.columns - 1);
        });
    }

    void draw(const l3d_micro_triangles& triangles, int rows = 1 << 20) {
        in_bands(std::min(rows, size.height), [&](const fill_target& target) {
            fill_triangles(target, triangles, 0, 0, triangles.count);
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
    l3d_shading shading;
    std::vector<float> levels;
    fill_queue queue;
    fill_counts counts;
    fill_rest rest;
    bool leaves_out_hidden = false;
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

/// The reference's number, clamped to the corners'.
double depth_of(const reference::corners& v, int x, int y) {
    std::vector<float> at_corners;
    for (const l3d_micro_vertex& c : v)
        at_corners.push_back(c.inv_w);
    const auto [least, most] = std::minmax_element(at_corners.begin(), at_corners.end());
    return std::clamp(static_cast<double>(reference::at_centre(v, at_corners, x, y)),
                      double(*least), double(*most));
}

std::int64_t count_of(const reference::corners& v, l3d_size size) {
    std::int64_t samples = 0;
    for (const reference::corners& piece : reference::pieces(v))
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x)
                samples += reference::covers(piece, x, y);
    return samples;
}

/// A pixel of one polygon alone in a picture: it is that of the nearest piece that covers it.
void compare(filled& picture, const std::vector<reference::corners>& pieces, float range, int x,
             int y) {
    // Runs that would not fit begin left of the polygon, where numbers are farther from the
    // corners'.
    const bool fits = x < picture.size.width - fill_least_width;
    double nearest = 0;
    for (const reference::corners& piece : pieces)
        if (reference::covers(piece, x, y))
            nearest = std::max(nearest, depth_of(piece, x, y));
    const auto inv_w = double(picture.inv_w(x, y));
    const double allowed = (fits ? 1e-5 : 1e-4) * double(range) + 4e-7 * nearest;
    ASSERT_NEAR(inv_w, nearest, allowed);
    const std::uint32_t word = picture.word(x, y);
    ASSERT_EQ(word, (word & 0xff) * 0x010101);
    bool right = nearest == 0 && word == 0;
    std::string expected;
    for (const reference::corners& piece : pieces)
        if (reference::covers(piece, x, y) && depth_of(piece, x, y) >= nearest - 2 * allowed) {
            const double grey = reference::grey_of(piece, picture.shading, x, y);
            right = right || grey < 0 || std::abs((word & 0xff) - grey) <= 1.5;
            expected += std::to_string(grey) + " ";
        }
    ASSERT_TRUE(right) << "grey " << (word & 0xff) << ", not " << expected;
}

void compare(filled& picture, const reference::corners& v) {
    if (!picture.rest.quads.empty() || !picture.rest.triangles.empty()) {
        EXPECT_EQ(picture.counts.samples, 0);
        return;
    }
    float least = v[0].inv_w, most = v[0].inv_w;
    for (const l3d_micro_vertex& c : v) {
        least = std::min(least, c.inv_w);
        most = std::max(most, c.inv_w);
    }
    const std::vector<reference::corners> pieces = reference::pieces(v);
    for (int y = 0; y < picture.size.height; ++y)
        for (int x = 0; x < picture.size.width; ++x) {
            compare(picture, pieces, most - least, x, y);
            if (testing::Test::HasFatalFailure())
                FAIL() << described(v) << "at " << x << ", " << y;
            ASSERT_LE(picture.inv_w(x, y), most);
            ASSERT_TRUE(picture.inv_w(x, y) == 0 || picture.inv_w(x, y) >= least);
        }
    ASSERT_EQ(picture.counts.samples, count_of(v, picture.size)) << described(v);
}

class FillKernelMode : public testing::TestWithParam<l3d_shade> {};

INSTANTIATE_TEST_SUITE_P(Shades, FillKernelMode, testing::ValuesIn(lane_modes));

TEST_P(FillKernelMode, DrawsRandomPolygonsLikeTheTwin) {
    RecordProperty("seed", static_cast<int>(seed));
    const l3d_size size{61, 31};
    unit_polygons polygons(size);
    std::int64_t taken = 0, samples = 0;
    const int count = thorough ? 30000 : 10000;
    for (int n = 0; n < count; ++n) {
        const reference::corners v = polygons.next();
        filled picture(size.width, size.height, GetParam());
        const l3d_surface_part part = part_of(v);
        if (v.size() == 3)
            picture.draw(part.triangles);
        else
            picture.draw(part.grid);
        compare(picture, v);
        ASSERT_TRUE(picture.guards_intact()) << described(v);
        if (HasFatalFailure())
            FAIL() << "seed " << seed << ", polygon " << n;
        taken += picture.counts.samples > 0;
        samples += picture.counts.samples;
    }
    EXPECT_GT(taken, count / 12);
    EXPECT_GT(samples, count * 5 / 2);
}

/// A run that does not fit the picture begins left of the polygon, there a thin one's numbers are
/// far from the corners': that must not be seen, of its pieces neither.
TEST_P(FillKernelMode, DrawsThinFoldedQuadsAtTheEdgeLikeTheTwin) {
    const l3d_size size{61, 31};
    unit_polygons polygons(size);
    std::int64_t taken = 0, left_over = 0;
    for (int n = 0; n < 4000; ++n) {
        random_polygons& random = polygons.random();
        reference::corners v(4);
        const int centre = 256 * random.number(30, size.width - 1) + 128,
                  y = random.number(0, 6000);
        for (l3d_micro_vertex& corner : v) {
            corner = {centre + random.number(-3, 3),
                      y + random.number(0, 1500),
                      random.real(0.5f, 1),
                      {0.3f, random.real(-0.2f, 0.2f), 0.9f}};
            normalize(corner);
        }
        filled picture(size.width, size.height, GetParam());
        picture.draw(part_of(v).grid);
        compare(picture, v);
        if (HasFatalFailure())
            FAIL() << "polygon " << n;
        (picture.rest.quads.empty() ? taken : left_over) += 1;
    }
    EXPECT_GT(taken, 1000);
    EXPECT_GT(left_over, 500);
}

/// Grids from smooth to folded, of any shape, some corners on pixel centres; and loose triangles.
struct random_scene {
    explicit random_scene(unsigned number) : random(seed + number, {97, 71}) {
        const int cell = random.number(100, 6000), jitter = random.number(0, cell);
        const int snap = random.number(0, 1) == 0 ? 1 : 128;
        const float spread = random.real(0, 0.5f);
        grid.resize(random.number(2, 40), random.number(2, 12));
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                l3d_micro_vertex v = vertex(spread);
                v.x = (column * cell - 1000 + random.number(-jitter, jitter)) / snap * snap;
                v.y = (row * cell - 700 + column * cell / 9 + random.number(-jitter, jitter)) /
                      snap * snap;
                surface_picture::set(grid, row, column, v);
            }
        for (int n = random.number(0, 90); n > 0; --n) {
            std::array<l3d_micro_vertex, 3> v{vertex(spread), vertex(spread), vertex(spread)};
            const reference::corners places = random.next();
            for (std::size_t i = 0; i < 3; ++i) {
                v[i].x = places[i].x;
                v[i].y = places[i].y;
            }
            triangles.add(v[0], v[1], v[2]);
        }
    }

    l3d_micro_vertex vertex(float spread) {
        l3d_micro_vertex v;
        v.inv_w = random.real(0.1f, 1.0f);
        v.normal[0] = 0.5f + spread * random.real(-1, 1);
        v.normal[1] = 0.3f + spread * random.real(-1, 1);
        v.normal[2] = 0.2f + spread * random.real(-1, 1);
        normalize(v);
        return v;
    }

    filled drawn(int band_rows, l3d_shade mode) const {
        filled picture(97, 71, mode);
        picture.draw(grid, band_rows);
        picture.draw(triangles, band_rows);
        return picture;
    }

    random_polygons random;
    l3d_micro_grid grid;
    l3d_micro_triangles triangles;
};

TEST_P(FillKernelMode, CoversGridsLikeTheTwin) {
    std::int64_t taken = 0;
    for (unsigned n = 0; n < 40; ++n) {
        const random_scene scene(n);
        const filled picture = scene.drawn(1 << 20, GetParam());
        ASSERT_TRUE(picture.guards_intact()) << "scene " << n;
        std::int64_t samples = 0;
        std::vector<std::size_t> rest;
        for (const fill_rest::quad& quad : picture.rest.quads) {
            ASSERT_EQ(quad.grid, &scene.grid);
            rest.push_back(quad.index);
        }
        std::sort(rest.begin(), rest.end());
        const l3d_micro_grid& g = scene.grid;
        for (int row = 0; row + 1 < g.rows; ++row)
            for (int column = 0; column + 1 < g.columns; ++column) {
                if (std::binary_search(rest.begin(), rest.end(), g.index(row, column)))
                    continue;
                const reference::corners v{g.vertex(row, column), g.vertex(row, column + 1),
                                           g.vertex(row + 1, column + 1),
                                           g.vertex(row + 1, column)};
                samples += count_of(v, picture.size);
                ++taken;
            }
        rest.clear();
        for (const fill_rest::triangle& triangle : picture.rest.triangles) {
            ASSERT_EQ(triangle.triangles, &scene.triangles);
            rest.push_back(triangle.index);
        }
        std::sort(rest.begin(), rest.end());
        for (std::size_t i = 0; i < scene.triangles.count; ++i)
            if (!std::binary_search(rest.begin(), rest.end(), i))
                samples += count_of({scene.triangles.vertex(i, 0), scene.triangles.vertex(i, 1),
                                     scene.triangles.vertex(i, 2)},
                                    picture.size);
        ASSERT_EQ(picture.counts.samples, samples) << "scene " << n;
    }
    EXPECT_GT(taken, 2000);
}

TEST_P(FillKernelMode, DrawsTheSameBitsInAnyBands) {
    for (unsigned n = 0; n < 200; ++n) {
        const random_scene scene(1000 + n);
        const filled whole = scene.drawn(1 << 20, GetParam());
        for (const int rows : {1, 7, 64}) {
            const filled banded = scene.drawn(rows, GetParam());
            ASSERT_TRUE(banded.same_bits(whole)) << "scene " << n << " in bands of " << rows;
            ASSERT_EQ(banded.counts.samples, whole.counts.samples);
            ASSERT_EQ(banded.counts.written, whole.counts.written);
        }
    }
}

TEST_P(FillKernelMode, DrawsTheSameBitsWithAnyInstructions) {
    const std::vector<std::string> targets = l3d_simd_targets();
    EXPECT_GE(targets.size(), 1u);
    for (unsigned n = 0; n < 200; ++n) {
        const random_scene scene(2000 + n);
        const filled best = scene.drawn(33, GetParam());
        for (const std::string& target : targets) {
            ASSERT_TRUE(l3d_set_simd_target(target));
            const filled other = scene.drawn(33, GetParam());
            ASSERT_TRUE(l3d_set_simd_target(""));
            ASSERT_TRUE(other.same_bits(best)) << "scene " << n << " with " << target;
            ASSERT_TRUE(other.guards_intact()) << "scene " << n << " with " << target;
            ASSERT_EQ(other.counts.samples, best.counts.samples);
            ASSERT_EQ(other.counts.written, best.counts.written);
            ASSERT_EQ(other.rest.quads.size(), best.rest.quads.size());
            ASSERT_EQ(other.rest.triangles.size(), best.rest.triangles.size());
        }
    }
}

TEST_P(FillKernelMode, FillsPartsOfAGrid) {
    const random_scene scene(3001);
    const l3d_micro_grid& g = scene.grid;
    const filled whole = [&] {
        filled picture(97, 71, GetParam());
        picture.draw(g);
        return picture;
    }();
    filled parts(97, 71, GetParam());
    const fill_grid lit = parts.lit(g);
    parts.in_bands(71, [&](const fill_target& target) {
        for (int row = 0; row + 1 < g.rows; row += 3)
            for (int column = 0; column + 1 < g.columns; column += 5)
                fill_quads(target, lit, row, std::min(row + 3, g.rows - 1), column,
                           std::min(column + 5, g.columns - 1));
        fill_quads(target, lit, 1, 1, 0, 1);
        fill_quads(target, lit, 0, 1, 1, 1);
    });
    EXPECT_EQ(parts.counts.samples, whole.counts.samples);
    EXPECT_EQ(parts.depths, whole.depths);
    EXPECT_EQ(parts.rest.quads.size(), whole.rest.quads.size());
}

} // namespace
