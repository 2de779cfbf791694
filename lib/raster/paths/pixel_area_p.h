// SPDX-License-Identifier: MIT
// pixel_area: the area of one pixel that lies inside of edges that cross each other.
#ifndef L3D_RASTER_PATHS_PIXEL_AREA_P_H
#define L3D_RASTER_PATHS_PIXEL_AREA_P_H

#include "raster/paths/row_areas_p.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// How an outline comes to be in a pixel where an edge begins.
enum class cell_begin : std::uint8_t {
    enters,    ///< by the pixel's sides
    continues, ///< by the edge before
    unclear,   ///< its first corner lies in the pixel, or it may cross itself there
};

/// The part of an outline's edge in one pixel.
struct edge_cell {
    l3d_point_2d top, bottom;
    std::int8_t direction;  ///< 1 if the outline leads upwards, which adds 1 to the winding on the
                            ///< right; -1 if downwards; 0 if the edge is level
    std::uint8_t layer;     ///< 0: an edge of the filled path; 1: of its clip path
    std::int8_t below_left; ///< if the edge crosses the pixel's left side: what this adds to the
                            ///< windings along the side, below the crossing; else 0
    cell_begin begin;
};

/// Finds the exact covered area of a pixel from all edges that reach it.
///
/// Edges may cross and lie upon each other. The pixel is cut at their ends and crossings. Between
/// two cuts edges have an order from left to right. Edges count only if one side is inside and the
/// other outside.
/// Cost:    n log n for n edges, times the number of their ends, and some more for each crossing.
class pixel_area {
public:
    /// Begins a pixel without edges.
    void begin(std::int32_t column);

    /// Adds an edge that reaches the pixel. Edges come in the order opposite to their outlines'.
    void add(const edge_cell& cell);

    /// The area inside, from 0 to 1. `sums` are the integrals of both layers' windings over the
    /// pixel; they tell the windings at its corner.
    double inside(const std::array<double, 2>& sums, const fill_rules& rules);

private:
    void end_visit();
    bool is_wound_about(int corner) const;

    double column_ = 0;
    std::array<double, 2> own_{}; ///< the part of the sums that the edges of the pixel add
    double visit_ = 0;            ///< the part that edges of the present visit add
    double shares_ = 0; ///< the sum of the shares of the pixel that lie on the visits' higher sides
    int visits_ = 0;
    bool is_unclear_ = false; ///< whether visits may not lead from side to side once
    /// The edges' parts in the pixel, with x from 0 to 1.
    std::vector<row_edge> parts_;
    std::vector<winding_change> changes_; ///< along the pixel's left side
    row_areas slabs_;
};

} // namespace l3d_detail

#endif
