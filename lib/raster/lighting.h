// SPDX-License-Identifier: MIT
// l3d_lighting: the lights of a frame, beside the direction of the first one.
#ifndef L3D_RASTER_LIGHTING_H
#define L3D_RASTER_LIGHTING_H

#include "base/public.h"
#include "geom/vector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

/// The default direction towards the first light: from above, from the right and from the front.
inline constexpr l3d_vector<double, 3> l3d_usual_light{0.4, 0.8, 0.45};

/// The red, green and blue of a light. Units: 1 in each is white; more is brighter.
using l3d_light_color = std::array<float, 3>;

/// A light so far away that its rays are parallel.
struct L3D_PUBLIC l3d_far_light {
    std::array<float, 3> direction{0, 0, 1}; ///< unit vector towards it, world space
    l3d_light_color color{1, 1, 1};          ///< its brightness

    friend bool operator==(const l3d_far_light&, const l3d_far_light&) = default;
};

/// A light at a place. Its brightness is that of its colour everywhere, or falls with the square of
/// the distance.
struct L3D_PUBLIC l3d_point_light {
    l3d_vector<double, 3> position{0.0, 0.0, 0.0}; ///< world space
    /// The distance at which it is as bright as its colour; 0: at every distance.
    float reach = 0;
    l3d_light_color color{1, 1, 1}; ///< how bright it is

    /// Its colour is multiplied by this at places whose distance from it has this square. No place
    /// is so near that it is more than `brightest`.
    float strength(float square) const {
        return reach > 0 ? std::min(reach * reach / square, brightest) : 1.0F;
    }
    static constexpr float brightest = 0x1p20F; ///< the most that a colour is multiplied by

    friend bool operator==(const l3d_point_light&, const l3d_point_light&) = default;
};

/// Ambient light, the first light's colour, and further lights. By default, the usual light: a
/// white one, and a tenth of ambient light.
///
/// With n the unit normal, turned to the eye, a channel of a pixel is
///
///     255 (c (a + 0.9 sum L max(0, n.l)) + s sum L max(0, n.h)^k), at most 255,
///
/// summed over the lights that are before the surface, n.l > 0. l is the direction to a light, L
/// its colour, times (reach / distance)^2 of a point light that has a reach, a that of ambient
/// light. c, s and k are the material's colour, highlight and sharpness. h is half-way between l
/// and the direction to the eye. Source: J. F. Blinn, "Models of light reflection for computer
/// synthesized pictures", 1977.
struct L3D_PUBLIC l3d_lighting {
    /// Lights beside the first.
    static constexpr std::size_t most_further = 7;
    /// Lights at places.
    static constexpr std::size_t most_points = 8;

    /// The part of a surface's colour that it has without any light.
    l3d_light_color ambient{0.1F, 0.1F, 0.1F};
    /// The first light's colour.
    l3d_light_color color{1, 1, 1};
    /// The further lights, and how many there are.
    std::array<l3d_far_light, most_further> lights{};
    std::size_t count = 0; ///< at most most_further
    /// The lights at places, and how many there are.
    std::array<l3d_point_light, most_points> points{};
    std::size_t point_count = 0; ///< at most most_points

    /// Adds a light. Expects: a direction of any length but 0, in the world; count < most_further.
    void add(const l3d_vector<double, 3>& towards, const l3d_light_color& of) {
        const l3d_vector<double, 3> unit = l3d_normalized(towards);
        lights[count++] = {
            {static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)},
            of};
    }

    /// Adds a light at a place. Expects: point_count < most_points.
    void add_point(const l3d_point_light& light) { points[point_count++] = light; }

    /// Whether this is the default.
    bool is_usual() const { return *this == l3d_lighting(); }

    friend bool operator==(const l3d_lighting&, const l3d_lighting&) = default;
};

#endif
