// SPDX-License-Identifier: MIT
// Gradients along lines and circles, and meshes of patches: colours, cracks and folds.
#include "raster/canvas_2d.h"
#include "raster/paths/gradient.h"
#include "raster/paths/mesh_dicer_p.h"
#include "raster/paths/path.h"
#include "raster/parallel/simd_target.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

double level(std::uint32_t word, int shift) {
    return word >> shift & 255;
}

TEST(gradient, has_the_nearest_level_to_the_line_between_two_stops) {
    const std::array<l3d_color_stop, 3> stops{
        {{0.25, 0x00ff0010}, {0.5, 0x0000ff20}, {1, 0x000000f0}}};
    const auto expected = [&](double t, int shift) {
        if (t <= 0.25)
            return level(stops[0].color, shift);
        const std::size_t i = t < 0.5 ? 0 : 1;
        const double share = std::min((t - stops[i].at) / (stops[i + 1].at - stops[i].at), 1.0);
        return std::lerp(level(stops[i].color, shift), level(stops[i + 1].color, shift), share);
    };
    canvas c(50, 40);
    l3d_path all;
    all.add_circle({25, 20}, 100);
    const auto test = [&](const l3d_gradient& gradient, const auto& place) {
        c.draw.draw_path(all, {.gradient = &gradient});
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 50; ++x)
                for (const int shift : {0, 8, 16})
                    ASSERT_NEAR(level(c.at(x, y), shift), expected(place(x, y), shift), 0.5001)
                        << x << ' ' << y;
    };
    test(l3d_gradient::linear({5, 7}, {40, 30}, stops),
         [](int x, int y) { return ((x - 5) * 35.0 + (y - 7) * 23.0) / (35 * 35 + 23 * 23); });
    test(l3d_gradient::radial({20, 11}, 25, stops),
         [](int x, int y) { return std::hypot(x - 20, y - 11) / 25; });
    // at the rim it is mixed with what is there
    c.draw.clear_buffer();
    l3d_path half;
    half.add_polygon(std::array<l3d_point_2d, 4>{{{10, -9}, {60, -9}, {60, 60}, {10, 60}}});
    const std::array<l3d_color_stop, 1> white{{{0, 0x00ffffff}}};
    const l3d_gradient plain = l3d_gradient::radial({0, 0}, 1, white);
    c.draw.draw_path(half, {.gradient = &plain});
    EXPECT_EQ(c.at(9, 5), 0u);
    EXPECT_EQ(c.at(10, 5), 0x00808080u);
    EXPECT_EQ(c.at(11, 5), 0x00ffffffu);
}

l3d_point_2d place_of(const l3d_mesh_patch& patch, double u, double v) {
    const auto along = [](double a, double b, double c, double d, double t) {
        const double s = 1 - t;
        return s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
    };
    std::array<l3d_point_2d, 4> p;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto& row = patch.points[i];
        p[i] = {along(row[0].x, row[1].x, row[2].x, row[3].x, u),
                along(row[0].y, row[1].y, row[2].y, row[3].y, u)};
    }
    return {along(p[0].x, p[1].x, p[2].x, p[3].x, v), along(p[0].y, p[1].y, p[2].y, p[3].y, v)};
}

double color_of(const l3d_mesh_patch& patch, double u, double v, int shift) {
    return std::lerp(std::lerp(level(patch.colors[0], shift), level(patch.colors[1], shift), u),
                     std::lerp(level(patch.colors[2], shift), level(patch.colors[3], shift), u), v);
}

/// Each pixel's colour is one that the patch has next to its sample, folded or not.
void test_patches(int count, unsigned seed) {
    constexpr int size = 24, samples = 400;
    std::mt19937 random(seed);
    canvas c(size, size);
    std::size_t lit = 0;
    for (int n = 0; n < count; ++n) {
        l3d_mesh_patch patch;
        // folded often or at times; or never, as neighbours differ by 3.5 along and 3 across
        constexpr std::array<double, 3> wilds{12, 3, 1.5};
        const double wild = wilds[static_cast<std::size_t>(n) % 3];
        for (int r = 0; r < 4; ++r)
            for (int k = 0; k < 4; ++k)
                patch.points[std::size_t(r)][std::size_t(k)] = {
                    2 + 6.5 * k + uniform(random, -wild, wild),
                    2 + 6.5 * r + uniform(random, -wild, wild)};
        for (std::uint32_t& color : patch.colors)
            color = (static_cast<std::uint32_t>(random()) & 0x00ffffff) | 0x00010101;
        struct range {
            std::array<double, 3> low{999, 999, 999}, high{-1, -1, -1};
            bool inside = false;
        };
        std::vector<range> ranges(size * size);
        double step = 0;
        l3d_point_2d last = patch.points[0][0];
        for (int j = 0; j <= samples; ++j)
            for (int i = 0; i <= samples; ++i) {
                const double u = double(i) / samples, v = double(j) / samples;
                const l3d_point_2d at = place_of(patch, u, v);
                if (i > 0)
                    step = std::max(step, std::hypot(at.x - last.x, at.y - last.y));
                last = at;
                const int x = int(std::lround(at.x)), y = int(std::lround(at.y));
                if (x < 0 || y < 0 || x >= size || y >= size ||
                    std::hypot(at.x - x, at.y - y) > 1.0 / 16 + 1.0 / 256 + 0.25)
                    continue;
                range& r = ranges[std::size_t(y * size + x)];
                r.inside |= i > 8 && j > 8 && i < samples - 8 && j < samples - 8 &&
                            std::hypot(at.x - x, at.y - y) < 0.02;
                for (std::size_t k = 0; k < 3; ++k) {
                    r.low[k] = std::min(r.low[k], color_of(patch, u, v, int(16 - 8 * k)));
                    r.high[k] = std::max(r.high[k], color_of(patch, u, v, int(16 - 8 * k)));
                }
            }
        c.draw.clear_buffer();
        c.draw.draw_mesh({&patch, 1});
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                const std::uint32_t word = c.at(x, y);
                const range& r = ranges[std::size_t(y * size + x)];
                if (word == 0) {
                    // without folds, the inside is far from the rim
                    ASSERT_FALSE(r.inside && wild < 2) << n << ": hole at " << x << ' ' << y;
                    continue;
                }
                ++lit;
                for (std::size_t k = 0; k < 3; ++k) {
                    const double shown = level(word, int(16 - 8 * k));
                    ASSERT_GE(shown, r.low[k] - 0.5626) << n << ": " << x << ' ' << y;
                    ASSERT_LE(shown, r.high[k] + 0.5626) << n << ": " << x << ' ' << y;
                }
            }
        ASSERT_TRUE(c.guards_intact());
    }
    EXPECT_GT(lit, static_cast<std::size_t>(count) * 100);
}

TEST(mesh, has_colours_of_the_patch_next_to_each_sample) {
    test_patches(30, 1);
}

/// Takes minutes: make stress.
TEST(mesh, DISABLED_has_colours_of_the_patch_next_to_each_sample_in_10_000_patches) {
    test_patches(10000, 2);
}

/// Triangles of one colour are as near to the patch as promised, at its own parameters, and not
/// much nearer: finer ones would be wasted.
TEST(mesh, triangles_are_a_sixteenth_of_a_pixel_from_the_patch) {
    constexpr std::array<std::array<double, 3>, 7> places{{{0.5, 0.5, 0},
                                                           {0, 0.5, 0.5},
                                                           {0.5, 0, 0.5},
                                                           {1 / 3.0, 1 / 3.0, 1 / 3.0},
                                                           {0.6, 0.2, 0.2},
                                                           {0.2, 0.6, 0.2},
                                                           {0.2, 0.2, 0.6}}};
    std::mt19937 random(8);
    double sum = 0;
    constexpr int count = 100;
    for (int n = 0; n < count; ++n) {
        // Each is wilder than the one before.
        l3d_mesh_patch patch;
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t c = 0; c < 4; ++c)
                patch.points[r][c] = {20 * double(c) + uniform(random, -0.2, 0.2) * n,
                                      20 * double(r) + uniform(random, -0.2, 0.2) * n};
        l3d_detail::mesh_dicer dicer({&patch, 1});
        const double steps = dicer.steps();
        double most = 0;
        int v = 0;
        dicer.visit(patch, [&](const l3d_detail::mesh_strip& strip) {
            for (std::size_t i = 0; i < strip.triangles(); ++i) {
                const auto t = strip.triangle(i);
                const double u = double(i / 2);
                const std::array<double, 3> us{u, u + 1, i % 2 == 0 ? u + 1 : u};
                const std::array<double, 3> vs{double(v), i % 2 == 0 ? v : v + 1.0, v + 1.0};
                for (const auto& at : places) {
                    l3d_point_2d here{}, mean{};
                    for (std::size_t k = 0; k < 3; ++k) {
                        here.x += at[k] * us[k] / steps;
                        here.y += at[k] * vs[k] / steps;
                        mean.x += at[k] * t[k].at.x;
                        mean.y += at[k] * t[k].at.y;
                    }
                    const l3d_point_2d exact = place_of(patch, here.x, here.y);
                    most = std::max(most, std::hypot(mean.x - exact.x, mean.y - exact.y));
                }
            }
            ++v;
        });
        ASSERT_LE(most, 1.0 / 16 + 1e-9) << n;
        sum += most * 16;
    }
    EXPECT_GT(sum / count, 0.5);
    std::printf("  largest distance: %.2f of the bound in the mean\n", sum / count);
}

TEST(mesh, has_no_cracks_between_patches_whichever_way_their_borders_run) {
    constexpr int size = 60, across = 4;
    std::mt19937 random(3);
    for (int n = 0; n < 40; ++n) {
        std::array<std::array<l3d_point_2d, 3 * across + 1>, 3 * across + 1> net;
        for (int r = 0; r <= 3 * across; ++r)
            for (int k = 0; k <= 3 * across; ++k) {
                const bool rim = r == 0 || k == 0 || r == 3 * across || k == 3 * across;
                const double wild = rim ? 0 : 1.2;
                net[std::size_t(r)][std::size_t(k)] = {
                    -1 + k * (size + 1.0) / (3 * across) + uniform(random, -wild, wild),
                    -1 + r * (size + 1.0) / (3 * across) + uniform(random, -wild, wild)};
            }
        std::vector<l3d_mesh_patch> patches;
        for (std::size_t r = 0; r < across; ++r)
            for (std::size_t k = 0; k < across; ++k) {
                l3d_mesh_patch patch;
                // turned by half, or mirrored, so that borders run either way
                const bool flip = random() % 2 == 0, mirror = random() % 2 == 0;
                for (std::size_t i = 0; i < 4; ++i)
                    for (std::size_t j = 0; j < 4; ++j)
                        patch.points[i][j] =
                            net[3 * r + (flip ? 3 - i : i)][3 * k + (mirror ? 3 - j : j)];
                patch.colors.fill(canvas::color);
                patches.push_back(patch);
            }
        canvas c(size, size);
        c.draw.draw_mesh(patches);
        EXPECT_EQ(c.lit().size(), std::size_t{size} * size) << n;
    }
}

TEST(mesh, shows_the_larger_parameter_where_it_folds) {
    // one way as it is; the other way up to 24 and back to 6
    const std::array<double, 4> even{1, 10, 19, 28}, folded{1, 32, 32, 6};
    const auto at = [&](double t) {
        const double s = 1 - t;
        return s * s * s * folded[0] + 3 * s * s * t * folded[1] + 3 * s * t * t * folded[2] +
               t * t * t * folded[3];
    };
    const auto largest = [&](double place) {
        for (double t = 1; t > 0; t -= 1e-5)
            if ((at(t) - place) * (at(t - 1e-5) - place) <= 0)
                return t;
        return -1.0;
    };
    for (const bool along_v : {true, false}) {
        l3d_mesh_patch patch;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                patch.points[i][j] =
                    along_v ? l3d_point_2d{even[j], folded[i]} : l3d_point_2d{folded[j], even[i]};
        patch.colors = along_v
                           ? std::array<std::uint32_t, 4>{0x100000, 0x100000, 0xf00000, 0xf00000}
                           : std::array<std::uint32_t, 4>{0x100000, 0xf00000, 0x100000, 0xf00000};
        canvas c(30, 30);
        c.draw.draw_mesh({&patch, 1});
        for (int i = 2; i < 22; ++i) {
            const double red = 16 + 224 * largest(i);
            // the colour changes by about 8 levels a pixel there, a sixteenth of which is allowed
            EXPECT_NEAR(level(along_v ? c.at(15, i) : c.at(i, 15), 16), red, 1.2) << i;
        }
    }
}

TEST(mesh, is_the_same_bits_with_all_vector_instructions) {
    const l3d_mesh_patch patch =
        l3d_mesh_patch::coons({{{2, 3},
                                {20, 12},
                                {40, -8},
                                {61, 5},
                                {50, 20},
                                {70, 30},
                                {58, 42},
                                {40, 30},
                                {20, 60},
                                {3, 41},
                                {9, 30},
                                {-4, 20}}},
                              {0x00ff1020, 0x0010ff30, 0x002030ff, 0x00f0f010});
    std::vector<std::uint32_t> first;
    for (const std::string& target : l3d_simd_targets()) {
        l3d_set_simd_target(target);
        std::vector<std::uint32_t> words(64 * 48);
        l3d_rasterizer_2d_sw_imp imp({words.data(), 64, 48, 64});
        l3d_rasterizer_2d(imp).draw_mesh({&patch, 1});
        if (first.empty())
            first = words;
        EXPECT_EQ(words, first) << target;
    }
    l3d_set_simd_target("");
    EXPECT_GT(std::ranges::count_if(first, [](std::uint32_t w) { return w != 0; }), 1500);
}

TEST(mesh, of_coons_is_straight_between_straight_borders) {
    std::array<l3d_point_2d, 12> border;
    for (std::size_t i = 0; i < 3; ++i) {
        const double way = 3 * double(i);
        border[i] = {way, 0};
        border[3 + i] = {9, way};
        border[6 + i] = {9 - way, 9};
        border[9 + i] = {0, 9 - way};
    }
    const l3d_mesh_patch patch = l3d_mesh_patch::coons(border, {1, 2, 3, 4});
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            EXPECT_NEAR(patch.points[i][j].x, 3.0 * double(j), 1e-12);
            EXPECT_NEAR(patch.points[i][j].y, 3.0 * double(i), 1e-12);
        }
    l3d_mesh_patch endless = patch;
    endless.points[1][2].x = std::numeric_limits<double>::infinity();
    canvas c(12, 12);
    c.draw.draw_mesh({&endless, 1});
    EXPECT_TRUE(c.lit().empty());
}

} // namespace
