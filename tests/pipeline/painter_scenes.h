// SPDX-License-Identifier: MIT
// Random triangles of a picture, and which of them is nearest at a pixel, by its definition.
#ifndef L3D_TESTS_PIPELINE_PAINTER_SCENES_H
#define L3D_TESTS_PIPELINE_PAINTER_SCENES_H

#include "raster/zsort/painter.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace pipeline_tests {

/// A picture of triangle numbers from 1, 0 where nothing is; `tied` where the two nearest depths
/// differ by no more than 2^-21 of the nearer: a float's rounding of each, twice over.
struct nearest_triangles {
    static constexpr double tie = 0x1p-21;
    std::vector<std::uint32_t> number;
    std::vector<bool> tied;
};

/// Pixel by pixel and triangle by triangle: coverage in whole numbers, depth in long double.
nearest_triangles find_nearest(const std::vector<l3d_painter_triangle>& triangles, l3d_size size);

/// Triangles of one of several kinds: through each other, in cycles, slivers, on common corners, in
/// layers, on a raster of whole pixels. Their materials are numbers from 1.
std::vector<l3d_painter_triangle> random_triangles(std::mt19937& random, l3d_size size);

/// A shading in which each material of materials_of shows its number.
l3d_shading show_numbers();

/// For that shading, one for each number of so many triangles; for others, none.
std::vector<l3d_material> materials_of(const l3d_shading& shading, std::size_t triangles);

/// Three rectangles, each over the next and under the one before.
std::vector<l3d_painter_triangle> rectangle_cycle(l3d_size size);

} // namespace pipeline_tests

#endif
