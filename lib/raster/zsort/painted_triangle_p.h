// SPDX-License-Identifier: MIT
// painted_triangle: one triangle of a painter, row by row.
#ifndef L3D_RASTER_ZSORT_PAINTED_TRIANGLE_P_H
#define L3D_RASTER_ZSORT_PAINTED_TRIANGLE_P_H

#include "raster/shaders/shader_choice_p.h"
#include "raster/shapes/attribute_plane_p.h"
#include "raster/zsort/light_queue_p.h"
#include "raster/zsort/open_pixels_p.h"
#include "raster/shapes/piece_pixels_p.h"
#include "raster/shapes/triangle_runs_p.h"
#include "raster/surfaces/fill_kernel_p.h"
#include "raster/surfaces/wide_rows_p.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

namespace l3d_detail {

/// Everything a triangle is painted by, in a band of rows. A worker writes to it at each row, so no
/// two share a line of the caches.
struct alignas(64) painting {
    l3d_pixels target;
    fill_band words{}; ///< those of the target
    scan_rows rows;
    scan_polygon scan;
    open_pixels open; ///< if it is painted from front to back
    std::vector<placed_cut> cuts;
    std::uint32_t color = white; ///< of the material
    /// What finds the colours of names, if triangles have these; and the name of what is painted.
    std::optional<face_painter> painter{};
    std::uint32_t name = 0;
    std::int64_t written = 0;
    /// All rows of one triangle.
    wide_runs found;
    /// What cuts and open pixels leave of them.
    wide_runs left;
    /// The shading whose fog is before all. Null if it has none.
    const l3d_shading* foggy = nullptr;
    /// What was painted and waits for its light.
    light_queue light;
    /// Whether what is painted first stays.
    bool from_front = false;
    static constexpr std::uint32_t white = wide_polygon::white;

    /// Whether rows are filled in lanes, if the shader has them: pixel by pixel the same bits.
    bool by_lanes() const {
        return target.width >= fill_least_width && foggy == nullptr && !painter;
    }

    void paint_to(l3d_pixels picture) {
        target = picture;
        words = {.words = picture.words,
                 .word_pitch = picture.stride,
                 .depths = nullptr,
                 .depth_pitch = 0,
                 .width = picture.width,
                 .top = 0,
                 .bottom = picture.height};
    }
};

/// The plane of a triangle's numbers, made when the first row of it is painted.
template <class Shader> class deferred_plane {
public:
    using planes = attribute_planes<1 + Shader::components>;

    deferred_plane(Shader& shader, const std::array<l3d_micro_vertex, 3>& v)
        : shader_(shader), v_(v) {}

    const planes& get() {
        if (plane_)
            return *plane_;
        shader_.begin_polygon(v_);
        std::array<typename planes::numbers, 3> values;
        for (std::size_t i = 0; i < 3; ++i) {
            values[i][0] = v_[i].inv_w;
            shader_.corner(v_[i], values[i].data() + 1);
        }
        const std::array<scan_point, 3> points = places_of(v_);
        return plane_.emplace(points, values, cross(points[1] - points[0], points[2] - points[0]));
    }

    /// What light_queue makes the same plane of. Expects: a shader of normals.
    unlit_triangle unlit(std::uint32_t color) const {
        unlit_triangle of{places_of(v_), {}, shader_.in_lanes().light, color};
        for (std::size_t i = 0; i < v_.size(); ++i)
            shader_.corner(v_[i], of.normals[i].data());
        return of;
    }

private:
    Shader& shader_;
    const std::array<l3d_micro_vertex, 3>& v_;
    std::optional<planes> plane_;
};

/// Paints some columns of a row, pixel by pixel.
template <class Shader>
void paint_row(painting& to, Shader& shader, const attribute_planes<1 + Shader::components>& plane,
               const std::array<l3d_micro_vertex, 3>& v, std::int32_t row, std::int32_t start,
               columns span) {
    constexpr std::size_t count = 1 + Shader::components;
    const auto step = plane.per_column(), value = plane.at(start, row);
    std::uint32_t* const words = to.target.row(row).data();
    const auto range = std::minmax({v[0].inv_w, v[1].inv_w, v[2].inv_w});
    const std::uint32_t fog =
        to.foggy ? to.foggy->fog.in_row(to.foggy->background, row, to.target.height) : 0;
    for (std::int32_t x = span.begin; x < span.end; ++x) {
        const auto k = static_cast<float>(x - start);
        std::array<float, count> here;
        for (std::size_t i = 1; i < count; ++i)
            here[i] = value[i] + step[i] * k;
        std::uint32_t word = 0, color = to.color;
        if constexpr (has_places<Shader>) {
            word = shader.word_at(here.data() + 1, x + 0.5, row + 0.5);
        } else {
            word = shader.word(here.data() + 1);
            if (to.painter)
                color = to.painter->color(to.name, x + 0.5, row + 0.5);
        }
        words[x] = l3d_product_of_colors(color, word);
        if (to.foggy) {
            const float inv_w = std::clamp(value[0] + step[0] * k, range.first, range.second);
            words[x] = to.foggy->fogged(words[x], fog, inv_w);
        }
    }
    to.written += span.end - span.begin;
}

/// Calls visit(columns) for those columns of a row that are to be painted: all, or those that are
/// open, and then taken.
template <class Visit>
void visit_open(painting& to, std::int32_t row, columns span, const Visit& visit) {
    if (to.from_front)
        to.open.take(row, span, visit);
    else
        visit(span);
}

/// Whether something was painted in all of a triangle's box already.
inline bool is_hidden(const painting& to, const std::array<l3d_micro_vertex, 3>& v) {
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    return !to.open.any(
        {std::max(first_centre(top), to.rows.top), std::min(first_centre(bottom), to.rows.bottom)},
        {std::max(first_centre(left), 0), std::min(first_centre(right), to.target.width)});
}

template <class Shader>
void paint_runs(painting& to, const Shader& shader, deferred_plane<Shader>& plane,
                const wide_runs& runs) {
    if (runs.count == 0)
        return;
    if constexpr (std::is_same_v<Shader, lambert_shader>) {
        to.written += to.light.add(to.words, plane.unlit(to.color), runs);
    } else {
        wide_polygon of{
            .planes = plane.get().view(), .light = shader.in_lanes(), .color = to.color};
        if (of.light.by == row_light::kind::word)
            of.light.word = l3d_product_of_colors(to.color, of.light.word);
        to.written += fill_wide_rows(to.words, of, runs);
    }
}

/// Paints what cuts and open pixels leave of the rows that were found.
template <class Shader>
void paint_rest_of_runs(painting& to, const Shader& shader, deferred_plane<Shader>& plane) {
    const wide_runs& runs = to.found;
    wide_runs& left = to.left;
    left.count = 0;
    const std::span<const placed_cut> cuts(to.cuts); // not to be read again in each row
    const std::size_t count = runs.count;
    for (std::size_t i = 0; i < count; ++i) {
        const std::int32_t row = runs.row[i], start = runs.start[i];
        const columns span = kept_by(cuts, {runs.begin[i], runs.end[i]}, start, row);
        if (span.begin >= span.end)
            continue;
        visit_open(to, row, span, [&](columns of) {
            left.add(row, start, of.begin, of.end);
            if (left.is_full()) {
                paint_runs(to, shader, plane, left);
                left.count = 0;
            }
        });
    }
    paint_runs(to, shader, plane, left);
}

template <class Shader>
void paint_in_lanes(painting& to, const Shader& shader, deferred_plane<Shader>& plane,
                    const std::array<l3d_micro_vertex, 3>& v) {
    triangle_runs rows(places_of(v), to.rows);
    while (rows.next(to.target.width, to.found))
        if (to.from_front || !to.cuts.empty())
            paint_rest_of_runs(to, shader, plane);
        else
            paint_runs(to, shader, plane, to.found);
}

/// The rows of a triangle whose pixels are known, as far as they are in the band and open.
inline void find_covered(painting& to, const l3d_painter_piece& piece) {
    constexpr std::int32_t side = l3d_painter_piece::small_side;
    static_assert(side * side / 2 <= wide_runs::room); // every other pixel of a row begins a run
    to.found.count = 0;
    std::int32_t row = piece.top;
    for (std::uint64_t left = piece.cover; left != 0; left >>= side, ++row) {
        const std::uint64_t in_row = left & ((1U << side) - 1);
        if (in_row == 0 || row < to.rows.top || row >= to.rows.bottom)
            continue;
        const std::int32_t start = piece.left + std::countr_zero(in_row);
        open_pixels::visit_bits(to.from_front ? to.open.take(row, piece.left, in_row) : in_row,
                                piece.left,
                                [&](columns of) { to.found.add(row, start, of.begin, of.end); });
    }
}

/// Paints a triangle whose pixels are known. Expects: to.by_lanes().
template <class Shader>
void paint_covered(painting& to, Shader& shader, const l3d_painter_piece& piece,
                   const std::array<l3d_micro_vertex, 3>& v) {
    find_covered(to, piece);
    deferred_plane<Shader> plane(shader, v);
    paint_runs(to, shader, plane, to.found);
}

template <class Shader>
void paint_triangle(painting& to, Shader& shader, const std::array<l3d_micro_vertex, 3>& v) {
    if (to.from_front && is_hidden(to, v))
        return;
    deferred_plane<Shader> plane(shader, v);
    if constexpr (has_lanes<Shader>)
        if (to.by_lanes())
            return paint_in_lanes(to, shader, plane, v);
    visit_rows(to.scan, v, to.cuts, to.target.width,
               [&](std::int32_t row, std::int32_t start, columns span) {
                   visit_open(to, row, span, [&](columns of) {
                       paint_row(to, shader, plane.get(), v, row, start, of);
                   });
                   return true;
               });
}

} // namespace l3d_detail

#endif
