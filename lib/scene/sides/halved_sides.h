// SPDX-License-Identifier: MIT
// l3d_halved_side: a side of a patch at which two patches of half the size continue the surface.
#ifndef L3D_SCENE_HALVED_SIDES_H
#define L3D_SCENE_HALVED_SIDES_H

#include "geom/bezier_patch.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// A side of a patch whose two halves are sides of other patches. The halves have the same control
/// points as the other patches' sides, bit for bit. Pictures draw a halved side as its halves, so
/// that no gap shows.
///
/// Shape: sides are v = 0, u = 1, v = 1, u = 0, in the order in which one walks round the patch.
struct l3d_halved_side {
    /// A side of a patch.
    struct place {
        std::uint32_t patch = 0, side = 0;
    };
    place of{};                    ///< the halved side
    std::array<place, 2> beyond{}; ///< the other patches' sides, in the order of the halves
    /// For each side beyond, whether it is walked in the same direction as its half. If so, its
    /// patch has opposite normals.
    std::array<bool, 2> turns{};
};

/// The curve of a side, in the direction in which one walks round the patch. Expects: side < 4.
inline l3d_bezier_curve<double, 3> l3d_walked_side(const l3d_bezier_patch<double, 3>& patch,
                                                   std::size_t side) {
    switch (side) {
    case 0:
        return patch.row(0);
    case 1:
        return patch.column(3);
    case 2:
        return patch.row(3).reversed();
    default:
        return patch.column(0).reversed();
    }
}

/// The coordinates of a curve's control points, as a key of tables. -0 becomes 0.
inline std::array<double, 12> l3d_numbers_of(const l3d_bezier_curve<double, 3>& curve) {
    std::array<double, 12> result{};
    for (std::size_t i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k)
            result[3 * i + static_cast<std::size_t>(k)] = curve.points[i][k] + 0.0;
    return result;
}

/// Finds all halved sides, in the order of their patches. A side counts only if it equals no other
/// side, and each of its halves equals exactly one.
/// Cost: some 1 us a patch.
std::vector<l3d_halved_side>
l3d_find_halved_sides(std::span<const l3d_bezier_patch<double, 3>> patches);

#endif
