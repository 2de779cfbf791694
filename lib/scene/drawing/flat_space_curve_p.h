// SPDX-License-Identifier: MIT
// flat_space_curve: turns curves in space into chords in the picture.
#ifndef L3D_SCENE_FLAT_SPACE_CURVE_P_H
#define L3D_SCENE_FLAT_SPACE_CURVE_P_H

#include "geom/plane.h"
#include "raster/lines/depth_lines_p.h"
#include "scene/camera.h"
#include "scene/space_curve.h"
#include "tool_2d/pixels.h"

#include <array>
#include <optional>
#include <vector>

namespace l3d_detail {

using depth_chord = std::array<depth_point, 2>;

/// Divides a curve into chords as a camera sees it, in the curve's order. Chords are cut off behind
/// the section. In perspective they are also cut off at the near and far planes. Parts outside of
/// the picture are left out where the line's width does not reach into the picture.
///
/// Every point of the curve in the picture is within `tolerance` pixels of its chord. The point's
/// depth is within `tolerance` of the chord's depth, in pixels at the point's distance. The
/// exception is a curve of over 2^16 chords between two knots.
/// Source: the control points' hull. Taken as (x / w, y / w, depth), all points of a rational
///         Bezier curve are means of the control points, with positive weights.
std::vector<depth_chord> flat_space_curve(const l3d_space_curve& curve, const l3d_camera& camera,
                                          l3d_size size, double tolerance, const depth_law& law,
                                          const std::optional<l3d_plane<double>>& section = {});

} // namespace l3d_detail

#endif
