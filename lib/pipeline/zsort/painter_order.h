// SPDX-License-Identifier: MIT
// l3d_painter_order: an order of triangles, cut where none is right, that paints the right picture.
#ifndef L3D_PIPELINE_ZSORT_PAINTER_ORDER_H
#define L3D_PIPELINE_ZSORT_PAINTER_ORDER_H

#include "pipeline/frame_report.h"
#include "raster/parallel/workers.h"
#include "raster/zsort/painter.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

/// Puts triangles into an order in which painting them gives the right picture. It sorts triangles
/// by their farthest corner, finds where this order is wrong, and mends it.
///
/// Only triangles that meet in the picture need an order. A triangle comes after the triangles that
/// it partly hides. Some sets of triangles have no such order, since they go through each other or
/// overlap in a circle. Such sets are the strongly connected components of more than one member.
/// Their members are cut by each other's planes until there is an order. The picture is exact,
/// except in pixels whose two nearest depths differ by less than 2^-36 of the nearest corner's
/// depth (painter_tie).
/// Cost:   sorting is linear. Comparing is linear in the pairs of triangles that lie over each
///         other within a tile of the picture. For surfaces, this is linear in the triangles. If n
///         triangles all go through each other, they may become n^2 pieces. Hidden pieces are left
///         out. Memory is kept for the next picture.
/// Source: comparisons as in Newell, Newell, Sancha: A solution to the hidden surface problem (ACM
///         1972). Cuts as in Fuchs, Kedem, Naylor: On visible surface generation by a priori tree
///         structures (SIGGRAPH 1980).
class l3d_painter_order {
public:
    /// Makes an order whose work these workers do. Lives: borrows the workers.
    explicit l3d_painter_order(l3d_workers& workers);
    ~l3d_painter_order();
    l3d_painter_order(const l3d_painter_order&) = delete;
    l3d_painter_order& operator=(const l3d_painter_order&) = delete;

    /// The kind of order that make() finds.
    struct way {
        /// Whether wrong places are mended; false sorts triangles, and compares none.
        bool resolve = true;
        /// Whether the sides of triangles are drawn as lines. If not, triangles that cover no pixel
        /// are left out. Triangles that other triangles hide in all of their pixels may be left
        /// out, too.
        bool sides = true;
    };

    /// Orders the triangles of a picture of this size. Triangles without an area are left out.
    /// Lives: borrows the triangles until the next make.
    void make(std::span<const l3d_painter_triangle> triangles, l3d_size size, const way& how);
    /// Orders triangles in the usual way: wrong places are mended, and sides are drawn.
    void make(std::span<const l3d_painter_triangle> triangles, l3d_size size) {
        make(triangles, size, way());
    }

    /// Begins to order triangles that come in chunks: chunk i ends before index ends[i]. The caller
    /// may write the triangles of a chunk until it calls note() for the chunk.
    void begin(std::span<const l3d_painter_triangle> triangles, std::span<const std::size_t> ends,
               l3d_size size, const way& how);
    /// Takes a chunk whose triangles are complete. Threads may note different chunks at the same
    /// time.
    void note(std::size_t chunk);
    /// Orders all triangles. Expects: all chunks were noted.
    void finish();

    /// The triangles that were given. Pieces and cuts refer to triangles by their indices.
    std::span<const l3d_painter_triangle> triangles() const;

    /// The pieces of triangles, in the order in which they are to be painted.
    std::span<const l3d_painter_piece> pieces() const;
    std::span<const l3d_painter_cut> cuts() const;

    const l3d_painter_order_counts& counts() const { return counts_; }

private:
    struct work_space;
    std::unique_ptr<work_space> work_;
    l3d_painter_order_counts counts_;
};

#endif
