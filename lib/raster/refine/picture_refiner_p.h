// SPDX-License-Identifier: MIT
// picture_refiner: anti-aliasing of a picture that has been drawn.
#ifndef L3D_RASTER_REFINE_PICTURE_REFINER_P_H
#define L3D_RASTER_REFINE_PICTURE_REFINER_P_H

#include "raster/parallel/workers.h"
#include "raster/refine/band_fragments_p.h"
#include "raster/refine/pixel_bits_p.h"
#include "raster/refine/pixel_mixer_p.h"
#include "raster/surfaces/band_list_p.h"
#include "raster/surfaces/coarse_depth_p.h"

#include <cstdint>
#include <vector>

namespace l3d_detail {

/// The data of a frame that refining needs: all of its items, and what has been drawn of them.
struct drawn_frame {
    const l3d_pixels& target;
    const l3d_shading& shading;
    const band_list& list;
    const coarse_depth& coarse;
    l3d_pixel_box window; ///< what is drawn of the target
    int rows = 0;         ///< of a band
};

/// Marks the pixels at edges, then draws only these again, by many samples each.
///
/// Pixels of a band depend on the items of the frame, and on the levels beside them before any
/// pixel was refined. So they depend neither on the bands nor on the number of workers.
/// Lives: kept for its memory.
class picture_refiner {
public:
    /// Expects: one draws at a time; items have the boxes of all squares that they reach.
    /// Returns how many pixels were refined.
    std::int64_t refine(const drawn_frame& frame, l3d_workers& workers);

private:
    void mark(const drawn_frame& frame, int band);
    void resolve(const drawn_frame& frame, int band, std::size_t worker);

    /// Shape: begins two cache lines, so that workers do not take each other's.
    struct alignas(128) worker_space {
        band_fragments fragments;
        pixel_mixer mixer;
        std::int64_t refined = 0;
    };

    pixel_bits bits_;
    std::vector<worker_space> each_worker_;
};

} // namespace l3d_detail

#endif
