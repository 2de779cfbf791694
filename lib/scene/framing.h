// SPDX-License-Identifier: MIT
// l3d_framed: a camera that shows the whole of a model, whatever its size and place.
#ifndef L3D_SCENE_FRAMING_H
#define L3D_SCENE_FRAMING_H

#include "base/public.h"
#include "scene/camera.h"
#include "scene/patch_scene.h"
#include "tool_2d/pixels.h"

#include <functional>
#include <string>

/// The reach of a thing along a direction: the largest dot product of the direction with any of its
/// points; minus infinity without points.
using l3d_reach = std::function<double(const l3d_vector<double, 3>& direction)>;

/// The reach of the surfaces of a scene, not of their control points. It is too large by at most
/// 1/10000 of the span of the control points.
/// Lives:   borrows the scene.
/// Cost:    16 products for each patch, and some for the few that reach farthest.
L3D_PUBLIC l3d_reach l3d_reach_of(const l3d_patch_scene& scene);

/// The part of a picture's width or height that a framed model fills. The rest is room to turn it.
inline constexpr double l3d_framed_share = 0.85;

/// The camera that shows all of a model in a picture of that size, seen along the same line of
/// sight, with the same `up` and `fov`. It fills l3d_framed_share of the width or of the height,
/// and no more of the other. The target is in the middle of the model's depth. `near` becomes
/// smaller if the model is too small or near for it.
///
/// In a parallel projection, the distance of the target decides on sizes.
/// Expects: a valid camera.
/// Errors:  none: the camera stays as it is if there is nothing to show, and an eye
///          that would be farther than l3d_farthest_eye from the origin stays within.
L3D_PUBLIC l3d_camera l3d_framed(const l3d_camera& camera, l3d_size size, const l3d_reach& reach);

/// Whether a picture of that size shows all of a model well: at 60 % or more of its width or
/// height, and not near one border with much room opposite. A parallel projection is never said to.
/// Expects: a valid camera.
L3D_PUBLIC bool l3d_shows_well(const l3d_camera& camera, l3d_size size, const l3d_reach& reach);

/// The reason why a picture shows nothing of a model, such as "behind the eye"; "" if it may show
/// something. A model whose picture is less than one pixel wide and high is "smaller than a pixel".
/// Expects: a valid camera. In parallel projection nothing is behind the eye.
L3D_PUBLIC std::string l3d_why_unseen(const l3d_camera& camera, l3d_size size,
                                      const l3d_reach& reach);

/// The answer of l3d_why_unseen for a model smaller than a pixel, which may still cover a pixel's
/// middle.
inline constexpr const char* l3d_smaller_than_a_pixel = "smaller than a pixel";

/// The answer of l3d_why_unseen for a model that no eye may be near enough to.
inline constexpr const char* l3d_too_small =
    "too small for any view, whose eye is 1e-32 away at least";

/// The answer of pipelines for a model whose faces or patches are all points or lines.
inline constexpr const char* l3d_without_area = "without any area";

/// The camera itself if it l3d_shows_well, else l3d_framed. Expects, Errors: as these.
L3D_PUBLIC l3d_camera l3d_framed_unless_well(const l3d_camera& camera, l3d_size size,
                                             const l3d_reach& reach);

#endif
