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

/// A piece of a patch: the control points of its own parameters (0 to 1), and where it lies in the
/// whole patch: u = u0 + du * own u.
struct net {
    std::array<hpoint, 16> points;
    double u0 = 0, v0 = 0, du = 1, dv = 1;
};

net make_net(const patch& surface, const camera_frame& frame);

std::pair<net, net> halves_u(const net& whole);
std::pair<net, net> halves_v(const net& whole);

/// Halves along the parameter that is longer in the picture; along the one that changes w more if
/// the piece reaches behind the eye and has no picture.
std::pair<net, net> halves(const net& whole);

/// A point with its derivatives by the own parameters, all before the division.
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

/// True if no surface point with w > 0 can lie inside the rectangle. Any sign of the w allowed.
bool is_outside(const net& piece, const rect& window);

/// True if the projected control points lie within `width` pixels of one straight line.
/// Expects: all w > 0.
bool is_line(const net& piece, double width);

} // namespace reference

#endif
