// SPDX-License-Identifier: MIT
// obj_surfaces: Bezier and B-spline surfaces as knots and control points.
#include "geom/files/obj_surfaces_p.h"

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
    return word == "cstype" || word == "deg" || word == "surf" || word == "parm" || word == "end";
}

bool obj_surfaces::read_statement(std::string_view word, const std::vector<vector>& vertices,
                                  const std::vector<double>& weights) {
    if (word == "cstype")
        return read_kind();
    if (word == "deg")
        return read_degrees();
    if (word == "surf")
        return read_surface(vertices.size());
    if (is_open_)
        return word == "parm" ? read_parameters() : end_surface(vertices, weights);
    // The word belongs to a curve, which is skipped.
    while (text_.next_in_line())
        ;
    return true;
}

bool obj_surfaces::finish() {
    return !is_open_ || text_.fail("the text ends in a surface, before its end");
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

bool obj_surfaces::read_surface(std::size_t vertices) {
    if (is_open_)
        return text_.fail("a surface begins before the last one's end");
    if (kind_ == kind::none)
        return text_.fail("a surface before cstype");
    if (kind_ == kind::other)
        return text_.fail("a surface that is neither bezier nor bspline");
    if (degree_u_ == 0 || degree_v_ == 0)
        return text_.fail("a surface before deg with two degrees");
    u_ = {degree_u_, {}, 0, 0};
    v_ = {degree_v_, {}, 0, 0};
    indices_.clear();
    for (double* value : {&u_.from, &u_.to, &v_.from, &v_.to})
        if (!number_in_line(*value, "the range of a parameter"))
            return false;
    if (!(u_.from < u_.to && v_.from < v_.to))
        return text_.fail("the range of a parameter is empty");
    while (text_.next_in_line()) {
        const std::string_view digits = text_.token().substr(0, text_.token().find('/'));
        std::uint32_t& index = indices_.emplace_back();
        if (!obj_index(text_, digits, vertices, index))
            return false;
    }
    is_open_ = true;
    return true;
}

bool obj_surfaces::read_parameters() {
    if (!text_.next_in_line() || (text_.token() != "u" && text_.token() != "v"))
        return text_.fail("parm is followed by neither u nor v");
    l3d_bspline_direction& direction = text_.token() == "u" ? u_ : v_;
    if (!direction.knots.empty())
        return text_.fail("a second parm " + quoted(text_.token()) + " of a surface");
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

/// Makes a knot vector of what parm says, and sees that the range lies in it.
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
    // Where more than n knots are equal, the surface is torn; at the ends they only do nothing.
    for (std::size_t i = 1; i + n + 1 < d.knots.size(); ++i)
        if (d.knots[i] == d.knots[i + n] && d.knots[i] > d.knots[n] &&
            d.knots[i] < d.knots[d.points()])
            return complain(" has a knot more often than the degree");
    return (d.knots[n] <= d.from && d.to <= d.knots[d.points()]) ||
           complain(" does not cover the range of surf");
}

bool obj_surfaces::end_surface(const std::vector<vector>& vertices,
                               const std::vector<double>& weights) {
    is_open_ = false;
    if (!complete(u_, "u") || !complete(v_, "v"))
        return false;
    const auto points_u = static_cast<std::uint64_t>(u_.points());
    const auto points_v = static_cast<std::uint64_t>(v_.points());
    if (indices_.size() != points_u * points_v)
        return text_.fail("the surface has " + std::to_string(indices_.size()) +
                          " control points; its parameters ask for " + std::to_string(points_u) +
                          " by " + std::to_string(points_v));
    // A vertex takes at least 8 bytes ("v 0 0 0") and 2 more where it is named. It makes at most a
    // rational bicubic patch of 568 bytes. A text that asks for more names the same vertices again
    // and again.
    constexpr std::size_t most_per_byte = 48;
    const std::size_t per_patch =
        sizeof(l3d_patch_points) +
        sizeof(std::array<double, 4>) * static_cast<std::size_t>((degree_u_ + 1) * (degree_v_ + 1));
    patch_bytes_ += per_patch * u_.segments() * v_.segments();
    if (patch_bytes_ > most_per_byte * text_bytes_)
        return text_.fail("the surfaces take more than " + std::to_string(most_per_byte) +
                          " times the memory of the text");

    const auto weight = [&weights](std::uint32_t i) { return i < weights.size() ? weights[i] : 1; };
    std::vector<std::array<double, 3>> points;
    std::vector<double> weights_here;
    points.reserve(indices_.size());
    is_control_point_.resize(vertices.size());
    for (const std::uint32_t i : indices_) {
        if (is_rational_ && !(weight(i) > 0))
            return text_.fail("the weight of vertex " + std::to_string(i + 1) +
                              ", a control point, is not positive");
        if (is_rational_)
            weights_here.push_back(weight(i));
        points.push_back({vertices[i][0], vertices[i][1], vertices[i][2]});
        is_control_point_[i] = true;
    }
    std::vector<l3d_patch_points> patches = l3d_bezier_patches(u_, v_, points, weights_here);
    patches_.insert(patches_.end(), std::make_move_iterator(patches.begin()),
                    std::make_move_iterator(patches.end()));
    if (whole_ == nullptr)
        return true;
    std::vector<l3d_nurbs_surface::vector> places;
    for (const std::uint32_t i : indices_)
        places.push_back(vertices[i]);
    whole_->emplace_back(u_, v_, std::move(places), std::move(weights_here));
    return true;
}

} // namespace l3d_detail
