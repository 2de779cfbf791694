// SPDX-License-Identifier: MIT
// Which side of a diced surface is seen.
#ifndef L3D_DICE_SEEN_SIDES_H
#define L3D_DICE_SEEN_SIDES_H

#include "raster/micro_grid.h"
#include "raster/surface_rasterizer.h"

#include <array>
#include <cstddef>
#include <span>

/// How far a normal points away from the eye that looks at a pixel: positive if it is to be turned
/// round. Units: x, y in pixels; the result in those of the normal times those of the rays.
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

/// Turns the grid's normals to the side that is seen.
///
/// Where a surface bends away from the eye, its outline divides a sheet that is seen from one that
/// lies behind it. In the exact picture the second is hidden; drawn, it may stick out by as much as
/// both may be off. If it were lit as the back that it is, single pixels would be dark or bright.
/// Within a step of an outline the sheet that is seen, the nearer one, decides for both.
/// Shape: away as the grid's arrays: l3d_away_from_eye of each vertex; it is written to.
void l3d_turn_normals(std::span<float> away, l3d_micro_grid& grid);

/// The same for levels; makes what l3d_micro_vertex says of them in mode l3d_shade::levels.
///
/// Shape: `away` and `level` as the grid's arrays and a number longer. The levels are those of the
///        normals as they are. In the grid, normal[1] and normal[2] are the levels of the middles
///        of sides, in place of what these bend by.
void l3d_turn_levels(std::span<float> away, std::span<const float> level, l3d_micro_grid& grid);

#endif
