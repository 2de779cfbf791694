// SPDX-License-Identifier: MIT
// Patches for tests of meshes: a square of them, whose borders run either way.
#ifndef L3D_TESTS_RASTER_MESH_PATCHES_H
#define L3D_TESTS_RASTER_MESH_PATCHES_H

#include "raster/canvas_2d.h"
#include "raster/paths/gradient.h"

#include <cstddef>
#include <random>
#include <vector>

inline double uniform(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// The same patch, whose rows are columns.
inline l3d_mesh_patch turned(const l3d_mesh_patch& patch) {
    l3d_mesh_patch result = patch;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            result.points[i][j] = patch.points[j][i];
    return result;
}

/// across x across patches of one colour on a picture of size x size pixels. Inner control points
/// are off by up to wild(row, column) pixels. Patches are turned by half, mirrored, or turned by a
/// quarter, so that borders run either way.
template <class Wild>
std::vector<l3d_mesh_patch> square_of_patches(std::size_t across, double size, const Wild& wild,
                                              std::mt19937& random) {
    const std::size_t side = 3 * across + 1;
    std::vector<std::vector<l3d_point_2d>> net(side, std::vector<l3d_point_2d>(side));
    for (std::size_t r = 0; r < side; ++r)
        for (std::size_t k = 0; k < side; ++k) {
            const bool rim = r == 0 || k == 0 || r == side - 1 || k == side - 1;
            const double most = rim ? 0 : wild(r, k), step = (size + 1) / double(side - 1);
            net[r][k] = {-1 + double(k) * step + uniform(random, -most, most),
                         -1 + double(r) * step + uniform(random, -most, most)};
        }
    std::vector<l3d_mesh_patch> result;
    for (std::size_t r = 0; r < across; ++r)
        for (std::size_t k = 0; k < across; ++k) {
            l3d_mesh_patch patch;
            const bool flip = random() % 2 == 0, mirror = random() % 2 == 0;
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < 4; ++j)
                    patch.points[i][j] =
                        net[3 * r + (flip ? 3 - i : i)][3 * k + (mirror ? 3 - j : j)];
            patch.colors.fill(canvas::color);
            result.push_back(random() % 2 == 0 ? patch : turned(patch));
        }
    return result;
}

#endif
