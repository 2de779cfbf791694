// SPDX-License-Identifier: MIT
// lit_shader: the light of several lamps, and highlights, from a unit normal in every pixel.
#ifndef L3D_RASTER_SHADERS_LIT_SHADER_P_H
#define L3D_RASTER_SHADERS_LIT_SHADER_P_H

#include "geom/material.h"
#include "raster/shaders/normal_code_p.h"
#include "raster/shaders/surface_shader_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

namespace l3d_detail {

/// A material, prepared for computing light: its colours are levels from 0 to 255.
struct lit_material {
    vector3 color{255, 255, 255}, highlight{};
    int sharpness = 1;

    /// The limit of the square of a highlight's cosine, below which the highlight is left out.
    /// Below it, the power of the cosine is too small to be seen, and slow to compute. The power is
    /// less than 2^-12, or for a large sharpness k less than exp(-e), since (1 - e / k)^k <
    /// exp(-e).
    float least_square = 0;

    lit_material() = default;
    explicit lit_material(const l3d_material& from) : sharpness(from.sharpness) {
        constexpr float least = 0x1p-12F, e = 11.1F;
        const float cosine = std::max(least, 1 - e / static_cast<float>(sharpness));
        least_square = cosine * cosine;
        color = levels(from.color);
        highlight = levels(from.highlight);
    }

    void use_color(std::uint32_t word) { color = levels(word); }

    bool shines() const { return highlight != vector3{}; }

private:
    static vector3 levels(std::uint32_t word) {
        return {static_cast<float>(word >> 16 & 255), static_cast<float>(word >> 8 & 255),
                static_cast<float>(word & 255)};
    }
};

/// Colours surfaces by the formula of l3d_lighting. In mode `flat` a polygon has one normal, the
/// sum of its corners' normals; the eye and highlights are computed for each pixel.
class lit_shader {
public:
    /// The numbers that are interpolated between corners: the normal, own_way() and the depth.
    static constexpr std::size_t components = 7;
    static constexpr bool interpolates_normals = true;

    /// Lives: borrows shading and materials.
    lit_shader(const l3d_shading& shading, std::span<const l3d_material> materials)
        : shading_(shading), materials_(materials), turns_(turns_normals(shading)) {}

    /// Whether a frame's normals must be turned to the eye in each pixel.
    static bool turns_normals(const l3d_shading& shading) {
        return shading.mode != l3d_shade::flat && shading.ray != vector3{};
    }

    /// Sets the material of the next polygons by its index, if the frame has materials.
    void use_material(std::uint32_t index) {
        if (!materials_.empty())
            material_ = lit_material(materials_[index]);
    }

    void begin_polygon(std::span<const l3d_micro_vertex> corners) {
        const auto by_depth = [](const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
            return a.inv_w < b.inv_w;
        };
        const auto [farthest, nearest] = std::ranges::minmax_element(corners, by_depth);
        farthest_ = farthest->inv_w;
        nearest_ = nearest->inv_w;
        if (shading_.mode != l3d_shade::flat)
            return;
        std::array<float, 4> sum{};
        for (const l3d_micro_vertex& vertex : corners) {
            std::array<float, 4> of;
            put_normal(vertex, shading_, of.data());
            for (std::size_t i = 0; i < sum.size(); ++i)
                sum[i] += of[i];
        }
        const float side = sum[3] > 0 ? -1.0F : 1.0F;
        normal_ = {side * sum[0], side * sum[1], side * sum[2]};
    }

    void corner(const l3d_micro_vertex& vertex, float* out) const {
        std::copy_n(shading_.mode == l3d_shade::flat ? normal_.data() : vertex.normal, 3, out);
        const float x = static_cast<float>(vertex.x) / l3d_subpixel_one;
        const float y = static_cast<float>(vertex.y) / l3d_subpixel_one;
        const vector3 own = own_way(shading_, x, y);
        std::copy(own.begin(), own.end(), out + 3);
        out[6] = vertex.inv_w;
    }

    static bool is_parallel(const l3d_shading& shading) { return shading.depth_step != 0; }

    /// The part of the ray from the eye that differs from pixel to pixel. It is the shading's
    /// `look` in perspective, and its `aside` in a parallel projection.
    static vector3 own_way(const l3d_shading& shading, float x, float y) {
        const bool parallel = is_parallel(shading);
        const vector3 &at = parallel ? shading.aside : shading.look,
                      &right = parallel ? shading.aside_right : shading.look_right,
                      &down = parallel ? shading.aside_down : shading.look_down;
        vector3 own;
        for (std::size_t i = 0; i < own.size(); ++i)
            own[i] = at[i] + y * down[i] + x * right[i];
        return own;
    }

    /// Sets another colour than the material's, 0x00RRGGBB, until use_material is called again.
    void use_color(std::uint32_t color) { material_.use_color(color); }

    /// The pixel word of a pixel's interpolated numbers. lit_words computes the same in lanes,
    /// operation by operation.
    std::uint32_t word(const float* at) const {
        const vector3 raw{at[0], at[1], at[2]}, own{at[3], at[4], at[5]};
        const vector3 look = is_parallel(shading_) ? shading_.look : own;
        const float inverse = 1 / length(raw);
        const float side = turns_ && dot(raw, look.data()) > 0 ? -inverse : inverse;
        const seen_normal seen({raw[0] * side, raw[1] * side, raw[2] * side}, look);
        const l3d_lighting& lighting = shading_.lighting;
        l3d_light_color scattered = lighting.ambient, mirrored{};
        add_light({shading_.light, 1, lighting.color}, seen, scattered, mirrored);
        for (std::size_t i = 0; i < lighting.count; ++i) {
            const l3d_far_light& light = lighting.lights[i];
            add_light({light.direction, 1, light.color}, seen, scattered, mirrored);
        }
        if (lighting.point_count > 0) {
            const vector3 place = place_of(own, std::clamp(at[6], farthest_, nearest_));
            for (std::size_t i = 0; i < lighting.point_count; ++i)
                add_light(light_at(lighting.points[i], place), seen, scattered, mirrored);
        }
        std::uint32_t word = 0;
        for (std::size_t i = 0; i < scattered.size(); ++i) {
            const float level =
                material_.color[i] * scattered[i] + material_.highlight[i] * mirrored[i];
            const float held = level > 0 ? (level < 255 ? level : 255.0F) : 0.0F;
            word = word << 8 | static_cast<std::uint32_t>(held + 0.5F);
        }
        return word;
    }

private:
    static float length(const vector3& v) { return std::sqrt(safe_square(dot(v, v.data()))); }

    /// A unit normal of a surface, and the ray from the eye to the normal's place.
    struct seen_normal {
        vector3 normal, look;
        float distance, against; ///< the ray's length, and the product of ray and normal

        seen_normal(const vector3& n, const vector3& e)
            : normal(n), look(e), distance(length(e)), against(dot(e, n.data())) {}
    };

    /// A light as it is seen from a place: its direction and its brightness.
    struct seen_light {
        vector3 direction;
        float strength;
        const l3d_light_color& color;
    };

    /// The place that a pixel shows, relative to the eye.
    vector3 place_of(const vector3& own, float depth) const {
        const float along = shading_.distance(depth) / shading_.look_depth;
        vector3 place;
        for (std::size_t i = 0; i < place.size(); ++i)
            place[i] = is_parallel(shading_) ? own[i] + along * shading_.look[i] : along * own[i];
        return place;
    }

    seen_light light_at(const l3d_point_light& light, const vector3& place) const {
        vector3 way;
        for (std::size_t i = 0; i < way.size(); ++i)
            way[i] = static_cast<float>(light.position[static_cast<int>(i)] - shading_.eye[i]) -
                     place[i];
        const float square = safe_square(dot(way, way.data())), inverse = 1 / std::sqrt(square);
        return {{way[0] * inverse, way[1] * inverse, way[2] * inverse},
                light.strength(square),
                light.color};
    }

    /// The power of a cosine, by repeated squares, so that results do not depend on a library's
    /// approximation.
    static float whole_power(float base, int exponent) {
        float result = 1;
        for (;; base *= base) {
            if (exponent & 1)
                result *= base;
            exponent >>= 1;
            if (exponent == 0)
                return result;
        }
    }

    /// Adds a light from direction l. A highlight needs the direction half-way between l and the
    /// eye. With the ray e from the eye, the half-way direction is that of h = l |e| - e. Then h.h
    /// = 2 |e| (|e| - l.e), and n.h = |e| n.l - n.e for the normal n.
    void add_light(const seen_light& light, const seen_normal& seen, l3d_light_color& scattered,
                   l3d_light_color& mirrored) const {
        const float lit = dot(light.direction, seen.normal.data());
        if (!(lit > 0))
            return;
        for (std::size_t i = 0; i < scattered.size(); ++i)
            scattered[i] += 0.9F * lit * light.strength * light.color[i];
        if (!material_.shines())
            return;
        const float product = seen.distance * lit - seen.against;
        const float beside = seen.distance - dot(light.direction, seen.look.data());
        const float square = safe_square((seen.distance + seen.distance) * beside);
        if (!(product > 0 && product * product > material_.least_square * square))
            return;
        const float facing = std::min(product / std::sqrt(square), 1.0F);
        const float peak = whole_power(facing, material_.sharpness);
        for (std::size_t i = 0; i < mirrored.size(); ++i)
            mirrored[i] += peak * light.strength * light.color[i];
    }

    const l3d_shading& shading_;
    std::span<const l3d_material> materials_;
    lit_material material_;
    bool turns_;
    vector3 normal_{}; ///< the polygon's normal, in mode `flat`
    /// The least and the largest depth of the polygon.
    float farthest_ = 0, nearest_ = std::numeric_limits<float>::max();
};

/// Keeps a pixel's normal, which lit_words lights when all polygons are filled: z and the material
/// in its word, x and y in a second word (fill_words).
class later_shader {
public:
    static constexpr std::size_t components = 3;
    static constexpr bool interpolates_normals = true;

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void corner(const l3d_micro_vertex& vertex, float* out) const {
        std::copy_n(vertex.normal, components, out);
    }
    normal_code code(const float* normal) const { return normal_code::of(normal); }
    static row_light in_lanes() { return {.by = row_light::kind::code}; }
};

} // namespace l3d_detail

#endif
