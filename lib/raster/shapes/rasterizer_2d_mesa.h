// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d_mesa_imp: points, lines and polygons through GL.
#ifndef L3D_RASTER_SHAPES_RASTERIZER_2D_MESA_H
#define L3D_RASTER_SHAPES_RASTERIZER_2D_MESA_H

#include "raster/mesa_target_p.h"
#include "raster/shapes/rasterizer_2d_sw.h"

#include <array>
#include <vector>

/// Draws the same pixels as l3d_rasterizer_2d_sw_imp, through GL.
///
/// All shapes become triangles on the lattice of 1/256 pixel, which GL fills by the same fill rule.
/// Points, the straight runs of a line and the spans of outlines are drawn as rectangles. GL's own
/// lines and polygons do not serve: its lines leave open which of two equally near pixels is lit,
/// and its polygons must be convex.
///
/// Pixel words are the same, too, except where GL computes colours: in Gouraud-shaded polygons,
/// smooth lines and coverage. In these, red, green and blue may differ by 1. The CPU draws shapes
/// that GL cannot draw exactly. These include polygons that reach further than 8191 pixels from the
/// middle of the picture, and all shapes in pictures larger than GL's largest.
/// Cost:    drawing only gathers triangles. The target's picture is copied to GL before the first
///          batch after finish, set_target, or a shape that the CPU draws. The picture is copied
///          back in finish.
class l3d_rasterizer_2d_mesa_imp final : public l3d_rasterizer_2d_imp {
public:
    /// Errors:  l3d_error(no_backend) if this GL does not compile the shaders.
    l3d_rasterizer_2d_mesa_imp(std::unique_ptr<l3d_detail::mesa_context> context,
                               l3d_pixels target);

private:
    void do_set_target(l3d_pixels target) override;
    void do_finish() override;
    void do_clear_buffer(std::uint32_t color) override;
    void do_draw_point(int x, int y, std::uint32_t color) override;
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

    struct vertex {
        float x, y;
        /// The vertex's red, green and blue, and the word's highest byte or the coverage.
        std::array<std::uint8_t, 4> color;
    };
    /// The state of the picture in GL, compared with the target's: GL has no picture, a black
    /// picture, or a newer picture than the target's.
    enum class held { not_at_all, as_black, newer_than_target };
    /// The meaning of the highest byte of colours in the batch: the word's own byte, or coverage.
    enum class blending { off, by_coverage };

    void draw_line(const l3d_line_2d& line, std::uint32_t color);
    void add_rectangle(int left, int top, int right, int bottom, std::uint32_t color);
    void add(float x, float y, std::uint32_t color);
    void add(const l3d_detail::far_point& corner, std::uint32_t color);
    bool reaches(const l3d_detail::far_point& corner) const;
    void set_blending(blending wanted);
    void flush();

    l3d_detail::mesa_target gl_target_;
    l3d_pixels target_;
    bool fits_ = false; ///< whether GL can hold the picture
    held held_ = held::not_at_all;
    blending blending_ = blending::off;
    std::vector<vertex> batch_;
    l3d_detail::polygon_corners corners_;
    l3d_detail::winding_scan winding_;
    l3d_rasterizer_2d_sw_imp cpu_imp_;
    l3d_rasterizer_2d cpu_;
};

#endif
