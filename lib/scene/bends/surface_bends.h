// SPDX-License-Identifier: MIT
// l3d_surface_bends: knows how much a patch and its blocks bend along the normal, and how normals
// turn.
#ifndef L3D_SCENE_BENDS_SURFACE_BENDS_H
#define L3D_SCENE_BENDS_SURFACE_BENDS_H

#include "geom/bezier_patch.h"
#include "geom/matrix.h"
#include "geom/normal_net.h"

#include <array>
#include <cstddef>

/// The bend numbers of a block: upper bounds of derivatives by the block's own parameters, which
/// run from 0 to 1 across it.
///
/// S is a point of the surface, and N the unit normal there, by the normal net.
/// Units: the model's units for bounds with S; radians, or pure numbers, for bounds of N without S.
template <class T> struct l3d_bend_numbers {
    T uu, uv, vv;                 ///< |N . S_uu|, and so on
    T uuu, uuv, uvv, vvv;         ///< |N . S_uuu|, and so on
    T uuvv;                       ///< |S_uuvv|
    T turn_u, turn_v;             ///< |N_u|, |N_v|
    T n_uu, n_uv, n_vv;           ///< |N_uu|, and so on
    T n_uuu, n_uuv, n_uvv, n_vvv; ///< |N_uuu|, and so on
};

/// The shade levels, of 255, that a cosine of 1 adds: the level is round(25.5 + max(0, 229.5
/// cosine)).
inline constexpr float l3d_level_of_cosine = 229.5F;

/// A parabola through both ends and the middle of a curve's step h errs by at most this factor
/// times h^3 times the third derivative. The factor is the largest value of |s (s - 1/2) (s - 1)| /
/// 6.
inline constexpr double l3d_of_thirds = 0.0080187537387448;

/// Bounds how far the drawn shade level of a quad with sides h_u, h_v is off the exact level at the
/// same parameters. The drawn level is a parabola through the levels of the corners and of the
/// middles of the sides. Opposite sides bend differently; the mean of both parabolas is drawn.
/// Units: levels of 255. NUMERICS, section 14.
double l3d_levels_off(const l3d_bend_numbers<double>& bends, double h_u, double h_v);

/// Bounds how a patch and its 4 x 4 blocks bend, and how their normals turn, edges included. Dicing
/// chooses steps by these numbers.
///
/// The bounds include all rounding (docs/NUMERICS.md, section 11). If the normal vanishes or is not
/// proven to exist, they are infinite, except for uuvv.
/// Shape: block 4 * row + column, columns along u, as in l3d_facing_cones. The array of each number
///        begins with a line of the cache.
/// Cost:  1344 bytes.
class alignas(64) l3d_surface_bends {
public:
    static constexpr std::size_t blocks = 16;
    using lanes = std::array<float, blocks>;

    /// Computes the bounds of a patch.
    /// Expects: finite coordinates of magnitude at most 1e12; the patch's own normals.
    /// Cost:    some 50 us, once for each patch of a model.
    l3d_surface_bends(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals);

    const l3d_bend_numbers<lanes>& of_blocks() const { return of_blocks_; }

    /// The number of steps along u across each block with which shade levels are off by at most one
    /// (l3d_levels_off). A step along u turns the normal by the same angle as a step along v. For
    /// an error of e levels, multiply the number by e^(-1/3). The number is 1 where nothing is
    /// known.
    const lanes& steps_u() const { return steps_u_; }
    const lanes& steps_v() const { return steps_v_; }

    /// The bend numbers of the whole patch, as if it were one block.
    const l3d_bend_numbers<float>& of_whole() const { return of_whole_; }

    /// The bounds for the patch after an affine map has moved it. Only the map's upper left three
    /// by three counts. A similarity, mirrored or not, multiplies the numbers with S by its scale,
    /// and does not change the numbers without S. Any other map enlarges the bounds, the more so
    /// the farther it is from a similarity.
    /// Errors: infinite, except for uuvv, if the map cannot be inverted.
    /// Cost:   some 2000 operations.
    l3d_surface_bends under(const l3d_matrix<double>& placement) const;

private:
    l3d_surface_bends() = default;
    void set_steps();

    l3d_bend_numbers<lanes> of_blocks_;
    lanes steps_u_, steps_v_;
    l3d_bend_numbers<float> of_whole_;
};

#endif
