// SPDX-License-Identifier: MIT
// obj_surfaces: reads connections of surfaces, whose trims become edges of the model.
#include "geom/files/obj_surfaces_p.h"
#include "geom/bezier_patch.h"
#include "geom/trims/trim_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

namespace l3d_detail {

namespace {

/// Brings a parameter into a surface's range. On a closed surface, the parameter wraps around.
double in_range(double at, const l3d_bspline_direction& along, bool is_closed) {
    const double period = along.to - along.from;
    if (is_closed)
        at -= std::floor((at - along.from) / period) * period;
    return std::clamp(at, along.from, along.to);
}

} // namespace

/// One side of a connection: a part of a trim curve of a surface.
struct obj_surfaces::connected {
    std::uint32_t surface = 0, curve = 0;
    double from = 0, to = 0; ///< the curve's parameters at the edge's beginning and end
};

bool obj_surfaces::read_connected(connected& side) {
    if (!text_.next_in_line())
        return text_.fail("the line ends where a surface of con should be");
    if (!obj_index(text_, text_.token(), surfaces_.size(), side.surface) ||
        !number_in_line(side.from, "the range of a curve") ||
        !number_in_line(side.to, "the range of a curve"))
        return false;
    if (side.from == side.to)
        return text_.fail("the range of a curve of con is empty");
    if (!text_.next_in_line())
        return text_.fail("the line ends where a curve of con should be");
    return obj_index(text_, text_.token(), trim_curves_.size(), side.curve);
}

/// Reads a connection of two surfaces along an edge. The edge lies where the first surface's trim
/// does.
bool obj_surfaces::read_connection() {
    if (open_ != opened::nothing)
        return text_.fail("a connection before the end of a surface or curve");
    std::array<connected, 2> sides;
    if (!read_connected(sides[0]) || !read_connected(sides[1]))
        return false;
    const auto edge = static_cast<std::uint32_t>(edges_.size());
    if (!follow(sides[0], edge) || !follow(sides[1], edge))
        return false;
    std::optional<l3d_model_edge> made = edge_along(sides[0]);
    if (!made)
        return text_.fail("the edge of con is a point, or beyond 1e12");
    edges_.push_back(*std::move(made));
    return takes(sizeof(std::array<double, 4>) * edges_.back().curve.points().size());
}

/// Makes the pieces of a trim curve follow an edge, whose parameter runs from 0 to 1.
bool obj_surfaces::follow(const connected& side, std::uint32_t edge) {
    const std::string name = "curve " + std::to_string(side.curve + 1) + " of surface " +
                             std::to_string(side.surface + 1);
    constexpr double rounding = 0x1p-30; // relative to the range
    const auto on_edge = [&](double t) { return (t - side.from) / (side.to - side.from); };
    bool is_found = false;
    const ended_surface& of = surfaces_[side.surface];
    for (std::size_t i = of.first_patch; i < of.end_patch; ++i)
        for (l3d_trim_loop& loop : patches_[i].trims)
            for (l3d_trim_curve& curve : loop) {
                if (curve.edge != (unconnected | side.curve))
                    continue;
                const double a = on_edge(curve.from), b = on_edge(curve.to);
                const double low = std::min(a, b), high = std::max(a, b);
                if (high <= rounding || low >= 1 - rounding)
                    continue;
                if (low < -rounding || high > 1 + rounding)
                    return text_.fail("con begins or ends between the knots of " + name);
                curve.edge = edge;
                curve.from = std::clamp(a, 0.0, 1.0);
                curve.to = std::clamp(b, 0.0, 1.0);
                is_found = true;
            }
    return is_found || text_.fail("con names a range of " + name +
                                  " that no trim has, or that another con has");
}

/// The edge in space that a trim curve makes. The edge has as many cubics as its accuracy takes;
/// each goes through four points of the surface.
std::optional<l3d_model_edge> obj_surfaces::edge_along(const connected& side) const {
    constexpr double wanted = 0x1p-30; // relative to the edge's extent
    constexpr std::size_t most_cubics = 1024, places = 16;
    const l3d_nurbs_surface& surface = *surfaces_[side.surface].whole;
    const l3d_nurbs_curve& curve = *trim_curves_[side.curve];
    const auto is_closed = l3d_closed_ways(surface);
    const auto at = [&](double t) {
        const l3d_bspline_direction& along = curve.along();
        const auto p =
            curve.evaluate(std::clamp(side.from + (side.to - side.from) * t, along.from, along.to));
        return surface.evaluate(in_range(p[0], surface.u(), is_closed[0]),
                                in_range(p[1], surface.v(), is_closed[1]));
    };
    // The curve may have corners at its knots.
    std::vector<double> stops{0, 1};
    for (const double knot : curve.along().knots)
        if (const double t = (knot - side.from) / (side.to - side.from); t > 0 && t < 1)
            stops.push_back(t);
    std::ranges::sort(stops);
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    for (std::size_t parts = 1;; parts *= 2) {
        l3d_bspline_direction along{3, {0}, 0, 1};
        std::vector<vector> points;
        double off = 0, extent = 0;
        for (std::size_t i = 0; i + 1 < stops.size(); ++i)
            for (std::size_t k = 0; k < parts; ++k) {
                const auto t = [&](double part) {
                    return stops[i] + (stops[i + 1] - stops[i]) * ((static_cast<double>(k) + part) /
                                                                   static_cast<double>(parts));
                };
                const vector a = at(t(0)), b = at(t(1.0 / 3)), c = at(t(2.0 / 3)), d = at(t(1));
                l3d_bezier_curve<double, 3> cubic{};
                cubic.points = {a, (a * -5.0 + b * 18.0 - c * 9.0 + d * 2.0) / 6.0,
                                (a * 2.0 - b * 9.0 + c * 18.0 - d * 5.0) / 6.0, d};
                along.knots.insert(along.knots.end(), 3, t(0));
                points.insert(points.end(), cubic.points.begin(), cubic.points.begin() + 3);
                for (std::size_t n = 1; n < places; ++n) {
                    const double part = static_cast<double>(n) / places;
                    off = std::max(off, l3d_length(at(t(part)) - cubic.evaluate(part)));
                }
                extent = std::max(extent, l3d_length(d - points.front()));
                extent = std::max(extent, l3d_length(b - points.front()));
            }
        points.push_back(at(1));
        along.knots.insert(along.knots.end(), {1, 1, 1, 1});
        if (off > wanted * extent && parts * stops.size() < most_cubics)
            continue;
        if (!(extent > 0) || !l3d_nurbs_curve::complaint(along, points, {}).empty())
            return std::nullopt;
        return l3d_model_edge{l3d_nurbs_curve(along, points), off};
    }
}

/// Lets trim curves that no connection names follow no edge.
void obj_surfaces::forget_unconnected() {
    for (l3d_patch_points& patch : patches_)
        for (l3d_trim_loop& loop : patch.trims)
            for (l3d_trim_curve& curve : loop)
                if (curve.edge != l3d_no_edge && (curve.edge & unconnected) != 0)
                    curve = {.points = std::move(curve.points)};
}

} // namespace l3d_detail
