// SPDX-License-Identifier: MIT
// l3d_diced_piece: a piece of a patch in the rasterizer's form, with its bounds.
#ifndef L3D_DICE_DICED_PIECE_H
#define L3D_DICE_DICED_PIECE_H

#include "raster/surface_part.h"
#include "raster/textures/painted_part_p.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// A vertex, and the parameters of the exact surface point that it stands for.
struct l3d_dice_vertex {
    l3d_micro_vertex vertex;
    double u = 0, v = 0;
};

/// How far the longest triangle of a slit reaches along the grid's side, for each block of the
/// side. Bounds of shade are computed from these lengths. An edge has steps of its own, so a slit's
/// triangle may span several steps of the grid.
/// Shape: [along u, along v][block of the side].
/// Units: the patch's parameters; 0 where there is no triangle.
struct l3d_gap_spans {
    using of_blocks = std::array<double, l3d_block_starts::most_blocks>;
    /// The reaches of triangles whose shade levels are parabolas.
    std::array<of_blocks, 2> bent{};
    std::array<of_blocks, 2> straight{}; ///< the reaches of triangles whose shade levels are linear
};

/// The distance of a drawn shape from the exact shape that it stands for, in the picture and in
/// depth.
/// Units: pixels; `depth` in pixels at the place's own depth, in space.
struct l3d_drawn_distance {
    double places = 0, depth = 0;

    void add(const l3d_drawn_distance& other) {
        places = std::max(places, other.places);
        depth = std::max(depth, other.depth);
    }
};

/// The result of dicing a piece: a grid and the triangles around it. Vertex (r, c) of the grid
/// stands for the exact surface point at (u[c], v[r]). Corner k of triangle i stands for the point
/// at triangle_uv[k][i].
///
/// Lives: an object is used again from frame to frame for its memory.
struct l3d_diced_piece {
    using parameters = l3d_patch_parameters;

    l3d_surface_part part;
    std::vector<double> u, v;
    /// The certified error of places in the grid, in pixels. For triangles, the bound of the whole
    /// frame holds (l3d_dice_counts::bound_px).
    double bound = 0;
    l3d_drawn_distance strips; ///< the largest distance between a visible strip and its edge
    l3d_gap_spans slits;
    bool has_levels = false; ///< whether vertices have shade levels and bends in place of normals

    /// Whether triangle_uv and border_along are filled in. Pictures on surfaces, inspections and
    /// tests need both.
    bool keep_parameters = false;
    std::array<std::vector<parameters>, 3> triangle_uv;
    /// The two ends of each edge of the part's border, as parameters along the side of the grid
    /// where the edge lies. Pieces without a grid leave the list empty.
    std::vector<std::array<double, 2>> border_along;

    /// A place on a side of the piece where the border of a trimmed region follows an edge of the
    /// model. If the slit beside the side is cut at this place, a strip fills the space between the
    /// cut and the edge.
    struct crossing {
        std::array<double, 2> at; ///< the place's parameters u and v
        std::uint32_t edge;
        double t; ///< the edge's parameter
    };
    std::vector<crossing> crossings;

    /// Removes grid and triangles, but keeps their memory.
    void clear() {
        part.grid.rows = part.grid.columns = 0;
        part.triangles.clear();
        part.border.clear();
        border_along.clear();
        crossings.clear();
        u.clear();
        v.clear();
        bound = 0;
        strips = {};
        slits = {};
        has_levels = false;
        for (auto& corner : triangle_uv)
            corner.clear();
    }

    /// Notes in `of` that a slit has a triangle between the parameters `low` and `high`, both of u
    /// or both of v.
    void add_span(std::array<l3d_gap_spans::of_blocks, 2>& of, bool along_u, double low,
                  double high) {
        const std::vector<double>& at = along_u ? u : v;
        const l3d_block_starts& starts = along_u ? part.block_columns : part.block_rows;
        if (at.size() < 2)
            return;
        for (std::size_t i = 0; i < static_cast<std::size_t>(starts.blocks); ++i) {
            const double from = at[static_cast<std::size_t>(starts.first[i])];
            const double to = at[static_cast<std::size_t>(starts.first[i + 1])];
            double& span = of[along_u ? 0 : 1][i];
            if (low < to && high > from)
                span = std::max(span, high - low);
        }
    }

    void add_triangle(const l3d_dice_vertex& a, const l3d_dice_vertex& b,
                      const l3d_dice_vertex& c) {
        part.triangles.add(a.vertex, b.vertex, c.vertex);
        if (!keep_parameters)
            return;
        triangle_uv[0].push_back({a.u, a.v});
        triangle_uv[1].push_back({b.u, b.v});
        triangle_uv[2].push_back({c.u, c.v});
    }
};

#endif
