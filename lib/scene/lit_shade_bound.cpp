// SPDX-License-Identifier: MIT
// l3d_lit_shade_bound: adds the errors of all lights, and takes the worst material.
#include "scene/lit_shade_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace {

using direction = std::array<double, 3>;

/// The error of normals that are rounded to 16383rds, 2^-14.2, and computed in floats. Floats err
/// as in shade levels, divided by 229.5. In shade levels they err by 20 * 2^-24 of numbers up to
/// 2^8, times the cancellation of terms.
constexpr double rounded_normal = 5.3e-5 + 4.4e-5;

/// The error of a colour channel that is rounded to a whole level, and computed in floats.
constexpr double rounded_level = 0.5 + 0.01;

/// Powers of a cosine that are smaller than this are left out of a highlight.
constexpr double least_power = 0x1p-12;

constexpr double white = 255, scattered_part = 0.9;

double length_of(const direction& v) {
    return std::hypot(v[0], v[1], v[2]);
}

direction way_at(const l3d_shading& shading, double x, double y) {
    direction way;
    for (std::size_t k = 0; k < way.size(); ++k)
        way[k] = double{shading.look[k]} + x * double{shading.look_right[k]} +
                 y * double{shading.look_down[k]};
    return way;
}

double angle_of(const direction& a, const direction& b) {
    const double product = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    return std::acos(std::clamp(product / (length_of(a) * length_of(b)), -1.0, 1.0));
}

/// The steepest slope of max(0, cos)^k over the angle. Units: per radian.
double steepest(double k) {
    return k > 1 ? std::sqrt(k) * std::pow(1 - 1 / k, (k - 1) / 2) : 1;
}

/// A cone around the picture's middle that holds all directions in which the picture looks.
struct seen_cone {
    direction middle;
    double half_angle = 0;

    seen_cone(const l3d_shading& shading, l3d_size size)
        : middle(way_at(shading, size.width / 2.0, size.height / 2.0)) {
        for (const double x : {0, size.width})
            for (const double y : {0, size.height})
                half_angle = std::max(half_angle, angle_of(middle, way_at(shading, x, y)));
    }

    /// The largest angle between the direction to a light and the direction to the eye, at any
    /// place of the picture.
    double most_apart(const std::array<float, 3>& light) const {
        const direction from_eye{-double{light[0]}, -double{light[1]}, -double{light[2]}};
        return std::min(angle_of(middle, from_eye) + half_angle, std::numbers::pi);
    }
};

/// Bound of the error of a highlight of strength 1 and sharpness k. `apart` is the largest angle
/// between the directions to the light and to the eye; `way` is the error of the latter. Units:
/// angles in radians.
double highlight_off(double k, double apart, double normal_angle, double way) {
    // The least length of the sum of both unit directions: their bisector turns by way / length.
    const double least_sum = 2 * std::cos(std::min(apart + way, std::numbers::pi) / 2);
    if (!(least_sum > 0))
        return 1;
    const double half_way = way / least_sum;
    const double setting = std::pow(std::sin((apart + way) / 2), k);
    // Cosines are off by 16 roundings of sums that may cancel, powers by k more.
    const double rounding = 16 * 0x1p-24 / (least_sum * least_sum) + 4 * 0x1p-24;
    return std::min(steepest(k) * (normal_angle + half_way) + setting + k * rounding + least_power,
                    1.0);
}

} // namespace

double l3d_lit_shade_bound(const l3d_shading& shading, std::span<const l3d_material> materials,
                           l3d_size size, const l3d_lit_errors& errors) {
    const seen_cone seen(shading, size);
    const double normal_angle = std::asin(std::min(errors.normal + rounded_normal, 1.0));
    const l3d_material usual;
    if (materials.empty())
        materials = {&usual, 1};
    const l3d_lighting& lighting = shading.lighting;
    double most = 0;
    for (const l3d_material& material : materials)
        for (const int shift : {16, 8, 0}) {
            const std::size_t channel = static_cast<std::size_t>(2 - shift / 8);
            const double color = material.color >> shift & 255;
            const double highlight = material.highlight >> shift & 255;
            double off = rounded_level;
            const auto add = [&](const l3d_far_light& light) {
                const double of_highlight =
                    highlight > 0
                        ? highlight_off(material.sharpness, seen.most_apart(light.direction),
                                        normal_angle, errors.way)
                        : 0;
                off += double{light.color[channel]} *
                       (color * scattered_part * normal_angle + highlight * of_highlight);
            };
            add({shading.light, lighting.color});
            for (std::size_t i = 0; i < lighting.count; ++i)
                add(lighting.lights[i]);
            most = std::max(most, off);
        }
    return std::min(most, white);
}
