// SPDX-License-Identifier: MIT
// contour_edges: finds the edges of grids at which surfaces fold over.
#ifndef L3D_RASTER_REFINE_CONTOUR_EDGES_P_H
#define L3D_RASTER_REFINE_CONTOUR_EDGES_P_H

#include "raster/pixel_bits.h"
#include "raster/shapes/scan_edge_p.h"
#include "raster/surfaces/band_list_p.h"

#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// An edge of a contour, at which pixels are drawn with anti-aliasing. It leads from one vertex to
/// another. In the picture, the surface lies on its right. Farther things are seen on its left.
struct contour_edge {
    scan_point from, to; ///< both ends of the edge; units: 1/256 pixel
    float nearest = 0;   ///< inv_w at the nearer end: the larger one of the ends' inv_w
};

/// Finds the edges of grids at which a surface folds over. Each of these edges lies between a
/// polygon that turns to the right in the picture and a polygon that does not. A folded quad is
/// taken as the four triangles by which it is filled.
///
/// Around a vertex, polygons that turn to the right fill the same angle as those that turn to the
/// left. So where polygons of one kind end at an edge, polygons of the other kind begin. All
/// outlines of a surface are among these edges and the surface's borders.
/// Lives: make one object for each worker, and keep it from frame to frame, since it keeps its
///        memory.
class contour_edges {
public:
    /// Finds the edges of an item's quads that may reach pixel rows [top, bottom). Edges at the
    /// upper and left end of the item's quads belong to this item; edges at their lower and right
    /// end belong to the neighbouring items.
    /// Returns: edges that stay valid until the next call.
    std::span<const contour_edge> find(const band_list& list, const band_item& item,
                                       std::int32_t top, std::int32_t bottom);

private:
    void add_row(const l3d_surface_part& part, const grid_cells& cells, int row);
    void add_between(const l3d_micro_vertex& from, const l3d_micro_vertex& to, bool right_turns,
                     bool left_turns);
    void add_spokes(const l3d_micro_grid& grid, int row, int column);

    /// The bits of a row of quads: first a bit for each quad that turns to the right, then a bit
    /// for each folded quad.
    std::vector<std::uint64_t> above_, here_;
    std::vector<contour_edge> edges_;
};

} // namespace l3d_detail

#endif
