// SPDX-License-Identifier: MIT
// bend_planner: steps that depth needs, and the errors that remain.
#if defined(L3D_DICE_BEND_PLANNER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef L3D_DICE_BEND_PLANNER_INL_H
#undef L3D_DICE_BEND_PLANNER_INL_H
#else
#define L3D_DICE_BEND_PLANNER_INL_H
#endif

#include "dice/planned_steps-inl.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace l3d_detail {
namespace HWY_NAMESPACE {
namespace {

/// The factor of h^3 |N.S_uuu| in the error of a chord along the normal. The factor is the largest
/// value of s (1 - s) ((1 - 2 s) / 6 + l3d_balance) over the chord. It holds whether balance moves
/// one end of the chord, both ends or none.
constexpr double of_moved_thirds = 0.0322;

/// A cubic's difference over a step h is h times the derivative at a place s of the step, plus two
/// further terms. These two factors bound the terms. The first factor is that of h^2 times the
/// second derivative, the second that of h^3 times the third derivative. They are the largest
/// values of (1 - 2 s) / 2 and ((1 - s)^3 + s^3) / 6. Moved ends of the step add l3d_balance.
constexpr double of_difference_second = 1.0 / 2 + l3d_balance;
constexpr double of_difference_third = 1.0 / 6 + l3d_balance;

/// The factor of h_u^2 h_v^2 |S_uuvv| in the error of a quad. Chords contribute 1/64, moved chords
/// 2 l3d_balance / 8, and chords moved in both directions l3d_balance^2. The corners' mixed
/// difference counts a quarter.
constexpr double of_fourths = 1.0 / 64 + l3d_balance / 4 + l3d_balance * l3d_balance +
                              of_difference_second * of_difference_second / 4;

/// Bounds the errors of depth that given steps leave in each block. l3d_plan_steps compares the
/// bounds with the budget while it chooses steps. NUMERICS, section 3, Depth.
class bend_planner {
public:
    explicit bend_planner(const l3d_block_needs& needs)
        : strips_(static_cast<std::size_t>(needs.strips)), per_strip_(1.0 / needs.strips) {
        const l3d_block_needs::normal_bends& of = needs.bends;
        second_[along_u].take(of.uu, strips_);
        second_[along_v].take(of.vv, strips_);
        third_[along_u].take(of.uuu, strips_);
        third_[along_v].take(of.vvv, strips_);
        twist_.take(of.uv, strips_);
        turned_[along_u].take(of.uuv, strips_);
        turned_[along_v].take(of.uvv, strips_);
        rest_[along_u].take(of.uuuv, strips_);
        rest_[along_v].take(of.uvvv, strips_);
        fourth_.take(of.uuvv, strips_);
    }

    /// Finds the largest second and third derivatives along d in each strip of direction d.
    HWY_INLINE void largest(direction d, double (&second)[most_strips],
                            double (&third)[most_strips]) const {
        largest_in_strips(second_[d], d, strips_, second);
        largest_in_strips(third_[d], d, strips_, third);
    }

    /// Bounds the errors of depth in a strip's blocks, from block `lane` on. Units: budgets of
    /// depth.
    HWY_INLINE lane_vec errors(direction d, std::size_t strip, std::size_t lane,
                               const strip_numbers& s) const {
        const auto chords = hn::Add(chord(d, d, strip, lane, s.own_step, s.own_bend),
                                    chord(other(d), d, strip, lane, s.step, s.bend));
        const lane_vec both = hn::Mul(s.own_step, s.step);
        const lane_vec turned = hn::Add(hn::Mul(turned_[d].in(d, strip, lane), s.own_step),
                                        hn::Mul(turned_[other(d)].in(d, strip, lane), s.step));
        const lane_vec twist =
            hn::Add(twist_.in(d, strip, lane),
                    hn::Add(times(of_difference_second, turned), rest(d, strip, lane, s)));
        const lane_vec fourths =
            times(of_fourths, hn::Mul(hn::Mul(both, both), fourth_.in(d, strip, lane)));
        return hn::Add(hn::Add(chords, times(0.25, hn::Mul(both, twist))), fourths);
    }

    /// Bounds the errors of depth in slits along the piece's sides, where chords are not balanced.
    /// A chord counts only in blocks that have it at a side of the piece. `along_side` is 1 in
    /// blocks with chords along d at a side, else 0. `at_side` is 1 in blocks with chords across d
    /// at a side, else 0.
    HWY_INLINE lane_vec slit_errors(direction d, std::size_t strip, std::size_t lane,
                                    const strip_numbers& s, lane_vec along_side,
                                    lane_vec at_side) const {
        const auto eighth = [](lane_vec h) HWY_ATTR { return times(1.0 / 8, hn::Mul(h, h)); };
        return larger(hn::Mul(along_side, chord(d, d, strip, lane, s.own_step, eighth(s.own_step))),
                      hn::Mul(at_side, chord(other(d), d, strip, lane, s.step, eighth(s.step))));
    }

private:
    static HWY_INLINE lane_vec times(double factor, lane_vec v) {
        return hn::Mul(hn::Set(lane_tag(), factor), v);
    }

    /// Bounds the error of chords over steps h along the direction `which`, in blocks of a strip of
    /// direction d. `bend` is the factor of second derivatives.
    HWY_INLINE lane_vec chord(direction which, direction d, std::size_t strip, std::size_t lane,
                              lane_vec h, lane_vec bend) const {
        const lane_vec cube = hn::Mul(hn::Mul(h, h), h);
        return hn::Add(hn::Mul(second_[which].in(d, strip, lane), bend),
                       times(of_moved_thirds, hn::Mul(cube, third_[which].in(d, strip, lane))));
    }

    /// Bounds the last part of the corners' mixed difference, divided by both steps. This part
    /// comes from |S_uuuv|, |S_uvvv| and the fifth and sixth derivatives. By the piece's own
    /// parameters, the fifth and sixth derivatives are |S_uuuvv| <= 4 |S_uuuv|, |S_uuvvv| <= 4
    /// |S_uvvv| and |S_uuuvvv| <= 8 |S_uuuv|. A block's parameters run `strips` times as fast.
    HWY_INLINE lane_vec rest(direction d, std::size_t strip, std::size_t lane,
                             const strip_numbers& s) const {
        const lane_vec one = hn::Set(lane_tag(), 1.0);
        const lane_vec u = d == along_u ? s.own_step : s.step;
        const lane_vec v = d == along_u ? s.step : s.own_step;
        const lane_vec more_u = times(per_strip_, u), more_v = times(per_strip_, v);
        const lane_vec with_v =
            hn::Mul(more_v, hn::Add(hn::Set(lane_tag(), 4 * of_difference_second),
                                    times(8 * of_difference_third, more_v)));
        const lane_vec with_u = times(4 * of_difference_second, more_u);
        const auto part = [&](direction of, lane_vec h, lane_vec more) HWY_ATTR {
            return hn::Mul(hn::Mul(h, h),
                           hn::Mul(rest_[of].in(d, strip, lane), hn::Add(one, more)));
        };
        return times(of_difference_third,
                     hn::Add(part(along_u, u, with_v), part(along_v, v, with_u)));
    }

    std::size_t strips_;
    double per_strip_;
    block_numbers second_[2], third_[2], twist_, turned_[2], rest_[2], fourth_;
};

} // namespace
} // namespace HWY_NAMESPACE
} // namespace l3d_detail
HWY_AFTER_NAMESPACE();

#endif
