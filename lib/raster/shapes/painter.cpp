// SPDX-License-Identifier: MIT
// l3d_painter: spans, cut where planes meet, and shaded.
#include "raster/shapes/painter.h"

#include "raster/shapes/attribute_plane_p.h"
#include "raster/shapes/line_pixels_p.h"
#include "raster/shapes/picture_plane.h"
#include "raster/shapes/scan_polygon_p.h"
#include "raster/surfaces/lit_shader_p.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
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

/// Columns [begin, end).
struct columns {
    std::int32_t begin, end;
};

/// A cut with the planes it is between.
struct placed_cut {
    l3d_picture_plane own, other;
    bool in_front;

    bool keeps(int column, int row) const {
        return (own.at_pixel(column, row) >= other.at_pixel(column, row)) == in_front;
    }

    /// The data that are kept of a row. Both sides of a cut find the same end of it: it depends on
    /// the two planes and on where the whole triangle's row begins.
    columns kept(columns of, std::int32_t start, std::int32_t row) const {
        const double nearer = own.at_pixel(start, row) - other.at_pixel(start, row);
        const double step = (own.along_x - other.along_x) * l3d_subpixel_one;
        if (step == 0)
            return (nearer >= 0) == in_front ? of : columns{of.begin, of.begin};
        const double root = start - nearer / step;
        // The first column in front where the front is to the right, or the first behind.
        const double first = step > 0 ? std::ceil(root) : std::floor(root) + 1;
        const auto at = static_cast<std::int32_t>(
            std::clamp(first, static_cast<double>(of.begin), static_cast<double>(of.end)));
        return (step > 0) == in_front ? columns{at, of.end} : columns{of.begin, at};
    }
};

/// Everything a triangle is painted by.
struct painting {
    l3d_pixels target;
    scan_polygon scan;
    std::vector<placed_cut> cuts;
    std::uint32_t color = white; ///< of the material
    std::int64_t written = 0;

    static constexpr std::uint32_t white = 0xffffff;
};

template <class Shader>
void paint_triangle(painting& to, Shader& shader, const std::array<l3d_micro_vertex, 3>& v) {
    constexpr std::size_t count = 1 + Shader::components;
    using planes = attribute_planes<count>;
    const std::array<scan_point, 3> points{{{v[0].x, v[0].y}, {v[1].x, v[1].y}, {v[2].x, v[2].y}}};
    const std::int64_t area2 = cross(points[1] - points[0], points[2] - points[0]);
    if (area2 == 0)
        return;
    const scan_rows rows = to.scan.convert(std::span<const scan_point, 3>(points), area2 > 0);
    if (rows.top >= rows.bottom)
        return;
    shader.begin_polygon(v);
    std::array<typename planes::numbers, 3> values;
    for (std::size_t i = 0; i < 3; ++i) {
        values[i][0] = v[i].inv_w;
        shader.corner(v[i], values[i].data() + 1);
    }
    const planes plane(points, values, area2);
    const typename planes::numbers step = plane.per_column();
    for (std::int32_t row = rows.top; row < rows.bottom; ++row) {
        const std::int32_t start = to.scan.first(row);
        columns span{std::max(start, 0), std::min(to.scan.last(row), to.target.width)};
        if (span.begin >= span.end)
            continue;
        for (const placed_cut& cut : to.cuts)
            span = cut.kept(span, start, row);
        const typename planes::numbers value = plane.at(start, row);
        std::uint32_t* const words = to.target.row(row).data();
        for (std::int32_t x = span.begin; x < span.end; ++x) {
            const auto k = static_cast<float>(x - start);
            std::array<float, count> here;
            for (std::size_t i = 1; i < count; ++i)
                here[i] = value[i] + step[i] * k;
            words[x] = l3d_product_of_colors(to.color, shader.word(here.data() + 1));
        }
        to.written += span.end - span.begin;
    }
}

} // namespace

struct l3d_painter::work_space {
    painting to;
    std::span<const l3d_material> materials;

    void begin(l3d_pixels target) {
        for (int y = 0; y < target.height; ++y)
            std::ranges::fill(target.row(y), 0u);
        to.target = target;
        to.scan.set_rows({0, target.height});
        to.written = 0;
        to.color = painting::white;
    }

    void place_cuts(const l3d_painter_piece& piece, std::span<const l3d_painter_triangle> triangles,
                    std::span<const l3d_painter_cut> cuts) {
        to.cuts.clear();
        for (std::uint32_t c = piece.cut; c != l3d_painter_cut::last; c = cuts[c].next)
            to.cuts.push_back({l3d_picture_plane(triangles[piece.triangle].v),
                               l3d_picture_plane(triangles[cuts[c].splitter].v), cuts[c].in_front});
    }

    template <class Shader>
    void paint(Shader shader, std::span<const l3d_painter_triangle> triangles,
               std::span<const l3d_painter_piece> pieces, std::span<const l3d_painter_cut> cuts) {
        for (const l3d_painter_piece& piece : pieces) {
            place_cuts(piece, triangles, cuts);
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
        case l3d_shade::levels:
            assert(false); // only diced surfaces have levels
            break;
        }
    }

    void draw_sides(const l3d_painter_triangle& of, std::uint32_t color) {
        for (std::size_t k = 0; k < of.v.size(); ++k)
            if (of.sides >> k & 1)
                visit_line(side_of(of.v[k], of.v[(k + 1) % 3]), to.target.size(),
                           [&](int x, int y, double) {
                               if (std::ranges::all_of(to.cuts, [&](const placed_cut& cut) {
                                       return cut.keeps(x, y);
                                   }))
                                   to.target.row(y)[static_cast<std::size_t>(x)] = color;
                           });
    }
};

l3d_painter::l3d_painter() : work_(std::make_unique<work_space>()) {}

l3d_painter::~l3d_painter() = default;

void l3d_painter::paint(l3d_pixels target, const l3d_shading& shading,
                        std::span<const l3d_material> materials,
                        std::span<const l3d_painter_triangle> triangles,
                        std::span<const l3d_painter_piece> pieces,
                        std::span<const l3d_painter_cut> cuts) {
    work_->begin(target);
    const bool is_light = shading.mode != l3d_shade::normals && shading.mode != l3d_shade::error;
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

void l3d_painter::paint_lines(l3d_pixels target, std::span<const l3d_painter_triangle> triangles,
                              std::span<const l3d_painter_piece> pieces,
                              std::span<const l3d_painter_cut> cuts, std::uint32_t line_color) {
    work_->begin(target);
    own_color_shader black;
    for (const l3d_painter_piece& piece : pieces) {
        work_->place_cuts(piece, triangles, cuts);
        paint_triangle(work_->to, black, triangles[piece.triangle].v);
        work_->draw_sides(triangles[piece.triangle], line_color);
    }
    counts_ = {};
    counts_.quads = static_cast<std::int64_t>(pieces.size());
    counts_.samples = counts_.written = work_->to.written;
    counts_.covered = l3d_surface_counts::none_counted;
}
