// SPDX-License-Identifier: MIT
// mesh_steps: finds how finely the patches of a mesh are diced.
#ifndef L3D_RASTER_PATHS_MESH_STEPS_P_H
#define L3D_RASTER_PATHS_MESH_STEPS_P_H

#include "raster/paths/gradient.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Whether all coordinates of a patch are finite numbers.
bool is_finite(const l3d_mesh_patch& patch);

/// The numbers of steps along one parameter of a patch. If `whole` is at most `few`, the patch has
/// that many equal steps. Otherwise each quarter has its own number of steps.
struct mesh_steps {
    /// The largest number of equal steps. Where more are needed, quarters cost less, as each
    /// quarter has only as many steps as it needs.
    static constexpr int few = 4;

    int whole = 1;
    std::array<int, 4> of_quarter{1, 1, 1, 1};

    bool is_quartered() const { return whole > few; }
    /// Raises each number of steps to the same number of another border, where the latter is
    /// larger.
    void cover(const mesh_steps& other);
    /// The same steps for the parameter that runs in the opposite direction.
    mesh_steps backwards() const;
};

/// The parameters, from 0 to 1, at which steps begin or end. The knots of mesh_steps::backwards()
/// are 1 minus these knots, and have weights with the same bits.
///
/// Shape:   `size` elements in each array, and `room` more that lanes may read past the last.
struct mesh_knots {
    static constexpr std::size_t room = 8;

    std::size_t size = 0;
    std::vector<double> at;
    /// Values of the four cubic Bernstein polynomials at the knots.
    std::array<std::vector<double>, 4> weights;
    /// For each knot, the quarter that holds the step which ends at the knot.
    std::vector<std::size_t> quarter;

    void set(const mesh_steps& steps);
};

/// The way in which triangles of a mesh get the colours between their corners.
enum class mesh_colors {
    linear, ///< linear functions between the colours of the triangle's corners
    /// The patch's bilinear colours; its parameters are linear between the triangle's corners.
    bilinear
};

/// The way in which a patch is diced.
struct mesh_dicing {
    mesh_steps along, down; ///< the steps along u, and the steps along v
    /// The cells' diagonals. If bit 4 r + c is set, cells in row r and column c of the quarters
    /// have diagonals from (1, 0) to (0, 1). Otherwise the diagonals go from (0, 0) to (1, 1).
    std::uint16_t rising = 0;

    bool rises(std::size_t row, std::size_t column) const {
        return (rising >> (4 * row + column) & 1) != 0;
    }
};

/// Finds a dicing of each patch that keeps the errors of its triangles within fixed limits of place
/// and colour. Patches with a common border have the same steps along it, even if the border runs
/// in opposite directions in them. Patches that are not finite get an arbitrary dicing.
std::vector<mesh_dicing> dicings_of(std::span<const l3d_mesh_patch> patches, mesh_colors colors);

/// Gives patches that share a border the same steps along it, as many as each of them needs. A
/// border is shared if its four control points are the same. Opposite borders of a patch always
/// have the same steps. So the patches that share the opposite borders get these steps, too.
/// Expects: a dicing for each patch.
void agree_on_borders(std::span<const l3d_mesh_patch> patches, std::span<mesh_dicing> dicings);

} // namespace l3d_detail

#endif
