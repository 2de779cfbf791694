// SPDX-License-Identifier: MIT
// band_scalar: fills parts of surfaces into a band, one polygon after the other, with any shader.
#ifndef L3D_RASTER_SURFACES_BAND_SCALAR_P_H
#define L3D_RASTER_SURFACES_BAND_SCALAR_P_H

#include "raster/surfaces/band_cells_p.h"
#include "raster/surface_rasterizer.h"
#include "raster/surfaces/surface_target_p.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace l3d_detail {

/// Fills the polygons of a band with any shader, as the slow twin of the fill kernel. Polygons that
/// the kernel does not take are filled by rows in lanes, with the same bits as pixel by pixel.
///
/// The planes of a quad's numbers have the corners' mean in its middle, and the corners'
/// differences along both diagonals. So no diagonal shows. Quads far from a parallelogram are
/// filled as two triangles.
/// Lives: borrows the band, the shading and the materials of begin().
/// Cost:  allocates only when a band is higher than any before.
class band_scalar {
public:
    /// Makes room so that drawing bands of this many rows allocates nothing.
    void reserve(int rows) { target_.scan.set_rows({0, rows}); }

    /// Begins a band: later calls draw into it, and counts start at 0.
    void begin(const fill_band& band, const l3d_shading& shading,
               std::span<const l3d_material> materials, const fill_words& words);

    void fill(const l3d_surface_part& part, const grid_cells& cells);

    /// Fills triangles [first, last) of a part.
    void fill(const l3d_surface_part& part, std::size_t first, std::size_t last);

    /// Fills the polygons that the fill kernel did not take. Expects: a band of at least
    /// fill_least_width.
    void fill(const fill_rest& rest);

    /// Fills the part of a triangle that cuts leave.
    /// Expects: a mode other than `error`, as such a triangle has no part that gives a colour.
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
