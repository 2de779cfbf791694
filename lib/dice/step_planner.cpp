// SPDX-License-Identifier: MIT
// Choosing integer steps per strip, the blocks of a strip in SIMD lanes.
#include "dice/step_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/step_planner.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Keeps hopeless cases finite, and tells even there which direction needs more steps.
constexpr int most_steps = 1 << 28;

/// Pieces with more steps than this are cut anyway, and are many when it comes to that.
constexpr int most_worth_saving = 64;

constexpr std::size_t most_strips = l3d_block_needs::most_strips;
using lane_tag = hn::CappedTag<double, most_strips>;
using lane_vec = hn::Vec<lane_tag>;
using lane_mask = hn::Mask<lane_tag>;

/// The two directions; as an index, and as the other one's.
enum direction : std::size_t { along_u, along_v };
constexpr direction other(direction d) {
    return d == along_u ? along_v : along_u;
}

/// A number of each block in two orders: in `by[d]` the blocks of a strip of direction d lie side
/// by side. Those of strips that there are not are 0.
struct block_numbers {
    alignas(64) double by[2][most_strips * most_strips] = {};

    void take(const l3d_block_needs::per_block& of, std::size_t strips) {
        for (std::size_t b = 0; b < strips; ++b)
            for (std::size_t a = 0; a < strips; ++a)
                by[along_v][most_strips * b + a] = by[along_u][most_strips * a + b] =
                    of[strips * b + a];
    }

    /// Of the blocks of a strip, from `lane` on.
    HWY_INLINE lane_vec in(direction d, std::size_t strip, std::size_t lane) const {
        return hn::Load(lane_tag(), by[d] + most_strips * strip + lane);
    }
};

/// The larger numbers; what is no number is left out.
HWY_INLINE lane_vec larger(lane_vec a, lane_vec b) {
    return hn::IfThenElse(hn::Gt(b, a), b, a);
}

/// The largest number of each strip of direction d, in lanes.
HWY_INLINE void largest_in_strips(const block_numbers& of, direction d,
                                  double (&out)[most_strips]) {
    for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(lane_tag())) {
        lane_vec most = hn::Zero(lane_tag());
        for (std::size_t strip = 0; strip < most_strips; ++strip)
            most = larger(most, of.in(other(d), strip, lane));
        hn::Store(most, lane_tag(), out + lane);
    }
}

/// Steps along one direction, and what follows from them, by strip.
struct steps_along {
    int n[most_strips] = {1, 1, 1, 1}, fewest[most_strips] = {1, 1, 1, 1};
    alignas(64) double step[most_strips] = {1, 1, 1, 1}; ///< h
    alignas(64) double bend[most_strips] = {};           ///< what multiplies a second derivative
    alignas(64) double moved[most_strips] = {};          ///< how much of it vertices are moved by

    void set(std::size_t strip, int steps, bool balanced) {
        const double h = 1.0 / steps;
        n[strip] = steps;
        step[strip] = h;
        moved[strip] = balanced && steps > 1 ? l3d_balance * h * h : 0;
        bend[strip] = moved[strip] > 0 ? moved[strip] : h * h / 8;
    }
};

/// The steps while they are chosen, and what is asked of them.
class planner {
public:
    planner(const l3d_block_needs& needs, double budget, l3d_quad_kind kind)
        : needs_(needs), strips_(static_cast<std::size_t>(needs.strips)), budget_(budget),
          mixed_(kind == l3d_quad_kind::whole ? 1.0 / 16 : 1.0 / 4), third_{needs.uuv, needs.uvv} {
        second_[along_u].take(needs.uu, strips_);
        second_[along_v].take(needs.vv, strips_);
        twist_.take(needs.uv, strips_);
        if (needs.keeps_depth) {
            depth_[along_u].take(needs.depth_uu, strips_);
            depth_[along_v].take(needs.depth_vv, strips_);
            depth_twist_.take(needs.depth_uv, strips_);
        }
    }

    /// Half the budget to each direction: the product of the steps is then least.
    HWY_INLINE void start() {
        start_along(along_u, needs_.least_u);
        start_along(along_v, needs_.least_v);
    }

    /// The mixed terms come on top of the halves: refine where they do not fit. More steps are
    /// never worse, but for two after one, which is not balanced: then all is looked at once more.
    HWY_INLINE void refine() {
        for (bool settled = false; !settled;) {
            settled = true;
            for (std::size_t strip = 0; strip < strips_; ++strip)
                settled &= refine_strip(strip);
        }
    }

    /// Rounding up leaves slack that the other direction can often use.
    HWY_INLINE void coarsen() {
        for (std::size_t strip = 0; strip < strips_; ++strip)
            for (const direction d : {along_u, along_v})
                coarsen_strip(d, strip);
    }

    HWY_INLINE void finish(l3d_step_plan& plan) const {
        plan.strips = needs_.strips;
        plan.visible = needs_.visible;
        plan.balanced = needs_.balanced;
        std::copy_n(steps_[along_u].n, most_strips, plan.nu.begin());
        std::copy_n(steps_[along_v].n, most_strips, plan.nv.begin());
        lane_vec most = hn::Zero(lane_tag());
        for (std::size_t strip = 0; strip < strips_; ++strip)
            for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(lane_tag())) {
                most = larger(most, image_errors(along_v, strip, lane));
                most = larger(most, slit_errors(along_v, strip, lane));
            }
        plan.chord_error = hn::GetLane(hn::MaxOfLanes(lane_tag(), most));
    }

private:
    /// Refines a v-strip, the coarser direction first, until its blocks are fine enough or
    /// hopeless. Returns whether they were.
    HWY_INLINE bool refine_strip(std::size_t strip) {
        bool settled = true;
        unsigned hopeless = 0;
        for (unsigned left; (left = unmet(along_v, strip) & ~hopeless) != 0;) {
            const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
            const int nu = steps_[along_u].n[lane], nv = steps_[along_v].n[strip];
            if (nu + nv >= 2 * most_steps) {
                hopeless |= 1u << lane;
                continue;
            }
            // In proportion, so that a far too coarse start needs few rounds.
            const auto more = [&](direction d, std::size_t s, int n) {
                steps_[d].set(s, n + 1 + n / 8, needs_.balanced);
            };
            nu <= nv ? more(along_u, lane, nu) : more(along_v, strip, nv);
            settled = false;
        }
        return settled;
    }

    /// Steps between 1 and most_steps.
    static int rounded_up(double steps) {
        const double n = std::ceil(steps);
        return n < most_steps ? std::max(1, static_cast<int>(n)) : most_steps;
    }

    /// Steps with which a second derivative takes half the budget at most, `squared` being the
    /// square of those that are not balanced.
    int steps_for(double squared) const {
        if (!needs_.balanced || squared <= 1)
            return rounded_up(std::sqrt(squared));
        return std::max(2, rounded_up(std::sqrt(8 * l3d_balance * squared)));
    }

    HWY_INLINE void start_along(direction d, const l3d_block_needs::per_block& least) {
        block_numbers least_of;
        least_of.take(least, strips_);
        alignas(64) double image[most_strips], depth[most_strips], few[most_strips];
        largest_in_strips(second_[d], d, image);
        largest_in_strips(depth_[d], d, depth);
        largest_in_strips(least_of, d, few);
        steps_along& here = steps_[d];
        for (std::size_t strip = 0; strip < strips_; ++strip) {
            here.fewest[strip] = rounded_up(few[strip]);
            const int for_depth = rounded_up(std::sqrt(depth[strip] / 4));
            here.set(
                strip,
                std::max({here.fewest[strip], steps_for(image[strip] / (4 * budget_)), for_depth}),
                needs_.balanced);
        }
    }

    HWY_INLINE void coarsen_strip(direction d, std::size_t strip) {
        steps_along& here = steps_[d];
        while (here.n[strip] > here.fewest[strip] && here.n[strip] <= most_worth_saving) {
            const int before = here.n[strip];
            here.set(strip, before - 1, needs_.balanced);
            if (unmet(d, strip) != 0) {
                here.set(strip, before, needs_.balanced);
                break;
            }
        }
    }

    /// What steps do to the blocks of a strip of direction d, from `lane` on.
    struct strip_numbers {
        lane_vec step, bend, moved; ///< across the strip: those of the other direction
        lane_vec own_step, own_bend, own_moved;
    };
    HWY_INLINE strip_numbers numbers_of(direction d, std::size_t strip, std::size_t lane) const {
        const lane_tag tag;
        const steps_along &own = steps_[d], &across = steps_[other(d)];
        return {hn::Load(tag, across.step + lane),  hn::Load(tag, across.bend + lane),
                hn::Load(tag, across.moved + lane), hn::Set(tag, own.step[strip]),
                hn::Set(tag, own.bend[strip]),      hn::Set(tag, own.moved[strip])};
    }

    HWY_INLINE lane_vec image_errors(direction d, std::size_t strip, std::size_t lane) const {
        const lane_tag tag;
        const strip_numbers s = numbers_of(d, strip, lane);
        const lane_vec own = second_[d].in(d, strip, lane);
        const lane_vec across = second_[other(d)].in(d, strip, lane);
        const lane_vec uv = twist_.in(d, strip, lane);
        const lane_vec both = hn::Mul(hn::Mul(s.moved, s.own_moved), hn::Set(tag, needs_.uuvv));
        const lane_vec thirds =
            hn::Add(hn::Mul(hn::Mul(s.own_moved, s.step), hn::Set(tag, third_[d])),
                    hn::Mul(hn::Mul(s.moved, s.own_step), hn::Set(tag, third_[other(d)])));
        const lane_vec twist =
            hn::Add(hn::Mul(hn::Mul(uv, s.step), s.own_step),
                    hn::Add(hn::Add(thirds, thirds), hn::Mul(hn::Set(tag, 4.0), both)));
        const lane_vec bends = hn::Add(hn::Mul(own, s.own_bend), hn::Mul(across, s.bend));
        const lane_vec error = hn::Add(hn::Add(bends, both), hn::Mul(twist, hn::Set(tag, mixed_)));
        // Not visible, or flat.
        const auto nothing = hn::Eq(hn::Add(hn::Add(own, uv), across), hn::Zero(tag));
        return hn::IfThenZeroElse(nothing, error);
    }

    /// Of w, in budgets. Balanced or not: with n >= 2, all that balance adds is within the 1/8 that
    /// it saves from. NUMERICS, section 3.
    HWY_INLINE lane_vec depth_errors(direction d, std::size_t strip, std::size_t lane) const {
        const strip_numbers s = numbers_of(d, strip, lane);
        const lane_vec own = hn::Mul(depth_[d].in(d, strip, lane), hn::Mul(s.own_step, s.own_step));
        const lane_vec across =
            hn::Mul(depth_[other(d)].in(d, strip, lane), hn::Mul(s.step, s.step));
        const lane_vec twist =
            hn::Mul(depth_twist_.in(d, strip, lane), hn::Mul(s.own_step, s.step));
        return hn::Add(hn::Mul(hn::Add(own, across), hn::Set(lane_tag(), 1.0 / 8)),
                       hn::Mul(twist, hn::Set(lane_tag(), mixed_)));
    }

    /// Of the slits along the piece's sides, where the block lies at one.
    HWY_INLINE lane_vec slit_errors(direction d, std::size_t strip, std::size_t lane) const {
        const lane_tag tag;
        if (!needs_.balanced)
            return hn::Zero(tag); // no more than that of the quads
        alignas(64) static constexpr double at_ends[most_strips] = {1, 0, 0, 1};
        const strip_numbers s = numbers_of(d, strip, lane);
        const lane_vec at_sides = hn::Set(tag, at_ends[strip]);
        const lane_vec own =
            hn::Mul(second_[d].in(d, strip, lane),
                    hn::Mul(hn::Mul(s.own_step, s.own_step), hn::Load(tag, at_ends + lane)));
        const lane_vec across = hn::Mul(second_[other(d)].in(d, strip, lane),
                                        hn::Mul(hn::Mul(s.step, s.step), at_sides));
        return hn::Mul(larger(own, across), hn::Set(tag, 1.0 / 8));
    }

    /// The blocks of a strip that are not fine enough, as bits.
    HWY_INLINE unsigned unmet(direction d, std::size_t strip) const {
        const lane_tag tag;
        const lane_vec budget = hn::Set(tag, budget_);
        unsigned bits = 0;
        for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(tag)) {
            lane_mask met = hn::And(hn::Le(image_errors(d, strip, lane), budget),
                                    hn::Le(slit_errors(d, strip, lane), budget));
            if (needs_.keeps_depth)
                met = hn::And(met, hn::Le(depth_errors(d, strip, lane), hn::Set(tag, 1.0)));
            std::uint8_t of_lanes[8] = {};
            hn::StoreMaskBits(tag, hn::Not(met), of_lanes);
            bits |= static_cast<unsigned>(of_lanes[0]) << lane;
        }
        return bits;
    }

    const l3d_block_needs& needs_;
    std::size_t strips_;
    double budget_, mixed_, third_[2];
    block_numbers second_[2], twist_, depth_[2], depth_twist_;
    steps_along steps_[2];
};

void plan_steps(const l3d_block_needs& needs, double budget, l3d_quad_kind kind,
                l3d_step_plan& plan) {
    planner steps(needs, budget, kind);
    if (needs.visible) {
        steps.start();
        steps.refine();
        steps.coarsen();
    }
    steps.finish(plan);
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {
namespace {

L3D_SIMD_TABLE(plan_steps);

} // namespace
} // namespace l3d_detail

l3d_step_plan l3d_plan_steps(const l3d_block_needs& needs, double budget, l3d_quad_kind kind) {
    using namespace l3d_detail;
    l3d_step_plan plan;
    L3D_SIMD_CALL(plan_steps)(needs, budget, kind, plan);
    return plan;
}
#endif
