// SPDX-License-Identifier: MIT
// Meshes of simple shapes, with any number of faces.
#ifndef L3D_GEOM_POLYGON_SHAPES_H
#define L3D_GEOM_POLYGON_SHAPES_H

#include "base/public.h"
#include "geom/polygon_mesh.h"

/// A torus around the z axis: `around` times `across` quads of two triangles each. `around` counts
/// the quads around the axis, and `across` those around the tube.
///
/// Units:   `major` from the centre to the middle of the tube, `minor` the tube's radius.
/// Expects: around, across >= 3; 0 < minor < major.
L3D_PUBLIC l3d_polygon_mesh l3d_torus_mesh(int around, int across, double major = 2,
                                           double minor = 0.8);

/// A sphere about the origin, poles on the z axis. From pole to pole it has `rows` rows, each
/// divided into `around` parts: 2 * around * (rows - 1) triangles in all.
/// Expects: around >= 3, rows >= 2; radius > 0.
L3D_PUBLIC l3d_polygon_mesh l3d_sphere_mesh(int around, int rows, double radius = 1);

/// A box about the origin, of six faces. Expects: width, height, depth > 0, along x, y and z.
L3D_PUBLIC l3d_polygon_mesh l3d_box_mesh(double width = 1, double height = 1, double depth = 1);

/// A cylinder about the z axis and the origin: `around` sides of four corners, and its two ends.
/// Expects: around >= 3; radius, height > 0.
L3D_PUBLIC l3d_polygon_mesh l3d_cylinder_mesh(int around, double radius = 1, double height = 2);

/// A cone about the z axis, half of its height below the origin: `around` triangles, and its base.
/// Expects: around >= 3; radius, height > 0.
L3D_PUBLIC l3d_polygon_mesh l3d_cone_mesh(int around, double radius = 1, double height = 2);

/// The pyramid of Lin's book (docs/BOOK.md): three edges of length 10 from the origin along the
/// axes, four faces.
L3D_PUBLIC l3d_polygon_mesh l3d_pyramid_mesh();

/// A mesh of the height field z = height(x, y) over the square [-1, 1] x [-1, 1], with 2 * cells^2
/// triangles.
/// Expects: cells >= 1.
template <class Height> l3d_polygon_mesh l3d_grid_mesh(int cells, Height height) {
    l3d_polygon_mesh mesh;
    const auto at = [cells](int column, int row) {
        return static_cast<std::uint32_t>(row * (cells + 1) + column);
    };
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const double x = 2.0 * column / cells - 1, y = 2.0 * row / cells - 1;
            mesh.vertices.push_back({x, y, height(x, y)});
        }
    for (int row = 0; row < cells; ++row)
        for (int column = 0; column < cells; ++column) {
            const std::uint32_t a = at(column, row), b = at(column + 1, row),
                                c = at(column + 1, row + 1), d = at(column, row + 1);
            mesh.add_face({{a, b, c}});
            mesh.add_face({{a, c, d}});
        }
    return mesh;
}

#endif
