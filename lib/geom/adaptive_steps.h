// SPDX-License-Identifier: MIT
// l3d_walk_adaptively: curves by forward differences whose step follows the pixels.
#ifndef L3D_GEOM_ADAPTIVE_STEPS_H
#define L3D_GEOM_ADAPTIVE_STEPS_H

#include "geom/forward_difference.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>

/// Counts of an adaptive walk.
struct l3d_step_counts {
    std::int64_t steps = 0;     ///< steps taken, each of three additions a coordinate
    std::int64_t halvings = 0;  ///< halvings of the step
    std::int64_t doublings = 0; ///< doublings of the step
};

/// Walks a curve to its end. Before a step that would move a coordinate by more than a pixel, the
/// step is halved. After one that leaves less than half a pixel to the next, it is doubled.
///
/// A step is doubled only where steps of twice the length fall on the curve's end. The walk is
/// exact if T is fixed point with g + 3 finest fraction bits, and control values are on a 2^-g
/// grid.
/// Shape:   one polynomial for each coordinate, at its beginning, with a step of 2^-first. Calls
///          visit(at, level, curve) there and after each step. The parameter is at / 2^finest, and
///          the step was 2^-level.
/// Units:   `pixel` in those of the coordinates.
/// Expects: 0 <= first <= finest <= 30; all differences in range. Steps of 2^-finest may be longer
///          than a pixel.
/// Source:  Lien, Shantz, Pratt, Adaptive Forward Differencing for Rendering Curves and Surfaces,
///          SIGGRAPH 1987.
template <class T, std::size_t Coordinates, class Visit>
l3d_step_counts l3d_walk_adaptively(std::array<l3d_forward_difference<T, 3>, Coordinates> curve,
                                    int first, int finest, T pixel, const Visit& visit) {
    assert(0 <= first && first <= finest && finest <= 30);
    const auto moves_more_than = [&](T length) {
        for (const auto& of : curve)
            if (of.d[1] > length || of.d[1] < -length)
                return true;
        return false;
    };
    const T half = l3d_midpoint(pixel, T(0));
    const std::int64_t end = std::int64_t{1} << finest;
    int level = first;
    l3d_step_counts counts;
    visit(std::int64_t{0}, level, curve);
    for (std::int64_t at = 0; at < end;) {
        for (; level < finest && moves_more_than(pixel); ++level, ++counts.halvings)
            for (auto& of : curve)
                of.halve();
        for (auto& of : curve)
            of.step();
        at += end >> level;
        ++counts.steps;
        visit(at, level, curve);
        if (level > 0 && at < end && at % (2 * (end >> level)) == 0 && !moves_more_than(half)) {
            for (auto& of : curve)
                of.double_step();
            --level;
            ++counts.doublings;
        }
    }
    return counts;
}

#endif
