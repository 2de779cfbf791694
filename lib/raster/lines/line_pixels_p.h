// SPDX-License-Identifier: MIT
// visit_line: the pixels of a line between two vertices, for callers that decide for each whether
// to draw it.
#ifndef L3D_RASTER_LINES_LINE_PIXELS_P_H
#define L3D_RASTER_LINES_LINE_PIXELS_P_H

#include "raster/lines/line_steps_p.h"
#include "raster/surface_part.h"
#include "raster/rasterizer_2d.h"

#include <cstdint>

namespace l3d_detail {

/// The line between the pixels that contain two vertices. The vertices' places are rounded down by
/// a shift, also below zero.
inline l3d_line_2d side_of(const l3d_micro_vertex& a, const l3d_micro_vertex& b) {
    return {a.x >> l3d_subpixel_bits, a.y >> l3d_subpixel_bits, b.x >> l3d_subpixel_bits,
            b.y >> l3d_subpixel_bits};
}

/// A vertex's place in the coordinates of smooth lines, where centres of pixels have whole numbers.
/// Units:   x, y in 1/256 pixel from the picture's top left corner.
inline l3d_point_2d line_place(std::int32_t x, std::int32_t y) {
    return {double(x) / l3d_subpixel_one - 0.5, double(y) / l3d_subpixel_one - 0.5};
}

/// Calls visit(x, y, along) for the pixels of a line that lie in a picture of this size. `along`
/// goes from 0 at the line's first end to 1 at its second end. The pixels are those of
/// l3d_rasterizer_2d::draw_line.
template <class Visit> void visit_line(const l3d_line_2d& line, l3d_size size, const Visit& visit) {
    if (line.x0 == line.x1 && line.y0 == line.y1) {
        if (line.x0 >= 0 && line.x0 < size.width && line.y0 >= 0 && line.y0 < size.height)
            visit(line.x0, line.y0, 0.0);
        return;
    }
    const line_steps steps = steps_of(line, size);
    if (steps.first > steps.last)
        return;
    auto minors = steps.minors();
    const bool backwards = steps.major != (steps.x_major ? line.x0 : line.y0);
    for (std::int64_t i = steps.first; i <= steps.last; ++i) {
        const auto major = static_cast<int>(steps.major + i);
        const auto minor = static_cast<int>(steps.minor + minors.floor());
        const double along = static_cast<double>(i) / static_cast<double>(steps.length);
        visit(steps.x_major ? major : minor, steps.x_major ? minor : major,
              backwards ? 1 - along : along);
        minors.step();
    }
}

} // namespace l3d_detail

#endif
