// SPDX-License-Identifier: MIT
// GL fills surfaces as the CPU does: the same pixels, nearly the same depth and shade.
#include "raster/surfaces/surface_rasterizer_mesa.h"

#include "level_difference.h"
#include "mesa_ways.h"
#include "raster/shapes/rasterizer_2d_mesa.h"
#include "surface_fixture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace {

using namespace l3d_detail;

constexpr unsigned seed = 20260522;
constexpr std::array<float, 3> light{0.48f, 0.60f, 0.64f};

/// Pixels and depth with noise in them and in the gaps between rows.
struct picture {
    picture(int width, int height)
        : size{width, height}, words(std::size_t(width + gap) * std::size_t(height), 0xdeadbeef) {
        depth.resize(size);
        for (int y = 0; y < height; ++y)
            std::ranges::fill(depth.row(y), 1e30f);
    }
    l3d_pixels pixels() { return {words.data(), size.width, size.height, size.width + gap}; }
    std::uint32_t& word(int x, int y) { return pixels().row(y)[static_cast<std::size_t>(x)]; }
    float& inv_w(int x, int y) { return depth.row(y)[static_cast<std::size_t>(x)]; }

    static constexpr int gap = 7;
    l3d_size size;
    std::vector<std::uint32_t> words;
    l3d_depth_buffer depth;
};

/// How two pictures of one size differ.
struct difference {
    long coverage = 0;           ///< pixels with a surface in one of them only
    std::array<long, 256> level; ///< pixels by their largest difference in a channel
    double depth = 0;            ///< largest relative difference of inv_w

    long above(int least) const {
        long count = 0;
        for (std::size_t i = static_cast<std::size_t>(least) + 1; i < level.size(); ++i)
            count += level[i];
        return count;
    }
};

difference compare(picture& a, picture& b) {
    difference result{};
    for (int y = 0; y < a.size.height; ++y)
        for (int x = 0; x < a.size.width; ++x) {
            const float one = a.inv_w(x, y), other = b.inv_w(x, y);
            result.coverage += (one > 0) != (other > 0);
            ++result.level[static_cast<std::size_t>(level_difference(a.word(x, y), b.word(x, y)))];
            if (one > 0 && other > 0)
                result.depth = std::max(result.depth, std::abs(double(one) / other - 1));
        }
    return result;
}

class mesa_surface : public testing::TestWithParam<mesa_way> {
protected:
    void TearDown() override {
        begin(l3d_shade::flat); // makes its context current
        EXPECT_EQ(calls.GetError(), unsigned{GL_NO_ERROR});
    }

    std::unique_ptr<mesa_context> context = open_mesa(GetParam());
    mesa_gl calls = context->make_current();
    l3d_surface_rasterizer_mesa gl{std::move(context)};
    l3d_surface_rasterizer_scalar cpu;
    picture by_gl{71, 47}, by_cpu{71, 47};

    void begin(l3d_shade mode) {
        gl.begin(by_gl.pixels(), &by_gl.depth, {mode, light});
        cpu.begin(by_cpu.pixels(), &by_cpu.depth, {mode, light});
    }
    void draw(const l3d_surface_part& part) {
        draw_part(gl, part);
        draw_part(cpu, part);
    }
    void draw(const reference::corners& v, std::uint32_t error_color = 0) {
        draw(part_of(v, error_color));
    }
    void finish() {
        gl.finish();
        cpu.finish();
    }
};

INSTANTIATE_TEST_SUITE_P(By, mesa_surface, testing::ValuesIn(mesa_ways), test_name_of);

/// A corner in whole pixels and the rest.
l3d_micro_vertex at(int x, int y, float inv_w, std::array<float, 3> normal = {0, 0, 1}) {
    return {x * l3d_subpixel_one, y * l3d_subpixel_one, inv_w, {normal[0], normal[1], normal[2]}};
}

bool in_reach(const reference::corners& v) {
    constexpr int most = (mesa_target::reach - 100) * l3d_subpixel_one;
    return std::ranges::all_of(
        v, [](const auto& c) { return std::abs(c.x) <= most && std::abs(c.y) <= most; });
}

TEST_P(mesa_surface, CoverageOfEveryPolygonIsExact) {
    random_polygons random(seed, by_gl.size);
    int drawn = 0;
    for (int n = 0; n < 2000; ++n) {
        const reference::corners v = random.next();
        if (!in_reach(v))
            continue;
        begin(l3d_shade::error);
        draw(v); // quads are mostly folded
        finish();
        const difference d = compare(by_cpu, by_gl);
        ASSERT_EQ(d.coverage, 0) << "seed " << seed << ", polygon " << n;
        ASSERT_EQ(gl.counts().samples, cpu.counts().samples) << "seed " << seed << ", " << n;
        ASSERT_EQ(gl.counts().covered, cpu.counts().covered) << "seed " << seed << ", " << n;
        drawn += gl.counts().samples > 0;
    }
    EXPECT_GT(drawn, 500);
}

/// Without counting everything is drawn once instead of twice, to the same picture.
TEST_P(mesa_surface, DrawsTheSameWhetherPixelsAreCountedOrNot) {
    random_polygons random(seed, by_gl.size);
    std::vector<reference::corners> scene;
    for (int n = 0; n < 50; ++n)
        if (const reference::corners v = random.next(); in_reach(v))
            scene.push_back(v);
    const auto draw_scene = [&](bool counted) {
        gl.count_pixels(counted);
        begin(l3d_shade::lambert);
        for (const reference::corners& v : scene)
            draw(v);
        finish();
        const l3d_surface_counts cpu_counts = cpu.counts();
        EXPECT_EQ(gl.counts().covered,
                  counted ? cpu_counts.covered : l3d_surface_counts::none_counted);
        EXPECT_EQ(gl.counts().samples, counted ? cpu_counts.samples : 0);
        return by_gl;
    };
    picture quiet = draw_scene(false);
    picture counted = draw_scene(true);
    const difference d = compare(counted, quiet);
    EXPECT_GT(gl.counts().quads, 10);
    EXPECT_EQ(d.coverage, 0);
    EXPECT_EQ(d.depth, 0);
    EXPECT_EQ(d.level[0], by_gl.size.width * by_gl.size.height);
    EXPECT_EQ(compare(counted, by_cpu).coverage, 0);

    // Without a depth that is given there is one of its own.
    gl.count_pixels(true);
    gl.begin(by_gl.pixels(), nullptr, {l3d_shade::lambert, light});
    for (const reference::corners& v : scene)
        draw_part(gl, part_of(v, 0));
    gl.finish();
    EXPECT_EQ(gl.counts().covered, cpu.counts().covered);
}

/// A wavy sheet, seen from its front in one half and from its back in the other.
l3d_micro_grid sheet(l3d_size size) {
    l3d_micro_grid g;
    constexpr int cells = 24;
    g.resize(cells + 1, cells + 1);
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const double u = double(column) / cells, v = double(row) / cells;
            const double x = (0.1 + 0.8 * std::sin(3 * u)) * size.width + 3 * v;
            const double y = (0.05 + 0.8 * v + 0.1 * std::sin(5 * u)) * size.height;
            const std::size_t i = g.index(row, column);
            g.x[i] = static_cast<std::int32_t>(std::lrint(256 * x));
            g.y[i] = static_cast<std::int32_t>(std::lrint(256 * y));
            g.inv_w[i] = static_cast<float>(0.3 + 0.2 * u + 0.05 * v * v);
            g.normal[0][i] = static_cast<float>(1 - 2 * u);
            g.normal[1][i] = static_cast<float>(0.4 * v - 0.7);
            g.normal[2][i] = static_cast<float>(0.6 + 0.3 * u * v);
        }
    return g;
}

TEST_P(mesa_surface, AllShadesAgree) {
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat,
                                 l3d_shade::normals, l3d_shade::error}) {
        begin(mode);
        draw(part_of(sheet(by_gl.size), 0x00c08040));
        finish();
        const difference d = compare(by_cpu, by_gl);
        const auto name = static_cast<int>(mode);
        EXPECT_EQ(d.coverage, 0) << name;
        EXPECT_LT(d.depth, 1e-3) << name;
        // At most 1 % of 3337 pixels differ by more than one level, as quads are no parallelograms.
        EXPECT_LE(d.above(1), 33) << name;
        EXPECT_EQ(d.above(6), 0) << name;
        EXPECT_GT(gl.counts().written, 1000) << name;
        EXPECT_EQ(gl.counts().quads, cpu.counts().quads);
        EXPECT_EQ(gl.counts().samples, cpu.counts().samples);
        EXPECT_EQ(gl.counts().covered, cpu.counts().covered);
        EXPECT_NEAR(double(gl.counts().written), double(cpu.counts().written), 3) << name;
    }
}

TEST_P(mesa_surface, LevelsAreWhatTheRuleSays) {
    constexpr std::array<float, 3> n{0.36f, -0.48f, 0.80f};
    const float cosine = light[0] * n[0] + light[1] * n[1] + light[2] * n[2];
    const auto front = static_cast<std::uint32_t>(std::lround(255 * (0.1 + 0.9 * cosine)));
    const reference::corners left{at(5, 4, 1, n), at(9, 30, 1, n), at(40, 8, 1, n)};
    reference::corners back = left;
    for (l3d_micro_vertex& corner : back)
        for (float& component : corner.normal)
            component *= -1;
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat}) {
        begin(mode);
        draw(left);
        finish();
        EXPECT_EQ(by_gl.word(10, 12), front * 0x010101u);
        begin(mode);
        draw(back); // its normals are turned to the eye
        finish();
        EXPECT_EQ(by_gl.word(10, 12), front * 0x010101u);
    }
    begin(l3d_shade::normals);
    draw(left);
    finish();
    EXPECT_EQ(by_gl.word(10, 12), 0x00ad42e6u); // round(255 (n + 1) / 2)
    begin(l3d_shade::error);
    draw(left, 0x00fe8101);
    draw({at(50, 4, 1), at(50, 30, 1), at(60, 8, 1)}, 0x000181fe);
    finish();
    EXPECT_EQ(by_gl.word(10, 12), 0x00fe8101u);
    EXPECT_EQ(by_gl.word(52, 12), 0x000181feu);
}

TEST_P(mesa_surface, ZeroNormalsAreAmbient) {
    begin(l3d_shade::lambert);
    draw({at(5, 4, 1, {0, 0, 0}), at(9, 30, 1, {0, 0, 0}), at(40, 8, 1, {0, 0, 0})});
    finish();
    EXPECT_EQ(by_gl.word(10, 12), 26u * 0x010101u);
    begin(l3d_shade::normals);
    draw({at(5, 4, 2, {0, 0, 0}), at(9, 30, 2, {0, 0, 0}), at(40, 8, 2, {0, 0, 0})});
    gl.finish();
    EXPECT_EQ(by_gl.word(10, 12), 0x00808080u);
}

TEST_P(mesa_surface, NearerWinsAndTheFirstOfEquals) {
    const auto draw_at = [this](float inv_w, std::uint32_t color) {
        draw({at(5, 4, inv_w), at(9, 30, inv_w), at(40, 8, inv_w)}, color);
    };
    begin(l3d_shade::error);
    draw_at(0.5f, 0x00111111);
    draw_at(0.5f, 0x00222222);
    finish();
    EXPECT_EQ(by_gl.word(10, 12), 0x00111111u);
    begin(l3d_shade::error);
    draw_at(0.5f, 0x00111111);
    draw_at(0.5f, 0x00222222);
    draw_at(std::nextafter(0.5f, 1.0f), 0x00333333);
    draw_at(0.25f, 0x00444444);
    finish();
    EXPECT_EQ(by_gl.word(10, 12), 0x00333333u);
    EXPECT_EQ(by_gl.inv_w(10, 12), std::nextafter(0.5f, 1.0f));
    EXPECT_EQ(gl.counts().written * 2, gl.counts().samples); // two of four
}

TEST_P(mesa_surface, DepthIsExactAtAnyDistance) {
    for (const float inv_w :
         {std::ldexp(1.2345678f, -80), 0.1f, 1.0f, std::ldexp(1.7654321f, 30)}) {
        begin(l3d_shade::error);
        draw({at(5, 4, inv_w), at(9, 30, inv_w), at(40, 8, inv_w)});
        gl.finish();
        EXPECT_EQ(by_gl.inv_w(10, 12), inv_w);
    }
}

TEST_P(mesa_surface, WhatWasThereBeforeIsGone) {
    begin(l3d_shade::error);
    draw({at(5, 4, 0.5f), at(9, 30, 0.5f), at(40, 8, 0.5f)}, 0x00010203);
    finish();
    EXPECT_EQ(by_gl.word(10, 12), 0x00010203u);
    EXPECT_EQ(by_gl.word(60, 40), 0u);
    EXPECT_EQ(by_gl.inv_w(60, 40), 0.0f);

    begin(l3d_shade::error);
    draw({at(5, 4, 0.25f), at(9, 30, 0.25f), at(40, 8, 0.25f)}, 0x00040506); // forgotten
    begin(l3d_shade::error);
    finish();
    for (int y = 0; y < by_gl.size.height; ++y)
        for (int x = 0; x < by_gl.size.width; ++x) {
            ASSERT_EQ(by_gl.word(x, y), 0u);
            ASSERT_EQ(by_gl.inv_w(x, y), 0.0f);
        }
    EXPECT_EQ(gl.counts().covered, 0);
}

TEST_P(mesa_surface, NeedsNoDepthBuffer) {
    begin(l3d_shade::lambert);
    draw(part_of(sheet(by_gl.size)));
    finish();
    picture without(by_gl.size.width, by_gl.size.height);
    gl.begin(without.pixels(), nullptr, {l3d_shade::lambert, light});
    draw_part(gl, part_of(sheet(by_gl.size)));
    gl.finish();
    EXPECT_EQ(without.words, by_gl.words);
    EXPECT_EQ(gl.counts().covered, cpu.counts().covered);
    EXPECT_EQ(without.inv_w(30, 20), 1e30f);
}

TEST_P(mesa_surface, HidesNothing) {
    begin(l3d_shade::error);
    draw({at(0, 0, 4), at(71, 0, 4), at(71, 47, 4), at(0, 47, 4)}, 0x00010203);
    EXPECT_FALSE(gl.hidden({0, 0, 71 * 256, 47 * 256}, 1));
}

TEST_P(mesa_surface, SharesAPictureWithLines) {
    l3d_rasterizer_2d_mesa_imp imp(open_mesa(GetParam()), by_gl.pixels());
    l3d_rasterizer_2d lines(imp);
    begin(l3d_shade::error);
    draw({at(5, 4, 1), at(9, 30, 1), at(40, 8, 1)}, 0x0000ff00);
    finish();
    lines.draw_line(12, 2, 12, 40, 0x000000ff);
    lines.draw_line(50, 12, 60, 12, 0x00ff0000);
    lines.finish();
    EXPECT_EQ(by_gl.word(10, 12), 0x0000ff00u);
    EXPECT_EQ(by_gl.word(12, 12), 0x000000ffu);
    EXPECT_EQ(by_gl.word(60, 12), 0x00ff0000u);
}

TEST_P(mesa_surface, PicturesThatGlCannotHoldAreFilledAllTheSame) {
    by_gl = picture(16500, 4);
    by_cpu = picture(16500, 4);
    begin(l3d_shade::lambert);
    draw(part_of(sheet(by_gl.size)));
    draw({at(16300, 0, 1), at(16310, 4, 1), at(16499, 2, 1)});
    finish();
    EXPECT_EQ(by_gl.words, by_cpu.words);
    EXPECT_EQ(gl.counts().written, cpu.counts().written);
    EXPECT_GT(gl.counts().written, 100);
    begin(l3d_shade::error);
    draw({at(16300, 0, 2), at(16310, 4, 2), at(16499, 2, 2)}, 0x00123456);
    finish();
    EXPECT_EQ(by_gl.word(16400, 2), 0x00123456u);
}

TEST(MesaSurfaces, OfEglAndOsmesaAreTheSame) {
    picture first(233, 149);
    for (const mesa_way way : mesa_ways) {
        picture other(233, 149);
        l3d_surface_rasterizer_mesa gl(open_mesa(way));
        gl.begin(other.pixels(), &other.depth, {l3d_shade::lambert, light});
        draw_part(gl, part_of(sheet(other.size)));
        gl.finish();
        EXPECT_GT(gl.counts().written, 10000);
        if (way == mesa_ways[0]) {
            first = other;
            continue;
        }
        const difference d = compare(first, other);
        EXPECT_EQ(d.coverage, 0);
        EXPECT_EQ(d.above(1), 0) << name_of(way);
        EXPECT_LE(10000 * d.above(0), 233 * 149) << name_of(way); // 0.01 %
    }
}

} // namespace
