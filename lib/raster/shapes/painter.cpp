// SPDX-License-Identifier: MIT
// l3d_painter: spans, cut where planes meet, and shaded.
#include "raster/shapes/painter.h"

#include "raster/shapes/attribute_plane_p.h"
#include "raster/shapes/piece_pixels_p.h"
#include "raster/shaders/lit_shader_p.h"
#include "raster/shaders/shader_choice_p.h"
#include "raster/shaders/surface_shader_p.h"
#include "raster/surfaces/fill_kernel_p.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <vector>

namespace {

using namespace l3d_detail;

/// The same word everywhere in a triangle.
struct own_color_shader {
    static constexpr std::size_t components = 0;
    std::uint32_t color = 0;

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void corner(const l3d_micro_vertex&, float*) const {}
    std::uint32_t word(const float*) const { return color; }
};

/// The background, where it is seen through the faces that hide lines.
struct ground_shader {
    static constexpr std::size_t components = 0;
    l3d_background background;
    int height;
    std::uint32_t of_row = 0;

    void begin_polygon(std::span<const l3d_micro_vertex>) {}
    void begin_row(std::int32_t row) { of_row = background.word(row, height); }
    void corner(const l3d_micro_vertex&, float*) const {}
    std::uint32_t word(const float*) const { return of_row; }
};

/// Everything a triangle is painted by.
struct painting {
    l3d_pixels target;
    scan_polygon scan;
    std::vector<placed_cut> cuts;
    std::uint32_t color = white; ///< of the material
    std::int64_t written = 0;
    std::vector<wide_row> waiting;      ///< of one triangle
    const l3d_shading* foggy = nullptr; ///< whose fog is before all, if it has any

    static constexpr std::uint32_t white = wide_polygon::white;
};

/// A triangle as lanes fill it.
template <class Shader, class Planes>
wide_polygon painted_by(const Shader& shader, const Planes& plane, const painting& to) {
    wide_polygon of{.light = shader.in_lanes(), .width = to.target.width, .color = to.color};
    of.light.word = l3d_product_of_colors(to.color, of.light.word);
    std::ranges::copy(plane.per_column(), of.step.begin());
    return of;
}

template <class Shader>
void paint_triangle(painting& to, Shader& shader, const std::array<l3d_micro_vertex, 3>& v) {
    constexpr std::size_t count = 1 + Shader::components;
    using planes = attribute_planes<count>;
    std::optional<planes> plane;
    const auto [farthest, nearest] = std::minmax({v[0].inv_w, v[1].inv_w, v[2].inv_w});
    const auto begin = [&](const std::array<scan_point, 3>& points, std::int64_t area2) {
        shader.begin_polygon(v);
        std::array<typename planes::numbers, 3> values;
        for (std::size_t i = 0; i < 3; ++i) {
            values[i][0] = v[i].inv_w;
            shader.corner(v[i], values[i].data() + 1);
        }
        plane.emplace(points, values, area2);
    };
    if constexpr (has_lanes<Shader>)
        if (to.target.width >= fill_least_width && !to.foggy) { // pixel by pixel the same bits
            to.waiting.clear();
            const auto keep_row = [&](std::int32_t row, std::int32_t start, columns span) {
                wide_row& next = to.waiting.emplace_back();
                next.words = to.target.row(row).data();
                next.start = start;
                next.begin = span.begin;
                next.end = span.end;
                std::ranges::copy(plane->at(start, row), next.value.begin());
                return true;
            };
            visit_rows(to.scan, v, to.cuts, to.target.width, begin, keep_row);
            if (!to.waiting.empty())
                to.written += fill_wide_rows(painted_by(shader, *plane, to), to.waiting);
            return;
        }
    const auto paint_row = [&](std::int32_t row, std::int32_t start, columns span) {
        if constexpr (requires { shader.begin_row(row); })
            shader.begin_row(row);
        const typename planes::numbers step = plane->per_column();
        const typename planes::numbers value = plane->at(start, row);
        std::uint32_t* const words = to.target.row(row).data();
        const std::uint32_t fog =
            to.foggy ? to.foggy->fog.in_row(to.foggy->background, row, to.target.height) : 0;
        for (std::int32_t x = span.begin; x < span.end; ++x) {
            const auto k = static_cast<float>(x - start);
            std::array<float, count> here;
            for (std::size_t i = 1; i < count; ++i)
                here[i] = value[i] + step[i] * k;
            const std::uint32_t word = shader.word(here.data() + 1);
            if constexpr (std::is_same_v<Shader, ground_shader>)
                words[x] = word; // no material changes it
            else
                words[x] = l3d_product_of_colors(to.color, word);
            if (to.foggy) {
                const float inv_w = std::clamp(value[0] + step[0] * k, farthest, nearest);
                words[x] = l3d_fog::word(words[x], fog, to.foggy->fog.amount(inv_w));
            }
        }
        to.written += span.end - span.begin;
        return true;
    };
    visit_rows(to.scan, v, to.cuts, to.target.width, begin, paint_row);
}

} // namespace

struct l3d_painter::work_space {
    painting to;
    std::span<const l3d_material> materials;

    void begin(l3d_pixels target, const l3d_background& background) {
        background.fill(target);
        to.target = target;
        to.scan.set_rows({0, target.height});
        to.written = 0;
        to.foggy = nullptr;
        to.color = painting::white;
    }

    template <class Shader>
    void paint(Shader shader, std::span<const l3d_painter_triangle> triangles,
               std::span<const l3d_painter_piece> pieces, std::span<const l3d_painter_cut> cuts) {
        for (const l3d_painter_piece& piece : pieces) {
            place_cuts(piece, triangles, cuts, to.cuts);
            if constexpr (std::is_same_v<Shader, own_color_shader>)
                shader.color = triangles[piece.triangle].color;
            if constexpr (std::is_same_v<Shader, lit_shader>)
                shader.use_material(triangles[piece.triangle].material);
            else if (!materials.empty())
                to.color = materials[triangles[piece.triangle].material].color;
            paint_triangle(to, shader, triangles[piece.triangle].v);
        }
    }

    void paint_by_mode(const l3d_shading& shading, std::span<const l3d_painter_triangle> triangles,
                       std::span<const l3d_painter_piece> pieces,
                       std::span<const l3d_painter_cut> cuts) {
        switch (shading.mode) {
        case l3d_shade::lambert:
            paint(lambert_shader(shading), triangles, pieces, cuts);
            break;
        case l3d_shade::gouraud:
            paint(gouraud_shader(shading), triangles, pieces, cuts);
            break;
        case l3d_shade::flat:
            paint(flat_shader(shading), triangles, pieces, cuts);
            break;
        case l3d_shade::normals:
            paint(normals_shader(shading), triangles, pieces, cuts);
            break;
        case l3d_shade::error:
            paint(own_color_shader(), triangles, pieces, cuts);
            break;
        default:
            assert(false); // only diced surfaces have levels or parameters
            break;
        }
    }

    void draw_sides(const l3d_painter_triangle& of, std::uint32_t color) {
        visit_sides(of, to.cuts, to.target.size(),
                    [&](int x, int y) { to.target.row(y)[static_cast<std::size_t>(x)] = color; });
    }
};

l3d_painter::l3d_painter() : work_(std::make_unique<work_space>()) {}

l3d_painter::~l3d_painter() = default;

void l3d_painter::paint(l3d_pixels target, const l3d_shading& shading,
                        std::span<const l3d_material> materials,
                        std::span<const l3d_painter_triangle> triangles,
                        std::span<const l3d_painter_piece> pieces,
                        std::span<const l3d_painter_cut> cuts) {
    work_->begin(target, shading.background);
    if (shading.fog.is_on())
        work_->to.foggy = &shading;
    const bool is_light = l3d_is_light(shading.mode);
    work_->materials = is_light ? materials : std::span<const l3d_material>();
    if (shading.is_lit(materials))
        work_->paint(lit_shader(shading, materials), triangles, pieces, cuts);
    else
        work_->paint_by_mode(shading, triangles, pieces, cuts);
    counts_ = {};
    counts_.quads = static_cast<std::int64_t>(pieces.size());
    counts_.samples = counts_.written = work_->to.written;
    counts_.covered = l3d_surface_counts::none_counted;
}

void l3d_painter::paint_lines(l3d_pixels target, const l3d_background& background,
                              std::span<const l3d_painter_triangle> triangles,
                              std::span<const l3d_painter_piece> pieces,
                              std::span<const l3d_painter_cut> cuts, std::uint32_t line_color) {
    work_->begin(target, background);
    ground_shader ground{background, target.height};
    for (const l3d_painter_piece& piece : pieces) {
        place_cuts(piece, triangles, cuts, work_->to.cuts);
        paint_triangle(work_->to, ground, triangles[piece.triangle].v);
        work_->draw_sides(triangles[piece.triangle], line_color);
    }
    counts_ = {};
    counts_.quads = static_cast<std::int64_t>(pieces.size());
    counts_.samples = counts_.written = work_->to.written;
    counts_.covered = l3d_surface_counts::none_counted;
}
