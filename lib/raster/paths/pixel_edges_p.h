// SPDX-License-Identifier: MIT
// pixel_edges: the edges of a pixel in lanes, and the numbers that vectors find for them.
#ifndef L3D_RASTER_PATHS_PIXEL_EDGES_P_H
#define L3D_RASTER_PATHS_PIXEL_EDGES_P_H

#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// The way by which an outline reaches the place in a pixel at which an edge begins.
enum class cell_begin : std::uint8_t {
    enters, ///< the outline enters by the pixel's top, right or bottom side, or by an unknown side
    continues,   ///< the edge begins where the outline's edge before it ends
    unclear,     ///< the outline begins at a corner in the pixel, or may cross itself in the pixel
    enters_left, ///< the outline enters by the pixel's left side
};

/// The number of visits that marks a pixel in which an outline may cross itself.
constexpr std::uint32_t unclear_visits = 1 << 30;

/// A part of an edge in a pixel, in the direction of its outline.
struct edge_record {
    static constexpr std::uint32_t mark_bits = 3, marks = 7, begins = 3, leaves_left = 4;

    l3d_point_2d from, to;
    /// Index of the record that was added to the pixel's list before this record; 0 for none.
    std::uint32_t before;
    /// The edge's index, above mark_bits lower bits. The lower bits hold the edge's cell_begin, and
    /// leaves_left if the edge leaves the pixel by its left side.
    std::uint32_t edge;

    std::uint32_t index() const { return edge >> mark_bits; }
};

/// Some edges of a pixel, one in each lane.
///
/// The winding number must not change where an edge meets the pixel's left side. So an edge whose
/// upper end lies on that side goes on upwards along it, and an edge whose lower end lies on that
/// side goes on downwards. A horizontal edge counts only by this part along the left side.
/// Units:   x and y from 0 to 1, from the pixel's top left corner.
struct alignas(64) edge_block {
    static constexpr std::size_t size = 8;
    using numbers = std::array<double, size>;

    /// The upper and the lower end of each edge. Before place_edges, they are the beginning and the
    /// end of the edge in the picture.
    numbers x0, y0, x1, y1;
    numbers slope; ///< dx / dy; 0 for a horizontal edge
    /// 1 for an edge that leads upwards, which adds 1 to the winding on its right; else -1. A
    /// horizontal edge apart from the left side has 0.
    numbers turns;
    /// As `turns` if the edge's upper end (for down_left: its lower end) is on the pixel's left
    /// side, else 0.
    numbers up_left, down_left;
    numbers adds;        ///< the edge's part of the integral of the winding number over the pixel
    numbers top, bottom; ///< the heights between which the edge may be a border of the inside
    std::array<std::uint32_t, size> edge; ///< as edge_record::edge

    double x_at(std::size_t lane, double y) const {
        return x0[lane] + (y - y0[lane]) * slope[lane];
    }
    cell_begin begins(std::size_t lane) const {
        return static_cast<cell_begin>(edge[lane] & edge_record::begins);
    }
    std::uint32_t index(std::size_t lane) const { return edge[lane] >> edge_record::mark_bits; }
    /// The vector from an edge's beginning to its end.
    l3d_point_2d way(std::size_t lane) const {
        return {(x0[lane] - x1[lane]) * turns[lane], (y0[lane] - y1[lane]) * turns[lane]};
    }
};

/// All edges of a pixel: first the edges of layer 0, then those of layer 1.
struct pixel_edges {
    std::span<edge_block> blocks;
    std::size_t count = 0, first_clip = 0;

    std::size_t layer(std::size_t i) const { return i < first_clip ? 0 : 1; }

    /// Calls take(block, lane, index) for each edge.
    template <class Take> void visit(const Take& take) const {
        for (std::size_t first = 0; first < count; first += edge_block::size) {
            edge_block& b = blocks[first / edge_block::size];
            const std::size_t lanes = std::min(count - first, edge_block::size);
            for (std::size_t lane = 0; lane < lanes; ++lane)
                take(b, lane, first + lane);
        }
    }
};

/// Sums over all edges of a pixel: `own` is the part of the winding number's integral that the
/// edges add. `before` is the winding number on the left of all edges, less the winding number at
/// the pixel's corner.
struct edge_sums {
    double own, before;
};

/// Places the edges in the pixel with this top left corner, and computes all other members of their
/// blocks. Rounding never puts an edge's ends beyond the pixel.
edge_sums place_edges(const pixel_edges& edges, const l3d_point_2d& corner);

/// Finds the fields of a pixel, its 8 x 8 equal parts, in which the winding number may be 0. It
/// returns a bit for each field, row by row. `beside` is the winding number on the left of all
/// edges. `sign` is -1 if the winding numbers are to be negated, else 1. Expects: all edges are of
/// layer 0.
std::uint64_t find_open(const pixel_edges& edges, int beside, int sign);

/// Sets each edge's `top` and `bottom` to the heights between which it may pass fields of
/// find_open; an edge that passes none of these fields gets an empty range.
void set_heights(const pixel_edges& edges, std::uint64_t open);

} // namespace l3d_detail

#endif
