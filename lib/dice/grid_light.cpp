// SPDX-License-Identifier: MIT
// l3d_light_vertex, l3d_light_grid: normals and levels, one vertex at a time.
#include "dice/grid_light.h"

#include "dice/normal_columns.h"
#include "dice/facing_fix.h"
#include "scene/bends/surface_bends.h"

#include <cmath>
#include <cstddef>

namespace {

float level_of(const l3d_shading& shading, const float* normal) {
    const auto& light = shading.light;
    return l3d_level_of_cosine *
           (normal[0] * light[0] + normal[1] * light[1] + normal[2] * light[2]);
}

float level_at(const l3d_shading& shading, const l3d_normal_net& normals, double u, double v) {
    return level_of(shading, l3d_unit_normal(normals.evaluate(u, v)).data());
}

/// Writes the shade levels of vertices into `level`. Writes the levels of the middles of sides
/// along u and v in place of the normals' components 1 and 2.
void put_levels(const l3d_shading& shading, const l3d_normal_net& normals, l3d_diced_piece& piece,
                std::vector<float>& level) {
    l3d_micro_grid& grid = piece.part.grid;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t at = grid.index(row, column);
            const auto r = static_cast<std::size_t>(row), c = static_cast<std::size_t>(column);
            const double u = piece.u[c], v = piece.v[r];
            const double u1 = column + 1 < grid.columns ? piece.u[c + 1] : u;
            const double v1 = row + 1 < grid.rows ? piece.v[r + 1] : v;
            level[at] = level_at(shading, normals, u, v);
            grid.normal[1][at] = level_at(shading, normals, (u + u1) / 2, v);
            grid.normal[2][at] = level_at(shading, normals, u, (v + v1) / 2);
        }
}

} // namespace

void l3d_make_unit(float (&normal)[3]) {
    const float length =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (length > 0)
        for (float& component : normal)
            component /= length;
}

bool l3d_light_vertex(const l3d_dice_view& view, const l3d_image_point& h, float (&normal)[3]) {
    const l3d_shading& shading = view.shading;
    // The sum takes the ray through h, times w. That is linear in h, so it also holds behind the
    // eye.
    double away = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double right = double{shading.ray_right[k]}, down = double{shading.ray_down[k]};
        const double centre =
            double{shading.ray[k]} + view.size.width / 2.0 * right + view.size.height / 2.0 * down;
        away += double{normal[k]} * (h[2] * centre + h[0] * right + h[1] * down);
    }
    if (view.makes_levels()) {
        normal[0] = level_of(shading, normal);
        normal[1] = normal[2] = 0;
    }
    return away > 0;
}

void l3d_light_grid(const l3d_dice_view& view, const l3d_normal_net& normals,
                    l3d_diced_piece& piece, std::array<std::vector<float>, 2>& memory) {
    l3d_micro_grid& grid = piece.part.grid;
    piece.has_levels = view.makes_levels();
    if (!l3d_has_eye(view.shading) && !piece.has_levels)
        return;
    for (auto& numbers : memory)
        if (numbers.size() <= grid.x.size())
            numbers.resize(grid.x.size() + 1);
    auto& [away, level] = memory;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t at = grid.index(row, column);
            const float normal[3] = {grid.normal[0][at], grid.normal[1][at], grid.normal[2][at]};
            away[at] = l3d_away_from_eye(view.shading, normal,
                                         static_cast<float>(grid.x[at]) / l3d_subpixel_one,
                                         static_cast<float>(grid.y[at]) / l3d_subpixel_one);
        }
    if (!piece.has_levels)
        return l3d_turn_normals(away, grid);
    put_levels(view.shading, normals, piece, level);
    l3d_turn_levels(away, level, grid);
}
