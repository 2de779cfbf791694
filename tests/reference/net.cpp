// SPDX-License-Identifier: MIT
// Control nets before the division: halving, bounds, values.
#include "reference/net.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace reference {
namespace {

hpoint middle(const hpoint& a, const hpoint& b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.w + b.w) / 2};
}

/// Halves four points that lie `step` apart in the net.
void halve_curve(const net& whole, net& low, net& high, std::size_t first, std::size_t step) {
    const auto at = [&](std::size_t i) { return first + i * step; };
    const hpoint& a = whole.points[at(0)];
    const hpoint& d = whole.points[at(3)];
    const hpoint ab = middle(a, whole.points[at(1)]);
    const hpoint bc = middle(whole.points[at(1)], whole.points[at(2)]);
    const hpoint cd = middle(whole.points[at(2)], d);
    const hpoint abc = middle(ab, bc), bcd = middle(bc, cd);
    low.points[at(0)] = a;
    low.points[at(1)] = ab;
    low.points[at(2)] = abc;
    low.points[at(3)] = high.points[at(0)] = middle(abc, bcd);
    high.points[at(1)] = bcd;
    high.points[at(2)] = cd;
    high.points[at(3)] = d;
}

/// Length of the longest of the four polygons that run along one parameter.
template <class Distance>
double longest(const net& piece, std::size_t step, std::size_t next, Distance distance) {
    double result = 0;
    for (std::size_t line = 0; line < 4; ++line) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t k = line * next + i * step;
            sum += distance(piece.points[k], piece.points[k + step]);
        }
        result = std::max(result, sum);
    }
    return result;
}

struct xy {
    double x, y;
};

xy projected(const hpoint& p) {
    return {p.x / p.w, p.y / p.w};
}

double squared(const xy& a, const xy& b) {
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

struct weights {
    std::array<double, 4> value, slope;
};

weights bernstein(double t) {
    const double s = 1 - t;
    return {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
            {-3 * s * s, 3 * s * (s - 2 * t), 3 * t * (2 * s - t), 3 * t * t}};
}

void add(hpoint& sum, double factor, const hpoint& p) {
    sum.x += factor * p.x;
    sum.y += factor * p.y;
    sum.w += factor * p.w;
}

} // namespace

net make_net(const patch& surface, const camera_frame& frame) {
    net result;
    for (std::size_t k = 0; k < 16; ++k) {
        const vec3& p = surface.points[k];
        const homogeneous_point h = frame.project({p.x, p.y, p.z});
        result.points[k] = {static_cast<double>(h.x), static_cast<double>(h.y),
                            static_cast<double>(h.w)};
    }
    return result;
}

std::pair<net, net> halves_u(const net& whole) {
    std::pair<net, net> result{whole, whole};
    for (std::size_t row = 0; row < 4; ++row)
        halve_curve(whole, result.first, result.second, 4 * row, 1);
    result.first.du = result.second.du = whole.du / 2;
    result.second.u0 = whole.u0 + whole.du / 2;
    return result;
}

std::pair<net, net> halves_v(const net& whole) {
    std::pair<net, net> result{whole, whole};
    for (std::size_t column = 0; column < 4; ++column)
        halve_curve(whole, result.first, result.second, column, 4);
    result.first.dv = result.second.dv = whole.dv / 2;
    result.second.v0 = whole.v0 + whole.dv / 2;
    return result;
}

std::pair<net, net> halves(const net& whole) {
    const bool has_picture = depth_range(whole).low > 0;
    const auto distance = [has_picture](const hpoint& a, const hpoint& b) {
        return has_picture ? std::sqrt(squared(projected(a), projected(b))) : std::abs(a.w - b.w);
    };
    const double along_u = longest(whole, 1, 4, distance), along_v = longest(whole, 4, 1, distance);
    if (along_u == along_v)
        return whole.du >= whole.dv ? halves_u(whole) : halves_v(whole);
    return along_u > along_v ? halves_u(whole) : halves_v(whole);
}

jet evaluate(const net& piece, double u, double v) {
    const weights in_u = bernstein(u), in_v = bernstein(v);
    jet result;
    for (std::size_t row = 0; row < 4; ++row) {
        hpoint value, slope;
        for (std::size_t i = 0; i < 4; ++i) {
            add(value, in_u.value[i], piece.points[4 * row + i]);
            add(slope, in_u.slope[i], piece.points[4 * row + i]);
        }
        add(result.value, in_v.value[row], value);
        add(result.by_v, in_v.slope[row], value);
        add(result.by_u, in_v.value[row], slope);
    }
    return result;
}

range depth_range(const net& piece) {
    range result{piece.points[0].w, piece.points[0].w};
    for (const hpoint& p : piece.points) {
        result.low = std::min(result.low, p.w);
        result.high = std::max(result.high, p.w);
    }
    return result;
}

rect bounding_box(const net& piece) {
    const xy first = projected(piece.points[0]);
    rect box{first.x, first.y, first.x, first.y};
    for (const hpoint& point : piece.points) {
        const xy p = projected(point);
        box.x0 = std::min(box.x0, p.x);
        box.y0 = std::min(box.y0, p.y);
        box.x1 = std::max(box.x1, p.x);
        box.y1 = std::max(box.y1, p.y);
    }
    return box;
}

bool is_outside(const net& piece, const rect& window) {
    const auto all = [&](auto predicate) {
        return std::all_of(piece.points.begin(), piece.points.end(), predicate);
    };
    return all([&](const hpoint& p) { return p.x < window.x0 * p.w; }) ||
           all([&](const hpoint& p) { return p.x > window.x1 * p.w; }) ||
           all([&](const hpoint& p) { return p.y < window.y0 * p.w; }) ||
           all([&](const hpoint& p) { return p.y > window.y1 * p.w; });
}

bool is_line(const net& piece, double width) {
    const auto farthest_from = [&](const xy& from) {
        xy result = from;
        for (const hpoint& p : piece.points)
            if (squared(projected(p), from) > squared(result, from))
                result = projected(p);
        return result;
    };
    const xy a = farthest_from(projected(piece.points[0]));
    const xy b = farthest_from(a);
    const double length = std::sqrt(squared(a, b));
    if (length <= width)
        return true;
    double low = 0, high = 0;
    for (const hpoint& point : piece.points) {
        const xy p = projected(point);
        const double side = ((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x)) / length;
        low = std::min(low, side);
        high = std::max(high, side);
    }
    return high - low <= width;
}

} // namespace reference
