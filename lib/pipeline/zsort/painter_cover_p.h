// SPDX-License-Identifier: MIT
// painter_cover: pixels in which later pieces hide earlier ones.
#ifndef L3D_PIPELINE_ZSORT_PAINTER_COVER_P_H
#define L3D_PIPELINE_ZSORT_PAINTER_COVER_P_H

#include "raster/pixel_bits.h"
#include "raster/shapes/piece_pixels_p.h"

#include <span>
#include <vector>

namespace l3d_detail {

/// The pixels in which the pieces added so far will be painted. A new piece is painted before these
/// pieces. If it covers only these pixels, it is hidden and can be left out. The painter's own code
/// finds the pixels, so the picture stays the same.
///
/// Lives: borrows the arguments of begin().
class painter_cover {
public:
    /// Forgets all pieces, and takes the triangles and cuts that the next pieces refer to.
    void begin(l3d_size size, std::span<const l3d_painter_triangle> triangles,
               const std::vector<l3d_painter_cut>& cuts);

    void add(const l3d_painter_piece& piece);

    /// Whether added pieces cover all pixels of `piece`, and all pixels of the lines that are drawn
    /// at its sides.
    bool hides(const l3d_painter_piece& piece);

private:
    bool hides_sides(const l3d_painter_piece& piece) const;

    std::span<const l3d_painter_triangle> triangles_;
    const std::vector<l3d_painter_cut>* cuts_ = nullptr;
    l3d_pixel_bits pixels_;
    std::vector<plane_cut> placed_;
    scan_polygon scan_;
};

} // namespace l3d_detail

#endif
