// SPDX-License-Identifier: MIT
// Drawn points against exact ones.
#include "certificate.h"

#include <algorithm>
#include <cmath>

namespace dice_tests {
namespace {

std::array<double, 4> bernstein(double t) {
    const double s = 1 - t;
    return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

} // namespace

reference::hpoint value_of(const reference::net& net, double u, double v) {
    const auto a = bernstein(u), b = bernstein(v);
    reference::hpoint result;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) {
            const reference::hpoint& p = net.points[4 * r + c];
            const double weight = a[c] * b[r];
            result.x += weight * p.x;
            result.y += weight * p.y;
            result.w += weight * p.w;
        }
    return result;
}

void certificate::sample(const drawn_point& at) {
    const reference::hpoint exact = value_of(net_, at.u, at.v);
    const double measured = std::hypot(exact.x / exact.w - at.x, exact.y / exact.w - at.y);
    ++samples;
    sum += measured;
    largest = std::max(largest, measured);
    // !(<=), so that a distance which is no number is a violation too.
    // Where no bound is given, nothing was promised.
    const bool kept = std::isinf(bound_) || (measured <= bound_ && exact.w > 0);
    violations += !kept;
    const double ratio = kept ? measured / bound_ : std::max(1.0, measured / bound_);
    if (ratio > worst_ratio || (!kept && !(worst_ratio >= 1))) {
        worst_ratio = ratio;
        worst_u = at.u;
        worst_v = at.v;
        worst_measured = measured;
        worst_bound = bound_;
        worst_is_grid = grid_;
    }
}

void certificate::draw(std::span<const l3d_diced_piece> pieces, double frame_bound) {
    const drawn_points points(size_, every_, frame_.parallel);
    const auto judge = [&](const drawn_point& at) { sample(at); };
    for (const l3d_diced_piece& piece : pieces) {
        largest_promise = std::max({largest_promise, piece.bound, frame_bound});
        bound_ = piece.bound;
        grid_ = true;
        points.of_grid(piece, judge);
        bound_ = frame_bound;
        grid_ = false;
        points.of_triangles(piece, judge);
    }
}

} // namespace dice_tests
