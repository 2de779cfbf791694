// SPDX-License-Identifier: MIT
// winding_scan: finds the pixels inside of outlines of any form, span by span.
#ifndef L3D_RASTER_SHAPES_WINDING_SCAN_P_H
#define L3D_RASTER_SHAPES_WINDING_SCAN_P_H

#include "raster/rasterizer_2d.h"
#include "raster/shapes/scan_edge_p.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A span of columns first <= column < last in a row.
struct pixel_span {
    std::int32_t row, first, last;
};

/// Finds the spans inside of outlines. It walks down the rows, and keeps the edges that cross a row
/// in the order of their columns.
///
/// Each edge counts for the pixels from its column on. So inside and outside are exact for every
/// pixel, however close edges cross.
/// Cost: for each row, one step and about one comparison for each edge that crosses it. Allocates
///       when there are more edges or spans than ever before.
class winding_scan {
public:
    /// The spans of outlines in a picture of this size, from top to bottom and left to right,
    /// without overlap.
    /// Lives: until the next call.
    std::span<const pixel_span> convert(std::span<const l3d_outline_2d> outlines,
                                        l3d_winding inside, l3d_size size);

private:
    struct edge {
        std::int32_t top, bottom; ///< the edge crosses rows top <= row < bottom
        /// 1 if the edge leads upwards, and so winds clockwise around places on its right; else -1.
        int direction;
        exact_edge columns;
    };
    struct crossing {
        std::int32_t column;
        int direction;
        std::size_t edge;
    };

    void add_outline(l3d_outline_2d outline, std::int32_t height);
    void add_edge(far_point from, far_point to, std::int32_t height);
    void sort_crossings();
    void add_spans(std::int32_t row, l3d_winding inside, std::int32_t width);
    void step_to(std::int32_t row);

    std::vector<edge> edges_;
    std::vector<crossing> crossings_;
    std::vector<pixel_span> spans_;
};

} // namespace l3d_detail

#endif
