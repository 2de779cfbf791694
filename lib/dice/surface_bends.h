// SPDX-License-Identifier: MIT
// l3d_surface_bends: how much a patch and its blocks bend along the normal, and how normals turn.
#ifndef L3D_DICE_SURFACE_BENDS_H
#define L3D_DICE_SURFACE_BENDS_H

#include "geom/bezier_patch.h"
#include "geom/matrix.h"
#include "geom/normal_net.h"

#include <array>
#include <cstddef>

/// Upper bounds of derivatives by the parameters of one block, which run from 0 to 1 across it.
///
/// N is the unit normal: that of the normal net, at the same point as the derivative of S.
/// Units: those of the model where S takes part; radians, or pure numbers, where only N does.
template <class T> struct l3d_bend_numbers {
    T uu, uv, vv;                 ///< |N . S_uu|, and so on
    T uuu, uuv, uvv, vvv;         ///< |N . S_uuu|, and so on
    T uuvv;                       ///< |S_uuvv|
    T turn_u, turn_v;             ///< |N_u|, |N_v|
    T n_uu, n_uv, n_vv;           ///< |N_uu|, and so on
    T n_uuu, n_uuv, n_uvv, n_vvv; ///< |N_uuu|, and so on
};

/// Of a patch, and of each of its 4 x 4 blocks: bounds over all of it, its edges included.
///
/// They hold whatever is rounded; what that adds is stated in docs/NUMERICS.md, section 11. They
/// are infinite, but for uuvv, where the normal vanishes or cannot be proven not to.
/// Shape: block 4 * row + column, columns along u, as l3d_facing_cones has it. Each number of the
///        blocks begins with a line of the cache.
/// Cost:  1152 bytes.
class alignas(64) l3d_surface_bends {
public:
    static constexpr std::size_t blocks = 16;
    using lanes = std::array<float, blocks>;

    /// Expects: finite coordinates of magnitude at most 1e12; the patch's own normals.
    /// Cost:    some 50 us, once a model.
    l3d_surface_bends(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals);

    const l3d_bend_numbers<lanes>& of_blocks() const { return of_blocks_; }

    /// The whole patch as one block.
    const l3d_bend_numbers<float>& of_whole() const { return of_whole_; }

    /// Bounds of the patch that was moved by an affine map, of which the upper left three by three
    /// count. A similarity, mirrored or not, multiplies what has a length by its scale and leaves
    /// the rest; any other map adds the more, the more unlike one it is.
    /// Errors: infinite, but for uuvv, if the map cannot be inverted.
    /// Cost:   some 2000 operations.
    l3d_surface_bends under(const l3d_matrix<double>& placement) const;

private:
    l3d_surface_bends() = default;

    l3d_bend_numbers<lanes> of_blocks_;
    l3d_bend_numbers<float> of_whole_;
};

#endif
