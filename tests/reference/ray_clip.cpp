// SPDX-License-Identifier: MIT
// Bezier clipping: hulls of distances, cuts and halves.
#include "reference/ray_clip.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

namespace reference::second {
namespace {

constexpr int most_parts = 100'000;

/// A side that keeps more than this of its length is halved instead: cutting a fifth off twice
/// leaves 0.64, which one halving beats.
constexpr double too_little = 0.8;

/// 2^-46: below it, halves of a parameter in [0, 1] are no longer told apart.
constexpr double least_side = 0x1p-46;

/// A stretch of a parameter.
struct stretch {
    double low = 0, high = 1;
    double length() const { return high - low; }
    double at(double t) const { return low + t * (high - low); }
};

struct part {
    offset_net points;
    stretch u, v;
};

offsets between(const offsets& p, const offsets& q, double t) {
    return {p.a + t * (q.a - p.a), p.b + t * (q.b - p.b)};
}

/// Four points of the net, `step` apart.
struct curve {
    std::size_t first, step;
    std::size_t at(std::size_t i) const { return first + i * step; }
};

/// Keeps what is before t.
void keep_low(offset_net& p, curve c, double t) {
    for (std::size_t round = 1; round < 4; ++round)
        for (std::size_t i = 3; i >= round; --i)
            p[c.at(i)] = between(p[c.at(i - 1)], p[c.at(i)], t);
}

/// Keeps what is after t.
void keep_high(offset_net& p, curve c, double t) {
    for (std::size_t round = 1; round < 4; ++round)
        for (std::size_t i = 0; i + round < 4; ++i)
            p[c.at(i)] = between(p[c.at(i)], p[c.at(i + 1)], t);
}

/// Keeps a stretch of all four curves along one parameter.
void keep(part& of, bool along_u, stretch kept) {
    for (std::size_t line = 0; line < 4; ++line) {
        const curve c = along_u ? curve{4 * line, 1} : curve{line, 4};
        if (kept.high < 1)
            keep_low(of.points, c, kept.high);
        if (kept.low > 0)
            keep_high(of.points, c, kept.low / kept.high);
    }
    stretch& whole = along_u ? of.u : of.v;
    whole = {whole.at(kept.low), whole.at(kept.high)};
}

bool is_missed(const offset_net& points, double slack) {
    double low_a = points[0].a, high_a = low_a, low_b = points[0].b, high_b = low_b;
    for (const offsets& p : points) {
        low_a = std::min(low_a, p.a);
        high_a = std::max(high_a, p.a);
        low_b = std::min(low_b, p.b);
        high_b = std::max(high_b, p.b);
    }
    return low_a > slack || high_a < -slack || low_b > slack || high_b < -slack;
}

double extent(const offset_net& points) {
    double result = 0;
    for (const offsets& p : points)
        result = std::max({result, std::abs(p.a - points[0].a), std::abs(p.b - points[0].b)});
    return result;
}

/// The stretch of one parameter outside of which the convex hull of (i / 3, distances of column i)
/// does not reach the axis. Empty, with low > high, if it never does.
stretch zeros_of(const part& of, bool along_u, double slack) {
    const offset_net& p = of.points;
    // A direction along the other parameter, so that distances from it change along this one.
    const std::size_t across = along_u ? 12 : 3, along = along_u ? 3 : 12;
    double da = p[across].a - p[0].a + p[15].a - p[along].a;
    double db = p[across].b - p[0].b + p[15].b - p[along].b;
    const double length = std::sqrt(da * da + db * db);
    if (!(length > 0))
        return {0, 1};
    da /= length;
    db /= length;
    std::array<double, 4> low{}, high{};
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j) {
            const offsets& q = p[along_u ? 4 * j + i : 4 * i + j];
            const double distance = da * q.b - db * q.a;
            low[i] = j == 0 ? distance - slack : std::min(low[i], distance - slack);
            high[i] = j == 0 ? distance + slack : std::max(high[i], distance + slack);
        }
    stretch result{2, -1};
    const auto meets = [&](double t) {
        result = {std::min(result.low, t), std::max(result.high, t)};
    };
    const auto third = [](std::size_t i) { return static_cast<double>(i) / 3; };
    for (std::size_t i = 0; i < 4; ++i) {
        if (low[i] <= 0 && high[i] >= 0)
            meets(third(i));
        if (!(low[i] < 0))
            continue;
        for (std::size_t k = 0; k < 4; ++k)
            for (const double above : {low[k], high[k]})
                for (const double below : {low[i], high[i]})
                    if (k != i && below < 0 && above > 0)
                        meets(third(i) + (third(k) - third(i)) * (below / (below - above)));
    }
    return result;
}

class clipper {
public:
    clipper(double width, const std::function<void(double, double)>& found)
        : width_(width), slack_(width / 1000), found_(found) {}

    void search(part of) {
        for (;;) {
            if (++parts_ > most_parts)
                throw std::runtime_error("second judge: a ray needs too many parts");
            if (is_missed(of.points, slack_))
                return;
            if (extent(of.points) <= width_ || std::max(of.u.length(), of.v.length()) < least_side)
                return found_(of.u.at(0.5), of.v.at(0.5));
            double left = 1;
            for (const bool along_u : {true, false}) {
                const stretch kept = zeros_of(of, along_u, slack_);
                if (kept.low > kept.high)
                    return;
                const stretch in{std::max(kept.low - 1e-12, 0.0), std::min(kept.high + 1e-12, 1.0)};
                keep(of, along_u, in);
                left = std::min(left, in.length());
            }
            if (left > too_little) {
                const bool along_u = is_wider_along_u(of);
                part low = of;
                keep(low, along_u, {0, 0.5});
                search(low);
                keep(of, along_u, {0.5, 1});
            }
        }
    }

private:
    /// By the control points' way along both parameters.
    static bool is_wider_along_u(const part& of) {
        if (of.u.length() < least_side || of.v.length() < least_side)
            return of.u.length() > of.v.length();
        double by_u = 0, by_v = 0;
        for (std::size_t line = 0; line < 4; ++line)
            for (std::size_t i = 0; i < 3; ++i) {
                const auto way = [&](std::size_t from, std::size_t to) {
                    const offsets &p = of.points[from], &q = of.points[to];
                    return std::abs(p.a - q.a) + std::abs(p.b - q.b);
                };
                by_u = std::max(by_u, way(4 * line + i, 4 * line + i + 1));
                by_v = std::max(by_v, way(4 * i + line, 4 * i + line + 4));
            }
        return by_u > by_v;
    }

    double width_, slack_;
    const std::function<void(double, double)>& found_;
    int parts_ = 0;
};

} // namespace

void clip_ray(const offset_net& piece, double width,
              const std::function<void(double, double)>& found) {
    clipper(width, found).search({piece, {}, {}});
}

} // namespace reference::second
