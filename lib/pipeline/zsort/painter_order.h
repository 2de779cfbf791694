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

/// Sorts triangles by their farthest corner, finds where that order is wrong, and mends it.
///
/// Only triangles that meet in the picture need an order. Each comes after those that it partly
/// hides. Some sets have no order: triangles that go through each other, and cyclic overlaps. They
/// are the strongly connected components of more than one member, and are cut by each other's
/// planes until there is an order. The result is exact except where the two nearest depths of a
/// pixel differ by less than 2^-36 of the nearest corner's (painter_tie).
/// Cost:   sorting is linear. Comparing is linear in the number of triangles that lie over each
/// other within a tile of the picture; for surfaces, in the number of triangles. A set of n that
/// all go through each other may become n^2 pieces if all of them are seen; hidden ones are left
/// out. Keeps its memory.
/// Source: comparisons as in Newell, Newell, Sancha: A solution to the hidden surface problem (ACM
/// 1972). Cuts as in Fuchs, Kedem, Naylor: On visible surface generation by a priori tree
/// structures (SIGGRAPH 1980).
class l3d_painter_order {
public:
    /// Lives: borrows the workers.
    explicit l3d_painter_order(l3d_workers& workers);
    ~l3d_painter_order();
    l3d_painter_order(const l3d_painter_order&) = delete;
    l3d_painter_order& operator=(const l3d_painter_order&) = delete;

    /// The kind of order.
    struct way {
        bool resolve = true; ///< false for the plain painter's algorithm: sorted, nothing compared
        /// Whether sides of triangles are drawn. If not, triangles that cover no pixel are left
        /// out. Triangles that are behind others in all of their pixels may be left out, too.
        bool sides = true;
    };

    /// Orders the triangles of a picture of this size. Triangles without an area are left out.
    /// Lives: borrows the triangles until the next make.
    void make(std::span<const l3d_painter_triangle> triangles, l3d_size size, const way& how);
    /// Orders all triangles that may have pixels or sides.
    void make(std::span<const l3d_painter_triangle> triangles, l3d_size size) {
        make(triangles, size, way());
    }

    /// Begins to order triangles that come in chunks, which end at `ends`. The triangles of a chunk
    /// may be written until note() is called for it.
    void begin(std::span<const l3d_painter_triangle> triangles, std::span<const std::size_t> ends,
               l3d_size size, const way& how);
    /// Takes a chunk whose triangles are complete. Threads may note chunks side by side.
    void note(std::size_t chunk);
    /// Orders all triangles. Expects: all chunks were noted.
    void finish();

    /// The given triangles, whose indices pieces and cuts refer to.
    std::span<const l3d_painter_triangle> triangles() const;

    /// The pieces in the order in which they are to be painted.
    std::span<const l3d_painter_piece> pieces() const;
    std::span<const l3d_painter_cut> cuts() const;

    const l3d_painter_order_counts& counts() const { return counts_; }

private:
    struct work_space;
    std::unique_ptr<work_space> work_;
    l3d_painter_order_counts counts_;
};

#endif
