// SPDX-License-Identifier: MIT
// l3d_trim_cells: cuts diced pieces at the borders of their patch's trimmed region.
#ifndef L3D_DICE_TRIM_CELLS_H
#define L3D_DICE_TRIM_CELLS_H

#include "dice/diced_piece.h"
#include "dice/trim_surfaces_p.h"
#include "geom/trims/grid_trims.h"
#include "scene/dice_view.h"

#include <array>
#include <cstddef>
#include <vector>

/// Leaves out what lies outside of a region: of a piece's quads, and of the triangles of its slits.
///
/// Quads that lie inside stay as they are. Others join the grid's `cut`, and triangles stand for
/// what is left of those that the border passes through. A new corner stands for the same
/// parameters in the plane of its quad, before projection. One on a side is a function of that
/// side's ends, so neighbours fit together (docs/NUMERICS.md, section 27).
/// Lives:   one per worker, kept for its memory.
/// Expects: pieces that keep the parameters of their triangles.
class l3d_trim_cells {
public:
    /// Cuts a piece of a patch with this region. A piece without a grid has slits alone to cut.
    /// Expects: `by` is what the region leaves of the grid, if the piece has one.
    l3d_trim_error cut(const l3d_trim_region& region, const l3d_dice_view& view,
                       l3d_diced_piece& piece, const l3d_grid_trims& by, bool keeps_parameters);

private:
    using stretch = std::array<double, 2>;
    using stretches = std::vector<stretch>;
    using quad_surface = l3d_detail::quad_surface;
    using slit_surface = l3d_detail::slit_surface;
    void cut_grid(const l3d_grid_trims& by);
    bool has_strip(const l3d_trim_use& use) const;
    void cut_quad(const l3d_grid_trims& by, const l3d_grid_trims::part& part);
    template <class Surface>
    void add(const Surface& of, const typename Surface::point& a, const typename Surface::point& b,
             const typename Surface::point& c);
    void cut_slits(const l3d_trim_region& region, const l3d_grid_trims& by);
    void keep_slit(std::size_t triangle);
    void cut_slit(std::size_t triangle, bool along_u, const stretches& kept);
    const l3d_diced_piece::crossing* crossing_at(bool along_u, double across, double along) const;
    template <class Point> l3d_dice_vertex lit(const Point& at, float side) const;
    void add_strip(const l3d_trim_use& use, const l3d_dice_vertex& from, const l3d_dice_vertex& to);
    void note_crossing(const l3d_trim_place& at, std::uint32_t edge, double t);
    void strip_whole(const l3d_grid_trims& by, const l3d_grid_trims::part& part);
    bool is_unseen(std::size_t row, std::size_t column) const;
    void note_whole_quads(const l3d_grid_trims& by);
    void cut_border(const l3d_grid_trims& by);

    const l3d_dice_view* view_ = nullptr;
    l3d_diced_piece* piece_ = nullptr;
    l3d_trim_error error_;
    std::vector<quad_surface::point> points_; ///< the corners in a quad that is cut
    std::vector<bool> is_whole_;              ///< quads, by the index of their first corners
    std::vector<l3d_border_edge> border_;     ///< as it was
    std::vector<l3d_border_edge> trims_;      ///< sides of triangles
    std::vector<stretch> border_along_;
    l3d_micro_triangles slits_;
    std::array<std::vector<l3d_patch_parameters>, 3> slits_uv_;
};

#endif
