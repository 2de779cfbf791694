// SPDX-License-Identifier: MIT
// l3d_bend_bounds: steps and bounds that depth and shade ask for.
#ifndef L3D_DICE_BEND_BOUNDS_H
#define L3D_DICE_BEND_BOUNDS_H

#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/diced_piece.h"
#include "dice/patch_part.h"
#include "dice/step_plan.h"
#include "scene/bends/surface_bends.h"
#include "raster/surface_part.h"

/// How a patch bends along its normals, as it is seen.
///
/// A quad's depth is a plane in space through the mean of its corners. Along the exact normal it is
/// off by what each direction bends, as places are, and by a quarter of what the corners are off
/// one plane. A quad's level is a parabola with the levels of its corners and of the middles of its
/// sides: third derivatives are what it is off by. NUMERICS, sections 3 and 14.
/// Lives: borrows the bends.
class l3d_bend_bounds {
public:
    /// Asks for nothing, and proves nothing.
    l3d_bend_bounds() = default;

    /// Units: w_per_length: what multiplies a length of the model to make scaled w of it; focal as
    ///        l3d_dice_view has it.
    /// Expects: the bends are those of the placed patch, but for the scale.
    l3d_bend_bounds(const l3d_surface_bends& bends, double w_per_length, double focal)
        : bends_(&bends), w_per_length_(w_per_length), focal_(focal) {}

    explicit operator bool() const { return bends_ != nullptr; }

    /// Makes a piece's needs such that depth keeps `depth_budget`, and that the shade keeps the
    /// view's tolerance unless quads would be smaller than six pixels.
    ///
    /// Expects: needs of the piece's blocks, of places alone; the budget in pixels.
    void ask(const l3d_patch_part& piece, const l3d_dice_view& view, double depth_budget,
             l3d_block_needs& needs) const;

    /// What the steps chosen leave. Levels of clipped pieces are linear over triangles.
    /// Expects: as above, all of it from what was asked; the slits are those that were made along
    ///          the piece's sides.
    l3d_surface_certificate certificate(const l3d_patch_part& piece, const l3d_dice_view& view,
                                        double depth_budget, const l3d_block_needs& needs,
                                        const l3d_step_plan& plan, const l3d_gap_spans& slits,
                                        bool clipped) const;

private:
    /// Of a piece's blocks, by their own parameters.
    struct of_piece {
        l3d_bend_numbers<l3d_surface_bends::lanes> bends{};
        l3d_surface_bends::lanes steps_u{}, steps_v{};
    };
    of_piece of_blocks(const l3d_patch_part& piece, int strips) const;
    void take_block(const l3d_patch_part& piece, int strips, std::size_t column, std::size_t row,
                    of_piece& to) const;
    void set_by_size(const l3d_patch_part& piece, int strips, of_piece& of) const;

    const l3d_surface_bends* bends_ = nullptr;
    double w_per_length_ = 0, focal_ = 0;
};

/// What snapped corners of planes may be off them by, beyond the tolerance. Units: pixels.
inline constexpr double l3d_snapped_planes = 0.001;

/// What depth is off by more than vertices are, at most, because corners of quads in some blocks of
/// a grid are not on the plane that stands for each.
///
/// Of what vertices are off by, a quad that is a plane does not need the rounding of its centre. A
/// folded one does, and is a fan of triangles, a quarter as far off. So the smaller of both parts
/// is left out. Shape: blocks as l3d_surface_certificate::without_normals. Units: pixels at their
/// depth. Expects: view.focal > 0.
double l3d_most_off_plane(const l3d_surface_part& part, unsigned blocks, const l3d_dice_view& view);

/// Asks for more steps in blocks without normals whose quads, now that they are there, are farther
/// off a plane than the budget of depth leaves. Returns whether it does.
bool l3d_ask_for_planes(const l3d_surface_part& part, const l3d_step_plan& plan,
                        const l3d_dice_view& view, double depth_budget, l3d_block_needs& needs);

#endif
