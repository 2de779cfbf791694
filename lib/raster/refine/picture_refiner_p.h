// SPDX-License-Identifier: MIT
// picture_refiner: smooths the edges of a picture that has been drawn.
#ifndef L3D_RASTER_REFINE_PICTURE_REFINER_P_H
#define L3D_RASTER_REFINE_PICTURE_REFINER_P_H

#include "raster/parallel/workers.h"
#include "raster/refine/band_fragments_p.h"
#include "raster/refine/border_edges_p.h"
#include "raster/refine/contour_edges_p.h"
#include "raster/pixel_bits.h"
#include "raster/surfaces/band_list_p.h"
#include "raster/surfaces/coarse_depth_p.h"

#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// The data of a frame that refining needs: all items of the frame, and the picture drawn from the
/// items.
struct drawn_frame {
    const l3d_pixels& target;
    l3d_depth_buffer& depth; ///< the depths of the whole picture
    const l3d_shading& shading;
    std::span<const l3d_material> materials;
    /// The materials' colours, if pixel words are levels of materials.
    std::span<const std::uint32_t> colors;
    const band_list& list;
    const coarse_depth& coarse;
    l3d_pixel_box window; ///< the part of the picture that the frame draws
    int rows = 0;         ///< the number of rows in a band
};

/// Finds the pixels at edges, and draws them again with anti-aliasing. A pixel is at an edge if a
/// visible contour passes through it, or if the level jumps from it to a neighbour. Each pixel at
/// an edge then shows the mean light of its 64 samples.
///
/// The pixels of a band depend on the items of the frame, and on the unrefined levels and depths
/// around the pixels. So refined pixels depend neither on the division into bands nor on the number
/// of workers.
/// Lives: keep the object from frame to frame, since it keeps its memory.
class picture_refiner {
public:
    /// Refines the picture of a frame, and returns the number of refined pixels.
    /// Expects: one call at a time; the boxes of items hold all squares of pixels that the items
    ///          reach.
    std::int64_t refine(const drawn_frame& frame, l3d_workers& workers);

private:
    /// The memory of one worker.
    /// Shape: begins a pair of cache lines, so that no two workers share a line.
    struct alignas(128) worker_space {
        contour_edges edges;
        border_edges borders;
        band_fragments fragments;
        std::int64_t refined = 0;
    };

    void find_edges(const drawn_frame& frame, int band, worker_space& space);
    void draw_marked(const drawn_frame& frame, int band, worker_space& space);
    void draw_slice(const drawn_frame& frame, int band, worker_space& space);

    l3d_pixel_bits marks_; ///< marks the pixels that are drawn again
    std::vector<worker_space> each_worker_;
};

/// Writes the pixel words of a band's marked pixels. A word is the mean light of the polygons'
/// visible parts. The light of a part is that in its middle, weighted by the part's number of
/// samples. `has_color` tells whether polygons have the colours of materials.
void light_pixels(const band_fragments& band, const l3d_shading& shading,
                  std::span<const l3d_material> materials, bool has_color,
                  const l3d_pixels& target);

} // namespace l3d_detail

#endif
