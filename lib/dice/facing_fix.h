// SPDX-License-Identifier: MIT
// Turns the light of a diced surface to the side that the eye sees.
#ifndef L3D_DICE_FACING_FIX_H
#define L3D_DICE_FACING_FIX_H

#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <array>
#include <cstddef>
#include <span>

/// Tells how far a normal points away from the eye at a pixel. If the result is positive, the
/// normal has to be turned round. Units: x, y in pixels; the result in units of the normal times
/// units of the shading's rays.
inline float l3d_away_from_eye(const l3d_shading& shading, const float* normal, float x, float y) {
    float away = 0;
    for (std::size_t k = 0; k < 3; ++k)
        away += normal[k] * (shading.ray[k] + x * shading.ray_right[k] + y * shading.ray_down[k]);
    return away;
}

/// Whether the shading has an eye, to which normals are turned.
inline bool l3d_has_eye(const l3d_shading& shading) {
    return shading.ray != std::array<float, 3>{0, 0, 0};
}

/// Turns the grid's normals to the eye if the whole grid shows one side. If the grid shows both
/// sides, the normals stay, and the grid's shows_both is set.
///
/// An outline passes through a quad where the surface bends away from the eye. Such a quad shows
/// only one of its sides, whichever sides the surface shows at the quad's corners. The whole quad
/// is lit as the side that it shows. The other side of the surface begins at the same drawn line
/// and lies behind the quad.
///
/// Where a side of a patch is nearly a point, the derivative along that side may turn round.
/// Normals at the side may then point to the other side of the surface. The normal of a border
/// vertex points to the other side if it is more than a right angle off the normal of the next
/// vertex inwards. This function makes the border vertex show the side that its inner neighbour
/// shows.
/// Shape: `away` has l3d_away_from_eye of each vertex, laid out as the grid's arrays. Numbers of
///        border vertices that are corrected change their sign.
void l3d_turn_normals(std::span<float> away, l3d_micro_grid& grid);

/// Turns the grid's shade levels to the eye as l3d_turn_normals turns normals, and makes the
/// numbers of l3d_micro_vertex for mode l3d_shade::levels. A border vertex takes the side of its
/// inner neighbour if levels between the two then bend less.
///
/// Shape: `away` and `level` are laid out as the grid's arrays, `level` one number longer; both are
///        changed. On entry, the levels are those of unturned normals. The grid's normal[1] and
///        normal[2] hold the levels of the middles of sides on entry, and bends on return.
void l3d_turn_levels(std::span<float> away, std::span<float> level, l3d_micro_grid& grid);

/// The factor 1 or -1 that turns the light of a grid's quad to the side that the quad shows. It is
/// -1 if the grid's shows_both is set and the quad turns to the right, else 1. For a folded quad,
/// it is the factor of the quad's triangle at `side`.
/// Shape: `side` as in l3d_edge_polylines.
float l3d_side_of_quad(const l3d_micro_grid& grid, int row, int column, std::size_t side);

#endif
