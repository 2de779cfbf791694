// SPDX-License-Identifier: MIT
// The sinks of l3d_pipeline_afd: one fills, one draws lines.
#ifndef L3D_PIPELINE_DICE_SINKS_P_H
#define L3D_PIPELINE_DICE_SINKS_P_H

#include "pipeline/dice_sink.h"
#include "raster/rasterizer_2d.h"
#include "raster/surface_rasterizer.h"

#include <algorithm>
#include <cfloat>
#include <cmath>
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

/// Gathers everything as parts, to be drawn together.
class filling_sink final : public l3d_dice_sink {
public:
    filling_sink(std::vector<l3d_surface_part>& parts, bool show_error, double tolerance)
        : parts_(parts), show_error_(show_error), tolerance_(tolerance) {}

    /// Draws all of them.
    void draw(l3d_surface_rasterizer& rasterizer) const {
        std::vector<const l3d_surface_part*> pointers;
        for (std::size_t i = 0; i < used_; ++i)
            pointers.push_back(&parts_[i]);
        rasterizer.draw(pointers);
    }

private:
    void do_grid(const l3d_dice_grid& grid) override {
        l3d_surface_part& part = next();
        part.grid = grid.vertices;
        unit_normals(part.grid);
        part.block_rows.first[1] = part.grid.rows - 1;
        part.block_columns.first[1] = part.grid.columns - 1;
        if (show_error_)
            part.error_color = error_color(grid.bound, tolerance_);
    }

    void do_triangles(std::span<const l3d_dice_vertex> corners, double bound) override {
        l3d_surface_part& part = next();
        part.grid.resize(0, 0);
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            part.triangles.add(unit(corners[i].vertex), unit(corners[i + 1].vertex),
                               unit(corners[i + 2].vertex));
        if (show_error_)
            part.error_color = error_color(bound, tolerance_);
    }

    l3d_surface_part& next() {
        if (used_ == parts_.size())
            parts_.emplace_back();
        parts_[used_].triangles.clear();
        return parts_[used_++];
    }

    static l3d_micro_vertex unit(l3d_micro_vertex v) {
        const float square =
            v.normal[0] * v.normal[0] + v.normal[1] * v.normal[1] + v.normal[2] * v.normal[2];
        for (float& component : v.normal)
            component = square > FLT_MIN ? component / std::sqrt(square) : 0.0f;
        return v;
    }

    static void unit_normals(l3d_micro_grid& grid) {
        for (int row = 0; row < grid.rows; ++row)
            for (int column = 0; column < grid.columns; ++column) {
                const l3d_micro_vertex v = unit(grid.vertex(row, column));
                for (std::size_t axis = 0; axis < 3; ++axis)
                    grid.normal[axis][grid.index(row, column)] = v.normal[axis];
            }
    }

    std::vector<l3d_surface_part>& parts_;
    bool show_error_;
    double tolerance_;
    std::size_t used_ = 0;
};

/// Draws the rows and columns of every grid as lines: the steps that were taken.
class line_sink final : public l3d_dice_sink {
public:
    line_sink(l3d_rasterizer_2d& rasterizer, std::uint32_t color)
        : rasterizer_(rasterizer), color_(color) {}

private:
    void do_grid(const l3d_dice_grid& grid) override {
        const l3d_micro_grid& g = grid.vertices;
        lines_.clear();
        for (int r = 0; r < g.rows; ++r)
            for (int c = 0; c < g.columns; ++c) {
                if (c + 1 < g.columns)
                    add(g.vertex(r, c), g.vertex(r, c + 1));
                if (r + 1 < g.rows)
                    add(g.vertex(r, c), g.vertex(r + 1, c));
            }
        rasterizer_.draw_lines(lines_, color_);
    }

    /// Slits are empty to the eye; pieces that had to be clipped come as triangles, too.
    void do_triangles(std::span<const l3d_dice_vertex> corners, double) override {
        lines_.clear();
        for (std::size_t i = 0; i + 2 < corners.size(); i += 3)
            for (std::size_t k = 0; k < 3; ++k)
                add(corners[i + k].vertex, corners[i + (k + 1) % 3].vertex);
        rasterizer_.draw_lines(lines_, color_);
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
