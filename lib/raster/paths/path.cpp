// SPDX-License-Identifier: MIT
// l3d_path: turns every curve into a rational cubic.
#include "raster/paths/path.h"

#include "geom/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

void l3d_path::move_to(l3d_point_2d to) {
    kinds_.push_back(kind::move);
    points_.push_back(to);
    first_ = last_ = to;
    open_ = true;
}

/// Begins an outline if none is open. After close, the new outline begins where the closed one
/// began.
void l3d_path::begin_if_needed() {
    if (!open_)
        move_to(first_);
}

void l3d_path::line_to(l3d_point_2d to) {
    begin_if_needed();
    kinds_.push_back(kind::line);
    points_.push_back(to);
    last_ = to;
}

void l3d_path::quadratic_to(l3d_point_2d control, l3d_point_2d to) {
    begin_if_needed();
    const auto third = [&control](l3d_point_2d end) {
        return l3d_point_2d{end.x / 3 + control.x * 2 / 3, end.y / 3 + control.y * 2 / 3};
    };
    cubic_to(third(last_), third(to), to);
}

void l3d_path::cubic_to(l3d_point_2d first, l3d_point_2d second, l3d_point_2d to) {
    rational_to({first, second, to}, {1, 1, 1});
}

void l3d_path::rational_to(const std::array<l3d_point_2d, 3>& points,
                           const std::array<double, 3>& weights) {
    begin_if_needed();
    kinds_.push_back(kind::curve);
    points_.insert(points_.end(), points.begin(), points.end());
    // a curve that begins with the weight 1 must keep the weight at its end
    weights_.insert(weights_.end(), weights.begin(), weights.end());
    last_ = points[2];
}

/// Adds arcs of at most a quarter each. Such an arc is the rational quadratic with control points
/// a, b, c and weights 1, w, 1. Here b is where the tangents meet, and w the cosine of half the
/// angle. As a cubic, its inner points have the weight (1 + 2 w) / 3. They are (a + 2 w b) / (1 + 2
/// w) and (2 w b + c) / (1 + 2 w).
void l3d_path::arc_to(l3d_point_2d center, l3d_point_2d radii, double turn, double begin,
                      double sweep) {
    const auto [cosine, sine] = l3d_turn_by(turn);
    const auto placed = [&, cosine = cosine, sine = sine](l3d_point_2d on_circle) {
        const double x = radii.x * on_circle.x, y = radii.y * on_circle.y;
        return l3d_point_2d{center.x + cosine * x - sine * y, center.y + sine * x + cosine * y};
    };
    const auto direction = [](double degrees) {
        const l3d_turn at = l3d_turn_by(degrees);
        return l3d_point_2d{at.cosine, at.sine};
    };
    l3d_point_2d from = direction(begin);
    const l3d_point_2d start = placed(from);
    if (!open_)
        move_to(start);
    else if (start.x != last_.x || start.y != last_.y)
        line_to(start);
    // If the sweep is not a number, std::min gives 60 000, which an integer can hold.
    const double bounded = std::min(60000.0, std::abs(sweep));
    const int pieces = std::max(1, static_cast<int>(std::ceil(bounded / 90 - 1e-9)));
    const double half = sweep / pieces / 2, weight = direction(half).x;
    const double tangent = direction(half).y / weight;
    const double sum = 1 + 2 * weight;
    const auto inner = [&](l3d_point_2d end, l3d_point_2d middle) {
        return l3d_point_2d{(end.x + 2 * weight * middle.x) / sum,
                            (end.y + 2 * weight * middle.y) / sum};
    };
    for (int i = 0; i < pieces; ++i) {
        const l3d_point_2d to = direction(begin + (2 * i + 1) * half + half);
        const l3d_point_2d middle = placed({from.x - tangent * from.y, from.y + tangent * from.x});
        const l3d_point_2d end = placed(to);
        rational_to({inner(last_, middle), inner(end, middle), end}, {sum / 3, sum / 3, 1});
        from = to;
    }
}

/// Adds four arcs of a quarter each, whose ends need no sines. With w the cosine of an eighth of a
/// turn, inner points are 2 w / (1 + 2 w) = 2 - sqrt 2 along the tangents.
void l3d_path::add_circle(l3d_point_2d center, double radius) {
    constexpr double along = 2 - std::numbers::sqrt2, weight = (1 + std::numbers::sqrt2) / 3;
    const auto at = [&](double x, double y) {
        return l3d_point_2d{center.x + radius * x, center.y + radius * y};
    };
    double x = 1, y = 0;
    move_to(at(x, y));
    for (int quarter = 0; quarter < 4; ++quarter) {
        rational_to({at(x - along * y, y + along * x), at(along * x - y, along * y + x), at(-y, x)},
                    {weight, weight, 1});
        x = -std::exchange(y, x);
    }
    close();
}

void l3d_path::close() {
    if (!open_)
        return;
    kinds_.push_back(kind::close);
    last_ = first_;
    open_ = false;
}

void l3d_path::add_box(const l3d_pixel_box& box) {
    if (box.empty())
        return;
    const double left = box.left - 0.5, top = box.top - 0.5;
    const double right = box.right - 0.5, bottom = box.bottom - 0.5;
    add_polygon(
        std::array<l3d_point_2d, 4>{{{left, top}, {right, top}, {right, bottom}, {left, bottom}}});
}

void l3d_path::add_polygon(l3d_outline_2d corners) {
    if (corners.empty())
        return;
    move_to(corners[0]);
    kinds_.insert(kinds_.end(), corners.size() - 1, kind::line);
    points_.insert(points_.end(), corners.begin() + 1, corners.end());
    close();
}

void l3d_path::add(const l3d_path& other, const l3d_placement_2d& place) {
    if (other.empty())
        return;
    const std::size_t kinds = other.kinds_.size(), points = other.points_.size();
    const std::size_t weights = other.weights_.size(); // read first, as `other` may be this path
    for (std::size_t i = 0; i < kinds; ++i)
        kinds_.push_back(other.kinds_[i]);
    for (std::size_t i = 0; i < points; ++i)
        points_.push_back(place.at(other.points_[i]));
    for (std::size_t i = 0; i < weights; ++i)
        weights_.push_back(other.weights_[i]);
    first_ = place.at(other.first_);
    last_ = place.at(other.last_);
    open_ = other.open_;
}

void l3d_path::clear() {
    kinds_.clear();
    points_.clear();
    weights_.clear();
    first_ = last_ = {};
    open_ = false;
}

bool l3d_path::is_number() const {
    const auto is_point = [](l3d_point_2d p) { return !std::isnan(p.x) && !std::isnan(p.y); };
    return (all_within_reach() || std::ranges::all_of(points_, is_point)) &&
           std::ranges::all_of(weights_, [](double w) { return w > 0 && std::isfinite(w); });
}
