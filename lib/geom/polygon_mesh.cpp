// SPDX-License-Identifier: MIT
// l3d_polygon_mesh: checks and changes its arrays.
#include "geom/polygon_mesh.h"

#include "geom/color_between_p.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

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

/// The crossing of two opposite sides of a quadrilateral, one of which begins at corner `side`.
struct crossing {
    bool exists = false;
    std::size_t side = 0;
    /// Place of the crossing on this side: 0 at its first corner, 1 at its second.
    double share = 0;
    l3d_polygon_mesh::vector place{0.0, 0.0, 0.0};
};

/// Finds two crossing sides of a quadrilateral. If sides cross, two corners turn left and two
/// right, seen along the normal of any corner.
crossing crossing_of(const l3d_polygon_mesh& mesh, std::span<const std::uint32_t> face) {
    using vector = l3d_polygon_mesh::vector;
    const auto at = [&](std::size_t i) { return mesh.vertices[face[i % 4]]; };
    const vector normal = l3d_cross(at(1) - at(0), at(3) - at(0));
    int turns = 0;
    for (std::size_t i = 1; i < 4; ++i)
        turns += l3d_dot(normal, l3d_cross(at(i + 1) - at(i), at(i + 3) - at(i))) > 0 ? 1 : -1;
    if (turns != -1)
        return {};
    for (std::size_t side = 0; side < 2; ++side) {
        const vector along = at(side + 1) - at(side), other = at(side + 3) - at(side + 2);
        const vector across = l3d_cross(along, other), between = at(side + 2) - at(side);
        const double square = l3d_dot(across, across);
        const double s = l3d_dot(l3d_cross(between, other), across) / square;
        const double t = l3d_dot(l3d_cross(between, along), across) / square;
        if (!(s > 0 && s < 1 && t > 0 && t < 1))
            continue;
        const vector place = at(side) + along * s;
        // Sides of a twisted quadrilateral cross as seen here, but pass each other in space.
        constexpr double near = 1e-3;
        if (l3d_length(at(side + 2) + other * t - place) <= near * l3d_length(along))
            return {true, side, s, place};
    }
    return {};
}

/// The index of a face's first corner among all corners.
std::ptrdiff_t first_corner(const l3d_polygon_mesh& of, std::size_t face) {
    return of.face(face).data() - of.corners.data();
}

/// Splits a face of `of` whose sides cross. Adds the crossing to the vertices of `of`, and the
/// face's two triangles to `made`.
void split_at(const crossing& at, std::size_t face, l3d_polygon_mesh& of, l3d_polygon_mesh& made) {
    const auto corner = [&](std::size_t i) { return of.face(face)[(at.side + i) % 4]; };
    const auto middle = static_cast<std::uint32_t>(of.vertices.size());
    const std::uint32_t a = corner(0), b = corner(1);
    of.vertices.push_back(at.place);
    if (!of.vertex_normals.empty())
        of.vertex_normals.push_back(of.vertex_normals[a] +
                                    (of.vertex_normals[b] - of.vertex_normals[a]) * at.share);
    if (!of.vertex_colors.empty())
        of.vertex_colors.push_back(
            l3d_detail::color_between(of.vertex_colors[a], of.vertex_colors[b], at.share));
    made.add_face({{middle, corner(3), a}});
    made.add_face({{middle, corner(2), b}});
    if (of.picture_places.empty())
        return;
    const auto place = [&](std::size_t i) {
        return of
            .picture_places[static_cast<std::size_t>(first_corner(of, face)) + (at.side + i) % 4];
    };
    const auto between = [&](double from, double to) {
        return static_cast<float>(from + (to - from) * at.share);
    };
    const l3d_polygon_mesh::picture_place p{between(place(0)[0], place(1)[0]),
                                            between(place(0)[1], place(1)[1])};
    made.picture_places.insert(made.picture_places.end(),
                               {p, place(3), place(0), p, place(2), place(1)});
}

/// Appends another mesh's array to an optional array. A mesh without the array counts as if it had
/// `missing` for each element.
template <class T>
void append_optional(std::vector<T>& to, std::size_t size, const std::vector<T>& more,
                     std::size_t more_size, const T& missing) {
    if (to.empty() && more.empty())
        return;
    to.resize(size, missing);
    to.insert(to.end(), more.begin(), more.end());
    to.resize(size + more_size, missing);
}

} // namespace

std::uint32_t l3d_polygon_mesh::index_of(std::size_t number) {
    if (number > std::numeric_limits<std::uint32_t>::max())
        throw std::length_error("more than 4294967295 corners or vertices in a mesh");
    return static_cast<std::uint32_t>(number);
}

l3d_polygon_mesh::vector l3d_polygon_mesh::area_vector(std::span<const std::uint32_t> face) const {
    vector sum{0.0, 0.0, 0.0};
    const vector& first = vertices[face[0]];
    for (std::size_t i = 2; i < face.size(); ++i)
        sum += l3d_cross(vertices[face[i - 1]] - first, vertices[face[i]] - first);
    return sum;
}

void l3d_polygon_mesh::uncross_faces() {
    std::vector<std::pair<std::size_t, crossing>> crossed;
    for (std::size_t f = 0; f < faces(); ++f)
        if (face(f).size() == 4)
            if (const crossing found = crossing_of(*this, face(f)); found.exists)
                crossed.emplace_back(f, found);
    if (crossed.empty())
        return;
    index_of(vertices.size() + crossed.size());
    l3d_polygon_mesh made;
    auto next = crossed.begin();
    auto part = parts.begin();
    for (std::size_t f = 0; f < faces(); ++f) {
        for (; part != parts.end() && part->first == f; ++part)
            part->first = index_of(made.faces());
        if (next != crossed.end() && next->first == f)
            split_at((next++)->second, f, *this, made);
        else {
            made.add_face(face(f));
            if (!picture_places.empty()) {
                const auto begin = picture_places.begin() + first_corner(*this, f);
                made.picture_places.insert(made.picture_places.end(), begin,
                                           begin + static_cast<std::ptrdiff_t>(face(f).size()));
            }
        }
        if (!face_colors.empty())
            made.face_colors.resize(made.faces(), face_colors[f]);
        if (!face_materials.empty())
            made.face_materials.resize(made.faces(), face_materials[f]);
    }
    for (; part != parts.end(); ++part)
        part->first = index_of(made.faces());
    corners = std::move(made.corners);
    picture_places = std::move(made.picture_places);
    face_ends = std::move(made.face_ends);
    face_colors = std::move(made.face_colors);
    face_materials = std::move(made.face_materials);
}

void l3d_polygon_mesh::append(const l3d_polygon_mesh& more) {
    index_of(vertices.size() + more.vertices.size());
    index_of(corners.size() + more.corners.size());
    const auto offset = index_of(vertices.size());
    const auto corner_offset = index_of(corners.size());
    constexpr std::uint32_t white = 0xffffff;
    append_optional(vertex_normals, vertices.size(), more.vertex_normals, more.vertices.size(),
                    vector(0));
    append_optional(vertex_colors, vertices.size(), more.vertex_colors, more.vertices.size(),
                    white);
    append_optional(picture_places, corners.size(), more.picture_places, more.corners.size(),
                    picture_place{});
    append_optional(face_colors, faces(), more.face_colors, more.faces(), white);
    vertices.insert(vertices.end(), more.vertices.begin(), more.vertices.end());
    for (const std::uint32_t corner : more.corners)
        corners.push_back(corner + offset);
    append_materials(more);
    append_parts(more);
    for (const std::uint32_t end : more.face_ends)
        face_ends.push_back(end + corner_offset);
}

/// Appends the parts of `more`. Expects: the faces of `more` are not added yet.
void l3d_polygon_mesh::append_parts(const l3d_polygon_mesh& more) {
    const auto first = index_of(faces());
    // A run without a name keeps the other mesh's first unnamed faces out of this mesh's last part.
    if (!parts.empty() && (more.parts.empty() || more.parts.front().first > 0))
        parts.push_back({"", first});
    for (const l3d_part_run& part : more.parts)
        parts.push_back({part.name, part.first + first});
}

/// Appends the materials of `more`. Expects: the faces of `more` are not added yet.
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
    for (l3d_material look : more.looks) {
        if (look.picture != l3d_material::no_picture)
            look.picture += static_cast<int>(pictures.size());
        looks.push_back(look);
    }
    pictures.insert(pictures.end(), more.pictures.begin(), more.pictures.end());
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
           std::ranges::all_of(
               picture_places,
               [](const picture_place& p) { return std::isfinite(p[0]) && std::isfinite(p[1]); }) &&
           std::ranges::all_of(looks,
                               [&](const l3d_material& look) {
                                   return look.picture == l3d_material::no_picture ||
                                          (look.picture >= 0 &&
                                           static_cast<std::size_t>(look.picture) <
                                               pictures.size());
                               }) &&
           absent_or(vertex_colors, vertices.size()) && absent_or(picture_places, corners.size()) &&
           absent_or(vertex_normals, vertices.size()) && absent_or(face_colors, faces()) &&
           absent_or(face_materials, faces()) && absent_or(looks, materials.size()) &&
           std::ranges::all_of(face_materials,
                               [&](std::uint32_t i) { return i < materials.size(); });
}

std::size_t l3d_polygon_mesh::bytes() const {
    return bytes_of(vertices) + bytes_of(corners) + bytes_of(face_ends) + bytes_of(vertex_normals) +
           bytes_of(vertex_colors) + bytes_of(picture_places) + bytes_of(face_colors) +
           bytes_of(face_materials) + bytes_of(looks);
}
