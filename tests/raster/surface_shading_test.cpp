// SPDX-License-Identifier: MIT
// The output of the surface rasterizer: depth, normals and colours against the twin and by hand.
#include "surface_fixture.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace {

constexpr unsigned seed = 20060711;

std::uint32_t grey(unsigned level) {
    return level * 0x010101u;
}

/// Longest distance of two corners along an axis, squared.
long double extent_squared(const reference::corners& v) {
    long double longest = 0;
    for (const auto& a : v)
        for (const auto& b : v)
            longest = std::max({longest, std::abs(static_cast<long double>(a.x) - b.x),
                                std::abs(static_cast<long double>(a.y) - b.y)});
    return longest * longest;
}

/// How far an interpolated number may be from the exact one, before it is clamped.
///
/// Float: start, slope, product and sum are rounded to 2^-24 each, of at most 4 times the largest
/// number (a quad's plane may leave the corners' range by their difference): 2^-20 in all.
/// Double: slopes are at most difference * length / area, rounded 4 times to 2^-53, and act over
/// one length in each of x and y.
long double allowed_error(const reference::corners& v, long double largest) {
    const long double area = std::abs(static_cast<long double>(reference::area2(v)));
    return std::ldexp(largest, -20) + std::ldexp(2 * largest * extent_squared(v) / area, 4 - 53);
}

std::vector<float> component(const reference::corners& v, int axis) {
    std::vector<float> result;
    for (const auto& corner : v)
        result.push_back(axis < 0 ? corner.inv_w : corner.normal[axis]);
    return result;
}

TEST(SurfaceShading, DepthIsTheTwinsWithinTheBound) {
    surface_picture picture(31, 19);
    random_polygons random(seed, picture.size);
    std::int64_t compared = 0;
    for (int n = 0; n < 100000; ++n) {
        const reference::corners v = random.next();
        const auto pieces = reference::pieces(v);
        if (pieces.size() != 1)
            continue;
        const std::vector<float> inv_w = component(v, -1);
        const auto [farthest, nearest] = std::minmax_element(inv_w.begin(), inv_w.end());
        const long double allowed = allowed_error(v, *nearest);
        picture.begin(l3d_shade::error);
        picture.draw(v);
        for (int y = 0; y < picture.size.height; ++y)
            for (int x = 0; x < picture.size.width; ++x) {
                if (!reference::covers(v, x, y))
                    continue;
                const long double exact = reference::at_centre(v, inv_w, x, y);
                const long double clamped = std::clamp<long double>(exact, *farthest, *nearest);
                ASSERT_NEAR(static_cast<double>(picture.inv_w(x, y)), static_cast<double>(clamped),
                            static_cast<double>(allowed))
                    << "seed " << seed << ", polygon " << n << " at " << x << ", " << y;
                ASSERT_GE(picture.inv_w(x, y), *farthest);
                ASSERT_LE(picture.inv_w(x, y), *nearest);
                ++compared;
            }
    }
    EXPECT_GT(compared, 1000000);
}

/// An eye that looks at a picture slantwise: rays differ from pixel to pixel.
l3d_shading slanting(l3d_shade mode, std::array<float, 3> light) {
    return {mode, light, {-0.4f, 0.3f, -1}, {0.05f, 0.01f, 0.02f}, {-0.01f, -0.06f, 0.03f}};
}

/// How far the normals at the corners point away from the eye.
std::vector<float> away_from_eye(const reference::corners& v, const l3d_shading& shading) {
    std::vector<float> result;
    for (const l3d_micro_vertex& corner : v) {
        double away = 0;
        for (std::size_t i = 0; i < 3; ++i)
            away += static_cast<double>(corner.normal[i]) *
                    (static_cast<double>(shading.ray[i]) +
                     corner.x / 256.0 * static_cast<double>(shading.ray_right[i]) +
                     corner.y / 256.0 * static_cast<double>(shading.ray_down[i]));
        result.push_back(static_cast<float>(away));
    }
    return result;
}

/// The unit normal, turned round if sign is -1, from the twin.
std::array<long double, 3> exact_normal(const reference::corners& v, int x, int y,
                                        long double sign) {
    std::array<long double, 3> n{};
    for (int axis = 0; axis < 3; ++axis)
        n[static_cast<std::size_t>(axis)] = reference::at_centre(v, component(v, axis), x, y);
    const long double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (long double& c : n)
        c *= sign / length;
    return n;
}

/// Shortest interpolated normal near a pixel decides how far errors turn it.
long double shortest(const reference::corners& v, int x, int y) {
    long double square = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const long double c = reference::at_centre(v, component(v, axis), x, y);
        square += c * c;
    }
    return std::sqrt(square);
}

TEST(SurfaceShading, LambertAndNormalsAreTheTwinsWithinTheBound) {
    surface_picture grey_picture(31, 19), color_picture(31, 19);
    random_polygons random(seed + 1, grey_picture.size);
    const std::array<float, 3> light{0.6f, -0.48f, 0.64f};
    std::int64_t compared = 0;
    for (int n = 0; n < 30000; ++n) {
        const reference::corners v = random.next();
        if (reference::pieces(v).size() != 1)
            continue;
        const long double allowed = allowed_error(v, 1);
        const l3d_shading shading = slanting(l3d_shade::lambert, light);
        const std::vector<float> aways = away_from_eye(v, shading);
        float largest = 0;
        for (const float corner : aways)
            largest = std::max(largest, std::abs(corner));
        grey_picture.begin(shading);
        color_picture.begin(slanting(l3d_shade::normals, light));
        grey_picture.draw(v);
        color_picture.draw(v);
        for (int y = 0; y < grey_picture.size.height; ++y)
            for (int x = 0; x < grey_picture.size.width; ++x) {
                if (!reference::covers(v, x, y))
                    continue;
                // a unit normal's error: sqrt(3) components, twice (itself and its length)
                const long double turn = 4 * allowed / shortest(v, x, y);
                if (!(turn < 0.001L))
                    continue;
                const long double away = reference::at_centre(v, aways, x, y);
                if (std::abs(away) <= 4 * allowed * static_cast<long double>(largest))
                    continue; // either side may be the front
                const auto unit = exact_normal(v, x, y, away > 0 ? -1 : 1);
                const long double cosine = unit[0] * static_cast<long double>(light[0]) +
                                           unit[1] * static_cast<long double>(light[1]) +
                                           unit[2] * static_cast<long double>(light[2]);
                const long double level = 255 * (0.1L + 0.9L * std::max(0.0L, cosine));
                const std::uint32_t word = grey_picture.word(x, y);
                ASSERT_EQ(word, grey(word & 255));
                // rounded: half a level; plus 2^-13 for the floats of a number up to 255
                ASSERT_NEAR(word & 255, static_cast<double>(level),
                            static_cast<double>(0.5L + 255 * turn + 0x1p-13L))
                    << "seed " << seed + 1 << ", polygon " << n << " at " << x << ", " << y;
                for (int axis = 0; axis < 3; ++axis)
                    ASSERT_NEAR(
                        color_picture.word(x, y) >> (16 - 8 * axis) & 255,
                        static_cast<double>(127.5L * (unit[static_cast<std::size_t>(axis)] + 1)),
                        static_cast<double>(0.5L + 255 * turn + 0x1p-13L));
                ++compared;
            }
    }
    EXPECT_GT(compared, 300000);
}

/// A cell that fills a picture of 8 by 6 pixels from pixel (2, 1), u to the right, v up.
reference::corners upright_cell() {
    const auto at = [](int x, int y) {
        return l3d_micro_vertex{256 * x, 256 * y, 0.5f, {0, 0, 3}};
    };
    return {at(2, 5), at(7, 5), at(7, 1), at(2, 1)};
}

TEST(SurfaceShading, SeenFromTheFrontTheNormalStays) {
    surface_picture picture(8, 6);
    picture.begin(l3d_shade::lambert, {0, 0, 1}); // a light behind the eye
    picture.draw(upright_cell());
    EXPECT_EQ(picture.word(3, 2), grey(255));
    picture.begin(l3d_shade::normals);
    picture.draw(upright_cell());
    EXPECT_EQ(picture.word(3, 2), 0x8080ffu); // 127.5 rounds up
}

TEST(SurfaceShading, SeenFromBehindTheNormalTurns) {
    surface_picture picture(8, 6);
    reference::corners cell = upright_cell();
    std::swap(cell[0], cell[3]); // v downwards: dS/du x dS/dv points away
    std::swap(cell[1], cell[2]);
    for (l3d_micro_vertex& v : cell)
        v.normal[2] = -3;
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat}) {
        picture.begin(mode, {0, 0, 1});
        picture.draw(cell);
        EXPECT_EQ(picture.word(3, 2), grey(255)) << static_cast<int>(mode);
        picture.begin(mode, {0, 0, -1});
        picture.draw(cell);
        EXPECT_EQ(picture.word(3, 2), grey(26)) << static_cast<int>(mode); // 25.5 rounds up
    }
    picture.begin(l3d_shade::lambert, {0, 0, 1});
    picture.draw({cell[0], cell[1], cell[2]}); // a triangle by the same rule
    EXPECT_EQ(picture.word(6, 2), grey(255));
}

TEST(SurfaceShading, NormalsAndNotTheOrientationSayWhatIsTheFront) {
    surface_picture picture(8, 6);
    reference::corners cell = upright_cell();
    std::swap(cell[1], cell[3]); // runs the other way round
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat}) {
        picture.begin(mode, {0, 0, 1});
        picture.draw(cell);
        EXPECT_EQ(picture.word(3, 2), grey(255)) << static_cast<int>(mode);
    }
}

TEST(SurfaceShading, GouraudInterpolatesTheCornersGreys) {
    surface_picture picture(8, 6);
    reference::corners cell = upright_cell();
    cell[1].normal[0] = cell[2].normal[0] = 3; // right side: cosine 0 instead of 1
    cell[1].normal[2] = cell[2].normal[2] = 0;
    picture.begin(l3d_shade::gouraud, {0, 0, 1});
    picture.draw(cell);
    // five pixels, centres at 0.1, 0.3 ... 0.9 of the way from 255 to 25.5; the formula by hand:
    const std::array<unsigned, 5> expected{232, 186, 140, 94, 48};
    for (int i = 0; i < 5; ++i)
        EXPECT_NEAR(picture.word(2 + i, 3) & 255, expected[static_cast<std::size_t>(i)], 1) << i;
    EXPECT_EQ(picture.word(4, 3), grey(140)); // 140.25
}

TEST(SurfaceShading, GouraudStaysBetweenTheCornersGreys) {
    // The plane through the diagonals' differences and the mean falls below the dark greys at the
    // corner opposite the bright one: to 125 - 0.36 (255 - 81) = 62.
    surface_picture picture(40, 31);
    reference::corners kite = upright_cell();
    const std::array<std::array<int, 2>, 4> places{{{3, 2}, {9, 27}, {24, 24}, {36, 9}}};
    const std::array<float, 4> lean{0, 4, 4, 4}; // the first is bright, the rest dark
    for (std::size_t i = 0; i < kite.size(); ++i) {
        kite[i].x = places[i][0] * l3d_subpixel_one;
        kite[i].y = places[i][1] * l3d_subpixel_one;
        kite[i].normal[0] = lean[i];
        kite[i].normal[1] = 0;
        kite[i].normal[2] = 1;
    }
    picture.begin(l3d_shade::gouraud, {0, 0, 1});
    picture.draw(kite);
    // 255 (0.1 + 0.9 / sqrt(17)) = 81.2 for the dark corners, 255 for the first.
    int written = 0;
    for (int y = 0; y < 31; ++y)
        for (int x = 0; x < 40; ++x)
            if (const unsigned level = picture.word(x, y) & 255; level != 0) {
                EXPECT_GE(level, 81u) << x << ' ' << y;
                ++written;
            }
    EXPECT_GT(written, 100);
}

TEST(SurfaceShading, FlatIsOneGreyFromTheMeanNormal) {
    surface_picture picture(8, 6);
    reference::corners cell = upright_cell();
    cell[1].normal[0] = cell[2].normal[0] = 3;
    cell[1].normal[2] = cell[2].normal[2] = 0;
    picture.begin(l3d_shade::flat, {0, 0, 1});
    picture.draw(cell);
    for (int x = 2; x < 7; ++x)
        EXPECT_EQ(picture.word(x, 4), grey(188)); // 255 (0.1 + 0.9 sqrt(1/2)) = 187.78
}

TEST(SurfaceShading, ANormalOfNoLengthIsAmbient) {
    surface_picture picture(8, 6);
    reference::corners cell = upright_cell();
    for (l3d_micro_vertex& v : cell)
        v.normal[2] = 0;
    for (const l3d_shade mode : {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat}) {
        picture.begin(mode);
        picture.draw(cell);
        EXPECT_EQ(picture.word(3, 3), grey(26));
    }
    picture.begin(l3d_shade::normals);
    picture.draw(cell);
    EXPECT_EQ(picture.word(3, 3), grey(128));
}

TEST(SurfaceShading, NormalsOfAnyLengthGiveOneColour) {
    surface_picture picture(8, 6);
    for (const float length : {1e-17f, 1e-3f, 1e17f}) {
        reference::corners cell = upright_cell();
        for (l3d_micro_vertex& v : cell)
            v.normal[2] = length;
        picture.begin(l3d_shade::lambert, {0, 0, 1});
        picture.draw(cell);
        EXPECT_EQ(picture.word(3, 3), grey(255)) << length;
    }
}

TEST(SurfaceShading, NormalsThatAreNotNumbersAreNoFault) {
    surface_picture picture(8, 6);
    reference::corners cell = upright_cell();
    cell[2].normal[1] = std::numeric_limits<float>::quiet_NaN();
    cell[3].normal[2] = std::numeric_limits<float>::infinity();
    for (const l3d_shade mode :
         {l3d_shade::lambert, l3d_shade::gouraud, l3d_shade::flat, l3d_shade::normals}) {
        picture.begin(mode);
        picture.draw(cell);
        EXPECT_EQ(picture.rasterizer.counts().written, 20);
    }
}

TEST(SurfaceDepth, NearerWinsAndOfEqualsTheFirst) {
    surface_picture picture(8, 6);
    const auto draw = [&](float inv_w, std::uint32_t color) {
        reference::corners cell = upright_cell();
        for (l3d_micro_vertex& v : cell)
            v.inv_w = inv_w;
        picture.draw(cell, color);
    };
    picture.begin(l3d_shade::error);
    draw(0.5f, 1);
    draw(0.25f, 2); // farther
    draw(0.5f, 3);  // equal
    EXPECT_EQ(picture.word(4, 3), 1u);
    EXPECT_EQ(picture.inv_w(4, 3), 0.5f);
    draw(0.75f, 4);
    EXPECT_EQ(picture.word(4, 3), 4u);
    EXPECT_EQ(picture.rasterizer.counts().quads, 4);
    EXPECT_EQ(picture.rasterizer.counts().samples, 4 * 20);
    EXPECT_EQ(picture.rasterizer.counts().written, 2 * 20);
}

l3d_micro_grid random_mesh(random_polygons& random, int dx, int dy) {
    l3d_micro_grid grid;
    grid.resize(14, 11);
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            l3d_micro_vertex v{1500 * column - 1000 + random.number(-2000, 2000) - 256 * dx,
                               1300 * row - 900 + random.number(-2000, 2000) - 256 * dy,
                               random.real(0.1f, 1.0f),
                               {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)}};
            surface_picture::set(grid, row, column, v);
        }
    return grid;
}

TEST(SurfaceDepth, APartOfThePictureIsTheSameAsThatPartOfTheWhole) {
    constexpr int left = 13, top = 7;
    surface_picture whole(67, 47), part(29, 23);
    for (unsigned n = 0; n < 100; ++n) {
        random_polygons random(seed + n, whole.size), again(seed + n, whole.size);
        whole.begin(l3d_shade::lambert, {0.6f, 0, 0.8f});
        part.begin(l3d_shade::lambert, {0.6f, 0, 0.8f});
        whole.draw(random_mesh(random, 0, 0));
        part.draw(random_mesh(again, left, top));
        for (int y = 0; y < part.size.height; ++y)
            for (int x = 0; x < part.size.width; ++x) {
                ASSERT_EQ(part.word(x, y), whole.word(x + left, y + top)) << "seed " << seed + n;
                ASSERT_EQ(part.inv_w(x, y), whole.inv_w(x + left, y + top)) << "seed " << seed + n;
            }
    }
}

} // namespace
