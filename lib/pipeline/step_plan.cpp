// SPDX-License-Identifier: MIT
// Choosing integer steps per strip.
#include "pipeline/step_plan.h"

#include <cmath>

namespace {

/// Keeps hopeless cases finite, and tells even there which direction needs more steps.
constexpr int most_steps = 1 << 28;

/// Pieces with more steps than this are cut anyway, and are many when it comes to that.
constexpr int most_worth_saving = 64;

/// Largest number of pixels between neighbouring control points' projections, along u and v.
std::array<double, 2> largest_gaps(const l3d_image_patch& block) {
    std::array<l3d_vector<double, 2>, 16> p;
    for (std::size_t i = 0; i < 16; ++i)
        p[i] = {block.points[i][0] / block.points[i][2], block.points[i][1] / block.points[i][2]};
    std::array<double, 2> gaps{};
    const auto take = [&](std::size_t direction, std::size_t i, std::size_t j) {
        gaps[direction] =
            std::max({gaps[direction], std::abs(p[i][0] - p[j][0]), std::abs(p[i][1] - p[j][1])});
    };
    for (std::size_t line = 0; line < 4; ++line)
        for (std::size_t i = 0; i < 3; ++i) {
            take(0, 4 * line + i, 4 * line + i + 1);
            take(1, 4 * i + line, 4 * i + 4 + line);
        }
    return gaps;
}

void add_need(l3d_block_needs& needs, std::size_t i, const l3d_image_patch& block,
              const l3d_dice_view& view, double budget, l3d_quad_kind kind) {
    if (l3d_outside(block.points, view.margin(), view.near, view.far))
        return;
    const double least = l3d_depth_range_of(block.points).least;
    const bool in_front = least > view.near;
    l3d_image_box box = view.margin();
    if (in_front)
        box = box.intersected(l3d_image_box_of(block.points));
    if (box.empty())
        return;
    needs.visible = true;
    const l3d_second_bounds image = l3d_second_bounds_of(block, box, view.drawn_w(least));
    needs.uu[i] = image.uu;
    needs.uv[i] = image.uv;
    needs.vv[i] = image.vv;
    // |D2 w| times half the box's diagonal is part of the image bound: in a box with a half
    // diagonal of 8 budgets, w is off by an eighth at most where the image is within budget.
    // Width and height together are at most sqrt(2) diagonals.
    constexpr double two_root_two = 2.8284271247461903;
    if (!in_front || box.width() + box.height() < 8 * two_root_two * budget) {
        const l3d_second_bounds depth = l3d_depth_bounds_of(block);
        const double scale = 1 / view.depth_budget(least);
        needs.keeps_depth = true;
        needs.depth_uu[i] = depth.uu * scale;
        needs.depth_uv[i] = depth.uv * scale;
        needs.depth_vv[i] = depth.vv * scale;
    }
    if (kind == l3d_quad_kind::whole) {
        // A cubic moves by at most three gaps of its control polygon.
        const auto [along_u, along_v] = largest_gaps(block);
        needs.least_u[i] = 3 / l3d_largest_quad * along_u;
        needs.least_v[i] = 3 / l3d_largest_quad * along_v;
    }
}

/// The steps while they are chosen, and what is asked of them.
class planner {
public:
    planner(const l3d_block_needs& needs, double budget, l3d_quad_kind kind)
        : needs_(needs), strips_(static_cast<std::size_t>(needs.strips)), budget_(budget),
          mixed_(kind == l3d_quad_kind::whole ? 1.0 / 16 : 1.0 / 4) {
        plan_.strips = needs.strips;
        plan_.visible = needs.visible;
    }

    /// Half the budget to each direction: the product of the steps is then least.
    void start() {
        start_along(needs_.uu, needs_.depth_uu, needs_.least_u, plan_.nu, least_u_, step_u_,
                    [this](std::size_t strip, std::size_t k) { return strips_ * k + strip; });
        start_along(needs_.vv, needs_.depth_vv, needs_.least_v, plan_.nv, least_v_, step_v_,
                    [this](std::size_t strip, std::size_t k) { return strips_ * strip + k; });
    }

    /// The mixed term comes on top of the halves: refine where it does not fit.
    void refine() {
        for (std::size_t b = 0; b < strips_; ++b)
            for (std::size_t a = 0; a < strips_; ++a)
                while (!met(a, b) && plan_.nu[a] + plan_.nv[b] < 2 * most_steps) {
                    // In proportion, so that a far too coarse start needs few rounds.
                    const bool along_u = plan_.nu[a] <= plan_.nv[b];
                    int& finer = along_u ? plan_.nu[a] : plan_.nv[b];
                    finer += 1 + finer / 8;
                    (along_u ? step_u_[a] : step_v_[b]) = 1.0 / finer;
                }
    }

    /// Rounding up leaves slack that the other direction can often use.
    void coarsen() {
        for (std::size_t strip = 0; strip < strips_; ++strip) {
            coarsen_along(plan_.nu[strip], least_u_[strip], step_u_[strip], [&] {
                bool all = true;
                for (std::size_t b = 0; b < strips_; ++b)
                    all &= met(strip, b);
                return all;
            });
            coarsen_along(plan_.nv[strip], least_v_[strip], step_v_[strip], [&] {
                bool all = true;
                for (std::size_t a = 0; a < strips_; ++a)
                    all &= met(a, strip);
                return all;
            });
        }
    }

    l3d_step_plan finished() {
        for (std::size_t b = 0; b < strips_; ++b)
            for (std::size_t a = 0; a < strips_; ++a)
                plan_.chord_error = std::max(plan_.chord_error, image_error(a, b));
        return plan_;
    }

private:
    using per_strip = std::array<double, l3d_step_plan::most_strips>;

    /// Steps between 1 and most_steps.
    static int rounded_up(double steps) {
        const double n = std::ceil(steps);
        return n < most_steps ? std::max(1, static_cast<int>(n)) : most_steps;
    }

    template <class BlockAt>
    void start_along(const l3d_block_needs::per_block& image,
                     const l3d_block_needs::per_block& depth,
                     const l3d_block_needs::per_block& least, std::array<int, 4>& steps,
                     std::array<int, 4>& fewest, per_strip& step, BlockAt block_at) const {
        const double per_image = 1 / (4 * budget_);
        for (std::size_t strip = 0; strip < strips_; ++strip) {
            double squared = 0, least_here = 0;
            for (std::size_t k = 0; k < strips_; ++k) {
                const std::size_t i = block_at(strip, k);
                squared = std::max({squared, image[i] * per_image, depth[i] / 4});
                least_here = std::max(least_here, least[i]);
            }
            fewest[strip] = rounded_up(least_here);
            steps[strip] = std::max(fewest[strip], rounded_up(std::sqrt(squared)));
            step[strip] = 1.0 / steps[strip];
        }
    }

    template <class AllMet>
    static void coarsen_along(int& n, int fewest, double& step, AllMet all_met) {
        while (n > fewest && n <= most_worth_saving) {
            const double before = step;
            step = 1.0 / (n - 1);
            if (!all_met()) {
                step = before;
                break;
            }
            --n;
        }
    }

    double error(const l3d_block_needs::per_block& uu, const l3d_block_needs::per_block& uv,
                 const l3d_block_needs::per_block& vv, std::size_t a, std::size_t b) const {
        const std::size_t i = strips_ * b + a;
        const double hu = step_u_[a], hv = step_v_[b];
        return (uu[i] * hu * hu + vv[i] * hv * hv) / 8 + uv[i] * hu * hv * mixed_;
    }

    double image_error(std::size_t a, std::size_t b) const {
        return error(needs_.uu, needs_.uv, needs_.vv, a, b);
    }

    bool met(std::size_t a, std::size_t b) const {
        return image_error(a, b) <= budget_ &&
               (!needs_.keeps_depth ||
                error(needs_.depth_uu, needs_.depth_uv, needs_.depth_vv, a, b) <= 1);
    }

    const l3d_block_needs& needs_;
    std::size_t strips_;
    double budget_, mixed_;
    l3d_step_plan plan_;
    std::array<int, 4> least_u_{}, least_v_{};
    per_strip step_u_{}, step_v_{}; ///< 1 / nu, 1 / nv
};

} // namespace

l3d_block_needs l3d_needs_of(std::span<const l3d_image_patch> blocks, const l3d_dice_view& view,
                             double budget, l3d_quad_kind kind) {
    l3d_block_needs needs;
    needs.strips = blocks.size() == 1 ? 1 : l3d_block_needs::most_strips;
    for (std::size_t i = 0; i < blocks.size(); ++i)
        add_need(needs, i, blocks[i], view, budget, kind);
    return needs;
}

l3d_step_plan l3d_plan_steps(const l3d_block_needs& needs, double budget, l3d_quad_kind kind) {
    planner plan(needs, budget, kind);
    if (needs.visible) {
        plan.start();
        plan.refine();
        plan.coarsen();
    }
    return plan.finished();
}
