// SPDX-License-Identifier: MIT
// contours_of: halves pieces until each part has one arc, and joins arcs to lines.
#include "scene/drawing/contours_p.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace l3d_detail {

namespace {

/// Bound of the relative rounding that all halvings of a net add. Each halving adds less than 2^-53
/// for each degree; at most 48 halvings of degree 44 are made.
constexpr double relative_rounding = 0x1p-41;

/// Enough halvings to divide a piece by 2^24 both ways.
constexpr int most_halvings = 48;

/// A rectangle of a piece's parameters, with the nets of surface and contour over it. The search
/// for contours halves cells.
struct cell {
    bernstein_net net, contour;
    double u0 = 0, u1 = 1, v0 = 0, v1 = 1;
    int halvings = 0;

    /// Expects: the cell's own nets are not used afterwards.
    std::pair<cell, cell> halves(bool along_u) {
        auto nets = bernstein_net::halves(std::move(net), along_u);
        auto contours = bernstein_net::halves(std::move(contour), along_u);
        std::pair<cell, cell> result{
            {std::move(nets.first), std::move(contours.first), u0, u1, v0, v1},
            {std::move(nets.second), std::move(contours.second), u0, u1, v0, v1}};
        auto& [low, high] = result;
        (along_u ? low.u1 : low.v1) = (along_u ? high.u0 : high.v0) =
            along_u ? (u0 + u1) / 2 : (v0 + v1) / 2;
        low.halvings = high.halvings = halvings + 1;
        return result;
    }
    /// The parameters of corner k, in the order in which one walks round the cell.
    std::array<double, 2> corner(std::size_t k) const {
        return {k == 1 || k == 2 ? u1 : u0, k >= 2 ? v1 : v0};
    }
};

/// An end of an arc of a contour, where the arc crosses a line of equal u (axis 0) or equal v (axis
/// 1).
struct arc_end {
    surface_vertex there;
    int axis = 0;

    double line() const { return axis == 0 ? there.u : there.v; }
    double along() const { return axis == 0 ? there.v : there.u; }
    bool is_on_boundary() const { return line() == 0 || line() == 1; }
};

using arc = std::array<arc_end, 2>;

/// The coefficients of the contour's polynomial along an edge of a cell, in the order of a walk
/// round the cell.
struct edge_values {
    std::array<double, bernstein_net::most_degree + 1> c;
    std::size_t degree;

    edge_values(const bernstein_net& f, std::size_t k, int dim)
        : degree(static_cast<std::size_t>(k % 2 == 0 ? f.m : f.n)) {
        for (std::size_t i = 0; i <= degree; ++i) {
            const int at = static_cast<int>(k < 2 ? i : degree - i);
            c[i] = (k % 2 == 0 ? f.at(k == 0 ? 0 : f.n, at) : f.at(at, k == 1 ? f.m : 0))[dim];
        }
    }

    int sign_changes() const {
        int result = 0;
        for (std::size_t i = 1; i <= degree; ++i)
            result += (c[i - 1] >= 0) != (c[i] >= 0);
        return result;
    }
    double at(double t) const {
        std::array<double, bernstein_net::most_degree + 1> p;
        std::copy_n(c.begin(), degree + 1, p.begin());
        for (std::size_t left = degree; left > 0; --left)
            for (std::size_t i = 0; i < left; ++i)
                p[i] += (p[i + 1] - p[i]) * t;
        return p[0];
    }
    /// A zero between ends of different signs, by the Illinois variant of false position.
    double zero() const;
};

double edge_values::zero() const {
    double low = 0, high = 1, at_low = c[0], at_high = c[degree];
    if ((at_low >= 0) == (at_high >= 0)) // rounding alone gave the corners other signs
        return std::abs(at_low) < std::abs(at_high) ? 0 : 1;
    constexpr int most_steps = 60;
    constexpr double small = 0x1p-46; // a share of the edge, and of the values along it
    const double range = std::abs(at_high - at_low);
    int side = 0;
    double t = 0.5;
    for (int i = 0; i < most_steps && high - low > small; ++i) {
        t = (at_high * low - at_low * high) / (at_high - at_low);
        if (!(t > low && t < high))
            t = (low + high) / 2;
        const double value = at(t);
        if (std::abs(value) < small * range)
            break;
        const bool is_low = (value >= 0) == (at_low >= 0);
        (is_low ? low : high) = t;
        (is_low ? at_low : at_high) = value;
        if (side == (is_low ? -1 : 1)) // the other end has stayed for two steps
            (is_low ? at_high : at_low) /= 2;
        side = is_low ? -1 : 1;
    }
    return t;
}

bool has_one_sign(const bernstein_net& f) {
    const bool first = f.c[0] >= 0;
    return std::ranges::all_of(f.c, [&](double value) { return (value >= 0) == first; });
}

/// Whether a polynomial certainly grows, or falls, along u or along v.
bool is_monotone(const bernstein_net& f, bool along_u) {
    bool rises = true, falls = true;
    for (int r = 0; r <= f.n - (along_u ? 0 : 1); ++r)
        for (int k = 0; k <= f.m - (along_u ? 1 : 0); ++k) {
            const double step = *(along_u ? f.at(r, k + 1) : f.at(r + 1, k)) - *f.at(r, k);
            rises = rises && step > 0;
            falls = falls && step < 0;
            if (!rises && !falls)
                return false;
        }
    return true;
}

class contour_search {
public:
    contour_search(const image_piece& piece, std::size_t number, const drawing_view& view,
                   double tolerance)
        : piece_(piece), number_(number), view_(view), tolerance_(tolerance) {
        for (const double value : piece.contour.c)
            rounding_ = std::max(rounding_, std::abs(value) * relative_rounding);
        search({piece.net, piece.contour});
    }

    std::vector<surface_line> lines();

private:
    void search(cell of);
    bool settle(const cell& of);
    void add_by_signs(const cell& of);
    arc_end crossing(const cell& of, std::size_t edge) const;
    double bound_of(const cell& of, const flat_image& flat, const arc& by) const;
    std::array<bool, 4> signs_of(const cell& of) const;

    const image_piece& piece_;
    std::size_t number_;
    const drawing_view& view_;
    double tolerance_;
    double rounding_ = 0; ///< bound of the rounding of the polynomial's values
    std::vector<arc> arcs_;
};

/// The signs of the contour's polynomial at the corners. All cells with a common corner agree on
/// its sign. If rounding may change the sign, the value is computed from the whole piece.
std::array<bool, 4> contour_search::signs_of(const cell& of) const {
    const bernstein_net& f = of.contour;
    const std::array<double, 4> values{*f.at(0, 0), *f.at(0, f.m), *f.at(f.n, f.m), *f.at(f.n, 0)};
    std::array<bool, 4> result{};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto [u, v] = of.corner(k);
        const bool is_sure = std::abs(values[k]) > rounding_;
        result[k] = (is_sure ? values[k] : piece_.contour.evaluate(u, v).value[0]) >= 0;
    }
    return result;
}

void contour_search::search(cell of) {
    if (has_one_sign(of.contour) || is_beside(of.net, view_))
        return;
    const ahead_of_near side = side_of_near(of.net, view_);
    if (side == ahead_of_near::none)
        return;
    const bool is_ahead = side == ahead_of_near::all;
    if (is_ahead && settle(of))
        return;
    if (of.halvings >= most_halvings) {
        if (is_ahead)
            add_by_signs(of);
        return;
    }
    auto halves = of.halves(is_ahead ? bends_along_u(of.net) : of.u1 - of.u0 >= of.v1 - of.v0);
    search(std::move(halves.first));
    search(std::move(halves.second));
}

/// Adds the contour's arc in a cell if it is known well enough. Returns whether the cell is done.
bool contour_search::settle(const cell& of) {
    const flat_image flat(of.net);
    if (flat.error > tolerance_)
        return false;
    if (flat.reach() <= tolerance_) {
        add_by_signs(of);
        return true;
    }
    // The contour may meet each line along u, or each line along v, at most once. So there is no
    // closed contour.
    if (!is_monotone(of.contour, true) && !is_monotone(of.contour, false))
        return false;
    const std::array<bool, 4> signs = signs_of(of);
    std::array<std::size_t, 4> crossed{};
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        const bool is_crossed = signs[k] != signs[(k + 1) % 4];
        if (edge_values(of.contour, k, 0).sign_changes() > (is_crossed ? 1 : 0))
            return false;
        if (is_crossed)
            crossed[count++] = k;
    }
    if (count == 0)
        return true;
    if (count != 2)
        return false;
    const arc one{crossing(of, crossed[0]), crossing(of, crossed[1])};
    if (!(bound_of(of, flat, one) <= tolerance_))
        return false;
    arcs_.push_back(one);
    return true;
}

/// A bound of the distance between an arc in a cell and its chord, in the picture. The contour's
/// polynomial is linear except for `off`. So the arc lies in a strip of the cell, and the corners
/// of this strip are no farther from the chord than the bound.
double contour_search::bound_of(const cell& of, const flat_image& flat, const arc& by) const {
    const bernstein_net& f = of.contour;
    const double f00 = *f.at(0, 0), f01 = *f.at(0, f.m), f10 = *f.at(f.n, 0), f11 = *f.at(f.n, f.m);
    const double middle = (f00 + f01 + f10 + f11) / 4;
    const double in_s = (f01 - f00 + f11 - f10) / 2, in_t = (f10 - f00 + f11 - f01) / 2;
    const auto linear = [&](double s, double t) {
        return middle + in_s * (s - 0.5) + in_t * (t - 0.5);
    };
    double off = 0;
    for (int r = 0; r <= f.n; ++r)
        for (int k = 0; k <= f.m; ++k)
            off = std::max(off, std::abs(*f.at(r, k) - linear(double(k) / f.m, double(r) / f.n)));
    double most = 0;
    const auto take = [&](double s, double t) {
        most = std::max(most, distance_from(flat.at(s, t), by[0].there.at, by[1].there.at));
    };
    constexpr std::array<std::array<double, 2>, 5> around{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    for (std::size_t k = 0; k < 4; ++k) {
        const auto &a = around[k], &b = around[k + 1];
        const double at_a = linear(a[0], a[1]), at_b = linear(b[0], b[1]);
        if (std::abs(at_a) <= off)
            take(a[0], a[1]);
        for (const double level : {-off, off})
            if ((at_a - level) * (at_b - level) < 0) {
                const double t = (level - at_a) / (at_b - at_a);
                take(a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1]));
            }
    }
    return most + flat.error;
}

arc_end contour_search::crossing(const cell& of, std::size_t edge) const {
    const double t = edge_values(of.contour, edge, 0).zero();
    const auto [u0, v0] = of.corner(edge);
    const auto [u1, v1] = of.corner((edge + 1) % 4);
    arc_end end;
    end.axis = edge % 2 == 0 ? 1 : 0;
    end.there = {.piece = number_, .u = u0 + (u1 - u0) * t, .v = v0 + (v1 - v0) * t};
    std::array<double, 4> p{};
    for (int k = 0; k < 4; ++k)
        p[static_cast<std::size_t>(k)] = edge_values(of.net, edge, k).at(t);
    end.there.at = {p[0] / p[2], p[1] / p[2], p[3] / p[2]};
    return end;
}

/// Adds the arcs that the signs at the corners imply, for a cell that is small in the picture.
void contour_search::add_by_signs(const cell& of) {
    const std::array<bool, 4> signs = signs_of(of);
    std::vector<arc_end> ends;
    for (std::size_t k = 0; k < 4; ++k)
        if (signs[k] != signs[(k + 1) % 4])
            ends.push_back(crossing(of, k));
    if (ends.size() == 4) {
        const bool middle =
            piece_.contour.evaluate((of.u0 + of.u1) / 2, (of.v0 + of.v1) / 2).value[0] >= 0;
        // Edges 0 and 1 meet at corner 1, which is cut off if its sign is not that of the middle.
        if (middle == signs[1])
            std::rotate(ends.begin(), ends.begin() + 1, ends.end());
    }
    for (std::size_t k = 0; k + 1 < ends.size(); k += 2)
        arcs_.push_back({ends[k], ends[k + 1]});
}

/// Joins arcs that end at the same place of a line of equal u or v.
std::vector<surface_line> contour_search::lines() {
    struct reference {
        std::size_t arc, end;
    };
    std::vector<reference> ends;
    for (std::size_t i = 0; i < arcs_.size(); ++i)
        for (const std::size_t end : {0U, 1U})
            if (!arcs_[i][end].is_on_boundary())
                ends.push_back({i, end});
    const auto key = [&](const reference& r) {
        const arc_end& end = arcs_[r.arc][r.end];
        return std::tuple(end.axis, end.line(), end.along());
    };
    std::ranges::sort(ends, {}, key);
    constexpr std::size_t none = ~std::size_t{0};
    std::vector<std::array<reference, 2>> next(arcs_.size(), {{{none, 0}, {none, 0}}});
    constexpr double same = 1e-9; // far below the smallest cell
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const auto [axis, line, along] = key(ends[i]);
        const auto [next_axis, next_line, next_along] = key(ends[i + 1]);
        if (axis != next_axis || line != next_line || next_along - along > same)
            continue;
        next[ends[i].arc][ends[i].end] = ends[i + 1];
        next[ends[i + 1].arc][ends[i + 1].end] = ends[i];
        ++i;
    }
    std::vector<surface_line> result;
    std::vector<bool> is_used(arcs_.size(), false);
    const auto walk = [&](std::size_t first, std::size_t begin) {
        surface_line& line = result.emplace_back();
        line.push_back(arcs_[first][begin].there);
        for (reference r{first, begin}; r.arc != none && !is_used[r.arc];) {
            is_used[r.arc] = true;
            line.push_back(arcs_[r.arc][1 - r.end].there);
            r = next[r.arc][1 - r.end];
        }
    };
    for (std::size_t i = 0; i < arcs_.size(); ++i)
        for (const std::size_t end : {0U, 1U})
            if (!is_used[i] && next[i][end].arc == none)
                walk(i, end);
    for (std::size_t i = 0; i < arcs_.size(); ++i)
        if (!is_used[i])
            walk(i, 0); // all others are closed
    return result;
}

} // namespace

std::vector<surface_line> contours_of(const image_piece& piece, std::size_t number,
                                      const drawing_view& view, double tolerance) {
    return contour_search(piece, number, view, tolerance).lines();
}

std::optional<surface_vertex> on_contour(const image_piece& piece, const surface_vertex& near) {
    surface_vertex result = near;
    constexpr int steps = 5; // Newton's method, from a chord that is nearly the contour
    for (int i = 0; i < steps; ++i) {
        const bernstein_net::jet f = piece.contour.evaluate(result.u, result.v);
        const double square = f.by_u[0] * f.by_u[0] + f.by_v[0] * f.by_v[0];
        if (!(square > 0))
            return std::nullopt;
        result.u -= f.value[0] * f.by_u[0] / square;
        result.v -= f.value[0] * f.by_v[0] / square;
    }
    result.u = std::clamp(result.u, 0.0, 1.0);
    result.v = std::clamp(result.v, 0.0, 1.0);
    result.at = piece.at(result.u, result.v);
    return result;
}

contour_shape shape_of_contour(const image_piece& piece, const surface_vertex& there) {
    const bernstein_net::jet p = piece.net.evaluate(there.u, there.v);
    const double w = p.value[2];
    const auto slope = [&](const std::array<double, 4>& by, std::size_t k) {
        return (by[k] - p.value[k] / w * by[2]) / w;
    };
    const double xu = slope(p.by_u, 0), yu = slope(p.by_u, 1), zu = slope(p.by_u, 3);
    const double xv = slope(p.by_v, 0), yv = slope(p.by_v, 1), zv = slope(p.by_v, 3);
    // On the contour, the map to the picture has rank 1. All motions lead along (tx, ty).
    const bool by_u = std::hypot(xu, yu) >= std::hypot(xv, yv);
    const double length = by_u ? std::hypot(xu, yu) : std::hypot(xv, yv);
    const double tx = (by_u ? xu : xv) / length, ty = (by_u ? yu : yv) / length;
    // The direction in parameters that is seen as a point, turned towards the eye.
    double ku = -(xv * tx + yv * ty), kv = xu * tx + yu * ty;
    if (zu * ku + zv * kv > 0)
        ku = -ku, kv = -kv;
    const bernstein_net::jet f = piece.contour.evaluate(there.u, there.v);
    contour_shape result;
    result.turn = f.by_u[0] * ku + f.by_v[0] * kv;
    // A step in this direction, forwards or back, leads to the side of the contour on which the
    // surface lies.
    const double scale = std::max(std::abs(ku), std::abs(kv));
    constexpr double step = 1e-3; // the second difference is well above rounding
    ku *= step / scale, kv *= step / scale;
    const image_place one = piece.at(there.u + ku, there.v + kv);
    const image_place two = piece.at(there.u - ku, there.v - kv);
    const double nx = -ty, ny = tx;
    const double bend =
        nx * (one.x + two.x - 2 * there.at.x) + ny * (one.y + two.y - 2 * there.at.y);
    result.out_x = bend > 0 ? -nx : nx;
    result.out_y = bend > 0 ? -ny : ny;
    return result;
}

} // namespace l3d_detail
