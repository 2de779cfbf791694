// SPDX-License-Identifier: MIT
// shaded_triangle: finds the spans of a triangle whose colours are linear.
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

/// A corner of a triangle on the lattice, and its red, green and blue from 0 to 255.
struct shaded_corner {
    far_point at;
    std::array<double, 3> color;
};

/// A span of pixels first <= column < last in a row. Column i has the colour start + step (i -
/// anchor).
///
/// The anchor depends only on the triangle, so clipping changes no colour.
struct shaded_span {
    std::int32_t row, first, last, anchor;
    std::array<float, 3> start, step;
};

/// Finds the spans of Gouraud-shaded triangles. Coverage is exact; colours are interpolated along
/// edges, and then across rows.
///
/// Every intermediate number is a weighted mean of the corners' numbers. Weights are exact
/// quotients of whole numbers except for a few roundings. So nothing cancels, however thin the
/// triangle is. Four roundings of float remain, each 2^-24 of at most 255: of the start, the step
/// over the whole span, its product for a pixel, and the sum. Together they are less than 2^-13;
/// 2^-12 is promised.
class shaded_triangle {
public:
    /// The spans of a triangle in a picture of this size. Lives: until the next call.
    std::span<const shaded_span> convert(const std::array<shaded_corner, 3>& corners,
                                         l3d_size size);

private:
    /// The left or right end of the triangle in a row. `distance` is the distance of the edge from
    /// the nearest sample inside.
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
