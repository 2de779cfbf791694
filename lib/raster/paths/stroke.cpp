// SPDX-License-Identifier: MIT
// l3d_stroked: finds chords, cuts dashes, and draws the pen's outlines beside them.
#include "raster/paths/path.h"

#include "raster/paths/flat_curve_p.h"
#include "raster/paths/pen_outline_p.h"
#include "tool_2d/pixels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace {

using namespace l3d_detail;

bool is_set(l3d_point_2d direction) {
    return direction.x != 0 || direction.y != 0;
}

/// A vector's direction with length 1. (0, 0) has no direction and stays (0, 0).
l3d_point_2d unit(l3d_point_2d v) {
    const double length = std::sqrt(v.x * v.x + v.y * v.y); // from numbers below 2^500
    return length > 0 ? l3d_point_2d{v.x / length, v.y / length} : l3d_point_2d{};
}

/// The vector between two points, divided by the square of its length. For neighbouring chords of a
/// circle, the sum of both chords' results has the circle's direction where the chords meet. The
/// reason is that the circle turns from each chord by half the angle of the chord's arc.
l3d_point_2d inverse_way(const pen_point& from, const pen_point& to) {
    const double x = to.at.x - from.at.x, y = to.at.y - from.at.y, square = x * x + y * y;
    return square > 0 ? l3d_point_2d{x / square, y / square} : l3d_point_2d{};
}

/// The directions of a curve at both ends of a chord. They are (0, 0) if the chord is on no curve.
struct chord_ends {
    l3d_point_2d first, last;

    /// Finds the directions for the chord that ends at point i.
    chord_ends(const std::vector<pen_point>& points, std::size_t i) {
        const pen_point &from = points[i - 1], &to = points[i];
        if (!to.smooth && !is_set(to.arrives))
            return;
        const l3d_point_2d own = inverse_way(from, to);
        const auto between = [&](const pen_point& a, const pen_point& b) {
            const l3d_point_2d other = inverse_way(a, b);
            return unit({own.x + other.x, own.y + other.y});
        };
        first = from.smooth           ? between(points[i - 2], from)
                : is_set(from.leaves) ? from.leaves
                                      : unit(own);
        last = to.smooth ? between(to, points[i + 1]) : to.arrives;
    }
    chord_ends() = default;

    /// The direction at parameter t of the chord. The direction turns evenly from end to end, as
    /// along a circle.
    l3d_point_2d at(double t) const {
        return is_set(last) ? unit({std::lerp(first.x, last.x, t), std::lerp(first.y, last.y, t)})
                            : l3d_point_2d{};
    }
};

/// The directions of a curve at its first and its last point. Each direction leads along the line
/// between this point and the next control point at another place.
std::array<l3d_point_2d, 2> end_directions(const l3d_curve_2d& c) {
    const auto from = [&](std::size_t at, std::size_t first, int step) {
        for (std::size_t i = first, n = 0; n < 3; ++n, i += static_cast<std::size_t>(step)) {
            const auto &p = c.points[at], &q = c.points[i];
            const l3d_point_2d way{q[0] * p[2] - p[0] * q[2], q[1] * p[2] - p[1] * q[2]};
            if (is_set(way))
                return unit(way);
        }
        return l3d_point_2d{};
    };
    const l3d_point_2d back = from(3, 2, -1);
    return {from(0, 1, 1), {-back.x, -back.y}};
}

constexpr std::size_t most_dashes = 1000000;

/// Adds up the lengths of a path's control polygons. No outline is longer than its control polygon.
struct length_visitor {
    double length = 0;
    l3d_point_2d begin{}, at{};

    void move(l3d_point_2d to) { begin = at = to; }
    void line(l3d_point_2d to) {
        length += std::hypot(to.x - at.x, to.y - at.y);
        at = to;
    }
    void curve(const l3d_curve_2d& c) {
        for (const auto& p : c.points)
            line({p[0] / p[2], p[1] / p[2]});
    }
    void close() { line(begin); }
};

/// Whether a path may have more dashes than most_dashes.
bool has_too_many_dashes(const l3d_path& path, const l3d_stroke& pen, double sum) {
    length_visitor visitor;
    path.visit(visitor);
    return visitor.length / sum * static_cast<double>(pen.dashes.size()) >
           static_cast<double>(most_dashes);
}

/// The part of a chord that may lie in a picture, in lengths from the chord's beginning. In both x
/// and y, this part is within `reach` of the largest picture. Source: Liang, Barsky 1984.
struct seen_part {
    double begin = 0, end;

    seen_part(l3d_point_2d from, l3d_point_2d direction, double whole, double reach) : end(whole) {
        clip(from.x, direction.x, reach);
        clip(from.y, direction.y, reach);
    }

private:
    void clip(double from, double direction, double reach) {
        const double low = -reach - from, high = l3d_largest_side + reach - from;
        if (direction == 0) {
            if (low > 0 || high < 0)
                begin = end;
            return;
        }
        begin = std::max(begin, std::min(low / direction, high / direction));
        end = std::min(end, std::max(low / direction, high / direction));
    }
};

/// Cuts outlines into dashes.
class dasher {
public:
    /// If `leaves_out`, dashes that no picture shows are not made, except the first and the last
    /// dash.
    dasher(const l3d_stroke& pen, pen_outline& outline, double sum, bool leaves_out)
        : pen_(pen), outline_(outline), sum_(sum), leaves_out_(leaves_out) {}

    /// Makes the dashes of a chain of points.
    void cut(const std::vector<pen_point>& points, bool closed) {
        start();
        first_ = {};
        dash_ = {};
        held_ = closed && drawing();
        if (drawing())
            dash_.points.push_back(points[0]);
        for (std::size_t i = 1; i < points.size(); ++i)
            go(points[i - 1], points[i], [&] { return chord_ends(points, i); });
        if (closed)
            go(points.back(), points[0], [] { return chord_ends(); });
        if (held_)
            return outline_.add(points, true); // a single dash is longer than the outline
        join_first();
        end_dash();
    }

private:
    struct dash {
        std::vector<pen_point> points;
        l3d_point_2d along{1, 0}; ///< the direction of the chord in which the dash ends
    };

    bool drawing() const { return turn_ % 2 == 0 && dashes_ < most_dashes; }

    void start() {
        turn_ = 0;
        const double twice = 2 * sum_; // an odd number of lengths repeats after two passes
        left_ = std::fmod(pen_.dash_begin, twice);
        if (left_ < 0)
            left_ += twice;
        while (left_ > 0 && left_ >= length())
            left_ -= length(), ++turn_;
        left_ = length() - left_;
    }

    double length() const { return pen_.dashes[turn_ % pen_.dashes.size()]; }

    /// Goes along a chord, and ends and begins dashes on it. find_ends() gives the curve's
    /// directions at both ends of the chord.
    template <class FindEnds>
    void go(const pen_point& from, const pen_point& to, const FindEnds& find_ends) {
        const double dx = to.at.x - from.at.x, dy = to.at.y - from.at.y;
        const double whole = std::sqrt(dx * dx + dy * dy);
        double done = 0;
        bool begins_here = false;
        if (whole > 0)
            dash_.along = {dx / whole, dy / whole};
        const chord_ends ends = whole > left_ ? find_ends() : chord_ends();
        const bool may_leave_out = leaves_out_ && whole > 0;
        while (whole - done > left_ && dashes_ < most_dashes) {
            if (may_leave_out && turn_ % 2 == 1)
                done += left_out(from.at, {dx / whole, dy / whole}, whole, done);
            done += left_;
            const double t = done / whole;
            const l3d_point_2d direction = ends.at(t);
            const pen_point cut{
                {std::lerp(from.at.x, to.at.x, t), std::lerp(from.at.y, to.at.y, t)},
                false,
                direction,
                direction};
            if (is_set(direction))
                dash_.along = direction;
            // The drawn part of a chord may be so short that only the curve's directions tell how
            // the pen continues.
            if (drawing()) {
                if (dash_.points.back().smooth)
                    turn(dash_.points.back(), ends.first);
                dash_.points.push_back(cut);
                end_dash();
            }
            ++turn_;
            left_ = length();
            begins_here = drawing();
            if (begins_here)
                dash_.points = {cut};
        }
        left_ -= whole - done;
        if (!drawing())
            return;
        dash_.points.push_back(to);
        if (begins_here && to.smooth)
            turn(dash_.points.back(), ends.last);
    }

    /// The length ahead that can be skipped in a gap: whole periods of dashes that no picture
    /// shows. The skipped length ends a period before the visible part, or before the chord's end.
    double left_out(l3d_point_2d from, l3d_point_2d direction, double whole, double done) const {
        const seen_part seen(from, direction, whole, 2 * pen_.width);
        const double twice = 2 * sum_; // an odd number of lengths repeats after two passes
        const double until = seen.begin < seen.end && done < seen.end ? seen.begin : whole;
        return std::max(0.0, std::floor((until - done - left_) / twice) - 1) * twice;
    }

    static void turn(pen_point& point, l3d_point_2d direction) {
        point.arrives = point.leaves = direction;
    }

    /// Hands the dash to the pen. The first dash of a closed outline waits for the last dash, as
    /// both dashes may meet.
    void end_dash() {
        if (dash_.points.empty())
            return;
        if (held_)
            first_ = dash_;
        else
            outline_.add(dash_.points, false, dash_.along);
        held_ = false;
        ++dashes_;
        dash_.points.clear();
    }

    /// Joins the dash at the end of a closed outline with its first dash.
    void join_first() {
        if (first_.points.empty())
            return;
        if (dash_.points.empty())
            dash_.along = first_.along;
        dash_.points.insert(dash_.points.end(), first_.points.begin(), first_.points.end());
    }

    const l3d_stroke& pen_;
    pen_outline& outline_;
    double sum_, left_ = 0;
    bool leaves_out_;
    std::size_t turn_ = 0, dashes_ = 0;
    dash dash_, first_;
    bool held_ = false; ///< whether the first dash of a closed outline waits for the last dash
};

bool is_sound(const l3d_stroke& pen) {
    const bool plain = std::isfinite(pen.width) && pen.width > 0 && std::isfinite(pen.dash_begin) &&
                       !std::isnan(pen.miter_limit);
    const auto is_length = [](double d) { return std::isfinite(d) && d >= 0; };
    constexpr double shortest = 1e-3;
    const double sum = std::accumulate(pen.dashes.begin(), pen.dashes.end(), 0.0);
    return plain && std::ranges::all_of(pen.dashes, is_length) &&
           (pen.dashes.empty() || (sum >= shortest && std::isfinite(2 * sum)));
}

/// Collects the chords of a path, outline by outline. Points inside of a curve are marked as
/// smooth.
template <class Outline> struct chord_visitor {
    const Outline& outline;
    std::vector<pen_point> points;
    l3d_point_2d begin{};
    flat_room room{};

    void move(l3d_point_2d to) {
        finish();
        points = {{to, false}};
        begin = to;
    }
    void line(l3d_point_2d to) {
        continue_outline();
        points.push_back({to, false});
    }
    void curve(const l3d_curve_2d& c) {
        continue_outline();
        const auto [leaves, arrives] = end_directions(c);
        points.back().leaves = leaves;
        constexpr double far = std::numeric_limits<double>::max();
        flatten(c, l3d_flat_enough, {-far, -far, far, far}, room,
                [this](std::span<const l3d_point_2d> ends) {
                    for (const l3d_point_2d& p : ends)
                        points.push_back({p, true});
                });
        points.back().smooth = false;
        points.back().arrives = arrives;
    }
    void close() {
        outline(points, true);
        points.clear();
    }
    void finish() {
        if (!points.empty())
            outline(points, false);
        points.clear();
    }

private:
    void continue_outline() {
        if (points.empty())
            points.push_back({begin, false});
    }
};

} // namespace

l3d_path l3d_stroked(const l3d_path& path, const l3d_stroke& pen) {
    l3d_path result;
    if (!path.is_number() || !is_sound(pen))
        return result;
    pen_outline outline(pen, result);
    const double sum = std::accumulate(pen.dashes.begin(), pen.dashes.end(), 0.0);
    dasher dashes(pen, outline, sum, !pen.dashes.empty() && has_too_many_dashes(path, pen, sum));
    const auto add = [&](const std::vector<pen_point>& points, bool closed) {
        if (pen.dashes.empty())
            outline.add(points, closed);
        else
            dashes.cut(points, closed);
    };
    chord_visitor<decltype(add)> visitor{add, {}, {}, {}};
    path.visit(visitor);
    visitor.finish();
    return result;
}
