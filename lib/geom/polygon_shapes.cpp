// SPDX-License-Identifier: MIT
// Makes simple bodies as polygons, with outward normals.
#include "geom/polygon_shapes.h"

#include <cassert>
#include <cmath>
#include <numbers>

namespace {

/// The angle of step i of n around a circle. Units: radians.
double angle(int i, int n) {
    return 2 * std::numbers::pi * i / n;
}

/// Adds a ring of vertices at height z, and returns the index of its first vertex.
std::uint32_t add_ring(l3d_polygon_mesh& mesh, int around, double radius, double z) {
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (int i = 0; i < around; ++i)
        mesh.vertices.push_back(
            {radius * std::cos(angle(i, around)), radius * std::sin(angle(i, around)), z});
    return first;
}

/// Adds a polygon of a ring's vertices. The polygon faces up the z axis if `from_above`, else down.
void add_disc(l3d_polygon_mesh& mesh, std::uint32_t first, int around, bool from_above) {
    for (int i = 0; i < around; ++i)
        mesh.corners.push_back(first + static_cast<std::uint32_t>(from_above ? i : around - 1 - i));
    mesh.end_face();
}

} // namespace

l3d_polygon_mesh l3d_torus_mesh(int around, int across, double major, double minor) {
    assert(around >= 3 && across >= 3 && minor > 0 && minor < major);
    l3d_polygon_mesh mesh;
    const auto at = [=](int i, int j) {
        return static_cast<std::uint32_t>(i % around * across + j % across);
    };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double u = angle(i, around), v = angle(j, across);
            const double from_axis = major + minor * std::cos(v);
            mesh.vertices.push_back(
                {from_axis * std::cos(u), from_axis * std::sin(u), minor * std::sin(v)});
        }
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const std::uint32_t a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1),
                                d = at(i, j + 1);
            mesh.add_face({{a, b, c}});
            mesh.add_face({{a, c, d}});
        }
    return mesh;
}

l3d_polygon_mesh l3d_sphere_mesh(int around, int rows, double radius) {
    assert(around >= 3 && rows >= 2 && radius > 0);
    l3d_polygon_mesh mesh;
    mesh.vertices.push_back({0.0, 0.0, radius});
    for (int row = 1; row < rows; ++row)
        for (int i = 0; i < around; ++i) {
            const double polar = std::numbers::pi * row / rows, u = angle(i, around);
            mesh.vertices.push_back({radius * std::sin(polar) * std::cos(u),
                                     radius * std::sin(polar) * std::sin(u),
                                     radius * std::cos(polar)});
        }
    const auto south = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({0.0, 0.0, -radius});
    const auto at = [=](int row, int i) {
        return static_cast<std::uint32_t>(1 + (row - 1) * around + i % around);
    };
    for (int i = 0; i < around; ++i) {
        mesh.add_face({{0, at(1, i), at(1, i + 1)}});
        for (int row = 1; row + 1 < rows; ++row) {
            mesh.add_face({{at(row, i), at(row + 1, i), at(row + 1, i + 1)}});
            mesh.add_face({{at(row, i), at(row + 1, i + 1), at(row, i + 1)}});
        }
        mesh.add_face({{at(rows - 1, i), south, at(rows - 1, i + 1)}});
    }
    return mesh;
}

l3d_polygon_mesh l3d_box_mesh(double width, double height, double depth) {
    assert(width > 0 && height > 0 && depth > 0);
    l3d_polygon_mesh mesh;
    for (std::uint32_t i = 0; i < 8; ++i) // bit k set: the upper side along axis k
        mesh.vertices.push_back({(i & 1 ? width : -width) / 2, (i & 2 ? height : -height) / 2,
                                 (i & 4 ? depth : -depth) / 2});
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t up = 1u << axis, a = 1u << (axis + 1) % 3, b = 1u << (axis + 2) % 3;
        mesh.add_face({{up, up | a, up | a | b, up | b}});
        mesh.add_face({{0, b, a | b, a}});
    }
    return mesh;
}

l3d_polygon_mesh l3d_cylinder_mesh(int around, double radius, double height) {
    assert(around >= 3 && radius > 0 && height > 0);
    l3d_polygon_mesh mesh;
    const std::uint32_t low = add_ring(mesh, around, radius, -height / 2);
    const std::uint32_t high = add_ring(mesh, around, radius, height / 2);
    for (int i = 0; i < around; ++i) {
        const auto here = static_cast<std::uint32_t>(i);
        const auto next = static_cast<std::uint32_t>((i + 1) % around);
        mesh.add_face({{low + here, low + next, high + next, high + here}});
    }
    add_disc(mesh, low, around, false);
    add_disc(mesh, high, around, true);
    return mesh;
}

l3d_polygon_mesh l3d_cone_mesh(int around, double radius, double height) {
    assert(around >= 3 && radius > 0 && height > 0);
    l3d_polygon_mesh mesh;
    const std::uint32_t base = add_ring(mesh, around, radius, -height / 2);
    const auto tip = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back({0.0, 0.0, height / 2});
    for (int i = 0; i < around; ++i)
        mesh.add_face({{base + static_cast<std::uint32_t>(i),
                        base + static_cast<std::uint32_t>((i + 1) % around), tip}});
    add_disc(mesh, base, around, false);
    return mesh;
}

l3d_polygon_mesh l3d_pyramid_mesh() {
    l3d_polygon_mesh mesh;
    mesh.vertices = {{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {0, 0, 10}};
    mesh.add_face({{0, 1, 3}});
    mesh.add_face({{2, 3, 1}});
    mesh.add_face({{0, 2, 1}});
    mesh.add_face({{3, 2, 0}});
    return mesh;
}
