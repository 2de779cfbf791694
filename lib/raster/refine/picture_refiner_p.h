// SPDX-License-Identifier: MIT
// picture_refiner: anti-aliasing of a picture that has been drawn.
#ifndef L3D_RASTER_REFINE_PICTURE_REFINER_P_H
#define L3D_RASTER_REFINE_PICTURE_REFINER_P_H

#include "raster/parallel/workers.h"
#include "raster/refine/band_fragments_p.h"
#include "raster/refine/border_edges_p.h"
#include "raster/refine/contour_edges_p.h"
#include "raster/refine/depth_steps_p.h"
#include "raster/pixel_bits.h"
#include "raster/surfaces/band_list_p.h"
#include "raster/surfaces/coarse_depth_p.h"

#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// The data of a frame that refining needs: all of its items, and what has been drawn of them.
struct drawn_frame {
    const l3d_pixels& target;
    l3d_depth_buffer& depth; ///< depth of the whole picture
    const l3d_shading& shading;
    std::span<const l3d_material> materials;
    std::span<const std::uint32_t> colors; ///< colours of the materials, if words are levels
    const band_list& list;
    const coarse_depth& coarse;
    l3d_pixel_box window; ///< the drawn part of the target
    int rows = 0;         ///< rows of a band
};

/// Finds the pixels at edges, and draws these again: those that a contour passes through where it
/// is not hidden, and both sides of jumps of level. A pixel then shows the mean light of what is
/// seen at its 64 samples.
///
/// Pixels of a band depend on the items of the frame, and on the levels and depths beside them
/// before any pixel was refined. So they depend neither on the bands nor on the number of workers.
/// Lives: kept for its memory.
class picture_refiner {
public:
    /// Expects: one draws at a time; items have the boxes of all squares that they reach.
    /// Returns how many pixels were refined.
    std::int64_t refine(const drawn_frame& frame, l3d_workers& workers);

private:
    /// Shape: begins two cache lines, so that workers do not take each other's.
    struct alignas(128) worker_space {
        contour_edges edges;
        border_edges borders;
        band_fragments fragments;
        std::int64_t refined = 0;
    };

    void find_edges(const drawn_frame& frame, int band, worker_space& space);
    void join_marks(const drawn_frame& frame, const l3d_pixel_box& box);
    void draw_marked(const drawn_frame& frame, int band, worker_space& space);

    level_jumps jumps_;
    l3d_pixel_bits marks_; ///< pixels that are sampled
    std::vector<worker_space> each_worker_;
};

/// Writes the words of a band's marked pixels: the mean of the light at the middles of polygons'
/// seen parts, weighted by the number of samples. If `has_color`, polygons have the colours of
/// materials.
/// Expects: `band` is finished.
void light_pixels(const band_fragments& band, const l3d_shading& shading,
                  std::span<const l3d_material> materials, bool has_color,
                  const l3d_pixels& target);

} // namespace l3d_detail

#endif
