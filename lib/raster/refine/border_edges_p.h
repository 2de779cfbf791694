// SPDX-License-Identifier: MIT
// border_edges: finds the borders of parts at which a surface ends, folds over or has a crease.
#ifndef L3D_RASTER_REFINE_BORDER_EDGES_P_H
#define L3D_RASTER_REFINE_BORDER_EDGES_P_H

#include "raster/refine/contour_edges_p.h"
#include "raster/surfaces/band_list_p.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Finds the borders of a band's parts that are contours. Two parts that share an edge have the
/// same vertices along it, bit by bit. If both parts lie on the same side of the edge in the
/// picture, the surface folds over at the edge. If the parts lie on different sides, the surface
/// continues. Then the edge is a contour only if the levels on both sides differ.
/// Lives: make one object for each worker, and keep it from frame to frame, since it keeps its
///        memory.
class border_edges {
public:
    /// Starts a band: the pixel rows [top, bottom).
    void begin(std::int32_t top, std::int32_t bottom) {
        top_ = top;
        bottom_ = bottom;
        edges_.clear();
    }

    /// Adds the border edges of an item's quads or triangles.
    void add(const band_item& item);

    /// Finds the contours among the added edges. Returns: edges that stay valid until the next
    /// call.
    std::span<const contour_edge> match();

private:
    enum class kind : unsigned char { contour, inside, always };
    struct border {
        contour_edge edge;
        float level;
        kind is;
    };

    bool reaches_rows(const l3d_border_edge& edge) const;
    void add_edge(const l3d_border_edge& edge, int turn);

    std::int32_t top_ = 0, bottom_ = 0;
    std::vector<border> edges_;
    /// A hash table; its numbers are 1 + the index of an edge, 0 for none.
    std::vector<std::uint32_t> table_;
    std::vector<contour_edge> contours_;
};

} // namespace l3d_detail

#endif
