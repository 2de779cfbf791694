// SPDX-License-Identifier: MIT
// pen_outline: makes sides, joints and caps.
#include "raster/paths/pen_outline_p.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace l3d_detail {
namespace {

/// The limit of a pen's width, which is the largest coordinate of paths. A pen of this width covers
/// every picture, and arcs of wider pens would have ever more pieces.
constexpr double widest_pen = 1 << 30;

/// The largest turn between neighbouring points of an arc for which the area in every pixel errs by
/// at most l3d_flat_enough. Chords of a turn u lose up to r^2 u^3 / (81 sqrt 2) on one side before
/// the other side makes up for this loss. Up to four of these losses may fall into one pixel. For
/// large circles, the distance of chords from the rim allows more, as at most sqrt 2 pixels of the
/// rim are in a pixel. See NUMERICS.md, section 20.
double most_turn(double radius) {
    constexpr double root = std::numbers::sqrt2;
    const double by_area = std::cbrt(81 * root / 4 * l3d_flat_enough / (radius * radius));
    const double by_distance = std::sqrt(12 * (l3d_flat_enough / root) / radius);
    return std::min(std::max(by_area, by_distance), std::numbers::pi / 4);
}

l3d_point_2d opposite(l3d_point_2d direction) {
    return {-direction.x, -direction.y};
}

} // namespace

/// Finds the largest turn of an arc that needs no points between its ends. An arc of angle a is at
/// most r (1 - cos(a / 2)), and so at most r a^2 / 8, away from its chord.
pen_outline::pen_outline(const l3d_stroke& pen, l3d_path& result)
    : pen_(pen), result_(result), radius_(std::min(pen.width, widest_pen) / 2),
      most_angle_(std::min(std::sqrt(8 * l3d_flat_enough / radius_), std::numbers::pi / 4)),
      least_cosine_(std::cos(most_angle_)), most_turn_(most_turn(radius_)) {}

void pen_outline::add(const std::vector<pen_point>& points, bool closed, l3d_point_2d along) {
    find_chords(points, closed);
    if (chords_.empty())
        return add_dot(points[0].at, along);
    const chord &first = chords_.front(), &last = chords_.back();
    if (closed)
        add_joint(last, first);
    else
        add_ends(first.from, first.begins);
    for (std::size_t i = 1; i < chords_.size(); ++i)
        add_joint(chords_[i - 1], chords_[i]);
    if (closed) {
        end_outline(left_);
        std::ranges::reverse(right_);
    } else {
        add_ends(last.to, last.ends);
        add_cap(last.to, last.ends);
        left_.insert(left_.end(), right_.rbegin(), right_.rend());
        add_cap(first.from, opposite(first.begins));
        right_.swap(left_);
        left_.clear();
    }
    end_outline(right_);
}

void pen_outline::end_outline(side& outline) {
    result_.add_polygon(outline);
    outline.clear();
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

/// Adds a chord. Returns false if the chord has no length. Where the chord begins or ends a curve,
/// the pen is square to the curve.
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

void pen_outline::add_ends(l3d_point_2d at, l3d_point_2d direction) {
    left_.push_back(beside(at, direction));
    right_.push_back(beside(at, opposite(direction)));
}

/// Adds a joint on both sides. The right side is found as the left side of a pen that comes back.
void pen_outline::add_joint(const chord& before, const chord& after) {
    if (add_flat_joint(before, after))
        return;
    const joint there{after.from, before.ends, after.begins, std::min(before.length, after.length),
                      after.smooth ? l3d_join::round : pen_.join};
    add_left(there, left_);
    const auto begin = static_cast<std::ptrdiff_t>(right_.size());
    add_left({there.at, opposite(there.begins), opposite(there.ends), there.shortest, there.join},
             right_);
    std::reverse(right_.begin() + begin, right_.end());
}

/// Adds a joint that turns so little that an arc is nearly its chord: one point on either side,
/// whatever the join. Does nothing and returns false if the joint turns more. Joints that turn so
/// little occur within curves, and at the many points of a plot.
///
/// On the outside, the point lies on the arc, and the sides of both rectangles are at most r (1 -
/// cos(turn / 2)) away. On the inside, the point is where the rectangles' sides cross, unless this
/// crossing is beyond the middle of one of them.
bool pen_outline::add_flat_joint(const chord& before, const chord& after) {
    const l3d_point_2d &ends = before.ends, &begins = after.begins, &at = after.from;
    const double sine = ends.x * begins.y - ends.y * begins.x;
    const double cosine = ends.x * begins.x + ends.y * begins.y;
    const double inner = radius_ / (1 + cosine);
    if (!(cosine >= least_cosine_) ||
        inner * std::abs(sine) > std::min(before.length, after.length) / 2)
        return false;
    const double outer = radius_ / std::sqrt(2 * (1 + cosine));
    const double left = sine > 0 ? outer : inner; // a turn to the right, as y leads down
    const double right = sine < 0 ? outer : inner;
    const double x = ends.y + begins.y, y = ends.x + begins.x;
    left_.push_back({at.x + left * x, at.y - left * y});
    right_.push_back({at.x - right * x, at.y + right * y});
    return true;
}

/// Adds the left side of a joint.
void pen_outline::add_left(const joint& j, side& to) {
    const double sine = j.ends.x * j.begins.y - j.ends.y * j.begins.x;
    const double cosine = j.ends.x * j.begins.x + j.ends.y * j.begins.y;
    const bool outside = sine > 0 || (sine == 0 && cosine < 0); // a turn to the right, y down
    const double inner = radius_ / (1 + cosine);
    if (cosine >= least_cosine_ && (outside || inner * -sine <= j.shortest / 2)) {
        const double scale = outside ? radius_ / std::sqrt(2 * (1 + cosine)) : inner;
        return to.push_back(between(j, scale));
    }
    to.push_back(beside(j.at, j.ends));
    if (outside)
        add_outside(j, sine, cosine, to);
    // Without the joint itself, the outline would leave out a triangle that both rectangles cover.
    else if (sine < 0 && radius_ * -sine > j.shortest)
        to.push_back(j.at);
    to.push_back(beside(j.at, j.begins));
}

void pen_outline::add_outside(const joint& j, double sine, double cosine, side& to) {
    if (j.join == l3d_join::round) {
        find_turns(std::atan2(sine, cosine), turns_);
        return add_arc(j.at, {j.ends.y, -j.ends.x}, turns_, to);
    }
    // From corner to corner, a miter is 1 / sin(half the angle between the chords) widths long.
    // That sine is the cosine of half the turn.
    const double half_cosine = std::sqrt(std::max((1 + cosine) / 2, 0.0));
    if (j.join == l3d_join::miter && half_cosine * pen_.miter_limit >= 1)
        to.push_back(between(j, radius_ / (1 + cosine)));
}

/// Adds the cap at the end of an outline, where the pen arrives in a direction.
void pen_outline::add_cap(l3d_point_2d at, l3d_point_2d arrives) {
    if (pen_.cap == l3d_cap::round) {
        if (half_turn_.empty())
            find_turns(std::numbers::pi, half_turn_);
        add_arc(at, {arrives.y, -arrives.x}, half_turn_, left_);
    } else if (pen_.cap == l3d_cap::square) {
        const double x = radius_ * arrives.x, y = radius_ * arrives.y;
        left_.push_back({at.x + x + y, at.y + y - x});
        left_.push_back({at.x + x - y, at.y + y + x});
    }
}

/// Finds the points of an arc. Equal turns u lead from one point to the next, on a circle that is
/// larger by about r u^2 / 12. So chords and their arcs bound equal areas. The arc's ends are on
/// the pen's circle, and their turns are u / sqrt 2. A single chord has no neighbour to make up for
/// the area that it cuts off.
void pen_outline::find_turns(double angle, std::vector<l3d_point_2d>& turns) const {
    constexpr double at_ends = 1 / std::numbers::sqrt2;
    constexpr double missing = 2 - 2 * at_ends; // 2 u less the turns of both ends, in u
    const int pieces = std::max(angle > most_angle_ ? 2 : 1,
                                static_cast<int>(std::ceil(angle / most_turn_ + missing)));
    const double turn = angle / (pieces - missing);
    const double cosine = std::cos(turn), sine = std::sin(turn);
    const double radius = radius_ * std::sqrt(turn / sine);
    double x = radius * std::cos(turn * at_ends), y = radius * std::sin(turn * at_ends);
    turns.clear();
    for (int i = 1; i < pieces; ++i) { // a few hundred turns at most, so rounding stays below 2^-40
        turns.push_back({x, y});
        const double turned = x * cosine - y * sine;
        y = y * cosine + x * sine;
        x = turned;
    }
}

void pen_outline::add_arc(l3d_point_2d center, l3d_point_2d left,
                          const std::vector<l3d_point_2d>& turns, side& to) {
    for (const l3d_point_2d& t : turns)
        to.push_back(
            {center.x + (left.x * t.x - left.y * t.y), center.y + (left.y * t.x + left.x * t.y)});
}

} // namespace l3d_detail
