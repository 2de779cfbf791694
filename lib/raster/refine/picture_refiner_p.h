// SPDX-License-Identifier: MIT
// picture_refiner: anti-aliasing of a picture that has been drawn.
#ifndef L3D_RASTER_REFINE_PICTURE_REFINER_P_H
#define L3D_RASTER_REFINE_PICTURE_REFINER_P_H

#include "raster/parallel/workers.h"
#include "raster/refine/band_fragments_p.h"
#include "raster/refine/border_edges_p.h"
#include "raster/refine/contour_edges_p.h"
#include "raster/refine/contour_mixer_p.h"
#include "raster/refine/contour_pixels_p.h"
#include "raster/refine/find_jumps_p.h"
#include "raster/refine/pixel_bits_p.h"
#include "raster/refine/pixel_mixer_p.h"
#include "raster/surfaces/band_list_p.h"
#include "raster/surfaces/coarse_depth_p.h"

#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// The data of a frame that refining needs: all of its items, and what has been drawn of them.
struct drawn_frame {
    const l3d_pixels& target;
    l3d_depth_buffer& depth; ///< of the whole picture
    const l3d_shading& shading;
    std::span<const l3d_material> materials;
    std::span<const std::uint32_t> colors; ///< of the materials, if they are those of levels
    const band_list& list;
    const coarse_depth& coarse;
    l3d_pixel_box window; ///< what is drawn of the target
    int rows = 0;         ///< of a band
};

/// Finds the pixels at edges, and draws these again.
///
/// A pixel that a single contour of a surface passes through is mixed by contour_mixer. What jumps
/// of level no contour explains, pixels of several contours, and those beside one where light is
/// steep are drawn by pixel_mixer from all polygons that reach them.
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
    /// A pixel's new word, which waits until nobody needs the one that is there.
    struct refined_pixel {
        std::int32_t x, y;
        std::uint32_t word;
    };
    /// What is known of a band. Shape: begins two cache lines, so that workers do not take each
    /// other's.
    struct alignas(128) band_space {
        contour_pixels contours;
        std::vector<refined_pixel> refined;
    };
    struct alignas(128) worker_space {
        contour_edges edges;
        border_edges borders;
        band_fragments fragments;
        pixel_mixer mixer;
    };

    void find_contours(const drawn_frame& frame, int band, worker_space& space);
    void mix_contours(const drawn_frame& frame, int band);
    void mark_rims(const l3d_pixel_box& box, int band, const contour_mixer& mixer);
    void mark_others(const drawn_frame& frame, const l3d_pixel_box& box);
    void resolve(const drawn_frame& frame, int band, worker_space& space);

    std::size_t bands_ = 0; ///< of the frame
    level_jumps jumps_;
    contour_cuts cuts_;
    pixel_bits contour_bits_; ///< pixels that contours pass through
    pixel_bits others_;       ///< pixels that are drawn from all polygons
    std::vector<band_space> each_band_;
    std::vector<worker_space> each_worker_;
};

} // namespace l3d_detail

#endif
