// SPDX-License-Identifier: MIT
// Control nets before the division, and how to halve and bound them.
#ifndef L3D_REFERENCE_NET_H
#define L3D_REFERENCE_NET_H

#include "reference/exact.h"

#include <array>
#include <utility>

namespace reference {

struct hpoint {
    double x = 0, y = 0, w = 0;
};

/// A piece of a patch: control points for its own parameters, 0 to 1, and its place in the whole
/// patch. The patch's u is u0 + du * own u; v likewise has v0 and dv.
struct net {
    std::array<hpoint, 16> points;
    double u0 = 0, v0 = 0, du = 1, dv = 1;
};

net make_net(const patch& surface, const camera_frame& frame);

std::pair<net, net> halves_u(const net& whole);
std::pair<net, net> halves_v(const net& whole);

/// Halves a piece along the parameter that is longer in the picture. If the piece reaches behind
/// the eye and has no picture, that is the parameter along which w changes more.
std::pair<net, net> halves(const net& whole);

/// A point with its derivatives by the piece's own parameters, all before the division.
struct jet {
    hpoint value, by_u, by_v;
};
jet evaluate(const net& piece, double u, double v);

struct rect {
    double x0, y0, x1, y1;

    bool touches(const rect& other) const {
        return x0 <= other.x1 && other.x0 <= x1 && y0 <= other.y1 && other.y0 <= y1;
    }
};

struct range {
    double low, high;
};
range depth_range(const net& piece);

/// The smallest rectangle around the projected control points.
/// Expects: all w > 0.
rect bounding_box(const net& piece);

/// Whether no surface point with w > 0 can lie inside the rectangle. The signs of w may be any.
bool is_outside(const net& piece, const rect& window);

/// Whether the projected control points lie within `width` pixels of one straight line.
/// Expects: all w > 0.
bool is_line(const net& piece, double width);

} // namespace reference

#endif
