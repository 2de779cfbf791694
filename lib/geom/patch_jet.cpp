// SPDX-License-Identifier: MIT
// l3d_patch_jet: Bernstein polynomials, and the fundamental forms.
#include "geom/patch_jet.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace {

using vector = l3d_patch_place::vector;
using weights = std::array<double, 4>;

/// The cubic Bernstein polynomials and their derivatives.
struct bernstein {
    explicit bernstein(double t) {
        const double s = 1 - t;
        value = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
        first = {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t};
        second = {6 * s, 6 * (t - 2 * s), 6 * (s - 2 * t), 6 * t};
    }
    weights value, first, second;
};

using rows = std::array<vector, 4>;

/// Each row of the net, weighed along u.
rows weigh_rows(const l3d_bezier_patch<double, 3>& patch, const weights& of) {
    rows result;
    for (int r = 0; r < 4; ++r)
        result[static_cast<std::size_t>(r)] = patch.at(r, 0) * of[0] + patch.at(r, 1) * of[1] +
                                              patch.at(r, 2) * of[2] + patch.at(r, 3) * of[3];
    return result;
}

vector weigh(const rows& of, const weights& by) {
    return of[0] * by[0] + of[1] * by[1] + of[2] * by[2] + of[3] * by[3];
}

} // namespace

l3d_patch_place l3d_place_of(const l3d_bezier_patch<double, 3>& patch, double u, double v) {
    const bernstein in_u(u), in_v(v);
    const rows values = weigh_rows(patch, in_u.value), slopes = weigh_rows(patch, in_u.first);
    return {weigh(values, in_v.value), weigh(slopes, in_v.value), weigh(values, in_v.first)};
}

l3d_patch_jet l3d_jet_of(const l3d_bezier_patch<double, 3>& patch, double u, double v) {
    const bernstein in_u(u), in_v(v);
    const rows values = weigh_rows(patch, in_u.value), slopes = weigh_rows(patch, in_u.first);
    l3d_patch_jet jet;
    jet.point = weigh(values, in_v.value);
    jet.along_u = weigh(slopes, in_v.value);
    jet.along_v = weigh(values, in_v.first);
    jet.along_uu = weigh(weigh_rows(patch, in_u.second), in_v.value);
    jet.along_uv = weigh(slopes, in_v.first);
    jet.along_vv = weigh(values, in_v.second);
    return jet;
}

std::optional<l3d_patch_bend> l3d_bend_of(const l3d_patch_jet& jet) {
    const vector &su = jet.along_u, &sv = jet.along_v;
    const double big_e = l3d_dot(su, su), big_f = l3d_dot(su, sv), big_g = l3d_dot(sv, sv);
    const vector across = l3d_cross(su, sv);
    const double area = l3d_dot(across, across);
    // Su x Sv is off by some 2^-52 |Su| |Sv|: a direction to 2^-20 is asked for.
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
