// SPDX-License-Identifier: MIT
// Tells which of two triangles, or pieces of them, must be painted first.
#ifndef L3D_PIPELINE_ZSORT_PAINTER_OVERLAP_P_H
#define L3D_PIPELINE_ZSORT_PAINTER_OVERLAP_P_H

#include "raster/zsort/painter.h"
#include "raster/shapes/picture_plane.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace l3d_detail {

/// A place in the picture. Units: 1/256 pixel.
struct picture_point {
    double x = 0, y = 0;
};

/// The corners of a convex polygon in the picture, in either direction.
using picture_region = std::vector<picture_point>;

/// Whether each of two triangles or planes is in front of the other somewhere.
struct front_parts {
    bool first = false;  ///< whether the first is in front somewhere
    bool second = false; ///< whether the second is in front somewhere

    bool mixed() const { return first && second; }
};

/// Depths of two triangles count as different only if they differ by more than this share of a
/// reference depth. The reference is the farther one of the two triangles' nearest corners. The
/// share is 2^-12 of the difference that a depth buffer of floats tells apart, and 2^17 times the
/// rounding of doubles.
inline constexpr double painter_tie = 0x1p-36;

/// Whether the insides of two triangles meet, decided exactly. If they do not meet, the triangles
/// have no pixel in common. The reason is the fill rule, which treats a pixel's centre on an edge
/// as if the centre lay a little to the right and below.
bool insides_meet(const std::array<l3d_micro_vertex, 3>& a,
                  const std::array<l3d_micro_vertex, 3>& b);

/// Finds which of two triangles is in front in the part of the picture that both cover.
/// Expects: both triangles have an area.
front_parts front_of(const std::array<l3d_micro_vertex, 3>& a,
                     const std::array<l3d_micro_vertex, 3>& b);

/// Finds which of two planes is in front over a region of the picture. Differences of depth up to
/// `tie` do not count.
front_parts front_over(std::span<const picture_point> region, const l3d_picture_plane& first,
                       const l3d_picture_plane& second, double tie);

/// Finds the common part of two convex polygons. This part gets a margin of 2^-12 sub-pixel on all
/// sides, so that rounding loses nothing.
///
/// Lives:   `out` gets the result; `scratch` is working memory.
void intersect(std::span<const picture_point> a, std::span<const picture_point> b,
               picture_region& out, picture_region& scratch);

/// Writes to `out` the part of a region where the first plane is in front of the second plane. If
/// `in_front` is false, it is the part where the first plane is behind the second. `out` is empty
/// only if the region has no such part.
void keep_side(std::span<const picture_point> region, const l3d_picture_plane& first,
               const l3d_picture_plane& second, bool in_front, picture_region& out);

picture_region region_of(const std::array<l3d_micro_vertex, 3>& v);

/// The difference up to which depths of these two triangles count as equal (painter_tie).
double tie_of(const std::array<l3d_micro_vertex, 3>& a, const std::array<l3d_micro_vertex, 3>& b);

} // namespace l3d_detail

#endif
