// SPDX-License-Identifier: MIT
// The parts of l3d_surface_bends: bounds of the 8 x 8 parts of a patch, in lanes.
#ifndef L3D_SCENE_BENDS_SURFACE_BENDS_P_H
#define L3D_SCENE_BENDS_SURFACE_BENDS_P_H

#include "scene/bends/surface_bends.h"

#include <array>
#include <cstddef>

namespace l3d_detail {

/// Parts along each side of a patch, two of a block.
inline constexpr std::size_t bend_parts = 8;

/// The numbers of l3d_bend_numbers in their order, and the order of derivative of each.
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

/// The order by u, and by v.
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

/// The members of l3d_bend_numbers, by their place.
template <class T>
inline constexpr std::array<T l3d_bend_numbers<T>::*, bend_numbers> bend_members{
    &l3d_bend_numbers<T>::uu,     &l3d_bend_numbers<T>::uv,    &l3d_bend_numbers<T>::vv,
    &l3d_bend_numbers<T>::uuu,    &l3d_bend_numbers<T>::uuv,   &l3d_bend_numbers<T>::uvv,
    &l3d_bend_numbers<T>::vvv,    &l3d_bend_numbers<T>::uuvv,  &l3d_bend_numbers<T>::turn_u,
    &l3d_bend_numbers<T>::turn_v, &l3d_bend_numbers<T>::n_uu,  &l3d_bend_numbers<T>::n_uv,
    &l3d_bend_numbers<T>::n_vv,   &l3d_bend_numbers<T>::n_uuu, &l3d_bend_numbers<T>::n_uuv,
    &l3d_bend_numbers<T>::n_uvv,  &l3d_bend_numbers<T>::n_vvv,
};

/// The bends of one block.
inline l3d_bend_numbers<double>
bends_of_block(const l3d_bend_numbers<l3d_surface_bends::lanes>& bends, std::size_t block) {
    l3d_bend_numbers<double> result{};
    for (std::size_t n = 0; n < bend_numbers; ++n)
        result.*bend_members<double>[n] =
            double{(bends.*bend_members<l3d_surface_bends::lanes>[n])[block]};
    return result;
}

/// Nets by component: [component][row][column]. Points count from the first one; `size` is their
/// largest coordinate.
struct bend_nets {
    double normals[3][6][6], points[3][4][4];
    double size;
};

/// Parts in lanes: Taylor's coefficients about their middles, for parameters from -1 to 1 across
/// them, of normals and points: [power of u][power of v][component][lane].
inline constexpr std::size_t part_lanes = 8;
struct part_group {
    alignas(64) double normals[6][6][3][part_lanes];
    alignas(64) double points[4][4][3][part_lanes];
};

/// Bounds by parts' own parameters from 0 to 1, and values in their middles. Without a bound, they
/// are infinite and meaningless. [number][lane]
struct group_bounds {
    alignas(64) double most[bend_numbers][part_lanes];
    alignas(64) double middle[bend_numbers][part_lanes];
};

/// The parts of a patch, a row of them a group.
void make_parts(const bend_nets& nets, part_group* rows);

/// Lane i gets quarter i % 4 of its part. Quarters 1 and 3 are the upper halves of u, 2 and 3 those
/// of v.
void quarter_parts(part_group& parts);

/// Bounds the parts; `size` is the largest coordinate of the points.
void bound_parts(const part_group& parts, double size, group_bounds& result);

} // namespace l3d_detail

#endif
