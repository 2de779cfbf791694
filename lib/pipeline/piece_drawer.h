// SPDX-License-Identifier: MIT
// l3d_piece_drawer: the vertices of a piece, and the slits along its sides, into a sink.
#ifndef L3D_PIPELINE_PIECE_DRAWER_H
#define L3D_PIPELINE_PIECE_DRAWER_H

#include "geom/normal_net.h"
#include "pipeline/dice_sink.h"
#include "pipeline/normal_columns.h"
#include "pipeline/piece_nets.h"
#include "pipeline/slit.h"
#include "pipeline/step_plan.h"
#include "pipeline/strip_walker.h"
#include "pipeline/surface_piece.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

/// Draws pieces with given steps. What to draw, and how finely, is the dicer's choice.
///
/// A piece that needs no clipping becomes a grid, its rows walked by forward differences; any
/// other becomes clipped triangles. Along each side, triangles fill the slit to the side's edge.
/// Cost: no allocation once the largest piece has been seen.
template <class T> class l3d_piece_drawer {
public:
    using wide = typename l3d_real_traits<T>::wide;
    using piece = l3d_surface_piece<wide>;

    /// What stays the same for a patch. Lives: normals and sink must outlive its drawing.
    void begin(const l3d_dice_view& view, const l3d_normal_net& normals, l3d_dice_sink& sink);

    /// Expects: `edges` are those that the piece's sides name; `bound` is that of the piece, and
    ///          `frame_bound` that of everything so far, slits included.
    void draw(const piece& p, const l3d_piece_nets<T>& nets, const l3d_step_plan& plan,
              double bound, double frame_bound, std::span<const l3d_edge_polyline> edges);

    /// A piece outside the window is not diced, but the slits that start along its sides may
    /// reach inside: they are filled up to its corners.
    void close_hidden(const piece& p, double frame_bound, std::span<const l3d_edge_polyline> edges);

    /// Vertices evaluated by the last draw.
    std::int64_t samples() const { return static_cast<std::int64_t>(u_.size() * v_.size()); }

private:
    void fill_parameters(const piece& p, const l3d_step_plan& plan);
    void walk_rows(const l3d_piece_nets<T>& nets, const l3d_step_plan& plan);
    void evaluate_grid(const l3d_piece_nets<T>& nets, const l3d_step_plan& plan);
    void copy_evaluated();
    void set_grid_corners(const piece& p);
    void set_clip_corners(const piece& p);
    void add_clipped_quads();
    l3d_clip_vertex grid_vertex(const piece& p, int row, int column) const;
    int grid_facing(int row, int column) const;
    int clip_facing(int row, int column) const;
    template <class VertexAt, class FacingAt>
    void fill_slits(const piece& p, std::span<const l3d_edge_polyline> edges, VertexAt vertex_at,
                    FacingAt facing_at);
    void hand_over_triangles(double bound);

    l3d_clip_vertex& clip_vertex(int row, int column) {
        return clip_grid_[static_cast<std::size_t>(row) * u_.size() +
                          static_cast<std::size_t>(column)];
    }
    const l3d_clip_vertex& clip_vertex(int row, int column) const {
        return clip_grid_[static_cast<std::size_t>(row) * u_.size() +
                          static_cast<std::size_t>(column)];
    }
    int columns() const { return static_cast<int>(u_.size()); }
    int rows() const { return static_cast<int>(v_.size()); }

    l3d_dice_view view_;
    const l3d_normal_net* normals_ = nullptr;
    l3d_dice_sink* sink_ = nullptr;

    // Kept between pieces only for their memory.
    std::vector<double> u_, v_;
    l3d_strip_walker<T> walker_;
    l3d_normal_columns normal_columns_;
    l3d_micro_grid grid_;
    std::vector<l3d_clip_vertex> clip_grid_;
    std::array<std::vector<float>, 3> normal_row_;
    std::vector<l3d_boundary_point> boundary_;
    std::vector<l3d_dice_vertex> triangles_;
};

#endif
