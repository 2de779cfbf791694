// SPDX-License-Identifier: MIT
// l3d_stroked: chords, dashes, and what the pen covers beside them.
#include "raster/paths/stroke.h"

#include "raster/paths/flat_curve_p.h"
#include "raster/paths/pen_outline_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <span>

namespace {

using namespace l3d_detail;

/// Cuts outlines into dashes.
class dasher {
public:
    dasher(const l3d_stroke& pen, pen_outline& outline) : pen_(pen), outline_(outline) {
        sum_ = std::accumulate(pen.dashes.begin(), pen.dashes.end(), 0.0);
    }

    /// The dashes of a chain of points.
    void cut(const std::vector<pen_point>& points, bool closed) {
        start();
        first_ = {};
        dash_ = {};
        held_ = closed && drawing();
        if (drawing())
            dash_.points.push_back(points[0]);
        for (std::size_t i = 1; i < points.size(); ++i)
            go(points[i - 1], points[i]);
        if (closed)
            go(points.back(), points[0]);
        if (held_)
            return outline_.add(points, true); // one dash is longer than all
        join_first();
        end_dash();
    }

private:
    static constexpr std::size_t most_dashes = 1000000;

    struct dash {
        std::vector<pen_point> points;
        l3d_point_2d along{1, 0}; ///< the direction of the chord that it ends in
    };

    bool drawing() const { return turn_ % 2 == 0 && dashes_ < most_dashes; }

    void start() {
        turn_ = 0;
        const double twice = 2 * sum_; // an odd number of lengths is run through twice
        left_ = std::fmod(pen_.dash_begin, twice);
        if (left_ < 0)
            left_ += twice;
        while (left_ > 0 && left_ >= length())
            left_ -= length(), ++turn_;
        left_ = length() - left_;
    }

    double length() const { return pen_.dashes[turn_ % pen_.dashes.size()]; }

    void go(const pen_point& from, const pen_point& to) {
        const double dx = to.at.x - from.at.x, dy = to.at.y - from.at.y;
        const double whole = std::sqrt(dx * dx + dy * dy);
        double done = 0;
        if (whole > 0)
            dash_.along = {dx / whole, dy / whole};
        while (whole - done > left_ && dashes_ < most_dashes) {
            done += left_;
            const double t = done / whole;
            const pen_point cut{
                {std::lerp(from.at.x, to.at.x, t), std::lerp(from.at.y, to.at.y, t)}, false};
            if (drawing()) {
                dash_.points.push_back(cut);
                end_dash();
            }
            ++turn_;
            left_ = length();
            if (drawing())
                dash_.points = {cut};
        }
        left_ -= whole - done;
        if (drawing())
            dash_.points.push_back(to);
    }

    /// The first dash of a closed outline waits for the last one.
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

    /// What is drawn where a closed outline ends goes on as its first dash.
    void join_first() {
        if (first_.points.empty())
            return;
        if (dash_.points.empty())
            dash_.along = first_.along;
        dash_.points.insert(dash_.points.end(), first_.points.begin(), first_.points.end());
    }

    const l3d_stroke& pen_;
    pen_outline& outline_;
    double sum_ = 0, left_ = 0;
    std::size_t turn_ = 0, dashes_ = 0;
    dash dash_, first_;
    bool held_ = false; ///< the dash is the first one of a closed outline
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

/// The chords of a path, outline by outline. Joints inside of a curve are marked.
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
        constexpr double far = std::numeric_limits<double>::max();
        flatten(c, l3d_flat_enough, {-far, -far, far, far}, room,
                [this](std::span<const l3d_point_2d> ends) {
                    for (const l3d_point_2d& p : ends)
                        points.push_back({p, true});
                });
        points.back().smooth = false;
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
    dasher dashes(pen, outline);
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
