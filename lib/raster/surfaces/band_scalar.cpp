// SPDX-License-Identifier: MIT
// band_scalar: chooses the shader, and walks over a grid's cells.
#include "raster/surfaces/band_scalar_p.h"

#include "raster/shaders/shader_choice_p.h"
#include "raster/surfaces/surface_fill_p.h"

#include <algorithm>
#include <array>

namespace l3d_detail {

namespace {

/// Whether no centre of the pixels [begin, end) lies between the least and the greatest of four
/// numbers.
bool misses(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t begin,
            std::int32_t end) {
    const std::int32_t least = std::min(std::min(a, b), std::min(c, d));
    const std::int32_t most = std::max(std::max(a, b), std::max(c, d));
    return l3d_centres_filled(least, most).within(begin, end).none();
}

/// Fills the quad whose first corner is at p00.
template <class Shader>
void fill_cell(surface_fill<Shader>& fill, const fill_band& band, const l3d_micro_grid& grid,
               std::size_t p00) {
    const std::size_t p10 = p00 + 1, p01 = p00 + static_cast<std::size_t>(grid.pitch);
    const std::size_t p11 = p01 + 1;
    if (misses(grid.x[p00], grid.x[p10], grid.x[p11], grid.x[p01], 0, band.width) ||
        misses(grid.y[p00], grid.y[p10], grid.y[p11], grid.y[p01], band.top, band.bottom))
        return;
    fill.quad({grid.vertex(p00), grid.vertex(p10), grid.vertex(p11), grid.vertex(p01)},
              grid.shows_both, grid.is_parallel);
}

template <class Shader>
void fill_triangle(surface_fill<Shader>& fill, const l3d_micro_triangles& triangles,
                   std::size_t i) {
    fill.triangle({triangles.vertex(i, 0), triangles.vertex(i, 1), triangles.vertex(i, 2)});
}

} // namespace

void band_scalar::begin(const fill_band& band, const l3d_shading& shading,
                        std::span<const l3d_material> materials, const fill_words& words) {
    materials_ = materials;
    target_.band = band;
    target_.coding = words;
    target_.scan.set_rows({band.top, band.bottom});
    target_.counts = {};
    shading_ = &shading;
}

/// Calls draw with a filler that has the frame's shader.
template <class Draw> void band_scalar::with_filler(std::uint32_t error_color, const Draw& draw) {
    if (target_.coding.has_normals)
        return draw(surface_fill(target_, later_shader()));
    with_shader(*shading_, materials_, error_color,
                [&](const auto& shader) { draw(surface_fill(target_, shader)); });
}

void band_scalar::fill(const l3d_surface_part& part, const grid_cells& cells) {
    target_.material = target_.coding.of_material(part.material);
    with_filler(part.error_color, [&](auto fill) {
        fill.use_material(part.material);
        for (int row = cells.row_begin; row < cells.row_end; ++row)
            for (int column = cells.column_begin; column < cells.column_end; ++column) {
                const std::size_t p00 = part.grid.index(row, column);
                if (part.grid.is_cut(p00))
                    continue;
                if (part.names_quads) {
                    target_.material = target_.coding.of_material(part.material_of_quad(p00));
                    fill.use_material(part.material_of_quad(p00));
                }
                fill_cell(fill, target_.band, part.grid, p00);
            }
    });
}

void band_scalar::fill(const l3d_surface_part& part, std::size_t first, std::size_t last) {
    with_filler(part.error_color, [&](auto fill) {
        for (std::size_t i = first; i < last; ++i) {
            target_.material = target_.coding.of_material(part.material_of(i));
            fill.use_material(part.material_of(i));
            fill_triangle(fill, part.triangles, i);
        }
    });
}

void band_scalar::fill(const fill_rest& rest) {
    target_.by_lanes = true;
    constexpr std::uint32_t no_color = 0; // the kernel does not draw mode `error`
    with_filler(no_color, [&](auto fill) {
        for (const fill_rest::quad& quad : rest.quads) {
            target_.material = quad.material;
            fill_cell(fill, target_.band, *quad.grid, quad.index);
        }
        for (const fill_rest::triangle& triangle : rest.triangles) {
            target_.material = triangle.material;
            fill_triangle(fill, *triangle.triangles, triangle.index);
        }
    });
    target_.by_lanes = false;
}

void band_scalar::fill(const cut_triangle& triangle, std::span<const plane_cut> cuts) {
    target_.cuts = cuts;
    target_.material = target_.coding.of_material(triangle.material);
    constexpr std::uint32_t no_color = 0; // in mode `error`, only triangles of parts have a colour
    with_filler(no_color, [&](auto fill) {
        fill.use_material(triangle.material);
        fill.triangle(triangle.v);
    });
    target_.cuts = {};
}

} // namespace l3d_detail
