// SPDX-License-Identifier: MIT
// l3d_shade: the ways to colour a surface, and their names.
#ifndef L3D_RASTER_SHADE_H
#define L3D_RASTER_SHADE_H

#include "base/public.h"

#include <array>
#include <cstddef>
#include <utility>

/// The way in which a surface's pixels get their colour.
enum class L3D_PUBLIC l3d_shade {
    /// A unit normal for each pixel; its grey level is round(255 (0.1 + 0.9 max(0, n.l))).
    lambert,
    /// The same grey level for each vertex, interpolated between them.
    gouraud,
    /// One grey level for each quad, from the mean of its normals.
    flat,
    /// Red, green and blue are round(255 (n + 1) / 2).
    normals,
    /// Each part has one colour, its `error_color`, by the known bound of its error.
    error,

    // The next five take the patch's exact derivatives at each pixel; l3d_inspection describes
    // them.

    /// Stripes of reflected rays.
    zebra,
    /// Stripes of equal light.
    isophotes,
    /// Gaussian curvature.
    gaussian,
    /// Mean curvature.
    mean,
    /// The angle between the surface and a direction.
    draft,

    /// The program's function, l3d_own_shade, colours each pixel's exact place on its patch. It has
    /// no name: users cannot choose it.
    own,

    /// Lambert's grey from levels that were made with the surface: vertices have their level and
    /// their sides' bends (l3d_micro_vertex) in place of normals. Users cannot choose it.
    levels,
};

/// The names of the ways that users can choose, in the order of their values.
inline constexpr std::array<std::pair<const char*, l3d_shade>, 10> l3d_shade_names{
    {{"lambert", l3d_shade::lambert},
     {"gouraud", l3d_shade::gouraud},
     {"flat", l3d_shade::flat},
     {"normals", l3d_shade::normals},
     {"error", l3d_shade::error},
     {"zebra", l3d_shade::zebra},
     {"isophotes", l3d_shade::isophotes},
     {"gaussian", l3d_shade::gaussian},
     {"mean", l3d_shade::mean},
     {"draft", l3d_shade::draft}}};

/// The number of ways, from the first on, that need normals and nothing else.
inline constexpr std::size_t l3d_shades_of_normals = 4;

/// Whether a way inspects a surface by the exact derivatives of patches.
constexpr bool l3d_is_inspection(l3d_shade shade) {
    return shade >= l3d_shade::zebra && shade <= l3d_shade::draft;
}

/// Whether a way looks at the exact patches.
constexpr bool l3d_sees_patches(l3d_shade shade) {
    return l3d_is_inspection(shade) || shade == l3d_shade::own;
}

/// Whether a way shows the light of lamps.
constexpr bool l3d_is_light(l3d_shade shade) {
    return shade != l3d_shade::normals && shade != l3d_shade::error && !l3d_sees_patches(shade);
}

/// Whether a way's colours are those of a scale, which fog would falsify.
constexpr bool l3d_has_scale(l3d_shade shade) {
    return shade == l3d_shade::error || l3d_is_inspection(shade);
}

#endif
