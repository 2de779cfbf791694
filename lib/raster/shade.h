// SPDX-License-Identifier: MIT
// l3d_shade: the ways to colour a surface, and their names; colours by the program and by a
// surface's shape.
#ifndef L3D_RASTER_SHADE_H
#define L3D_RASTER_SHADE_H

#include "base/color.h"
#include "base/public.h"
#include "geom/material.h"
#include "geom/vector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <utility>
#include <vector>

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

/// The place of a patch that the eye sees in a pixel. Places and directions are in world space.
struct L3D_PUBLIC l3d_seen_place {
    double x = 0, y = 0; ///< place in the picture, from its top left corner, in pixels
    double u = 0, v = 0; ///< the patch's parameters there
    l3d_vector<double, 3> point{0.0, 0.0, 0.0}; ///< the exact point of the patch
    /// The unit normal, turned to the eye; 0 where the patch has none.
    l3d_vector<double, 3> normal{0.0, 0.0, 0.0};
    double light = 0;        ///< 0.1 + 0.9 max(0, n . l), where l goes towards the first light
    l3d_material material{}; ///< the patch's
};

/// A function of the program that colours surfaces, for l3d_shade::own.
///
/// It gets runs of neighbouring pixels of a row, and writes a pixel word 0x00RRGGBB for each. At
/// edges, it gets single places within a pixel, whose colours are mixed. Colours that depend on
/// more than the places make the picture depend on the number of threads.
/// Expects: a function that may be called by several threads at once, and does not throw.
struct L3D_PUBLIC l3d_own_shade {
    /// Colours places. Shape: as many words as places.
    std::function<void(std::span<const l3d_seen_place> places, std::span<std::uint32_t> words)>
        colors{};

    /// The largest error of a word against the colour that the program means for the place. Frames
    /// report it as their bound of shades. Units: levels of 255; infinite if it is unknown.
    double error = std::numeric_limits<double>::infinity();
};

/// The settings of the shades that inspect a surface. n is the unit normal, turned to the eye.
///
/// - `zebra`: dark and bright stripes of the angle between the direction and the ray that the eye
///   sees reflected. Where they break, normals do; where they have a corner, curvatures break.
/// - `isophotes`: the same for the angle between n and the light.
/// - `gaussian`, `mean`: curvature, from blue over white, 0, to red. Mean curvature is positive
///   where the surface bends towards n, as a bowl that is seen from above.
/// - `draft`: the angle between the surface and the direction, from red over yellow, 0, to green.
///   It is positive where n goes along the direction.
struct L3D_PUBLIC l3d_inspection {
    /// The direction from which `zebra` and `draft` measure angles. World space, any length but 0.
    l3d_vector<double, 3> direction{0.0, 1.0, 0.0};

    /// The number at the scale's end; its negative is at the beginning. 0 chooses one that suits
    /// the scene. Units: 1 / world units squared for `gaussian`, 1 / world units for `mean`,
    /// degrees for `draft`.
    double scale = 0;

    /// The width of each stripe of `zebra` and `isophotes`. Units: degrees.
    double stripe = 10;

    /// The end of a draft angle's scale that suits most parts. Units: degrees.
    static constexpr double usual_draft = 15;

    friend bool operator==(const l3d_inspection&, const l3d_inspection&) = default;
};

/// The pixel word of a number by the scale of a shade; numbers beyond the ends get the ends'
/// colours.
/// Expects: `gaussian`, `mean` or `draft`; a positive scale; NaN gives grey.
L3D_PUBLIC std::uint32_t l3d_inspection_color(l3d_shade shade, double number, double scale);

/// The pixel word of stripes, in the mean over a square in which the angle is linear. Beyond 0 and
/// 180 degrees it turns back.
/// Units: all in degrees: the angle in the middle, its changes along both sides of the square, the
///        width of a stripe.
/// Expects: a positive stripe; changes of at least 0.
L3D_PUBLIC l3d_color l3d_stripe_color(double angle, double across, double down, double stripe);

/// The colours of a shade's scale, evenly spaced, as l3d_panel::add_scale takes them: from -scale
/// to scale, or for stripes from 0 to 180 degrees.
/// Expects: l3d_is_inspection(shade).
L3D_PUBLIC std::vector<std::uint32_t> l3d_inspection_colors(l3d_shade shade,
                                                            const l3d_inspection& inspection);

struct l3d_inspected_patches;

#endif
