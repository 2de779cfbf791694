// SPDX-License-Identifier: MIT
// l3d_measured: measures exact pieces of curved models, and their principal curvatures.
#include "scene/measured_place.h"

#include "geom/transform.h"
#include "base/formatted_p.h"
#include "geom/nurbs_surface.h"
#include "scene/picks/surface_jet.h"

#include <algorithm>
#include <cmath>

namespace {

using vector = l3d_measured_place::vector;
using l3d_detail::formatted;

l3d_surface_jet::vector around(const vector& v, double radius) {
    return {l3d_interval::around(v[0], radius), l3d_interval::around(v[1], radius),
            l3d_interval::around(v[2], radius)};
}

/// Measures the exact piece that holds the picked patch, from its derivatives in the world.
///
/// The rounding of derivatives grows with their order. A derivative of order k is a sum of control
/// points times degrees to the k-th power. The ratio of weights counts once more for each order.
/// Evaluating, dividing and placing take less than 128 roundings.
l3d_surface_jet exact_jet(const l3d_patch_instance& instance, const l3d_pick& pick) {
    const l3d_patch_model& model = instance.model();
    const l3d_nurbs_surface piece = model.surface(model.piece_of(pick.patch));
    const l3d_parameter_range range = model.range_in_piece(pick.patch);
    const double u = range.u0 + pick.u * (range.u1 - range.u0);
    const double v = range.v0 + pick.v * (range.v1 - range.v0);
    const l3d_surface_derivatives s = piece.derivatives(u, v);
    const auto& weights = piece.weights();
    double unequal = 1;
    if (!weights.empty()) {
        const auto [least, most] = std::ranges::minmax(weights);
        unequal = most / least;
    }
    const double degrees = 2.0 * std::max(piece.u().degree, piece.v().degree);
    const double rounding = 0x1p-46 * instance.reach() * unequal;
    const double first = rounding * unequal * degrees, second = first * unequal * degrees;
    const l3d_matrix<double>& m = instance.placement();
    const vector place = l3d_transformed(m, l3d_point<double>(s.place)).from_origin;
    return l3d_surface_jet({.point = around(place, rounding),
                            .by_u = around(l3d_transformed(m, s.by_u), first),
                            .by_v = around(l3d_transformed(m, s.by_v), first),
                            .by_uu = around(l3d_transformed(m, s.by_uu), second),
                            .by_uv = around(l3d_transformed(m, s.by_uv), second),
                            .by_vv = around(l3d_transformed(m, s.by_vv), second)});
}

/// Sets the curvatures H +- sqrt(H^2 - K). H^2 - K is never negative, so negative parts of its
/// interval are left out.
void take_curvatures(l3d_measured_place& to, const l3d_interval& mean,
                     const l3d_interval& gaussian) {
    const l3d_interval under = mean.squared() - gaussian;
    if (!(under.high >= 0 && std::isfinite(under.high)))
        return;
    const l3d_interval root = l3d_interval{std::max(under.low, 0.0), under.high}.root();
    const l3d_interval larger = mean + root, smaller = mean - root;
    to.curvatures = {larger.middle(), smaller.middle()};
    to.curvature_error = std::max(larger.radius(), smaller.radius());
}

} // namespace

l3d_measured_place l3d_measured(const l3d_patch_scene& scene, const l3d_pick& pick) {
    l3d_measured_place result{.point = pick.point,
                              .point_error = pick.point_error,
                              .normal = pick.normal,
                              .normal_error = pick.normal_error};
    const l3d_patch_instance& instance = scene.instances()[pick.instance];
    if (!instance.model().is_curved()) {
        take_curvatures(result, l3d_interval::around(pick.mean, pick.mean_error),
                        l3d_interval::around(pick.gaussian, pick.gaussian_error));
        return result;
    }
    const l3d_surface_jet jet = exact_jet(instance, pick);
    result.point = l3d_middle(jet.point);
    result.point_error = l3d_radius(jet.point);
    result.normal = {0.0, 0.0, 0.0};
    if (!jet.normal)
        return result;
    const vector normal = l3d_middle(*jet.normal);
    const double side = l3d_dot(normal, pick.normal) < 0 ? -1 : 1;
    result.normal = normal * side;
    result.normal_error = l3d_radius(*jet.normal);
    const l3d_interval mean = side < 0 ? l3d_interval{-jet.mean.high, -jet.mean.low} : jet.mean;
    take_curvatures(result, mean, jet.gaussian);
    return result;
}

std::string l3d_measured_place::radii() const {
    if (!std::isfinite(curvature_error))
        return "";
    const auto [less, more] = std::minmax(
        curvatures[0], curvatures[1], [](double a, double b) { return std::abs(a) < std::abs(b); });
    const auto is_flat = [&](double of) { return !(std::abs(of) > curvature_error); };
    if (is_flat(more))
        return formatted("flat: no radius below %.2g units",
                         1 / (std::abs(more) + curvature_error));
    const auto error = [&](double of) {
        return 1 / (std::abs(of) - curvature_error) - 1 / std::abs(of);
    };
    if (is_flat(less))
        return formatted("radius %.9g units, good to %.1g, and flat across", 1 / std::abs(more),
                         error(more));
    return formatted("radii %.9g and %.9g units, good to %.1g and %.1g", 1 / std::abs(more),
                     1 / std::abs(less), error(more), error(less));
}
