// SPDX-License-Identifier: MIT
// visit_coverage: visits the rows of a covered rectangle that are in a picture.
#ifndef L3D_RASTER_SHAPES_VISIT_COVERAGE_P_H
#define L3D_RASTER_SHAPES_VISIT_COVERAGE_P_H

#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Calls visit(x, y, values) for each row of a shape that reaches a picture of this size. (x, y) is
/// the row's first pixel in the picture, and `values` is the coverage from this pixel on.
template <class Visit>
void visit_coverage(const l3d_coverage_2d& shape, l3d_size size, const Visit& visit) {
    // A shape may begin anywhere: its end may be beyond the largest int.
    const auto end = [](int begin, int length, int most) {
        return static_cast<int>(std::min<std::int64_t>(std::int64_t{begin} + length, most));
    };
    const int left = std::max(shape.left, 0), right = end(shape.left, shape.width, size.width);
    const int top = std::max(shape.top, 0), bottom = end(shape.top, shape.height, size.height);
    for (int y = top; y < bottom && left < right; ++y)
        visit(left, y,
              shape.row(y - shape.top)
                  .subspan(static_cast<std::size_t>(std::int64_t{left} - shape.left),
                           static_cast<std::size_t>(right - left)));
}

} // namespace l3d_detail

#endif
