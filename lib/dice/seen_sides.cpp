// SPDX-License-Identifier: MIT
// l3d_turn_normals, l3d_turn_levels: outlines found from the change of facing along a grid.
#include "dice/seen_sides.h"

#include "scene/dice_view.h"
#include "raster/surface_part.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>

#include <hwy/base.h>

namespace {

/// So many steps behind an outline, at most, the nearer sheet decides. An outline runs somewhere
/// between two vertices, and the quads of the first vertex behind it stick out. More would turn
/// what is seen where an outline ends. 0.3 and 0.4 leave the fewest wrong pixels of 0 to 2 in the
/// pictures of seen_test; no bound depends on it.
constexpr float steps_behind = 0.4F;

/// Where an outline ends, facing hardly changes along the line of sight: by less than this part of
/// its largest change to a neighbour. No outline is told from it then. Chosen like steps_behind.
constexpr float least_turn = 0.3F;

/// Columns of a grid at most.
constexpr std::size_t most_columns =
    std::size_t{l3d_block_starts::most_blocks} * l3d_most_steps_whole + 1;

/// The neighbours of a vertex along one direction of a grid.
struct neighbours {
    std::size_t before, after;
    int steps;

    neighbours(std::size_t at, int i, int count, std::size_t step)
        : before(i > 0 ? at - step : at), after(i + 1 < count ? at + step : at),
          steps((i > 0) + (i + 1 < count)) {}

    float largest_change(std::span<const float> of, std::size_t at) const {
        return std::max(std::abs(of[after] - of[at]), std::abs(of[at] - of[before]));
    }
    /// For a step.
    template <class Numbers> float change(const Numbers& of) const {
        const auto both = static_cast<float>(of[after] - of[before]);
        return steps == 2 ? both / 2 : both;
    }
};

/// Along the direction in which the picture does not change at an outline, 1 / w grows towards the
/// nearer sheet, and facing changes its sign: whether that is so near that this is the farther one.
bool is_behind_outline(const l3d_micro_grid& grid, std::span<const float> away, std::size_t at,
                       const neighbours& u, const neighbours& v) {
    const float step = std::max(u.largest_change(away, at), v.largest_change(away, at));
    if (std::abs(away[at]) > 2 * steps_behind * step)
        return false;
    const float x_u = u.change(grid.x), x_v = v.change(grid.x);
    const float y_u = u.change(grid.y), y_v = v.change(grid.y);
    const bool by_x = std::abs(x_u) + std::abs(x_v) >= std::abs(y_u) + std::abs(y_v);
    float k_u = by_x ? -x_v : -y_v, k_v = by_x ? x_u : y_u;
    const float longest = std::max(std::abs(k_u), std::abs(k_v));
    if (!(longest > 0))
        return false;
    const float nearer = u.change(grid.inv_w) * k_u + v.change(grid.inv_w) * k_v;
    k_u *= std::copysign(1 / longest, nearer);
    k_v *= std::copysign(1 / longest, nearer);
    const float turned = u.change(away) * k_u + v.change(away) * k_v;
    const float steps = -away[at] / turned;
    return steps > 0 && steps <= steps_behind && std::abs(turned) >= least_turn * step;
}

/// The side that all of a grid shows; none if it shows both, or nearly does.
std::optional<float> only_side(const l3d_micro_grid& grid, std::span<const float> away) {
    float least = away[0], most = least, step = 0;
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    for (int row = 0; row < grid.rows; ++row) {
        const float* const of_row = away.data() + grid.index(row, 0);
        for (std::size_t i = 0; i < columns; ++i) {
            least = std::min(least, of_row[i]);
            most = std::max(most, of_row[i]);
        }
        for (std::size_t i = 0; i + 1 < columns; ++i)
            step = std::max(step, std::abs(of_row[i + 1] - of_row[i]));
        if (row + 1 < grid.rows)
            for (std::size_t i = 0; i < columns; ++i)
                step = std::max(step, std::abs(of_row[i + pitch] - of_row[i]));
    }
    if (most <= -2 * steps_behind * step)
        return 1.0F;
    if (least > 2 * steps_behind * step)
        return -1.0F;
    return std::nullopt;
}

/// Whether vertices of a row have so small a number that an outline may be near, by their changes
/// to neighbours; rows above and below are those at `up` and `down`, or the row itself.
void find_near(const float* HWY_RESTRICT row, const float* HWY_RESTRICT up,
               const float* HWY_RESTRICT down, std::size_t columns, float* HWY_RESTRICT near) {
    for (std::size_t i = 0; i < columns; ++i)
        near[i] = std::max(std::abs(up[i] - row[i]), std::abs(down[i] - row[i]));
    for (std::size_t i = 0; i + 1 < columns; ++i) {
        const float change = std::abs(row[i + 1] - row[i]);
        near[i] = std::max(near[i], change);
        near[i + 1] = std::max(near[i + 1], change);
    }
    for (std::size_t i = 0; i < columns; ++i)
        near[i] = 2 * steps_behind * near[i] - std::abs(row[i]);
}

/// Replaces each number of `away` by 1 or -1, the side that is seen: a row late, so that what is
/// read of neighbours is what it was.
void choose_sides(const l3d_micro_grid& grid, std::span<float> away) {
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    assert(columns <= most_columns);
    float sides[2][most_columns], near[most_columns];
    for (int row = 0; row < grid.rows; ++row) {
        const std::size_t first = grid.index(row, 0);
        const float* const here = &away[first];
        find_near(here, row > 0 ? here - pitch : here, row + 1 < grid.rows ? here + pitch : here,
                  columns, near);
        float* const of_row = sides[row % 2];
        for (std::size_t i = 0; i < columns; ++i)
            of_row[i] = here[i] > 0 ? -1.0F : 1.0F;
        for (std::size_t i = 0; i < columns; ++i) {
            if (HWY_LIKELY(near[i] < 0))
                continue;
            const neighbours u(first + i, static_cast<int>(i), grid.columns, 1);
            const neighbours v(first + i, row, grid.rows, pitch);
            if (is_behind_outline(grid, away, first + i, u, v))
                of_row[i] = -of_row[i];
        }
        if (row > 0)
            std::copy_n(sides[(row - 1) % 2], columns, &away[first - pitch]);
    }
    std::copy_n(sides[(grid.rows - 1) % 2], columns, &away[grid.index(grid.rows - 1, 0)]);
}

/// How far the middles of sides to vertices `step` on are above the mean of both ends, times the
/// side that is seen. It is 0 where the ends show different sides, since nothing is known of the
/// points between.
void put_bends(const float* HWY_RESTRICT level, const float* HWY_RESTRICT side, std::size_t step,
               std::size_t count, float* HWY_RESTRICT middle) {
    for (std::size_t i = 0; i < count; ++i) {
        const float bend = side[i] * (middle[i] - 0.5F * (level[i] + level[i + step]));
        middle[i] = side[i] == side[i + step] ? bend : 0.0F;
    }
}
void put_bends(const float* HWY_RESTRICT level, float side, std::size_t step, std::size_t count,
               float* HWY_RESTRICT middle) {
    for (std::size_t i = 0; i < count; ++i)
        middle[i] = side * (middle[i] - 0.5F * (level[i] + level[i + step]));
}

/// For each vertex of the grid.
template <class Visit> void for_vertices(const l3d_micro_grid& grid, const Visit& visit) {
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            visit(row, column, grid.index(row, column));
}

} // namespace

void l3d_turn_normals(std::span<float> away, l3d_micro_grid& grid) {
    const std::optional<float> all = only_side(grid, away);
    if (all == 1.0F)
        return;
    if (!all)
        choose_sides(grid, away);
    for_vertices(grid, [&](int, int, std::size_t at) {
        for (auto& component : grid.normal)
            component[at] *= all ? *all : away[at];
    });
}

void l3d_turn_levels(std::span<float> away, std::span<const float> level, l3d_micro_grid& grid) {
    const std::optional<float> all = only_side(grid, away);
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    const std::size_t count = pitch * static_cast<std::size_t>(grid.rows);
    if (!all)
        choose_sides(grid, away);
    for (int row = 0; row < grid.rows; ++row) {
        const std::size_t at = grid.index(row, 0), down = row + 1 < grid.rows ? pitch : 0;
        float *along_u = &grid.normal[1][at], *along_v = &grid.normal[2][at];
        if (all) {
            put_bends(&level[at], *all, 1, pitch, along_u);
            put_bends(&level[at], *all, down, pitch, along_v);
        } else {
            put_bends(&level[at], &away[at], 1, pitch, along_u);
            put_bends(&level[at], &away[at], down, pitch, along_v);
        }
    }
    for (std::size_t i = 0; i < count; ++i)
        grid.normal[0][i] = level[i] * (all ? *all : away[i]);
}
