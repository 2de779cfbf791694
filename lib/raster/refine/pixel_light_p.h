// SPDX-License-Identifier: MIT
// pixel_light: the mean light of the fragments that are seen in pixels.
#ifndef L3D_RASTER_REFINE_PIXEL_LIGHT_P_H
#define L3D_RASTER_REFINE_PIXEL_LIGHT_P_H

#include "geom/material.h"
#include "raster/refine/band_fragments_p.h"
#include "raster/surface_rasterizer.h"
#include "tool_2d/pixels.h"

#include <span>

namespace l3d_detail {

/// Writes the words of a band's marked pixels: the mean of the light at the middles of polygons'
/// seen parts, weighted by the number of samples. If `has_color`, polygons have the colours of
/// materials.
/// Expects: `band` is finished.
void light_pixels(const band_fragments& band, const l3d_shading& shading,
                  std::span<const l3d_material> materials, bool has_color,
                  const l3d_pixels& target);

} // namespace l3d_detail

#endif
