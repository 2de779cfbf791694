// SPDX-License-Identifier: MIT
// Where a straight line meets a bicubic piece: Bezier clipping.
#ifndef L3D_REFERENCE_RAY_CLIP_H
#define L3D_REFERENCE_RAY_CLIP_H

#include <array>
#include <functional>

namespace reference::second {

/// The signed distances of one control point from two planes that meet in the line.
struct offsets {
    double a = 0, b = 0;
};

/// The offsets of a piece's control points. Shape: points[4 * row + column]; rows run along v,
/// columns along u.
using offset_net = std::array<offsets, 16>;

/// Calls `found(u, v)` for each point of the piece that lies on the line, where a = b = 0. A point
/// that is hard to tell from a neighbour may be found more than once.
///
/// The convex hull of the distances from a line across the piece shows which parts have no zero.
/// These are cut off at both ends, in u and in v by turns. A piece that does not shrink by this is
/// halved.
///
/// Source:  Nishita, Sederberg, Kakimoto, *Ray tracing trimmed rational surface patches*, SIGGRAPH
///          1990.
///
/// Units:   u, v of the piece, 0 to 1. `width` is in units of the offsets: a piece narrower than
///          this counts as a point. Points within a thousandth of it count as on the line. At a
///          fold that bends with a radius of R widths, that is a stretch of sqrt(R / 500), in as
///          many parts.
/// Errors:  std::runtime_error after 100000 parts.
void clip_ray(const offset_net& piece, double width,
              const std::function<void(double, double)>& found);

} // namespace reference::second

#endif
