// SPDX-License-Identifier: MIT
// l3d_ray_search: looks into parts in order of depth, and proves hits by Krawczyk's operator.
#include "scene/picks/ray_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

namespace {

/// The share of its size by which a part grows at each side before a hit in it is proven. So a
/// point on the border of two parts, or of two patches, lies inside both.
constexpr double margin = 0.125;
/// The largest contraction with which Newton's operator proves a hit. Then the image of a part that
/// holds a hit lies inside the inflated part: 2 x 0.08 x 0.625 <= 0.125.
constexpr double most_contraction = 0.08;
/// Parts whose distance from the ray is less than this many errors are not split, since nobody
/// could tell which half holds the hit.
constexpr double blurred_errors = 16;
/// Parts that are no larger than this along u are not split along u. The same holds for v.
constexpr double least_size = 0x1p-48;
/// The largest number of steps of a search: far more than a ray needs, unless it runs along a
/// surface. After so many steps, no part is split.
constexpr long most_steps = 1 << 16;
/// The largest number of parts that are looked at to join unproven hits: 50 halvings of a few parts
/// at a time.
constexpr int most_joined = 1 << 10;

struct range {
    double low, high;

    double middle() const { return (low + high) / 2; }
    double width() const { return high - low; }
};

/// The net of the same surface for u and v from -margin to 1 + margin.
l3d_ray_net inflated(const l3d_ray_net& net) {
    using curve = l3d_ray_net::curve;
    const auto stretched = [](const curve& c) {
        // The blossom at three arguments, each one of the two new ends.
        const auto blossom = [&](double a, double b, double d) {
            std::array<l3d_ray_net::point, 4> p{c.points[0], c.points[1], c.points[2], c.points[3]};
            int left = 3;
            for (const double t : {a, b, d}) {
                for (std::size_t i = 0; i < static_cast<std::size_t>(left); ++i)
                    p[i] = p[i] * (1 - t) + p[i + 1] * t;
                --left;
            }
            return p[0];
        };
        constexpr double from = -margin, to = 1 + margin;
        return curve{{blossom(from, from, from), blossom(from, from, to), blossom(from, to, to),
                      blossom(to, to, to)}};
    };
    l3d_ray_net rows, result;
    for (int r = 0; r < 4; ++r) {
        const curve row = stretched(net.row(r));
        for (int c = 0; c < 4; ++c)
            rows.at(r, c) = row.points[static_cast<std::size_t>(c)];
    }
    for (int c = 0; c < 4; ++c) {
        const curve column = stretched(rows.column(c));
        for (int r = 0; r < 4; ++r)
            result.at(r, c) = column.points[static_cast<std::size_t>(r)];
    }
    return result;
}

/// Bounds of the derivative of a coordinate by u or v, over all of the net.
range slope(const l3d_ray_net& net, int coordinate, bool along_v) {
    range result{};
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k) {
            const double d = along_v ? net.at(k + 1, i)[coordinate] - net.at(k, i)[coordinate]
                                     : net.at(i, k + 1)[coordinate] - net.at(i, k)[coordinate];
            if (i == 0 && k == 0)
                result = {d, d};
            result = {std::min(result.low, d), std::max(result.high, d)};
        }
    return {3 * result.low, 3 * result.high};
}

/// Newton's step towards a hit, with one matrix for a whole part of a patch, and a bound of its
/// contraction in the part.
struct operator_of {
    double inverse[2][2];
    double contraction; ///< bound of the contraction, in the maximum norm
    bool exists = false;

    /// Expects: an inflated part, whose own parameters go from 0 to 1.
    explicit operator_of(const l3d_ray_net& part) {
        range j[2][2];
        for (int coordinate = 0; coordinate < 2; ++coordinate)
            for (int along = 0; along < 2; ++along)
                j[coordinate][along] = slope(part, coordinate, along == 1);
        const double a = j[0][0].middle(), b = j[0][1].middle();
        const double c = j[1][0].middle(), d = j[1][1].middle();
        const double determinant = a * d - b * c;
        // Nothing is proven if the determinant may be 0 within its rounding.
        if (!(std::abs(determinant) > 0x1p-40 * (std::abs(a * d) + std::abs(b * c))))
            return;
        exists = true;
        inverse[0][0] = d / determinant, inverse[0][1] = -b / determinant;
        inverse[1][0] = -c / determinant, inverse[1][1] = a / determinant;
        contraction = 0;
        for (const auto& row : inverse) {
            double sum = 0;
            for (int along = 0; along < 2; ++along)
                sum += std::abs(row[0]) * j[0][along].width() / 2 +
                       std::abs(row[1]) * j[1][along].width() / 2;
            contraction = std::max(contraction, sum);
        }
        // The inverse has a relative error of 2^-53 / 2^-40 at most, and some roundings.
        contraction += 0x1p-12;
    }

    std::array<double, 2> step(const l3d_ray_net::point& f) const {
        return {inverse[0][0] * f[0] + inverse[0][1] * f[1],
                inverse[1][0] * f[0] + inverse[1][1] * f[1]};
    }
    /// The most by which a step changes if values of the net err by `error`.
    double blur(double error) const {
        return error * std::max(std::abs(inverse[0][0]) + std::abs(inverse[0][1]),
                                std::abs(inverse[1][0]) + std::abs(inverse[1][1]));
    }
};

} // namespace

bool l3d_ray_search::may_be_met(const l3d_ray_net& net, double error) const {
    const auto [low, high] = net.bounds();
    return low[0] <= error && high[0] >= -error && low[1] <= error && high[1] >= -error &&
           high[2] + error >= near_ && low[2] - error <= far_;
}

void l3d_ray_search::add(std::size_t patch, const l3d_ray_net& net, double error) {
    if (!may_be_met(net, error))
        return;
    roots_.push_back({patch, net, error});
    part whole{};
    whole.net = net;
    whole.root = roots_.size() - 1;
    push(std::move(whole));
}

void l3d_ray_search::push(part one, const std::optional<l3d_ray_hit>& hit) {
    one.least_depth = hit && hit->is_proven ? hit->depth : one.net.w().least;
    one.hit = hit;
    heap_.push_back(std::move(one));
    std::ranges::push_heap(heap_, std::greater(), &part::least_depth);
}

l3d_ray_search::part l3d_ray_search::pop() {
    std::ranges::pop_heap(heap_, std::greater(), &part::least_depth);
    part result = std::move(heap_.back());
    heap_.pop_back();
    return result;
}

std::optional<l3d_ray_hit> l3d_ray_search::nearest() {
    while (!heap_.empty()) {
        const part one = pop();
        if (!one.hit)
            look_into(one);
        else if (one.hit->is_proven)
            return one.hit;
        else
            return joined(*one.hit);
    }
    return std::nullopt;
}

void l3d_ray_search::look_into(const part& one) {
    const double error = roots_[one.root].error;
    if (settle(one))
        return;
    const auto [low, high] = one.net.bounds();
    const double widest = std::max(high[0] - low[0], high[1] - low[1]);
    const bool is_least = one.u1 - one.u0 < least_size && one.v1 - one.v0 < least_size;
    if (widest <= blurred_errors * error || is_least || ++steps_ > most_steps)
        keep_unproven(one);
    else
        split(one);
}

/// Splits a part across the direction in which it is larger, as the ray sees it.
void l3d_ray_search::split(const part& one) {
    double along_u = 0, along_v = 0;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 3; ++k)
            for (int coordinate = 0; coordinate < 2; ++coordinate) {
                const auto gap = [&](const auto& a, const auto& b) {
                    return std::abs(a[coordinate] - b[coordinate]);
                };
                along_u = std::max(along_u, gap(one.net.at(i, k), one.net.at(i, k + 1)));
                along_v = std::max(along_v, gap(one.net.at(k, i), one.net.at(k + 1, i)));
            }
    for (part& half : l3d_halves(one, along_u >= along_v ? one.u1 - one.u0 >= least_size
                                                         : one.v1 - one.v0 < least_size))
        if (may_be_met(half.net, roots_[one.root].error))
            push(std::move(half));
}

/// Settles a part if possible. Returns true if the part certainly has no hit, or if its only hit is
/// now in the heap.
bool l3d_ray_search::settle(const part& one) {
    const root& whole = roots_[one.root];
    const l3d_ray_net larger = inflated(one.net);
    const operator_of newton(larger);
    if (!newton.exists || newton.contraction > most_contraction)
        return false;
    // In parameters of the inflated part, the part itself is from `edge` to 1 - edge.
    constexpr double size = 1 + 2 * margin, edge = margin / size;
    double at[2] = {0.5, 0.5};
    const double blur = newton.blur(whole.error);
    const auto first = newton.step(larger.evaluate(at[0], at[1]));
    const double reach = newton.contraction / 2 + blur; // half the image's side
    for (const double step : first)
        if (std::abs(step) - reach > 0.5 - edge)
            return true; // the image is beside the part
    for (const double step : first)
        if (std::abs(step) + reach > 0.5)
            return false;
    // The image is inside, so there is exactly one hit. The last step bounds the distance that is
    // left.
    double left = 1;
    for (int i = 0; i < 8 && left > blur; ++i) {
        const auto step = newton.step(larger.evaluate(at[0], at[1]));
        at[0] -= step[0];
        at[1] -= step[1];
        left = std::max(std::abs(step[0]), std::abs(step[1]));
    }
    const double du = (one.u1 - one.u0) * size, dv = (one.v1 - one.v0) * size;
    l3d_ray_hit hit{.patch = whole.patch,
                    .u = one.u0 + (at[0] - edge) * du,
                    .v = one.v0 + (at[1] - edge) * dv,
                    .is_proven = true};
    // A last step, from the whole net: `error` bounds that net's rounding.
    const auto rest = newton.step(whole.net.evaluate(hit.u, hit.v));
    const double off =
        (std::max(std::abs(rest[0]), std::abs(rest[1])) + blur) / (1 - newton.contraction);
    hit.u_error = off * du + 0x1p-52;
    hit.v_error = off * dv + 0x1p-52;
    const auto beside = [](double t, double error) { return t < -error || t > 1 + error; };
    if (beside(hit.u, hit.u_error) || beside(hit.v, hit.v_error))
        return true;
    const auto bring_inside = [](double& t, double& error) {
        const double inside = std::clamp(t, 0.0, 1.0);
        error += std::abs(std::exchange(t, inside) - inside);
    };
    bring_inside(hit.u, hit.u_error);
    bring_inside(hit.v, hit.v_error);
    hit.depth = whole.net.evaluate(hit.u, hit.v)[2];
    if (hit.depth >= near_ && hit.depth <= far_ && is_seen_(hit))
        push(one, hit);
    return true;
}

void l3d_ray_search::keep_unproven(const part& one) {
    const auto [low, high] = one.net.bounds();
    push(one,
         l3d_ray_hit{.patch = roots_[one.root].patch,
                     .u = (one.u0 + one.u1) / 2,
                     .v = (one.v0 + one.v1) / 2,
                     .u_error = (one.u1 - one.u0) / 2,
                     .v_error = (one.v1 - one.v0) / 2,
                     .depth = (low[2] + high[2]) / 2,
                     .width = (high[0] - low[0]) + (high[1] - low[1]) + 2 * roots_[one.root].error,
                     .depth_width = high[2] - low[2]});
}

/// Joins unproven hits that lie side by side along an outline, since any of these hits may be the
/// nearest.
l3d_ray_hit l3d_ray_search::joined(l3d_ray_hit first) {
    const double front = first.depth - first.depth_width / 2;
    double back = front + first.depth_width;
    for (int i = 0; i < most_joined && !heap_.empty(); ++i) {
        if (heap_.front().least_depth > back)
            break;
        const part next = pop();
        if (!next.hit) {
            look_into(next);
            continue;
        }
        const l3d_ray_hit& other = *next.hit;
        back = std::max(back, other.depth + other.depth_width / 2);
        first.width = std::max(first.width, other.width);
        if (other.patch == first.patch) {
            first.u_error = std::max(first.u_error, std::abs(other.u - first.u) + other.u_error);
            first.v_error = std::max(first.v_error, std::abs(other.v - first.v) + other.v_error);
        }
    }
    first.depth_width = back - front;
    first.depth = (front + back) / 2;
    return first;
}
