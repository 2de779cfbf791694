// SPDX-License-Identifier: MIT
// l3d_grid_builder: makes the vertices of a piece, and fills the slits along its sides.
#ifndef L3D_DICE_GRID_BUILDER_H
#define L3D_DICE_GRID_BUILDER_H

#include "geom/normal_net.h"
#include "geom/trims/trim_triangles.h"
#include "dice/diced_piece.h"
#include "dice/edges/edge_polylines.h"
#include "dice/normal_columns.h"
#include "dice/piece_bounds.h"
#include "dice/edges/gap_filler.h"
#include "dice/step_plan.h"
#include "dice/strip_walker.h"
#include "dice/surface_piece.h"

#include <array>
#include <vector>

/// Makes the grids or triangles of pieces. l3d_patch_dicer chooses the pieces and the steps.
///
/// A piece that needs no clipping becomes a grid, whose rows are walked by forward differences. Any
/// other piece becomes clipped triangles. Along each side, triangles fill the slit between the
/// piece and the polyline of the side's edge.
/// Cost: no allocation once the largest piece has been seen.
template <class T> class l3d_grid_builder {
public:
    using piece = l3d_surface_piece;

    /// Starts a patch, with the data that all its pieces share.
    /// Lives: normals and edges must live until the patch is drawn.
    void begin(const l3d_dice_view& view, const l3d_normal_net& normals,
               const l3d_edge_polylines& edges);

    /// Draws a piece: adds its grid or triangles, and its slits, to `out`.
    /// Expects: the sides of the piece name edges that were given to begin().
    void draw(const piece& p, const l3d_piece_bounds<T>& nets, const l3d_step_plan& plan,
              l3d_diced_piece& out);

    /// Completes a piece that needs no clipping and whose grid is in `out`. Moves the grid's
    /// corners to the places that neighbouring pieces use, and fills the slits.
    /// Expects: the grid's blocks, out.u and out.v are written.
    void close(const piece& p, l3d_diced_piece& out);

    /// Fills the slits of a piece outside the window. The piece itself is not diced, but its slits
    /// may reach into the window. In the slits, a straight row between two corners stands for each
    /// side of the piece.
    void close_hidden(const piece& p, l3d_diced_piece& out);

    /// Reserves memory, so that pieces no larger than any of `other` allocate nothing.
    void reserve_as(const l3d_grid_builder& other);

private:
    void fill_parameters(const piece& p, const l3d_step_plan& plan, l3d_diced_piece& out);
    void walk_rows(const l3d_piece_bounds<T>& nets, const l3d_step_plan& plan,
                   l3d_diced_piece& out);
    void evaluate_grid(const l3d_piece_bounds<T>& nets, const l3d_step_plan& plan,
                       const l3d_diced_piece& out);
    void copy_evaluated(l3d_micro_grid& grid) const;
    void set_grid_corners(const piece& p, l3d_micro_grid& grid) const;
    void set_clip_corners(const piece& p);
    using corners_of_half = std::array<l3d_clip_vertex, 3>;
    corners_of_half half_of_quad(int row, int column, bool first) const;
    void add_clipped_quads(l3d_diced_piece& out);
    void add_clipped_block(const l3d_trim_block& of, l3d_diced_piece& out) const;
    l3d_clip_vertex corner_at(const l3d_trim_block& quad, const l3d_trim_box& box,
                              const l3d_trim_place& at) const;
    void add_strip(const l3d_trim_use& use, const std::array<l3d_clip_vertex, 2>& border,
                   const corners_of_half& beside, l3d_diced_piece& out) const;
    void add_trimmed(const l3d_trim_block& quad, const std::array<l3d_trim_place, 3>& triangle,
                     const l3d_trim_box& box, l3d_diced_piece& out) const;
    l3d_clip_vertex grid_vertex(const piece& p, const l3d_micro_grid& grid, int row,
                                int column) const;
    template <class VertexAt, class SideAt>
    void fill_slit(const piece& p, std::size_t side, VertexAt vertex_at, SideAt side_at,
                   l3d_diced_piece& out);

    l3d_clip_vertex& clip_vertex(int row, int column) {
        return clip_grid_[clip_index(row, column)];
    }
    const l3d_clip_vertex& clip_vertex(int row, int column) const {
        return clip_grid_[clip_index(row, column)];
    }
    std::size_t clip_index(int row, int column) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    l3d_dice_view view_;
    const l3d_normal_net* normals_ = nullptr;
    const l3d_edge_polylines* edges_ = nullptr;

    int columns_ = 0, rows_ = 0;

    // Kept between pieces only for their memory.
    l3d_strip_walker<T> walker_;
    l3d_normal_columns normal_columns_;
    std::vector<l3d_clip_vertex> clip_grid_;
    std::vector<l3d_image_curve> curves_;
    std::array<std::vector<float>, 3> normal_row_;
    std::vector<l3d_boundary_point> boundary_;
    l3d_trim_triangles trims_;
    std::array<std::vector<float>, 2> light_memory_;
};

#endif
