// SPDX-License-Identifier: MIT
// l3d_facing_cones: which blocks of a patch show their back, whatever is in them.
#ifndef L3D_DICE_FACING_CONES_H
#define L3D_DICE_FACING_CONES_H

#include "geom/bezier_patch.h"
#include "geom/normal_net.h"

#include <array>
#include <cstdint>

/// Of each of a patch's 4 x 4 blocks a ball around its points and a cone around its normals
/// dS/du x dS/dv.
///
/// Shape: block 4 * row + column, columns along u.
class l3d_facing_cones {
public:
    using vector = l3d_vector<double, 3>;
    static constexpr std::size_t blocks = 16;
    static constexpr unsigned all = 0xffff;

    l3d_facing_cones(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals);

    /// A bit for each block all of whose normals point away from a point: (S - from) . n > 0 for
    /// every point S and every normal n of it. With `side` = -1, towards it.
    /// Expects: side is 1 or -1.
    /// Cost:    some 25 operations a block, a root among them.
    unsigned away_from(const vector& from, double side) const;

private:
    using numbers = std::array<double, blocks>;
    struct ball_and_cone;

    void set(std::size_t block, const ball_and_cone& of);

    std::array<numbers, 3> centre_, axis_;
    numbers radius_, sine_; ///< a sine of 2: anything may be a normal
};

#endif
