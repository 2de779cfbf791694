// SPDX-License-Identifier: MIT
// l3d_pipe_along: circles around a curve, and cubics between the circles.
#include "geom/nurbs_surface.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace {

using vector = l3d_vector<double, 3>;

/// A place of the curve, its unit tangent, and two unit vectors across the tangent.
struct section {
    vector centre, tangent, normal, binormal;
};

vector any_across(const vector& tangent) {
    vector axis(0.0);
    int least = 0;
    for (int k = 1; k < 3; ++k)
        if (std::abs(tangent[k]) < std::abs(tangent[least]))
            least = k;
    axis[least] = 1;
    return l3d_normalized(l3d_cross(tangent, axis));
}

/// The next section, turned about the tangent as little as possible. It is found by two
/// reflections.
/// Source: Wang, Juettler, Zheng, Liu, Computation of rotation minimizing frames, ACM TOG 27, 2008.
section next_section(const section& from, const vector& centre, const vector& tangent) {
    const auto reflected = [](const vector& v, const vector& by) {
        const double square = l3d_dot(by, by);
        return square > 0 ? v - by * (2 * l3d_dot(by, v) / square) : v;
    };
    const vector along = centre - from.centre;
    const vector normal = reflected(from.normal, along), half = reflected(from.tangent, along);
    section next{centre, tangent, reflected(normal, tangent - half), vector(0.0)};
    next.normal = l3d_normalized(next.normal - tangent * l3d_dot(next.normal, tangent));
    next.binormal = l3d_cross(tangent, next.normal);
    return next;
}

section section_at(const l3d_nurbs_curve& curve, double t, const section* before) {
    const l3d_curve_jet jet = curve.derivatives(t);
    const vector tangent = l3d_normalized(jet.first);
    if (before)
        return next_section(*before, jet.place, tangent);
    const vector normal = any_across(tangent);
    return {jet.place, tangent, normal, l3d_cross(tangent, normal)};
}

/// The parameters that cut each knot span into `cuts` equal parts, with both ends of the curve.
std::vector<double> places_along(const l3d_bspline_direction& along, int cuts) {
    std::vector<double> knots{along.from};
    for (const double knot : along.knots)
        if (knot > knots.back() && knot < along.to)
            knots.push_back(knot);
    knots.push_back(along.to);
    std::vector<double> result{along.from};
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
        for (int k = 1; k <= cuts; ++k)
            result.push_back(k == cuts ? knots[i + 1]
                                       : knots[i] + (knots[i + 1] - knots[i]) * k / cuts);
    return result;
}

/// The surface through a circle around each section, with one cubic span between neighbours. Let
/// the frame not turn about the tangent T. Then a normal n has the derivative -(n.T') T, where T'
/// is the part of c'' / |c'| across T.
l3d_nurbs_surface skin_of(const std::vector<section>& sections, const std::vector<double>& t,
                          const l3d_nurbs_curve& curve, double radius) {
    const l3d_nurbs_curve circle = l3d_nurbs_curve::circle(radius);
    const std::size_t last = sections.size() - 1;
    l3d_bspline_direction along{3, std::vector<double>(4, t[0]), t.front(), t.back()};
    for (std::size_t i = 1; i < last; ++i)
        along.knots.insert(along.knots.end(), 3, t[i]);
    along.knots.insert(along.knots.end(), 4, t[last]);
    std::vector<vector> points;
    std::vector<double> weights;
    const auto add_ring = [&](const vector& centre, const vector& normal, const vector& binormal) {
        for (std::size_t i = 0; i < circle.points().size(); ++i) {
            const vector& at = circle.points()[i];
            points.push_back(centre + normal * at[0] + binormal * at[1]);
            weights.push_back(circle.weight(i));
        }
    };
    for (std::size_t i = 0; i <= last; ++i) {
        const section& s = sections[i];
        const l3d_curve_jet jet = curve.derivatives(t[i]);
        const vector turn = jet.second / l3d_length(jet.first);
        const auto beside = [&](double h) {
            add_ring(s.centre + jet.first * h, s.normal - s.tangent * (h * l3d_dot(s.normal, turn)),
                     s.binormal - s.tangent * (h * l3d_dot(s.binormal, turn)));
        };
        if (i > 0)
            beside((t[i - 1] - t[i]) / 3);
        add_ring(s.centre, s.normal, s.binormal);
        if (i < last)
            beside((t[i + 1] - t[i]) / 3);
    }
    return {circle.along(), std::move(along), std::move(points), std::move(weights)};
}

/// The largest distance of sampled points of the surface from the circles that the surface
/// approximates.
double measured_on(const l3d_nurbs_surface& surface, const l3d_nurbs_curve& curve,
                   const std::vector<double>& t, double radius) {
    constexpr int places = 8;
    double most = 0;
    for (std::size_t i = 0; i + 1 < t.size(); ++i)
        for (int k = 0; k <= places; ++k) {
            const double v = t[i] + (t[i + 1] - t[i]) * k / places;
            const l3d_curve_jet jet = curve.derivatives(v);
            const vector tangent = l3d_normalized(jet.first);
            for (int j = 0; j < places; ++j) {
                const vector from = surface.evaluate(surface.u().to * j / places, v) - jet.place;
                const double ahead = l3d_dot(from, tangent);
                const double beside = l3d_length(from - tangent * ahead) - radius;
                most = std::max(most, std::hypot(ahead, beside));
            }
        }
    return most;
}

} // namespace

l3d_pipe l3d_pipe_along(const l3d_nurbs_curve& curve, double radius, double tolerance) {
    constexpr std::size_t most_spans = 1024;
    for (int cuts = 1;; cuts *= 2) {
        const std::vector<double> t = places_along(curve.along(), cuts);
        std::vector<section> sections;
        for (const double at : t)
            sections.push_back(
                section_at(curve, at, sections.empty() ? nullptr : &sections.back()));
        l3d_nurbs_surface surface = skin_of(sections, t, curve, radius);
        const double measured = measured_on(surface, curve, t, radius);
        if (measured <= tolerance)
            return {std::move(surface), measured};
        if (2 * t.size() > most_spans)
            throw l3d_error(l3d_exit::bad_input, "pipe: " + std::to_string(t.size()) +
                                                     " spans are off by " +
                                                     std::to_string(measured));
    }
}
