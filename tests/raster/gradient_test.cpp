// SPDX-License-Identifier: MIT
// Gradients against the mean of many samples in each pixel, found in the slowest way.
#include "effort.h"
#include "raster/canvas_2d.h"
#include "raster/paths/gradient.h"
#include "raster/paths/path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <vector>

namespace {

using stops = std::vector<l3d_color_stop>;
/// Where along a gradient a point of the picture is.
using place_of = std::function<double(l3d_point_2d)>;

/// Red, green, blue and alpha, from 0 to 255.
using rgba = std::array<double, 4>;

double level(std::uint32_t word, int shift) {
    return word >> shift & 255;
}

rgba slow_color(const stops& all, l3d_spread spread, double t) {
    if (spread == l3d_spread::repeat)
        t -= std::floor(t);
    if (spread == l3d_spread::reflect)
        t = std::abs(t - 2 * std::floor(t / 2 + 0.5));
    const l3d_color_stop *from = &all.front(), *to = from;
    for (const l3d_color_stop& stop : all) {
        to = &stop;
        if (stop.at > t)
            break;
        from = &stop;
    }
    const double share =
        to->at > from->at ? std::clamp((t - from->at) / (to->at - from->at), 0., 1.) : 1;
    rgba result;
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = std::lerp(level(from->color, 16 - 8 * int(k)),
                              level(to->color, 16 - 8 * int(k)), share);
    result[3] = 255 * std::lerp(from->alpha, to->alpha, share);
    return result;
}

/// The mean over a pixel's square, of so many samples along either axis.
rgba slow_mean(const stops& all, l3d_spread spread, const place_of& place, int x, int y) {
    constexpr int samples = 40;
    rgba sum{};
    for (int i = 0; i < samples; ++i)
        for (int j = 0; j < samples; ++j) {
            const rgba here = slow_color(
                all, spread, place({x - 0.5 + (i + 0.5) / samples, y - 0.5 + (j + 0.5) / samples}));
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += here[k] * here[3];
            sum[3] += here[3];
        }
    for (std::size_t k = 0; k < 3; ++k)
        sum[k] = sum[3] > 0 ? sum[k] / sum[3] : 0;
    sum[3] /= samples * samples;
    return sum;
}

/// `tolerance`: of what is not rounding; the slow twin's samples tell where a jump is to 1/40.
void expect_means(const l3d_gradient& gradient, const stops& all, l3d_spread spread,
                  const place_of& place, double tolerance = 0.35) {
    for (int y = -3; y < 24; y += 3) {
        std::array<std::uint32_t, 31> row;
        gradient.colors(-3, y, row);
        for (int x = 0; x < 31; x += 4 + y % 3) {
            const rgba expected = slow_mean(all, spread, place, x - 3, y);
            const std::uint32_t word = row[std::size_t(x)];
            ASSERT_NEAR(255 - level(word, 24), expected[3], 0.5 + tolerance) << x - 3 << ' ' << y;
            for (std::size_t k = 0; k < 3 && expected[3] > 8; ++k)
                ASSERT_NEAR(level(word, 16 - 8 * int(k)), expected[k], 0.5 + tolerance)
                    << x - 3 << ' ' << y << ' ' << k;
        }
    }
}

const stops smooth{{0.1, 0x00ff0010}, {0.5, 0x0000ff20}, {1, 0x000000f0}};
/// The differences are small, so that samples can tell the mean of what jumps.
const stops jumping{{0, 0x00203040}, {0.3, 0x00404040}, {0.3, 0x00586048}, {0.8, 0x00404860}};
const stops fading{{0, 0x00ff4000, 0}, {0.6, 0x0080c0ff, 1}, {1, 0x00004080, 0.25}};
constexpr std::array spreads{l3d_spread::pad, l3d_spread::repeat, l3d_spread::reflect};

/// Of the ray from the focus through a point to the unit circle, by halving.
double slow_focal(l3d_point_2d focus, l3d_point_2d at) {
    double least = 0, most = 64;
    for (int i = 0; i < 44; ++i) {
        const double t = (least + most) / 2; // circles between the focus and the unit circle
        const bool inside = std::hypot(at.x - (1 - t) * focus.x, at.y - (1 - t) * focus.y) < t;
        (inside ? most : least) = t;
    }
    return most;
}

TEST(gradient, along_a_line_is_the_mean_over_each_pixel) {
    for (const stops* all : {&smooth, &jumping, &fading})
        for (const l3d_spread spread : spreads)
            for (const l3d_point_2d end : {l3d_point_2d{21, 13}, {5, 14}, {9, 7}, {5, 5.3}}) {
                const double dx = end.x - 5, dy = end.y - 7, length = dx * dx + dy * dy;
                expect_means(
                    l3d_gradient::linear({5, 7}, end, *all, spread), *all, spread,
                    [&](l3d_point_2d p) { return ((p.x - 5) * dx + (p.y - 7) * dy) / length; },
                    all == &smooth && length < 30 && spread == l3d_spread::repeat ? 1.8 : 0.6);
            }
}

TEST(gradient, that_repeats_many_times_in_a_pixel_is_its_mean) {
    for (const l3d_spread spread : {l3d_spread::repeat, l3d_spread::reflect}) {
        const auto gradient = l3d_gradient::linear({0, 0}, {1e-4, 3e-5}, smooth, spread);
        std::array<std::uint32_t, 9> row;
        gradient.colors(-4, 5, row);
        rgba sum{};
        for (int i = 0; i < 100000; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += slow_color(smooth, spread, (i + 0.5) / 1e5)[k] / 1e5;
        for (const std::uint32_t word : row)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_NEAR(level(word, 16 - 8 * int(k)), sum[k], 0.6);
    }
}

TEST(gradient, around_a_place_is_the_mean_over_each_pixel_with_a_focus_too) {
    int at = 0; // unless thorough, each pair of stops, spreads and foci once
    for (const stops* all : {&smooth, &jumping, &fading})
        for (const l3d_spread spread : spreads)
            for (const l3d_point_2d focus : {l3d_point_2d{12, 9}, {15.5, 11}, {6, 3.25}}) {
                const int square = at / 9 + at / 3 + at;
                ++at;
                if (!thorough && square % 3)
                    continue;
                constexpr double radius = 9;
                const l3d_point_2d f{(focus.x - 12) / radius, (focus.y - 9) / radius};
                expect_means(
                    l3d_gradient::radial({12, 9}, radius, focus, *all, spread), *all, spread,
                    [&](l3d_point_2d p) {
                        return slow_focal(f, {(p.x - 12) / radius, (p.y - 9) / radius});
                    },
                    all == &smooth && spread == l3d_spread::repeat ? 3.0 : 1.0);
            }
}

TEST(gradient, is_placed_with_its_plane) {
    const l3d_placement_2d place =
        l3d_placement_2d::scaled(2, 0.7).then(l3d_placement_2d::turned(34, {3, 4}));
    const auto back = [&](l3d_point_2d p) { // by Cramer's rule
        const l3d_point_2d d{p.x - place.origin.x, p.y - place.origin.y};
        const double area = place.across.x * place.down.y - place.across.y * place.down.x;
        return l3d_point_2d{(d.x * place.down.y - d.y * place.down.x) / area,
                            (place.across.x * d.y - place.across.y * d.x) / area};
    };
    expect_means(
        l3d_gradient::linear({1, 2}, {9, 5}, jumping).placed(place), jumping, l3d_spread::pad,
        [&](l3d_point_2d p) {
            const l3d_point_2d q = back(p);
            return ((q.x - 1) * 8 + (q.y - 2) * 3) / 73;
        },
        0.6);
    expect_means(
        l3d_gradient::radial({6, 9}, 7, {8, 9}, jumping).placed(place), jumping, l3d_spread::pad,
        [&](l3d_point_2d p) {
            const l3d_point_2d q = back(p);
            return slow_focal({2.0 / 7, 0}, {(q.x - 6) / 7, (q.y - 9) / 7});
        },
        1.0);
}

TEST(gradient, a_focus_outside_is_moved_inside) {
    std::array<std::uint32_t, 40> outside, inside;
    l3d_gradient::radial({12, 9}, 9, {40, 9}, smooth).colors(0, 9, outside);
    l3d_gradient::radial({12, 9}, 9, {21 - 9.0 / 1024, 9}, smooth).colors(0, 9, inside);
    EXPECT_EQ(outside, inside);
}

TEST(gradient, lets_through_what_is_behind_by_its_alpha) {
    const stops glass{{0, 0x00ff0000, 0.5}};
    const auto gradient = l3d_gradient::linear({0, 0}, {9, 0}, glass);
    l3d_path all;
    all.add_box({0, 0, 20, 20});
    canvas c(20, 20);
    c.draw.clear_buffer(0x000000ff);
    c.draw.draw_path(all, {.gradient = &gradient});
    EXPECT_EQ(c.at(4, 4), 0x0080007fu);
    c.draw.clear_buffer(0x000000ff);
    c.draw.draw_path(all, {.gradient = &gradient, .alpha = 0.5});
    EXPECT_NEAR(level(c.at(4, 4), 16), 64, 1);
    c.draw.clear_buffer(0x000000ff);
    c.draw.draw_path(all, {.gradient = &gradient, .blending = l3d_blending::linear});
    EXPECT_NEAR(level(c.at(4, 4), 16), 188, 1);
    EXPECT_NEAR(level(c.at(4, 4), 0), 188, 1);
    const stops nothing{{0, 0x00ff0000, 0}};
    const auto none = l3d_gradient::linear({0, 0}, {9, 0}, nothing);
    c.draw.clear_buffer(0x000000ff);
    c.draw.draw_path(all, {.gradient = &none});
    EXPECT_EQ(c.at(4, 4), 0x000000ffu);
}

TEST(gradient, at_the_rim_of_a_path_is_mixed_with_what_is_there) {
    canvas c(50, 40);
    l3d_path half;
    half.add_polygon(std::array<l3d_point_2d, 4>{{{10, -9}, {60, -9}, {60, 60}, {10, 60}}});
    const std::array<l3d_color_stop, 1> white{{{0, 0x00ffffff}}};
    const l3d_gradient plain = l3d_gradient::radial({0, 0}, 1, white);
    c.draw.draw_path(half, {.gradient = &plain});
    EXPECT_EQ(c.at(9, 5), 0u);
    EXPECT_EQ(c.at(10, 5), 0x00808080u);
    EXPECT_EQ(c.at(11, 5), 0x00ffffffu);
}

} // namespace
