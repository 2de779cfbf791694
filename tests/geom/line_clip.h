// SPDX-License-Identifier: MIT
// l3d_clip_line: what of a line is in an upright window.
#ifndef L3D_TESTS_GEOM_LINE_CLIP_H
#define L3D_TESTS_GEOM_LINE_CLIP_H

#include "geom/plane.h"

#include <algorithm>
#include <cmath>

/// Moves the ends of a line into a window; false, and nothing changes, if no point of it is there.
///
/// An end in the window stays as it is; another one goes to the border, to nearest in T, and is
/// never outside. For lines of pixels the rasterizer does without: it clips by itself, so that the
/// pixels are those of the whole line.
/// Expects: least[i] <= most[i]. A line with an end that is not finite, or longer than
///          double can say, is nowhere.
/// Cost:    see docs/BOOK.md; Cohen and Sutherland's way was measured against it.
/// Source:  Liang, Barsky: A New Concept and Method for Line Clipping (1984).
template <class T>
bool l3d_clip_line(l3d_position<T>& from, l3d_position<T>& to, const l3d_position<T>& least,
                   const l3d_position<T>& most) noexcept {
    double enters = 0;
    double leaves = 1;
    for (int axis = 0; axis < 2; ++axis) {
        const double start = l3d_to_double(from[axis]);
        const double way = l3d_to_double(to[axis]) - start;
        const double low = l3d_to_double(least[axis]) - start;
        const double high = l3d_to_double(most[axis]) - start;
        if (!std::isfinite(way))
            return false;
        if (way == 0) {
            if (!(low <= 0 && high >= 0))
                return false;
            continue;
        }
        const double at_low = low / way;
        const double at_high = high / way;
        enters = std::max(enters, std::min(at_low, at_high));
        leaves = std::min(leaves, std::max(at_low, at_high));
    }
    if (!(enters <= leaves))
        return false;
    const auto on_border = [&](double t) {
        l3d_position<T> place = l3d_part_way<T>(from, to, t);
        for (int axis = 0; axis < 2; ++axis)
            place[axis] = std::clamp(place[axis], least[axis], most[axis]);
        return place;
    };
    const l3d_position<T> last = leaves < 1 ? on_border(leaves) : to;
    if (enters > 0)
        from = on_border(enters);
    to = last;
    return true;
}

#endif
