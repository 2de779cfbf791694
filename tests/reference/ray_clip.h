// SPDX-License-Identifier: MIT
// Where a straight line meets a bicubic piece: Bezier clipping.
#ifndef L3D_REFERENCE_RAY_CLIP_H
#define L3D_REFERENCE_RAY_CLIP_H

#include <array>
#include <functional>

namespace reference::second {

/// Signed distances of one control point from two planes through the line.
struct offsets {
    double a = 0, b = 0;
};

/// Shape: points[4 * row + column]; rows run along v, columns along u.
using offset_net = std::array<offsets, 16>;

/// Calls `found(u, v)` for the points of the piece that lie on the line, a = b = 0; for one that is
/// hard to tell from a neighbour, more than once.
///
/// The convex hull of the distances from a line across the piece shows parts without a zero. They
/// are cut off at both ends, in u and in v by turns. A piece that does not shrink in this way is
/// halved (Nishita, Sederberg, Kakimoto, *Ray tracing trimmed rational surface patches*, SIGGRAPH
/// 1990).
///
/// Units:   u, v of the piece, 0 to 1; `width` in those of the offsets: what is narrower is a
/// point.
///          What is within a thousandth of it counts as on the line: at a fold that bends with a
///          radius of R widths, that is a stretch of sqrt(R / 500), in as many parts.
/// Errors:  std::runtime_error after 100000 parts.
void clip_ray(const offset_net& piece, double width,
              const std::function<void(double, double)>& found);

} // namespace reference::second

#endif
