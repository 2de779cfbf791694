// SPDX-License-Identifier: MIT
// l3d_facing_cones: finds the blocks of a patch that certainly show their back.
#ifndef L3D_SCENE_FACING_CONES_H
#define L3D_SCENE_FACING_CONES_H

#include "geom/bezier_patch.h"
#include "geom/normal_net.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

/// Finds the blocks of a patch that certainly show their back. For the patch and for each of its 4
/// x 4 blocks, it holds two bounds: a ball around the points, and a cone around the normals dS/du x
/// dS/dv.
///
/// Shape: block 4 * row + column, columns along u. The object begins with a line of the cache,
///        since most questions need the patch's own cone alone.
class alignas(64) l3d_facing_cones {
public:
    using vector = l3d_vector<double, 3>;
    static constexpr std::size_t blocks = 16;
    static constexpr unsigned all = 0xffff;

    l3d_facing_cones(const l3d_bezier_patch<double, 3>& patch, const l3d_normal_net& normals);

    /// Finds the blocks whose normals all point away from the point `from`. The result has a bit
    /// for each block. For every point S and every normal n of a block that is found, (S - from) .
    /// n > 0. With `side` = -1, it finds the blocks whose normals all point towards `from`.
    /// Expects: side is 1 or -1.
    /// Cost:    some 20 operations, and 25 with a root for each block unless all of the patch turns
    ///          one side to the point.
    unsigned away_from(const vector& from, double side) const;

private:
    using numbers = std::array<double, blocks>;
    struct ball_and_cone {
        vector centre{0.0, 0.0, 0.0}, axis{0.0, 0.0, 0.0};
        double radius = 0, sine = 2; ///< a sine of 2 means that anything may be a normal

        void hold_points(std::span<const vector> points);
        void hold_normals(std::span<const vector> normals);
    };

    void set(std::size_t block, const ball_and_cone& of);

    ball_and_cone whole_;
    std::array<numbers, 3> centre_, axis_;
    numbers radius_, sine_;
};

#endif
