// SPDX-License-Identifier: MIT
// pixel_light: the light of polygons at places, in linear light.
#include "raster/refine/pixel_light_p.h"

#include "raster/color/linear_light_p.h"
#include "raster/refine/sample_places_p.h"
#include "raster/shaders/shader_choice_p.h"
#include "raster/shapes/attribute_plane_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

namespace l3d_detail {

namespace {

/// Amounts of red, green and blue light.
struct light_sum {
    std::array<float, 3> of{};

    void add(const light_sum& other, float share) {
        for (std::size_t i = 0; i < of.size(); ++i)
            of[i] += share * other.of[i];
    }

    std::uint32_t word(const linear_light& tables) const {
        if (of[0] == of[1] && of[1] == of[2])
            return tables.level(of[0]) * 0x010101u;
        std::uint32_t result = 0;
        for (const float channel : of)
            result = result << 8 | tables.level(channel);
        return result;
    }

    static light_sum of_word(std::uint32_t word, const linear_light& tables) {
        return {{tables.light(word >> 16 & 255), tables.light(word >> 8 & 255),
                 tables.light(word & 255)}};
    }
};

/// The level of a polygon of mode l3d_shade::levels: that of levels_shader, at the parameters that
/// a parallelogram would have.
class level_surface {
public:
    level_surface() = default;
    explicit level_surface(const fragment_polygon& of)
        : middle_x_(of.middle_x), middle_y_(of.middle_y) {
        const float per_area = l3d_subpixel_one / static_cast<float>(of.area2);
        const float ax = per_area * static_cast<float>(of.x[2] - of.x[0]),
                    ay = per_area * static_cast<float>(of.y[2] - of.y[0]),
                    bx = per_area * static_cast<float>(of.x[3] - of.x[1]),
                    by = per_area * static_cast<float>(of.y[3] - of.y[1]);
        // In parts of the diagonals from the mean of the corners, a place is
        // s = by right - bx down and t = ax down - ay right.
        const auto& [a, b, c, d] = of.light[0];
        const float ab = 4 * of.light[1][0], ad = 4 * of.light[2][0], bc = 4 * of.light[2][1];
        level_ = a;
        per_uu_ = -ab;
        per_vv_ = -ad;
        per_u_ = b - a + ab;
        v_ = {0.5f, by - ay, ax - bx}; // 1/2 + s + t
        if (of.corners == 4) {
            // Between opposite sides, level and bend change steadily.
            const float along_v = 4 * of.light[1][3] - ab, along_u = bc - ad;
            u_ = {0.5f, by + ay, -ax - bx}; // 1/2 + s - t
            per_v_ = d - a + ad;
            per_uv_ = a - b + c - d + along_v + along_u;
            per_uuv_ = -along_v;
            per_uvv_ = -along_u;
        } else {                   // with d = c; u is the part of b, v that of c
            u_ = {0.25f, ay, -ax}; // 1/4 - t
            per_v_ = c - a + ad;
            per_uv_ = bc - ab - ad;
        }
    }

    /// Units: pixels.
    float at(float x, float y) const {
        const float right = x - middle_x_, down = y - middle_y_;
        const float u = u_.at(right, down), v = v_.at(right, down);
        return level_ + u * (per_u_ + u * per_uu_ + v * (per_uv_ + u * per_uuv_ + v * per_uvv_)) +
               v * (per_v_ + v * per_vv_);
    }

private:
    /// A parameter, held from 0 to 1.
    struct parameter {
        float middle, per_right, per_down;

        float at(float right, float down) const {
            return std::min(std::max(middle + (per_right * right + per_down * down), 0.0f), 1.0f);
        }
    };

    float middle_x_, middle_y_;
    parameter u_, v_;
    float level_, per_u_, per_v_, per_uu_, per_uv_, per_vv_, per_uuv_ = 0, per_uvv_ = 0;
};

/// Planes of `Count` numbers of a polygon's corners.
template <std::size_t Corners, std::size_t Count, class NumbersOf>
attribute_planes<Count> planes_of(const fragment_polygon& polygon, const NumbersOf& numbers_of) {
    std::array<scan_point, Corners> places;
    std::array<std::array<float, Count>, Corners> numbers;
    for (std::size_t i = 0; i < Corners; ++i) {
        places[i] = {polygon.x[i], polygon.y[i]};
        numbers_of(polygon.corner(i), numbers[i].data());
    }
    return {places, numbers, polygon.area2};
}

/// The light of a band's polygons behind fog. Lives: borrows the polygons and the shading.
template <class Shader> class polygon_light {
public:
    polygon_light(const Shader& shader, const l3d_shading& shading,
                  std::span<const l3d_material> materials, bool has_color, int height,
                  std::span<const fragment_polygon> polygons)
        : shader_(shader), shading_(shading), has_color_(has_color), height_(height),
          polygons_(polygons) {
        if (has_color && shading.paints)
            painter_.emplace(*shading.paints, materials);
        if constexpr (has_bends<Shader>)
            for (const fragment_polygon& polygon : polygons)
                levels_.emplace_back(polygon);
    }

    /// Whether no light has a hue.
    bool is_grey() const { return has_bends<Shader> && !has_color_ && !shading_.fog.is_on(); }

    /// The amount of all channels, if they are the same.
    float grey_of(const seen_fragment& seen) const {
        return tables_.light_between(levels_[seen.polygon].at(seen.x, seen.y));
    }

    light_sum of(const seen_fragment& seen) {
        const fragment_polygon& polygon = polygons_[seen.polygon];
        const float x = seen.x, y = seen.y;
        const light_sum light = clear(polygon, seen);
        const l3d_fog& fog = shading_.fog;
        if (!fog.is_on())
            return light;
        const auto [farthest, nearest] =
            std::minmax({polygon.inv_w[0], polygon.inv_w[1], polygon.inv_w[2], polygon.inv_w[3]});
        const float plane = polygon.depth + (polygon.depth_right * (x - polygon.middle_x) +
                                             polygon.depth_down * (y - polygon.middle_y));
        const std::uint32_t color = fog.in_row(shading_.background, static_cast<int>(y), height_);
        const std::uint32_t amount = fog.amount(std::clamp(plane, farthest, nearest));
        return light_sum::of_word(l3d_fog::word(light.word(tables_), color, amount), tables_);
    }

private:
    light_sum clear(const fragment_polygon& polygon, const seen_fragment& seen) {
        if constexpr (std::is_same_v<Shader, constant_shader>)
            return light_sum::of_word(polygon.color, tables_);
        else if constexpr (has_bends<Shader>)
            return of_level(levels_[seen.polygon].at(seen.x, seen.y), color_of(polygon, seen));
        else
            return of_word(word_at(polygon, double{seen.x}, double{seen.y}), color_of(polygon, seen));
    }

    std::uint32_t color_of(const fragment_polygon& polygon, const seen_fragment& seen) {
        return painter_ ? painter_->color(polygon.color, double{seen.x}, double{seen.y})
                        : polygon.color;
    }

    light_sum of_level(float lit, std::uint32_t color) const {
        constexpr std::uint32_t white = 0xffffff;
        if (!has_color_ || color == white) {
            const float light = tables_.light_between(lit);
            return {{light, light, light}};
        }
        const float level = linear_light::level_of(lit) / 255;
        light_sum result;
        for (std::size_t i = 0; i < result.of.size(); ++i)
            result.of[i] =
                tables_.light_at_level(level * static_cast<float>(color >> (16 - 8 * i) & 255));
        return result;
    }

    light_sum of_word(std::uint32_t word, std::uint32_t color) const {
        return light_sum::of_word(has_color_ ? l3d_product_of_colors(color, word) : word, tables_);
    }

    std::uint32_t word_at(const fragment_polygon& polygon, double x, double y) {
        const std::array all{polygon.corner(0), polygon.corner(1), polygon.corner(2),
                             polygon.corner(3)};
        if constexpr (has_materials<Shader>)
            shader_.use_material(polygon.color);
        shader_.begin_polygon(std::span(all).first(static_cast<std::size_t>(polygon.corners)));
        constexpr std::size_t count = Shader::components;
        std::array<float, count> values{};
        if constexpr (count > 0) {
            const auto numbers = [&](const l3d_micro_vertex& v, float* out) {
                shader_.corner(v, out);
            };
            const double column = l3d_subpixel_one * x, row = l3d_subpixel_one * y;
            values = polygon.corners == 4
                         ? planes_of<4, count>(polygon, numbers).at_place(column, row)
                         : planes_of<3, count>(polygon, numbers).at_place(column, row);
        }
        if constexpr (has_places<Shader>)
            return shader_.word_around(values.data(), x, y);
        else
            return shader_.word(values.data());
    }

    Shader shader_;
    const l3d_shading& shading_;
    const linear_light& tables_ = linear_light_tables();
    bool has_color_;
    int height_; ///< of the picture
    std::span<const fragment_polygon> polygons_;
    std::optional<face_painter> painter_; ///< if polygons have names in place of colours
    std::vector<level_surface> levels_; ///< of the polygons, if the shader takes levels
};

/// The word of light before what is behind all surfaces, which fills `empty` of the pixel.
std::uint32_t word_before(light_sum light, std::uint32_t behind, float empty,
                          const linear_light& tables) {
    if (!(empty > 0))
        return light.word(tables);
    if (behind != l3d_pixels::transparent) {
        light.add(light_sum::of_word(behind, tables), empty);
        return light.word(tables);
    }
    if (!(empty < 1))
        return behind;
    light_sum whole;
    whole.add(light, 1 / (1 - empty));
    return whole.word(tables) | l3d_transparency_of(empty);
}

} // namespace

void light_pixels(const band_fragments& band, const l3d_shading& shading,
                  std::span<const l3d_material> materials, bool has_color,
                  const l3d_pixels& target) {
    const linear_light& tables = linear_light_tables();
    constexpr float part = 1.0f / sample_places::count;
    const auto pixels = band.pixels();
    const auto light_by = [&](auto shader) {
        polygon_light light(shader, shading, materials, has_color, target.height, band.polygons());
        const bool is_grey = light.is_grey();
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            light_sum sum;
            int count = 0;
            for (const seen_fragment& of : band.seen_in(i)) {
                const auto samples = static_cast<float>(of.count);
                if (is_grey)
                    sum.of[0] += samples * light.grey_of(of);
                else
                    sum.add(light.of(of), samples);
                count += of.count;
            }
            if (is_grey)
                sum.of[1] = sum.of[2] = sum.of[0];
            const std::int32_t x = pixels[i].x, y = pixels[i].y;
            std::uint32_t& word = target.row(y)[static_cast<std::size_t>(x)];
            const bool shares = band.closed(i) && count > 0;
            light_sum mean;
            mean.add(sum, shares ? 1 / static_cast<float>(count) : part);
            const float empty = shares ? 0.0f : 1 - part * static_cast<float>(count);
            const std::uint32_t behind =
                empty > 0 ? shading.background.word(y, target.height) : 0; // it does not matter
            word = word_before(mean, behind, empty, tables);
        }
    };
    with_shader(shading, materials, 0, light_by);
}

} // namespace l3d_detail
