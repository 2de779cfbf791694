// SPDX-License-Identifier: MIT
// wire_lines: the rows and columns of diced surfaces as lines.
#ifndef L3D_PIPELINE_WIRE_LINES_P_H
#define L3D_PIPELINE_WIRE_LINES_P_H

#include "pipeline/wire_p.h"
#include "raster/surface_part.h"

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace l3d_detail {

/// Draws the steps that were taken: the sides of all quads and triangles.
class wire_lines {
public:
    explicit wire_lines(wire_drawer drawer) : drawer_(std::move(drawer)) {}

    void draw(std::span<const l3d_surface_part* const> parts) {
        for (const l3d_surface_part* part : parts) {
            lines_.clear();
            add_grid(part->grid);
            add_triangles(part->triangles);
            drawer_.draw(lines_);
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

    void add(const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
        lines_.push_back({a.x, a.y, b.x, b.y});
    }

    wire_drawer drawer_;
    std::vector<wire> lines_;
};

} // namespace l3d_detail

#endif
