// SPDX-License-Identifier: MIT
// Walks the vertices of a patch, its columns side by side in SIMD lanes.
#ifndef L3D_DICE_LANES_LANE_ROWS_P_H
#define L3D_DICE_LANES_LANE_ROWS_P_H

#include "dice/lanes/lane_bounds_p.h"
#include "raster/surface_part.h"

#include <array>
#include <cstdint>

namespace l3d_detail {

/// The number of columns or rows that are computed at a time. Behind the last column or row, arrays
/// hold finite numbers.
inline constexpr std::size_t lane_columns = 16;

/// The parameters of a grid of at most 4 strips along one direction.
struct lane_parameters {
    static constexpr std::size_t most = 4 * l3d_most_steps_whole + 1;
    static constexpr std::size_t room = (most + lane_columns - 1) / lane_columns * lane_columns;
    alignas(64) double at[room];
    /// The factor of the second derivative by which balancing moves vertices, for each parameter.
    alignas(64) double moved[room];
    std::size_t count = 0;

    /// The count of parameters, rounded up to whole vectors of lane_columns.
    std::size_t padded() const { return (count + lane_columns - 1) / lane_columns * lane_columns; }

    /// The middles between neighbouring parameters. In place of the last middle, the result has the
    /// last parameter.
    lane_parameters middles() const;

    /// Sets the parameters of each strip, which divide it into its n steps of equal length. Also
    /// sets `moved`, which is 0 unless `balanced`. The last parameter is 1, and so are all numbers
    /// behind it.
    void fill(int strips, const std::array<int, 4>& steps, bool balanced);

    /// Maps parameters from [0, 1] to [low, high].
    void place(double low, double high);
};

/// The types of registers in which columns can be walked.
enum class lane_register { float_32, float_64, fixed_32, fixed_64 };

/// The input of walk_in_lanes: the net, the columns, and how they are walked.
struct lane_walk {
    const centred_net& net;
    const lane_parameters& u;
    int strips;
    bool balanced;
    std::array<int, 4> rows; ///< number of steps of each strip along v
    /// The place of the centred net's origin in the picture, in sub-pixels from the picture's
    /// corner.
    std::int32_t origin_x, origin_y;
    /// The number that stands for 1 in registers: a power of two.
    double register_xy = 1, register_w = 1;
    float depth_scale = 1;
    /// In a parallel projection, w_middle is the w that registers leave out, and depth_slope is how
    /// much depth changes for a unit of w. Both are 0 in perspective.
    double w_middle = 0, depth_slope = 0;
};

/// Walks all columns by forward differences, projects and snaps their points, and writes these to
/// the grid. At the beginning of each strip, each column starts exactly, from a double. The slow
/// twin is l3d_strip_walker.
/// Expects: the grid has as many columns and rows as there are parameters; every point is in the
///          guard band.
/// Cost:    9 additions a column and step, one division and a few products a vertex.
void walk_in_lanes(const lane_walk& walk, lane_register kind, l3d_micro_grid& grid);

} // namespace l3d_detail

#endif
