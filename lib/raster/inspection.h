// SPDX-License-Identifier: MIT
// l3d_inspection: the quantities that inspecting shades show, and their colours.
#ifndef L3D_RASTER_INSPECTION_H
#define L3D_RASTER_INSPECTION_H

#include "base/public.h"
#include "raster/shade.h"

#include <array>
#include <cstdint>
#include <vector>

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
    std::array<double, 3> direction{0, 1, 0};

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
L3D_PUBLIC std::uint32_t l3d_stripe_color(double angle, double across, double down, double stripe);

/// The colours of a shade's scale, evenly spaced, as l3d_panel::add_scale takes them: from -scale
/// to scale, or for stripes from 0 to 180 degrees.
/// Expects: l3d_is_inspection(shade).
L3D_PUBLIC std::vector<std::uint32_t> l3d_inspection_colors(l3d_shade shade,
                                                            const l3d_inspection& inspection);

struct l3d_inspected_patches;

#endif
