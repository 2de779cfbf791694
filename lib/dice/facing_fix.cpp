// SPDX-License-Identifier: MIT
// l3d_turn_normals, l3d_turn_levels: turn a grid's light to its visible side, in SIMD lanes.
#include "dice/facing_fix.h"

#include "raster/surface_part.h"
#include "raster/surfaces/quad_cut_p.h"
#include "scene/dice_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/facing_fix.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// The largest number of vertices along a side of a grid.
constexpr std::size_t most_along =
    std::size_t{l3d_block_starts::most_blocks} * l3d_most_steps_whole + 1;

/// A vector of columns; rows of a grid have room for whole vectors.
using floats = hn::CappedTag<float, 16>;

/// Tells which side all vertices of a grid show, 1 or -1; 0 if the grid shows both sides.
HWY_ATTR float only_side(const l3d_micro_grid& grid, const float* away) {
    const floats d;
    const auto columns = static_cast<std::size_t>(grid.columns);
    auto least = hn::Set(d, away[0]), most = least;
    for (int row = 0; row < grid.rows; ++row) {
        const float* const of_row = away + grid.index(row, 0);
        for (std::size_t i = 0; i < columns; i += hn::Lanes(d)) {
            const auto here = hn::LoadU(d, of_row + i);
            const auto valid = hn::FirstN(d, columns - i);
            least = hn::IfThenElse(valid, hn::Min(least, here), least);
            most = hn::IfThenElse(valid, hn::Max(most, here), most);
        }
    }
    if (hn::GetLane(hn::MaxOfLanes(d, most)) <= 0)
        return 1;
    return hn::GetLane(hn::MinOfLanes(d, least)) > 0 ? -1.0F : 0.0F;
}

/// A vertex on a grid's border, its inner neighbour, and where the grid keeps the bend of the side
/// between them.
struct border_side {
    std::size_t at, inner;
    std::size_t component, bend_at; ///< indices into l3d_micro_grid::normal
};

/// Calls visit(border_side) for each vertex on a grid's border.
template <class Visit> void for_border(const l3d_micro_grid& grid, const Visit& visit) {
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    for (int column = 0; column < grid.columns; ++column) {
        const std::size_t first = grid.index(0, column), last = grid.index(grid.rows - 1, column);
        visit(border_side{first, first + pitch, 2, first});
        visit(border_side{last, last - pitch, 2, last - pitch});
    }
    for (int row = 0; row < grid.rows; ++row) {
        const std::size_t first = grid.index(row, 0), last = grid.index(row, grid.columns - 1);
        visit(border_side{first, first + 1, 1, first});
        visit(border_side{last, last - 1, 1, last - 1});
    }
}

/// Returns the sign that turns a grid's normals or levels to the eye. The sign is 1 if the grid
/// shows both sides, so that normals stay dS/du x dS/dv.
///
/// First corrects the grid's border. Calls negate(vertex) for each border vertex that shows another
/// side than its inner neighbour, if is_other(border_side) finds that the vertex's normal is the
/// cause.
template <class IsOther, class Negate>
HWY_ATTR float sign_of_light(l3d_micro_grid& grid, float* away, const IsOther& is_other,
                             const Negate& negate) {
    float side = only_side(grid, away);
    if (side == 0) {
        for_border(grid, [&](const border_side& of) {
            if ((away[of.at] > 0) == (away[of.inner] > 0) || !is_other(of))
                return;
            away[of.at] = -away[of.at];
            negate(of.at);
        });
        side = only_side(grid, away);
    }
    grid.shows_both = side == 0;
    return grid.shows_both ? 1 : side;
}

/// Calls visit(at, down) for each vector of vertices. `at` is the index of the vector's first
/// vertex. `down` is the offset of the next row, or 0 in the last row.
template <class Visit>
HWY_ATTR HWY_INLINE void for_vertices(const l3d_micro_grid& grid, const Visit& visit) {
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    for (int row = 0; row < grid.rows; ++row) {
        const std::size_t first = grid.index(row, 0), down = row + 1 < grid.rows ? pitch : 0;
        for (std::size_t at = first; at < first + static_cast<std::size_t>(grid.columns);
             at += hn::Lanes(floats()))
            visit(at, down);
    }
}

HWY_ATTR void turn_normals(float* away, l3d_micro_grid& grid) {
    const auto is_other = [&](const border_side& of) {
        float cosine = 0;
        for (const auto& component : grid.normal)
            cosine += component[of.at] * component[of.inner];
        return cosine < 0;
    };
    const auto negate = [&](std::size_t at) {
        for (auto& component : grid.normal)
            component[at] = -component[at];
    };
    if (sign_of_light(grid, away, is_other, negate) > 0)
        return;
    for_vertices(grid, [&](std::size_t at, std::size_t) HWY_ATTR {
        const floats d;
        for (auto& component : grid.normal)
            hn::StoreU(hn::Neg(hn::LoadU(d, component.data() + at)), d, component.data() + at);
    });
}

/// Turns the levels of vertices and the bends of sides to the visible side of the surface. A bend
/// says how far the level in a side's middle is above the mean of its ends' levels. The bend is 0
/// if the level of one end was negated, since the middle's level is then unknown.
HWY_ATTR void turn_levels(float* away, float* level, l3d_micro_grid& grid) {
    const floats d;
    const auto is_other = [&](const border_side& of) {
        const float middle = grid.normal[of.component][of.bend_at];
        const float half = (level[of.inner] - level[of.at]) / 2;
        return std::abs(middle - half) < std::abs(middle - half - level[of.at]);
    };
    std::array<std::size_t, std::size_t{4} * most_along> negated;
    std::size_t count = 0;
    const auto negate = [&](std::size_t at) {
        level[at] = -level[at];
        negated[count++] = at;
    };
    const auto side = hn::Set(d, sign_of_light(grid, away, is_other, negate));
    for_vertices(grid, [&](std::size_t at, std::size_t down) HWY_ATTR {
        const auto own = hn::LoadU(d, level + at);
        const auto put_bends = [&](std::size_t step, float* middles) HWY_ATTR {
            const auto mean =
                hn::Mul(hn::Set(d, 0.5F), hn::Add(own, hn::LoadU(d, level + at + step)));
            hn::StoreU(hn::Mul(side, hn::Sub(hn::LoadU(d, middles + at), mean)), d, middles + at);
        };
        put_bends(1, grid.normal[1].data());
        put_bends(down, grid.normal[2].data());
        hn::StoreU(hn::Mul(own, side), d, grid.normal[0].data() + at);
    });
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t at = negated[i];
        grid.normal[1][at] = grid.normal[2][at] = 0;
        if (at % pitch > 0)
            grid.normal[1][at - 1] = 0;
        if (at >= pitch)
            grid.normal[2][at - pitch] = 0;
    }
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {
namespace {

L3D_SIMD_TABLE(turn_normals);
L3D_SIMD_TABLE(turn_levels);

} // namespace
} // namespace l3d_detail

void l3d_turn_normals(std::span<float> away, l3d_micro_grid& grid) {
    using namespace l3d_detail;
    L3D_SIMD_CALL(turn_normals)(away.data(), grid);
}

void l3d_turn_levels(std::span<float> away, std::span<float> level, l3d_micro_grid& grid) {
    using namespace l3d_detail;
    L3D_SIMD_CALL(turn_levels)(away.data(), level.data(), grid);
}

float l3d_side_of_quad(const l3d_micro_grid& grid, int row, int column, std::size_t side) {
    using namespace l3d_detail;
    if (!grid.shows_both)
        return 1;
    const quad_corners v = corners_of(grid, grid.index(row, column));
    const quad_turns turns(v);
    constexpr std::array<std::size_t, 4> piece{0, 2, 3, 1}; // at each side of a folded quad
    const std::int64_t area2 =
        turns.folded()
            ? folded_sides(v, turns, projective_centre(v, grid.is_parallel)).area2(piece[side])
            : turns.area2();
    return area2 > 0 ? -1.0F : 1.0F;
}
#endif
