// SPDX-License-Identifier: MIT
// l3d_painter: fills triangles over each other in a given order, whatever their depth.
#ifndef L3D_RASTER_ZSORT_PAINTER_H
#define L3D_RASTER_ZSORT_PAINTER_H

#include "raster/surface_part.h"
#include "raster/depth_buffer.h"
#include "raster/parallel/workers.h"
#include "raster/shapes/plane_cut_p.h"
#include "raster/surfaces/surface_rasterizer_sw.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// A triangle of the picture.
struct l3d_painter_triangle {
    std::array<l3d_micro_vertex, 3> v;
    std::uint32_t sides = 7;    ///< bit k: the side from corner k to the next is drawn as a line
    std::uint32_t material = 0; ///< its place among the materials that it is painted with
};

/// Keeps of a triangle the pixels in which it is in front of another one's plane (or behind it).
///
/// Where two planes meet is a line in the picture, as 1/w of a plane is linear there. The pixels
/// are divided at it without gap and without overlap. No corner is made, so the pieces keep the
/// outline and the shading of the whole triangle.
struct l3d_painter_cut {
    static constexpr std::uint32_t last = ~0u;

    std::uint32_t splitter = 0; ///< the triangle of the other plane
    bool in_front =
        false; ///< the side that is kept; places where both are equally near are in front
    std::uint32_t next = last; ///< a further cut of the same piece
};

/// A thing to paint: a triangle, or the part of it that cuts leave.
struct l3d_painter_piece {
    std::uint32_t triangle = 0;
    std::uint32_t cut = l3d_painter_cut::last; ///< the first of its cuts
};

/// The look of sides that are drawn as lines.
struct l3d_line_look {
    std::uint32_t color = 0x00ffffff;
    bool smooth = false; ///< anti-aliased
};

/// Paints by the surface rasterizer. A piece's place in the order takes the place of its depth, so
/// what is later in the order is nearer. Pixels have the same colours as those of a depth buffer.
///
/// Cost:    keeps its memory. How many workers there are changes no bit.
/// Lives:   borrows the workers.
class l3d_painter {
public:
    explicit l3d_painter(l3d_workers& workers) : workers_(workers), filler_(workers) {}

    /// Clears the picture and paints the pieces, the first at the bottom. Without materials, all is
    /// white; modes that show no light have no use for them. Fog and smooth edges want depths:
    /// l3d_surface_rasterizer_sw::begin_over adds them.
    /// Expects: indices of pieces, cuts and materials name what is there.
    void paint(l3d_pixels target, const l3d_shading& shading,
               std::span<const l3d_material> materials,
               std::span<const l3d_painter_triangle> triangles,
               std::span<const l3d_painter_piece> pieces, std::span<const l3d_painter_cut> cuts);

    /// Clears the picture and draws the visible sides of the pieces as lines. A piece that is
    /// painted later hides the sides of those before it. Lines have the shading's background and
    /// its fog.
    void paint_lines(l3d_pixels target, const l3d_shading& shading,
                     std::span<const l3d_painter_triangle> triangles,
                     std::span<const l3d_painter_piece> pieces,
                     std::span<const l3d_painter_cut> cuts, const l3d_line_look& look);

    /// The counts of the last call.
    const l3d_surface_counts& counts() const { return filler_.counts(); }

private:
    void make_parts(std::span<const l3d_painter_triangle> triangles,
                    std::span<const l3d_painter_piece> pieces, bool with_materials);
    void make_cut(std::span<const l3d_painter_triangle> triangles,
                  std::span<const l3d_painter_piece> pieces, std::span<const l3d_painter_cut> cuts);

    l3d_workers& workers_;
    l3d_surface_rasterizer_sw filler_;
    std::vector<l3d_surface_part> parts_; ///< parts of whole triangles, the topmost first
    std::vector<const l3d_surface_part*> drawn_;
    std::vector<l3d_detail::cut_triangle> cut_;
    std::vector<l3d_detail::plane_cut> plane_cuts_; ///< cuts of all cut triangles
    l3d_depth_buffer places_;                       ///< in the order, of what is on top
    l3d_depth_buffer line_depths_;                  ///< depths of lines in fog
};

#endif
