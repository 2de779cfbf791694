// SPDX-License-Identifier: MIT
// What l3d_pipeline_afd makes of pieces: filled surfaces, or lines.
#ifndef L3D_PIPELINE_DICE_SINKS_P_H
#define L3D_PIPELINE_DICE_SINKS_P_H

#include "pipeline/diced_pieces.h"
#include "pipeline/stopwatch_p.h"
#include "raster/rasterizer_2d.h"
#include "raster/surface_rasterizer.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Green where the bound is small, over yellow, to red where it is all of the tolerance.
inline std::uint32_t error_color(double bound, double tolerance) {
    const double part = std::clamp(bound / tolerance, 0.0, 1.0);
    const auto red = static_cast<std::uint32_t>(255 * std::min(1.0, 2 * part));
    const auto green = static_cast<std::uint32_t>(255 * std::min(1.0, 2 - 2 * part));
    return red << 16 | green << 8;
}

/// Hands pieces to the surface rasterizer, and takes the time that it needs.
inline double fill_pieces(const l3d_diced_pieces& pieces, l3d_surface_rasterizer& rasterizer,
                          bool show_error, double tolerance) {
    const stopwatch watch;
    for (const l3d_diced_piece& piece : pieces.used()) {
        if (show_error)
            rasterizer.set_error_color(error_color(piece.bound, tolerance));
        const l3d_surface_part& part = piece.part;
        if (part.grid.rows > 1)
            rasterizer.draw_grid(part.grid);
        for (std::size_t i = 0; i < part.triangles.count; ++i)
            rasterizer.draw_triangle(part.triangles.vertex(i, 0), part.triangles.vertex(i, 1),
                                     part.triangles.vertex(i, 2));
    }
    return watch.milliseconds();
}

/// Draws the rows and columns of every grid as lines: the steps that were taken.
class line_sink {
public:
    line_sink(l3d_rasterizer_2d& rasterizer, std::uint32_t color)
        : rasterizer_(rasterizer), color_(color) {}

    void draw(const l3d_diced_pieces& pieces) {
        lines_.clear();
        for (const l3d_diced_piece& piece : pieces.used()) {
            const l3d_micro_grid& g = piece.part.grid;
            for (int r = 0; r < g.rows; ++r)
                for (int c = 0; c < g.columns; ++c) {
                    if (c + 1 < g.columns)
                        add(g.vertex(r, c), g.vertex(r, c + 1));
                    if (r + 1 < g.rows)
                        add(g.vertex(r, c), g.vertex(r + 1, c));
                }
            // Slits are empty to the eye; pieces that had to be clipped are triangles, too.
            const l3d_micro_triangles& t = piece.part.triangles;
            for (std::size_t i = 0; i < t.count; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    add(t.vertex(i, k), t.vertex(i, (k + 1) % 3));
        }
        rasterizer_.draw_lines(lines_, color_);
    }

private:
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
