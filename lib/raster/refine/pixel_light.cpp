// SPDX-License-Identifier: MIT
// light_pixels: finds the light of polygons at places, in linear light.
#include "raster/refine/picture_refiner_p.h"

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

/// The levels of a polygon in mode l3d_shade::levels. They form a plane through its corners'
/// levels, raised by the mean height of the curved surface of levels above this plane.
///
/// Let h be the bend of a side of a triangle. The side raises the level by 4 h times the product of
/// two barycentric coordinates. This product has the mean 1/12 over a triangle, so the mean height
/// is h / 3. Over a quad, the mean height is two thirds of the mean h of opposite sides, so h / 3
/// for each side, too.
class level_surface {
public:
    explicit level_surface(const fragment_polygon& of)
        : plane_(of.plane_of(of.light[0])),
          bend_((of.light[1][0] + of.light[1][3] + of.light[2][0] + of.light[2][1]) / 3) {
        const auto [least, most] =
            std::minmax({of.light[0][0], of.light[0][1], of.light[0][2], of.light[0][3]});
        least_ = least;
        most_ = most;
    }

    /// The level at a place of the picture. The plane of a sliver is steep, so the plane's value is
    /// held between the levels of the corners.
    /// Units: x and y in pixels.
    float at(const fragment_polygon& of, float x, float y) const {
        return std::min(std::max(of.at(plane_, x, y), least_), most_) + bend_;
    }

private:
    fragment_plane plane_;
    float bend_, least_, most_;
};

/// Makes the planes through `Count` numbers at each corner of a polygon.
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

/// Finds the light of a band's polygons, fog included. Lives: borrows the polygons and the shading.
template <class Shader> class polygon_light {
public:
    polygon_light(const Shader& shader, const l3d_shading& shading,
                  std::span<const l3d_material> materials, bool has_color, int height,
                  std::span<const fragment_polygon> polygons)
        : shader_(shader), shading_(shading), has_color_(has_color), height_(height),
          polygons_(polygons) {
        if (has_color && shading.paints)
            painter_.emplace(*shading.paints, materials);
        if constexpr (has_bends<Shader>) {
            levels_.reserve(polygons.size());
            for (const fragment_polygon& polygon : polygons)
                levels_.emplace_back(polygon);
        }
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
        const std::uint32_t color = fog.in_row(shading_.background, static_cast<int>(y), height_);
        const float depth = std::clamp(polygon.at(polygon.depth, x, y), farthest, nearest);
        return light_sum::of_word(shading_.fogged(light.word(tables_), color, depth), tables_);
    }

private:
    light_sum clear(const fragment_polygon& polygon, const seen_fragment& seen) {
        if constexpr (std::is_same_v<Shader, constant_shader>)
            return light_sum::of_word(polygon.color, tables_);
        else if constexpr (has_bends<Shader>)
            return of_level(levels_[seen.polygon].at(polygon, seen.x, seen.y),
                            color_of(polygon, seen));
        else
            return of_word(word_at(polygon, double{seen.x}, double{seen.y}),
                           color_of(polygon, seen));
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
    int height_; ///< the height of the picture
    std::span<const fragment_polygon> polygons_;
    /// Set if polygons have names (face_painter) in place of colours.
    std::optional<face_painter> painter_;
    /// A surface of levels for each polygon, if the shader takes levels and bends.
    std::vector<level_surface> levels_;
};

/// Makes the word of a pixel: `light` from surfaces, and `behind` in the share `empty` of the pixel
/// that shows no surface.
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
    // Where sides meet, some samples may be in none of the polygons: two at each such place. In all
    // tilings that were tried, a pixel has at most four such places.
    constexpr int closed_count = sample_places::count - 8;
    const auto pixels = band.pixels();
    const auto light_by = [&](auto shader) {
        polygon_light light(shader, shading, materials, has_color, target.height, band.polygons());
        band.visit_seen([&](std::size_t i, std::span<const seen_fragment> seen) {
            light_sum sum;
            int count = 0;
            for (const seen_fragment& of : seen) {
                sum.add(light.of(of), static_cast<float>(of.count));
                count += of.count;
            }
            const std::int32_t x = pixels[i].x, y = pixels[i].y;
            std::uint32_t& word = target.row(y)[static_cast<std::size_t>(x)];
            const bool shares = band.closed(i) && count >= closed_count;
            light_sum mean;
            mean.add(sum, shares ? 1 / static_cast<float>(count) : part);
            const float empty = shares ? 0.0f : 1 - part * static_cast<float>(count);
            const std::uint32_t behind =
                empty > 0 ? shading.background.word(y, target.height) : 0; // 0 is not used
            word = word_before(mean, behind, empty, tables);
        });
    };
    with_shader(shading, materials, 0, light_by);
}

} // namespace l3d_detail
