// SPDX-License-Identifier: MIT
// pixel_area: the area of one pixel that lies inside of edges that cross each other.
#ifndef L3D_RASTER_PATHS_PIXEL_AREA_P_H
#define L3D_RASTER_PATHS_PIXEL_AREA_P_H

#include "raster/paths/path_chains_p.h"
#include "raster/paths/row_areas_p.h"
#include "tool_2d/pixels.h"

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

/// The part of an outline's edge in one pixel, in the direction of the outline.
/// Units:   x and y from 0 to 1, seen from the pixel's top left corner.
struct edge_cell {
    l3d_point_2d from, to;
    std::uint32_t edge;     ///< its index; that of the outline's next edge is the next one
    std::uint8_t layer;     ///< 0: an edge of the filled path; 1: of its clip path
    std::int8_t below_left; ///< if the edge crosses the pixel's left side: what this adds to the
                            ///< windings along the side, below the crossing; else 0
    cell_begin begin;
};

/// Finds the exact covered area of a pixel from all edges that reach it.
///
/// The range of windings may tell that all of the pixel is inside, or none. If not, and a few
/// visits do not cross, the winding on either side of each is known. The area is then a sum over
/// the visits that have inside on one side and outside on the other.
///
/// Other pixels are cut into slabs at the ends and crossings of edges. Within a slab edges have an
/// order from left to right, which tells the windings between them. Where many visits meet under
/// the nonzero rule, only those fields of the pixel are cut that may have places outside.
/// Cost:    the square of the number of edges, where visits do not cross. A cut takes n log n for n
///          edges, times the number of slabs.
class pixel_area {
public:
    /// Begins a pixel without edges.
    void begin();

    /// Adds an edge that reaches the pixel. Edges come in the order opposite to their outlines'.
    void add(const edge_cell& cell);

    /// The area inside, from 0 to 1. `sums` are the integrals of both layers' windings over the
    /// pixel; they tell the windings at its corner.
    double inside(const std::array<double, 2>& sums, const fill_rules& rules);

private:
    /// A pixel has as many rows and columns of fields.
    static constexpr int fields = 8;
    /// The least and the most winding anywhere in the pixel.
    struct windings_range {
        int least, most;
    };
    /// A visit: a way of an outline through the pixel, from side to side. On its one side, the
    /// higher one, the winding is higher by 1 than on the other.
    struct visit {
        std::size_t first, end; ///< its edges
        double adds = 0;        ///< its part of the sum
        int lower = 0;          ///< the winding on its lower side
    };
    enum class side { unknown, lower, higher };

    void find_open(int corner);
    windings_range range(int least) const;
    side side_of(const visit& of, const visit& other) const;
    bool find_lower(int least);
    double cut(const windings& corner, const fill_rules& rules);
    double box(const l3d_pixel_box& of, const windings& corner, const fill_rules& rules);
    double slabs(std::span<const row_edge> edges, std::span<winding_change> changes,
                 windings beside, double top, double bottom, const fill_rules& rules);

    std::vector<edge_cell> edges_;
    std::vector<visit> visits_;
    bool open_ = false;                   ///< whether the last visit waits for its first edges
    bool is_unclear_ = false;             ///< whether visits may not lead from side to side once
    std::array<double, 2> own_{};         ///< the part of the sums that the edges of the pixel add
    std::vector<row_edge> parts_;         ///< the edges that are not level
    std::vector<winding_change> changes_; ///< along the pixel's left side
    std::vector<row_edge> box_parts_;     ///< the same in a box of fields
    std::vector<winding_change> side_changes_;
    std::array<std::uint8_t, fields> open_fields_{}; ///< for each row, as bits
    row_areas slabs_;
};

} // namespace l3d_detail

#endif
