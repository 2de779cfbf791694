// SPDX-License-Identifier: MIT
// l3d_own_shade: a program's own colours of surfaces.
#ifndef L3D_RASTER_OWN_SHADE_H
#define L3D_RASTER_OWN_SHADE_H

#include "base/public.h"
#include "geom/material.h"
#include "geom/vector.h"

#include <cstdint>
#include <functional>
#include <limits>
#include <span>

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

#endif
