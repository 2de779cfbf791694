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

namespace {

using namespace l3d_detail;

/// Cuts outlines into dashes.
class dasher {
public:
    dasher(const l3d_stroke& pen, pen_outline& outline) : pen_(pen), outline_(outline) {
        sum_ = std::accumulate(pen.dashes.begin(), pen.dashes.end(), 0.0);
    }

    /// The dashes of a chain of points.
    void cut(const std::vector<pen_point>& points) {
        start();
        dash_.clear();
        if (drawing())
            dash_.push_back(points[0]);
        for (std::size_t i = 1; i < points.size(); ++i)
            go(points[i - 1], points[i]);
        end_dash();
    }

private:
    static constexpr std::size_t most_dashes = 1000000;

    bool drawing() const { return turn_ % 2 == 0; }

    void start() {
        turn_ = 0;
        const double twice = 2 * sum_; // an odd number of lengths is run through twice
        left_ = pen_.dash_begin - twice * std::floor(pen_.dash_begin / twice);
        while (left_ >= length())
            left_ -= length(), ++turn_;
        left_ = length() - left_;
    }

    double length() const { return pen_.dashes[turn_ % pen_.dashes.size()]; }

    void go(const pen_point& from, const pen_point& to) {
        const double dx = to.at.x - from.at.x, dy = to.at.y - from.at.y;
        const double whole = std::sqrt(dx * dx + dy * dy);
        double done = 0;
        while (whole - done > left_ && dashes_ < most_dashes) {
            done += left_;
            const double t = done / whole;
            const pen_point cut{
                {std::lerp(from.at.x, to.at.x, t), std::lerp(from.at.y, to.at.y, t)}, false};
            if (drawing()) {
                dash_.push_back(cut);
                end_dash();
            }
            ++turn_;
            left_ = length();
            if (drawing())
                dash_ = {cut};
        }
        left_ -= whole - done;
        if (drawing())
            dash_.push_back(to);
    }

    void end_dash() {
        if (!dash_.empty())
            outline_.add(dash_, false);
        ++dashes_;
        dash_.clear();
    }

    const l3d_stroke& pen_;
    pen_outline& outline_;
    double sum_ = 0, left_ = 0;
    std::size_t turn_ = 0, dashes_ = 0;
    std::vector<pen_point> dash_;
};

bool is_sound(const l3d_stroke& pen) {
    const bool plain = std::isfinite(pen.width) && pen.width > 0 && std::isfinite(pen.dash_begin) &&
                       !std::isnan(pen.miter_limit);
    const auto is_length = [](double d) { return std::isfinite(d) && d >= 0; };
    constexpr double shortest = 1e-3;
    return plain && std::ranges::all_of(pen.dashes, is_length) &&
           (pen.dashes.empty() ||
            std::accumulate(pen.dashes.begin(), pen.dashes.end(), 0.0) >= shortest);
}

/// The chords of a path, outline by outline. Joints inside of a curve are marked.
template <class Outline> struct chord_visitor {
    const Outline& outline;
    std::vector<pen_point> points;
    l3d_point_2d begin{};

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
        flatten(c, l3d_flat_enough, {-far, -far, far, far}, [this](l3d_point_2d p) {
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
    const auto add = [&](std::vector<pen_point>& points, bool closed) {
        if (pen.dashes.empty())
            return outline.add(points, closed);
        if (closed)
            points.push_back(points[0]);
        dashes.cut(points);
    };
    chord_visitor<decltype(add)> visitor{add, {}, {}};
    path.visit(visitor);
    visitor.finish();
    return result;
}
