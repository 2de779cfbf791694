// SPDX-License-Identifier: MIT
// l3d_painter: fills triangles over each other in a given order, without any depth buffer.
#ifndef L3D_RASTER_ZSORT_PAINTER_H
#define L3D_RASTER_ZSORT_PAINTER_H

#include "raster/micro_grid.h"
#include "raster/parallel/workers.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

/// A triangle of the picture.
struct l3d_painter_triangle {
    std::array<l3d_micro_vertex, 3> v;
    std::uint32_t color = 0;    ///< in mode `error`, a pixel word; else of no meaning
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
    bool in_front = false;      ///< what is kept; where both are equally near is in front
    std::uint32_t next = last;  ///< a further cut of the same piece
};

/// A thing to paint: a triangle, or the part of it that cuts leave.
///
/// If it is known which pixels a small triangle covers, `cover` has a bit for each of them: bit
/// 8 r + c for pixel (left + c, top + r). All bits stand for pixels of the picture.
struct l3d_painter_piece {
    static constexpr std::int32_t small_side = 8; ///< rows and columns of `cover`

    std::uint32_t triangle = 0;
    std::uint32_t cut = l3d_painter_cut::last; ///< the first of its cuts
    std::int32_t left = 0, top = 0;
    std::uint64_t cover = 0; ///< 0 if that is not known, or if there are cuts
};

/// What sides look like that are drawn as lines.
struct l3d_line_look {
    std::uint32_t color = 0x00ffffff;
    bool smooth = false; ///< anti-aliased
};

/// Fills by the coverage, the planes and the shaders of the surface rasterizers, so that a pixel of
/// a triangle has the same colour as there.
///
/// Cost:    keeps its memory. The workers share the picture by bands of rows; how many they are
///          changes no bit of it.
/// Lives:   borrows the workers.
class l3d_painter {
public:
    explicit l3d_painter(l3d_workers& workers);
    ~l3d_painter();
    l3d_painter(const l3d_painter&) = delete;
    l3d_painter& operator=(const l3d_painter&) = delete;

    /// Clears the picture and paints the pieces, the first at the bottom. Without materials, all is
    /// white; modes that show no light have no use for them.
    /// Expects: indices of pieces, cuts and materials name what is there.
    void paint(l3d_pixels target, const l3d_shading& shading,
               std::span<const l3d_material> materials,
               std::span<const l3d_painter_triangle> triangles,
               std::span<const l3d_painter_piece> pieces, std::span<const l3d_painter_cut> cuts);

    /// Clears the picture and draws the visible sides of the pieces as lines. Each piece is painted
    /// as background before its own sides. Of the shading, lines have the background and the fog.
    void paint_lines(l3d_pixels target, const l3d_shading& shading,
                     std::span<const l3d_painter_triangle> triangles,
                     std::span<const l3d_painter_piece> pieces,
                     std::span<const l3d_painter_cut> cuts, const l3d_line_look& look);

    /// The counts of the last call; samples are all pixels painted.
    const l3d_surface_counts& counts() const { return counts_; }

private:
    void count(std::size_t pieces);

    struct work_space;
    std::unique_ptr<work_space> work_;
    l3d_surface_counts counts_;
};

#endif
