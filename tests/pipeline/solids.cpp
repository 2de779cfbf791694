// SPDX-License-Identifier: MIT
// Solids: planes, cylinders, tori and balls by revolving and extruding.
#include "solids.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace {

using vector = solid::vector;
constexpr double pi = std::numbers::pi;

struct curve_use {
    l3d_nurbs_curve curve; ///< in (u, v)
    l3d_edge_use edge;
};

void add_face(solid& to, const l3d_nurbs_surface& surface,
              const std::vector<std::vector<curve_use>>& loops) {
    std::vector<l3d_trim_loop> trims;
    for (const auto& loop : loops) {
        std::vector<l3d_nurbs_curve> curves;
        std::vector<l3d_edge_use> edges;
        for (const curve_use& one : loop) {
            curves.push_back(one.curve);
            edges.push_back(one.edge);
        }
        trims.push_back(l3d_trim_loop_of(curves, edges));
    }
    to.faces.push_back(surface.trimmed(trims));
}

std::uint32_t add_edge(solid& to, const l3d_nurbs_curve& curve, double tolerance = 0) {
    to.edges.push_back({curve, tolerance});
    return static_cast<std::uint32_t>(to.edges.size() - 1);
}

l3d_nurbs_curve moved(const l3d_nurbs_curve& curve, const auto& place) {
    std::vector<vector> points;
    for (const vector& p : curve.points())
        points.push_back(place(p));
    return {curve.along(), points, curve.weights()};
}

/// A circle around a line along y, which turns from x towards -z, as revolved surfaces do.
l3d_nurbs_curve ring(double x, double y, double z, double radius) {
    return moved(l3d_nurbs_curve::circle(radius), [&](const vector& p) {
        return vector{x + p[0], y, z - p[1]};
    });
}

l3d_nurbs_curve line(double u0, double v0, double u1, double v1) {
    return l3d_nurbs_curve::polyline({{u0, v0, 0.0}, {u1, v1, 0.0}});
}

/// A wall between two rings on one axis, all of a revolved or extruded surface: along its low v,
/// up the seam, back along its high v, and down the seam.
void add_ring_face(solid& to, const l3d_nurbs_surface& surface, std::uint32_t low,
                   std::uint32_t high) {
    const auto &u = surface.u(), &v = surface.v();
    const l3d_nurbs_curve seam = [&] {
        std::vector<vector> points;
        std::vector<double> weights;
        for (std::size_t row = 0; row < v.points(); ++row) {
            points.push_back(surface.points()[row * u.points()]);
            if (!surface.weights().empty())
                weights.push_back(surface.weights()[row * u.points()]);
        }
        return l3d_nurbs_curve(v, points, weights);
    }();
    const std::uint32_t along_seam = add_edge(to, seam);
    add_face(to, surface,
             {{{line(u.from, v.from, u.to, v.from), {low, 0, 4}},
               {line(u.to, v.from, u.to, v.to), {along_seam, v.from, v.to}},
               {line(u.to, v.to, u.from, v.to), {high, 4, 0}},
               {line(u.from, v.to, u.from, v.from), {along_seam, v.to, v.from}}}});
}

/// A plane at y that faces up or down, over a square of (x, z) of this half side.
struct level_plane {
    double y, half;
    bool is_up;

    /// u runs along x, and v along -z or z.
    l3d_nurbs_surface surface() const {
        const double s = is_up ? -half : half;
        return {l3d_bspline_direction::clamped(1, 2),
                l3d_bspline_direction::clamped(1, 2),
                {{-half, y, -s}, {half, y, -s}, {-half, y, s}, {half, y, s}}};
    }
    l3d_nurbs_curve on(const l3d_nurbs_curve& curve) const {
        return moved(curve, [&](const vector& p) {
            const double v = (p[2] / half + 1) / 2;
            return vector{(p[0] / half + 1) / 2, is_up ? 1 - v : v, 0.0};
        });
    }
};

curve_use ring_on(const level_plane& plane, double x, double z, double radius, std::uint32_t edge,
                  double error) {
    return {plane.on(ring(x, plane.y, z, radius * (1 + error))), {edge, 0, 4}};
}

l3d_nurbs_surface wall_of(const l3d_nurbs_curve& low, double height) {
    return l3d_extruded(low, {0.0, height, 0.0});
}

double off_axis(const vector& p, double x, double z) {
    return std::hypot(p[0] - x, p[2] - z);
}

/// The distance outside of an upright cylinder.
double cylinder(const vector& p, double radius, double low, double high) {
    return std::max({off_axis(p, 0, 0) - radius, low - p[1], p[1] - high});
}

/// A cubic through places of a curve from 0 to 1, with its tangents by differences.
l3d_nurbs_curve fitted(const std::function<vector(double)>& place, int spans) {
    l3d_bspline_direction along{3, {0}, 0, 1};
    std::vector<vector> points;
    const double step = 1.0 / spans, h = step * 0x1p-6;
    const auto slope = [&](double t) {
        const vector a = (place(t + h) - place(t - h)) / (2 * h);
        const vector b = (place(t + 2 * h) - place(t - 2 * h)) / (4 * h);
        return a + (a - b) * (1.0 / 3);
    };
    for (int i = 0; i < spans; ++i) {
        along.knots.insert(along.knots.end(), 3, i * step);
        const double from = i * step, to = (i + 1) * step;
        points.insert(points.end(), {place(from), place(from) + slope(from) * (step / 3),
                                     place(to) - slope(to) * (step / 3)});
    }
    points.push_back(place(1));
    along.knots.insert(along.knots.end(), 4, 1.0);
    return {along, points};
}

/// The parameter at which a value that rises reaches `at`.
double solved(const std::function<double(double)>& value, double low, double high, double at) {
    for (int i = 0; i < 60; ++i) {
        const double middle = (low + high) / 2;
        (value(middle) < at ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// The parameter of a quarter circle's rational parabola: four quarters from 0 to 4.
double circle_parameter(double angle) {
    static const l3d_nurbs_curve circle = l3d_nurbs_curve::circle(1);
    const double turns = std::floor(angle / (2 * pi)), rest = angle - 2 * pi * turns;
    const double quarter = std::min(std::floor(rest / (pi / 2)), 3.0);
    const auto angle_at = [&](double t) {
        const vector p = circle.evaluate(t);
        const double from = quarter * pi / 2;
        return std::atan2(p[1] * std::cos(from) - p[0] * std::sin(from),
                          p[0] * std::cos(from) + p[1] * std::sin(from));
    };
    return 4 * turns + solved(angle_at, quarter, quarter + 1, rest - quarter * pi / 2);
}

} // namespace

solid holed_plate(int across, const solid_errors& errors) {
    solid result;
    const double half = across, low = 0, high = 0.7, radius = 0.6;
    const level_plane top{high, half, true}, bottom{low, half, false};
    const auto corner = [&](int k, double y) {
        constexpr int x[] = {-1, 1, 1, -1}, z[] = {1, 1, -1, -1};
        return vector{half * x[k % 4], y, half * z[k % 4]};
    };
    std::array<std::uint32_t, 4> below{}, above{}, upright{};
    for (int k = 0; k < 4; ++k) {
        const auto i = static_cast<std::size_t>(k);
        below[i] =
            add_edge(result, l3d_nurbs_curve::polyline({corner(k, low), corner(k + 1, low)}));
        above[i] =
            add_edge(result, l3d_nurbs_curve::polyline({corner(k, high), corner(k + 1, high)}));
        upright[i] = add_edge(result, l3d_nurbs_curve::polyline({corner(k, low), corner(k, high)}));
    }
    const auto straight = [&](std::uint32_t edge, bool back) {
        const auto& along = result.edges[edge].curve.along();
        return back ? l3d_edge_use{edge, along.to, along.from}
                    : l3d_edge_use{edge, along.from, along.to};
    };
    for (int k = 0; k < 4; ++k) {
        const auto i = static_cast<std::size_t>(k), j = (i + 1) % 4;
        const l3d_nurbs_surface side(
            l3d_bspline_direction::clamped(1, 2), l3d_bspline_direction::clamped(1, 2),
            {corner(k, low), corner(k + 1, low), corner(k, high), corner(k + 1, high)});
        add_face(result, side,
                 {{{line(0, 0, 1, 0), straight(below[i], false)},
                   {line(1, 0, 1, 1), straight(upright[j], false)},
                   {line(1, 1, 0, 1), straight(above[i], true)},
                   {line(0, 1, 0, 0), straight(upright[i], true)}}});
    }
    std::vector<std::vector<curve_use>> on_top(1), on_bottom(1);
    for (std::size_t k = 0; k < 4; ++k) {
        on_top[0].push_back({top.on(result.edges[above[k]].curve), straight(above[k], false)});
        on_bottom[0].push_back(
            {bottom.on(result.edges[below[k]].curve), straight(below[k], false)});
    }
    for (int row = 0; row < across; ++row)
        for (int column = 0; column < across; ++column) {
            const double x = 2 * column + 1 - half, z = 2 * row + 1 - half;
            const std::uint32_t up = add_edge(result, ring(x, high, z, radius));
            const std::uint32_t down = add_edge(result, ring(x, low, z, radius));
            on_top.push_back({ring_on(top, x, z, radius, up, errors.circles)});
            on_bottom.push_back({ring_on(bottom, x, z, radius, down, -errors.circles)});
            // Downwards, so that its outside is towards the axis.
            add_ring_face(result, wall_of(ring(x, high, z, radius), low - high), up, down);
        }
    add_face(result, top.surface(), on_top);
    add_face(result, bottom.surface(), on_bottom);
    result.outside = [=](const vector& p) {
        const double box =
            std::max({std::abs(p[0]) - half, std::abs(p[2]) - half, low - p[1], p[1] - high});
        const auto nearest = [&](double at) {
            return std::clamp(2 * std::floor((at + half) / 2) + 1 - half, 1 - half, half - 1);
        };
        return std::max(box, radius - off_axis(p, nearest(p[0]), nearest(p[2])));
    };
    result.middle = {0.0, (low + high) / 2, 0.0};
    result.radius = std::hypot(half, half, high);
    return result;
}

solid flange(int bolts, const solid_errors& errors) {
    solid result;
    const double outer = 3, hub = 1.4, bore = 0.9, at = 2.2, bolt = 0.3, low = 0, middle = 0.6,
                 high = 2;
    const level_plane bottom{low, outer, false}, rim{middle, outer, true}, top{high, outer, true};
    const auto round = [&](double y, double radius) {
        return add_edge(result, ring(0, y, 0, radius));
    };
    const std::uint32_t foot = round(low, outer), brim = round(middle, outer),
                        neck = round(middle, hub), head = round(high, hub),
                        bore_low = round(low, bore), bore_high = round(high, bore);
    const double e = errors.circles;
    std::vector<std::vector<curve_use>> on_bottom{{ring_on(bottom, 0, 0, outer, foot, 0)},
                                                  {ring_on(bottom, 0, 0, bore, bore_low, e)}},
        on_rim{{ring_on(rim, 0, 0, outer, brim, 0)}, {ring_on(rim, 0, 0, hub, neck, e)}};
    add_face(result, top.surface(),
             {{ring_on(top, 0, 0, hub, head, -e)}, {ring_on(top, 0, 0, bore, bore_high, e)}});
    add_ring_face(result, wall_of(ring(0, low, 0, outer), middle - low), foot, brim);
    add_ring_face(result, wall_of(ring(0, middle, 0, hub), high - middle), neck, head);
    add_ring_face(result, wall_of(ring(0, high, 0, bore), low - high), bore_high, bore_low);
    std::vector<std::array<double, 2>> holes;
    for (int i = 0; i < bolts; ++i) {
        const double angle = 2 * pi * (i + 0.3) / bolts;
        const double x = at * std::cos(angle), z = at * std::sin(angle);
        const std::uint32_t up = add_edge(result, ring(x, middle, z, bolt));
        const std::uint32_t down = add_edge(result, ring(x, low, z, bolt));
        on_rim.push_back({ring_on(rim, x, z, bolt, up, e)});
        on_bottom.push_back({ring_on(bottom, x, z, bolt, down, -e)});
        add_ring_face(result, wall_of(ring(x, middle, z, bolt), low - middle), up, down);
        holes.push_back({x, z});
    }
    add_face(result, bottom.surface(), on_bottom);
    add_face(result, rim.surface(), on_rim);
    result.outside = [=](const vector& p) {
        double d = std::min(cylinder(p, outer, low, middle), cylinder(p, hub, low, high));
        d = std::max(d, bore - off_axis(p, 0, 0));
        for (const auto& [x, z] : holes)
            d = std::max(d, bolt - off_axis(p, x, z));
        return d;
    };
    result.middle = {0.0, high / 2, 0.0};
    result.radius = std::hypot(outer, high / 2);
    return result;
}

solid filleted_cylinders(const solid_errors& errors) {
    solid result;
    const double wide = 2, thin = 0.8, fillet = 0.5, low = 0, middle = 1, high = 3;
    const level_plane bottom{low, wide, false}, shoulder{middle, wide, true}, top{high, wide, true};
    const auto round = [&](double y, double radius) {
        return add_edge(result, ring(0, y, 0, radius));
    };
    const std::uint32_t foot = round(low, wide), brim = round(middle, wide),
                        outer = round(middle, thin + fillet), inner = round(middle + fillet, thin),
                        head = round(high, thin);
    add_face(result, bottom.surface(), {{ring_on(bottom, 0, 0, wide, foot, -errors.circles)}});
    add_face(result, shoulder.surface(),
             {{ring_on(shoulder, 0, 0, wide, brim, -errors.circles)},
              {ring_on(shoulder, 0, 0, thin + fillet, outer, errors.circles)}});
    add_face(result, top.surface(), {{ring_on(top, 0, 0, thin, head, -errors.circles)}});
    add_ring_face(result, wall_of(ring(0, low, 0, wide), middle - low), foot, brim);
    add_ring_face(result, wall_of(ring(0, middle + fillet, 0, thin), high - middle - fillet), inner,
                  head);
    const l3d_nurbs_curve quarter(
        l3d_bspline_direction::clamped(2, 3),
        {{thin + fillet, middle, 0.0}, {thin, middle, 0.0}, {thin, middle + fillet, 0.0}},
        {1, std::numbers::sqrt2 / 2, 1});
    add_ring_face(result, l3d_revolved(quarter), outer, inner);
    result.outside = [=](const vector& p) {
        const double r = off_axis(p, 0, 0), y = p[1];
        const double corner = std::max({r - thin - fillet, middle - y, y - middle - fillet});
        const double hollow = fillet - std::hypot(r - thin - fillet, y - middle - fillet);
        return std::min({cylinder(p, wide, low, middle), cylinder(p, thin, low, high),
                         std::max(corner, hollow)});
    };
    result.middle = {0.0, high / 2, 0.0};
    result.radius = std::hypot(wide, high / 2);
    return result;
}

solid drilled_ball(int spans, double distance) {
    solid result;
    const double radius = 0.35;
    const l3d_nurbs_surface ball = l3d_sphere_surfaces().at(0);
    const auto place = [=](double t, double side) {
        const double x = distance + radius * std::cos(2 * pi * t),
                     z = -radius * std::sin(2 * pi * t);
        return vector{x, side * std::sqrt(1 - x * x - z * z), z};
    };
    // The height along a meridian rises with v.
    const auto meridian = [&](double y) {
        return solved([&](double v) { return ball.evaluate(0, v)[1]; }, ball.v().from, ball.v().to,
                      y);
    };
    // Angles from the meridian that is opposite to the seam, so that none jumps on the far side.
    const bool is_near_seam = distance > 0;
    const auto on_ball = [&](double t, double side) {
        const vector p = place(t, side);
        const double angle = is_near_seam ? std::atan2(-p[2], p[0]) : pi + std::atan2(p[2], -p[0]);
        return vector{circle_parameter(angle), meridian(p[1]), 0.0};
    };
    std::array<std::uint32_t, 2> edges{};
    std::vector<std::vector<curve_use>> loops;
    const auto &u = ball.u(), &v = ball.v();
    std::vector<vector> seam;
    std::vector<double> seam_weights;
    for (std::size_t row = 0; row < v.points(); ++row) {
        seam.push_back(ball.points()[row * u.points()]);
        seam_weights.push_back(ball.weights()[row * u.points()]);
    }
    const std::uint32_t along_seam = add_edge(result, {v, seam, seam_weights});
    loops.push_back({{line(u.from, v.from, u.to, v.from), {}},
                     {line(u.to, v.from, u.to, v.to), {along_seam, v.from, v.to}},
                     {line(u.to, v.to, u.from, v.to), {}},
                     {line(u.from, v.to, u.from, v.from), {along_seam, v.to, v.from}}});
    for (const std::size_t k : {0U, 1U}) {
        const double side = k == 0 ? 1 : -1;
        edges[k] = add_edge(result, fitted([&](double t) { return place(t, side); }, spans), 1e-3);
        loops.push_back(
            {{fitted([&](double t) { return on_ball(t, side); }, spans), {edges[k], 0, 1}}});
    }
    add_face(result, ball, loops);
    // The wall turns as the ring does, downwards from 1 to -1.
    const l3d_nurbs_surface wall = wall_of(ring(distance, 1, 0, radius), -2);
    const auto on_wall = [&](double t, double side) {
        return vector{circle_parameter(2 * pi * t), (1 - place(t, side)[1]) / 2, 0.0};
    };
    const double high = on_wall(0, 1)[1], low = on_wall(0, -1)[1];
    const std::uint32_t along_wall =
        add_edge(result, l3d_nurbs_curve::polyline({place(0, 1), place(0, -1)}));
    const auto& up = result.edges[along_wall].curve.along();
    add_face(result, wall,
             {{{fitted([&](double t) { return on_wall(t, 1); }, spans), {edges[0], 0, 1}},
               {line(4, high, 4, low), {along_wall, up.from, up.to}},
               {fitted([&](double t) { return on_wall(1 - t, -1); }, spans), {edges[1], 1, 0}},
               {line(0, low, 0, high), {along_wall, up.to, up.from}}}});
    result.outside = [=](const vector& p) {
        return std::max(l3d_length(p) - 1, radius - off_axis(p, distance, 0));
    };
    return result;
}

solid capped_ball() {
    solid result;
    const double height = 0.6, radius = 0.8;
    const l3d_nurbs_surface ball = l3d_sphere_surfaces().at(0);
    const auto &u = ball.u(), &v = ball.v();
    const double at =
        solved([&](double t) { return ball.evaluate(0, t)[1]; }, v.from, v.to, height);
    const std::uint32_t rim = add_edge(result, ring(0, height, 0, radius));
    // What is below is on its left.
    add_face(result, ball, {{{line(u.to, at, u.from, at), {rim, 4, 0}}}});
    const level_plane top{height, 1, true};
    add_face(result, top.surface(), {{ring_on(top, 0, 0, radius, rim, 0)}});
    result.outside = [=](const vector& p) { return std::max(l3d_length(p) - 1, p[1] - height); };
    return result;
}

solid threaded_rod(int turns, int spans) {
    solid result;
    // The profile along the axis, by parts of the pitch: crest, flank, root, flank. It has flanks
    // of 31 degrees.
    constexpr double pitch = 0.6, root = 1, crest = 1.3;
    constexpr std::array at{0.0, 0.2, 0.5, 0.7, 1.0}, radius{crest, crest, root, root, crest};
    const double high = pitch * turns;
    const auto place = [=](double r, double turn, double y) {
        return vector{r * std::cos(2 * pi * turn), y, -r * std::sin(2 * pi * turn)};
    };
    // Helices run from turn -1 to `turns`, as the parameter goes from 0 to 1.
    const auto parameter = [=](double turn) { return (turn + 1) / (turns + 1); };
    const auto helix = [&](std::size_t k) {
        return fitted(
            [&](double t) {
                const double turn = t * (turns + 1) - 1;
                return place(radius[k], turn, pitch * (turn + at[k]));
            },
            spans * (turns + 1));
    };
    // Hermite's cubics are off a circle by h^4 / 384, and twice that with the edge's own.
    result.model_error = 2 * crest * std::pow(2 * pi / spans, 4) / 384;
    std::array<std::uint32_t, 4> winds{}, low_ends{}, high_ends{};
    for (std::size_t k = 0; k < 4; ++k) {
        const l3d_nurbs_curve whole = helix(k);
        l3d_bspline_direction along = whole.along();
        along.from = parameter(-at[k]);
        along.to = parameter(turns - at[k]);
        winds[k] = add_edge(result, {along, whole.points()}, result.model_error);
        const auto end = [&](double turn, double y) {
            const auto curve = [&, y, turn](double t) {
                return place(radius[k] + t * (radius[k + 1] - radius[k]),
                             turn - at[k] - t * (at[k + 1] - at[k]), y);
            };
            return add_edge(result, fitted(curve, spans), result.model_error);
        };
        low_ends[k] = end(0, 0);
        high_ends[k] = end(turns, high);
    }
    for (std::size_t k = 0; k < 4; ++k) {
        const std::size_t next = (k + 1) % 4;
        const double begin = parameter(-at[k]), end = parameter(turns - at[k]);
        const double next_begin = parameter(-at[k + 1]), next_end = parameter(turns - at[k + 1]);
        const auto& along = result.edges[winds[next]].curve.along();
        add_face(result, l3d_ruled(helix(k), helix(k + 1)),
                 {{{line(begin, 0, end, 0), {winds[k], begin, end}},
                   {line(end, 0, next_end, 1), {high_ends[k], 0, 1}},
                   {line(next_end, 1, next_begin, 1), {winds[next], along.to, along.from}},
                   {line(next_begin, 1, begin, 0), {low_ends[k], 1, 0}}}});
    }
    for (const bool is_high : {false, true}) {
        const level_plane plane{is_high ? high : 0, 1.1 * crest, is_high};
        std::vector<curve_use> loop;
        for (const std::uint32_t edge : is_high ? high_ends : low_ends)
            loop.push_back({plane.on(result.edges[edge].curve), {edge, 0, 1}});
        add_face(result, plane.surface(), {loop});
    }
    result.outside = [=](const vector& p) {
        constexpr double slope = (crest - root) / (0.3 * pitch), inner = root / 2;
        const double r = off_axis(p, 0, 0), ends = std::max(-p[1], p[1] - high);
        if (r < inner)
            return std::max(r - root, ends);
        const double turn = p[1] / pitch - std::atan2(-p[2], p[0]) / (2 * pi);
        const double part = turn - std::floor(turn);
        const double down = crest - slope * pitch * std::max(0.0, part - at[1]);
        const double up = crest - slope * pitch * (1 - std::max(at[3], part));
        const double surface = std::max({down, up, root});
        // Along the axis the radius changes by `slope`, and around it by less.
        const double around = slope * pitch / (2 * pi * inner);
        return std::max((r - surface) / std::sqrt(1 + slope * slope + around * around), ends);
    };
    result.middle = {0.0, high / 2, 0.0};
    result.radius = std::hypot(crest, high / 2);
    return result;
}
