// SPDX-License-Identifier: MIT
// Choosing integer steps per strip.
#include "pipeline/step_plan.h"

#include <cmath>
#include <cstddef>

namespace {

/// Keeps hopeless cases finite, and tells even there which direction needs more steps.
constexpr int most_steps = 1 << 28;

/// Pieces with more steps than this are cut anyway, and are many when it comes to that.
constexpr int most_worth_saving = 64;

struct block_need {
    bool visible = false;
    l3d_second_bounds image, depth;
    double depth_budget = 0;
};

int steps_for(double second_bound, double eighths) {
    const double n = std::ceil(std::sqrt(second_bound / eighths));
    return n < most_steps ? std::max(1, static_cast<int>(n)) : most_steps;
}

/// The needs of all blocks, and whether given steps meet them.
class needs {
public:
    needs(std::span<const l3d_image_patch> blocks, const l3d_dice_view& view, double budget,
          l3d_quad_kind kind)
        : strips_(blocks.size() == 1 ? 1 : l3d_step_plan::most_strips), budget_(budget),
          kind_(kind) {
        for (std::size_t i = 0; i < blocks.size(); ++i)
            blocks_[i] = need_of(blocks[i], view);
    }

    int strips() const { return strips_; }
    const block_need& at(int a, int b) const {
        return blocks_[static_cast<std::size_t>(b) * static_cast<std::size_t>(strips_) +
                       static_cast<std::size_t>(a)];
    }

    double error(int a, int b, int nu, int nv) const { return error_of(at(a, b).image, nu, nv); }

    bool met(int a, int b, int nu, int nv) const {
        if (!at(a, b).visible)
            return true;
        return error(a, b, nu, nv) <= budget_ &&
               error_of(at(a, b).depth, nu, nv) <= at(a, b).depth_budget;
    }

    double budget() const { return budget_; }

private:
    block_need need_of(const l3d_image_patch& block, const l3d_dice_view& view) const {
        block_need need;
        if (l3d_outside(block.points, view.margin(), view.near, view.far))
            return need;
        const double least = l3d_depth_range_of(block.points).least;
        const bool in_front = least > view.near;
        const double w_low = view.drawn_w(least);
        l3d_image_box box = view.margin();
        if (in_front)
            box = box.intersected(l3d_image_box_of(block.points));
        if (box.empty())
            return need;
        need.visible = true;
        need.image = l3d_second_bounds_of(block, box, w_low);
        need.depth_budget = view.depth_budget(least);
        // |D2 w| times half the box's diagonal is part of the image bound: in a box with a half
        // diagonal of 8 budgets, w is off by an eighth at most where the image is within budget.
        // Width and height together are at most sqrt(2) diagonals.
        constexpr double two_root_two = 2.8284271247461903;
        if (!in_front || box.width() + box.height() < 8 * two_root_two * budget_)
            need.depth = l3d_depth_bounds_of(block);
        return need;
    }

    double error_of(const l3d_second_bounds& m, int nu, int nv) const {
        return kind_ == l3d_quad_kind::whole ? m.quad_error(nu, nv) : m.triangle_error(nu, nv);
    }

    int strips_;
    double budget_;
    l3d_quad_kind kind_;
    std::array<block_need, std::size_t{l3d_step_plan::most_strips} * l3d_step_plan::most_strips>
        blocks_;
};

/// Half the budget to each direction: the product of the steps is then least.
void start(const needs& need, l3d_step_plan& plan) {
    for (int b = 0; b < need.strips(); ++b)
        for (int a = 0; a < need.strips(); ++a) {
            const block_need& block = need.at(a, b);
            if (!block.visible)
                continue;
            plan.visible = true;
            int& nu = plan.nu[static_cast<std::size_t>(a)];
            int& nv = plan.nv[static_cast<std::size_t>(b)];
            nu = std::max({nu, steps_for(block.image.uu, 4 * need.budget()),
                           steps_for(block.depth.uu, 4 * block.depth_budget)});
            nv = std::max({nv, steps_for(block.image.vv, 4 * need.budget()),
                           steps_for(block.depth.vv, 4 * block.depth_budget)});
        }
}

/// The mixed term comes on top of the halves: refine where it does not fit.
void refine(const needs& need, l3d_step_plan& plan) {
    for (int b = 0; b < need.strips(); ++b)
        for (int a = 0; a < need.strips(); ++a) {
            int& nu = plan.nu[static_cast<std::size_t>(a)];
            int& nv = plan.nv[static_cast<std::size_t>(b)];
            while (!need.met(a, b, nu, nv) && nu + nv < 2 * most_steps) {
                // In proportion, so that a far too coarse start needs few rounds.
                int& finer = nu <= nv ? nu : nv;
                finer += 1 + finer / 8;
            }
        }
}

/// Rounding up leaves slack that the other direction can often use.
void coarsen(const needs& need, l3d_step_plan& plan) {
    const auto all_met = [&](int strip, bool along_u) {
        for (int other = 0; other < need.strips(); ++other) {
            const int a = along_u ? strip : other, b = along_u ? other : strip;
            if (!need.met(a, b, plan.nu[static_cast<std::size_t>(a)],
                          plan.nv[static_cast<std::size_t>(b)]))
                return false;
        }
        return true;
    };
    for (int strip = 0; strip < need.strips(); ++strip)
        for (const bool along_u : {true, false}) {
            int& n = (along_u ? plan.nu : plan.nv)[static_cast<std::size_t>(strip)];
            while (n > 1 && n <= most_worth_saving) {
                --n;
                if (!all_met(strip, along_u)) {
                    ++n;
                    break;
                }
            }
        }
}

} // namespace

l3d_step_plan l3d_plan_steps(std::span<const l3d_image_patch> blocks, const l3d_dice_view& view,
                             double budget, l3d_quad_kind kind) {
    const needs need(blocks, view, budget, kind);
    l3d_step_plan plan;
    plan.strips = need.strips();
    start(need, plan);
    if (!plan.visible)
        return plan;
    refine(need, plan);
    coarsen(need, plan);
    for (int b = 0; b < need.strips(); ++b)
        for (int a = 0; a < need.strips(); ++a)
            if (need.at(a, b).visible)
                plan.chord_error = std::max(plan.chord_error,
                                            need.error(a, b, plan.nu[static_cast<std::size_t>(a)],
                                                       plan.nv[static_cast<std::size_t>(b)]));
    return plan;
}
