// SPDX-License-Identifier: MIT
// Makes the normals of a patch's vertices, or their levels, its columns side by side in SIMD lanes.
#ifndef L3D_DICE_LANES_LANE_LIGHT_P_H
#define L3D_DICE_LANES_LANE_LIGHT_P_H

#include "geom/normal_net.h"
#include "dice/lanes/lane_rows_p.h"
#include "raster/surface_part.h"
#include "raster/surface_rasterizer.h"

#include <cstddef>
#include <vector>

namespace l3d_detail {

/// A normal shorter than this may be rounding alone, as in l3d_unit_normal. Such normals occur
/// where the coefficients of a normal net vanish, for instance in the corner of a singular patch.
/// In a corner, all other coefficients have the weight 0.
inline constexpr float normal_rounding = 0x1p-42F;

/// Working memory of normals_in_lanes and levels_in_lanes: arrays with a number for each vertex of
/// a grid, and room for one vector more. They are kept between grids.
struct vertex_numbers {
    std::vector<float> away = std::vector<float>(room), level = std::vector<float>(room);

    static constexpr std::size_t room =
        lane_parameters::room * lane_parameters::most + lane_columns;
};

/// Writes the unit normals of a grid's vertices, or zero where there is no normal. If the shading
/// has an eye, normals are turned to it. The slow twin is l3d_normal_columns.
/// Expects: the grid's places are set.
/// Errors:  some 16 * 2^-24 of the weighted coefficients, before the normal is made a unit vector.
///          Bernstein polynomials are positive, so only coefficients can cancel.
void normals_in_lanes(const l3d_normal_net& net, const lane_parameters& u, const lane_parameters& v,
                      const l3d_shading& shading, vertex_numbers& memory, l3d_micro_grid& grid);

/// Writes the shade levels and bends of a grid's vertices (l3d_micro_vertex), for normals that are
/// turned to the eye. The slow twin is l3d_light_grid.
/// Expects: the grid's places are set.
/// Errors:  each level errs by 229.5 times the error of the unit normal: 2^-16 where the normal's
///          coefficients are not much larger than the normal.
void levels_in_lanes(const l3d_normal_net& net, const lane_parameters& u, const lane_parameters& v,
                     const l3d_shading& shading, vertex_numbers& memory, l3d_micro_grid& grid);

} // namespace l3d_detail

#endif
