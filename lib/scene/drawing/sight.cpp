// SPDX-License-Identifier: MIT
// line_of_sight: searches a tree of halves for each piece.
#include "scene/drawing/sight_p.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace l3d_detail {

namespace {

constexpr double flat_enough = 1.0 / 256;

/// Enough halvings to divide a piece by 2^20 both ways, for pieces that cross the near plane.
constexpr int most_halvings = 40;

} // namespace

line_of_sight::line_of_sight(std::span<const image_piece> pieces, const drawing_view& view)
    : pieces_(pieces), view_(view) {
    for (const image_piece& piece : pieces)
        add(piece.net, nullptr, false, false);
}

void line_of_sight::add(bernstein_net net, const node* whole, bool along_u, bool second) {
    node result;
    if (whole != nullptr) {
        result.u0 = whole->u0, result.u1 = whole->u1, result.v0 = whole->v0, result.v1 = whole->v1;
        result.halvings = whole->halvings + 1;
        double& end = along_u ? (second ? result.u0 : result.u1) : (second ? result.v0 : result.v1);
        end = along_u ? (whole->u0 + whole->u1) / 2 : (whole->v0 + whole->v1) / 2;
    }
    const ahead_of_near side = side_of_near(net, view_);
    // A part behind the near plane gets an empty box.
    if (side == ahead_of_near::none)
        result.box = image_bounds{1, 0, 1, 0, 0, 0};
    else if (side == ahead_of_near::all) {
        result.box = bounds_of(net);
        const flat_image flat(net);
        if (flat.error <= flat_enough || result.halvings >= most_halvings)
            result.flat = flat;
    }
    result.net = std::move(net);
    nodes_.push_back(std::move(result));
}

void line_of_sight::split(std::size_t index) {
    bernstein_net net = std::move(nodes_[index].net); // only its halves are asked for from now on
    const node whole = nodes_[index];
    const bool goes_along_u =
        whole.box ? bends_along_u(net) : whole.u1 - whole.u0 >= whole.v1 - whole.v0;
    auto [low, high] = bernstein_net::halves(std::move(net), goes_along_u);
    nodes_[index].halves = nodes_.size();
    add(std::move(low), &whole, goes_along_u, false);
    add(std::move(high), &whole, goes_along_u, true);
}

bool line_of_sight::is_hidden(const image_place& at, std::span<const std::size_t> sides) {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
        const bool is_side = std::ranges::find(sides, i) != sides.end();
        if (hides(i, at, is_side ? least_gap_of_sides : least_gap))
            return true;
    }
    return false;
}

bool line_of_sight::hides(std::size_t piece, const image_place& at, double gap) {
    const double limit = at.z - gap;
    stack_.assign(1, piece);
    while (!stack_.empty()) {
        const std::size_t index = stack_.back();
        stack_.pop_back();
        if (const auto& box = nodes_[index].box) {
            if (at.x < box->left - flat_enough || at.x > box->right + flat_enough ||
                at.y < box->top - flat_enough || at.y > box->bottom + flat_enough ||
                box->near > limit)
                continue;
        } else if (nodes_[index].halvings >= most_halvings)
            continue;
        if (const auto& flat = nodes_[index].flat) {
            const double determinant =
                flat->along_u.x * flat->along_v.y - flat->along_u.y * flat->along_v.x;
            const double dx = at.x - flat->middle.x, dy = at.y - flat->middle.y;
            double s = (dx * flat->along_v.y - dy * flat->along_v.x) / determinant;
            double t = (flat->along_u.x * dy - flat->along_u.y * dx) / determinant;
            if (!(std::isfinite(s) && std::isfinite(t)))
                continue;
            // The nearest place of the parallelogram, as if it were a rectangle.
            s = std::clamp(s + 0.5, 0.0, 1.0);
            t = std::clamp(t + 0.5, 0.0, 1.0);
            const image_place here = flat->at(s, t);
            const node& n = nodes_[index];
            if (std::hypot(here.x - at.x, here.y - at.y) <= flat_enough + flat->error &&
                here.z <= limit &&
                pieces_[piece].contains(n.u0 + (n.u1 - n.u0) * s, n.v0 + (n.v1 - n.v0) * t))
                return true;
            continue;
        }
        if (nodes_[index].halves == 0)
            split(index);
        stack_.push_back(nodes_[index].halves);
        stack_.push_back(nodes_[index].halves + 1);
    }
    return false;
}

} // namespace l3d_detail
