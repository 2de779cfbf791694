// SPDX-License-Identifier: MIT
// fill_kernel: micro-quads and triangles into a band of rows, many at a time in SIMD lanes.
#ifndef L3D_RASTER_FILL_KERNEL_P_H
#define L3D_RASTER_FILL_KERNEL_P_H

#include "raster/micro_grid.h"
#include "raster/micro_triangles.h"
#include "raster/surface_rasterizer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Rows [top, bottom) of a picture while they are filled.
///
/// Shape:   words and depths point at column 0 of row `top`. Pitches in elements, >= width.
/// Expects: width >= fill_least_width. Nothing outside [0, width) x [top, bottom) is touched.
struct fill_band {
    std::uint32_t* words;
    std::ptrdiff_t word_pitch;
    float* depths;
    std::ptrdiff_t depth_pitch;
    std::int32_t width, top, bottom;
};

/// A whole vector of pixels must fit a row.
inline constexpr std::int32_t fill_least_width = 16;

/// What stays the same for a frame: l3d_shading without its mode, which is lambert.
struct fill_shading {
    std::array<float, 3> light, ray, ray_right, ray_down;

    explicit fill_shading(const l3d_shading& s)
        : light(s.light), ray(s.ray), ray_right(s.ray_right), ray_down(s.ray_down) {}
};

struct fill_counts {
    std::int64_t samples = 0; ///< pixel centres tested against the depth buffer
    std::int64_t written = 0; ///< of those, nearer than what was there
};

/// Polygons that the lanes do not take: folded, skew, or larger than 64 pixels. The caller fills
/// them by the scalar filler.
struct fill_rest {
    std::vector<std::uint32_t> quads;     ///< l3d_micro_grid::index of each one's first corner
    std::vector<std::uint32_t> triangles; ///< each one's number in its l3d_micro_triangles

    void clear() {
        quads.clear();
        triangles.clear();
    }
};

/// Fills the quads of a grid whose first corner is in rows [row_begin, row_end) and columns
/// [column_begin, column_end).
///
/// The same picture as surface_fill with the lambert shader: coverage and `samples` exactly, depth
/// within 1e-5 of the corners' range, grey within one level. The same bits whatever the processor
/// and however a picture is divided into bands.
/// Expects: 0 <= row_begin, row_end < grid.rows, and so for columns; normals of unit length, or
///          zero; inv_w > 0. Counts and rest are added to.
void fill_quads(const fill_band& band, const fill_shading& shading, const l3d_micro_grid& grid,
                int row_begin, int row_end, int column_begin, int column_end, fill_counts& counts,
                fill_rest& rest);

/// Fills triangles [first, last); otherwise like fill_quads.
void fill_triangles(const fill_band& band, const fill_shading& shading,
                    const l3d_micro_triangles& triangles, std::size_t first, std::size_t last,
                    fill_counts& counts, fill_rest& rest);

} // namespace l3d_detail

#endif
