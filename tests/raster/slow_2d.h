// SPDX-License-Identifier: MIT
// The slow, obvious twin of the 2D rasterizer: the rules as they are written, pixel by pixel, in
// whole numbers of 128 bits.
#ifndef L3D_TESTS_RASTER_SLOW_2D_H
#define L3D_TESTS_RASTER_SLOW_2D_H

#include "raster/rasterizer_2d.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace slow_2d {

__extension__ typedef __int128 wide;

/// A position in 1/256 pixel; pixel (x, y) is sampled at (256 x, 256 y).
struct point {
    wide x, y;
};

using outline = std::vector<point>;

inline point rounded(double x, double y) {
    const auto raw = [](double v) { // 2^30 pixels less the half pixel by which lattices differ
        constexpr double most = 256.0 * (1 << 30) - 128;
        return static_cast<wide>(std::llrint(std::clamp(v * 256, -most, most)));
    };
    return {raw(x), raw(y)};
}

template <class Corners> outline rounded(const Corners& corners) {
    outline result;
    for (const auto& c : corners)
        result.push_back(rounded(c.x, c.y));
    return result;
}

/// How often an outline winds around a pixel: edges on the pixel's row that pass left of its
/// sample or through it, those downwards less those upwards. The upper end of an edge belongs to
/// it, the lower does not.
inline int winding(const outline& v, int x, int y) {
    const wide px = wide{256} * x, py = wide{256} * y;
    int turns = 0;
    for (std::size_t i = 0; i < v.size(); ++i) {
        const point &from = v[i], &to = v[(i + 1) % v.size()];
        const bool down = from.y < to.y;
        const point &upper = down ? from : to, &lower = down ? to : from;
        if (py < upper.y || py >= lower.y)
            continue;
        const wide side =
            (px - upper.x) * (lower.y - upper.y) - (py - upper.y) * (lower.x - upper.x);
        if (side >= 0)
            turns += down ? 1 : -1;
    }
    return turns;
}

inline wide doubled_area(const point& a, const point& b, const point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// A channel of a triangle's colour at a pixel: the corners' by the areas opposite them.
inline long double channel(const outline& v, const std::vector<std::uint32_t>& colors, int shift,
                           int x, int y) {
    const point p{wide{256} * x, wide{256} * y};
    const auto part = [&](std::size_t i, const point& b, const point& c) {
        return doubled_area(p, b, c) * static_cast<wide>(colors[i] >> shift & 255);
    };
    const wide sum = part(0, v[1], v[2]) + part(1, v[2], v[0]) + part(2, v[0], v[1]);
    return static_cast<long double>(sum) / static_cast<long double>(doubled_area(v[0], v[1], v[2]));
}

/// ceil(n / d - 1/2) for d > 0: the nearest whole number, of two the smaller.
inline wide nearest(wide n, wide d) {
    const wide twice = 2 * n - d;
    const wide down = twice / (2 * d);
    return down + (twice > down * 2 * d ? 1 : 0);
}

/// The pixel of step i of a line, counted from its first end.
inline std::pair<wide, wide> pixel_of_line(const l3d_line_2d& l, wide i) {
    const wide dx = wide{l.x1} - l.x0, dy = wide{l.y1} - l.y0;
    const wide length = std::max(dx < 0 ? -dx : dx, dy < 0 ? -dy : dy);
    if (length == 0)
        return {l.x0, l.y0};
    return {l.x0 + nearest(i * dx, length), l.y0 + nearest(i * dy, length)};
}

/// How much of a pixel a smooth line covers, 0 to 1: the formula of draw_line_antialiased.
inline long double coverage(l3d_point_2d from, l3d_point_2d to, int x, int y) {
    point a = rounded(from.x, from.y), b = rounded(to.x, to.y), p{wide{256} * x, wide{256} * y};
    const auto size = [](wide n) { return n < 0 ? -n : n; };
    if (size(b.x - a.x) < size(b.y - a.y)) {
        std::swap(a.x, a.y);
        std::swap(b.x, b.y);
        std::swap(p.x, p.y);
    }
    if (a.x > b.x)
        std::swap(a, b);
    const wide begin = std::max(p.x - 128, a.x - 128), end = std::min(p.x + 128, b.x + 128);
    const wide length = std::max<wide>(b.x - a.x, 1);
    const wide distance = size((p.y - a.y) * length - (b.y - a.y) * (p.x - a.x));
    if (begin >= end || distance >= 256 * length)
        return 0;
    return static_cast<long double>(end - begin) / 256 *
           (1 - static_cast<long double>(distance) / (256 * static_cast<long double>(length)));
}

} // namespace slow_2d

#endif
