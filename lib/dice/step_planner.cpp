// SPDX-License-Identifier: MIT
// Chooses the whole numbers of steps of all strips, with the blocks of a strip in SIMD lanes.
#include "dice/step_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "dice/step_planner.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "dice/bend_planner-inl.h"
#include "raster/parallel/simd_dispatch_p.h"

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The limit of steps in a strip. The limit keeps numbers of steps finite in hopeless cases. Even
/// there, the numbers tell which direction needs more steps.
constexpr int most_steps = 1 << 28;

/// The share of the corners' mixed difference by which a folded quad, drawn as a fan of four
/// triangles, errs.
constexpr double of_fan = 1.0 / 16;

/// The largest number of steps of a strip for which fewer steps are tried. Pieces with more steps
/// are cut anyway, and may be many.
constexpr int most_worth_saving = 64;

/// The steps of all strips while they are chosen, and the needs that they have to meet.
class planner {
public:
    planner(const l3d_block_needs& needs, double budget, l3d_quad_kind kind)
        : needs_(needs), strips_(static_cast<std::size_t>(needs.strips)), budget_(budget),
          mixed_(mixed_of(kind)), third_{needs.uuv, needs.uvv} {
        second_[along_u].take(needs.uu, strips_);
        second_[along_v].take(needs.vv, strips_);
        twist_.take(needs.uv, strips_);
        if (needs.keeps_depth) {
            depth_[along_u].take(needs.depth_uu, strips_);
            depth_[along_v].take(needs.depth_vv, strips_);
            depth_twist_.take(needs.depth_uv, strips_);
        }
        if (needs.keeps_bends)
            bends_.emplace(needs);
    }

    /// Chooses the steps.
    HWY_INLINE void choose() {
        start();
        refine();
        coarsen();
    }

    HWY_INLINE void finish(l3d_step_plan& plan) const {
        plan.strips = needs_.strips;
        plan.visible = needs_.visible;
        plan.balanced = needs_.balanced;
        std::copy_n(steps_[along_u].n, most_strips, plan.nu.begin());
        std::copy_n(steps_[along_v].n, most_strips, plan.nv.begin());
        lane_vec most = hn::Zero(lane_tag()), of_fans = most;
        for (std::size_t strip = 0; strip < strips_; ++strip)
            for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(lane_tag())) {
                const lane_vec of_blocks = image_errors(along_v, strip, lane, mixed_);
                hn::Store(of_blocks, lane_tag(), &plan.errors[most_strips * strip + lane]);
                most = larger(most, of_blocks);
                most = larger(most, slit_errors(along_v, strip, lane));
                of_fans = larger(of_fans, image_errors(along_v, strip, lane, drawn_mixed()));
            }
        of_fans = larger(of_fans, most);
        plan.chord_error = hn::GetLane(hn::MaxOfLanes(lane_tag(), most));
        plan.fan_error = hn::GetLane(hn::MaxOfLanes(lane_tag(), of_fans));
        plan.bend_error = bend_error();
    }

    /// Takes the steps of a given plan in place of choosing them.
    HWY_INLINE void take(const l3d_step_plan& plan) {
        for (std::size_t strip = 0; strip < strips_; ++strip) {
            steps_[along_u].set(strip, plan.nu[strip], plan.balanced);
            steps_[along_v].set(strip, plan.nv[strip], plan.balanced);
        }
    }

    /// The error along the normal that these steps leave.
    HWY_INLINE double bend_error() const {
        lane_vec most = hn::Zero(lane_tag());
        if (bends_)
            for (std::size_t strip = 0; strip < strips_; ++strip)
                for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(lane_tag()))
                    most = larger(most, bend_errors(along_v, strip, lane));
        return hn::GetLane(hn::MaxOfLanes(lane_tag(), most));
    }

private:
    static double mixed_of(l3d_quad_kind kind) {
        if (kind == l3d_quad_kind::convex)
            return 0;
        return kind == l3d_quad_kind::whole ? of_fan : 1.0 / 4;
    }

    /// The share of the mixed difference that counts if every quad is folded.
    double drawn_mixed() const { return std::max(mixed_, of_fan); }

    /// Starts with half the budget for each direction, since this makes the product of the numbers
    /// of steps least.
    HWY_INLINE void start() {
        start_along(along_u, needs_.least_u);
        start_along(along_v, needs_.least_v);
    }

    /// Refines strips where the mixed terms exceed the budget. More steps are never worse, except
    /// that two steps may be worse than one, since one step is not balanced. So after a change, all
    /// strips are checked once more.
    HWY_INLINE void refine() {
        for (bool settled = false; !settled;) {
            settled = true;
            for (std::size_t strip = 0; strip < strips_; ++strip)
                settled &= refine_strip(strip);
        }
    }

    /// Coarsens strips where rounding up has left enough room.
    HWY_INLINE void coarsen() {
        for (std::size_t strip = 0; strip < strips_; ++strip)
            for (const direction d : {along_u, along_v})
                coarsen_strip(d, strip);
    }

    /// Refines the steps in a v-strip, of the coarser direction first, until the strip's blocks are
    /// fine enough or hopeless. Returns whether nothing had to change.
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
            // Steps grow in proportion, so that a far too coarse start needs few rounds.
            const auto more = [&](direction d, std::size_t s, int n) {
                steps_[d].set(s, n + 1 + n / 8, needs_.balanced);
            };
            nu <= nv ? more(along_u, lane, nu) : more(along_v, strip, nv);
            settled = false;
        }
        return settled;
    }

    /// Rounds a number of steps up to a whole number between 1 and most_steps.
    static int rounded_up(double steps) {
        const double n = std::ceil(steps);
        return n < most_steps ? std::max(1, static_cast<int>(n)) : most_steps;
    }

    /// The steps with which a second derivative takes at most half the budget. `squared` is the
    /// square of the unbalanced steps.
    int steps_for(double squared) const {
        if (!needs_.balanced || squared <= 1)
            return rounded_up(std::sqrt(squared));
        return std::max(2, rounded_up(std::sqrt(8 * l3d_balance * squared)));
    }

    /// The steps with which the error along the normal takes at most half the budget. Third
    /// derivatives count, too.
    int steps_for_bends(double second, double third) const {
        const int steps = steps_for(second / 4);
        const double of_third = of_moved_thirds / l3d_balance / steps;
        return third > 0 ? steps_for((second + of_third * third) / 4) : steps;
    }

    HWY_INLINE void start_along(direction d, const l3d_block_needs::per_block& least) {
        block_numbers least_of;
        least_of.take(least, strips_);
        alignas(64) double image[most_strips], few[most_strips], depth[most_strips] = {};
        alignas(64) double bend[most_strips] = {}, third[most_strips] = {};
        largest_in_strips(second_[d], d, strips_, image);
        largest_in_strips(least_of, d, strips_, few);
        if (needs_.keeps_depth)
            largest_in_strips(depth_[d], d, strips_, depth);
        if (bends_)
            bends_->largest(d, bend, third);
        steps_along& here = steps_[d];
        for (std::size_t strip = 0; strip < strips_; ++strip) {
            here.fewest[strip] = rounded_up(few[strip]);
            const int for_depth = rounded_up(std::sqrt(depth[strip] / 4));
            const int for_image = steps_for(image[strip] / (4 * budget_));
            here.set(strip,
                     std::max({here.fewest[strip], for_image, for_depth,
                               steps_for_bends(bend[strip], third[strip])}),
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

    /// The steps along both directions, and their factors of errors, in the blocks of a strip of
    /// direction d, from block `lane` on.
    HWY_INLINE strip_numbers numbers_of(direction d, std::size_t strip, std::size_t lane) const {
        const lane_tag tag;
        const steps_along &own = steps_[d], &across = steps_[other(d)];
        return {hn::Load(tag, across.step + lane),  hn::Load(tag, across.bend + lane),
                hn::Load(tag, across.moved + lane), hn::Set(tag, own.step[strip]),
                hn::Set(tag, own.bend[strip]),      hn::Set(tag, own.moved[strip])};
    }

    HWY_INLINE lane_vec image_errors(direction d, std::size_t strip, std::size_t lane,
                                     double mixed_share) const {
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
        const lane_vec error =
            hn::Add(hn::Add(bends, both), hn::Mul(twist, hn::Set(tag, mixed_share)));
        // Not visible, or flat.
        const auto nothing = hn::Eq(hn::Add(hn::Add(own, uv), across), hn::Zero(tag));
        return hn::IfThenZeroElse(nothing, error);
    }

    /// Bounds the errors of w in the blocks of a strip. The bounds hold whether vertices are
    /// balanced or not: with n >= 2, all that balancing adds stays within the 1/8 of a chord.
    /// NUMERICS, section 3. Units: budgets of w.
    HWY_INLINE lane_vec depth_errors(direction d, std::size_t strip, std::size_t lane) const {
        const strip_numbers s = numbers_of(d, strip, lane);
        const lane_vec own = hn::Mul(depth_[d].in(d, strip, lane), hn::Mul(s.own_step, s.own_step));
        const lane_vec across =
            hn::Mul(depth_[other(d)].in(d, strip, lane), hn::Mul(s.step, s.step));
        const lane_vec twist =
            hn::Mul(depth_twist_.in(d, strip, lane), hn::Mul(s.own_step, s.step));
        return hn::Add(hn::Mul(hn::Add(own, across), hn::Set(lane_tag(), 1.0 / 8)),
                       hn::Mul(twist, hn::Set(lane_tag(), drawn_mixed())));
    }

    /// Bounds the errors of quads and slits along the normal. Units: budgets of depth.
    HWY_INLINE lane_vec bend_errors(direction d, std::size_t strip, std::size_t lane) const {
        const strip_numbers s = numbers_of(d, strip, lane);
        const lane_vec quads = bends_->errors(d, strip, lane, s);
        if (!needs_.balanced)
            return quads;
        return larger(quads,
                      bends_->slit_errors(d, strip, lane, s, hn::Load(lane_tag(), at_ends + lane),
                                          hn::Set(lane_tag(), at_ends[strip])));
    }

    /// Bounds the errors of slits along the piece's sides; 0 for blocks that lie at no side.
    HWY_INLINE lane_vec slit_errors(direction d, std::size_t strip, std::size_t lane) const {
        const lane_tag tag;
        if (!needs_.balanced)
            return hn::Zero(tag); // no larger than the quads' errors
        const strip_numbers s = numbers_of(d, strip, lane);
        const lane_vec at_sides = hn::Set(tag, at_ends[strip]);
        const lane_vec own =
            hn::Mul(second_[d].in(d, strip, lane),
                    hn::Mul(hn::Mul(s.own_step, s.own_step), hn::Load(tag, at_ends + lane)));
        const lane_vec across = hn::Mul(second_[other(d)].in(d, strip, lane),
                                        hn::Mul(hn::Mul(s.step, s.step), at_sides));
        return hn::Mul(larger(own, across), hn::Set(tag, 1.0 / 8));
    }

    /// Finds the blocks of a strip whose errors exceed a budget. The result has a bit for each
    /// block.
    HWY_INLINE unsigned unmet(direction d, std::size_t strip) const {
        const lane_tag tag;
        const lane_vec budget = hn::Set(tag, budget_);
        unsigned bits = 0;
        for (std::size_t lane = 0; lane < most_strips; lane += hn::MaxLanes(tag)) {
            lane_mask met = hn::And(hn::Le(image_errors(d, strip, lane, mixed_), budget),
                                    hn::Le(slit_errors(d, strip, lane), budget));
            if (bends_)
                met = hn::And(met, hn::Le(bend_errors(d, strip, lane), hn::Set(tag, 1.0)));
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
    std::optional<bend_planner> bends_;
    steps_along steps_[2];
};

/// The needs, raised where outlines need finer steps.
l3d_block_needs with_outlines(const l3d_block_needs& needs) {
    l3d_block_needs result = needs;
    const auto strips = static_cast<std::size_t>(needs.strips);
    for (std::size_t i = 0; i < strips * strips; ++i) {
        const bool folds = (needs.folds >> i & 1) != 0;
        const bool in_side_row = i < strips || i + strips >= strips * strips;
        const bool in_side_column = i % strips == 0 || (i + 1) % strips == 0;
        if (folds || in_side_row)
            result.uu[i] *= needs.finer_outlines;
        if (folds || in_side_column)
            result.vv[i] *= needs.finer_outlines;
        if (folds) {
            result.uv[i] *= needs.finer_outlines;
            result.bends.refine(i, needs.finer_outlines);
        }
    }
    return result;
}

void choose_steps(const l3d_block_needs& needs, double budget, l3d_quad_kind kind,
                  l3d_step_plan& plan) {
    planner steps(needs, budget, kind);
    if (needs.visible)
        steps.choose();
    steps.finish(plan);
}

void plan_steps(const l3d_block_needs& needs, double budget, l3d_quad_kind kind,
                l3d_step_plan& plan) {
    if (needs.finer_outlines > 1 && kind != l3d_quad_kind::triangles) {
        choose_steps(with_outlines(needs), budget, kind, plan);
        if (std::max(plan.most_u(), plan.most_v()) <= l3d_most_steps_whole) {
            planner steps(needs, budget, kind);
            steps.take(plan);
            return steps.finish(plan);
        }
    }
    choose_steps(needs, budget, kind, plan);
}

void bend_error_of(const l3d_block_needs& needs, const l3d_step_plan& plan, double& error) {
    planner steps(needs, 0, l3d_quad_kind::whole);
    steps.take(plan);
    error = steps.bend_error();
}

/// Does the work of l3d_bends_of, in lanes, row by row of the net.
void bends_of(const l3d_image_patch& net, double x, double y, double focal, l3d_net_bends& out) {
    constexpr std::size_t points = 16;
    const lane_tag d;
    // Vectors may reach beyond the last row.
    alignas(64) double p[3][points + most_strips] = {};
    auto nearest = hn::Set(d, net.points[0][2]);
    for (std::size_t i = 0; i < points; i += hn::Lanes(d)) {
        lane_vec of[3];
        hn::LoadInterleaved3(d, &net.points[i][0], of[0], of[1], of[2]);
        for (std::size_t k = 0; k < 3; ++k)
            hn::Store(of[k], d, p[k] + i);
        nearest = hn::Min(nearest, of[2]);
    }
    const auto take = [&](std::size_t lanes, lane_vec& largest, const auto& difference) HWY_ATTR {
        const lane_vec w = difference(p[2]);
        const lane_vec dx = hn::Sub(difference(p[0]), hn::Mul(hn::Set(d, x), w));
        const lane_vec dy = hn::Sub(difference(p[1]), hn::Mul(hn::Set(d, y), w));
        const lane_vec dw = hn::Mul(hn::Set(d, focal), w);
        const lane_vec square = hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dw, dw));
        largest = hn::Max(largest, hn::IfThenElseZero(hn::FirstN(d, lanes), square));
    };
    const auto second = [&](std::size_t i, std::size_t step) HWY_ATTR {
        return [=](const double* of) HWY_ATTR {
            const auto ends = hn::Add(hn::LoadU(d, of + i), hn::LoadU(d, of + i + 2 * step));
            return hn::Sub(ends, hn::Mul(hn::Set(d, 2.0), hn::LoadU(d, of + i + step)));
        };
    };
    const auto twist = [&](std::size_t i) HWY_ATTR {
        return [=](const double* of) HWY_ATTR {
            const auto at = [&](std::size_t k) HWY_ATTR { return hn::LoadU(d, of + i + k); };
            return hn::Add(hn::Sub(hn::Sub(at(0), at(1)), at(4)), at(5));
        };
    };
    lane_vec uu = hn::Zero(d), vv = uu, uv = uu;
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t column = 0; column < 2; column += hn::Lanes(d))
            take(2 - column, uu, second(4 * line + column, 1));
    for (std::size_t i = 0; i < 8; i += hn::Lanes(d))
        take(hn::Lanes(d), vv, second(i, 4));
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; column += hn::Lanes(d))
            take(3 - column, uv, twist(4 * row + column));
    const auto size = [&](lane_vec square)
                          HWY_ATTR { return std::sqrt(hn::GetLane(hn::MaxOfLanes(d, square))); };
    out = {size(uu), size(vv), size(uv), hn::GetLane(hn::MinOfLanes(d, nearest))};
}

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace l3d_detail {
namespace {

L3D_SIMD_TABLE(plan_steps);
L3D_SIMD_TABLE(bend_error_of);
L3D_SIMD_TABLE(bends_of);

} // namespace
} // namespace l3d_detail

l3d_step_plan l3d_plan_steps(const l3d_block_needs& needs, double budget, l3d_quad_kind kind) {
    using namespace l3d_detail;
    l3d_step_plan plan;
    L3D_SIMD_CALL(plan_steps)(needs, budget, kind, plan);
    return plan;
}

double l3d_bend_error_of(const l3d_block_needs& needs, const l3d_step_plan& plan) {
    using namespace l3d_detail;
    double error = 0;
    L3D_SIMD_CALL(bend_error_of)(needs, plan, error);
    return error;
}

l3d_net_bends l3d_bends_of(const l3d_image_patch& net, const l3d_image_box& hull, double focal) {
    using namespace l3d_detail;
    l3d_net_bends result;
    L3D_SIMD_CALL(bends_of)
    (net, (hull.left + hull.right) / 2, (hull.top + hull.bottom) / 2, focal, result);
    return result;
}
#endif
