// SPDX-License-Identifier: MIT
// hard_edged: settings for pictures that are counted pixel by pixel.
#ifndef L3D_TESTS_HARD_EDGED_H
#define L3D_TESTS_HARD_EDGED_H

#include "pipeline/pipeline_afd.h"
#include "pipeline/polygons/pipeline_polygons.h"

/// Hard edges on black, by one thread: each pixel shows one surface or nothing, in order.
inline l3d_afd_settings hard_edged() {
    return {.antialias = false, .background = {}, .threads = 1};
}

/// The same of polygons, in one grey each.
inline l3d_polygon_settings hard_edged_polygons() {
    return {.shade = l3d_shade::flat, .background = {}, .antialias = false, .threads = 1};
}

#endif
