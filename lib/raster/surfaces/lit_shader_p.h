// SPDX-License-Identifier: MIT
// lit_shader: the light of several lamps, and highlights, from a unit normal in every pixel.
#ifndef L3D_RASTER_SURFACES_LIT_SHADER_P_H
#define L3D_RASTER_SURFACES_LIT_SHADER_P_H

#include "geom/material.h"
#include "raster/surfaces/surface_shader_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// The colour of a surface by l3d_lighting. In mode `flat` a polygon has one normal, the sum of its
/// corners'; the eye and highlights are each pixel's own.
class lit_shader {
public:
    /// The normal, how far it points away from the eye, and the way from the eye.
    static constexpr std::size_t components = 7;

    /// Lives: borrows both.
    lit_shader(const l3d_shading& shading, std::span<const l3d_material> materials)
        : shading_(shading), materials_(materials) {}

    /// What polygons are made of from now on: a place among the materials, if there are any.
    void use_material(std::uint32_t index) {
        if (!materials_.empty())
            material_ = materials_[index];
    }

    void begin_polygon(std::span<const l3d_micro_vertex> corners) {
        if (shading_.mode != l3d_shade::flat)
            return;
        sum_ = {0, 0, 0, 0};
        for (const l3d_micro_vertex& vertex : corners) {
            std::array<float, 4> of;
            put_normal(vertex, shading_, of.data());
            for (std::size_t i = 0; i < sum_.size(); ++i)
                sum_[i] += of[i];
        }
    }

    void corner(const l3d_micro_vertex& vertex, float* out) const {
        if (shading_.mode == l3d_shade::flat)
            std::copy(sum_.begin(), sum_.end(), out);
        else
            put_normal(vertex, shading_, out);
        const float x = static_cast<float>(vertex.x) / l3d_subpixel_one;
        const float y = static_cast<float>(vertex.y) / l3d_subpixel_one;
        for (std::size_t i = 0; i < 3; ++i)
            out[4 + i] = shading_.look[i] + x * shading_.look_right[i] + y * shading_.look_down[i];
    }

    std::uint32_t word(const float* at) const {
        const float length = std::sqrt(safe_square(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]));
        const float side = (at[3] > 0 ? -1.0F : 1.0F) / length;
        const vector3 normal{side * at[0], side * at[1], side * at[2]};
        const vector3 to_eye = unit({-at[4], -at[5], -at[6]});
        const l3d_lighting& lighting = shading_.lighting;
        l3d_light_color scattered = lighting.ambient, mirrored{};
        add_light({shading_.light, lighting.color}, normal, to_eye, scattered, mirrored);
        for (std::size_t i = 0; i < lighting.count; ++i)
            add_light(lighting.lights[i], normal, to_eye, scattered, mirrored);
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const int shift = 16 - 8 * static_cast<int>(i);
            const auto part = [&](std::uint32_t color) {
                return static_cast<float>(color >> shift & 255);
            };
            const float level =
                part(material_.color) * scattered[i] + part(material_.highlight) * mirrored[i];
            const float held = level > 0 ? (level < 255 ? level : 255.0F) : 0.0F;
            word = word << 8 | static_cast<std::uint32_t>(held + 0.5F);
        }
        return word;
    }

private:
    static vector3 unit(const vector3& v) {
        const float length = std::sqrt(safe_square(dot(v, v.data())));
        return {v[0] / length, v[1] / length, v[2] / length};
    }

    /// By squares, so that no library's approximation decides a bit.
    static float whole_power(float base, int exponent) {
        float result = 1;
        for (; exponent > 0; exponent >>= 1, base *= base)
            if (exponent & 1)
                result *= base;
        return result;
    }

    void add_light(const l3d_far_light& light, const vector3& normal, const vector3& to_eye,
                   l3d_light_color& scattered, l3d_light_color& mirrored) const {
        const float lit = dot(light.direction, normal.data());
        if (!(lit > 0))
            return;
        const vector3 half = unit({light.direction[0] + to_eye[0], light.direction[1] + to_eye[1],
                                   light.direction[2] + to_eye[2]});
        const float facing = std::max(dot(half, normal.data()), 0.0F);
        const float peak =
            material_.highlight == 0 ? 0.0F : whole_power(facing, material_.sharpness);
        for (std::size_t i = 0; i < scattered.size(); ++i) {
            scattered[i] += 0.9F * lit * light.color[i];
            mirrored[i] += peak * light.color[i];
        }
    }

    const l3d_shading& shading_;
    std::span<const l3d_material> materials_;
    l3d_material material_;
    std::array<float, 4> sum_{};
};

} // namespace l3d_detail

#endif
