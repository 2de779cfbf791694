// SPDX-License-Identifier: MIT
// audit_part: finds distances to triangles, and bounds how far surfaces are off them.
#include "scene/audit/audit_part_p.h"

#include <algorithm>
#include <cmath>

namespace l3d_detail {
namespace {

using vector = flat_triangle::vector;
using place = audit_part::place;

constexpr std::size_t next(std::size_t k) {
    return k < 2 ? k + 1 : 0;
}

/// The square of the distance from (x, y) to the segment from the origin to (a, b).
double square_distance_to_segment(double x, double y, double a, double b) {
    const double square = a * a + b * b;
    const double share = square > 0 ? std::clamp((x * a + y * b) / square, 0.0, 1.0) : 0;
    const double dx = x - share * a, dy = y - share * b;
    return dx * dx + dy * dy;
}

/// Some unit vector perpendicular to `unit`.
vector any_across(const vector& unit) {
    vector axis{0.0, 0.0, 0.0};
    axis[std::abs(unit[0]) < 0.5 ? 0 : 1] = 1;
    return l3d_normalized(axis - unit * l3d_dot(axis, unit));
}

/// A bound of a polynomial between two parameters: the largest of its Bezier coefficients for this
/// interval. These coefficients are blossoms of the polynomial's given coefficients `of`.
template <std::size_t count>
double most_between(const std::array<double, count>& of, double from, double to) {
    double result = 0;
    for (std::size_t low = 0; low < count; ++low) {
        std::array<double, count> b = of;
        for (std::size_t level = count - 1; level > 0; --level)
            for (std::size_t i = 0; i < level; ++i)
                b[i] = std::lerp(b[i], b[i + 1], level > low ? to : from);
        result = std::max(result, b[0]);
    }
    return result;
}

vector on_surface(const patch_sheet& sheet, const place& p) {
    return sheet.patch->of.evaluate(p[0], p[1]);
}

place mixed(const place& a, const place& b, double share) {
    return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share)};
}

} // namespace

flat_triangle::flat_triangle(const std::array<vector, 3>& corners) : corners_(corners) {
    std::size_t side = 0;
    double longest = -1;
    for (std::size_t k = 0; k < 3; ++k)
        if (const double l = l3d_length(corners[next(k)] - corners[k]); l > longest) {
            longest = l;
            side = k;
        }
    length_ = longest;
    first_ = corners[side];
    along_ = longest > 0 ? (corners[next(side)] - first_) * (1 / longest) : vector(1.0, 0.0, 0.0);
    const vector third = corners[next(next(side))] - first_;
    x_ = l3d_dot(third, along_);
    const vector height = third - along_ * x_;
    y_ = l3d_length(height);
    // A height below the rounding of the side's length counts as 0, since it has no certain
    // direction.
    const bool is_flat = y_ <= 0x1p-50 * length_;
    if (is_flat)
        y_ = 0;
    across_ = is_flat ? any_across(along_) : height * (1 / y_);
    normal_ = l3d_cross(along_, across_);
}

double flat_triangle::square_distance(const vector& from) const {
    const vector to = from - first_;
    const double x = l3d_dot(to, along_), y = l3d_dot(to, across_), z = l3d_dot(to, normal_);
    const bool is_over =
        y_ > 0 && y >= 0 && y_ * x >= x_ * y && (x_ - length_) * y >= y_ * (x - length_);
    if (is_over)
        return z * z;
    return z * z + std::min({square_distance_to_segment(x, y, length_, 0),
                             square_distance_to_segment(x, y, x_, y_),
                             square_distance_to_segment(x - length_, y, x_ - length_, y_)});
}

double flat_triangle::beyond(std::size_t k, const vector& place) const {
    const vector side = corners_[next(k)] - corners_[k];
    vector out = l3d_cross(side, normal_);
    const double length = l3d_length(out);
    if (!(length > 0))
        return 0;
    out = out * (1 / length);
    const double of_third = l3d_dot(out, corners_[next(next(k))] - corners_[k]);
    return (of_third > 0 ? -1 : 1) * l3d_dot(out, place - corners_[k]);
}

bool flat_triangle::is_apart(const flat_triangle& other, double by) const {
    const auto all_beyond = [&](const vector& out, const vector& from) {
        const double least = by * l3d_length(out);
        return std::ranges::all_of(other.corners_,
                                   [&](const vector& p) { return l3d_dot(out, p - from) > least; });
    };
    if (all_beyond(normal_, corners_[0]) || all_beyond(normal_ * -1.0, corners_[0]))
        return true;
    for (std::size_t k = 0; k < 3; ++k) {
        vector out = l3d_cross(corners_[next(k)] - corners_[k], normal_);
        if (l3d_dot(out, corners_[next(next(k))] - corners_[k]) > 0)
            out = out * -1.0;
        if (all_beyond(out, corners_[k]))
            return true;
    }
    return false;
}

bent_patch::bent_patch(const patch& p) : of(p) {
    const auto raise = [](double& to, double by) { to = std::max(to, by); };
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 2; ++k) {
            const auto at = static_cast<std::size_t>(i);
            raise(uu_[at], 6 * l3d_length(p.at(i, k) - p.at(i, k + 1) * 2.0 + p.at(i, k + 2)));
            raise(vv_[at], 6 * l3d_length(p.at(k, i) - p.at(k + 1, i) * 2.0 + p.at(k + 2, i)));
        }
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            const double mixed =
                9 * l3d_length(p.at(i, k) - p.at(i, k + 1) - p.at(i + 1, k) + p.at(i + 1, k + 1));
            raise(uv_by_v_[static_cast<std::size_t>(i)], mixed);
            raise(uv_by_u_[static_cast<std::size_t>(k)], mixed);
        }
}

/// Bounds each row of a derivative's net by its longest vector, and takes means of these bounds. A
/// place is a mean of the rows, too: its weights are Bernstein polynomials, whose sum is 1.
std::array<double, 3> bent_patch::bounds(const patch_place& least, const patch_place& most) const {
    return {most_between(uu_, least[1], most[1]),
            std::min(most_between(uv_by_v_, least[1], most[1]),
                     most_between(uv_by_u_, least[0], most[0])),
            most_between(vv_, least[0], most[0])};
}

/// The contribution of each side to `off`. Let e be a side of the triangle as a step in (u, v), and
/// let l_i be the weights of the corners at a place. The flat triangle is off by at most half the
/// sum of l_i l_j |second derivative along e|, over all three sides. NUMERICS, "The distance
/// between a mesh and a surface", derives this bound.
std::array<double, 3> audit_part::weights() const {
    std::array<double, 2> widths{};
    std::array<place, 3> sides{};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 2; ++i) {
            sides[k][i] = at[next(k)][i] - at[k][i];
            widths[i] = std::max(widths[i], std::abs(sides[k][i]));
        }
    const auto [u0, u1] = std::minmax({at[0][0], at[1][0], at[2][0]});
    const auto [v0, v1] = std::minmax({at[0][1], at[1][1], at[2][1]});
    const auto [uu, uv, vv] = sheet->patch->bounds({u0, v0}, {u1, v1});
    // For any t, |2 du dv| <= t du^2 + dv^2 / t. This t makes both terms alike.
    const bool has_both = widths[0] > 0 && widths[1] > 0;
    const double by_u = uu + (has_both ? uv * widths[1] / widths[0] : 0);
    const double by_v = vv + (has_both ? uv * widths[0] / widths[1] : 0);
    std::array<double, 3> result{};
    for (std::size_t k = 0; k < 3; ++k)
        result[k] = by_u * sides[k][0] * sides[k][0] + by_v * sides[k][1] * sides[k][1];
    return result;
}

audit_part::audit_part(const patch_sheet& of, const std::array<place, 3>& at_corners)
    : audit_part(of, at_corners,
                 {on_surface(of, at_corners[0]), on_surface(of, at_corners[1]),
                  on_surface(of, at_corners[2])}) {}

audit_part::audit_part(const patch_sheet& of, const std::array<place, 3>& at_corners,
                       const std::array<vector, 3>& corners)
    : flat(corners), at(at_corners), sheet(&of), index(of.index) {
    // The sum of l_i l_j w_k is the variance of the corners of a triangle with sides of squared
    // lengths w. It is at most the square of the radius of the least circle around it.
    const auto [a, b, c] = weights();
    const double most = std::max({a, b, c});
    const bool is_acute = 2 * most < a + b + c;
    const double area = 2 * (a * b + b * c + c * a) - (a * a + b * b + c * c); // 16 squared areas
    off = (is_acute && area > 0 ? std::min(a * b * c / area, most / 3) : most / 4) / 2;
}

audit_part::vector audit_part::middle() const {
    const auto& c = flat.corners();
    if (!sheet)
        return (c[0] + c[1] + c[2]) * (1.0 / 3);
    return on_surface(*sheet,
                      {(at[0][0] + at[1][0] + at[2][0]) / 3, (at[0][1] + at[1][1] + at[2][1]) / 3});
}

std::array<audit_part, 2> audit_part::cut(std::size_t k, double share) const {
    const std::size_t l = next(k), m = next(l);
    const auto& c = flat.corners();
    if (sheet) {
        const place at_cut = mixed(at[k], at[l], share);
        const vector p = on_surface(*sheet, at_cut);
        return {audit_part(*sheet, {at[k], at_cut, at[m]}, {c[k], p, c[m]}),
                audit_part(*sheet, {at_cut, at[l], at[m]}, {p, c[l], c[m]})};
    }
    const vector p = l3d_lerp(c[k], c[l], share);
    return {audit_part({c[k], p, c[m]}, index), audit_part({p, c[l], c[m]}, index)};
}

std::size_t audit_part::bent_side() const {
    const auto w = weights();
    return static_cast<std::size_t>(std::ranges::max_element(w) - w.begin());
}

double audit_part::size() const {
    const std::size_t side = longest_side();
    return l3d_length(flat.corners()[next(side)] - flat.corners()[side]);
}

std::size_t audit_part::longest_side() const {
    const auto& c = flat.corners();
    const std::array<double, 3> lengths{l3d_length(c[1] - c[0]), l3d_length(c[2] - c[1]),
                                        l3d_length(c[0] - c[2])};
    return static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
}

patch_place bent_patch::place_near(const vector& to, patch_place begin) const {
    constexpr int most_steps = 6;
    constexpr double small = 1e-4; // a step's error is about its square
    for (int step = 0; step < most_steps; ++step) {
        const vector u = of.derivative_u(begin[0], begin[1]);
        const vector v = of.derivative_v(begin[0], begin[1]);
        const vector off = to - of.evaluate(begin[0], begin[1]);
        const double a = l3d_dot(u, u), b = l3d_dot(u, v), c = l3d_dot(v, v);
        const double area = a * c - b * b;
        if (!(area > 0))
            break;
        const double by_u = l3d_dot(off, u), by_v = l3d_dot(off, v);
        const double du = (c * by_u - b * by_v) / area, dv = (a * by_v - b * by_u) / area;
        // A place that is farther beyond the patch than the patch is wide cannot be near.
        begin = {std::clamp(begin[0] + du, -1.0, 2.0), std::clamp(begin[1] + dv, -1.0, 2.0)};
        if (std::max(std::abs(du), std::abs(dv)) < small)
            break;
    }
    return begin;
}

} // namespace l3d_detail
