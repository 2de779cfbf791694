// SPDX-License-Identifier: MIT
// l3d_rasterizer_factory_sw: makes rasterizers whose classes its users need not see.
#include "raster/rasterizer_factory.h"

#include "raster/paths/path.h"
#include "raster/shapes/rasterizer_2d_sw.h"
#include "raster/surfaces/surface_rasterizer_sw.h"

namespace {

/// Draws polygons of one colour as paths, and lines by Wu's algorithm. So a program that is written
/// for hard edges gets smooth edges. All other calls draw as l3d_rasterizer_2d_sw_imp does.
class rasterizer_2d_smooth final : public l3d_rasterizer_2d_sw_imp {
public:
    using l3d_rasterizer_2d_sw_imp::l3d_rasterizer_2d_sw_imp;

private:
    void do_draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) override;
    void do_draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) override;
    void do_draw_polygon_flatshaded(l3d_outline_2d corners, std::uint32_t color) override;
};

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

} // namespace

std::unique_ptr<l3d_rasterizer_2d_imp>
l3d_rasterizer_factory_sw::do_create_2d(l3d_pixels target) const {
    if (edges_ == l3d_edges::smooth)
        return std::make_unique<rasterizer_2d_smooth>(target);
    return std::make_unique<l3d_rasterizer_2d_sw_imp>(target);
}

std::unique_ptr<l3d_surface_rasterizer>
l3d_rasterizer_factory_sw::do_create_surface(l3d_workers& workers) const {
    return std::make_unique<l3d_surface_rasterizer_sw>(workers);
}
