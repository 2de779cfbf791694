// SPDX-License-Identifier: MIT
// The planner's tables: numbers of blocks and steps of strips, a strip's blocks in lanes.
#if defined(L3D_DICE_PLANNED_STEPS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_DICE_PLANNED_STEPS_INL_H
#undef L3D_DICE_PLANNED_STEPS_INL_H
#else
#define L3D_DICE_PLANNED_STEPS_INL_H
#endif

#include "dice/step_plan.h"

#include <algorithm>
#include <cstddef>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr std::size_t most_strips = l3d_block_needs::most_strips;
using lane_tag = hn::CappedTag<double, most_strips>;
using lane_vec = hn::Vec<lane_tag>;
using lane_mask = hn::Mask<lane_tag>;

/// The two directions of parameters, as indices of arrays.
enum direction : std::size_t { along_u, along_v };
constexpr direction other(direction d) {
    return d == along_u ? along_v : along_u;
}

/// One number for each block of a net, in two orders. In `by[d]`, the blocks of a strip of
/// direction d lie side by side, so that one load reads them. A net of one block has 0 in the lanes
/// of the missing blocks. The strips that a net of one block lacks are not set.
struct block_numbers {
    alignas(64) double by[2][most_strips * most_strips];

    HWY_INLINE void take(const l3d_block_needs::per_block& of, std::size_t strips) {
        if (strips == 1) {
            const lane_tag tag;
            for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(tag)) {
                const auto first = hn::FirstN(tag, lane == 0 ? 1 : 0);
                const lane_vec numbers = hn::IfThenElseZero(first, hn::Set(tag, of[0]));
                hn::Store(numbers, tag, by[along_u] + lane);
                hn::Store(numbers, tag, by[along_v] + lane);
            }
            return;
        }
        for (std::size_t b = 0; b < strips; ++b)
            for (std::size_t a = 0; a < strips; ++a)
                by[along_v][most_strips * b + a] = by[along_u][most_strips * a + b] =
                    of[strips * b + a];
    }

    /// The numbers of a strip's blocks, from block `lane` on.
    HWY_INLINE lane_vec in(direction d, std::size_t strip, std::size_t lane) const {
        return hn::Load(lane_tag(), by[d] + most_strips * strip + lane);
    }
};

/// The larger number of each lane. If b is NaN, the result is a.
HWY_INLINE lane_vec larger(lane_vec a, lane_vec b) {
    return hn::IfThenElse(hn::Gt(b, a), b, a);
}

/// Finds the largest number in each strip of direction d, one strip in each element of `out`.
HWY_INLINE void largest_in_strips(const block_numbers& of, direction d, std::size_t strips,
                                  double (&out)[most_strips]) {
    for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(lane_tag())) {
        lane_vec most = hn::Zero(lane_tag());
        for (std::size_t strip = 0; strip < strips; ++strip)
            most = larger(most, of.in(other(d), strip, lane));
        hn::Store(most, lane_tag(), out + lane);
    }
}

/// For each of four strips: 1 if the strip is at a side of the piece, 0 if it is inside.
alignas(64) constexpr double at_ends[most_strips] = {1, 0, 0, 1};

/// The steps of each strip along one direction, and the factors of errors that follow from them.
struct steps_along {
    int n[most_strips] = {1, 1, 1, 1}, fewest[most_strips] = {1, 1, 1, 1};
    alignas(64) double step[most_strips] = {1, 1, 1, 1}; ///< the step h = 1 / n
    /// The factor of a second derivative in a chord's error.
    alignas(64) double bend[most_strips] = {};
    /// l3d_balance h^2 in strips whose vertices are balanced, else 0.
    alignas(64) double moved[most_strips] = {};

    void set(std::size_t strip, int steps, bool balanced) {
        const double h = 1.0 / steps;
        n[strip] = steps;
        step[strip] = h;
        moved[strip] = balanced && steps > 1 ? l3d_balance * h * h : 0;
        bend[strip] = moved[strip] > 0 ? moved[strip] : h * h / 8;
    }
};

/// The steps along both directions in the blocks of one strip, from some block on, a block a lane.
/// The strip's own steps are the same in all its blocks.
struct strip_numbers {
    /// The members of steps_along for the steps across the strip's direction, a block a lane.
    lane_vec step, bend, moved;
    lane_vec own_step, own_bend, own_moved;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
