// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer_sw: the surface rasterizer on the CPU.
#ifndef L3D_RASTER_SURFACE_RASTERIZER_SW_H
#define L3D_RASTER_SURFACE_RASTERIZER_SW_H

#include "raster/surface_rasterizer.h"
#include "raster/surface_target_p.h"

/// Fills surfaces with exact integer coverage and attributes that are linear in the picture.
///
/// A quad's attribute plane is the one through its two diagonals' differences and the mean of its
/// corners, so no diagonal shows; quads far from a parallelogram are filled as two triangles.
/// Units:   normals of 1e-18 to 1e18 in length; a zero normal gets the ambient grey, and the middle
///          grey in mode `normals`.
/// Expects: begin before anything is drawn. One object serves one thread.
/// Cost:    allocates in begin only, when the picture is higher than any before.
class l3d_surface_rasterizer_sw final : public l3d_surface_rasterizer {
private:
    void do_begin(l3d_pixels target, l3d_depth_buffer& depth, const l3d_shading& shading) override;
    void do_set_error_color(std::uint32_t color) override { error_color_ = color; }
    void do_draw_grid(const l3d_micro_grid& grid) override;
    void do_draw_triangle(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                          const l3d_micro_vertex& c) override;
    const l3d_surface_counts& do_counts() const override { return target_.counts; }

    template <class Draw> void with_shader(const Draw& draw);

    l3d_detail::surface_target target_;
    std::uint32_t error_color_ = 0x00ffffff;
};

#endif
