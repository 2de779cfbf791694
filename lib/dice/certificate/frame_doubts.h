// SPDX-License-Identifier: MIT
// l3d_frame_doubts: bounds how far each pixel is off the exact picture.
#ifndef L3D_DICE_CERTIFICATE_FRAME_DOUBTS_H
#define L3D_DICE_CERTIFICATE_FRAME_DOUBTS_H

#include "dice/certificate/doubt_tile.h"
#include "raster/depth_buffer.h"
#include "scene/sides/side_pairs.h"
#include "geom/matrix.h"
#include "raster/parallel/workers.h"
#include "scene/dice_view.h"
#include "scene/levels/level_choice.h"
#include "scene/patch_scene.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <vector>

/// The input of l3d_frame_doubts: a drawn frame whose pixels are to be judged, and the frame's
/// error bounds.
struct l3d_doubted_frame {
    const l3d_patch_scene& scene;
    const l3d_matrix<double>& to_image; ///< maps the world to the view's units
    const l3d_dice_view& view;
    /// The direction towards the light, in the world; any length but 0.
    l3d_vector<double, 3> light;
    /// Error bounds of places and of depth; infinite if the frame has no such bound. Units: pixels.
    double bound_px, depth_bound_px;
    l3d_curved_error curved{}; ///< how far patches of curved models are off their surfaces
    /// Whether the frame shows Lambert's levels of one white light, without highlights and fog.
    /// Otherwise `lighting` and `fog` are used.
    bool has_levels = true;
    l3d_lighting lighting{}; ///< the lights, without the direction of the first light
    l3d_fog fog{};
    double nearer = 0; ///< how much nearer the camera's own eye is than the eye that w counts from
    l3d_pixels drawn;  ///< the picture: greys in all three channels, or any colours
    /// The exact background behind all surfaces; not l3d_background::none().
    l3d_background background{};
};

/// Bounds how far each pixel of a drawn frame is off the exact picture. It bounds the exact picture
/// from the exact patches, and compares the drawn picture with these bounds (NUMERICS, The map of
/// doubt). The bounds of the exact picture do not depend on how a picture was drawn.
///
/// Cost: some 7 us a pixel that shows a surface, and a millisecond a pixel at an outline.
class l3d_frame_doubts {
public:
    /// Bounds the pixels of a frame. Expects: a light that is not 0; a drawn picture of the view's
    /// size.
    void find(const l3d_doubted_frame& frame, l3d_workers& workers);

    /// For each pixel of the last frame, how far it may be off the exact picture. Units: levels of
    /// 255.
    const l3d_error_map& map() const { return map_; }

    /// For each pixel, the part of its square, from 0 to 1, that may show another surface than the
    /// exact picture. The part is 1 everywhere if coverage_bound() is infinite.
    const l3d_error_map& coverage() const { return coverage_; }

    /// The largest part of any pixel's square that may show another surface than in the exact
    /// picture, from 0 to 1. Infinite if places or depth have no bound.
    double coverage_bound() const { return coverage_bound_; }

    /// The largest error in map() of any pixel that lies inside one surface or shows the background
    /// alone. It is infinite if the frame has uncertain pixels, but no pixel that lies inside a
    /// surface.
    /// Units: levels of 255.
    double color_bound() const { return color_bound_; }

    /// The number of pieces that were halved in all frames so far. It measures the map's cost.
    std::int64_t cuts() const;

private:
    /// A patch of the frame, and its box in the picture.
    struct placed {
        l3d_doubt_patch of;
        l3d_image_box box;
    };
    /// Bounds of a pixel of the frame. `light` is a weighted mean over all choices: each
    /// transparent instance may be there, or not.
    struct pixel {
        l3d_light_bounds light;
        /// The largest members of l3d_doubt_pixel over all choices.
        double unsure = 0, unsure_drawn = 0, covered = 0;
    };
    struct tile_result {
        double coverage = 0, color = 0;
        /// Whether the tile has pixels with unsure or with covered parts.
        bool has_unsure = false, has_covered = false;
    };

    void place(const l3d_doubted_frame& frame);
    l3d_doubt_piece whole_of(const l3d_doubted_frame& frame, const placed& p) const;
    std::vector<pixel> find_light(const l3d_doubted_frame& frame, const l3d_pixel_box& box,
                                  l3d_doubt_tile& tile) const;
    void find_tile(const l3d_doubted_frame& frame, const l3d_pixel_box& box, l3d_doubt_tile& tile,
                   tile_result& result);

    l3d_doubt_view view_;
    /// Sides of the frame's models, by l3d_patch_model::identity().
    std::map<const void*, l3d_side_pairs> sides_;
    std::vector<placed> patches_;
    std::vector<l3d_doubt_tile> tiles_; ///< working memory, one tile for each worker
    l3d_error_map map_, coverage_;
    bool is_searched_ = false; ///< whether coverage() was searched; if not, it is 1 everywhere
    double coverage_bound_ = 0, color_bound_ = 0;
};

#endif
