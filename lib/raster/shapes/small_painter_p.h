// SPDX-License-Identifier: MIT
// small_painter: triangles of a few pixels, whose pixels are lit many at a time.
#ifndef L3D_RASTER_SHAPES_SMALL_PAINTER_P_H
#define L3D_RASTER_SHAPES_SMALL_PAINTER_P_H

#include "raster/micro_grid.h"
#include "raster/refine/pixel_bits_p.h"
#include "raster/shapes/open_pixels_p.h"
#include "raster/shapes/painter.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace l3d_detail {

/// Pixels that wait for their light, each with the triangle that it is of.
///
/// Shape: pixel i is in element i of each array. A normal's numbers are x, y, z and how far it
///        points away from the eye; the last of them only if it is ever above 0.
struct small_pixels {
    static constexpr std::size_t room = 64; ///< 12 KB of arrays: they stay in the nearest cache
    static constexpr std::size_t corners = 3, numbers = 4;

    alignas(64) std::int32_t x[corners][room], y[corners][room]; ///< as of l3d_micro_vertex
    alignas(64) float normal[corners][numbers][room];
    alignas(64) std::int32_t start[room]; ///< where the triangle's row begins
    alignas(64) std::int32_t row[room];
    alignas(64) std::int32_t column[room]; ///< from there
    alignas(64) std::uint32_t word[room];  ///< what the pixel will show, if its triangle is white
};

/// Paints triangles by lambert's rule, the same bits as l3d_painter paints row by row.
///
/// Lives: borrows what begin() was given until finish().
class small_painter {
public:
    /// From now on nothing is painted until there is another target.
    void rest() { shading_ = nullptr; }

    /// Expects: target.width >= fill_least_width; no fog.
    void begin(l3d_pixels target, const l3d_shading& shading);

    /// Whether this is the way to paint a piece: its pixels are known, and few. Triangles of more
    /// pixels take less time row by row, where they share a plane.
    bool takes(const l3d_painter_piece& piece) const {
        const int pixels = bits_in(piece.cover);
        return shading_ != nullptr && pixels > 0 && pixels <= most_pixels;
    }

    /// Paints what a piece has in these rows now or, at the latest, in finish(). Of `open`, unless
    /// it is null, only those pixels that are open, which are taken.
    /// Returns: the number of pixels.
    /// Expects: takes(piece).
    std::int64_t paint(const l3d_painter_piece& piece, const l3d_painter_triangle& triangle,
                       scan_rows rows, std::uint32_t color, open_pixels* open);

    /// Paints all that waits.
    void finish();

private:
    static constexpr int most_pixels = 8;

    void add(const std::array<l3d_micro_vertex, 3>& v, std::int32_t start, std::int32_t row,
             std::int32_t column, std::uint32_t color);

    const l3d_shading* shading_ = nullptr;
    bool with_away_ = false; ///< normals may point away from the eye
    l3d_pixels target_{};
    std::size_t count_ = 0;
    small_pixels waiting_;
    std::array<std::uint32_t, small_pixels::room> colors_;
    std::array<std::uint32_t*, small_pixels::room> places_;
};

} // namespace l3d_detail

#endif
