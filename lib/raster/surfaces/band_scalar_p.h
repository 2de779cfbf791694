// SPDX-License-Identifier: MIT
// band_scalar: parts of surfaces into a band, one polygon after the other, with any shader.
#ifndef L3D_RASTER_SURFACES_BAND_SCALAR_P_H
#define L3D_RASTER_SURFACES_BAND_SCALAR_P_H

#include "raster/surfaces/band_cells_p.h"
#include "raster/surface_rasterizer.h"
#include "raster/surfaces/surface_target_p.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// The slow twin of the fill kernel, for all shaders and all polygons. Polygons that the
/// kernel left are filled by rows in lanes, pixel by pixel the same bits.
///
/// A quad's attribute plane goes through its two diagonals' differences and the mean of its
/// corners, so no diagonal shows. Quads far from a parallelogram are filled as two triangles.
/// Lives: borrows band, shading and materials.
/// Cost:  allocates only when a band is higher than any before.
class band_scalar {
public:
    /// So that no band of so many rows makes it allocate.
    void reserve(int rows) { target_.scan.set_rows({0, rows}); }

    /// From now on it draws here and counts from 0.
    void begin(const fill_band& band, const l3d_shading& shading,
               std::span<const l3d_material> materials, const fill_words& words);

    void fill(const l3d_surface_part& part, const grid_cells& cells);

    /// Triangles [first, last).
    void fill(const l3d_surface_part& part, std::size_t first, std::size_t last);

    /// The polygons that the kernel left. Expects: a band as wide as lanes want it.
    void fill(const fill_rest& rest);

    /// Fills the part of a triangle that these cuts leave. Expects: another mode than `error`,
    /// where it has no one colour.
    void fill(const cut_triangle& triangle, std::span<const plane_cut> cuts);

    const fill_counts& counts() const { return target_.counts; }

private:
    template <class Draw> void with_filler(std::uint32_t error_color, const Draw& draw);

    surface_target target_;
    const l3d_shading* shading_ = nullptr;
    std::span<const l3d_material> materials_;
};

} // namespace l3d_detail

#endif
