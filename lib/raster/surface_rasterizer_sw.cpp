// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_sw: choosing the shader, and the walk over a grid's cells.
#include "raster/surface_rasterizer_sw.h"

#include "raster/surface_fill_p.h"
#include "raster/surface_shader_p.h"

#include <algorithm>
#include <cassert>

namespace {

using namespace l3d_detail;

l3d_micro_vertex vertex_at(const l3d_micro_grid& grid, std::size_t i) {
    return {grid.x[i],
            grid.y[i],
            grid.inv_w[i],
            {grid.normal[0][i], grid.normal[1][i], grid.normal[2][i]}};
}

/// Whether no pixel centre of [0, size) lies between the least and the greatest of four numbers.
bool misses(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, std::int32_t size) {
    const std::int32_t first = first_centre(std::min(std::min(a, b), std::min(c, d)));
    const std::int32_t last = first_centre(std::max(std::max(a, b), std::max(c, d)));
    return std::max(first, 0) >= std::min(last, size);
}

template <class Shader>
void fill_grid(surface_fill<Shader> fill, const l3d_micro_grid& grid, l3d_size size) {
    for (int row = 0; row + 1 < grid.rows; ++row) {
        const std::size_t above = grid.index(row, 0), below = grid.index(row + 1, 0);
        for (int column = 0; column + 1 < grid.columns; ++column) {
            const std::size_t p00 = above + static_cast<std::size_t>(column), p10 = p00 + 1;
            const std::size_t p01 = below + static_cast<std::size_t>(column), p11 = p01 + 1;
            if (misses(grid.x[p00], grid.x[p10], grid.x[p11], grid.x[p01], size.width) ||
                misses(grid.y[p00], grid.y[p10], grid.y[p11], grid.y[p01], size.height))
                continue;
            fill.quad({vertex_at(grid, p00), vertex_at(grid, p10), vertex_at(grid, p11),
                       vertex_at(grid, p01)});
        }
    }
}

} // namespace

void l3d_surface_rasterizer_sw::do_begin(l3d_pixels target, l3d_depth_buffer& depth,
                                         const l3d_shading& shading) {
    assert(target.size() == depth.size());
    target_.pixels = target;
    target_.depth = &depth;
    target_.scan.set_height(target.height);
    target_.counts = {};
    target_.shading = shading;
}

/// Calls draw with a filler for the frame's shader: one switch per draw call, none per pixel.
template <class Draw> void l3d_surface_rasterizer_sw::with_shader(const Draw& draw) {
    switch (target_.shading.mode) {
    case l3d_shade::lambert:
        return draw(surface_fill(target_, lambert_shader(target_.shading)));
    case l3d_shade::gouraud:
        return draw(surface_fill(target_, gouraud_shader(target_.shading)));
    case l3d_shade::flat:
        return draw(surface_fill(target_, flat_shader(target_.shading)));
    case l3d_shade::normals:
        return draw(surface_fill(target_, normals_shader(target_.shading)));
    case l3d_shade::error:
        return draw(surface_fill(target_, constant_shader(error_color_)));
    }
}

void l3d_surface_rasterizer_sw::do_draw_grid(const l3d_micro_grid& grid) {
    if (grid.rows < 2 || grid.columns < 2)
        return;
    target_.counts.quads += std::int64_t{grid.rows - 1} * (grid.columns - 1);
    with_shader([&](auto fill) { fill_grid(fill, grid, target_.pixels.size()); });
}

void l3d_surface_rasterizer_sw::do_draw_triangle(const l3d_micro_vertex& a,
                                                 const l3d_micro_vertex& b,
                                                 const l3d_micro_vertex& c) {
    ++target_.counts.quads;
    with_shader([&](auto fill) { fill.triangle({a, b, c}); });
}
