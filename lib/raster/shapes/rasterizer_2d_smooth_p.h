// SPDX-License-Identifier: MIT
// rasterizer_2d_smooth: hard shapes become smooth ones.
#ifndef L3D_RASTER_SHAPES_RASTERIZER_2D_SMOOTH_P_H
#define L3D_RASTER_SHAPES_RASTERIZER_2D_SMOOTH_P_H

#include "raster/shapes/rasterizer_2d_sw.h"

namespace l3d_detail {

/// Draws polygons of one colour as paths, and lines in Wu's way. A program that asks for hard edges
/// gets smooth ones without a change. All other calls draw as l3d_rasterizer_2d_sw_imp does.
class rasterizer_2d_smooth final : public l3d_rasterizer_2d_sw_imp {
public:
    using l3d_rasterizer_2d_sw_imp::l3d_rasterizer_2d_sw_imp;

private:
    void do_draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) override;
    void do_draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) override;
    void do_draw_polygon_flatshaded(l3d_outline_2d corners, std::uint32_t color) override;
};

} // namespace l3d_detail

#endif
