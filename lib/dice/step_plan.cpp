// SPDX-License-Identifier: MIT
// Choosing integer steps per strip.
#include "dice/step_plan.h"

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
    if (in_front) {
        const l3d_image_box hull = l3d_image_box_of(block.points);
        box = box.intersected(needs.balanced ? hull.grown(view.tolerance) : hull);
    }
    if (box.empty())
        return;
    needs.visible = true;
    const l3d_second_bounds image = l3d_second_bounds_of(block, box, view.drawn_w(least));
    needs.uu[i] = image.uu;
    needs.uv[i] = image.uv;
    needs.vv[i] = image.vv;
    // |D2 w| times half the box's diagonal is part of the image bound: in a box with a half
    // diagonal of 8 budgets, w is off by an eighth at most where the image is within budget, if
    // both count h^2 / 8. Width and height together are at most sqrt(2) diagonals.
    constexpr double two_root_two = 2.8284271247461903;
    const double enough = needs.balanced ? 1 / l3d_balance : 8;
    if (!in_front || box.width() + box.height() < enough * two_root_two * budget) {
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

/// Third and fourth derivatives of a net, as its quarters' steps see them.
void add_mixed(l3d_block_needs& needs, const l3d_image_patch& net, const l3d_dice_view& view) {
    const l3d_image_box box =
        view.margin().intersected(l3d_image_box_of(net.points).grown(view.tolerance));
    if (box.empty())
        return;
    const l3d_mixed_bounds mixed =
        l3d_mixed_bounds_of(net, box, l3d_depth_range_of(net.points).least);
    needs.uuv = mixed.uuv / 64;
    needs.uvv = mixed.uvv / 64;
    needs.uuvv = mixed.uuvv / 256;
}

/// Steps along one direction of one strip, and what follows from them.
struct strip_steps {
    int n = 1, fewest = 1;
    double step = 1;  ///< h
    double bend = 1;  ///< what multiplies a second derivative
    double moved = 0; ///< how much of it vertices are moved by

    void set(int steps, bool balanced) {
        n = steps;
        step = 1.0 / n;
        moved = balanced && n > 1 ? l3d_balance * step * step : 0;
        bend = moved > 0 ? moved : step * step / 8;
    }
};

/// The steps while they are chosen, and what is asked of them.
class planner {
public:
    planner(const l3d_block_needs& needs, double budget, l3d_quad_kind kind)
        : needs_(needs), strips_(static_cast<std::size_t>(needs.strips)), budget_(budget),
          mixed_(kind == l3d_quad_kind::whole ? 1.0 / 16 : 1.0 / 4) {}

    /// Half the budget to each direction: the product of the steps is then least.
    void start() {
        start_along(needs_.uu, needs_.depth_uu, needs_.least_u, along_u_,
                    [this](std::size_t strip, std::size_t k) { return strips_ * k + strip; });
        start_along(needs_.vv, needs_.depth_vv, needs_.least_v, along_v_,
                    [this](std::size_t strip, std::size_t k) { return strips_ * strip + k; });
    }

    /// The mixed terms come on top of the halves: refine where they do not fit. More steps are
    /// never worse, but for two after one, which is not balanced: then all is looked at once more.
    void refine() {
        for (bool settled = false; !settled;) {
            settled = true;
            for (std::size_t b = 0; b < strips_; ++b)
                for (std::size_t a = 0; a < strips_; ++a)
                    settled &= refine_block(a, b);
        }
    }

    /// Rounding up leaves slack that the other direction can often use.
    void coarsen() {
        for (std::size_t strip = 0; strip < strips_; ++strip) {
            coarsen_along(along_u_[strip], [&] {
                bool all = true;
                for (std::size_t b = 0; b < strips_; ++b)
                    all &= met(strip, b);
                return all;
            });
            coarsen_along(along_v_[strip], [&] {
                bool all = true;
                for (std::size_t a = 0; a < strips_; ++a)
                    all &= met(a, strip);
                return all;
            });
        }
    }

    l3d_step_plan finished() const {
        l3d_step_plan plan;
        plan.strips = needs_.strips;
        plan.visible = needs_.visible;
        plan.balanced = needs_.balanced;
        for (std::size_t b = 0; b < strips_; ++b) {
            plan.nu[b] = along_u_[b].n;
            plan.nv[b] = along_v_[b].n;
            for (std::size_t a = 0; a < strips_; ++a)
                plan.chord_error =
                    std::max({plan.chord_error, image_error(a, b), slit_error(a, b)});
        }
        return plan;
    }

private:
    using strips_along = std::array<strip_steps, l3d_step_plan::most_strips>;

    /// Returns whether it was fine enough already.
    bool refine_block(std::size_t a, std::size_t b) {
        bool settled = true;
        while (!met(a, b) && along_u_[a].n + along_v_[b].n < 2 * most_steps) {
            // In proportion, so that a far too coarse start needs few rounds.
            strip_steps& finer = along_u_[a].n <= along_v_[b].n ? along_u_[a] : along_v_[b];
            finer.set(finer.n + 1 + finer.n / 8, needs_.balanced);
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

    template <class BlockAt>
    void start_along(const l3d_block_needs::per_block& image,
                     const l3d_block_needs::per_block& depth,
                     const l3d_block_needs::per_block& least, strips_along& along,
                     BlockAt block_at) const {
        const double per_image = 1 / (4 * budget_);
        for (std::size_t strip = 0; strip < strips_; ++strip) {
            double in_image = 0, in_depth = 0, least_here = 0;
            for (std::size_t k = 0; k < strips_; ++k) {
                const std::size_t i = block_at(strip, k);
                in_image = std::max(in_image, image[i] * per_image);
                in_depth = std::max(in_depth, depth[i] / 4);
                least_here = std::max(least_here, least[i]);
            }
            strip_steps& here = along[strip];
            here.fewest = rounded_up(least_here);
            here.set(std::max({here.fewest, steps_for(in_image), rounded_up(std::sqrt(in_depth))}),
                     needs_.balanced);
        }
    }

    template <class AllMet> void coarsen_along(strip_steps& strip, AllMet all_met) const {
        while (strip.n > strip.fewest && strip.n <= most_worth_saving) {
            const strip_steps before = strip;
            strip.set(strip.n - 1, needs_.balanced);
            if (!all_met()) {
                strip = before;
                break;
            }
        }
    }

    double image_error(std::size_t a, std::size_t b) const {
        const std::size_t i = strips_ * b + a;
        if (needs_.uu[i] + needs_.uv[i] + needs_.vv[i] == 0)
            return 0; // not visible, or flat
        const strip_steps &u = along_u_[a], &v = along_v_[b];
        const double both = u.moved * v.moved * needs_.uuvv;
        const double twist = needs_.uv[i] * u.step * v.step +
                             2 * (u.moved * v.step * needs_.uuv + v.moved * u.step * needs_.uvv) +
                             4 * both;
        return needs_.uu[i] * u.bend + needs_.vv[i] * v.bend + both + twist * mixed_;
    }

    /// Of w, in budgets. Balanced or not: with n >= 2, uuvv <= 24 min(uu, vv), uuv <= 6 uu and uvv
    /// <= 6 vv, all that balance adds is within the 1/8 that it saves from.
    double depth_error(std::size_t a, std::size_t b) const {
        const std::size_t i = strips_ * b + a;
        const double hu = along_u_[a].step, hv = along_v_[b].step;
        return (needs_.depth_uu[i] * hu * hu + needs_.depth_vv[i] * hv * hv) / 8 +
               needs_.depth_uv[i] * hu * hv * mixed_;
    }

    /// Of the slits along the piece's sides, where the block lies at one.
    double slit_error(std::size_t a, std::size_t b) const {
        if (!needs_.balanced)
            return 0; // no more than that of the quads
        const std::size_t i = strips_ * b + a;
        const double hu = along_u_[a].step, hv = along_v_[b].step;
        const double along_u = b == 0 || b + 1 == strips_ ? needs_.uu[i] * hu * hu : 0;
        const double along_v = a == 0 || a + 1 == strips_ ? needs_.vv[i] * hv * hv : 0;
        return std::max(along_u, along_v) / 8;
    }

    bool met(std::size_t a, std::size_t b) const {
        return image_error(a, b) <= budget_ && slit_error(a, b) <= budget_ &&
               (!needs_.keeps_depth || depth_error(a, b) <= 1);
    }

    const l3d_block_needs& needs_;
    std::size_t strips_;
    double budget_, mixed_;
    strips_along along_u_, along_v_;
};

} // namespace

l3d_block_needs l3d_needs_of(const l3d_image_patch& net, std::span<const l3d_image_patch> blocks,
                             const l3d_dice_view& view, double budget, l3d_quad_kind kind) {
    l3d_block_needs needs;
    needs.strips = blocks.size() == 1 ? 1 : l3d_block_needs::most_strips;
    needs.balanced = needs.strips > 1 && kind == l3d_quad_kind::whole;
    if (needs.balanced)
        add_mixed(needs, net, view);
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
