// SPDX-License-Identifier: MIT
// Means over pixels against areas that are known.
#include "reference/box_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <vector>

namespace reference {
namespace {

struct corner {
    long double x = 0, y = 0;
};
using polygon = std::vector<corner>;

/// Of a control point in its net.
double row_of(std::size_t k) {
    const std::size_t row = k / 4;
    return static_cast<double>(row);
}
double column_of(std::size_t k) {
    return static_cast<double>(k % 4);
}

/// The part on that side of the line a x + b y = c where a x + b y is less.
polygon below(const polygon& whole, long double a, long double b, long double c) {
    polygon result;
    for (std::size_t k = 0; k < whole.size(); ++k) {
        const corner &p = whole[k], &q = whole[(k + 1) % whole.size()];
        const long double at_p = a * p.x + b * p.y - c, at_q = a * q.x + b * q.y - c;
        if (at_p <= 0)
            result.push_back(p);
        if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
            const long double t = at_p / (at_p - at_q);
            result.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
        }
    }
    return result;
}

double area(const polygon& of) {
    long double twice = 0;
    for (std::size_t k = 0; k < of.size(); ++k) {
        const corner &p = of[k], &q = of[(k + 1) % of.size()];
        twice += p.x * q.y - p.y * q.x;
    }
    return static_cast<double>(std::abs(twice) / 2);
}

polygon in_pixel(const polygon& whole, int x, int y) {
    return below(below(below(below(whole, -1, 0, -x), 1, 0, x + 1), 0, -1, -y), 0, 1, y + 1);
}

/// The plane z = 0 is the picture: a unit is a pixel, its centre the origin.
constexpr picture_size flat_size{40, 30};
const camera flat_view{
    {0, 0, 1000}, {0, 0, 0}, {0, 1, 0}, 2 * std::atan(0.015) * 180 / std::numbers::pi, 0.1};
constexpr vec3 flat_light{0.6, 0, 0.8};

/// A rectangle about (x, y), its sides a and b long, turned by an angle; z = slope of x.
struct sheet {
    double x = 0, y = 0, a = 1, b = 1, angle = 0, slope = 0;

    patch surface() const {
        patch result;
        for (std::size_t k = 0; k < 16; ++k) {
            const double s = a * (column_of(k) / 3 - 0.5);
            const double t = b * (row_of(k) / 3 - 0.5);
            const double px = x + s * std::cos(angle) - t * std::sin(angle);
            result.points[k] = {px, y + s * std::sin(angle) + t * std::cos(angle), slope * px};
        }
        return result;
    }

    /// In the picture, of the flat camera.
    polygon outline() const {
        polygon result;
        const patch of = surface();
        const camera_frame frame(flat_view, flat_size);
        for (const std::size_t k : {0u, 3u, 15u, 12u}) {
            const vec3& p = of.points[k];
            const homogeneous_point h = frame.project({p.x, p.y, p.z});
            result.push_back({h.x / h.w, h.y / h.w});
        }
        return result;
    }

    double light() const {
        const double size = std::sqrt(1 + slope * slope);
        const double cosine = (flat_light.z - slope * flat_light.x) / size;
        return light_of_level(255 * (0.1 + 0.9 * std::max(0.0, cosine)));
    }
};

struct agreement {
    double largest = 0; ///< error, levels
    double unsure = 0;  ///< the largest
    int partly = 0;     ///< pixels that are covered in part
};

/// Flat sheets that do not lie behind each other, pixel by pixel against their areas.
agreement compare(const std::vector<sheet>& sheets, const box_settings& settings = {}) {
    std::vector<patch> patches;
    patches.reserve(sheets.size());
    for (const sheet& each : sheets)
        patches.push_back(each.surface());
    const box_image image(patches, flat_view, flat_size, flat_light, settings);
    agreement result;
    for (int y = 0; y < flat_size.height; ++y)
        for (int x = 0; x < flat_size.width; ++x) {
            double share = 0, light = 0;
            for (const sheet& each : sheets) {
                const double part = area(in_pixel(each.outline(), x, y));
                share += part;
                light += part * each.light();
            }
            light += (1 - share) * light_of_level(settings.background);
            const box_pixel& found = image.at(x, y);
            const double off = std::abs(found.level - level_of_light(light));
            EXPECT_LE(off, found.unsure) << x << ", " << y;
            EXPECT_NEAR(found.covered, share, 1e-4) << x << ", " << y;
            result.largest = std::max(result.largest, off);
            result.unsure = std::max(result.unsure, found.unsure);
            result.partly += share > 1e-12 && share < 1 - 1e-12;
        }
    return result;
}

void print(const char* name, const agreement& found) {
    std::printf("%-18s %4d pixels in part, off by %.4f levels, sure to %.4f\n", name, found.partly,
                found.largest, found.unsure);
}

TEST(level_of_light, is_the_inverse_of_light_of_level) {
    for (int level = 0; level <= 255; ++level)
        EXPECT_NEAR(level_of_light(light_of_level(level)), level, 1e-4); // the pieces' own gap
    EXPECT_NEAR(light_of_level(128), 0.2158605, 1e-7);                   // from the standard
}

TEST(box_image, of_a_turned_square_is_its_area) {
    for (const double angle : {0.0, 0.01, 0.3, 0.7, std::numbers::pi / 4})
        for (const double background : {0.0, 120.0}) {
            const agreement found =
                compare({{0.123, 0.077, 17.3, 13.1, angle}}, {.background = background});
            print("turned square", found);
            EXPECT_GT(found.partly, 40);
            EXPECT_LT(found.unsure, 0.5);
            EXPECT_LT(found.largest, 0.4);
        }
}

TEST(box_image, of_sheets_smaller_than_a_pixel_is_their_area) {
    const agreement found = compare({{0.43, 0.61, 0.4, 0.3, 0.2},
                                     {5.02, 3.98, 0.2, 0.2, 0.9},
                                     {-7.3, 2.2, 0.13, 0.5, 1.3},
                                     {-7.3, -4.7, 0.1, 0.1, 0}});
    print("small sheets", found);
    EXPECT_GE(found.partly, 7);
    EXPECT_LT(found.unsure, 1);
}

TEST(box_image, of_a_thin_strip_is_its_area) {
    for (const double width : {0.1, 0.001})
        for (const double angle : {0.0, 0.02, 0.5, std::numbers::pi / 2}) {
            const agreement found = compare({{0.05, 0.32, 18, width, angle}});
            print("thin strip", found);
            EXPECT_GE(found.partly, 18);
            EXPECT_LT(found.unsure, 1);
        }
}

/// A tube that comes out of a sheet: x = 9 a u (1 - u) (1 - 2 u) and z = 3 d u (1 - u) across it,
/// so it folds over where its tangent stands upright, sqrt(3) a apart. Its borders meet at z = 0,
/// and are hidden by the sheet.
struct tube {
    double a = 0.012, d = 0.05, length = 12, angle = 0;

    patch surface() const {
        patch result;
        for (std::size_t k = 0; k < 16; ++k) {
            const double s = std::array{0.0, 3 * a, -3 * a, 0.0}[k % 4];
            const double t = length * (row_of(k) / 3 - 0.5);
            result.points[k] = {s * std::cos(angle) - t * std::sin(angle) + 0.37,
                                s * std::sin(angle) + t * std::cos(angle) + 0.21,
                                d * std::array{0.0, 1.0, 0.5, 0.0}[k % 4]};
        }
        return result;
    }

    polygon outline() const {
        const sheet flat{0.37, 0.21, std::sqrt(3.0) * a, length, angle, 0};
        return flat.outline();
    }

    double mean_light() const {
        constexpr int steps = 10000;
        const double first = (1 - 1 / std::sqrt(3.0)) / 2;
        double light = 0, width = 0;
        for (int k = 0; k < steps; ++k) {
            const double u = first + (1 - 2 * first) * (k + 0.5) / steps;
            const double dx = 9 * a * (1 - 6 * u + 6 * u * u),
                         dz = 1.5 * d * (2 - 6 * u + 3 * u * u);
            const double cosine =
                (dz * std::cos(angle) * flat_light.x - dx * flat_light.z) / std::hypot(dx, dz);
            light += -dx * light_of_level(255 * (0.1 + 0.9 * std::max(0.0, cosine)));
            width += -dx;
        }
        return light / width;
    }
};

TEST(box_image, of_a_thin_tube_without_borders_is_its_area) {
    const sheet behind{0, 0, 40, 30, 0.1, 0};
    for (const double angle : {0.0, 0.4, 1.1, std::numbers::pi / 2}) {
        const tube thin{.angle = angle};
        std::vector<patch> patches{behind.surface(), thin.surface()};
        for (vec3& p : patches[0].points)
            p.z = thin.d / 5;
        const box_image image(patches, flat_view, flat_size, flat_light);
        double largest = 0, unsure = 0, contrast = 0;
        for (int y = 6; y < 24; ++y)
            for (int x = 8; x < 32; ++x) {
                const double part = area(in_pixel(thin.outline(), x, y));
                const double light = part * thin.mean_light() + (1 - part) * behind.light();
                const box_pixel& found = image.at(x, y);
                const double off = std::abs(found.level - level_of_light(light));
                // Perspective moves what stands out by 1000 / (1000 - z), 0.05 levels here.
                EXPECT_LE(off, found.unsure + 0.05) << angle << ": " << x << ", " << y;
                largest = std::max(largest, off);
                unsure = std::max(unsure, found.unsure);
                contrast = std::max(
                    contrast, std::abs(level_of_light(light) - level_of_light(behind.light())));
            }
        std::printf("thin tube: changes %.3f levels, off by %.4f, sure to %.4f\n", contrast,
                    largest, unsure);
        EXPECT_GT(contrast, 0.3) << angle;
        EXPECT_LT(unsure, 0.5) << angle;
    }
}

/// z = x / 2 and z = 0 cross where x = 0. What is nearer is seen: the slanted one to the right.
TEST(box_image, of_sheets_that_cross_is_that_of_their_visible_parts) {
    const double shift = 0.3; // of the crossing, within a pixel
    const sheet flat{shift, 0.2, 20, 10, 0, 0}, slanted{shift, 0.1, 16, 8, 0, 0.5};
    std::vector<patch> patches{flat.surface(), slanted.surface()};
    for (vec3& p : patches[1].points)
        p.z -= 0.5 * shift;
    const box_image image(patches, flat_view, flat_size, flat_light);
    const camera_frame frame(flat_view, flat_size);
    const homogeneous_point seam = frame.project({shift, 0, 0});
    polygon front;
    for (const std::size_t k : {0u, 3u, 15u, 12u}) {
        const vec3& p = patches[1].points[k];
        const homogeneous_point h = frame.project({p.x, p.y, p.z});
        front.push_back({h.x / h.w, h.y / h.w});
    }
    front = below(front, -1, 0, -seam.x / seam.w);
    double unsure = 0;
    for (int y = 0; y < flat_size.height; ++y)
        for (int x = 0; x < flat_size.width; ++x) {
            const double before = area(in_pixel(front, x, y));
            const double all = area(in_pixel(flat.outline(), x, y));
            const double light = before * slanted.light() + (all - before) * flat.light();
            const box_pixel& found = image.at(x, y);
            EXPECT_NEAR(found.level, level_of_light(light), found.unsure) << x << ", " << y;
            unsure = std::max(unsure, found.unsure);
        }
    EXPECT_LT(unsure, 0.5);
}

/// A strip 0.05 px wide between two samples is an arch: z = 0.075 (1 - s s) for s from -1 to 1, so
/// both its sides are equally dark, and its middle is light.
TEST(box_image, of_a_thin_arch_is_not_what_its_sides_are) {
    constexpr double half = 0.025, height = 0.075, x0 = 0.53, length = 12;
    patch arch;
    for (std::size_t k = 0; k < 16; ++k)
        arch.points[k] = {x0 + half * (2 * column_of(k) / 3 - 1), length * (row_of(k) / 3 - 0.5),
                          k % 4 == 1 || k % 4 == 2 ? height * 4 / 3 : 0};
    const std::vector<patch> patches{arch};
    const box_image image(patches, flat_view, flat_size, {0, 0, 1});
    constexpr int steps = 1000;
    double light = 0;
    for (int k = 0; k < steps; ++k) {
        const double slope = 2 * height / half * ((2 * k + 1.0) / steps - 1);
        light += light_of_level(255 * (0.1 + 0.9 / std::hypot(1.0, slope))) / steps;
    }
    const double wanted = level_of_light(2 * half * light);
    for (int y = 10; y < 20; ++y) {
        const box_pixel& found = image.at(20, y);
        EXPECT_NEAR(found.level, wanted, found.unsure + 0.01); // of perspective
        EXPECT_LT(found.unsure, 0.5);
    }
}

/// A dome 2 px wide and high comes through a sheet, in a spot 0.2 px wide that all coarse samples
/// miss: z = 2 (1 - x x) (1 - y y), the sheet at z = 1.98.
TEST(box_image, of_a_spot_between_the_samples_is_not_passed_over) {
    constexpr double x0 = 0.62, y0 = 0.38, height = 2, cut = 1.98;
    patch dome;
    for (std::size_t k = 0; k < 16; ++k) {
        const auto bulge = [](std::size_t i) { return i % 3 == 0 ? 0 : 4.0 / 3; };
        dome.points[k] = {x0 + column_of(k) * 2 / 3 - 1, y0 + row_of(k) * 2 / 3 - 1,
                          height * bulge(k % 4) * bulge(k / 4)};
    }
    const sheet flat{0, 0, 30, 20, 0, 0};
    std::vector<patch> patches{dome, flat.surface()};
    for (vec3& p : patches[1].points)
        p.z = cut;
    const box_image image(patches, flat_view, flat_size, flat_light);
    constexpr int steps = 400;
    double light = 0;
    for (int k = 0; k < steps * steps; ++k) {
        const int column = k % steps, row = k / steps;
        const double x = (column + 0.5) / steps - 0.5, y = (row + 0.5) / steps - 0.5;
        if (height * (1 - x * x) * (1 - y * y) < cut) {
            light += flat.light();
            continue;
        }
        const double nx = 2 * height * x * (1 - y * y), ny = 2 * height * y * (1 - x * x);
        const double cosine =
            (nx * flat_light.x + ny * flat_light.y + flat_light.z) / std::hypot(nx, ny, 1.0);
        light += light_of_level(255 * (0.1 + 0.9 * std::max(0.0, cosine)));
    }
    const double wanted = level_of_light(light / (steps * steps));
    EXPECT_GT(std::abs(wanted - level_of_light(flat.light())), 0.1);
    const box_pixel& found = image.at(20, 14);
    EXPECT_NEAR(found.level, wanted, found.unsure + 0.01);
    EXPECT_LT(found.unsure, 0.5);
    std::printf("spot: changes %.3f levels, off by %.4f, sure to %.4f\n",
                wanted - level_of_light(flat.light()), found.level - wanted, found.unsure);
}

} // namespace
} // namespace reference
