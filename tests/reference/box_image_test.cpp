// SPDX-License-Identifier: MIT
// Means over pixels against areas that are known, and against brute force.
#include "reference/box_image.h"
#include "reference/views.h"

#include <gtest/gtest.h>

#include <algorithm>
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
            const double s = a * (static_cast<double>(k % 4) / 3 - 0.5);
            const double t = b * (static_cast<double>(k / 4) / 3 - 0.5);
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
            EXPECT_NEAR(found.covered, share, 5e-3) << x << ", " << y;
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
    for (const double angle : {0.0, 0.02, 0.5, 1.2}) {
        const agreement found = compare({{0.05, 0.32, 18, 0.1, angle}});
        print("thin strip", found);
        EXPECT_GE(found.partly, 18);
        EXPECT_LT(found.unsure, 1);
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

} // namespace
} // namespace reference
