// SPDX-License-Identifier: MIT
// wire_lines: draws the rows and columns of diced surfaces as lines.
#ifndef L3D_PIPELINE_WIRE_LINES_P_H
#define L3D_PIPELINE_WIRE_LINES_P_H

#include "pipeline/wire_p.h"
#include "raster/surface_part.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// Draws diced surfaces as lines: the sides of all quads, and of the triangles that clipping
/// leaves. Neighbouring quads and triangles share the line at their common side.
class wire_lines {
public:
    explicit wire_lines(wire_picture& picture) : picture_(picture) {}

    /// Draws the lines of these parts. Expects: if lines are smooth, the parts hold their border
    /// edges.
    void draw(std::span<const l3d_surface_part* const> parts) {
        for (const l3d_surface_part* part : parts) {
            lines_.clear();
            if (!part->grid.cut.empty()) {
                add_uncut(part->grid);
                add_triangles(part->triangles);
            } else if (part->grid.rows > 1) {
                add_inside(part->grid);
                add_rim(*part);
            } else {
                add_triangles(part->triangles);
            }
            picture_.draw(lines_);
        }
    }

private:
    /// Adds the sides of all quads of a grid, except those that clipping replaced by triangles.
    void add_uncut(const l3d_micro_grid& g) {
        for (int r = 0; r + 1 < g.rows; ++r)
            for (int c = 0; c + 1 < g.columns; ++c) {
                if (g.is_cut(g.index(r, c)))
                    continue;
                add_shared(between(g.vertex(r, c), g.vertex(r, c + 1)));
                add_shared(between(g.vertex(r, c + 1), g.vertex(r + 1, c + 1)));
                add_shared(between(g.vertex(r + 1, c + 1), g.vertex(r + 1, c)));
                add_shared(between(g.vertex(r + 1, c), g.vertex(r, c)));
            }
    }

    void add_inside(const l3d_micro_grid& g) {
        for (int r = 0; r < g.rows; ++r)
            for (int c = 0; c < g.columns; ++c) {
                if (c + 1 < g.columns && r > 0 && r + 1 < g.rows)
                    lines_.push_back(between(g.vertex(r, c), g.vertex(r, c + 1)));
                if (r + 1 < g.rows && c > 0 && c + 1 < g.columns)
                    lines_.push_back(between(g.vertex(r, c), g.vertex(r + 1, c)));
            }
    }

    /// Adds the lines along a part's four sides. If part.border holds edges of a side, these are
    /// drawn in place of the grid's line, so that both neighbours draw the same line. Grid and
    /// border differ by a part of the tolerance: drawing both would look like one line that is too
    /// bright. The thin triangles between grid and border are not drawn.
    void add_rim(const l3d_surface_part& part) {
        std::array<bool, 4> noted{};
        for (const l3d_border_edge& e : part.border) {
            noted[static_cast<std::size_t>(e.side)] = true;
            add_shared({e.from_x, e.from_y, e.to_x, e.to_y, e.from_inv_w, e.to_inv_w});
        }
        const l3d_micro_grid& g = part.grid;
        const std::array rows{0, g.columns - 1, g.rows - 1, 0}; // sides above, right, below, left
        for (int side = 0; side < 4; ++side) {
            if (noted[static_cast<std::size_t>(side)])
                continue;
            const bool along_u = side % 2 == 0;
            const int line = rows[static_cast<std::size_t>(side)];
            const auto vertex = [&](int i) {
                return along_u ? g.vertex(line, i) : g.vertex(i, line);
            };
            for (int i = 0; i + 1 < (along_u ? g.columns : g.rows); ++i)
                add_shared(between(vertex(i), vertex(i + 1)));
        }
    }

    void add_triangles(const l3d_micro_triangles& t) {
        for (std::size_t i = 0; i < t.count; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                add_shared(between(t.vertex(i, k), t.vertex(i, (k + 1) % 3)));
    }

    static wire between(const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
        return {a.x, a.y, b.x, b.y, a.inv_w, b.inv_w};
    }

    void add_shared(const wire& line) {
        if (shared_.add(line))
            lines_.push_back(line);
    }

    wire_picture& picture_;
    shared_wires shared_;
    std::vector<wire> lines_;
};

} // namespace l3d_detail

#endif
