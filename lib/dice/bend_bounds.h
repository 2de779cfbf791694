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

/// Chooses steps that keep a piece's errors of depth and shade within their tolerances, and bounds
/// the errors that remain.
///
/// Both errors follow from how a patch bends along its normals. A quad is drawn with the depth of
/// one plane in space, through the mean of its corners. Two errors add up along the exact normal.
/// One is the bend along each direction, as for places. The other is a quarter of the corners'
/// distance from a common plane. The shade level within a quad is a parabola through the levels of
/// its corners and of the middles of its sides. Third derivatives bound the parabola's error.
/// Source: NUMERICS, sections 3 and 14.
/// Lives:  borrows the bends.
class l3d_bend_bounds {
public:
    /// Makes an object without bends, which asks for no finer steps and proves nothing.
    l3d_bend_bounds() = default;

    /// Takes the bends of a patch that is placed in a view.
    /// Units:   `w_per_length` is the scaled w of a length of 1 in the model; `focal` is
    ///          l3d_dice_view::focal.
    /// Expects: the bends of the placed patch, or of the same patch at another scale.
    l3d_bend_bounds(const l3d_surface_bends& bends, double w_per_length, double focal)
        : bends_(&bends), w_per_length_(w_per_length), focal_(focal) {}

    explicit operator bool() const { return bends_ != nullptr; }

    /// Raises a piece's needs so that its error of depth keeps `depth_budget` and its error of
    /// shade keeps the view's tolerance. Where this would make quads smaller than six pixels, the
    /// error of shade may exceed the tolerance.
    ///
    /// Units:   the budget is in pixels.
    /// Expects: `needs` are what the piece's blocks need for places alone.
    void ask(const l3d_patch_part& piece, const l3d_dice_view& view, double depth_budget,
             l3d_block_needs& needs) const;

    /// Bounds the errors that remain with the chosen steps. `clipped` says that the piece was
    /// clipped, so that its shade levels are linear over triangles.
    /// Expects: the arguments of ask(), with the needs that ask() raised; the plan made from these
    ///          needs; the spans of the slits along the piece's sides.
    l3d_surface_certificate certificate(const l3d_patch_part& piece, const l3d_dice_view& view,
                                        double depth_budget, const l3d_block_needs& needs,
                                        const l3d_step_plan& plan, const l3d_gap_spans& slits,
                                        bool clipped) const;

private:
    /// The bends and the wanted steps of a piece's blocks, by the blocks' own parameters. A piece
    /// of one block uses the first lane; the other lanes hold no valid numbers.
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

/// The distance beyond the tolerance by which corners may be off a plane, since they are snapped.
/// Units: pixels.
inline constexpr double l3d_snapped_planes = 0.001;

/// Measures the largest error of depth that arises because the corners of a quad do not lie on one
/// plane. This error comes on top of the vertices' error. Only quads in the given blocks of the
/// grid are looked at.
///
/// The vertices' error already allows for rounding the centre of a folded quad. A flat quad has no
/// centre to be rounded, so its error is reduced by this allowance. A folded quad has a centre, but
/// is drawn as a fan, which errs by a quarter as much. The larger of both errors holds for every
/// quad.
/// Shape:   `blocks` as l3d_surface_certificate::without_normals.
/// Units:   pixels at the depth of the quad.
/// Expects: view.focal > 0.
double l3d_most_off_plane(const l3d_surface_part& part, unsigned blocks, const l3d_dice_view& view);

/// Raises the needs of blocks without normals if the corners of their quads are farther off a plane
/// than the budget of depth allows. Returns whether any needs were raised.
bool l3d_ask_for_planes(const l3d_surface_part& part, const l3d_step_plan& plan,
                        const l3d_dice_view& view, double depth_budget, l3d_block_needs& needs);

#endif
