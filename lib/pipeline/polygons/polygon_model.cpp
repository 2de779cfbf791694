// SPDX-License-Identifier: MIT
// l3d_polygon_model: makes triangles, normals, materials and boxes of a mesh.
#include "pipeline/polygons/polygon_model.h"

#include "base/error.h"
#include "base/printable_p.h"
#include "pipeline/polygons/crease_normals_p.h"
#include "pipeline/polygons/flat_face_p.h"
#include "scene/model_loader.h"
#include "tool_2d/image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>

namespace {

using vector = l3d_polygon_model::vector;
using direction = l3d_polygon_model::direction;

/// The unit vector of v, or zero if v is zero. Lengths above 2^511 or below 2^-511 have squares
/// that do not fit doubles.
direction unit(const vector& v) {
    const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
    const bool has_square = largest < 0x1p511 && largest > 0x1p-511;
    return l3d_converted<float>(l3d_normalized(has_square || largest == 0 ? v : v / largest));
}

bool is_zero(const vector& v) {
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/// The sides that a triangle shares with its face, which has `size` corners. Bit k stands for the
/// side from corner k to k + 1.
std::uint32_t sides_of(const l3d_detail::flat_face::triangle& corners, std::size_t size) {
    std::uint32_t sides = 0;
    for (std::size_t k = 0; k < 3; ++k)
        if ((corners[k] + 1) % size == corners[(k + 1) % 3])
            sides |= 1u << k;
    return sides;
}

} // namespace

l3d_polygon_model::l3d_polygon_model(l3d_polygon_mesh mesh, bool to_origin, double crease_angle)
    : contents_(std::make_shared<const contents>(std::move(mesh), to_origin, crease_angle)) {}

l3d_polygon_model l3d_polygon_model::load(const std::string& file) {
    std::vector<std::string> notes;
    const l3d_polygon_model model(l3d_mesh_of(l3d_load_model(file, file), file, l3d_usual_facets));
    return model.textured(l3d_read_textures(model.mesh(), notes));
}

l3d_polygon_model::contents::contents(l3d_polygon_mesh of, bool to_origin, double crease_angle)
    : mesh(std::move(of)) {
    assert(mesh.is_valid());
    mesh.uncross_faces();
    parts = l3d_parts(mesh.parts, mesh.faces());
    if (to_origin && !mesh.vertices.empty()) {
        vector sum{0.0, 0.0, 0.0};
        for (const vector& v : mesh.vertices)
            sum += v;
        const vector mean = sum / static_cast<double>(mesh.vertices.size());
        for (vector& v : mesh.vertices)
            v -= mean;
    }
    measure();
    make_triangles();
    make_normals(crease_angle);
    make_facing_blocks();
    std::vector<l3d_material> looks;
    if (!mesh.face_colors.empty() || (!mesh.face_materials.empty() && !mesh.looks.empty()))
        for (std::size_t f = 0; f < mesh.faces(); ++f)
            looks.push_back(mesh.look_of(f));
    make_materials(looks);
    make_painted();
}

/// Measures the box and the radius of the vertices that faces use. Other vertices may lie anywhere.
void l3d_polygon_model::contents::measure() {
    std::vector<bool> is_seen(mesh.vertices.size(), mesh.corners.empty());
    for (const std::uint32_t corner : mesh.corners)
        is_seen[corner] = true;
    bool is_first = true;
    for (std::size_t k = 0; k < is_seen.size(); ++k) {
        const vector& v = mesh.vertices[k];
        if (!is_seen[k])
            continue;
        if (is_first)
            least = most = v;
        is_first = false;
        for (int i = 0; i < 3; ++i) {
            least[i] = std::min(least[i], v[i]);
            most[i] = std::max(most[i], v[i]);
        }
    }
    for (std::size_t k = 0; k < is_seen.size(); ++k)
        if (is_seen[k])
            radius = std::max(radius, l3d_length(mesh.vertices[k] - centre()));
}

/// Makes the list of materials: faces that look alike share an entry. If all faces are plain, the
/// list is empty.
void l3d_polygon_model::contents::make_materials(std::span<const l3d_material> looks) {
    materials.clear();
    materials_of_faces.clear();
    using key = std::tuple<std::uint32_t, std::uint32_t, int, int>;
    std::map<key, std::uint32_t> places;
    materials.emplace_back();
    const auto key_of = [](const l3d_material& look) {
        return key(look.color, look.highlight, look.sharpness, look.picture);
    };
    places[key_of(materials[0])] = 0;
    for (std::size_t f = 0; f < looks.size(); ++f) {
        const l3d_material& look = looks[f];
        const auto next = static_cast<std::uint32_t>(materials.size());
        const auto [place, is_new] = places.try_emplace(key_of(look), next);
        if (is_new)
            materials.push_back(look);
        if (place->second == 0 && materials_of_faces.empty())
            continue;
        materials_of_faces.resize(f);
        materials_of_faces.push_back(place->second);
    }
    materials_of_faces.resize(materials_of_faces.empty() ? 0 : mesh.faces());
    if (materials_of_faces.empty() && mesh.vertex_colors.empty())
        materials.clear();
}

/// Makes the list of painted triangles if vertices have colours or textures were read. Otherwise
/// the list is empty, so that rasterizers need not look for paint at each pixel.
void l3d_polygon_model::contents::make_painted() {
    painted.clear();
    const bool has_texture = std::ranges::any_of(materials, [&](const l3d_material& material) {
        return material.picture >= 0 &&
               static_cast<std::size_t>(material.picture) < textures.size() &&
               textures[static_cast<std::size_t>(material.picture)];
    });
    if (mesh.vertex_colors.empty() && !has_texture)
        return;
    painted.reserve(triangles.size());
    for (const l3d_model_triangle& triangle : triangles)
        painted.push_back(painted_triangle(triangle));
}

l3d_painted_triangle
l3d_polygon_model::contents::painted_triangle(const l3d_model_triangle& triangle) const {
    l3d_painted_triangle result{.corners = triangle.corners};
    if (!materials_of_faces.empty())
        result.material = materials_of_faces[triangle.face];
    const auto face = mesh.face(triangle.face);
    const std::size_t end = mesh.face_ends[triangle.face], begin = end - face.size();
    const bool has_colors =
        !mesh.vertex_colors.empty() && (repainted.empty() || !repainted[triangle.face]);
    for (std::size_t k = 0; k < triangle.corners.size(); ++k) {
        if (has_colors)
            result.colors[k] = mesh.vertex_colors[triangle.corners[k]];
        if (mesh.picture_places.empty())
            continue;
        const auto corner = std::ranges::find(face, triangle.corners[k]);
        result.picture_places[k] =
            mesh.picture_places[begin + static_cast<std::size_t>(corner - face.begin())];
    }
    return result;
}

void l3d_polygon_model::contents::keep_triangles(const std::vector<bool>& of_faces) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (!of_faces[triangles[i].face])
            continue;
        if (!crease_corners.empty())
            crease_corners[kept] = crease_corners[i];
        triangles[kept++] = triangles[i];
    }
    triangles.resize(kept);
    crease_corners.resize(crease_corners.empty() ? 0 : kept);
    make_facing_blocks();
}

void l3d_polygon_model::contents::make_triangles() {
    triangles.reserve(mesh.corners.size() - 2 * mesh.faces());
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        const auto number = static_cast<std::uint32_t>(f);
        if (face.size() == 3) {
            triangles.push_back({{face[0], face[1], face[2]}, number, 7});
            continue;
        }
        for (const auto& corners : l3d_detail::flat_face(mesh, face).triangles())
            triangles.push_back({{face[corners[0]], face[corners[1]], face[corners[2]]},
                                 number,
                                 sides_of(corners, face.size())});
    }
}

void l3d_polygon_model::contents::make_normals(double crease_angle) {
    std::vector<vector> areas, sums(mesh.vertices.size(), vector{0.0, 0.0, 0.0});
    face_normals.reserve(mesh.faces());
    areas.reserve(mesh.faces());
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        const vector area = mesh.area_vector(face);
        areas.push_back(area);
        face_normals.push_back(unit(area));
        for (const std::uint32_t corner : face)
            sums[corner] += area;
    }
    vertex_normals.reserve(sums.size());
    bool has_computed = false;
    for (std::size_t v = 0; v < sums.size(); ++v) {
        const bool is_computed = !has_own_normal(v);
        has_computed = has_computed || is_computed;
        vertex_normals.push_back(unit(is_computed ? sums[v] : mesh.vertex_normals[v]));
    }
    if (has_computed)
        find_creases(areas, crease_angle);
    if (!mesh.vertex_normals.empty())
        turn_normals_to_faces();
}

void l3d_polygon_model::contents::set_crease(std::size_t triangle, std::size_t corner,
                                             std::uint32_t normal) {
    if (crease_corners.empty())
        crease_corners.assign(triangles.size(), {no_crease, no_crease, no_crease});
    crease_corners[triangle][corner] = normal;
}

bool l3d_polygon_model::contents::has_own_normal(std::size_t vertex) const {
    return !mesh.vertex_normals.empty() && !is_zero(mesh.vertex_normals[vertex]);
}

void l3d_polygon_model::contents::find_creases(std::span<const vector> areas, double crease_angle) {
    const l3d_detail::crease_normals creases(mesh, areas, face_normals, vertex_normals,
                                             crease_angle);
    if (creases.empty())
        return;
    crease_normals.assign(creases.normals().begin(), creases.normals().end());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            if (const auto of = creases.at(triangles[i].corners[k], triangles[i].face);
                of != l3d_detail::crease_normals::none)
                set_crease(i, k, of);
}

void l3d_polygon_model::contents::make_facing_blocks() {
    constexpr std::size_t in_block = l3d_facing_block::triangles;
    facing_blocks.assign((triangles.size() + in_block - 1) / in_block, l3d_facing_block());
    for (std::size_t b = 0; b < facing_blocks.size(); ++b) {
        l3d_facing_block& block = facing_blocks[b];
        const auto of_block = std::span<const l3d_model_triangle>(triangles).subspan(
            b * in_block, std::min(in_block, triangles.size() - b * in_block));
        const auto normal = [&](const l3d_model_triangle& t) {
            return l3d_converted<double>(face_normals[t.face]);
        };
        const auto corner = [&](const l3d_model_triangle& t) {
            return mesh.vertices[t.corners[0]];
        };
        const double part = 1.0 / static_cast<double>(of_block.size());
        for (const l3d_model_triangle& t : of_block) {
            block.axis += normal(t) * part;
            block.middle += corner(t) * part;
        }
        for (const l3d_model_triangle& t : of_block) {
            block.spread = std::max(block.spread, l3d_length(normal(t) - block.axis));
            block.reach = std::max(block.reach, l3d_length(corner(t) - block.middle));
        }
    }
}

/// Turns the mesh's own normals to the side from which faces' corners run counterclockwise, so that
/// the visible side is lit. Some files have normals that point to the opposite side. Where a
/// surface folds over, faces around one vertex get opposite normals, since light interpolated
/// between opposite normals would be dark.
void l3d_polygon_model::contents::turn_normals_to_faces() {
    const auto side_of = [&](const l3d_model_triangle& t, std::size_t k) {
        return l3d_dot(face_normals[t.face], vertex_normals[t.corners[k]]);
    };
    std::ptrdiff_t before = 0;
    for (const l3d_model_triangle& t : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (has_own_normal(t.corners[k]))
                before += (side_of(t, k) > 0) - (side_of(t, k) < 0);
    for (std::size_t v = 0; before < 0 && v < vertex_normals.size(); ++v)
        if (has_own_normal(v))
            vertex_normals[v] *= -1.0F;
    std::vector<std::uint32_t> turned(vertex_normals.size(), no_crease);
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        const l3d_model_triangle& t = triangles[i];
        for (std::size_t k = 0; k < 3; ++k) {
            std::uint32_t& normal = turned[t.corners[k]];
            if (side_of(t, k) >= 0 || !has_own_normal(t.corners[k]))
                continue;
            if (normal == no_crease) {
                normal = static_cast<std::uint32_t>(crease_normals.size());
                crease_normals.push_back(vertex_normals[t.corners[k]] * -1.0F);
            }
            set_crease(i, k, normal);
        }
    }
}

l3d_polygon_model l3d_polygon_model::part_painted(std::size_t part,
                                                  const l3d_material& material) const {
    std::vector<l3d_material> looks(mesh().faces());
    for (std::size_t f = 0; f < looks.size(); ++f)
        if (parts().of(f) == part)
            looks[f] = material;
        else if (!materials().empty())
            looks[f] = materials()[material_of(f)];
    l3d_polygon_model result = *this;
    const auto made = std::make_shared<contents>(*contents_);
    made->repainted.resize(looks.size());
    for (std::size_t f = 0; f < looks.size(); ++f)
        if (parts().of(f) == part)
            made->repainted[f] = true;
    made->make_materials(looks);
    made->make_painted();
    result.contents_ = made;
    return result;
}

l3d_polygon_model
l3d_polygon_model::textured(std::vector<std::shared_ptr<const l3d_texture>> textures) const {
    l3d_polygon_model result = *this;
    const auto made = std::make_shared<contents>(*contents_);
    made->textures = std::move(textures);
    made->make_painted();
    result.contents_ = made;
    return result;
}

l3d_polygon_model l3d_polygon_model::shown(const std::vector<bool>& faces) const {
    l3d_polygon_model result = *this;
    const auto made = std::make_shared<contents>(*contents_);
    made->keep_triangles(faces);
    made->make_painted();
    result.contents_ = made;
    return result;
}

l3d_polygon_model l3d_polygon_model::only(std::span<const std::size_t> parts) const {
    return shown(this->parts().things_of(parts, mesh().faces()));
}

l3d_polygon_model l3d_polygon_model::without(std::span<const std::size_t> parts) const {
    std::vector<bool> faces = this->parts().things_of(parts, mesh().faces());
    faces.flip();
    return shown(faces);
}

/// Cuts the model at a plane. It cuts triangles instead of faces, since faces may be concave.
l3d_polygon_model l3d_polygon_model::cut(const l3d_plane<double>& plane) const {
    l3d_polygon_mesh shown;
    shown.vertices = mesh().vertices;
    shown.vertex_normals = mesh().vertex_normals;
    shown.vertex_colors = mesh().vertex_colors;
    shown.looks.assign(materials().begin(), materials().end());
    for (l3d_material& look : shown.looks)
        look.picture = l3d_material::no_picture;
    shown.materials.resize(shown.looks.size());
    for (const l3d_model_triangle& triangle : triangles()) {
        const std::string name(parts().name_of(triangle.face));
        if (shown.parts.empty() || shown.parts.back().name != name)
            shown.parts.push_back({name, static_cast<std::uint32_t>(shown.faces())});
        shown.add_face(triangle.corners);
        if (!materials().empty())
            shown.face_materials.push_back(material_of(triangle.face));
    }
    l3d_polygon_mesh kept = l3d_cut_mesh(shown, plane);
    kept.materials = shown.materials;
    kept.looks = shown.looks;
    l3d_polygon_model result(std::move(kept));
    const auto made = std::make_shared<contents>(*result.contents_);
    made->least = least();
    made->most = most();
    made->radius = radius();
    result.contents_ = made;
    return result;
}

std::size_t l3d_polygon_model::bytes() const {
    return mesh().bytes() + triangles().size() * sizeof(l3d_model_triangle) +
           facing_blocks().size() * sizeof(l3d_facing_block) +
           materials().size() * sizeof(l3d_material) +
           contents_->materials_of_faces.size() * sizeof(std::uint32_t) +
           painted().size() * sizeof(l3d_painted_triangle) +
           contents_->crease_corners.size() * sizeof(contents_->crease_corners[0]) +
           (face_normals().size() + vertex_normals().size() + contents_->crease_normals.size()) *
               sizeof(direction);
}

namespace {

std::shared_ptr<const l3d_texture> texture_of(const l3d_mesh_picture& picture) {
    l3d_image image = picture.bytes.empty()
                          ? l3d_read_image(picture.name, l3d_most_texture_pixels)
                          : l3d_decoded_image(picture.bytes, picture.name, l3d_most_texture_pixels);
    const auto wrap = [](bool repeats, bool mirrors) {
        return !repeats  ? l3d_texture_wrap::clamp
               : mirrors ? l3d_texture_wrap::mirror
                         : l3d_texture_wrap::repeat;
    };
    return std::make_shared<const l3d_texture>(image.pixels(),
                                               wrap(picture.repeats_u, picture.mirrors_u),
                                               wrap(picture.repeats_v, picture.mirrors_v));
}

} // namespace

std::vector<std::shared_ptr<const l3d_texture>> l3d_read_textures(const l3d_polygon_mesh& mesh,
                                                                  std::vector<std::string>& notes) {
    std::vector<std::shared_ptr<const l3d_texture>> textures(mesh.pictures.size());
    if (mesh.looks.empty())
        return textures;
    std::vector<bool> is_shown(mesh.pictures.size());
    for (const std::uint32_t material : mesh.face_materials)
        if (const int picture = mesh.looks[material].picture; picture != l3d_material::no_picture)
            is_shown[static_cast<std::size_t>(picture)] = true;
    for (std::size_t i = 0; i < textures.size(); ++i)
        try {
            if (is_shown[i])
                textures[i] = texture_of(mesh.pictures[i]);
        } catch (const l3d_error& error) {
            notes.push_back(l3d_detail::printable(error.what()) +
                            "; its faces have the colours of their materials");
        }
    return textures;
}

std::shared_ptr<const l3d_texture> l3d_read_texture(const std::string& file,
                                                    std::vector<std::string>& notes) {
    try {
        l3d_image image = l3d_read_image(file, l3d_most_texture_pixels);
        return std::make_shared<const l3d_texture>(image.pixels());
    } catch (const l3d_error& error) {
        notes.push_back(l3d_detail::printable(error.what()) +
                        "; the model has the colours of its materials");
        return nullptr;
    }
}
