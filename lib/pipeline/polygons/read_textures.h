// SPDX-License-Identifier: MIT
// l3d_read_textures: the pictures that a mesh names.
#ifndef L3D_PIPELINE_POLYGONS_READ_TEXTURES_H
#define L3D_PIPELINE_POLYGONS_READ_TEXTURES_H

#include "base/public.h"
#include "geom/polygon_mesh.h"
#include "raster/textures/texture.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// The most pixels of a texture: those of 8192 by 8192, 0.7 GB with its smaller pictures.
inline constexpr std::int64_t l3d_most_texture_pixels = std::int64_t{1} << 26;

/// The textures of a mesh, for l3d_polygon_model::textured: one for each of its pictures. A picture
/// that no face shows is null, and so is one that cannot be read or is too large. For each of the
/// latter, `notes` get a line with file and reason: no model is lost for a picture.
///
///     std::vector<std::string> notes;
///     const l3d_polygon_model plain(mesh);
///     const l3d_polygon_model model = plain.textured(l3d_read_textures(mesh, notes));
L3D_PUBLIC std::vector<std::shared_ptr<const l3d_texture>>
l3d_read_textures(const l3d_polygon_mesh& mesh, std::vector<std::string>& notes);

#endif
