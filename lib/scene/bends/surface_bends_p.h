// SPDX-License-Identifier: MIT
// The parts of a patch for l3d_surface_bends: bounds of its 8 x 8 parts, in lanes.
#ifndef L3D_SCENE_BENDS_SURFACE_BENDS_P_H
#define L3D_SCENE_BENDS_SURFACE_BENDS_P_H

#include "scene/bends/surface_bends.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

/// The number of parts along each side of a patch, two for each block.
inline constexpr std::size_t bend_parts = 8;

/// Names the members of l3d_bend_numbers in their order, as indices of arrays. bend_orders has the
/// order of the derivative that each member bounds.
enum bend_number : std::size_t {
    bend_uu,
    bend_uv,
    bend_vv,
    bend_uuu,
    bend_uuv,
    bend_uvv,
    bend_vvv,
    bend_uuvv,
    turn_u,
    turn_v,
    turn_uu,
    turn_uv,
    turn_vv,
    turn_uuu,
    turn_uuv,
    turn_uvv,
    turn_vvv,
    bend_numbers
};
inline constexpr std::array<int, bend_numbers> bend_orders{2, 2, 2, 3, 3, 3, 3, 4, 1,
                                                           1, 2, 2, 2, 3, 3, 3, 3};

/// For each bend_number, the orders by u and by v of the derivative that it bounds.
inline constexpr std::array<std::array<int, 2>, bend_numbers> bend_powers{{{2, 0},
                                                                           {1, 1},
                                                                           {0, 2},
                                                                           {3, 0},
                                                                           {2, 1},
                                                                           {1, 2},
                                                                           {0, 3},
                                                                           {2, 2},
                                                                           {1, 0},
                                                                           {0, 1},
                                                                           {2, 0},
                                                                           {1, 1},
                                                                           {0, 2},
                                                                           {3, 0},
                                                                           {2, 1},
                                                                           {1, 2},
                                                                           {0, 3}}};

/// Pointers to the members of l3d_bend_numbers, by bend_number.
template <class T>
inline constexpr std::array<T l3d_bend_numbers<T>::*, bend_numbers> bend_members{
    &l3d_bend_numbers<T>::uu,     &l3d_bend_numbers<T>::uv,    &l3d_bend_numbers<T>::vv,
    &l3d_bend_numbers<T>::uuu,    &l3d_bend_numbers<T>::uuv,   &l3d_bend_numbers<T>::uvv,
    &l3d_bend_numbers<T>::vvv,    &l3d_bend_numbers<T>::uuvv,  &l3d_bend_numbers<T>::turn_u,
    &l3d_bend_numbers<T>::turn_v, &l3d_bend_numbers<T>::n_uu,  &l3d_bend_numbers<T>::n_uv,
    &l3d_bend_numbers<T>::n_vv,   &l3d_bend_numbers<T>::n_uuu, &l3d_bend_numbers<T>::n_uuv,
    &l3d_bend_numbers<T>::n_uvv,  &l3d_bend_numbers<T>::n_vvv,
};

/// The bend numbers of one block, taken from the arrays for all blocks.
inline l3d_bend_numbers<double>
bends_of_block(const l3d_bend_numbers<l3d_surface_bends::lanes>& bends, std::size_t block) {
    l3d_bend_numbers<double> result{};
    for (std::size_t n = 0; n < bend_numbers; ++n)
        result.*bend_members<double>[n] =
            double{(bends.*bend_members<l3d_surface_bends::lanes>[n])[block]};
    return result;
}

/// The nets of a patch's normals and points: [component][row][column]. Points are relative to the
/// first point, and `size` is the largest magnitude of their coordinates.
struct bend_nets {
    double normals[3][6][6], points[3][4][4];
    double size;
};

/// The number of parts in a group, one part in each lane.
inline constexpr std::size_t part_lanes = 8;
/// A group of parts of a patch: Taylor coefficients of the parts' normals and points about the
/// parts' middles. Parameters are from -1 to 1 across a part. Shape: [power of u][power of
/// v][component][lane].
struct part_group {
    alignas(64) double normals[6][6][3][part_lanes];
    alignas(64) double points[4][4][3][part_lanes];
};

/// Bounds of derivatives over the parts of a group, and values of the derivatives in the parts'
/// middles: [number][lane]. Parameters are from 0 to 1 across a part. Without a bound, `most` is
/// infinite and `middle` means nothing.
struct group_bounds {
    alignas(64) double most[bend_numbers][part_lanes];
    alignas(64) double middle[bend_numbers][part_lanes];
};

/// Makes the parts of a patch. Each row of parts is a group.
void make_parts(const bend_nets& nets, part_group* rows);

/// Replaces the part in lane i by its quarter i % 4. Quarters 1 and 3 have the upper half of u;
/// quarters 2 and 3 have the upper half of v.
void quarter_parts(part_group& parts);

/// Computes bounds of derivatives for each part of a group. `size` is the largest magnitude of the
/// points' coordinates.
void bound_parts(const part_group& parts, double size, group_bounds& result);

} // namespace l3d_detail

#endif
