// SPDX-License-Identifier: MIT
// The visible side of a diced surface.
#ifndef L3D_DICE_FACING_FIX_H
#define L3D_DICE_FACING_FIX_H

#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <array>
#include <cstddef>
#include <span>

/// The part of a normal that points away from the eye at a pixel: positive if the normal is to be
/// turned round. Units: x, y in pixels; the result in units of the normal times units of the rays.
inline float l3d_away_from_eye(const l3d_shading& shading, const float* normal, float x, float y) {
    float away = 0;
    for (std::size_t k = 0; k < 3; ++k)
        away += normal[k] * (shading.ray[k] + x * shading.ray_right[k] + y * shading.ray_down[k]);
    return away;
}

/// Whether there is an eye to turn normals to.
inline bool l3d_has_eye(const l3d_shading& shading) {
    return shading.ray != std::array<float, 3>{0, 0, 0};
}

/// Turns the grid's normals to the visible side, if all of the grid shows the same one; else sets
/// shows_both.
///
/// Where a surface bends away from the eye, an outline passes through quads. One side of such a
/// quad is drawn, whichever sides its corners show. The eye would see that side, so all of the quad
/// is lit as this side. The other side of the surface begins at the same drawn line and lies
/// behind.
///
/// Where a side of a patch is nearly a point, dS along the side turns round. Normals there may be
/// those of the other side. Such a normal at a vertex on the grid's border is more than a right
/// angle off that of the next vertex inwards. The border vertex then shows the side that its inner
/// neighbour shows.
/// Shape: `away` as the grid's arrays: l3d_away_from_eye of each vertex. It is corrected, too.
void l3d_turn_normals(std::span<float> away, l3d_micro_grid& grid);

/// Turns the grid's levels to the visible side, as l3d_turn_normals turns normals, and makes the
/// numbers of l3d_micro_vertex for mode l3d_shade::levels. A border vertex takes the side of its
/// inner neighbour if the levels between the two then bend less.
///
/// Shape: `away` and `level` as the grid's arrays, `level` a number longer; both are written to.
///        The levels are those of the unturned normals. In the grid, normal[1] and normal[2] are
///        the levels of the middles of sides, in place of bends.
void l3d_turn_levels(std::span<float> away, std::span<float> level, l3d_micro_grid& grid);

/// The sign of the light that a quad of a grid shows. It is -1 if the grid shows_both and the quad
/// turns to the right, else 1. A folded quad shows the sign of its piece at `side`.
/// Shape: side as in l3d_edge_polylines.
float l3d_side_of_quad(const l3d_micro_grid& grid, int row, int column, std::size_t side);

#endif
