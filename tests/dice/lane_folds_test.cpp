// SPDX-License-Identifier: MIT
// Folded quads: found in grids of every width, and no farther from a bilinear piece than measured.
#include "nasty.h"
#include "dice/lanes/lane_folds_p.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace dice_tests {
namespace {

using point = std::array<double, 3>; // x w, y w, w; in sub-pixels

/// A part with quads of some pixels, each of its own kind of block, none folded.
l3d_surface_part flat_part(random_numbers& random, int columns, int rows) {
    l3d_surface_part part;
    part.grid.resize(columns, rows);
    for (int r = 0; r < rows; ++r)
        for (int c = 0; c < columns; ++c) {
            const std::size_t i = part.grid.index(r, c);
            part.grid.x[i] = 2000 * c - 700 * r + static_cast<int>(random.between(-300, 300));
            part.grid.y[i] = 1500 * r + 500 * c + static_cast<int>(random.between(-200, 200));
            part.grid.inv_w[i] = static_cast<float>(random.between(0.2, 0.3));
        }
    part.block_columns = {4, {0, columns / 4, columns / 2, columns - 2, columns - 1}};
    part.block_rows = {1, {0, rows - 1}};
    return part;
}

point corner(const l3d_micro_grid& grid, std::size_t i) {
    const double w = 1 / double{grid.inv_w[i]};
    return {grid.x[i] * w, grid.y[i] * w, w};
}

/// The largest distance in the picture of the fan of a quad from its bilinear piece, at the same
/// parameters. Units: pixels.
double sampled(const l3d_micro_grid& grid, int row, int column) {
    const point a = corner(grid, grid.index(row, column));
    const point b = corner(grid, grid.index(row, column + 1));
    const point c = corner(grid, grid.index(row + 1, column));
    const point d = corner(grid, grid.index(row + 1, column + 1));
    double most = 0;
    constexpr int steps = 40;
    for (int i = 0; i <= steps; ++i)
        for (int j = 0; j <= steps; ++j) {
            const double s = i / double{steps}, t = j / double{steps};
            // s t on the fan: linear on each of its triangles, as it is in the corners and centre.
            const double to_side = std::min({s, 1 - s, t, 1 - t});
            const double product = to_side == t       ? t / 2
                                   : to_side == s     ? s / 2
                                   : to_side == 1 - t ? s - (1 - t) / 2
                                                      : t - (1 - s) / 2;
            point fan{}, piece{};
            for (std::size_t k = 0; k < 3; ++k) {
                const double mixed = a[k] - b[k] - c[k] + d[k];
                const double linear = a[k] + s * (b[k] - a[k]) + t * (c[k] - a[k]);
                fan[k] = linear + product * mixed;
                piece[k] = linear + s * t * mixed;
            }
            most = std::max(most, std::hypot(fan[0] / fan[2] - piece[0] / piece[2],
                                             fan[1] / fan[2] - piece[1] / piece[2]));
        }
    return most / l3d_subpixel_one;
}

TEST(lane_folds, are_found_in_grids_of_every_width_and_bounded) {
    l3d_block_needs::per_block errors{};
    for (std::size_t i = 0; i < errors.size(); ++i)
        errors[i] = 100 * static_cast<double>(i + 1);
    double tightest = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        random_numbers random(seed);
        const int columns = 6 + static_cast<int>(random.below(40));
        const int rows = 2 + static_cast<int>(random.below(3));
        l3d_surface_part part = flat_part(random, columns, rows);
        ASSERT_EQ(l3d_detail::most_folded(part, errors), 0) << "seed " << seed;
        // The last column is pulled back over the one before it, or a corner alone is.
        const int row = static_cast<int>(random.below(static_cast<std::uint64_t>(rows - 1)));
        const std::size_t last = part.grid.index(row, columns - 1);
        part.grid.x[last] -= 2900;
        const double found = l3d_detail::most_folded(part, errors) - errors[3];
        const double wanted = sampled(part.grid, row, columns - 2);
        ASSERT_GE(found, wanted) << "seed " << seed;
        tightest = std::max(tightest, wanted / found);
    }
    EXPECT_GT(tightest, 0.6);
    EXPECT_LE(tightest, 1);
}

TEST(lane_folds, are_found_in_narrow_grids_and_where_w_is_the_same) {
    l3d_surface_part part;
    part.grid.resize(2, 2);
    part.grid.is_parallel = true;
    part.block_columns = part.block_rows = {1, {0, 1}};
    // A bow tie of 4 by 2 pixels: its mixed difference is 8 pixels long.
    const std::array<std::array<int, 2>, 4> corners{{{0, 0}, {1024, 512}, {1024, 0}, {0, 512}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t at = part.grid.index(static_cast<int>(i / 2), static_cast<int>(i % 2));
        part.grid.x[at] = corners[i][0];
        part.grid.y[at] = corners[i][1];
        part.grid.inv_w[at] = static_cast<float>(i + 1);
    }
    const l3d_block_needs::per_block errors{1};
    EXPECT_DOUBLE_EQ(l3d_detail::most_folded(part, errors), 1 + 8.0 / 16);
}

} // namespace
} // namespace dice_tests
