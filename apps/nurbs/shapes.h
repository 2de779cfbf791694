// SPDX-License-Identifier: MIT
// The surfaces that nurbs begins with, and steps through.
#ifndef L3D_APPS_NURBS_SHAPES_H
#define L3D_APPS_NURBS_SHAPES_H

#include <l3d/nurbs_surface.h>

#include <cstddef>
#include <string_view>
#include <vector>

/// A shape for the program nurbs: its surfaces, and its name for the user.
struct shape {
    std::string_view name;
    std::vector<l3d_nurbs_surface> surfaces;
};

/// The number of shapes: a vase, a sheet, and the exact shapes of the library.
std::size_t shape_count();
/// Makes the shape with this index. Expects: index < shape_count().
shape shape_at(std::size_t index);

#endif
