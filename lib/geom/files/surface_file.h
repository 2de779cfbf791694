// SPDX-License-Identifier: MIT
// NURBS surfaces in .obj files, with their own knots and control points; reader and writer.
#ifndef L3D_GEOM_FILES_SURFACE_FILE_H
#define L3D_GEOM_FILES_SURFACE_FILE_H

#include "base/public.h"
#include "geom/nurbs_surface.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Reads the surfaces of an .obj file as they were made, for programs that change control points.
/// l3d_read_obj gives their Bezier patches, which are pieces() of these surfaces in their order.
///
/// Errors: as l3d_read_obj. A file without surfaces is no error.
/// Cost:   as l3d_read_obj, and the memory of the surfaces.
L3D_PUBLIC std::optional<std::vector<l3d_nurbs_surface>>
l3d_read_obj_surfaces(std::string_view text, std::string_view name, std::string& why);

/// The text of an .obj file; reading it by l3d_read_obj_surfaces gives the same surfaces, bit for
/// bit.
L3D_PUBLIC std::string l3d_write_obj_surfaces(std::span<const l3d_nurbs_surface> surfaces);

#endif
