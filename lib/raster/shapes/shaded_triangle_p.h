// SPDX-License-Identifier: MIT
// shaded_triangle: the spans of a triangle whose colours are linear.
#ifndef L3D_RASTER_SHAPES_SHADED_TRIANGLE_P_H
#define L3D_RASTER_SHAPES_SHADED_TRIANGLE_P_H

#include "raster/shapes/scan_edge_p.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// A corner and its red, green and blue, 0 to 255.
struct shaded_corner {
    far_point at;
    std::array<double, 3> color;
};

/// Pixels first <= column < last of a row; the colour of column i is start + step (i - anchor).
///
/// The anchor depends on the triangle alone, so no colour depends on clipping.
struct shaded_span {
    std::int32_t row, first, last, anchor;
    std::array<float, 3> start, step;
};

/// Finds the spans of triangles: exact in coverage, colours along the edges and then across.
///
/// Every intermediate number is a mean of the corners'. Its weights are exact quotients of whole
/// numbers except for a few roundings. So nothing cancels, however thin the triangle. The roundings
/// of float remain, 2^-24 of at most 255 each: start, the step over the whole span, its product for
/// a pixel, the sum. That is less than 2^-13 in all; 2^-12 is promised.
class shaded_triangle {
public:
    /// The spans in a picture of that size. Lives: until the next call.
    std::span<const shaded_span> convert(const std::array<shaded_corner, 3>& corners,
                                         l3d_size size);

private:
    /// The beginning or end of a row; `distance` is the edge's distance from the nearest sample
    /// inside.
    struct end {
        std::int32_t column = 0;
        double distance = 0;
        std::array<double, 3> color{};
    };

    void add_edge(const shaded_corner& upper, const shaded_corner& lower, bool left,
                  std::int32_t height);
    void add_span(std::int32_t row, std::int32_t width);

    std::int32_t top_ = 0, bottom_ = 0;
    std::vector<std::array<end, 2>> ends_;
    std::vector<shaded_span> spans_;
};

} // namespace l3d_detail

#endif
