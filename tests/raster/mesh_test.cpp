// SPDX-License-Identifier: MIT
// Meshes of patches: colours, steps, cracks and folds.
#include "raster/canvas_2d.h"
#include "raster/mesh_patches.h"
#include "raster/parallel/simd_target.h"
#include "raster/paths/gradient.h"
#include "raster/paths/mesh_dicer_p.h"
#include "raster/shapes/rasterizer_2d_sw.h"

#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace {

double level(std::uint32_t word, int shift) {
    return word >> shift & 255;
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

/// Half a level of rounding, and what roundings of float add.
constexpr double colors_err = 0.5 + 1.0 / 32;

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
                    ASSERT_GE(shown, r.low[k] - colors_err) << n << ": " << x << ' ' << y;
                    ASSERT_LE(shown, r.high[k] + colors_err) << n << ": " << x << ' ' << y;
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
        l3d_detail::mesh_dicer dicer({&patch, 1}, l3d_detail::mesh_colors::bilinear);
        double most = 0;
        std::size_t j = 0;
        dicer.visit([&](const l3d_detail::mesh_strip& strip) {
            for (std::size_t i = 0; i < strip.cells(); ++i) {
                const l3d_detail::mesh_cell cell = strip.cell(i);
                for (const auto& t : cell.triangles())
                    for (const auto& at : places) {
                        l3d_point_2d here{}, mean{};
                        for (std::size_t k = 0; k < 3; ++k) {
                            here.x += at[k] * dicer.along().at[i + t[k] % 2];
                            here.y += at[k] * dicer.down().at[j + t[k] / 2];
                            mean.x += at[k] * cell.corners[t[k]].at.x;
                            mean.y += at[k] * cell.corners[t[k]].at.y;
                        }
                        const l3d_point_2d exact = place_of(patch, here.x, here.y);
                        most = std::max(most, std::hypot(mean.x - exact.x, mean.y - exact.y));
                    }
            }
            ++j;
        });
        ASSERT_LE(most, 1.0 / 16 + 1e-9) << n;
        sum += most * 16;
    }
    EXPECT_GT(sum / count, 0.5);
    std::printf("  largest distance: %.2f of the bound in the mean\n", sum / count);
}

/// Whether a square of patches covers every pixel, again and again.
template <class Wild>
void expect_no_cracks(std::size_t across, int size, int count, const Wild& wild) {
    std::mt19937 random(3);
    for (int n = 0; n < count; ++n) {
        canvas c(size, size);
        c.draw.draw_mesh(square_of_patches(across, size, wild, random));
        EXPECT_EQ(c.lit().size(), std::size_t(size) * std::size_t(size)) << n;
    }
}

TEST(mesh, has_no_cracks_between_patches_whichever_way_their_borders_run) {
    expect_no_cracks(4, 60, 40, [](std::size_t, std::size_t) { return 1.2; });
}

/// They need other steps than their neighbours: a corner of the square is the wildest.
TEST(mesh, has_no_cracks_between_patches_that_bend_more_and_less) {
    expect_no_cracks(3, 120, 30, [](std::size_t r, std::size_t k) { return 0.05 * double(r * k); });
}

/// Implements triangles, and no meshes.
class triangles_imp final : public l3d_rasterizer_2d_imp {
public:
    explicit triangles_imp(l3d_pixels target) : imp_(target) {}

private:
    void do_set_target(l3d_pixels) override {}
    void do_clear_buffer(std::uint32_t) override {}
    void do_draw_point(int, int, std::uint32_t) override {}
    void do_draw_lines(std::span<const l3d_line_2d>, std::uint32_t) override {}
    void do_draw_line_antialiased(l3d_point_2d, l3d_point_2d, std::uint32_t) override {}
    void do_draw_polygon_flatshaded(l3d_outline_2d, std::uint32_t) override {}
    void do_draw_polygon_gouraudshaded(std::span<const l3d_colored_point_2d> corners) override {
        l3d_rasterizer_2d(imp_).draw_polygon_gouraudshaded(corners);
    }
    void do_draw_outlines(std::span<const l3d_outline_2d>, l3d_winding, std::uint32_t) override {}

    l3d_rasterizer_2d_sw_imp imp_;
};

/// Places are linear, so each pixel's parameters are known. Small triangles, large ones, and some
/// that are partly outside.
TEST(mesh, has_bilinear_colours) {
    constexpr int size = 150;
    for (const double side : {6.0, 20.0, 60.0, 140.0, 400.0})
        for (const double slope : {0.0, 0.2}) {
            l3d_mesh_patch patch;
            const double step = side / 3;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    patch.points[i][j] = {1.25 + step * (double(j) + slope * double(i)),
                                          1.25 + step * (double(i) - slope * double(j))};
            patch.colors = {0x00ff1020, 0x0010f0e0, 0x002030ff, 0x00f0f010};
            std::vector<std::uint32_t> smooth(size * size), plain(size * size);
            l3d_rasterizer_2d_sw_imp imp({smooth.data(), size, size, size});
            l3d_rasterizer_2d(imp).draw_mesh({&patch, 1});
            triangles_imp lines({plain.data(), size, size, size});
            l3d_rasterizer_2d(lines).draw_mesh({&patch, 1});
            std::size_t judged = 0;
            for (int y = 0; y < size; ++y)
                for (int x = 0; x < size; ++x) {
                    const double whole = side * (1 + slope * slope);
                    const double u = (x - 1.25 - slope * (y - 1.25)) / whole;
                    const double v = (y - 1.25 + slope * (x - 1.25)) / whole;
                    const std::size_t i = std::size_t(y * size + x);
                    if (smooth[i] == 0 || plain[i] == 0)
                        continue;
                    ++judged;
                    // the rim is rounded to 1/256 of a pixel
                    const double places = 256 * 3 / side / 256;
                    for (const int shift : {0, 8, 16}) {
                        const double exact = color_of(patch, u, v, shift);
                        ASSERT_NEAR(level(smooth[i], shift), exact, colors_err + places);
                        // those of corners are rounded, too
                        ASSERT_NEAR(level(plain[i], shift), exact, 1.1 + places);
                    }
                }
            EXPECT_GT(double(judged), 0.8 * std::min(side * side, 120.0 * 120.0)) << side;
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
