// SPDX-License-Identifier: MIT
// face_writer: finds the borders of faces, and writes their edges and curves in the plane of
// parameters.
#include "faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <BRepTools.hxx>
#include <BRepTools_WireExplorer.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <GeomAPI.hxx>
#include <GeomAdaptor_Surface.hxx>
#include <Geom2d_Curve.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <gp_Pln.hxx>

namespace cad {

namespace {

using l3d_detail::cad_record;

constexpr std::uint32_t no_edge = 0xffffffff; // l3d_no_edge
/// The error of trimming curves in the plane of parameters. It is a share of the range that the
/// face has in this plane.
constexpr double trim_share = 1e-9;
/// A line closes a gap between a loop's curves that is wider than this share of the loop's extent.
/// The library l3d allows gaps of 2^-20 of the extent (l3d_trims_complaint).
constexpr double gap_share = 0x1p-22;
/// The farthest that a trimming curve may reach beyond its surface's parameters, in multiples of
/// the face's range. Curves of sound files reach beyond only by rounding, or by a period. Farther
/// away, doubles give places no more exactly than trim_share.
constexpr double most_ranges_beyond = 0x1p12;
/// The most turns of a surface about its axis, as for a screw's thread. A thread of so many turns
/// takes some 10^4 pieces.
constexpr double most_turns = 0x1p12;

using place_2d = std::array<double, 2>;

/// The parameters at which a curve in the plane of parameters is divided. There, the curve is not
/// smooth, or passes from one arc of the surface's parameter_maps to the next arc.
std::vector<double> breaks_of(const rational_curve& flat, const Handle(Geom2d_Curve) & curve,
                              const rational_surface& surface, const direction* edge, double from,
                              double to) {
    std::vector<double> breaks{from, to};
    const auto add = [&](double s) {
        if (s > from && s < to)
            breaks.push_back(s);
    };
    if (flat.along.map.is_same())
        std::ranges::for_each(flat.along.knots, add);
    if (edge)
        std::ranges::for_each(edge->map.ends(), add);
    std::ranges::sort(breaks);
    constexpr int places = 16; // for each smooth stretch; no curve in a file oscillates more often
    const std::vector<double> smooth = breaks;
    for (std::size_t k = 0; k < 2; ++k)
        for (const double end : (k == 0 ? surface.u : surface.v).map.ends())
            for (std::size_t i = 0; i + 1 < smooth.size(); ++i)
                for (int j = 0; j < places; ++j) {
                    const auto beyond = [&](double s) {
                        const gp_Pnt2d p = curve->Value(s);
                        return (k == 0 ? p.X() : p.Y()) - end;
                    };
                    double low = smooth[i] + (smooth[i + 1] - smooth[i]) * j / places;
                    double high = smooth[i] + (smooth[i + 1] - smooth[i]) * (j + 1) / places;
                    const double sign = beyond(low);
                    if (!(sign * beyond(high) < 0))
                        continue;
                    for (int halvings = 0; halvings < 50; ++halvings) {
                        const double middle = (low + high) / 2;
                        (sign * beyond(middle) > 0 ? low : high) = middle;
                    }
                    add(low);
                }
    std::ranges::sort(breaks);
    const double least = 1e-9 * (to - from);
    std::vector<double> result{from};
    for (const double s : breaks)
        if (s - result.back() > least && to - s > least)
            result.push_back(s);
    result.push_back(to);
    return result;
}

/// The control points of a Bezier curve of degree 5. The curve passes through six given places, at
/// equal steps of its parameter.
std::vector<point> through(const std::array<place_2d, 6>& at) {
    // The inverse of the Bernstein polynomials' values at i / 5; rows below the middle mirror them.
    static constexpr double row_1[6] = {-77.0 / 60, 5, -5, 10.0 / 3, -5.0 / 4, 1.0 / 5};
    static constexpr double row_2[6] = {269.0 / 240, -145.0 / 24, 295.0 / 24,
                                        -115.0 / 12, 185.0 / 48,  -77.0 / 120};
    std::vector<point> result(6, point{0, 0, 0, 1});
    for (std::size_t k = 0; k < 2; ++k) {
        result[0][k] = at[0][k];
        result[5][k] = at[5][k];
        for (std::size_t i = 0; i < 6; ++i) {
            result[1][k] += row_1[i] * at[i][k];
            result[2][k] += row_2[i] * at[i][k];
            result[3][k] += row_2[i] * at[5 - i][k];
            result[4][k] += row_1[i] * at[5 - i][k];
        }
    }
    return result;
}

place_2d value(const std::vector<point>& bezier, double t) {
    std::vector<point> p = bezier;
    for (std::size_t left = p.size() - 1; left > 0; --left)
        for (std::size_t i = 0; i < left; ++i)
            for (std::size_t k = 0; k < 2; ++k)
                p[i][k] += t * (p[i + 1][k] - p[i][k]);
    return {p[0][0], p[0][1]};
}

rational_curve bezier(std::vector<point> points) {
    rational_curve result;
    result.along.degree = static_cast<int>(points.size()) - 1;
    result.along.knots.assign(points.size(), 0);
    result.along.knots.insert(result.along.knots.end(), points.size(), 1);
    result.points = std::move(points);
    return result;
}

/// The box around control points of curves in the plane of parameters.
struct hull {
    rectangle box{std::numeric_limits<double>::max(), -std::numeric_limits<double>::max(),
                  std::numeric_limits<double>::max(), -std::numeric_limits<double>::max()};

    void add(const std::vector<point>& points) {
        for (const point& p : points) {
            box.u0 = std::min(box.u0, p[0]);
            box.u1 = std::max(box.u1, p[0]);
            box.v0 = std::min(box.v0, p[1]);
            box.v1 = std::max(box.v1, p[1]);
        }
    }
    double extent() const { return std::max(box.u1 - box.u0, box.v1 - box.v0); }
};

/// The diagonal of the box around control points.
double size_of(const std::vector<point>& points) {
    Bnd_Box box;
    for (const point& p : points)
        box.Add(gp_Pnt(p[0], p[1], p[2]));
    return std::sqrt(box.SquareExtent());
}

/// Fits a face's range of one parameter, u or v, into the surface's range. `low` and `high` are the
/// range's ends, as hulls of the face's curves give them. If the parameter turns about an axis
/// (`is_turn`), the range may be longer than one period, as for a screw's thread.
void fit(double& low, double& high, const std::array<double, 2>& optimal, double period,
         bool is_turn, double first, double last) {
    if (period == 0) {
        low = std::max(low, first);
        high = std::min(high, last);
        return;
    }
    constexpr double rounding = 1e-9; // the kernel's own precision of angles
    if (high - low > period * most_turns)
        throw Standard_Failure("it turns more than 4096 times about its axis");
    if (!is_turn && high - low > period * (1 + rounding)) {
        low = std::max(low, optimal[0]);
        high = std::min({high, optimal[1], low + period});
    }
    if (std::abs(high - low - period) < period * rounding)
        high = low + period;
}

} // namespace

struct face_writer::edge_use {
    TopoDS_Edge edge;
    Handle(Geom2d_Curve) curve;
    double from = 0, to = 1;
    rational_curve flat;

    bool is_reversed() const { return edge.Orientation() == TopAbs_REVERSED; }
    place_2d end(bool last) const {
        const point& p = last != is_reversed() ? flat.points.back() : flat.points.front();
        return {p[0], p[1]};
    }

    edge_use(const TopoDS_Edge& of, const TopoDS_Face& face) : edge(of) {
        curve = BRep_Tool::CurveOnSurface(edge, face, from, to);
        if (curve.IsNull())
            throw Standard_Failure("an edge has no curve in the plane of parameters");
        flat = rational_of(GeomAPI::To3d(curve, gp_Pln()), from, to);
    }

    /// The edges of a wire, in order. Each edge begins where the edge before it ends.
    static std::vector<edge_use> all_of(const TopoDS_Wire& wire, const TopoDS_Face& face) {
        std::vector<edge_use> result;
        std::size_t count = 0;
        for (TopoDS_Iterator each(wire); each.More(); each.Next())
            count += each.Value().Orientation() == TopAbs_FORWARD ||
                     each.Value().Orientation() == TopAbs_REVERSED;
        for (BRepTools_WireExplorer each(wire, face); each.More(); each.Next())
            result.emplace_back(each.Current(), face);
        if (result.size() == count)
            return result;
        // The explorer stops where edges do not meet. Then the nearest edge is the next.
        std::vector<edge_use> left;
        for (TopoDS_Iterator each(wire); each.More(); each.Next())
            if (each.Value().Orientation() == TopAbs_FORWARD ||
                each.Value().Orientation() == TopAbs_REVERSED)
                left.emplace_back(TopoDS::Edge(each.Value()), face);
        result.clear();
        while (!left.empty()) {
            auto next = left.begin();
            if (!result.empty()) {
                const place_2d at = result.back().end(true);
                const auto distance = [&](const edge_use& use) {
                    const place_2d p = use.end(false);
                    return std::hypot(p[0] - at[0], p[1] - at[1]);
                };
                next = std::ranges::min_element(left, {}, distance);
            }
            result.push_back(*next);
            left.erase(next);
        }
        return result;
    }
};

const face_writer::known_edge* face_writer::known(const TopoDS_Edge& edge) {
    const auto index = static_cast<std::size_t>(edges_.Add(edge)) - 1;
    if (index == known_.size()) {
        known_.push_back({no_edge, {}});
        double from = 0, to = 1;
        const Handle(Geom_Curve) curve =
            BRep_Tool::Degenerated(edge) ? nullptr : BRep_Tool::Curve(edge, from, to);
        if (!curve.IsNull()) {
            const rational_curve exact = rational_of(curve, from, to);
            to_.begin(cad_record::edge);
            to_.number(BRep_Tool::Tolerance(edge));
            put(exact);
            known_.back() = {written_++, exact.along};
        }
    }
    return known_[index].number == no_edge ? nullptr : &known_[index];
}

face_writer::loop face_writer::trims_of(const edge_use& use, const rational_surface& surface) {
    const known_edge* const edge = known(use.edge);
    const std::uint32_t number = edge ? edge->number : no_edge;
    const parameter_map map = edge ? edge->along.map : parameter_map();
    loop result;
    const bool is_linear = surface.u.map.is_same() && surface.v.map.is_same();
    if (is_linear && (!edge || use.flat.along.map == map))
        result.push_back({number, map(use.from), map(use.to), use.flat});
    else {
        const double wide = trim_share * (surface.u.to() - surface.u.from()),
                     high = trim_share * (surface.v.to() - surface.v.from());
        const auto is_near = [&](const place_2d& a, const place_2d& b) {
            return std::abs(a[0] - b[0]) <= wide && std::abs(a[1] - b[1]) <= high;
        };
        const auto place = [&](double t) -> place_2d {
            const gp_Pnt2d p = use.curve->Value(map.inverse(t));
            return {surface.u.map(p.X()), surface.v.map(p.Y())};
        };
        const auto add = [&](auto&& again, double from, double to, int depth) -> void {
            std::array<place_2d, 6> at;
            for (std::size_t i = 0; i < 6; ++i)
                at[i] = place(from + (to - from) * static_cast<double>(i) / 5);
            const std::vector<point> line{{at[0][0], at[0][1], 0, 1}, {at[5][0], at[5][1], 0, 1}};
            bool is_line = true, is_close = true;
            const std::vector<point> curved = through(at);
            for (std::size_t i = 0; i < 5; ++i) {
                const double t = (static_cast<double>(i) + 0.5) / 5;
                const place_2d exact = place(from + (to - from) * t);
                is_line = is_line && is_near(value(line, t), exact) &&
                          is_near(value(line, static_cast<double>(i) / 5), at[i]);
                is_close = is_close && is_near(value(curved, t), exact);
            }
            constexpr int most_depth = 10; // an error of degree 6 is below 2^-60 of the first one
            if (is_line || is_close || depth == most_depth) {
                result.push_back({number, from, to, bezier(is_line ? line : curved)});
                return;
            }
            const double middle = (from + to) / 2;
            again(again, from, middle, depth + 1);
            again(again, middle, to, depth + 1);
        };
        const auto breaks = breaks_of(use.flat, use.curve, surface, edge ? &edge->along : nullptr,
                                      use.from, use.to);
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
            add(add, map(breaks[i]), map(breaks[i + 1]), 0);
    }
    if (use.is_reversed()) {
        std::ranges::reverse(result);
        for (trim& each : result) {
            std::swap(each.from, each.to);
            each.curve = each.curve.reversed();
        }
    }
    return result;
}

void face_writer::write(const TopoDS_Face& face) {
    ++faces_;
    std::string why;
    try {
        write_surface(face);
        return;
    } catch (const Standard_Failure& failure) {
        why = failure.GetMessageString();
        if (why.empty())
            why = failure.DynamicType()->Name();
    }
    to_.begin(cad_record::note);
    to_.text("face " + std::to_string(faces_) + " is left out: " + why);
}

void face_writer::write_surface(const TopoDS_Face& located) {
    const TopoDS_Face face = TopoDS::Face(located.Oriented(TopAbs_FORWARD));
    const Handle(Geom_Surface) shape = BRep_Tool::Surface(face);
    if (shape.IsNull())
        throw Standard_Failure("it has no surface");
    std::vector<std::vector<edge_use>> wires;
    hull bounds;
    for (TopExp_Explorer each(face, TopAbs_WIRE); each.More(); each.Next()) {
        const TopAbs_Orientation side = each.Current().Orientation();
        if (side != TopAbs_FORWARD && side != TopAbs_REVERSED)
            continue;
        auto uses = edge_use::all_of(TopoDS::Wire(each.Current()), face);
        for (const edge_use& use : uses)
            bounds.add(use.flat.points);
        if (!uses.empty())
            wires.push_back(std::move(uses));
    }
    rectangle nearest{};
    BRepTools::UVBounds(face, nearest.u0, nearest.u1, nearest.v0, nearest.v1);
    rectangle box = wires.empty() ? nearest : bounds.box;
    const GeomAdaptor_Surface known_shape(shape);
    const GeomAbs_SurfaceType kind = known_shape.GetType();
    const bool turns_twice = kind == GeomAbs_Torus;
    const bool turns = turns_twice || kind == GeomAbs_Cylinder || kind == GeomAbs_Cone ||
                       kind == GeomAbs_Sphere || kind == GeomAbs_SurfaceOfRevolution;
    fit(box.u0, box.u1, {nearest.u0, nearest.u1},
        known_shape.IsUPeriodic() ? known_shape.UPeriod() : 0, turns, known_shape.FirstUParameter(),
        known_shape.LastUParameter());
    fit(box.v0, box.v1, {nearest.v0, nearest.v1},
        known_shape.IsVPeriodic() ? known_shape.VPeriod() : 0, turns_twice,
        known_shape.FirstVParameter(), known_shape.LastVParameter());
    for (const double end : {box.u0, box.u1, box.v0, box.v1})
        if (Precision::IsInfinite(end))
            throw Standard_Failure("it has no end");
    if (!(box.u0 < box.u1 && box.v0 < box.v1))
        throw Standard_Failure("it is empty");
    const double wide = most_ranges_beyond * (box.u1 - box.u0);
    const double high = most_ranges_beyond * (box.v1 - box.v0);
    if (!wires.empty() && !(box.u0 - bounds.box.u0 <= wide && bounds.box.u1 - box.u1 <= wide &&
                            box.v0 - bounds.box.v0 <= high && bounds.box.v1 - box.v1 <= high))
        throw Standard_Failure("its trims are far outside of its surface");
    rational_surface surface = rational_of(shape, box);
    for (const auto& wire : wires)
        for (const edge_use& use : wire)
            if (!(BRep_Tool::Tolerance(use.edge) <= size_of(surface.points)))
                throw Standard_Failure("an edge's tolerance is more than the size of the face");

    std::vector<loop> loops;
    for (const auto& wire : wires) {
        hull extent;
        loop pieces;
        for (const edge_use& use : wire)
            for (trim& piece : trims_of(use, surface)) {
                extent.add(piece.curve.points);
                pieces.push_back(std::move(piece));
            }
        loop& closed = loops.emplace_back();
        const point first = pieces.front().curve.points.front();
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const point end = pieces[i].curve.points.back();
            const point next = i + 1 < pieces.size() ? pieces[i + 1].curve.points.front() : first;
            const double gap = std::max(std::abs(next[0] - end[0]), std::abs(next[1] - end[1]));
            const bool gapes = gap > gap_share * extent.extent();
            std::vector<point> line{end, next};
            closed.push_back(std::move(pieces[i]));
            if (gapes) {
                line[0][3] = line[1][3] = 1;
                closed.push_back({no_edge, 0, 1, bezier(std::move(line))});
            }
        }
    }
    const bool is_inside_out = located.Orientation() == TopAbs_REVERSED;
    if (is_inside_out)
        surface = surface.exchanged();
    approximate_ += surface.is_approximate;
    to_.begin(cad_record::face);
    for (const direction* along : {&surface.u, &surface.v}) {
        to_.count(static_cast<std::uint64_t>(along->degree));
        to_.numbers(along->knots);
    }
    put_points(surface.points);
    to_.count(loops.size());
    for (loop& each : loops) {
        to_.count(each.size());
        for (trim& piece : each) {
            if (is_inside_out)
                for (point& p : piece.curve.points)
                    std::swap(p[0], p[1]);
            to_.count(piece.edge);
            to_.number(piece.from);
            to_.number(piece.to);
            put(piece.curve);
        }
    }
}

void face_writer::write_curve(const TopoDS_Edge& edge) {
    double from = 0, to = 1;
    const Handle(Geom_Curve) curve =
        BRep_Tool::Degenerated(edge) ? nullptr : BRep_Tool::Curve(edge, from, to);
    if (curve.IsNull() || Precision::IsInfinite(from) || Precision::IsInfinite(to))
        return;
    const rational_curve exact = rational_of(curve, from, to);
    to_.begin(cad_record::curve);
    put(exact);
}

void face_writer::put(const rational_curve& curve) {
    to_.count(static_cast<std::uint64_t>(curve.along.degree));
    to_.numbers(curve.along.knots);
    put_points(curve.points);
}

void face_writer::put_points(const std::vector<point>& points) {
    std::vector<double> numbers;
    numbers.reserve(points.size() * 4);
    for (const point& p : points)
        numbers.insert(numbers.end(), p.begin(), p.end());
    to_.numbers(numbers);
}

void face_writer::finish() {
    if (approximate_ == 0)
        return;
    to_.begin(cad_record::note);
    to_.text(std::to_string(approximate_) + " of " + std::to_string(faces_) +
             " faces are no rational surfaces; they are approximated to 1e-6 mm");
}

} // namespace cad
