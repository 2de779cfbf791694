// SPDX-License-Identifier: MIT
// l3d_gradient: finds means over pixels. l3d_mesh_patch: finds inner points.
#include "raster/paths/gradient.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double dot(l3d_point_2d a, l3d_point_2d b) {
    return a.x * b.x + a.y * b.y;
}

} // namespace

l3d_gradient::l3d_gradient(std::span<const l3d_color_stop> stops, l3d_spread spread) {
    assert(!stops.empty());
    const auto numbers_of = [](const l3d_color_stop& stop) {
        const auto channel = [&stop](int shift) { return double(stop.color >> shift & 255); };
        return numbers{channel(16), channel(8), channel(0), stop.alpha};
    };
    const numbers first = numbers_of(stops.front()), last = numbers_of(stops.back());
    pieces_.push_back({-infinite, stops.front().at, first, first});
    for (std::size_t i = 1; i < stops.size(); ++i)
        if (stops[i - 1].at < stops[i].at)
            pieces_.push_back(
                {stops[i - 1].at, stops[i].at, numbers_of(stops[i - 1]), numbers_of(stops[i])});
    pieces_.push_back({stops.back().at, infinite, last, last});
    for (const piece& p : pieces_) {
        is_opaque_ = is_opaque_ && p.begin[3] == 1 && p.end[3] == 1;
        for (std::size_t k = 0; k < 3; ++k)
            steepest_ = std::max(steepest_, std::abs(p.end[k] - p.begin[k]) / (p.to - p.from));
    }
    if (spread == l3d_spread::pad)
        return;
    period_ = 1;
    std::erase_if(pieces_, [](const piece& p) { return p.to <= 0 || p.from >= 1; });
    for (piece& p : pieces_)
        p = {std::max(p.from, 0.0), std::min(p.to, 1.0), p.at(std::max(p.from, 0.0)),
             p.at(std::min(p.to, 1.0))};
    if (spread == l3d_spread::repeat)
        return;
    period_ = 2;
    for (std::size_t i = pieces_.size(); i-- > 0;) {
        const piece p = pieces_[i];
        pieces_.push_back({2 - p.to, 2 - p.from, p.end, p.begin});
    }
}

l3d_gradient l3d_gradient::linear(l3d_point_2d from, l3d_point_2d to,
                                  std::span<const l3d_color_stop> stops, l3d_spread spread) {
    const l3d_point_2d d{to.x - from.x, to.y - from.y};
    assert(dot(d, d) > 0);
    l3d_gradient result(stops, spread);
    return result.placed({from, d, {-d.y, d.x}});
}

l3d_gradient l3d_gradient::radial(l3d_point_2d center, double radius, l3d_point_2d focus,
                                  std::span<const l3d_color_stop> stops, l3d_spread spread) {
    assert(radius > 0);
    constexpr double farthest = 1 - 0x1p-10;
    l3d_gradient result(stops, spread);
    result.radial_ = true;
    result.focus_ = {(focus.x - center.x) / radius, (focus.y - center.y) / radius};
    if (const double off = std::hypot(result.focus_.x, result.focus_.y); off > farthest)
        result.focus_ = {result.focus_.x * farthest / off, result.focus_.y * farthest / off};
    return result.placed({center, {radius, 0}, {0, radius}});
}

l3d_gradient l3d_gradient::placed(const l3d_placement_2d& place) const {
    l3d_gradient result = *this;
    result.to_unit_ = place.inverted().then(to_unit_);
    // The two singular values of the map.
    const l3d_point_2d a = result.to_unit_.across, d = result.to_unit_.down;
    const double sum = std::hypot(a.x + d.y, a.y - d.x), rest = std::hypot(a.x - d.y, a.y + d.x);
    result.widest_ = (sum + rest) / 2;
    result.narrowest_ = std::abs(sum - rest) / 2;
    return result;
}

l3d_gradient::numbers l3d_gradient::piece::at(double place) const {
    if (begin == end)
        return begin;
    const double share = (place - from) / (to - from);
    numbers result;
    for (std::size_t k = 0; k < result.size(); ++k)
        result[k] = begin[k] + (end[k] - begin[k]) * share;
    return result;
}

/// Returns the piece that a place of the gradient lies in, and sets `in_period` to the place within
/// its period.
const l3d_gradient::piece& l3d_gradient::piece_at(double place, double& in_period) const {
    in_period = period_ > 0 ? place - period_ * std::floor(place / period_) : place;
    const auto found = std::ranges::upper_bound(pieces_, in_period, {}, &piece::to);
    return found != pieces_.end() ? *found : pieces_.back();
}

bool l3d_gradient::is_one_piece(double from, double to) const {
    double first = 0, last = 0;
    const piece* const of_first = &piece_at(from, first);
    return of_first == &piece_at(to, last) && last - first >= (to - from) / 2;
}

/// Adds the integral of colour times weight from one place to another. The weight is linear in the
/// place. The numbers of a colour are red, green and blue, each times alpha, and alpha. Within a
/// piece, these numbers are at most quadratic, and cubic with the weight. So two Gauss points are
/// exact.
void l3d_gradient::add_in_period(double from, double to, double weight_from, double weight_to,
                                 numbers& sum) const {
    const double rise = to > from ? (weight_to - weight_from) / (to - from) : 0;
    for (auto p = std::ranges::upper_bound(pieces_, from, {}, &piece::to);
         p != pieces_.end() && p->from < to; ++p) {
        const double begin = std::max(from, p->from), half = (std::min(to, p->to) - begin) / 2;
        for (const double side : {-1.0, 1.0}) {
            const double place = begin + half * (1 + side / std::numbers::sqrt3);
            const numbers here = p->at(place);
            const double weight = (weight_from + rise * (place - from)) * half * here[3];
            for (std::size_t k = 0; k < 3; ++k)
                sum[k] += weight * here[k];
            sum[3] += weight;
        }
    }
}

/// Adds the integral over any number of periods. All whole periods are added as one period, with
/// the sum of their weights.
void l3d_gradient::add(double from, double to, double weight_from, double weight_to,
                       numbers& sum) const {
    if (period_ == 0)
        return add_in_period(from, to, weight_from, weight_to, sum);
    const double rise = (weight_to - weight_from) / (to - from);
    const auto weight_at = [&](double place) { return weight_from + rise * (place - from); };
    const double first = std::floor(from / period_), last = std::floor(to / period_);
    const double origin = first * period_, behind = last * period_;
    if (first == last)
        return add_in_period(from - origin, to - origin, weight_from, weight_to, sum);
    const double next = origin + period_, count = last - first - 1;
    add_in_period(from - origin, period_, weight_from, weight_at(next), sum);
    if (count > 0) {
        const double weight = count * weight_at(next) + rise * period_ * count * (count - 1) / 2;
        add_in_period(0, period_, weight, weight + count * rise * period_, sum);
    }
    add_in_period(0, to - behind, weight_at(behind), weight_to, sum);
}

/// The mean colour of a square over which the place in the gradient changes linearly. The density
/// of the places' values in the square is a trapezoid. It is as wide as the changes over the
/// square's width and height together.
l3d_gradient::numbers l3d_gradient::mean(const slope& of) const {
    const double wide = std::max(std::abs(of.right), std::abs(of.down));
    const double narrow = std::min(std::abs(of.right), std::abs(of.down));
    const double half = (wide + narrow) / 2, flat = (wide - narrow) / 2;
    numbers sum{};
    if (is_opaque_ && is_one_piece(of.place - half, of.place + half)) {
        double place = 0;
        const piece& p = piece_at(of.place, place);
        return p.at(place);
    }
    constexpr double least = 0x1p-40; // a smaller change counts as none
    if (wide < least) {
        double place = 0;
        sum = piece_at(of.place, place).at(place);
        for (std::size_t k = 0; k < 3; ++k)
            sum[k] *= sum[3];
        return sum;
    }
    if (narrow > least * wide) {
        add(of.place - half, of.place - flat, 0, 1 / wide, sum);
        add(of.place + flat, of.place + half, 1 / wide, 0, sum);
    }
    if (flat > 0)
        add(of.place - flat, of.place + flat, 1 / wide, 1 / wide, sum);
    return sum;
}

/// A point's place in the gradient, and the change of this place from pixel to pixel. Along a ray d
/// from the focus f to the unit circle, the place is 1 / s with |f + s d| = 1.
l3d_gradient::slope l3d_gradient::slope_at(l3d_point_2d at) const {
    const l3d_point_2d unit = to_unit_.at(at), &across = to_unit_.across, &down = to_unit_.down;
    if (!radial_)
        return {unit.x, across.x, down.x};
    const l3d_point_2d d{unit.x - focus_.x, unit.y - focus_.y};
    const double inside = 1 - dot(focus_, focus_), along = dot(focus_, d);
    const double root = std::sqrt(along * along + dot(d, d) * inside);
    if (root == 0)
        return {0, 0, 0};
    const auto change = [&](l3d_point_2d step) {
        const double step_along = dot(focus_, step);
        return (step_along + (along * step_along + dot(d, step) * inside) / root) / inside;
    };
    return {(along + root) / inside, change(across), change(down)};
}

/// The number of parts along each axis into which a pixel is cut. If the place in the gradient is
/// taken as linear in a square of side h, it errs by h^2 / 4 r at r pixels from the focus of a
/// circle. With a focus beside the middle, or an ellipse for a circle, r counts for less.
double l3d_gradient::parts_at(l3d_point_2d at) const {
    constexpr double most = 32, exact = 1.0 / 512;
    const l3d_point_2d unit = to_unit_.at(at);
    const double off = std::hypot(unit.x - focus_.x, unit.y - focus_.y);
    const double r = off * (1 - std::hypot(focus_.x, focus_.y)) * narrowest_ / (widest_ * widest_);
    return r > 0 ? std::clamp(std::ceil(std::sqrt(1 / (4 * r * exact))), 1.0, most) : most;
}

std::uint32_t l3d_gradient::word_at(l3d_point_2d at) const {
    const slope whole = slope_at(at);
    double parts = radial_ ? parts_at(at) : 1;
    // Between two stops, the places along a pixel may be curved. Their mean then differs from the
    // middle by a 24th of the bend.
    const double change = std::abs(whole.right) + std::abs(whole.down);
    constexpr double nothing = 1.0 / 16; // levels
    if (parts > 1 && is_opaque_ && steepest_ * change * parts * parts < 24 * 128 * nothing &&
        is_one_piece(whole.place - change, whole.place + change))
        parts = 1;
    numbers sum{};
    const auto count = static_cast<int>(parts);
    for (int y = 0; y < count; ++y)
        for (int x = 0; x < count; ++x) {
            slope part =
                count == 1
                    ? whole
                    : slope_at({at.x + (x + 0.5) / count - 0.5, at.y + (y + 0.5) / count - 0.5});
            part.right /= count;
            part.down /= count;
            const numbers here = mean(part);
            for (std::size_t k = 0; k < sum.size(); ++k)
                sum[k] += here[k] / (count * count);
        }
    const double alpha = std::clamp(sum[3], 0.0, 1.0);
    std::uint32_t word = static_cast<std::uint32_t>(255 * (1 - alpha) + 0.5);
    for (std::size_t k = 0; k < 3; ++k)
        word =
            word << 8 |
            (alpha > 0 ? static_cast<std::uint32_t>(std::clamp(sum[k] / sum[3], 0.0, 255.0) + 0.5)
                       : 0);
    return word;
}

void l3d_gradient::colors(int x, int y, std::span<std::uint32_t> result) const {
    double column = x;
    for (std::uint32_t& word : result)
        word = word_at({column++, double(y)});
}

l3d_mesh_patch l3d_mesh_patch::coons(const std::array<l3d_point_2d, 12>& around,
                                     const std::array<std::uint32_t, 4>& colors) {
    l3d_mesh_patch result;
    result.colors = colors;
    auto& p = result.points;
    for (std::size_t i = 0; i < 3; ++i) {
        p[0][i] = around[i];
        p[i][3] = around[3 + i];
        p[3][3 - i] = around[6 + i];
        p[3 - i][0] = around[9 + i];
    }
    // Computes an inner control point from the corner next to it, a. The terms are: a, its
    // neighbours on the borders, the corners beside it, the points opposite of these neighbours,
    // and the corner opposite of a.
    const auto inner = [&p](std::size_t row, std::size_t column) {
        const std::size_t r = row == 1 ? 0 : 3, c = column == 1 ? 0 : 3;
        const std::size_t far_r = 3 - r, far_c = 3 - c;
        const auto sum = [&](double l3d_point_2d::*k) {
            return (-4 * p[r][c].*k + 6 * (p[r][column].*k + p[row][c].*k) -
                    2 * (p[r][far_c].*k + p[far_r][c].*k) +
                    3 * (p[far_r][column].*k + p[row][far_c].*k) - p[far_r][far_c].*k) /
                   9;
        };
        return l3d_point_2d{sum(&l3d_point_2d::x), sum(&l3d_point_2d::y)};
    };
    for (std::size_t row = 1; row < 3; ++row)
        for (std::size_t column = 1; column < 3; ++column)
            p[row][column] = inner(row, column);
    return result;
}
