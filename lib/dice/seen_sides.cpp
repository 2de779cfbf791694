// SPDX-License-Identifier: MIT
// l3d_turn_normals, l3d_turn_levels: outlines found from the change of facing along a grid, a row's
// vertices side by side in SIMD lanes.
#include "dice/seen_sides.h"

#include "dice/dice_view.h"
#include "raster/surface_part.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/seen_sides.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// So many steps behind an outline, at most, the nearer sheet decides. An outline runs somewhere
/// between two vertices, and the quads of the first vertex behind it stick out. More would turn
/// what is seen where an outline ends. 0.3 and 0.4 leave the fewest wrong pixels of 0 to 2 in the
/// pictures of seen_test; no bound depends on it.
constexpr float steps_behind = 0.4F;

/// Where an outline ends, facing hardly changes along the line of sight: by less than this part of
/// its largest change to a neighbour. No outline is told from it then. Chosen like steps_behind.
constexpr float least_turn = 0.3F;

/// Columns are taken so many at a time; rows of a grid have room for whole vectors.
constexpr std::size_t lane_columns = 16;

/// Columns of a grid at most, in whole vectors.
constexpr std::size_t most_columns =
    (std::size_t{l3d_block_starts::most_blocks} * l3d_most_steps_whole + lane_columns) /
    lane_columns * lane_columns;

/// The neighbours of a vertex along one direction of a grid.
struct neighbours {
    std::size_t before, after;
    int steps;

    neighbours(std::size_t at, int i, int count, std::size_t step)
        : before(i > 0 ? at - step : at), after(i + 1 < count ? at + step : at),
          steps((i > 0) + (i + 1 < count)) {}

    float largest_change(const float* of, std::size_t at) const {
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
bool is_behind_outline(const l3d_micro_grid& grid, const float* away, std::size_t at,
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

using floats = hn::CappedTag<float, lane_columns>;
using float_lanes = hn::Vec<floats>;

HWY_ATTR HWY_INLINE float_lanes change(float_lanes a, float_lanes b) {
    return hn::Abs(hn::Sub(a, b));
}

/// The side that all of a grid shows, 1 or -1; 0 if it shows both, or nearly does.
HWY_ATTR float only_side(const l3d_micro_grid& grid, const float* away) {
    const floats d;
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    auto least = hn::Set(d, away[0]), most = least, step = hn::Zero(d);
    for (int row = 0; row < grid.rows; ++row) {
        const float* const of_row = away + grid.index(row, 0);
        const std::size_t down = row + 1 < grid.rows ? pitch : 0;
        for (std::size_t i = 0; i < columns; i += hn::Lanes(d)) {
            const auto here = hn::LoadU(d, of_row + i);
            const auto valid = hn::FirstN(d, columns - i), inner = hn::FirstN(d, columns - 1 - i);
            least = hn::IfThenElse(valid, hn::Min(least, here), least);
            most = hn::IfThenElse(valid, hn::Max(most, here), most);
            const auto along_u = change(hn::LoadU(d, of_row + i + 1), here);
            const auto along_v = change(hn::LoadU(d, of_row + i + down), here);
            step = hn::Max(step, hn::Max(hn::IfThenElseZero(inner, along_u),
                                         hn::IfThenElseZero(valid, along_v)));
        }
    }
    const float near = 2 * steps_behind * hn::GetLane(hn::MaxOfLanes(d, step));
    if (hn::GetLane(hn::MaxOfLanes(d, most)) <= -near)
        return 1;
    return hn::GetLane(hn::MinOfLanes(d, least)) > near ? -1.0F : 0.0F;
}

/// A row of numbers, with the first and the last one once more before and behind it.
class extended_row {
public:
    HWY_ATTR void copy(const float* row, std::size_t columns) {
        at_[0] = row[0];
        std::copy_n(row, columns, at_ + 1);
        std::fill(at_ + 1 + columns, at_ + columns + lane_columns + 1, row[columns - 1]);
    }
    /// The largest change from numbers to their neighbours in the row.
    HWY_ATTR HWY_INLINE float_lanes changes(std::size_t i) const {
        const floats d;
        const auto here = hn::LoadU(d, at_ + i + 1);
        return hn::Max(change(hn::LoadU(d, at_ + i), here),
                       change(hn::LoadU(d, at_ + i + 2), here));
    }

private:
    float at_[most_columns + lane_columns + 1];
};

/// Which numbers of a row are so small, by their changes to neighbours, that an outline may be
/// near, as bits; rows above and below are those at `up` and `down`, or the row itself.
HWY_ATTR HWY_INLINE std::uint32_t near_outline(const extended_row& row, const float* here,
                                               const float* up, const float* down, std::size_t i,
                                               std::size_t columns) {
    const floats d;
    const auto own = hn::LoadU(d, here + i);
    const auto along_v =
        hn::Max(change(hn::LoadU(d, up + i), own), change(hn::LoadU(d, down + i), own));
    const auto near = hn::Mul(hn::Set(d, 2 * steps_behind), hn::Max(row.changes(i), along_v));
    const auto found = hn::And(hn::Ge(near, hn::Abs(own)), hn::FirstN(d, columns - i));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, found, bits);
    return bits[0] | std::uint32_t{bits[1]} << 8;
}

/// Replaces each number of `away` by 1 or -1, the side that is seen: a row late, so that what is
/// read of neighbours is what it was.
HWY_ATTR void choose_sides(const l3d_micro_grid& grid, float* away) {
    const floats d;
    const auto columns = static_cast<std::size_t>(grid.columns);
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    assert(columns <= most_columns);
    float sides[2][most_columns];
    extended_row extended;
    for (int row = 0; row < grid.rows; ++row) {
        const std::size_t first = grid.index(row, 0);
        const float* const here = away + first;
        const float* const up = row > 0 ? here - pitch : here;
        const float* const down = row + 1 < grid.rows ? here + pitch : here;
        extended.copy(here, columns);
        float* const of_row = sides[row % 2];
        for (std::size_t i = 0; i < columns; i += hn::Lanes(d)) {
            const auto turned = hn::Gt(hn::LoadU(d, here + i), hn::Zero(d));
            hn::StoreU(hn::IfThenElse(turned, hn::Set(d, -1.0F), hn::Set(d, 1.0F)), d, of_row + i);
            std::uint32_t near = near_outline(extended, here, up, down, i, columns);
            for (; near != 0; near &= near - 1) {
                const std::size_t k = i + hwy::Num0BitsBelowLS1Bit_Nonzero32(near);
                const neighbours u(first + k, static_cast<int>(k), grid.columns, 1);
                const neighbours v(first + k, row, grid.rows, pitch);
                if (is_behind_outline(grid, away, first + k, u, v))
                    of_row[k] = -of_row[k];
            }
        }
        if (row > 0)
            std::copy_n(sides[(row - 1) % 2], columns, away + first - pitch);
    }
    std::copy_n(sides[(grid.rows - 1) % 2], columns, away + grid.index(grid.rows - 1, 0));
}

/// For each vector of vertices of the grid: where it begins, what further the next row is, or 0 in
/// the last one, and the sides that are seen.
template <class Visit>
HWY_ATTR HWY_INLINE void for_sides(const l3d_micro_grid& grid, const float* away, float all,
                                   const Visit& visit) {
    const floats d;
    const auto pitch = static_cast<std::size_t>(grid.pitch);
    for (int row = 0; row < grid.rows; ++row) {
        const std::size_t first = grid.index(row, 0), down = row + 1 < grid.rows ? pitch : 0;
        for (std::size_t at = first; at < first + static_cast<std::size_t>(grid.columns);
             at += hn::Lanes(d))
            visit(at, down, all != 0 ? hn::Set(d, all) : hn::LoadU(d, away + at));
    }
}

HWY_ATTR void turn_normals(float* away, l3d_micro_grid& grid) {
    const float all = only_side(grid, away);
    if (all == 1)
        return;
    if (all == 0)
        choose_sides(grid, away);
    for_sides(grid, away, all, [&](std::size_t at, std::size_t, float_lanes side) HWY_ATTR {
        const floats d;
        for (auto& component : grid.normal)
            hn::StoreU(hn::Mul(hn::LoadU(d, component.data() + at), side), d,
                       component.data() + at);
    });
}

/// What the middles of sides to other vertices are above the mean of both ends, times the side that
/// is seen; 0 where the ends show different sides, as nothing is known of what is between.
HWY_ATTR void turn_levels(float* away, const float* level, l3d_micro_grid& grid) {
    const float all = only_side(grid, away);
    if (all == 0)
        choose_sides(grid, away);
    for_sides(grid, away, all, [&](std::size_t at, std::size_t down, float_lanes side) HWY_ATTR {
        const floats d;
        const auto own = hn::LoadU(d, level + at);
        const auto put_bends = [&](std::size_t step, float* middles) HWY_ATTR {
            const auto mean =
                hn::Mul(hn::Set(d, 0.5F), hn::Add(own, hn::LoadU(d, level + at + step)));
            auto bend = hn::Mul(side, hn::Sub(hn::LoadU(d, middles + at), mean));
            if (all == 0)
                bend = hn::IfThenElseZero(hn::Eq(side, hn::LoadU(d, away + at + step)), bend);
            hn::StoreU(bend, d, middles + at);
        };
        put_bends(1, grid.normal[1].data());
        put_bends(down, grid.normal[2].data());
        hn::StoreU(hn::Mul(own, side), d, grid.normal[0].data() + at);
    });
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

void l3d_turn_levels(std::span<float> away, std::span<const float> level, l3d_micro_grid& grid) {
    using namespace l3d_detail;
    L3D_SIMD_CALL(turn_levels)(away.data(), level.data(), grid);
}
#endif
