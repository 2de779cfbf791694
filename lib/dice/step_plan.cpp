// SPDX-License-Identifier: MIT
// Finds what a piece's blocks need of its steps, one block after the other.
#include "dice/step_plan.h"

#include "geom/trims/trim_region.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace {

void add_need(l3d_block_needs& needs, std::size_t i, const l3d_image_patch& block,
              const l3d_dice_view& view, double budget, l3d_quad_kind kind) {
    if (view.section.cuts_off(block.points) ||
        l3d_outside(block.points, view.margin(), view.near, view.far))
        return;
    const double least = l3d_depth_range_of(block.points).least;
    const bool in_front = least > view.near;
    l3d_image_box box = view.margin();
    if (in_front) {
        const l3d_image_box hull = l3d_image_box_of(block.points);
        box = box.intersected(needs.balanced ? hull.grown(view.most_moved()) : hull);
    }
    if (box.empty())
        return;
    needs.visible = true;
    const l3d_second_bounds image = l3d_second_bounds_of(block, box, view.drawn_w(least));
    needs.least_w[i] = view.drawn_w(least);
    needs.uu[i] = image.uu;
    needs.uv[i] = image.uv;
    needs.vv[i] = image.vv;
    // |D2 w| times half the box's diagonal is part of the image bound. In a box with a half
    // diagonal of 8 budgets or more, the image bound therefore keeps w, too. Both count h^2 / 8, so
    // w is off by an eighth at most where the image is within its budget. Width and height together
    // are at most sqrt(2) diagonals.
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
    if (kind != l3d_quad_kind::triangles) {
        // A cubic moves by at most three times the widest gap of its control polygon.
        const auto [along_u, along_v] = l3d_image_gaps_of(block);
        needs.least_u[i] = 3 / l3d_largest_quad * along_u;
        needs.least_v[i] = 3 / l3d_largest_quad * along_v;
    }
}

/// Sets the bounds of mixed third and fourth derivatives of a net, by the parameters of its
/// quarters.
void add_mixed(l3d_block_needs& needs, const l3d_image_net& net, const l3d_dice_view& view) {
    const l3d_image_box box = view.margin().intersected(net.box().grown(view.most_moved()));
    if (box.empty())
        return;
    const l3d_mixed_bounds mixed = l3d_mixed_bounds_of(net, box, net.w().least);
    needs.uuv = mixed.uuv / 64;
    needs.uvv = mixed.uvv / 64;
    needs.uuvv = mixed.uuvv / 256;
}

bool is_large(const l3d_image_box& hull) {
    return !(hull.width() < l3d_largest_one_block && hull.height() < l3d_largest_one_block);
}

/// Finds the largest of some differences of control points, as seen from the eye.
class largest_bend {
public:
    largest_bend(const l3d_image_box& hull, double focal)
        : x_((hull.left + hull.right) / 2), y_((hull.top + hull.bottom) / 2), focal_(focal) {}

    /// Takes a second difference of x, y and w. If focal is not 0, a length along the line of sight
    /// counts like a length across it.
    void take(double x, double y, double w) {
        const double dx = x - x_ * w, dy = y - y_ * w, dw = focal_ * w;
        square_ = std::max(square_, dx * dx + dy * dy + dw * dw);
    }
    void take(const l3d_image_point& a, const l3d_image_point& b, const l3d_image_point& c) {
        take(a[0] + c[0] - 2 * b[0], a[1] + c[1] - 2 * b[1], a[2] + c[2] - 2 * b[2]);
    }
    double size() const { return std::sqrt(square_); }

private:
    double x_, y_, focal_, square_ = 0;
};

/// The budget of chords in a view. It is smaller with smooth edges, whose outlines need finer
/// steps.
double budget_of(const l3d_dice_view& view) {
    return view.chord_budget(0) / view.finer_outlines();
}

constexpr double steps_squared = l3d_most_steps_of_one_block * l3d_most_steps_of_one_block;

} // namespace

/// Estimates the error of three steps. Second derivatives are 6 times second differences along u
/// and v, and 9 times mixed differences. A quad errs by an eighth of the derivatives along u and
/// along v and a sixteenth of the mixed one, see l3d_plan_steps.
bool l3d_is_one_block(const l3d_image_patch& net, const l3d_image_box& hull,
                      const l3d_dice_view& view) {
    if (l3d_is_small(hull))
        return true;
    if (is_large(hull))
        return false;
    const l3d_net_bends bends = l3d_bends_of(net, hull, view.focal);
    const double error = 6.0 / 8 * (bends.uu + bends.vv) + 9.0 / 16 * bends.uv;
    return error <= steps_squared * bends.least_w * budget_of(view);
}

/// The estimated error is compared with half of the budget, since an edge gets as much as each
/// direction of a quad.
bool l3d_is_one_strip(const l3d_image_curve& edge, const l3d_image_box& hull,
                      const l3d_dice_view& view) {
    if (l3d_is_small(hull))
        return true;
    if (is_large(hull))
        return false;
    const auto& p = edge.points;
    largest_bend bend(hull, view.focal);
    bend.take(p[0], p[1], p[2]);
    bend.take(p[1], p[2], p[3]);
    const double least_w = std::min({p[0][2], p[1][2], p[2][2], p[3][2]});
    return 6.0 / 8 * bend.size() <= steps_squared * least_w * budget_of(view) / 2;
}

l3d_quad_kind l3d_whole_kind(const l3d_dice_view& view) {
    return view.trim == nullptr || view.trim->is_all_of({}) ? l3d_quad_kind::whole
                                                            : l3d_quad_kind::trimmed;
}

l3d_block_needs l3d_needs_of(const l3d_image_net& net, std::span<const l3d_image_patch> blocks,
                             const l3d_dice_view& view, double budget, l3d_quad_kind kind) {
    l3d_block_needs needs;
    needs.strips = blocks.size() == 1 ? 1 : l3d_block_needs::most_strips;
    needs.balanced = needs.strips > 1 && kind != l3d_quad_kind::triangles;
    if (needs.balanced)
        add_mixed(needs, net, view);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        add_need(needs, i, blocks[i], view, budget, kind);
    return needs;
}

/// Marks the blocks that outlines may cross. A piece is made by halving the patch, so all
/// parameters here are exact.
void l3d_ask_for_outlines(const l3d_patch_part& piece, const l3d_dice_view& view,
                          l3d_block_needs& needs) {
    needs.finer_outlines = view.finer_outlines();
    needs.folds = 0;
    if (view.folds == 0)
        return;
    constexpr unsigned across = 4; // blocks of a patch along either direction
    const auto strips = static_cast<std::size_t>(needs.strips);
    // Finds, as bits, the patch's blocks along a direction into which block i of the piece reaches.
    const auto reached = [&](double low, double high, std::size_t i) {
        const double size = across * (high - low) / needs.strips;
        const double from = across * low + size * static_cast<double>(i);
        unsigned bits = 0;
        for (unsigned k = 0; k < across; ++k)
            if (k < from + size && k + 1 > from)
                bits |= 1U << k;
        return bits;
    };
    for (std::size_t row = 0; row < strips; ++row) {
        const unsigned rows = reached(piece.v0, piece.v1, row);
        unsigned in_rows = 0;
        for (unsigned r = 0; r < across; ++r)
            if ((rows >> r & 1) != 0)
                in_rows |= view.folds >> across * r;
        for (std::size_t column = 0; column < strips; ++column)
            if ((in_rows & reached(piece.u0, piece.u1, column)) != 0)
                needs.folds |= 1U << (strips * row + column);
    }
}
