// SPDX-License-Identifier: MIT
// pen_outline: sides, joints and caps.
#include "raster/paths/pen_outline_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace l3d_detail {
namespace {

/// The limit of a pen's width, as far as paths reach: such a pen covers every picture. Arcs of
/// wider pens would have ever more pieces.
constexpr double widest_pen = 1 << 30;

/// The largest turn from point to point of an arc, so that a pixel's area is off by at most
/// l3d_flat_enough. Chords of a turn u add up to r^2 u^3 / (81 sqrt 2) to one side before the other
/// side makes up for it, and may do so four times in a pixel. Chords of large circles are nearer
/// than sqrt 2 pixels of the rim allow. NUMERICS.md, section 20.
double most_turn(double radius) {
    constexpr double root = std::numbers::sqrt2;
    const double by_area = std::cbrt(81 * root / 4 * l3d_flat_enough / (radius * radius));
    const double by_distance = std::sqrt(12 * (l3d_flat_enough / root) / radius);
    return std::min(std::max(by_area, by_distance), std::numbers::pi / 4);
}

} // namespace

/// An arc of angle a is r (1 - cos(a / 2)) away from its chord, at most r a^2 / 8.
pen_outline::pen_outline(const l3d_stroke& pen, l3d_path& result)
    : pen_(pen), result_(result), radius_(std::min(pen.width, widest_pen) / 2),
      most_angle_(std::min(std::sqrt(8 * l3d_flat_enough / radius_), std::numbers::pi / 4)),
      least_cosine_(std::cos(most_angle_)), most_turn_(most_turn(radius_)) {}

void pen_outline::add(const std::vector<pen_point>& points, bool closed, l3d_point_2d along) {
    find_chords(points, closed);
    if (chords_.empty())
        return add_dot(points[0].at, along);
    add_side(closed);
    if (closed)
        end_outline();
    else
        add_cap(chords_.back());
    reverse();
    add_side(closed);
    if (!closed)
        add_cap(chords_.back());
    end_outline();
}

void pen_outline::end_outline() {
    result_.add_polygon(outline_);
    outline_.clear();
}

void pen_outline::find_chords(const std::vector<pen_point>& points, bool closed) {
    chords_.clear();
    const pen_point* last = points.data();
    l3d_point_2d leaves = last->leaves;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (add_chord(*last, leaves, points[i]))
            last = &points[i];
        leaves = points[i].leaves;
    }
    if (closed)
        add_chord(*last, leaves, points[0]);
}

/// Adds a chord; returns false if it has no length. The pen is square to a curve where this begins
/// or ends.
bool pen_outline::add_chord(const pen_point& from, l3d_point_2d leaves, const pen_point& to) {
    const double dx = to.at.x - from.at.x, dy = to.at.y - from.at.y;
    const double length = std::sqrt(dx * dx + dy * dy); // from numbers below 2^32
    if (!(length > 0))
        return false;
    const l3d_point_2d own{dx / length, dy / length};
    const auto unless_back = [own](l3d_point_2d d) {
        return own.x * d.x + own.y * d.y > 0 ? d : own;
    };
    chords_.push_back(
        {from.at, to.at, length, unless_back(leaves), unless_back(to.arrives), from.smooth});
    return true;
}

void pen_outline::add_dot(l3d_point_2d at, l3d_point_2d along) {
    if (pen_.cap == l3d_cap::round) {
        result_.add_circle(at, radius_);
    } else if (pen_.cap == l3d_cap::square) {
        const double x = radius_ * along.x, y = radius_ * along.y;
        const std::array<l3d_point_2d, 4> corners{{{at.x - x + y, at.y - y - x},
                                                   {at.x + x + y, at.y + y - x},
                                                   {at.x + x - y, at.y + y + x},
                                                   {at.x - x - y, at.y - y + x}}};
        result_.add_polygon(corners);
    }
}

void pen_outline::add_side(bool closed) {
    if (closed)
        add_joint(chords_.back(), chords_.front());
    else
        add_point(beside(chords_.front().from, chords_.front().begins));
    for (std::size_t i = 1; i < chords_.size(); ++i)
        add_joint(chords_[i - 1], chords_[i]);
    if (!closed)
        add_point(beside(chords_.back().to, chords_.back().ends));
}

void pen_outline::add_joint(const chord& before, const chord& after) {
    const l3d_point_2d from = before.ends, to = after.begins;
    const double sine = from.x * to.y - from.y * to.x;
    const double cosine = from.x * to.x + from.y * to.y;
    if (cosine >= least_cosine_ && add_small_joint(before, after, sine, cosine))
        return;
    add_point(beside(after.from, from));
    if (sine > 0 || (sine == 0 && cosine < 0)) { // a turn to the right, y down: left is outside
        add_outer_joint(before, after, sine, cosine);
    } else if (sine < 0) {
        // The shorter way leaves out a triangle that both rectangles cover.
        const double aside = radius_ * -sine;
        if (cosine <= 0 || aside > std::min(before.length, after.length))
            add_point(after.from);
    }
    add_point(beside(after.from, to));
}

/// Adds one point for a turn so small that its arc is nearly its chord, whatever the join: within a
/// curve, and along the many points of a plot. On the outside it lies on the arc, and the sides of
/// both rectangles are at most r (1 - cos(turn / 2)) away. On the inside it is where these sides
/// cross; nothing is done where that is beyond the middle of one of them.
bool pen_outline::add_small_joint(const chord& before, const chord& after, double sine,
                                  double cosine) {
    const bool outside = sine > 0;
    const double along = radius_ * -sine / (1 + cosine);
    if (!outside && along > std::min(before.length, after.length) / 2)
        return false;
    const double scale = radius_ / (outside ? std::sqrt(2 * (1 + cosine)) : 1 + cosine);
    add_point(between(before, after, scale));
    return true;
}

/// The point beside a joint, in the middle between the left of both chords.
l3d_point_2d pen_outline::between(const chord& before, const chord& after, double scale) {
    return {after.from.x + scale * (before.ends.y + after.begins.y),
            after.from.y - scale * (before.ends.x + after.begins.x)};
}

void pen_outline::add_outer_joint(const chord& before, const chord& after, double sine,
                                  double cosine) {
    const l3d_join join = after.smooth ? l3d_join::round : pen_.join;
    if (join == l3d_join::round) {
        find_turns(std::atan2(sine, cosine), turns_);
        return add_arc(after.from, {before.ends.y, -before.ends.x}, turns_);
    }
    // From corner to corner a miter is 1 / sin(half the angle between the chords) widths long. The
    // sine is the cosine of half the turn.
    const double half_cosine = std::sqrt(std::max((1 + cosine) / 2, 0.0));
    if (join == l3d_join::miter && half_cosine * pen_.miter_limit >= 1)
        add_point(between(before, after, radius_ / (1 + cosine)));
}

void pen_outline::add_cap(const chord& last) {
    if (pen_.cap == l3d_cap::round) {
        if (half_turn_.empty())
            find_turns(std::numbers::pi, half_turn_);
        add_arc(last.to, {last.ends.y, -last.ends.x}, half_turn_);
    } else if (pen_.cap == l3d_cap::square) {
        const double x = radius_ * last.ends.x, y = radius_ * last.ends.y;
        add_point({last.to.x + x + y, last.to.y + y - x});
        add_point({last.to.x + x - y, last.to.y + y + x});
    }
}

/// Equal turns u lead from one point to the next, on a circle that is larger by r u^2 / 12 or so: a
/// chord and its arc bound equal areas. The arc itself begins and ends on the circle: there the
/// turn is by u / sqrt 2. A single chord has no neighbour to make up for the area that it cuts off.
void pen_outline::find_turns(double angle, std::vector<l3d_point_2d>& turns) const {
    constexpr double at_ends = 1 / std::numbers::sqrt2;
    constexpr double missing = 2 - 2 * at_ends; // turns by u that both ends together fall short of
    const int pieces = std::max(angle > most_angle_ ? 2 : 1,
                                static_cast<int>(std::ceil(angle / most_turn_ + missing)));
    const double turn = angle / (pieces - missing);
    const double cosine = std::cos(turn), sine = std::sin(turn);
    const double radius = radius_ * std::sqrt(turn / sine);
    double x = radius * std::cos(turn * at_ends), y = radius * std::sin(turn * at_ends);
    turns.clear();
    for (int i = 1; i < pieces; ++i) { // a few hundred turns at most: rounding stays below 2^-40
        turns.push_back({x, y});
        const double turned = x * cosine - y * sine;
        y = y * cosine + x * sine;
        x = turned;
    }
}

void pen_outline::add_arc(l3d_point_2d center, l3d_point_2d left,
                          const std::vector<l3d_point_2d>& turns) {
    for (const l3d_point_2d& t : turns)
        add_point(
            {center.x + (left.x * t.x - left.y * t.y), center.y + (left.y * t.x + left.x * t.y)});
}

/// The other side is the left one on the way back.
void pen_outline::reverse() {
    const auto back = [](l3d_point_2d direction) {
        return l3d_point_2d{-direction.x, -direction.y};
    };
    std::ranges::reverse(chords_);
    bool mark = chords_.back().smooth; // a joint's mark goes to the chord that begins there now
    for (chord& c : chords_) {
        std::swap(c.from, c.to);
        c.begins = back(std::exchange(c.ends, back(c.begins)));
        std::swap(c.smooth, mark);
    }
}

} // namespace l3d_detail
