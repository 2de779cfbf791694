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

/// Cuts off the parts of a diced piece that lie outside of its patch's trimmed region. It cuts the
/// grid's quads and the slits' triangles.
///
/// Quads inside the region stay as they are. All other quads are noted in the grid's `cut`, so that
/// they are not drawn. Where the region's border passes through a quad, triangles fill the quad's
/// part inside the region. A new corner has the parameters of its place on the border, and lies in
/// the plane of its quad, before projection. A new corner on a side depends on that side's ends
/// alone, so neighbours fit together (docs/NUMERICS.md, section 27).
/// Lives:   one for each worker, kept for its memory.
/// Expects: pieces that keep the parameters of their triangles.
class l3d_trim_cells {
public:
    /// Cuts a piece of a patch, and returns the errors that cutting adds to the piece. In a piece
    /// without a grid, only slits are cut.
    /// Expects: `by` tells what the region leaves of the grid, if the piece has one.
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
    /// The corners of the triangles in the quad that is being cut.
    std::vector<quad_surface::point> points_;
    /// Whether each quad lies inside the region, by the index of the quad's first corner.
    std::vector<bool> is_whole_;
    std::vector<l3d_border_edge> border_; ///< the piece's border before the cut
    std::vector<l3d_border_edge> trims_;  ///< sides of triangles that lie on the region's border
    std::vector<stretch> border_along_;
    l3d_micro_triangles slits_;
    std::array<std::vector<l3d_patch_parameters>, 3> slits_uv_;
};

#endif
