// SPDX-License-Identifier: MIT
// GL draws the same points, lines and polygons as the CPU, word for word, by every way to GL.
#include "raster/shapes/rasterizer_2d_mesa.h"

#include "level_difference.h"
#include "raster/paths/gradient.h"
#include "raster/placement_2d.h"
#include "raster/paths/path.h"
#include "mesa_ways.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include <malloc.h>

namespace {

using namespace l3d_detail;

constexpr unsigned seed = 20260521;

/// A picture with words behind every row that are not its own.
class picture {
public:
    picture(int width, int height, std::mt19937 random)
        : size_{width, height}, words_(std::size_t(width + gap) * std::size_t(height)) {
        for (std::uint32_t& word : words_)
            word = static_cast<std::uint32_t>(random());
    }
    l3d_pixels pixels() { return {words_.data(), size_.width, size_.height, size_.width + gap}; }
    std::uint32_t& at(int x, int y) { return pixels().row(y)[static_cast<std::size_t>(x)]; }
    const std::vector<std::uint32_t>& words() const { return words_; }

private:
    static constexpr int gap = 5;
    l3d_size size_;
    std::vector<std::uint32_t> words_;
};

class mesa_2d : public testing::TestWithParam<mesa_way> {
protected:
    std::unique_ptr<mesa_context> context() { return open_mesa(GetParam()); }
};

INSTANTIATE_TEST_SUITE_P(By, mesa_2d, testing::ValuesIn(mesa_ways), test_name_of);

/// The same picture twice: one for the CPU, one for GL.
struct twins {
    twins(std::unique_ptr<mesa_context> context, int width, int height)
        : by_cpu(width, height, std::mt19937(seed)), by_gl(width, height, std::mt19937(seed)),
          calls(context->make_current()), cpu_imp(by_cpu.pixels()),
          gl_imp(std::move(context), by_gl.pixels()), cpu(cpu_imp), gl(gl_imp) {}

    twins(const twins&) = delete;
    twins& operator=(const twins&) = delete;
    ~twins() {
        gl_imp.set_target(by_gl.pixels()); // makes its context current
        EXPECT_EQ(calls.GetError(), unsigned{GL_NO_ERROR});
    }

    template <class Draw> void draw(const Draw& what) {
        what(cpu);
        what(gl);
    }

    /// How many words differ, those between the rows included.
    std::ptrdiff_t different() {
        gl.finish();
        std::ptrdiff_t count = 0;
        for (std::size_t i = 0; i < by_cpu.words().size(); ++i)
            count += by_cpu.words()[i] != by_gl.words()[i];
        return count;
    }

    /// The most by which a red, green or blue differs; the highest bytes must not.
    int worst_channel() {
        gl.finish();
        int worst = 0;
        for (std::size_t i = 0; i < by_cpu.words().size(); ++i) {
            const std::uint32_t a = by_cpu.words()[i], b = by_gl.words()[i];
            EXPECT_EQ(a >> 24, b >> 24);
            worst = std::max(worst, level_difference(a, b));
        }
        return worst;
    }

    picture by_cpu, by_gl;
    mesa_gl calls;
    l3d_rasterizer_2d_sw_imp cpu_imp;
    l3d_rasterizer_2d_mesa_imp gl_imp;
    l3d_rasterizer_2d cpu, gl;
};

TEST_P(mesa_2d, PutsAPointWhereItBelongsInItsColor) {
    picture p(13, 7, std::mt19937(seed));
    l3d_rasterizer_2d_mesa_imp imp(context(), p.pixels());
    l3d_rasterizer_2d draw(imp);
    draw.clear_buffer();
    draw.draw_point(9, 2, 0x81ff4020);
    draw.finish();
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 13; ++x)
            EXPECT_EQ(p.at(x, y), x == 9 && y == 2 ? 0x81ff4020u : 0u) << x << " " << y;
}

TEST_P(mesa_2d, PointsAndLinesAreTheSamePixels) {
    twins t(context(), 61, 43);
    std::mt19937 random(seed + 1);
    constexpr int least = std::numeric_limits<int>::min(), most = std::numeric_limits<int>::max();
    std::uniform_int_distribution<int> near(-40, 90), any(least, most);
    for (int n = 0; n < 4000; ++n) {
        auto& at = n % 8 == 0 ? any : near;
        const int x0 = at(random), y0 = at(random), x1 = at(random), y1 = at(random);
        const auto color = static_cast<std::uint32_t>(random());
        t.draw([&](l3d_rasterizer_2d& r) {
            if (n % 5 == 0)
                r.draw_point(x0, y0, color);
            else
                r.draw_line(x0, y0, x1, y1, color);
        });
        if (n % 400 == 0) {
            ASSERT_EQ(t.different(), 0) << "seed " << seed + 1 << ", line " << n;
        }
    }
    EXPECT_EQ(t.different(), 0) << "seed " << seed + 1;
}

TEST_P(mesa_2d, CoverageIsMixedToWithinALevel) {
    twins t(context(), 61, 43);
    std::mt19937 random(seed + 9);
    std::uniform_int_distribution<int> near(-40, 90);
    const std::array<l3d_point_2d, 4> all{{{-1, -1}, {70, -1}, {70, 50}, {-1, 50}}};
    for (int n = 0; n < 300; ++n) {
        const int width = near(random) + 41, height = near(random) + 41;
        std::vector<std::uint8_t> values(static_cast<std::size_t>(width * height));
        for (std::uint8_t& value : values)
            value = static_cast<std::uint8_t>(random() % 2 == 0 ? 200 : random());
        const l3d_coverage_2d shape{near(random), near(random),  width,
                                    height,       values.data(), n % 2 == 0 ? 0 : width};
        const auto color = static_cast<std::uint32_t>(random() & 0x00ffffff);
        const auto ground = static_cast<std::uint32_t>(random() & 0x00ffffff);
        t.draw([&](l3d_rasterizer_2d& r) {
            r.draw_polygon_flatshaded(all, ground);
            r.draw_coverage(shape, color);
        });
        ASSERT_LE(t.worst_channel(), 1) << "seed " << seed + 9 << ", shape " << n;
    }
}

TEST_P(mesa_2d, PathsCurvesAndMeshesAreTheSamePixels) {
    twins t(context(), 61, 43);
    const std::array<l3d_point_2d, 4> all{{{-1, -1}, {70, -1}, {70, 50}, {-1, 50}}};
    l3d_path path;
    path.add_circle({30, 20}, 17);
    path.move_to({3, 3});
    path.cubic_to({80, 10}, {-30, 30}, {60, 37});
    const l3d_mesh_patch patch =
        l3d_mesh_patch::coons({{{2, 3},
                                {9, 9},
                                {12, 1},
                                {20, 2},
                                {18, 8},
                                {22, 12},
                                {21, 20},
                                {15, 22},
                                {9, 17},
                                {3, 19},
                                {0, 12},
                                {5, 8}}},
                              {0x00ff1020, 0x0010ff30, 0x002030ff, 0x00f0f010});
    std::array<std::uint32_t, 4> words{0x00ff0000, 0x0000ff00, 0x000000ff, 0x00808080};
    const l3d_placed_image image{{words.data(), 2, 2, 2}, {{10, 5}, {20, 8}, {-7, 19}}};
    t.draw([&](l3d_rasterizer_2d& r) {
        r.draw_polygon_flatshaded(all, 0x00304050);
        r.draw_path(path, {.color = 0x00ffd080, .alpha = 0.7});
        r.draw_path(path, {.alpha = 0.2, .blending = l3d_blending::linear});
        r.draw_image(image, {.alpha = 0.9, .clip = &path});
        r.draw_point(30, 20, 0x00ffffff);
        r.draw_mesh({&patch, 1});
        r.draw_curves(path, 0x0000ff00);
        r.draw_line(0, 39, 50, 0, 0x00ff00ff);
    });
    EXPECT_EQ(t.different(), 0);
}

/// Corners around an ellipse, convex but for rounding; every third time on whole and half pixels.
std::vector<l3d_point_2d> random_convex(std::mt19937& random, double reach) {
    const auto real = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a, b)(random);
    };
    const bool lattice = random() % 3 == 0;
    const double step = lattice ? 2 : 256;
    const double x = real(-20, 80), y = real(-20, 60), rx = real(1, reach), ry = real(1, reach);
    std::vector<l3d_point_2d> v(3 + random() % (lattice ? 2 : 7));
    const double start = real(0, 6.3);
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double angle = start + 6.283185307179586 * double(i) / double(v.size());
        v[i] = {std::round((x + rx * std::cos(angle)) * step) / step,
                std::round((y + ry * std::sin(angle)) * step) / step};
    }
    if (random() % 2)
        std::ranges::reverse(v);
    return v;
}

TEST_P(mesa_2d, PolygonsAreTheSamePixels) {
    twins t(context(), 67, 39);
    std::mt19937 random(seed + 2);
    // in reach of GL, and beyond it
    for (const double reach : {5.0, 50.0, 3000.0, 8000.0, 30000.0}) {
        for (int n = 0; n < 1500; ++n) {
            const auto v = random_convex(random, reach);
            const auto color = static_cast<std::uint32_t>(random());
            t.draw([&](l3d_rasterizer_2d& r) { r.draw_polygon_flatshaded(v, color); });
            if (n % 100 == 0) {
                ASSERT_EQ(t.different(), 0)
                    << "seed " << seed + 2 << ", reach " << reach << ", " << n;
            }
        }
        ASSERT_EQ(t.different(), 0) << "seed " << seed + 2 << ", reach " << reach;
    }
}

TEST_P(mesa_2d, OutlinesAreTheSamePixels) {
    twins t(context(), 67, 39);
    std::mt19937 random(seed + 5);
    std::uniform_real_distribution<double> at(-30, 100), far(-1e6, 1e6);
    for (int n = 0; n < 300; ++n) {
        std::vector<l3d_point_2d> one(3 + random() % 9), other(3 + random() % 4);
        for (l3d_point_2d& p : one)
            p = {at(random), at(random)};
        for (l3d_point_2d& p : other)
            p = n % 3 ? l3d_point_2d{at(random), at(random)}
                      : l3d_point_2d{far(random), at(random)};
        const std::array<l3d_outline_2d, 2> outlines{one, other};
        const auto inside = n % 2 ? l3d_winding::nonzero : l3d_winding::even_odd;
        const auto color = static_cast<std::uint32_t>(random());
        t.draw([&](l3d_rasterizer_2d& r) { r.draw_outlines(outlines, inside, color); });
    }
    EXPECT_EQ(t.different(), 0) << "seed " << seed + 5;
}

TEST_P(mesa_2d, ShadedPolygonsAndSmoothLinesDifferByOneAtMost) {
    std::mt19937 random(seed + 6);
    twins t(context(), 67, 39);
    std::uniform_real_distribution<double> at(-30, 90);
    int worst = 0;
    for (int n = 0; n < 300; ++n) {
        const l3d_point_2d a{at(random), at(random)}, b{at(random), at(random)};
        const auto color = static_cast<std::uint32_t>(random());
        std::vector<l3d_colored_point_2d> corners;
        for (const l3d_point_2d& p : random_convex(random, n % 10 ? 50.0 : 9000.0))
            corners.push_back({p.x, p.y, static_cast<std::uint32_t>(random())});
        t.draw([&](l3d_rasterizer_2d& r) {
            r.clear_buffer();
            if (n % 2)
                r.draw_polygon_gouraudshaded(corners);
            else
                r.draw_line_antialiased(a, b, color);
            r.draw_point(3, 4, color); // and back to colours that are not blended
        });
        worst = std::max(worst, t.worst_channel());
    }
    EXPECT_LE(worst, 1) << "seed " << seed + 6;
}

TEST_P(mesa_2d, WhatDrawsNothingDrawsNothing) {
    twins t(context(), 29, 17);
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    using corners = std::vector<l3d_point_2d>;
    const std::vector<corners> polygons{
        {}, {{4, 5}}, {{4, 5}, {20, 9}}, {{4, 5}, {20, 9}, {4, 5}}, {{nan, 3}, {20, 4}, {9, 15}}};
    const picture before = t.by_gl;
    for (const corners& v : polygons)
        t.gl.draw_polygon_flatshaded(v, 0x00ffffff);
    t.gl.draw_point(29, 3, 0x00ffffff);
    t.gl.draw_line(3, -1, 20, -1, 0x00ffffff);
    t.gl.draw_lines({}, 0x00ffffff);
    t.gl.finish();
    EXPECT_EQ(t.by_gl.words(), before.words());
}

TEST_P(mesa_2d, ThePixelsInMemoryAreTheTruth) {
    twins t(context(), 31, 23);
    const auto outside = [](picture& p, std::uint32_t word) {
        for (int y = 3; y < 9; ++y)
            for (int x = 2; x < 17; ++x)
                p.at(x, y) = word;
    };
    const auto line = [&t](std::uint32_t color) {
        t.draw([color](l3d_rasterizer_2d& r) { r.draw_line(1, 2, 27, 20, color); });
    };
    line(0x00112233);
    EXPECT_EQ(t.different(), 0);
    outside(t.by_cpu, 0x00445566); // after finish
    outside(t.by_gl, 0x00445566);
    line(0x00778899);
    EXPECT_EQ(t.different(), 0);
    t.draw([](l3d_rasterizer_2d& r) { r.clear_buffer(); });
    EXPECT_EQ(t.different(), 0);
    outside(t.by_cpu, 0x00aabbcc); // after clear_buffer and finish
    outside(t.by_gl, 0x00aabbcc);
    line(0x00ddeeff);
    EXPECT_EQ(t.different(), 0);
    t.draw([](l3d_rasterizer_2d& r) {
        r.draw_line(25, 1, 4, 19, 0x00010203);
        r.clear_buffer(); // takes it back, though it is not finished
    });
    line(0x00fedcba);
    EXPECT_EQ(t.different(), 0);
}

TEST_P(mesa_2d, DrawsIntoTheTargetOfTheLastResize) {
    twins t(context(), 31, 23);
    picture cpu_second(45, 12, std::mt19937(seed + 3)), gl_second = cpu_second;
    const picture before = t.by_gl;
    t.gl.draw_line(0, 0, 30, 20, 0x00ffffff); // not finished, so lost
    t.cpu_imp.set_target(cpu_second.pixels());
    t.gl_imp.set_target(gl_second.pixels());
    t.draw([](l3d_rasterizer_2d& r) { r.draw_line(44, 0, -3, 14, 0x00345678); });
    t.gl.finish();
    EXPECT_EQ(gl_second.words(), cpu_second.words());
    EXPECT_EQ(t.by_gl.words(), before.words());
}

TEST_P(mesa_2d, PicturesThatGlCannotHoldAreDrawnAllTheSame) {
    twins t(context(), 31, 23);
    picture cpu_large(16500, 3, std::mt19937(seed)), gl_large = cpu_large;
    t.cpu_imp.set_target(cpu_large.pixels());
    t.gl_imp.set_target(gl_large.pixels());
    const std::vector<l3d_point_2d> corners{{16300, 0}, {16499, 0.5}, {16420, 3}};
    const std::vector<l3d_colored_point_2d> colored{
        {16310, 0, 0x00ff0000}, {16499, 0.5, 0x0000ff00}, {16420, 3, 0x000000ff}};
    t.draw([&](l3d_rasterizer_2d& r) {
        r.clear_buffer();
        r.draw_point(16450, 1, 0x00fedcba);
        r.draw_line(3, 2, 16490, 0, 0x00123456);
        r.draw_polygon_flatshaded(corners, 0x00987654);
        r.draw_polygon_complex(corners, l3d_winding::nonzero, 0x00765432);
        r.draw_polygon_gouraudshaded(colored);
        r.draw_line_antialiased({16000, 0.5}, {16480, 2}, 0x00543210);
    });
    t.gl.finish();
    EXPECT_EQ(gl_large.words(), cpu_large.words());
}

TEST_P(mesa_2d, LargestPicturesAreExactUpToTheirEdges) {
    twins t(context(), 16384, 5);
    std::mt19937 random(seed + 4);
    std::uniform_real_distribution<double> x(-300, 16700), y(-4, 9);
    for (int n = 0; n < 300; ++n) {
        std::vector<l3d_point_2d> v{
            {x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}};
        const auto color = static_cast<std::uint32_t>(random());
        t.draw([&](l3d_rasterizer_2d& r) { r.draw_polygon_flatshaded(v, color); });
    }
    EXPECT_EQ(t.different(), 0) << "seed " << seed + 4;
}

/// Contexts that are forgotten are reachable from Mesa's own lists, so no leak checker tells of
/// them.
TEST(MesaLife, AHundredCyclesEndClean) {
    std::size_t in_use = 0;
    for (int n = 0; n < 100; ++n) {
        if (n == 10) // Mesa's caches are filled
            in_use = mallinfo2().uordblks;
        picture p(17, 9, std::mt19937(seed));
        auto context = open_mesa(mesa_ways[static_cast<std::size_t>(n) % mesa_ways.size()]);
        ASSERT_TRUE(context);
        l3d_rasterizer_2d_mesa_imp imp(std::move(context), p.pixels());
        l3d_rasterizer_2d draw(imp);
        draw.draw_point(n % 17, n % 9, 0x00abcdef);
        draw.finish();
        ASSERT_EQ(p.at(n % 17, n % 9), 0x00abcdefu);
    }
    // Mesa keeps some 700 bytes of each; a whole context has more than 4 MB. Sanitizers have a heap
    // of their own and count nothing here.
    EXPECT_LT(mallinfo2().uordblks, in_use + 1000000);
}

} // namespace
