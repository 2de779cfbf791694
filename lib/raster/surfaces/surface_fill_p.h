// SPDX-License-Identifier: MIT
// surface_fill: fills quads and triangles into picture and depth buffer, pixel by pixel.
#ifndef L3D_RASTER_SURFACES_SURFACE_FILL_P_H
#define L3D_RASTER_SURFACES_SURFACE_FILL_P_H

#include "raster/shapes/attribute_plane_p.h"
#include "raster/surfaces/quad_cut_p.h"
#include "raster/shaders/shader_choice_p.h"
#include "raster/surfaces/surface_target_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

namespace l3d_detail {

/// A bound for the error of a plane through a polygon's normals: the parts that come from the
/// polygon's shape and from the change of w. This function is the slow twin of
/// normal_lanes::note_error. See NUMERICS, section 24.
///
/// Shape:   area2 is the cross product of both diagonals, or of a triangle's first two sides.
/// Expects: area2 != 0, inv_w > 0.
template <std::size_t Corners>
float normal_error(const std::array<l3d_micro_vertex, Corners>& v,
                   const std::array<scan_point, Corners>& p, std::int64_t area2) {
    constexpr std::size_t last = Corners - 1;
    double part1 = 0, part2 = 0;
    if constexpr (Corners == 4) {
        // From the middle of the first diagonal to that of the second, in parts of both, halved.
        const scan_point along1 = p[2] - p[0], along2 = p[3] - p[1];
        const scan_point apart{p[1].x + p[3].x - p[0].x - p[2].x,
                               p[1].y + p[3].y - p[0].y - p[2].y};
        const double quarter = 0.25 / static_cast<double>(area2);
        part1 = quarter * static_cast<double>(cross(apart, along2));
        part2 = quarter * static_cast<double>(cross(along1, apart));
    }
    double square1 = 0, square2 = 0, twist = 0, beside = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto n = [&](std::size_t i) { return double{v[i].normal[k]}; };
        const double d1 = n(2) - n(0), d2 = n(last) - n(1), t = n(0) - n(1) + n(2) - n(last);
        const double off = part1 * d1 + part2 * d2;
        square1 += d1 * d1;
        square2 += d2 * d2;
        twist += t * t;
        beside += off * off;
    }
    float farthest = v[0].inv_w, nearest = farthest;
    for (const l3d_micro_vertex& corner : v) {
        farthest = std::min(farthest, corner.inv_w);
        nearest = std::max(nearest, corner.inv_w);
    }
    const double range = std::sqrt(std::max(square1, square2)) + std::sqrt(twist) / 2;
    const double more = double{nearest} / double{farthest} - 1;
    return static_cast<float>(std::sqrt(beside) + more / 4 * range);
}

/// Fills polygons with one shader, which is known at compile time.
///
/// Lives: borrows the target for one call.
template <class Shader> class surface_fill {
public:
    surface_fill(surface_target& target, const Shader& shader) : target_(target), shader_(shader) {}

    /// Sets the material of the next polygons, for shaders that take it.
    void use_material(std::uint32_t index) {
        if constexpr (has_materials<Shader>)
            shader_.use_material(index);
    }

    /// Fills a quad of a grid. `shows_both` and `parallel` are the grid's members shows_both and
    /// is_parallel.
    void quad(quad_corners v, bool shows_both, bool parallel) {
        const quad_turns turns(v);
        if (turns.level())
            return;
        if (shows_both && !turns.folded())
            show_side(v, turns.area2());
        if (!turns.folded() && !turns.skew())
            return convex(v, turns.area2());
        const auto fill_triangle = [&](auto piece, std::int64_t area2) {
            if (shows_both && turns.folded())
                show_side(piece, area2);
            triangle(piece);
        };
        if constexpr (has_bends<Shader>) {
            if (turns.folded())
                return cut_folded_levels(v, parallel, turns, fill_triangle);
            shader_.begin_quad(v);
            cut_quad(v, parallel, turns, fill_triangle);
            shader_.end_quad();
        } else {
            cut_quad(v, parallel, turns, fill_triangle);
        }
    }

    void triangle(const std::array<l3d_micro_vertex, 3>& v) {
        const std::int64_t area2 =
            cross(position(v[1]) - position(v[0]), position(v[2]) - position(v[0]));
        if (area2 != 0)
            convex(v, area2);
    }

private:
    static constexpr std::size_t count = 1 + Shader::components;
    using planes = attribute_planes<count>;
    using numbers = typename planes::numbers;

    template <std::size_t Corners>
    void convex(const std::array<l3d_micro_vertex, Corners>& v, std::int64_t area2) {
        std::array<scan_point, Corners> points;
        for (std::size_t i = 0; i < Corners; ++i)
            points[i] = position(v[i]);
        const scan_rows rows =
            target_.scan.convert(std::span<const scan_point, Corners>(points), area2 > 0);
        if (rows.top >= rows.bottom)
            return;

        shader_.begin_polygon(v);
        if constexpr (has_bends<Shader>)
            target_.counts.note_level_error(shader_.error());
        std::array<numbers, Corners> values;
        float farthest = v[0].inv_w, nearest = v[0].inv_w;
        for (std::size_t i = 0; i < Corners; ++i) {
            values[i][0] = v[i].inv_w;
            shader_.corner(v[i], values[i].data() + 1);
            farthest = std::min(farthest, v[i].inv_w);
            nearest = std::max(nearest, v[i].inv_w);
        }
        if constexpr (has_normals<Shader>)
            target_.counts.note_normal_error(normal_error(v, points, area2));
        const planes plane(points, values, area2);
        if constexpr (has_lanes<Shader>)
            if (target_.by_lanes)
                return fill_in_lanes(rows, plane, farthest, nearest);
        const numbers step = plane.per_column();
        for (std::int32_t row = rows.top; row < rows.bottom; ++row)
            fill_row(row, plane, step, farthest, nearest);
        if constexpr (counts_unsolved<Shader>)
            target_.counts.unsolved += shader_.take_unsolved();
    }

    columns kept_columns(std::int32_t row, std::int32_t start) const {
        return kept_by(target_.cuts,
                       {std::max(start, 0), std::min(target_.scan.last(row), target_.band.width)},
                       start, row);
    }

    /// Fills a row of a polygon. Interpolated numbers are computed from those at the beginning of
    /// the unclipped span, so that a pixel's colour does not depend on where the picture ends.
    void fill_row(std::int32_t row, const planes& plane, const numbers& step, float farthest,
                  float nearest) {
        const std::int32_t start = target_.scan.first(row);
        const auto [begin, end] = kept_columns(row, start);
        if (begin >= end)
            return;
        const numbers value = plane.at(start, row);
        float* const depths = target_.depths(row);
        std::uint32_t* const words = target_.words(row);
        std::int64_t written = 0;
        for (std::int32_t x = begin; x < end; ++x) {
            const auto k = static_cast<float>(x - start);
            const float inv_w = std::min(std::max(value[0] + step[0] * k, farthest), nearest);
            if (!(inv_w > depths[x]))
                continue;
            depths[x] = inv_w;
            std::array<float, count> here;
            for (std::size_t i = 1; i < count; ++i)
                here[i] = value[i] + step[i] * k;
            put(here.data() + 1, x, row, words[x]);
            ++written;
        }
        if constexpr (shades_runs<Shader>)
            shader_.end_run();
        target_.counts.samples += end - begin;
        target_.counts.written += written;
    }

    /// Fills rows as fill_row does, but several rows at a time, in lanes.
    void fill_in_lanes(scan_rows rows, const planes& plane, float farthest, float nearest) {
        wide_polygon of{.planes = plane.view(),
                        .farthest = farthest,
                        .nearest = nearest,
                        .light = shader_.in_lanes(),
                        .unit = target_.coding.unit(),
                        .material = target_.material};
        of.light.word = target_.word_of(of.light.word);
        wide_runs runs;
        const auto fill = [&] {
            target_.counts.written += fill_wide_rows(target_.band, of, runs);
            runs.count = 0;
        };
        for (std::int32_t row = rows.top; row < rows.bottom; ++row) {
            const std::int32_t start = target_.scan.first(row);
            const auto [begin, end] = kept_columns(row, start);
            if (begin >= end)
                continue;
            runs.add(row, start, begin, end);
            target_.counts.samples += end - begin;
            if (runs.is_full())
                fill();
        }
        fill();
    }

    void put(const float* values, std::int32_t x, std::int32_t row, std::uint32_t& word) {
        if constexpr (shades_later<Shader>) {
            const normal_code code = shader_.code(values);
            word = code.z | target_.material;
            target_.normals(row)[x] = code.xy;
        } else if constexpr (shades_runs<Shader>) {
            constexpr double half = 0.5;
            shader_.note(values, x + half, row + half, word);
        } else {
            word = target_.word_of(word_at(values, x, row));
        }
    }

    std::uint32_t word_at(const float* values, std::int32_t x, std::int32_t row) {
        constexpr double half = 0.5;
        if constexpr (has_places<Shader>)
            return shader_.word_at(values, x + half, row + half);
        else
            return shader_.word(values);
    }

    surface_target& target_;
    Shader shader_;
};

} // namespace l3d_detail

#endif
