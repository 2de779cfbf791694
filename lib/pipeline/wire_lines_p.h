// SPDX-License-Identifier: MIT
// wire_lines: the rows and columns of diced surfaces as lines.
#ifndef L3D_PIPELINE_WIRE_LINES_P_H
#define L3D_PIPELINE_WIRE_LINES_P_H

#include "raster/rasterizer_2d.h"
#include "raster/surface_part.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Draws the steps that were taken: the sides of all quads and triangles.
class wire_lines {
public:
    wire_lines(l3d_rasterizer_2d& rasterizer, std::uint32_t color)
        : rasterizer_(rasterizer), color_(color) {}

    void draw(std::span<const l3d_surface_part* const> parts) {
        for (const l3d_surface_part* part : parts) {
            lines_.clear();
            add_grid(part->grid);
            add_triangles(part->triangles);
            rasterizer_.draw_lines(lines_, color_);
        }
    }

private:
    void add_grid(const l3d_micro_grid& g) {
        for (int r = 0; r < g.rows; ++r)
            for (int c = 0; c < g.columns; ++c) {
                if (c + 1 < g.columns)
                    add(g.vertex(r, c), g.vertex(r, c + 1));
                if (r + 1 < g.rows)
                    add(g.vertex(r, c), g.vertex(r + 1, c));
            }
    }

    /// Slits are empty to the eye; pieces that had to be clipped are triangles, too.
    void add_triangles(const l3d_micro_triangles& t) {
        for (std::size_t i = 0; i < t.count; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                add(t.vertex(i, k), t.vertex(i, (k + 1) % 3));
    }

    /// The pixel a sub-pixel position lies in: a shift rounds down, also below zero.
    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
        lines_.push_back({a.x >> l3d_subpixel_bits, a.y >> l3d_subpixel_bits,
                          b.x >> l3d_subpixel_bits, b.y >> l3d_subpixel_bits});
    }

    l3d_rasterizer_2d& rasterizer_;
    std::uint32_t color_;
    std::vector<l3d_line_2d> lines_;
};

} // namespace l3d_detail

#endif
