// SPDX-License-Identifier: MIT
// l3d_bend_bounds: steps for depth and shade, and the bounds of their errors.
#ifndef L3D_DICE_BEND_BOUNDS_H
#define L3D_DICE_BEND_BOUNDS_H

#include "scene/counts.h"
#include "scene/dice_view.h"
#include "dice/diced_piece.h"
#include "geom/patch_part.h"
#include "dice/step_plan.h"
#include "scene/bends/surface_bends.h"
#include "raster/surface_part.h"

/// Chooses steps for depth and shade by the bends of a patch along its normals, and bounds the
/// errors that remain.
///
/// A quad is drawn with the depth of a plane in space through the mean of its corners. Its error
/// along the exact normal has two parts: the bend along each direction, as for places, and a
/// quarter of the corners' distance from one plane. A quad's level is a parabola with the levels of
/// its corners and of the middles of its sides. Its error comes from third derivatives. NUMERICS,
/// sections 3 and 14. Lives: borrows the bends.
class l3d_bend_bounds {
public:
    /// Makes bounds without bends, which need no finer steps and prove nothing.
    l3d_bend_bounds() = default;

    /// Units:   w_per_length: factor from a length of the model to scaled w; focal:
    ///          l3d_dice_view::focal.
    /// Expects: the bends are those of the placed patch, but for the scale.
    l3d_bend_bounds(const l3d_surface_bends& bends, double w_per_length, double focal)
        : bends_(&bends), w_per_length_(w_per_length), focal_(focal) {}

    explicit operator bool() const { return bends_ != nullptr; }

    /// Raises a piece's needs so that depth keeps `depth_budget`, and the shade keeps the view's
    /// tolerance unless quads would be smaller than six pixels.
    ///
    /// Units:   the budget in pixels.
    /// Expects: `needs` are those of the piece's blocks for places alone.
    void ask(const l3d_patch_part& piece, const l3d_dice_view& view, double depth_budget,
             l3d_block_needs& needs) const;

    /// Error bounds that remain with the chosen steps. In clipped pieces, levels are linear over
    /// triangles.
    /// Expects: the arguments that ask() had, and the plan made from its needs; the slits are those
    ///          along the piece's sides.
    l3d_surface_certificate certificate(const l3d_patch_part& piece, const l3d_dice_view& view,
                                        double depth_budget, const l3d_block_needs& needs,
                                        const l3d_step_plan& plan, const l3d_gap_spans& slits,
                                        bool clipped) const;

private:
    /// The bends and steps of a piece's blocks, by their own parameters. Others than those have no
    /// numbers.
    struct of_piece {
        l3d_bend_numbers<l3d_surface_bends::lanes> bends;
        l3d_surface_bends::lanes steps_u, steps_v;
    };
    of_piece of_blocks(const l3d_patch_part& piece, int strips) const;
    void take_block(const l3d_patch_part& piece, int strips, std::size_t column, std::size_t row,
                    of_piece& to) const;
    void set_by_size(const l3d_patch_part& piece, int strips, of_piece& of) const;

    const l3d_surface_bends* bends_ = nullptr;
    double w_per_length_ = 0, focal_ = 0;
};

/// The most that snapping moves corners off their planes, beyond the tolerance. Units: pixels.
inline constexpr double l3d_snapped_planes = 0.001;

/// The error of depth that comes on top of the vertices' own, in some blocks of a grid. It arises
/// because a quad's corners do not lie on one plane.
///
/// The vertices' error has an allowance for the rounding of a quad's centre. A flat quad does not
/// need it. A folded quad does, but it is a fan of triangles, a quarter as far off. So the smaller
/// of both parts is left out.
/// Shape:   `blocks` as l3d_surface_certificate::without_normals.
/// Units:   pixels at their depth.
/// Expects: view.focal > 0.
double l3d_most_off_plane(const l3d_surface_part& part, unsigned blocks, const l3d_dice_view& view);

/// Asks for more steps in blocks without normals whose quads are farther off a plane than the
/// budget of depth allows. Returns whether there are any.
bool l3d_ask_for_planes(const l3d_surface_part& part, const l3d_step_plan& plan,
                        const l3d_dice_view& view, double depth_budget, l3d_block_needs& needs);

#endif
