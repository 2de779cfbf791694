// SPDX-License-Identifier: MIT
// fragment_light: depth and light of a polygon at any place.
#ifndef L3D_RASTER_REFINE_FRAGMENT_LIGHT_P_H
#define L3D_RASTER_REFINE_FRAGMENT_LIGHT_P_H

#include "raster/refine/band_fragments_p.h"
#include "raster/background.h"
#include "raster/refine/coverage_p.h"
#include "raster/refine/linear_light_p.h"
#include "raster/shaders/shader_choice_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace l3d_detail {

/// Amounts of red, green and blue light.
struct light_sum {
    std::array<float, 3> of{};

    void add(const light_sum& other, float share) {
        for (std::size_t i = 0; i < of.size(); ++i)
            of[i] += share * other.of[i];
    }

    /// The word of the nearest levels.
    std::uint32_t word(const linear_light& tables) const {
        std::uint32_t result = 0;
        for (const float channel : of)
            result = result << 8 | tables.level(channel);
        return result;
    }

    /// The word of a pixel of which a share shows nothing but what is behind all surfaces.
    std::uint32_t word_before(std::uint32_t behind, float share, const linear_light& tables) const {
        light_sum whole;
        if (behind != l3d_pixels::transparent) {
            whole = *this;
            whole.add(of_word(behind, tables), share);
            return whole.word(tables);
        }
        if (!(share < 1))
            return behind;
        whole.add(*this, 1 / (1 - share));
        return whole.word(tables) | l3d_transparency_of(share);
    }

    /// The light of a level above the ambient one, in a material's colour.
    static light_sum of_level(float lit, std::uint32_t color, const linear_light& tables) {
        constexpr std::uint32_t white = 0xffffff;
        if (color == white) {
            const float light = tables.light_between(lit);
            return {{light, light, light}};
        }
        const float level = linear_light::level_of(lit);
        light_sum result;
        for (std::size_t i = 0; i < result.of.size(); ++i) {
            const std::uint32_t part = color >> (16 - 8 * i) & 255;
            result.of[i] = tables.light_at_level(level * static_cast<float>(part) / 255);
        }
        return result;
    }

    static light_sum of_word(std::uint32_t word, const linear_light& tables) {
        return {{tables.light(word >> 16 & 255), tables.light(word >> 8 & 255),
                 tables.light(word & 255)}};
    }
};

template <std::size_t Corners, std::size_t Count> struct corner_numbers {
    std::array<scan_point, Corners> places;
    std::array<std::array<float, Count>, Corners> numbers;

    template <class NumbersOf>
    corner_numbers(const fragment_polygon& polygon, const NumbersOf& numbers_of) {
        for (std::size_t i = 0; i < Corners; ++i) {
            places[i] = {polygon.x[i], polygon.y[i]};
            numbers[i] = numbers_of(polygon.corner(i));
        }
    }
};

/// Planes of numbers of the corners. Shape: numbers_of gives an array of `Count` floats.
template <std::size_t Count, class NumbersOf>
attribute_planes<Count> planes_of(const fragment_polygon& polygon, const NumbersOf& numbers_of) {
    if (polygon.corners == 4) {
        const corner_numbers<4, Count> of(polygon, numbers_of);
        return {of.places, of.numbers, polygon.area2()};
    }
    const corner_numbers<3, Count> of(polygon, numbers_of);
    return {of.places, of.numbers, polygon.area2()};
}

/// Fog before fragments. Lives: borrows the shading.
struct fragment_fog {
    const l3d_shading& shading;
    int height; ///< of the picture

    /// The light that is left of a polygon's at a place, and the fog's own. Units: 1/256 pixel.
    light_sum over(const light_sum& light, const fragment_polygon& polygon, double x,
                   double y) const {
        const l3d_fog& fog = shading.fog;
        if (!fog.is_on())
            return light;
        const linear_light& tables = linear_light_tables();
        const auto depth =
            planes_of<1>(polygon, [](const l3d_micro_vertex& v) { return std::array{v.inv_w}; });
        const float inv_w = std::clamp(depth.at_place(x, y)[0], polygon.farthest, polygon.nearest);
        const auto row = static_cast<int>(std::floor(y / l3d_subpixel_one));
        const std::uint32_t color = fog.in_row(shading.background, row, height);
        return light_sum::of_word(l3d_fog::word(light.word(tables), color, fog.amount(inv_w)),
                                  tables);
    }
};

/// The light of a polygon at a place; its material's colour is seen if `has_color`.
/// Units: 1/256 pixel.
template <class Shader>
light_sum light_at(Shader& shader, const fragment_polygon& polygon, bool has_color, double x,
                   double y) {
    const linear_light& tables = linear_light_tables();
    if constexpr (std::is_same_v<Shader, constant_shader>) {
        return light_sum::of_word(polygon.color, tables);
    } else {
        const auto corners = static_cast<std::size_t>(polygon.corners);
        const std::array all{polygon.corner(0), polygon.corner(1), polygon.corner(2),
                             polygon.corner(3)};
        if constexpr (has_materials<Shader>)
            shader.use_material(polygon.color);
        shader.begin_polygon(std::span(all).first(corners));
        constexpr std::size_t count = Shader::components;
        std::array<float, count> values{};
        if constexpr (has_bends<Shader>) {
            values = {static_cast<float>(x - polygon.x[0]), static_cast<float>(y - polygon.y[0])};
        } else if constexpr (count > 0) {
            const auto numbers = [&](const l3d_micro_vertex& v) {
                std::array<float, count> of;
                shader.corner(v, of.data());
                return of;
            };
            values = planes_of<count>(polygon, numbers).at_place(x, y);
        }
        std::uint32_t word = 0;
        if constexpr (has_places<Shader>)
            word = shader.word_around(values.data(), x / l3d_subpixel_one, y / l3d_subpixel_one);
        else
            word = shader.word(values.data());
        return light_sum::of_word(has_color ? l3d_product_of_colors(polygon.color, word) : word,
                                  tables);
    }
}

} // namespace l3d_detail

#endif
