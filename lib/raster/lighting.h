// SPDX-License-Identifier: MIT
// l3d_lighting: the lights of a frame, beside the direction of the first one.
#ifndef L3D_RASTER_LIGHTING_H
#define L3D_RASTER_LIGHTING_H

#include "base/error.h"
#include "base/public.h"
#include "geom/vector.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

/// The default direction towards the first light: from above, from the right and from the front.
inline constexpr l3d_vector<double, 3> l3d_usual_light{0.4, 0.8, 0.45};

/// The red, green and blue of a light. Units: 1 in each is white; more is brighter.
using l3d_light_color = std::array<float, 3>;

/// A light so far away that its rays are parallel.
struct L3D_PUBLIC l3d_far_light {
    std::array<float, 3> direction{0, 0, 1}; ///< unit vector towards the light, world space
    l3d_light_color color{1, 1, 1};          ///< the light's brightness in red, green and blue

    friend bool operator==(const l3d_far_light&, const l3d_far_light&) = default;
};

/// A light at a place. Its brightness is the same everywhere, or falls with the square of the
/// distance.
struct L3D_PUBLIC l3d_point_light {
    l3d_vector<double, 3> position{0.0, 0.0, 0.0}; ///< the light's place, world space
    /// The distance at which the light is as bright as its colour. 0: the light is as bright as its
    /// colour at every distance.
    float reach = 0;
    l3d_light_color color{1, 1, 1}; ///< the light's brightness at the distance `reach`

    /// The factor by which the light's colour is multiplied at a place, at most `brightest`.
    /// Units: `square` is the square of the distance from the light.
    float strength(float square) const {
        return reach > 0 ? std::min(reach * reach / square, brightest) : 1.0F;
    }
    static constexpr float brightest = 0x1p20F; ///< upper limit of strength()

    friend bool operator==(const l3d_point_light&, const l3d_point_light&) = default;
};

/// All lights of a scene: ambient light, the first light's colour, and further lights. By default,
/// the first light is white, and ambient light is a tenth of it.
///
/// A channel of a pixel is
///
///     255 (c (a + 0.9 sum L max(0, n.l)) + s sum L max(0, n.h)^k), at most 255.
///
/// Both sums are over the lights in front of the surface, where n.l > 0. n is the unit normal,
/// turned to the eye, and l is the direction to a light. h is half-way between l and the direction
/// to the eye. L is the light's colour, times (reach / distance)^2 for a point light with a reach,
/// and a is the ambient light. c, s and k are the material's colour, highlight and sharpness.
/// Source: J. F. Blinn, "Models of light reflection for computer synthesized pictures", 1977.
struct L3D_PUBLIC l3d_lighting {
    /// The limit of far lights besides the first.
    static constexpr std::size_t most_further = 7;
    /// The limit of lights at places.
    static constexpr std::size_t most_points = 8;

    /// The ambient light: the part of a surface's colour that it shows without any lamp.
    l3d_light_color ambient{0.1F, 0.1F, 0.1F};
    /// The first light's colour.
    l3d_light_color color{1, 1, 1};
    /// The far lights besides the first. The first `count` elements are used.
    std::array<l3d_far_light, most_further> lights{};
    std::size_t count = 0; ///< the number of far lights besides the first; at most most_further
    /// The lights at places. The first `point_count` elements are used.
    std::array<l3d_point_light, most_points> points{};
    std::size_t point_count = 0; ///< the number of lights at places; at most most_points

    /// Adds a far light: `towards` is the direction to the light, `of` its colour.
    /// Expects: a direction in world space, of any length but 0.
    /// Errors:  throws l3d_error if there are most_further already.
    void add(const l3d_vector<double, 3>& towards, const l3d_light_color& of) {
        if (count >= most_further)
            throw l3d_error(l3d_exit::failure, "lights: at most " + std::to_string(most_further) +
                                                   " are far, besides the first");
        const l3d_vector<double, 3> unit = l3d_normalized(towards);
        lights[count++] = {
            {static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)},
            of};
    }

    /// Adds a light at a place. Errors: throws l3d_error if there are most_points already.
    void add_point(const l3d_point_light& light) {
        if (point_count >= most_points)
            throw l3d_error(l3d_exit::failure,
                            "lights: at most " + std::to_string(most_points) + " are at places");
        points[point_count++] = light;
    }

    /// Whether all lights are the default lights.
    bool is_usual() const { return *this == l3d_lighting(); }

    friend bool operator==(const l3d_lighting&, const l3d_lighting&) = default;
};

#endif
