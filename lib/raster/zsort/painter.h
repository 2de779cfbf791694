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

/// A triangle of the picture, for l3d_painter to paint back to front.
struct l3d_painter_triangle {
    std::array<l3d_micro_vertex, 3> v;
    /// Bit k tells whether the side from corner k to the next is drawn as a line.
    std::uint32_t sides = 7;
    std::uint32_t material = 0; ///< index of the material with which the triangle is painted
};

/// A cut of a triangle by another triangle's plane. The cut keeps the pixels in which the triangle
/// is in front of this plane, or the pixels in which it is behind the plane.
///
/// Two planes meet along a line in the picture, as a plane's 1/w is linear in the picture. This
/// line divides the pixels without gap and without overlap. No corners are made, so pieces keep the
/// outline and the shading of the whole triangle.
struct l3d_painter_cut {
    static constexpr std::uint32_t last = ~0u;

    std::uint32_t splitter = 0; ///< index of the triangle whose plane cuts
    /// Whether the part in front of the plane is kept; places of equal depth are in front.
    bool in_front = false;
    /// Index of the next cut of the same piece; `last` if this is the last.
    std::uint32_t next = last;
};

/// A piece to paint: a triangle, or the part of a triangle that cuts leave.
struct l3d_painter_piece {
    std::uint32_t triangle = 0;
    /// Index of the first of the piece's cuts; `last` if it has none.
    std::uint32_t cut = l3d_painter_cut::last;
};

/// The look of triangles' sides that are drawn as lines.
struct l3d_line_look {
    std::uint32_t color = 0x00ffffff;
    bool smooth = false; ///< whether lines are anti-aliased
};

/// Paints pieces by the surface rasterizer. The order of the pieces replaces depth: later pieces
/// are nearer. Pixels have the same colours as with a depth buffer.
///
/// Cost:    keeps its memory. The number of workers changes no bit.
/// Lives:   borrows the workers.
class l3d_painter {
public:
    explicit l3d_painter(l3d_workers& workers) : workers_(workers), filler_(workers) {}

    /// Clears the picture and paints the pieces, the first at the bottom. Without materials, all
    /// pieces are white; modes that do not show light ignore materials. Fog and smooth edges need
    /// depths, so they are left to a later frame of l3d_surface_rasterizer_sw::begin_over.
    /// Expects: pieces, cuts and materials are named by valid indices.
    void paint(l3d_pixels target, const l3d_shading& shading,
               std::span<const l3d_material> materials,
               std::span<const l3d_painter_triangle> triangles,
               std::span<const l3d_painter_piece> pieces, std::span<const l3d_painter_cut> cuts);

    /// Clears the picture and draws the visible sides of the pieces as lines. Later pieces hide the
    /// sides of earlier pieces. Background and fog are those of the shading.
    void paint_lines(l3d_pixels target, const l3d_shading& shading,
                     std::span<const l3d_painter_triangle> triangles,
                     std::span<const l3d_painter_piece> pieces,
                     std::span<const l3d_painter_cut> cuts, const l3d_line_look& look);

    /// The counts of the last call of paint().
    const l3d_surface_counts& counts() const { return filler_.counts(); }

private:
    void make_parts(std::span<const l3d_painter_triangle> triangles,
                    std::span<const l3d_painter_piece> pieces, bool with_materials);
    void make_cut(std::span<const l3d_painter_triangle> triangles,
                  std::span<const l3d_painter_piece> pieces, std::span<const l3d_painter_cut> cuts);

    l3d_workers& workers_;
    l3d_surface_rasterizer_sw filler_;
    /// The surface parts of whole triangles, the topmost first.
    std::vector<l3d_surface_part> parts_;
    std::vector<const l3d_surface_part*> drawn_;
    std::vector<l3d_detail::cut_triangle> cut_;
    /// The cuts of all triangles of which cuts keep a part.
    std::vector<l3d_detail::plane_cut> plane_cuts_;
    l3d_depth_buffer places_; ///< in each pixel, the topmost piece's place in the order, as a depth
    l3d_depth_buffer line_depths_; ///< depths of lines, which tell how much fog the lines get
};

#endif
