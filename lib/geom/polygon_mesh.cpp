// SPDX-License-Identifier: MIT
// l3d_polygon_mesh: what must hold of its arrays.
#include "geom/polygon_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace {

template <class T> std::size_t bytes_of(const std::vector<T>& array) {
    return array.size() * sizeof(T);
}

bool is_finite(const l3d_polygon_mesh::vector& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

template <class T> bool absent_or(const std::vector<T>& array, std::size_t size) {
    return array.empty() || array.size() == size;
}

} // namespace

std::uint32_t l3d_polygon_mesh::index_of(std::size_t number) {
    if (number > std::numeric_limits<std::uint32_t>::max())
        throw std::length_error("more than 4294967295 corners or vertices in a mesh");
    return static_cast<std::uint32_t>(number);
}

void l3d_polygon_mesh::append(const l3d_polygon_mesh& more) {
    index_of(vertices.size() + more.vertices.size());
    index_of(corners.size() + more.corners.size());
    const auto offset = index_of(vertices.size());
    const auto corner_offset = index_of(corners.size());
    const bool have_normals = vertex_normals.size() == vertices.size() &&
                              more.vertex_normals.size() == more.vertices.size();
    vertices.insert(vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const std::uint32_t corner : more.corners)
        corners.push_back(corner + offset);
    if (have_normals)
        vertex_normals.insert(vertex_normals.end(), more.vertex_normals.begin(),
                              more.vertex_normals.end());
    else
        vertex_normals.clear();
    append_colors(more);
    append_materials(more);
    append_parts(more);
    for (const std::uint32_t end : more.face_ends)
        face_ends.push_back(end + corner_offset);
}

/// Expects: the other mesh's faces are not added yet.
void l3d_polygon_mesh::append_parts(const l3d_polygon_mesh& more) {
    const auto first = index_of(faces());
    // What has no name shall not become part of the last one here.
    if (!parts.empty() && (more.parts.empty() || more.parts.front().first > 0))
        parts.push_back({"", first});
    for (const l3d_part_run& part : more.parts)
        parts.push_back({part.name, part.first + first});
}

/// Expects: the other mesh's faces are not added yet.
void l3d_polygon_mesh::append_colors(const l3d_polygon_mesh& more) {
    if (face_colors.empty() && more.face_colors.empty())
        return;
    constexpr std::uint32_t white = 0xffffff;
    face_colors.resize(faces(), white);
    face_colors.insert(face_colors.end(), more.face_colors.begin(), more.face_colors.end());
    face_colors.resize(faces() + more.faces(), white);
}

/// Expects: the other mesh's faces are not added yet.
void l3d_polygon_mesh::append_materials(const l3d_polygon_mesh& more) {
    if (face_materials.empty() && more.face_materials.empty())
        return;
    looks.resize(materials.size());
    const auto name = [this](std::size_t missing) {
        if (missing > 0) {
            materials.emplace_back();
            looks.emplace_back();
        }
        return static_cast<std::uint32_t>(materials.size() - 1);
    };
    const std::size_t without = faces() - face_materials.size();
    face_materials.resize(faces(), name(without));
    const auto offset = static_cast<std::uint32_t>(materials.size());
    for (const std::uint32_t material : more.face_materials)
        face_materials.push_back(material + offset);
    materials.insert(materials.end(), more.materials.begin(), more.materials.end());
    looks.insert(looks.end(), more.looks.begin(), more.looks.end());
    looks.resize(materials.size());
    face_materials.resize(faces() + more.faces(), name(more.faces() - more.face_materials.size()));
}

l3d_material l3d_polygon_mesh::look_of(std::size_t face) const {
    l3d_material result;
    if (!face_materials.empty() && !looks.empty())
        result = looks[face_materials[face]];
    if (!face_colors.empty())
        result.color = l3d_product_of_colors(result.color, face_colors[face]);
    return result;
}

bool l3d_polygon_mesh::is_valid() const {
    std::size_t begin = 0;
    for (const std::size_t end : face_ends) {
        if (end < begin + 3 || end > corners.size())
            return false;
        begin = end;
    }
    std::uint32_t first = 0;
    for (const l3d_part_run& p : parts) {
        if (p.first < first || p.first > faces())
            return false;
        first = p.first;
    }
    return begin == corners.size() &&
           std::ranges::all_of(corners, [&](std::uint32_t i) { return i < vertices.size(); }) &&
           std::ranges::all_of(vertices, is_finite) &&
           std::ranges::all_of(vertex_normals, is_finite) &&
           absent_or(vertex_normals, vertices.size()) && absent_or(face_colors, faces()) &&
           absent_or(face_materials, faces()) && absent_or(looks, materials.size()) &&
           std::ranges::all_of(face_materials,
                               [&](std::uint32_t i) { return i < materials.size(); });
}

std::size_t l3d_polygon_mesh::bytes() const {
    return bytes_of(vertices) + bytes_of(corners) + bytes_of(face_ends) + bytes_of(vertex_normals) +
           bytes_of(face_colors) + bytes_of(face_materials) + bytes_of(looks);
}
