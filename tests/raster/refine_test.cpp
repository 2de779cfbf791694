// SPDX-License-Identifier: MIT
// Anti-aliasing: against a picture of 16 x 16 times the pixels, and against exact areas.
#include "raster/color/linear_light_p.h"
#include "raster/color/srgb_light.h"
#include "raster/refine/sample_places_p.h"
#include "surface_scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>

namespace {

using l3d_detail::scan_point;

constexpr int fine = 16; ///< samples of a pixel along x and along y

l3d_shading antialiased(l3d_shade mode) {
    l3d_shading shading = scene_shading(mode);
    shading.antialias = true;
    return shading;
}

/// A part in a picture of so many times the pixels.
l3d_surface_part enlarged(l3d_surface_part part) {
    for (auto* const numbers : {&part.grid.x, &part.grid.y})
        for (std::int32_t& number : *numbers)
            number *= fine;
    for (l3d_micro_triangles::block& block : part.triangles.blocks)
        for (l3d_micro_triangles::corner& c : block)
            for (auto* const numbers : {&c.x, &c.y})
                for (std::int32_t& number : *numbers)
                    number *= fine;
    return part;
}

surface_parts enlarged(const surface_parts& scene) {
    surface_parts result;
    for (const l3d_surface_part& part : scene)
        result.push_back(enlarged(part));
    return result;
}

void draw(surface_picture& picture, const surface_parts& scene, const l3d_shading& shading) {
    picture.begin(shading);
    picture.rasterizer.draw(pointers(scene));
    picture.rasterizer.finish();
}

/// The slow twin: every pixel by 256 samples, each drawn as a pixel of its own.
class slow_picture {
public:
    slow_picture(const surface_parts& scene, l3d_size size, l3d_shade mode)
        : picture_(size.width * fine, size.height * fine) {
        l3d_shading shading = scene_shading(mode);
        for (auto* const ray : {&shading.ray_right, &shading.ray_down})
            for (float& part : *ray)
                part /= fine;
        draw(picture_, enlarged(scene), shading);
    }

    /// The mean light of a pixel as a level, and the levels of its darkest and brightest samples.
    struct pixel {
        double level = 0;
        int darkest = 255, brightest = 0;
    };
    pixel at(int x, int y) {
        pixel result;
        double sum = 0;
        for (int row = 0; row < fine; ++row)
            for (int column = 0; column < fine; ++column) {
                const int level = int(picture_.word(x * fine + column, y * fine + row) & 255);
                result.darkest = std::min(result.darkest, level);
                result.brightest = std::max(result.brightest, level);
                sum += l3d_light_of_level(level);
            }
        result.level = l3d_level_of_light(sum / (fine * fine));
        return result;
    }

private:
    surface_picture picture_;
};

/// Errors as shares of the pixel's contrast.
struct share_errors {
    int outlines = 0; ///< pixels of some contrast
    double largest = 0, sum = 0;

    void add(double drawn, const slow_picture::pixel& exact) {
        const double dark = l3d_light_of_level(exact.darkest),
                     bright = l3d_light_of_level(exact.brightest);
        if (exact.brightest - exact.darkest < 24)
            return;
        const double error =
            std::abs(l3d_light_of_level(drawn) - l3d_light_of_level(exact.level)) / (bright - dark);
        ++outlines;
        sum += error * error;
        largest = std::max(largest, error);
    }
    double rms() const { return outlines > 0 ? std::sqrt(sum / outlines) : 0; }
};

TEST(Refine, DrawsWhatTheSlowTwinDraws) {
    constexpr l3d_size size{101, 67};
    for (const l3d_shade mode : {l3d_shade::gouraud, l3d_shade::flat, l3d_shade::levels})
        for (unsigned n = 0; n < 6; ++n) {
            const surface_parts scene = random_scene(scene_seed + n, size, 6);
            surface_picture drawn(size.width, size.height, 2), stairs(size.width, size.height, 2);
            draw(drawn, scene, antialiased(mode));
            draw(stairs, scene, scene_shading(mode));
            slow_picture slow(scene, size, mode);
            share_errors errors, of_stairs;
            for (int y = 0; y < size.height; ++y)
                for (int x = 0; x < size.width; ++x) {
                    const auto exact = slow.at(x, y);
                    errors.add(int(drawn.word(x, y) & 255), exact);
                    of_stairs.add(int(stairs.word(x, y) & 255), exact);
                }
            SCOPED_TRACE(testing::Message() << "mode " << int(mode) << ", seed " << n);
            ASSERT_GT(errors.outlines, 100);
            // Here and there shading jumps from facet to facet by less than what counts as an edge,
            // and no centre sees what is thinner than a pixel. Limits are 1.2 times what was
            // measured: 0.071, and 0.27 of the stairs' error.
            EXPECT_LT(errors.rms(), 0.085);
            EXPECT_LT(errors.rms(), 0.32 * of_stairs.rms());
        }
}

/// A sheet that is folded along the line from `a` to `b`, lit alike everywhere, and its two borders
/// far away on the right of that way.
l3d_surface_part folded_at(scan_point a, scan_point b, int rows, float inv_w = 0.5f) {
    const scan_point across{(a.y - b.y), (b.x - a.x)};
    l3d_micro_grid grid;
    grid.resize(3, rows + 1);
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column < 3; ++column) {
            const bool at_fold = column == 1;
            const std::int32_t x = a.x + (b.x - a.x) * row / rows,
                               y = a.y + (b.y - a.y) * row / rows;
            surface_picture::set(grid, row, column,
                                 {at_fold ? x : x + across.x,
                                  at_fold ? y : y + across.y,
                                  column == 0   ? 0.6f
                                  : column == 1 ? inv_w
                                                : 0.4f,
                                  {100.25f, 0, 0}});
        }
    return part_of(grid);
}

/// The part of a pixel that is on the right of a line, seen in the picture.
double area_right_of(scan_point a, scan_point b, int x, int y) {
    // Rows of a 512th of a pixel: each is cut by a straight line, in the mean exactly.
    constexpr int rows = 512;
    double sum = 0;
    for (int row = 0; row < rows; ++row) {
        const double at_y = 256 * (y + (row + 0.5) / rows);
        const double at_x = a.x + (at_y - a.y) * (b.x - a.x) / double(b.y - a.y);
        const double left = std::clamp(at_x / 256 - x, 0.0, 1.0);
        sum += b.y < a.y ? 1 - left : left;
    }
    return sum / rows;
}

TEST(Refine, AFoldHasItsShareOfEachPixel) {
    constexpr l3d_size size{48, 32};
    std::mt19937 random(scene_seed);
    const auto number = [&](int least, int most) {
        return std::uniform_int_distribution<int>(least, most)(random);
    };
    surface_picture picture(size.width, size.height, 1);
    const double surface = l3d_light_of_level(std::round(25.5 + 100.25));
    int between = 0;
    for (int n = 0; n < 300; ++n) {
        // From below the picture to above it, and back.
        scan_point a{number(0, 256 * size.width), 256 * size.height + number(3000, 6000)};
        scan_point b{number(0, 256 * size.width), -number(3000, 6000)};
        if (n % 2 != 0)
            std::swap(a, b);
        const int rows = number(1, 12);
        if (a.y - b.y == 0 || (a.y - b.y) % rows != 0 || (a.x - b.x) % rows != 0)
            b.y = a.y + (b.y - a.y) / rows * rows, b.x = a.x + (b.x - a.x) / rows * rows;
        draw(picture, {folded_at(a, b, rows)}, antialiased(l3d_shade::levels));
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const double area = area_right_of(a, b, x, y);
                between += area > 0.01 && area < 0.99;
                const double shown = l3d_light_of_level(picture.word(x, y) & 255) / surface;
                // Samples may be wrong by 3.4/64, and half a level of 126 is 2.4 / 2 / 126 of its
                // light.
                ASSERT_NEAR(shown, area, 3.4 / 64 + 1.0 / 100) << n << ": " << x << ", " << y;
            }
    }
    EXPECT_GT(between, 5000);
}

TEST(Refine, AGapBetweenCentresShowsWhatIsInIt) {
    surface_picture picture(24, 16, 1);
    // Between two folds, which are nearest to the eye: a quarter of column 10, not its middle.
    constexpr std::int32_t left = 10 * 256 + 160, right = 10 * 256 + 224;
    const auto behind = [](std::int32_t x, std::int32_t y) {
        return l3d_micro_vertex{x, y, 0.3f, {24.5f, 0, 0}};
    };
    surface_parts parts{folded_at({left, -1000}, {left, 5000}, 1, 0.7f),
                        folded_at({right, 5000}, {right, -1000}, 1, 0.7f)};
    // Behind them is the background, or a surface.
    for (const double seen : {0.0, l3d_light_of_level(50)}) {
        draw(picture, parts, antialiased(l3d_shade::levels));
        const double light = 0.75 * l3d_light_of_level(126) + 0.25 * seen;
        for (int y = 0; y < picture.size.height; ++y)
            EXPECT_NEAR(picture.word(10, y) & 255, l3d_level_of_light(light), 1) << y;
        parts.push_back(part_of(
            {behind(-256, -256), behind(6400, -256), behind(6400, 4400), behind(-256, 4400)}));
    }
}

/// Errors in levels, of pixels that outlines pass.
struct level_errors {
    double sum = 0, largest = 0;
    int pixels = 0;

    double rms() const { return std::sqrt(sum / pixels); }
};

/// Tubes of some radius, seen from 24 sides, beside the slow twin.
level_errors errors_of_tubes(double radius, double wider) {
    constexpr l3d_size size{64, 48};
    surface_picture picture(size.width, size.height, 1);
    level_errors errors;
    for (int n = 0; n < 24; ++n) {
        const surface_parts scene{tube(0.1 + n * 0.26, radius + n % 5 * wider, (n % 3 - 1) * 0.7)};
        draw(picture, scene, antialiased(l3d_shade::levels));
        slow_picture slow(scene, size, l3d_shade::levels);
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                const auto exact = slow.at(x, y);
                if (exact.darkest > 0 || exact.brightest == 0)
                    continue;
                const double error = std::abs(int(picture.word(x, y) & 255) - exact.level);
                ++errors.pixels;
                errors.sum += error * error;
                errors.largest = std::max(errors.largest, error);
            }
    }
    return errors;
}

/// The light of a tube changes by up to 40 levels from pixel to pixel beside its outlines. Limits
/// are 1.2 times what was measured.
TEST(Refine, SteepLevelsBesideAFoldAreThoseOfTheSlowTwin) {
    const level_errors wide = errors_of_tubes(8, 3);
    EXPECT_GT(wide.pixels, 3000);
    EXPECT_LT(wide.rms(), 1.85);
    EXPECT_LT(wide.largest, 20);
    // So thin that a pixel's neighbours tell little of it.
    const level_errors thin = errors_of_tubes(1.5, 0.5);
    EXPECT_GT(thin.pixels, 3000);
    EXPECT_LT(thin.rms(), 4.1);
    EXPECT_LT(thin.largest, 36);
}

TEST(Refine, LevelsComeBackFromLight) {
    const l3d_detail::linear_light& tables = l3d_detail::linear_light_tables();
    for (std::uint32_t level = 0; level < 256; ++level)
        EXPECT_EQ(tables.level(tables.light(level)), level);
    for (int i = 0; i < 2550; ++i) {
        const double level = i / 10.0;
        if (i % 10 == 5)
            continue;
        EXPECT_EQ(tables.level(float(l3d_light_of_level(level))), std::uint32_t(level + 0.5)) << i;
    }
}

TEST(Refine, SamplesTellAreasOfHalfPlanes) {
    using l3d_detail::the_samples;
    double largest = 0;
    for (int direction = 0; direction < 180; ++direction) {
        const double angle = direction * 3.14159265358979 / 180;
        const double nx = std::cos(angle), ny = std::sin(angle);
        for (int step = -70; step <= 70; ++step) {
            const double at = step / 100.0; // of the line from the pixel's middle
            int inside = 0;
            for (std::size_t i = 0; i < the_samples.count; ++i)
                inside += nx * ((the_samples.x[i] + 0.5) / 16 - 0.5) +
                              ny * ((the_samples.y[i] + 0.5) / 16 - 0.5) <
                          at;
            constexpr int fine_rows = 2000;
            double area = 0;
            for (int row = 0; row < fine_rows; ++row) {
                // Along the axis that the line crosses, so that nothing is divided by 0.
                const bool along_x = std::abs(nx) > std::abs(ny);
                const double other = (row + 0.5) / fine_rows - 0.5;
                const double slope = along_x ? nx : ny, rest = along_x ? ny : nx;
                const double end = (at - rest * other) / slope;
                const double below = std::clamp(end + 0.5, 0.0, 1.0);
                area += (slope > 0 ? below : 1 - below) / fine_rows;
            }
            largest = std::max(largest, std::abs(inside / double(the_samples.count) - area));
        }
    }
    EXPECT_LT(largest, 3.6 / 64);
}

} // namespace
