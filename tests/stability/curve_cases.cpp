// SPDX-License-Identifier: MIT
// Chords of plane curves.
#include "curve_cases.h"

#include "exact_surface.h"

#include "raster/paths/flat_curve_p.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>

namespace stability {
namespace {

using l3d_detail::flat_steps;

/// Pieces of a picture of this size are cut; what is beside it is one chord.
constexpr double window = 1000;
constexpr l3d_detail::seen_box seen{-1, -1, window, window};

/// Chords whose exact curve is evaluated: 100 digits take microseconds.
constexpr std::int64_t most_judged = 2000;

/// What a chord's ends may be off by rounding, for a coordinate of that size (flat_curve_p.h).
double rounding_of(double size) {
    return std::ldexp(size, -40);
}

class exact_curve {
public:
    explicit exact_curve(const l3d_curve_2d& c) {
        for (std::size_t i = 0; i < 4; ++i)
            for (int k = 0; k < 3; ++k)
                points_[i][static_cast<std::size_t>(k)] = digits(c.points[i][k]);
    }

    std::array<digits, 2> at(const digits& t) const {
        auto p = points_;
        for (std::size_t left = 3; left > 0; --left)
            for (std::size_t i = 0; i < left; ++i)
                for (std::size_t k = 0; k < 3; ++k)
                    p[i][k] += t * (p[i + 1][k] - p[i][k]);
        return {p[0][0] / p[0][2], p[0][1] / p[0][2]};
    }

private:
    std::array<std::array<digits, 3>, 4> points_;
};

/// Of a point from a chord between two others.
double distance(const std::array<digits, 2>& p, l3d_point_2d a, l3d_point_2d b) {
    const digits x = b.x - digits(a.x), y = b.y - digits(a.y);
    const digits px = p[0] - a.x, py = p[1] - a.y, length = x * x + y * y;
    digits along = length > 0 ? (px * x + py * y) / length : digits(0);
    along = std::clamp(along, digits(0), digits(1));
    const digits dx = px - along * x, dy = py - along * y;
    return static_cast<double>(sqrt(dx * dx + dy * dy));
}

/// Follows the library's cuts, so that each chord's parameters are known.
class chord_judge {
public:
    chord_judge(const l3d_curve_2d& c, std::int64_t every) : exact_(c), every_(every) {}

    void follow(const l3d_curve_2d& c, const digits& from, const digits& to) {
        const l3d_detail::flat_plan plan = flat_steps(c, l3d_flat_enough);
        const bool is_seen = !seen.misses(c);
        if (is_seen && plan.halved) {
            const auto [first, second] = c.split();
            const digits middle = (from + to) / 2;
            follow(first, from, middle);
            follow(second, middle, to);
            return;
        }
        std::vector<l3d_point_2d> ends{l3d_detail::projected(c.points[0])};
        l3d_detail::flat_room room;
        l3d_detail::flatten(c, l3d_flat_enough, seen, room,
                            [&](std::span<const l3d_point_2d> some) {
                                ends.insert(ends.end(), some.begin(), some.end());
                            });
        const std::size_t count = ends.size() - 1;
        const auto place = [count](std::size_t step) { // what flat_step says
            if (step == 0 || step == count)
                return digits(step == 0 ? 0 : 1);
            return (static_cast<double>(step - 1) + l3d_detail::flat_step_at_ends) *
                   digits(l3d_detail::flat_step(count));
        };
        for (std::size_t i = 0; i < count; ++i)
            if (chords_++ % every_ == 0 && is_seen)
                for (const double part : {0.0, 0.25, 0.5, 0.75}) {
                    const digits within = place(i) + (place(i + 1) - place(i)) * part;
                    const digits t = from + (to - from) * within;
                    measured_ = std::max(measured_, distance(exact_.at(t), ends[i], ends[i + 1]));
                }
    }

    std::int64_t chords() const { return chords_; }
    double measured() const { return measured_; }

private:
    exact_curve exact_;
    std::int64_t every_, chords_ = 0;
    double measured_ = 0;
};

double ratio(double larger, double smaller) {
    return smaller > 0 ? larger / smaller : std::numeric_limits<double>::infinity();
}

double stiffness_of(const l3d_curve_2d& c) {
    std::array<l3d_point_2d, 4> p;
    double least = std::numeric_limits<double>::infinity(), most = 0, slow = least, fast = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        p[i] = l3d_detail::projected(c.points[i]);
        least = std::min(least, c.points[i][2]);
        most = std::max(most, c.points[i][2]);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const double speed = std::hypot(p[i + 1].x - p[i].x, p[i + 1].y - p[i].y);
        slow = std::min(slow, speed);
        fast = std::max(fast, speed);
    }
    const double third = std::hypot(p[3].x - 3 * p[2].x + 3 * p[1].x - p[0].x,
                                    p[3].y - 3 * p[2].y + 3 * p[1].y - p[0].y);
    const double chord = std::hypot(p[3].x - p[0].x, p[3].y - p[0].y);
    return std::max({ratio(fast, slow), 1 + ratio(third, chord), ratio(most, least)});
}

class collection {
public:
    void add(const char* group, const std::string& name, const std::array<l3d_point_2d, 4>& p,
             const std::array<double, 4>& weights = {1, 1, 1, 1}) {
        l3d_curve_2d c;
        double size = window;
        for (std::size_t i = 0; i < 4; ++i) {
            c.points[i] = {p[i].x * weights[i], p[i].y * weights[i], weights[i]};
            size = std::max({size, std::abs(p[i].x), std::abs(p[i].y)});
        }
        chord_judge count(c, std::numeric_limits<std::int64_t>::max());
        count.follow(c, 0, 1);
        chord_judge judge(c, 1 + count.chords() / most_judged);
        judge.follow(c, 0, 1);
        results.push_back({group, name, stiffness_of(c), judge.chords(),
                           l3d_flat_enough + rounding_of(size), judge.measured()});
    }

    std::vector<curve_result> results;
};

std::string power(const char* what, int exponent) {
    return std::string(what) + " 1e" + std::to_string(exponent);
}

} // namespace

std::vector<curve_result> all_curves() {
    collection to;
    for (int e = 3; e <= 12; ++e) {
        const double slow = std::pow(10, -e);
        to.add("speed", power("speeds differ by", e),
               {{{10, 20}, {10 + 900 * slow, 20 + 700 * slow}, {400, 500}, {910, 720}}});
    }
    to.add("speed", "stands still at one end", {{{10, 20}, {10, 20}, {10, 20}, {910, 720}}});
    for (const double off : {0.0, 1e-3, 1e-6, 1e-9, 1e-12})
        to.add("cusp", "missed by " + std::to_string(off),
               {{{100, 100}, {900 + 800 * off, 900}, {100, 900}, {900, 100}}});
    for (int e = 1; e <= 8; ++e) {
        const double d = 150 * std::pow(10, e);
        to.add("third difference", power("to the chord", e),
               {{{100, 400}, {100 + d, 500 - d}, {900 - d, 400 + d}, {900, 600}}});
    }
    for (int e = 1; e <= 6; ++e) {
        const double heavy = std::pow(10, e), light = std::pow(10, -e);
        const std::array<l3d_point_2d, 4> p{{{50, 100}, {300, 900}, {700, 50}, {950, 800}}};
        to.add("weights", power("heavy inside", e), p, {1, heavy, heavy, 1});
        to.add("weights", power("light inside", e), p, {1, light, light, 1});
        to.add("weights", power("rising", e), p, {1, std::sqrt(heavy), heavy, heavy});
        to.add("weights", power("by turns", e), p, {1, heavy, light, 1});
    }
    for (int e = 4; e <= 9; ++e) {
        const double far = std::pow(10, e);
        to.add("far", power("through the window from", e),
               {{{-far, -0.9 * far}, {400, 700}, {600, 300}, {far, 0.8 * far}}});
        to.add("far", power("round the window", e),
               {{{500, -10}, {far, 300}, {-far, 600}, {500, 1010}}});
    }
    return std::move(to.results);
}

} // namespace stability
