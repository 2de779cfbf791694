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

/// The way in which a surface's pixels get their colour. n is the unit normal, turned to the eye,
/// and l the direction to the light.
enum class L3D_PUBLIC l3d_shade {
    /// Each pixel takes a unit normal of its own; its grey level is round(255 (0.1 + 0.9
    /// max(0, n.l))).
    lambert,
    /// Each vertex has lambert's grey level; pixels interpolate between vertices.
    gouraud,
    /// Each quad has one grey level, from the mean of its normals.
    flat,
    /// Each pixel shows its normal: red, green and blue are round(255 (n + 1) / 2).
    normals,
    /// Each l3d_surface_part has one colour, its `error_color`. The caller chooses this colour by
    /// the bound of the part's error.
    error,

    // The next five take the patch's exact derivatives at each pixel; l3d_inspection describes
    // them.

    /// Stripes that show the direction of the reflected ray; see l3d_inspection.
    zebra,
    /// Stripes of equal angles between the normal and the light; see l3d_inspection.
    isophotes,
    /// Gaussian curvature on a colour scale; see l3d_inspection.
    gaussian,
    /// Mean curvature on a colour scale; see l3d_inspection.
    mean,
    /// The angle between the surface and a direction, on a colour scale; see l3d_inspection.
    draft,

    /// The program's function, l3d_own_shade, colours each pixel by its exact place on its patch.
    /// Users cannot choose this shade, so it has no name.
    own,

    /// Pixels have Lambert's grey, interpolated between levels that were computed with the surface.
    /// Vertices have their level and their sides' bends (l3d_micro_vertex) in place of normals.
    /// Users cannot choose this shade.
    levels,
};

/// The names of the shades that users can choose, in the order of l3d_shade.
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

/// The number of shades, from the first on, that need the vertices' normals and nothing else.
inline constexpr std::size_t l3d_shades_of_normals = 4;

/// Whether a shade inspects a surface by the exact derivatives of patches.
constexpr bool l3d_is_inspection(l3d_shade shade) {
    return shade >= l3d_shade::zebra && shade <= l3d_shade::draft;
}

/// Whether a shade finds each pixel's exact place on its patch, and so needs exact patches.
constexpr bool l3d_sees_patches(l3d_shade shade) {
    return l3d_is_inspection(shade) || shade == l3d_shade::own;
}

/// Whether a shade shows the light of lamps.
constexpr bool l3d_is_light(l3d_shade shade) {
    return shade != l3d_shade::normals && shade != l3d_shade::error && !l3d_sees_patches(shade);
}

/// Whether a shade's colours stand for numbers. Fog would falsify such colours.
constexpr bool l3d_has_scale(l3d_shade shade) {
    return shade == l3d_shade::error || l3d_is_inspection(shade);
}

/// The place of a patch that is seen at a place of the picture, for l3d_own_shade. Places and
/// directions are in world space.
struct L3D_PUBLIC l3d_seen_place {
    double x = 0, y = 0; ///< place in the picture, from its top left corner, in pixels
    double u = 0, v = 0; ///< the patch's parameters at that place
    l3d_vector<double, 3> point{0.0, 0.0, 0.0}; ///< the exact point of the patch
    /// The unit normal, turned to the eye; 0 where the patch has none.
    l3d_vector<double, 3> normal{0.0, 0.0, 0.0};
    double light = 0;        ///< 0.1 + 0.9 max(0, n . l), where l goes towards the first light
    l3d_material material{}; ///< the patch's material
};

/// A function of the program that colours surfaces, for l3d_shade::own.
///
/// The function gets runs of neighbouring pixels of a row, and writes a pixel word 0x00RRGGBB for
/// each pixel. At edges, the function gets single places within a pixel, and the colours of these
/// places are mixed. If the function's colours depend on more than the places, the picture depends
/// on the number of threads.
/// Expects: a function that may be called by several threads at once, and does not throw.
struct L3D_PUBLIC l3d_own_shade {
    /// Colours places. Shape: one word for each place.
    std::function<void(std::span<const l3d_seen_place> places, std::span<std::uint32_t> words)>
        colors{};

    /// The largest error of a word against the colour that the program means for the place. A frame
    /// reports it as the bound of its shades.
    /// Units: levels of 255; infinite if it is unknown.
    double error = std::numeric_limits<double>::infinity();
};

/// The settings of the shades that inspect a surface. n is the unit normal, turned to the eye.
///
/// - `zebra`: dark and bright stripes of the angle between `direction` and the reflected ray that
///   reaches the eye. Stripes break where normals jump, and have a corner where curvatures jump.
/// - `isophotes`: stripes of the angle between n and the light.
/// - `gaussian`, `mean`: curvature, from blue (negative) over white (0) to red. Mean curvature is
///   positive where the surface bends towards n, as a bowl that is seen from above.
/// - `draft`: the angle between the surface and `direction`, from red (negative) over yellow (0) to
///   green. The angle is positive where n goes along `direction`.
struct L3D_PUBLIC l3d_inspection {
    /// The direction from which `zebra` and `draft` measure angles. World space, any length but 0.
    l3d_vector<double, 3> direction{0.0, 1.0, 0.0};

    /// The number at the end of the colour scale, which begins at its negative. 0 chooses a number
    /// that suits the scene.
    /// Units: 1 / world units squared for `gaussian`, 1 / world units for `mean`, degrees for
    ///        `draft`.
    double scale = 0;

    /// The width of each stripe of `zebra` and `isophotes`. Units: degrees.
    double stripe = 10;

    /// A scale for draft angles that suits most parts. Units: degrees.
    static constexpr double usual_draft = 15;

    friend bool operator==(const l3d_inspection&, const l3d_inspection&) = default;
};

/// The pixel word of a number on a shade's colour scale, which goes from -scale to scale. Numbers
/// beyond an end of the scale get the colour of this end; NaN gives grey.
/// Expects: `gaussian`, `mean` or `draft`; a positive scale.
L3D_PUBLIC std::uint32_t l3d_inspection_color(l3d_shade shade, double number, double scale);

/// The pixel word of a square with stripes: the mean over the square, in which the angle changes
/// linearly. `across` and `down` are its changes along the square's sides. An angle beyond 0 or 180
/// degrees counts as mirrored there.
/// Units: all in degrees: the angle in the square's middle, its changes, and the width of a stripe.
/// Expects: a positive stripe; changes of at least 0.
L3D_PUBLIC l3d_color l3d_stripe_color(double angle, double across, double down, double stripe);

/// The colours of a shade's scale, evenly spaced, for l3d_panel::add_scale. They go from -scale to
/// scale, or for stripes from 0 to 180 degrees.
/// Expects: l3d_is_inspection(shade).
L3D_PUBLIC std::vector<std::uint32_t> l3d_inspection_colors(l3d_shade shade,
                                                            const l3d_inspection& inspection);

struct l3d_inspected_patches;

#endif
