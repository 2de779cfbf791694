// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_sw_imp: points, lines and flat polygons on the CPU.
#ifndef L3D_RASTER_RASTERIZER_2D_SW_H
#define L3D_RASTER_RASTERIZER_2D_SW_H

#include "raster/rasterizer_2d.h"
#include "raster/scan_polygon_p.h"

#include <vector>

/// Writes pixel words into memory, whichever screen they belong to.
///
/// Cost: allocates when the target is higher, or a polygon has more corners, than any before.
class l3d_rasterizer_2d_sw_imp final : public l3d_rasterizer_2d_imp {
public:
    explicit l3d_rasterizer_2d_sw_imp(l3d_pixels target) { do_set_target(target); }

private:
    void do_set_target(l3d_pixels target) override;
    void do_clear_buffer() override;
    void do_draw_point(int x, int y, std::uint32_t color) override;
    void do_draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) override;
    void do_draw_polygon_flatshaded(std::span<const l3d_point_2d> corners,
                                    std::uint32_t color) override;

    void draw_line(const l3d_line_2d& line, std::uint32_t color);

    l3d_pixels target_;
    l3d_detail::scan_polygon scan_;
    std::vector<l3d_detail::scan_point> corners_;
};

#endif
