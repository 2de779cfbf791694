// SPDX-License-Identifier: MIT
// mesh_steps: how finely the patches of a mesh are diced.
#ifndef L3D_RASTER_PATHS_MESH_STEPS_P_H
#define L3D_RASTER_PATHS_MESH_STEPS_P_H

#include "raster/paths/gradient.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Whether all coordinates are finite numbers.
bool is_finite(const l3d_mesh_patch& patch);

/// Steps along one parameter of a patch: equal ones if few are enough, else so many in each
/// quarter.
struct mesh_steps {
    /// The number of steps from which on quarters pay: with one step each they are as many.
    static constexpr int few = 4;

    int whole = 1;
    std::array<int, 4> of_quarter{1, 1, 1, 1};

    bool is_quartered() const { return whole > few; }
    /// Takes as many steps as both need.
    void cover(const mesh_steps& other);
    /// The steps of the parameter that runs the other way.
    mesh_steps backwards() const;
};

/// Parameters where steps begin or end, from 0 to 1. Those of backwards() are 1 less these, with
/// the same bits in their weights.
///
/// Shape:   `size` of each, and so many more that lanes may read past the last.
struct mesh_knots {
    static constexpr std::size_t room = 8;

    std::size_t size = 0;
    std::vector<double> at;
    std::array<std::vector<double>, 4> weights; ///< the Bernstein polynomials of control points
    std::vector<std::size_t> quarter;           ///< quarter of the step that ends here

    void set(const mesh_steps& steps);
};

/// The colours between the corners of a triangle.
enum class mesh_colors {
    linear,  ///< the colours of its corners
    bilinear ///< those of the patch, at parameters that are linear
};

/// How a patch is diced.
struct mesh_dicing {
    mesh_steps along, down; ///< along u and along v
    /// Bit 4 r + c: in row r and column c of the quarters, diagonals lead from (1, 0) to (0, 1) of
    /// a cell, instead of from (0, 0) to (1, 1).
    std::uint16_t rising = 0;

    bool rises(std::size_t row, std::size_t column) const {
        return (rising >> (4 * row + column) & 1) != 0;
    }
};

/// The dicing of each patch: its triangles err by no more than is allowed, and patches have the
/// same steps along a common border, whichever way it runs in each. Patches that are not finite
/// have any.
std::vector<mesh_dicing> dicings_of(std::span<const l3d_mesh_patch> patches, mesh_colors colors);

/// Lets patches whose borders have the same four control points take as many steps along them as
/// each of them needs. So do the opposite borders, and the patches that share them.
/// Expects: a dicing for each patch.
void agree_on_borders(std::span<const l3d_mesh_patch> patches, std::span<mesh_dicing> dicings);

} // namespace l3d_detail

#endif
