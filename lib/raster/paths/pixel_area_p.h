// SPDX-License-Identifier: MIT
// pixel_area: finds the area of one pixel that lies inside of edges that cross each other.
#ifndef L3D_RASTER_PATHS_PIXEL_AREA_P_H
#define L3D_RASTER_PATHS_PIXEL_AREA_P_H

#include "raster/paths/covered_span_p.h"
#include "raster/paths/pixel_edges_p.h"
#include "raster/paths/row_areas_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace l3d_detail {

/// Finds the exact covered area of a pixel from all edges that reach it.
///
/// Bounds of the winding number often prove that the whole pixel lies inside or outside. Where many
/// outlines pass under the nonzero rule, the bounds are found for parts of the pixel, and often
/// prove the same for each part.
///
/// Otherwise the borders of the inside are found. The winding number on an edge's left changes
/// along the edge where other edges cross it, begin or end. The parts of the edge that have the
/// inside on one side only are borders, and add to the area. If rounding may tell wrong which of
/// two edges is on the left, the pixel is cut into slabs.
/// Cost:    the square of the number of edges. Slabs take n log n for n edges, times the number of
///          slabs.
class pixel_area {
public:
    /// Begins a pixel without edges.
    void begin() { blocks_.clear(), edges_ = {}; }

    /// Adds the edges of a layer that reach the pixel. Their records are a list in `all`. The list
    /// begins with index `last`, and each record's `before` is the index of the next record.
    void add(const edge_record* all, std::uint32_t last, std::size_t layer);

    /// The area inside, from 0 to 1, of the pixel with this top left corner. `sums` are the
    /// integrals of both layers' winding numbers over the pixel, from which the winding numbers at
    /// the corner follow.
    double inside(const l3d_point_2d& corner, const std::array<double, 2>& sums,
                  std::uint32_t visits, const fill_rules& rules);

private:
    static constexpr std::uint64_t all_fields = ~std::uint64_t{0};
    /// The least and the largest winding number in the pixel.
    struct windings_range {
        int least = 0, most = 0;
    };
    windings_range find_range() const;
    std::optional<double> between_borders(const windings& corner, const windings& beside,
                                          const fill_rules& rules);
    row_edge border(const edge_block& b, std::size_t lane, std::size_t i) const;
    void find_changes();
    double on_left(windings beside, const fill_rules& rules) const;
    double slabs(const windings& corner, const fill_rules& rules);

    kept_list<edge_block> blocks_;
    pixel_edges edges_;
    /// Changes of the winding number along the pixel's left side.
    kept_list<winding_change> changes_;
    /// Changes on the left of an edge, where other edges cross it, begin or end.
    kept_list<winding_change> passed_;
    std::vector<row_edge> slab_edges_;
    row_areas slabs_;
};

} // namespace l3d_detail

#endif
