// SPDX-License-Identifier: MIT
// l3d_turn_normals, l3d_turn_levels: outlines found from the change of facing along a grid, a row's
// vertices side by side in SIMD lanes.
#include "dice/seen_sides.h"

#include "scene/dice_view.h"
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

#include "raster/parallel/simd_dispatch_p.h"

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
    template <class T> HWY_ATTR void copy(const T* row, std::size_t columns) {
        at_[0] = static_cast<float>(row[0]);
        for (std::size_t i = 0; i < columns; ++i)
            at_[i + 1] = static_cast<float>(row[i]);
        std::fill(at_ + 1 + columns, at_ + columns + lane_columns + 1, at_[columns]);
    }
    HWY_ATTR HWY_INLINE float_lanes before(std::size_t i) const {
        return hn::LoadU(floats(), at_ + i);
    }
    HWY_ATTR HWY_INLINE float_lanes after(std::size_t i) const {
        return hn::LoadU(floats(), at_ + i + 2);
    }

private:
    float at_[most_columns + lane_columns + 1];
};

/// A row of a grid: where it and the rows above and below it are, or itself where there is none.
struct grid_row {
    std::size_t here, up, down, columns;
    float per_row; ///< 1 over how many rows `up` and `down` are apart

    HWY_ATTR grid_row(const l3d_micro_grid& grid, int row)
        : here(grid.index(row, 0)), up(row > 0 ? grid.index(row - 1, 0) : here),
          down(row + 1 < grid.rows ? grid.index(row + 1, 0) : here),
          columns(static_cast<std::size_t>(grid.columns)),
          per_row(row > 0 && row + 1 < grid.rows ? 0.5F : 1.0F) {}

    /// What a number changes by along v.
    HWY_ATTR HWY_INLINE float_lanes change_v(const float* of, std::size_t i) const {
        const floats d;
        return hn::Mul(hn::Set(d, per_row),
                       hn::Sub(hn::LoadU(d, of + down + i), hn::LoadU(d, of + up + i)));
    }
    HWY_ATTR HWY_INLINE float_lanes change_v(const std::int32_t* of, std::size_t i) const {
        const hn::Rebind<std::int32_t, floats> di;
        const auto both = hn::Sub(hn::LoadU(di, of + down + i), hn::LoadU(di, of + up + i));
        return hn::Mul(hn::Set(floats(), per_row), hn::ConvertTo(floats(), both));
    }
    /// The same along u: between the first and the last column over two steps.
    HWY_ATTR HWY_INLINE float_lanes change_u(const extended_row& of, std::size_t i) const {
        const floats d;
        const auto columns_before = hn::Iota(d, static_cast<float>(i));
        const auto at_end =
            hn::Or(hn::Eq(columns_before, hn::Zero(d)),
                   hn::Ge(columns_before, hn::Set(d, static_cast<float>(columns - 1))));
        const auto per_step = hn::IfThenElse(at_end, hn::Set(d, 1.0F), hn::Set(d, 0.5F));
        return hn::Mul(per_step, hn::Sub(of.after(i), of.before(i)));
    }
};

/// Turns the sides of vertices that are behind an outline.
///
/// Along the direction in which the picture does not change at an outline, 1 / w grows towards the
/// nearer sheet, and facing changes its sign: whether that is so near that this is the farther one.
class outline_finder {
public:
    HWY_ATTR outline_finder(const l3d_micro_grid& grid, const float* away)
        : grid_(grid), away_(away) {}

    HWY_ATTR void begin(const grid_row& row) {
        row_facing_.copy(away_ + row.here, row.columns);
        has_places_ = false;
    }

    /// The sides of the vertices from `i` on.
    HWY_ATTR HWY_INLINE float_lanes sides(const grid_row& row, std::size_t i) {
        const floats d;
        const auto own = hn::LoadU(d, away_ + row.here + i);
        const auto step =
            hn::Max(hn::Max(change(row_facing_.before(i), own), change(row_facing_.after(i), own)),
                    hn::Max(change(hn::LoadU(d, away_ + row.up + i), own),
                            change(hn::LoadU(d, away_ + row.down + i), own)));
        const auto near = hn::And(hn::Ge(hn::Mul(hn::Set(d, 2 * steps_behind), step), hn::Abs(own)),
                                  hn::FirstN(d, row.columns - i));
        const auto side =
            hn::IfThenElse(hn::Gt(own, hn::Zero(d)), hn::Set(d, -1.0F), hn::Set(d, 1.0F));
        if (HWY_LIKELY(hn::AllFalse(d, near)))
            return side;
        return hn::IfThenElse(hn::And(near, behind(row, i, own, step)), hn::Neg(side), side);
    }

private:
    HWY_ATTR hn::Mask<floats> behind(const grid_row& row, std::size_t i, float_lanes own,
                                     float_lanes step) {
        const floats d;
        if (!has_places_) {
            x_.copy(grid_.x.data() + row.here, row.columns);
            y_.copy(grid_.y.data() + row.here, row.columns);
            inv_w_.copy(grid_.inv_w.data() + row.here, row.columns);
            has_places_ = true;
        }
        const auto x_u = row.change_u(x_, i), x_v = row.change_v(grid_.x.data(), i);
        const auto y_u = row.change_u(y_, i), y_v = row.change_v(grid_.y.data(), i);
        const auto by_x =
            hn::Ge(hn::Add(hn::Abs(x_u), hn::Abs(x_v)), hn::Add(hn::Abs(y_u), hn::Abs(y_v)));
        auto k_u = hn::Neg(hn::IfThenElse(by_x, x_v, y_v)), k_v = hn::IfThenElse(by_x, x_u, y_u);
        const auto longest = hn::Max(hn::Abs(k_u), hn::Abs(k_v));
        const auto along = [&](float_lanes of_u, float_lanes of_v)
                               HWY_ATTR { return hn::Add(hn::Mul(of_u, k_u), hn::Mul(of_v, k_v)); };
        const auto nearer = along(row.change_u(inv_w_, i), row.change_v(grid_.inv_w.data(), i));
        const auto scale = hn::CopySign(hn::Div(hn::Set(d, 1.0F), longest), nearer);
        k_u = hn::Mul(k_u, scale);
        k_v = hn::Mul(k_v, scale);
        const auto turned = along(row.change_u(row_facing_, i), row.change_v(away_, i));
        const auto steps = hn::Div(hn::Neg(own), turned);
        const auto close =
            hn::And(hn::Gt(steps, hn::Zero(d)), hn::Le(steps, hn::Set(d, steps_behind)));
        const auto clear = hn::Ge(hn::Abs(turned), hn::Mul(hn::Set(d, least_turn), step));
        return hn::And(hn::Gt(longest, hn::Zero(d)), hn::And(close, clear));
    }

    const l3d_micro_grid& grid_;
    const float* away_;
    extended_row row_facing_, x_, y_, inv_w_;
    bool has_places_ = false; ///< the last three are the row's
};

/// Replaces each number of `away` by 1 or -1, the side that is seen: a row late, so that what is
/// read of neighbours is what it was.
HWY_ATTR void choose_sides(const l3d_micro_grid& grid, float* away) {
    const floats d;
    const auto columns = static_cast<std::size_t>(grid.columns);
    assert(columns <= most_columns);
    float sides[2][most_columns];
    outline_finder outlines(grid, away);
    for (int i = 0; i < grid.rows; ++i) {
        const grid_row row(grid, i);
        outlines.begin(row);
        for (std::size_t column = 0; column < columns; column += hn::Lanes(d))
            hn::StoreU(outlines.sides(row, column), d, sides[i % 2] + column);
        if (i > 0)
            std::copy_n(sides[(i - 1) % 2], columns, away + row.up);
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

/// Turns the levels of vertices and the bends of sides to the side of the surface that is seen. A
/// bend is how far a side's middle is above the mean of its ends. It is 0 where the ends show
/// different sides of the surface, as nothing is known of what is between.
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
