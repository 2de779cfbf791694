// SPDX-License-Identifier: MIT
// obj_surfaces: reads Bezier and B-spline surfaces and curves as knots and control points.
#include "geom/files/obj_surfaces_p.h"

#include "geom/trims/trim_region.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

namespace l3d_detail {

bool obj_index(text_cursor& text, std::string_view digits, std::size_t count,
               std::uint32_t& index) {
    std::int64_t number = 0;
    if (!text.integer_in_text(digits, number, "an index"))
        return false;
    const auto last = static_cast<std::int64_t>(count);
    if (number == 0 || number > last || number < -last)
        return text.fail(quoted(digits) + ", an index, names none of the " + std::to_string(count) +
                         " before it");
    index = static_cast<std::uint32_t>(number > 0 ? number - 1 : last + number);
    return true;
}

bool obj_surfaces::knows(std::string_view word) {
    constexpr std::string_view known[] = {"cstype", "deg", "surf",  "curv", "parm", "end",
                                          "l",      "vp",  "curv2", "trim", "hole", "con"};
    return std::ranges::find(known, word) != std::end(known);
}

bool obj_surfaces::read_statement(std::string_view word, const std::vector<vector>& vertices,
                                  const std::vector<double>& weights) {
    if (word == "cstype")
        return read_kind();
    if (word == "deg")
        return read_degrees();
    if (word == "surf")
        return read_surface(vertices.size());
    if (word == "curv")
        return read_curve(vertices.size());
    if (word == "l")
        return read_line(vertices);
    if (word == "vp")
        return read_parameter_vertex();
    if (word == "curv2")
        return read_trim_curve();
    if (word == "trim" || word == "hole")
        return read_trim(word == "hole");
    if (word == "con")
        return read_connection();
    if (open_ != opened::nothing)
        return word == "parm" ? read_parameters() : end(vertices, weights);
    // The word belongs to a curve that is skipped.
    while (text_.next_in_line())
        ;
    return true;
}

bool obj_surfaces::finish() {
    forget_unconnected();
    return open_ == opened::nothing ||
           text_.fail(std::string("the text ends in a ") +
                      (open_ == opened::surface ? "surface" : "curve") + ", before its end");
}

bool obj_surfaces::read_kind() {
    is_rational_ = text_.take_in_line("rat");
    if (!text_.next_in_line())
        return text_.fail("cstype names no type");
    const std::string_view name = text_.token();
    kind_ = name == "bezier" ? kind::bezier : name == "bspline" ? kind::bspline : kind::other;
    constexpr std::string_view others[] = {"bmatrix", "cardinal", "taylor"};
    return kind_ != kind::other || std::ranges::find(others, name) != std::end(others) ||
           text_.fail(quoted(name) + " is no type of curve or surface");
}

bool obj_surfaces::read_degrees() {
    // Curves have one degree.
    for (int* degree : {&degree_u_, &degree_v_}) {
        std::int64_t wide = 0;
        *degree = 0;
        if (!text_.next_in_line())
            return degree == &degree_v_ || text_.fail("deg names no degree");
        if (!text_.integer_in_text(text_.token(), wide, "a degree") ||
            !text_.is_in(wide, "a degree", 1, l3d_bpt_largest_degree))
            return false;
        *degree = static_cast<int>(wide);
    }
    return true;
}

bool obj_surfaces::number_in_line(double& value, const char* what) {
    if (!text_.next_in_line())
        return text_.fail("the line ends where " + std::string(what) + " should be");
    // Beyond the limit of coordinates, differences of knots times coordinates might overflow.
    return text_.number_in(text_.token(), value, what) && text_.is_coordinate(value);
}

bool obj_surfaces::read_range(l3d_bspline_direction& direction) {
    if (!number_in_line(direction.from, "the range of a parameter") ||
        !number_in_line(direction.to, "the range of a parameter"))
        return false;
    return direction.from < direction.to || text_.fail("the range of a parameter is empty");
}

/// Reads the control points of a surface or curve. Numbers after a slash are places in pictures,
/// and normals.
bool obj_surfaces::read_points(std::size_t vertices) {
    indices_.clear();
    while (text_.next_in_line()) {
        const std::string_view digits = text_.token().substr(0, text_.token().find('/'));
        std::uint32_t& index = indices_.emplace_back();
        if (!obj_index(text_, digits, vertices, index))
            return false;
    }
    return true;
}

bool obj_surfaces::read_surface(std::size_t vertices) {
    if (open_ != opened::nothing)
        return text_.fail("a surface begins before the last one's end");
    if (kind_ == kind::none)
        return text_.fail("a surface before cstype");
    if (kind_ == kind::other)
        return text_.fail("a surface that is neither bezier nor bspline");
    if (degree_u_ == 0 || degree_v_ == 0)
        return text_.fail("a surface before deg with two degrees");
    u_ = {degree_u_, {}, 0, 0};
    v_ = {degree_v_, {}, 0, 0};
    trims_.clear();
    has_outer_trim_ = false;
    open_ = opened::surface;
    return read_range(u_) && read_range(v_) && read_points(vertices);
}

bool obj_surfaces::read_curve(std::size_t vertices) {
    if (!begins_curve())
        return false;
    if (kind_ == kind::other) {
        text_.note_once("curves that are neither bezier nor bspline are skipped");
        while (text_.next_in_line())
            ;
        return true;
    }
    u_ = {degree_u_, {}, 0, 0};
    open_ = opened::curve;
    return read_range(u_) && read_points(vertices);
}

/// Checks that a curve may begin at this place of the text.
bool obj_surfaces::begins_curve() {
    if (open_ != opened::nothing)
        return text_.fail("a curve begins before the last one's end");
    if (kind_ == kind::none || degree_u_ == 0)
        return text_.fail(kind_ == kind::none ? "a curve before cstype" : "a curve before deg");
    return true;
}

/// Reads u, v and a weight. A missing v is 0, a missing weight is 1.
bool obj_surfaces::read_parameter_vertex() {
    std::array<double, 3>& p = parameter_vertices_.emplace_back(std::array<double, 3>{0, 0, 1});
    if (!number_in_line(p[0], "a parameter"))
        return false;
    for (std::size_t k = 1; k < 3; ++k)
        if (text_.next_in_line() &&
            (!text_.number_in(text_.token(), p[k], "a parameter") || !text_.is_coordinate(p[k])))
            return false;
    return true;
}

bool obj_surfaces::read_trim_curve() {
    if (!begins_curve())
        return false;
    if (kind_ == kind::other) {
        text_.note_once("curves that are neither bezier nor bspline are skipped");
        trim_curves_.emplace_back();
        while (text_.next_in_line())
            ;
        return true;
    }
    u_ = {degree_u_, {}, 0, 0};
    open_ = opened::trim_curve;
    return read_points(parameter_vertices_.size());
}

/// Reads the loop of a trim or of a hole: ranges of curves, each of which begins where the one
/// before ends.
bool obj_surfaces::read_trim(bool is_hole) {
    const std::string word = is_hole ? "hole" : "trim";
    if (open_ != opened::surface)
        return text_.fail(word + " outside of a surface");
    std::vector<l3d_nurbs_curve> curves;
    std::vector<l3d_edge_use> uses; // the curve in place of an edge, until con names that
    std::size_t points = 0;
    while (text_.next_in_line()) {
        l3d_bspline_direction range;
        std::uint32_t index = 0;
        if (!text_.number_in(text_.token(), range.from, "the range of a curve") ||
            !number_in_line(range.to, "the range of a curve"))
            return false;
        if (!(range.from < range.to))
            return text_.fail("the range of a curve of " + word + " is empty");
        if (!text_.next_in_line())
            return text_.fail("the line ends where a curve of " + word + " should be");
        if (!obj_index(text_, text_.token(), trim_curves_.size(), index))
            return false;
        const std::optional<l3d_nurbs_curve>& curve = trim_curves_[index];
        if (!curve)
            return text_.fail(word + " names a curve that is neither bezier nor bspline");
        l3d_bspline_direction along = curve->along();
        if (range.from < along.from || range.to > along.to)
            return text_.fail("the range of a curve of " + word + " is not within its parameters");
        along.from = range.from;
        along.to = range.to;
        points += along.segments() * static_cast<std::size_t>(along.degree + 1);
        if (!takes(sizeof(std::array<double, 3>) * points))
            return false;
        curves.emplace_back(along, curve->points(), curve->weights());
        uses.push_back({unconnected | index, range.from, range.to});
    }
    trims_.push_back(l3d_trim_loop_of(curves, uses));
    std::string why;
    has_outer_trim_ = has_outer_trim_ || !is_hole;
    // Whether the surface is closed is known only at its end. Until then it may be.
    const l3d_trim_box box{{u_.from, v_.from}, {u_.to, v_.to}};
    return l3d_unrolled(std::span(&trims_.back(), 1), box, {true, true}, why) || text_.fail(why);
}

bool obj_surfaces::read_line(const std::vector<vector>& vertices) {
    if (open_ != opened::nothing)
        return text_.fail("a line begins before the end of a surface or curve");
    if (!read_points(vertices.size()))
        return false;
    if (indices_.size() < 2) {
        text_.note_once("lines of fewer than two vertices are skipped");
        return true;
    }
    const std::vector<vector> points = places_of(vertices);
    const std::string why =
        l3d_nurbs_curve::complaint(l3d_bspline_direction::clamped(1, points.size()), points, {});
    if (!why.empty())
        return text_.fail(why);
    curves_.push_back(l3d_nurbs_curve::polyline(points));
    return true;
}

bool obj_surfaces::read_parameters() {
    const bool is_curve = open_ != opened::surface;
    if (!text_.next_in_line() || (text_.token() != "u" && (is_curve || text_.token() != "v")))
        return text_.fail(is_curve ? "parm of a curve is not followed by u"
                                   : "parm is followed by neither u nor v");
    l3d_bspline_direction& direction = text_.token() == "u" ? u_ : v_;
    if (!direction.knots.empty())
        return text_.fail("a second parm " + quoted(text_.token()) + " of a surface or curve");
    while (text_.next_in_line()) {
        double value = 0;
        if (!text_.number_in(text_.token(), value, "a parameter") || !text_.is_coordinate(value))
            return false;
        if (!direction.knots.empty() && value < direction.knots.back())
            return text_.fail(quoted(text_.token()) + ", a parameter, is less than the one before");
        direction.knots.push_back(value);
    }
    return true;
}

/// Makes a knot vector from the values of `parm`, and checks that the knots hold the surface's
/// range.
bool obj_surfaces::complete(l3d_bspline_direction& d, const char* name) {
    const auto n = static_cast<std::size_t>(d.degree);
    const auto complain = [&](const std::string& what) {
        return text_.fail("parm " + std::string(name) + what);
    };
    if (kind_ == kind::bezier) {
        if (d.knots.size() < 2)
            return complain(" has fewer than 2 parameters");
        // The same curve as a B-spline: each parameter n times, one more at both ends.
        std::vector<double> knots{d.knots.front()};
        knots.reserve(n * d.knots.size() + 2);
        for (const double knot : d.knots)
            knots.insert(knots.end(), n, knot);
        knots.push_back(d.knots.back());
        d.knots = std::move(knots);
    }
    if (d.knots.size() < 2 * (n + 1))
        return complain(" has fewer knots than twice the degree and 2");
    // More than n equal knots tear the surface, except at its ends, where they have no effect.
    for (std::size_t i = 1; i + n + 1 < d.knots.size(); ++i)
        if (d.knots[i] == d.knots[i + n] && d.knots[i] > d.knots[n] &&
            d.knots[i] < d.knots[d.points()])
            return complain(" has a knot more often than the degree");
    return (d.knots[n] <= d.from && d.to <= d.knots[d.points()]) ||
           complain(" does not cover the range of surf");
}

bool obj_surfaces::end(const std::vector<vector>& vertices, const std::vector<double>& weights) {
    switch (std::exchange(open_, opened::nothing)) {
    case opened::curve:
        return end_curve(vertices, weights);
    case opened::trim_curve:
        return end_trim_curve();
    default:
        return end_surface(vertices, weights);
    }
}

/// Counts memory that the model takes. Fails if this is more memory than different vertices of the
/// text could need. A vertex takes at least 8 bytes of text ("v 0 0 0"), and 2 more bytes where it
/// is named. A vertex makes at most a rational bicubic patch of 568 bytes. A text that asks for
/// more memory names the same vertices again and again.
bool obj_surfaces::takes(std::size_t bytes) {
    constexpr std::size_t most_per_byte = 48;
    patch_bytes_ += bytes;
    return patch_bytes_ <= most_per_byte * text_bytes_ ||
           text_.fail("the surfaces and curves take more than " + std::to_string(most_per_byte) +
                      " times the memory of the text");
}

/// Finds the weights of the control points, if the type is rational. Missing weights are 1.
bool obj_surfaces::weights_of(const std::vector<double>& weights, std::vector<double>& of_points) {
    for (const std::uint32_t i : indices_) {
        const double weight = i < weights.size() ? weights[i] : 1;
        if (is_rational_ &&
            !text_.is_weight(weight, "the weight of vertex " + std::to_string(i + 1) +
                                         ", a control point,"))
            return false;
        if (is_rational_)
            of_points.push_back(weight);
    }
    return true;
}

std::vector<obj_surfaces::vector> obj_surfaces::places_of(const std::vector<vector>& vertices) {
    std::vector<vector> places;
    places.reserve(indices_.size());
    is_control_point_.resize(vertices.size());
    for (const std::uint32_t i : indices_) {
        places.push_back(vertices[i]);
        is_control_point_[i] = true;
    }
    return places;
}

bool obj_surfaces::end_curve(const std::vector<vector>& vertices,
                             const std::vector<double>& weights) {
    if (!complete(u_, "u"))
        return false;
    if (indices_.size() != u_.points())
        return text_.fail("the curve has " + std::to_string(indices_.size()) +
                          " control points; its parameters ask for " + std::to_string(u_.points()));
    std::vector<double> of_points;
    if (!takes(sizeof(std::array<double, 4>) * static_cast<std::size_t>(degree_u_ + 1) *
               u_.segments()) ||
        !weights_of(weights, of_points))
        return false;
    std::vector<vector> points = places_of(vertices);
    const std::string why = l3d_nurbs_curve::complaint(u_, points, of_points);
    if (!why.empty())
        return text_.fail(why);
    curves_.emplace_back(u_, std::move(points), std::move(of_points));
    return true;
}

bool obj_surfaces::end_trim_curve() {
    // The range is all that has enough control points.
    const auto n = static_cast<std::size_t>(u_.degree);
    if (u_.knots.size() >= 2) {
        u_.from =
            kind_ == kind::bezier ? u_.knots.front() : u_.knots[std::min(n, u_.knots.size() - 1)];
        u_.to = kind_ == kind::bezier
                    ? u_.knots.back()
                    : u_.knots[u_.knots.size() - 1 - std::min(n, u_.knots.size() - 1)];
    }
    if (!complete(u_, "u"))
        return false;
    if (indices_.size() != u_.points())
        return text_.fail("the curve has " + std::to_string(indices_.size()) +
                          " control points; its parameters ask for " + std::to_string(u_.points()));
    if (!takes(sizeof(std::array<double, 4>) * indices_.size()))
        return false;
    std::vector<vector> points;
    std::vector<double> weights;
    for (const std::uint32_t i : indices_) {
        const auto& [u, v, weight] = parameter_vertices_[i];
        points.push_back({u, v, 0.0});
        if (is_rational_)
            weights.push_back(weight);
    }
    const std::string why = l3d_nurbs_curve::complaint(u_, points, weights);
    if (!why.empty())
        return text_.fail(why);
    trim_curves_.emplace_back(std::in_place, u_, std::move(points), std::move(weights));
    return true;
}

/// Gives each piece of a surface the parts of the loops that matter in this piece. If all loops are
/// holes, they are cut out of the whole surface.
bool obj_surfaces::put_trims(std::span<l3d_patch_points> patches) {
    if (trims_.empty())
        return true;
    if (!has_outer_trim_)
        trims_.push_back(l3d_trim_around({{u_.from, v_.from}, {u_.to, v_.to}}));
    const auto in_u = l3d_spans_of(u_), in_v = l3d_spans_of(v_);
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto [u0, u1] = in_u[i % in_u.size()];
        const auto [v0, v1] = in_v[i / in_u.size()];
        patches[i].trims = l3d_trims_in(trims_, {{u0, v0}, {u1, v1}});
        std::size_t bytes = 0;
        for (const l3d_trim_loop& loop : patches[i].trims)
            for (const l3d_trim_curve& curve : loop)
                bytes += sizeof curve + sizeof(curve.points[0]) * curve.points.size();
        if (!takes(bytes))
            return false;
    }
    return true;
}

bool obj_surfaces::end_surface(const std::vector<vector>& vertices,
                               const std::vector<double>& weights) {
    if (!complete(u_, "u") || !complete(v_, "v"))
        return false;
    const auto points_u = static_cast<std::uint64_t>(u_.points());
    const auto points_v = static_cast<std::uint64_t>(v_.points());
    if (indices_.size() != points_u * points_v)
        return text_.fail("the surface has " + std::to_string(indices_.size()) +
                          " control points; its parameters ask for " + std::to_string(points_u) +
                          " by " + std::to_string(points_v));
    const std::size_t per_patch =
        sizeof(l3d_patch_points) +
        sizeof(std::array<double, 4>) * static_cast<std::size_t>((degree_u_ + 1) * (degree_v_ + 1));
    std::vector<double> weights_here;
    if (!takes(per_patch * u_.segments() * v_.segments()) || !weights_of(weights, weights_here))
        return false;
    std::vector<vector> places = places_of(vertices);
    std::vector<std::array<double, 3>> points;
    points.reserve(places.size());
    for (const vector& p : places)
        points.push_back({p[0], p[1], p[2]});
    std::vector<l3d_patch_points> patches = l3d_bezier_patches(u_, v_, points, weights_here);
    if (!trims_.empty()) {
        std::string why;
        auto unrolled = l3d_unrolled(trims_, {{u_.from, v_.from}, {u_.to, v_.to}},
                                     l3d_closed_ways({u_, v_, places, weights_here}), why);
        if (!unrolled)
            return text_.fail(why);
        trims_ = *std::move(unrolled);
    }
    if (!put_trims(patches))
        return false;
    ended_surface& ended = surfaces_.emplace_back();
    ended.first_patch = patches_.size();
    ended.end_patch = patches_.size() + patches.size();
    if (!trims_.empty()) {
        if (!takes(sizeof(std::array<double, 4>) * places.size()))
            return false;
        ended.whole.emplace(u_, v_, places, weights_here);
    }
    patches_.insert(patches_.end(), std::make_move_iterator(patches.begin()),
                    std::make_move_iterator(patches.end()));
    for (l3d_trim_loop& loop : trims_)
        for (l3d_trim_curve& curve : loop)
            curve = {.points = std::move(curve.points)};
    if (whole_ != nullptr)
        whole_->push_back(
            l3d_nurbs_surface(u_, v_, std::move(places), std::move(weights_here)).trimmed(trims_));
    return true;
}

} // namespace l3d_detail
