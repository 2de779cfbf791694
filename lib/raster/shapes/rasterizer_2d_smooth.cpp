// SPDX-License-Identifier: MIT
// rasterizer_2d_smooth: each hard shape by a smooth call.
#include "raster/shapes/rasterizer_2d_smooth_p.h"

#include "raster/paths/path.h"

namespace l3d_detail {

void rasterizer_2d_smooth::do_draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) {
    const l3d_line_2d line{x0, y0, x1, y1};
    do_draw_lines({&line, 1}, color);
}

void rasterizer_2d_smooth::do_draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) {
    l3d_rasterizer_2d smooth(*this);
    for (const auto& [x0, y0, x1, y1] : lines)
        smooth.draw_line_antialiased({double(x0), double(y0)}, {double(x1), double(y1)}, color);
}

void rasterizer_2d_smooth::do_draw_polygon_flatshaded(l3d_outline_2d corners, std::uint32_t color) {
    if (corners.empty())
        return;
    l3d_path path;
    path.move_to(corners.front());
    for (const l3d_point_2d& corner : corners.subspan(1))
        path.line_to(corner);
    l3d_rasterizer_2d(*this).draw_path(path, {.color = color});
}

} // namespace l3d_detail
