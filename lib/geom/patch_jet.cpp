// SPDX-License-Identifier: MIT
// l3d_patch_jet: evaluates Bernstein polynomials, and finds the fundamental forms.
#include "geom/patch_jet.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace {

using vector = l3d_patch_place::vector;
using four = std::array<vector, 4>;

// Derivatives come from differences of control points, so they are exactly zero where control
// points coincide.

vector value_of(const four& p, double t) {
    const double s = 1 - t;
    return p[0] * (s * s * s) + p[1] * (3 * s * s * t) + p[2] * (3 * s * t * t) +
           p[3] * (t * t * t);
}

vector first_of(const four& p, double t) {
    const double s = 1 - t;
    return (p[1] - p[0]) * (3 * s * s) + (p[2] - p[1]) * (6 * s * t) + (p[3] - p[2]) * (3 * t * t);
}

vector second_of(const four& p, double t) {
    return ((p[2] - p[1]) - (p[1] - p[0])) * (6 * (1 - t)) +
           ((p[3] - p[2]) - (p[2] - p[1])) * (6 * t);
}

/// Applies the function `of` to each row of the control net, at parameter u.
template <class Of> four of_rows(const l3d_bezier_patch<double, 3>& patch, double u, const Of& of) {
    four result;
    for (int r = 0; r < 4; ++r)
        result[static_cast<std::size_t>(r)] =
            of({patch.at(r, 0), patch.at(r, 1), patch.at(r, 2), patch.at(r, 3)}, u);
    return result;
}

} // namespace

l3d_patch_place l3d_place_of(const l3d_bezier_patch<double, 3>& patch, double u, double v) {
    const four values = of_rows(patch, u, value_of), slopes = of_rows(patch, u, first_of);
    return {value_of(values, v), value_of(slopes, v), first_of(values, v)};
}

l3d_patch_jet l3d_jet_of(const l3d_bezier_patch<double, 3>& patch, double u, double v) {
    const four values = of_rows(patch, u, value_of), slopes = of_rows(patch, u, first_of);
    l3d_patch_jet jet;
    jet.point = value_of(values, v);
    jet.along_u = value_of(slopes, v);
    jet.along_v = first_of(values, v);
    jet.along_uu = value_of(of_rows(patch, u, second_of), v);
    jet.along_uv = first_of(slopes, v);
    jet.along_vv = second_of(values, v);
    return jet;
}

std::optional<l3d_patch_bend> l3d_bend_of(const l3d_patch_jet& jet) {
    const vector &su = jet.along_u, &sv = jet.along_v;
    const double big_e = l3d_dot(su, su), big_f = l3d_dot(su, sv), big_g = l3d_dot(sv, sv);
    const vector across = l3d_cross(su, sv);
    const double area = l3d_dot(across, across);
    // Least sine between Su and Sv. Su x Sv errs by 2^-52 |Su| |Sv|: its direction by 2^-20.
    constexpr double least_sine = 0x1p-32;
    if (!(area > least_sine * least_sine * big_e * big_g))
        return std::nullopt;
    const double length = std::sqrt(area);
    l3d_patch_bend bend;
    const vector& n = bend.normal = across * (1 / length);
    const auto turned = [&](const vector& change) {
        return (change - n * l3d_dot(n, change)) * (1 / length);
    };
    bend.normal_u = turned(l3d_cross(jet.along_uu, sv) + l3d_cross(su, jet.along_uv));
    bend.normal_v = turned(l3d_cross(jet.along_uv, sv) + l3d_cross(su, jet.along_vv));
    const double e = l3d_dot(jet.along_uu, n), f = l3d_dot(jet.along_uv, n);
    const double g = l3d_dot(jet.along_vv, n);
    bend.gaussian = (e * g - f * f) / area;
    bend.mean = (e * big_g - 2 * f * big_f + g * big_e) / (2 * area);
    return bend;
}
