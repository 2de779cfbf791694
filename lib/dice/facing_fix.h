// SPDX-License-Identifier: MIT
// Turns the light of a diced surface to the side that the eye sees.
#ifndef L3D_DICE_FACING_FIX_H
#define L3D_DICE_FACING_FIX_H

#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <array>
#include <cstddef>
#include <span>

/// Tells how far a normal points away from the eye at a pixel; if the result is positive, the
/// normal has to be turned round. Units: x, y in pixels; the result in units of the normal times
/// those of the rays.
inline float l3d_away_from_eye(const l3d_shading& shading, const float* normal, float x, float y) {
    float away = 0;
    for (std::size_t k = 0; k < 3; ++k)
        away += normal[k] * (shading.ray[k] + x * shading.ray_right[k] + y * shading.ray_down[k]);
    return away;
}

/// Whether the shading has an eye, so that normals are turned to it.
inline bool l3d_has_eye(const l3d_shading& shading) {
    return shading.ray != std::array<float, 3>{0, 0, 0};
}

/// Turns the grid's normals to the eye if the whole grid shows one side. If it shows both sides,
/// leaves them and sets shows_both.
///
/// An outline passes through a quad where the surface bends away from the eye. Such a quad is drawn
/// on one side only, whichever sides its corners show. The eye would see that side there, so the
/// whole quad is lit as that side. The other side of the surface begins at the same drawn line and
/// lies behind.
///
/// Where a side of a patch is nearly a point, the derivative along that side turns round. Normals
/// there may be those of the other side. This function corrects such a vertex on the grid's border:
/// its normal is more than a right angle off that of the next vertex inwards. The border vertex
/// then shows the side that its inner neighbour shows.
/// Shape: `away` has l3d_away_from_eye of each vertex, laid out as the grid's arrays. It is
///        corrected, too.
void l3d_turn_normals(std::span<float> away, l3d_micro_grid& grid);

/// Turns the grid's levels to the eye as l3d_turn_normals turns normals, and makes the numbers of
/// l3d_micro_vertex for mode l3d_shade::levels. A border vertex takes the side of its inner
/// neighbour if the levels between both then bend less.
///
/// Shape: `away` and `level` are laid out as the grid's arrays, `level` one number longer; both are
///        written to. The levels are those of unturned normals. On entry, the grid's normal[1] and
///        normal[2] hold the levels of the middles of sides; on return, they hold bends.
void l3d_turn_levels(std::span<float> away, std::span<float> level, l3d_micro_grid& grid);

/// Tells the sign of the light that a quad of a grid shows. It is -1 if the grid shows_both and the
/// quad turns to the right, else 1. A folded quad gives the sign of its piece at `side`.
/// Shape: `side` as in l3d_edge_polylines.
float l3d_side_of_quad(const l3d_micro_grid& grid, int row, int column, std::size_t side);

#endif
