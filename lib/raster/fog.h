// SPDX-License-Identifier: MIT
// l3d_fog: farther surfaces fade into a colour.
#ifndef L3D_RASTER_FOG_H
#define L3D_RASTER_FOG_H

#include "base/public.h"
#include "raster/background.h"
#include "tool_2d/screen_info.h"

#include <cstdint>
#include <optional>

/// Fog, or depth cueing if its colour is black. Surfaces nearer than `near` look as without fog;
/// those from `far` on have the fog's colour. Between the two, fog grows in proportion to the
/// distance. By default there is none.
///
/// Units: distances along the view axis, in world units.
struct L3D_PUBLIC l3d_fog {
    float near = 0;                       ///< distance at which fog begins
    float far = 0;                        ///< distance at which fog hides everything
    std::optional<std::uint32_t> color{}; ///< pixel word; none: that of the background in each row

    /// Whether there is any.
    bool is_on() const { return far > near; }

    /// The amount of fog before a surface at that distance: 0 to 255. Expects: is_on().
    std::uint32_t amount(float distance) const {
        const float share = (distance - near) / (far - near);
        const float held = share > 0 ? (share < 1 ? share : 1.0F) : 0.0F;
        return static_cast<std::uint32_t>(255 * held + 0.5F);
    }

    /// The colour of a surface behind fog: in each channel the weighted mean of both.
    /// Units: pixel words without transparency; the amount from 0 to 255.
    static std::uint32_t word(std::uint32_t surface, std::uint32_t fog, std::uint32_t amount) {
        return l3d_screen_info::light_native(surface, 255 - amount) +
               l3d_screen_info::light_native(fog, amount);
    }

    /// The fog's colour in a row of a picture.
    std::uint32_t in_row(const l3d_background& background, int row, int height) const {
        return color ? *color : background.word(row, height);
    }

    friend bool operator==(const l3d_fog&, const l3d_fog&) = default;
};

#endif
