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

/// Upper bounds of derivatives by the parameters of one block, which run from 0 to 1 across it.
///
/// S is the surface, and N its unit normal by the normal net, at the same point.
/// Units: those of the model where S takes part; radians, or pure numbers, where only N does.
template <class T> struct l3d_bend_numbers {
    T uu, uv, vv;                 ///< |N . S_uu|, and so on
    T uuu, uuv, uvv, vvv;         ///< |N . S_uuu|, and so on
    T uuvv;                       ///< |S_uuvv|
    T turn_u, turn_v;             ///< |N_u|, |N_v|
    T n_uu, n_uv, n_vv;           ///< |N_uu|, and so on
    T n_uuu, n_uuv, n_uvv, n_vvv; ///< |N_uuu|, and so on
};

/// The level of a cosine of 1, in levels of 255: the grey is round(25.5 + max(0, 229.5 cosine)).
inline constexpr float l3d_level_of_cosine = 229.5F;

/// The factor in the error of a parabola through both ends and the middle of a step h. The error is
/// at most this times h^3 and the third derivative. The factor is the largest value of |s (s - 1/2)
/// (s - 1)| / 6.
inline constexpr double l3d_of_thirds = 0.0080187537387448;

/// Bounds how far the drawn level of a quad with sides h_u, h_v is off the exact one at the same
/// parameters. The drawn level is a parabola through the levels of the corners and of the middles
/// of the sides. Opposite sides have bends of their own, and their mean is drawn.
/// Units: levels. NUMERICS, section 14.
double l3d_levels_off(const l3d_bend_numbers<double>& bends, double h_u, double h_v);

/// Bounds how a patch and its 4 x 4 blocks bend, and how their normals turn, edges included. Dicing
/// chooses steps by these numbers.
///
/// The bounds include all rounding (docs/NUMERICS.md, section 11). If the normal vanishes or is not
/// proven to exist, they are infinite, except for uuvv.
/// Shape: block 4 * row + column, columns along u, as in l3d_facing_cones. Each number of the
///        blocks begins with a line of the cache.
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

    /// The number of steps of each block with which levels are off by at most one (l3d_levels_off).
    /// Each step along u or v turns the normal by the same angle. For an error of e levels,
    /// multiply the number by e^(-1/3). It is 1 where nothing is known.
    const lanes& steps_u() const { return steps_u_; }
    const lanes& steps_v() const { return steps_v_; }

    /// The bends of the whole patch, as one block.
    const l3d_bend_numbers<float>& of_whole() const { return of_whole_; }

    /// Bounds the patch after an affine map, whose upper left three by three counts. A similarity,
    /// mirrored or not, multiplies numbers that have a length by its scale and leaves the rest. Any
    /// other map enlarges the bounds, the more so the farther it is from a similarity.
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
