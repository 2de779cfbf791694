// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_sw_imp: points, lines and polygons on the CPU.
#ifndef L3D_RASTER_SHAPES_RASTERIZER_2D_SW_H
#define L3D_RASTER_SHAPES_RASTERIZER_2D_SW_H

#include "raster/shapes/polygon_corners_p.h"
#include "raster/paths/path_scan_p.h"
#include "raster/rasterizer_2d.h"
#include "raster/shapes/scan_polygon_p.h"
#include "raster/shapes/shaded_triangle_p.h"
#include "raster/shapes/winding_scan_p.h"

#include <array>
#include <vector>

/// Draws by the CPU into pixel words in memory, whichever screen the words belong to.
///
/// Cost: allocates when the target is higher, or a polygon has more corners, than any before.
class l3d_rasterizer_2d_sw_imp : public l3d_rasterizer_2d_imp {
public:
    explicit l3d_rasterizer_2d_sw_imp(l3d_pixels target) { do_set_target(target); }

private:
    void do_set_target(l3d_pixels target) override;
    void do_clear_buffer(std::uint32_t color) override;
    void do_draw_point(int x, int y, std::uint32_t color) override;
    void do_draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) override;
    void do_draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) override;
    void do_draw_line_antialiased(l3d_point_2d from, l3d_point_2d to, std::uint32_t color) override;
    void do_draw_polygon_flatshaded(l3d_outline_2d corners, std::uint32_t color) override;
    void do_draw_polygon_gouraudshaded(std::span<const l3d_colored_point_2d> corners) override;
    void do_draw_outlines(std::span<const l3d_outline_2d> outlines, l3d_winding inside,
                          std::uint32_t color) override;
    void do_draw_coverage(const l3d_coverage_2d& shape, std::uint32_t color) override;
    void do_draw_path(const l3d_path& path, const l3d_fill& fill) override;
    void do_draw_image(const l3d_placed_image& image, const l3d_fill& fill) override;
    void do_draw_curves(const l3d_path& path, std::uint32_t color) override;
    void do_draw_mesh(std::span<const l3d_mesh_patch> patches) override;

    template <class Paint>
    void paint_run(const l3d_detail::covered_run& run, const Paint& paint) const;
    template <class Point> void fill_convex(std::span<const Point> corners, std::uint32_t color);

    l3d_pixels target_;
    std::array<double, 2> ends_{}; ///< the argument `ends` of fill_small_triangle
    l3d_detail::polygon_corners corners_;
    l3d_detail::scan_polygon scan_;
    l3d_detail::shaded_triangle triangle_;
    l3d_detail::winding_scan winding_;
    l3d_detail::path_scan paths_;
    std::vector<std::uint32_t> colors_;
};

#endif
