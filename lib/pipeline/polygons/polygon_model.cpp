// SPDX-License-Identifier: MIT
// l3d_polygon_model: ears, normals, box.
#include "pipeline/polygons/polygon_model.h"

#include "scene/model_loader.h"
#include "pipeline/polygons/patch_tessellation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace {

using vector = l3d_polygon_model::vector;
using direction = l3d_polygon_model::direction;

/// Twice the area times the normal. Source: Newell's sum over the sides; any corner may be concave.
/// Counted from the first corner: far from the origin the products would cancel.
vector area_vector(const l3d_polygon_mesh& mesh, std::span<const std::uint32_t> face) {
    vector sum{0.0, 0.0, 0.0};
    const vector& first = mesh.vertices[face[0]];
    for (std::size_t i = 2; i < face.size(); ++i)
        sum += l3d_cross(mesh.vertices[face[i - 1]] - first, mesh.vertices[face[i]] - first);
    return sum;
}

direction unit(const vector& v) {
    return l3d_converted<float>(l3d_normalized(v));
}

/// A face seen along the axis its normal is nearest to, counterclockwise.
class flat_face {
public:
    flat_face(const l3d_polygon_mesh& mesh, std::span<const std::uint32_t> face) : face_(face) {
        const vector normal = area_vector(mesh, face);
        int axis = 0;
        for (int i = 1; i < 3; ++i)
            if (std::abs(normal[i]) > std::abs(normal[axis]))
                axis = i;
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const double sign = normal[axis] < 0 ? -1 : 1;
        for (const std::uint32_t corner : face)
            places_.push_back({sign * mesh.vertices[corner][u], mesh.vertices[corner][v]});
        for (std::size_t i = 0; i < face.size(); ++i)
            left_.push_back(i);
    }

    /// Cuts off corner after corner that holds no other corner.
    /// Cost:    linear for a convex face; of n corners, n^2 if each ear is found at once.
    template <class Emit> void triangulate(const Emit& emit) {
        if (is_convex()) {
            for (std::size_t i = 2; i < face_.size(); ++i)
                emit_triangle({0, i - 1, i}, emit);
            return;
        }
        while (left_.size() > 3) {
            std::size_t ear = 1;
            while (ear < left_.size() && !is_ear(ear))
                ++ear;
            // A face that crosses itself may have none.
            cut(ear < left_.size() ? ear : 1, emit);
        }
        cut(1, emit);
    }

private:
    struct place {
        double u, v;
    };

    double turn(std::size_t a, std::size_t b, std::size_t c) const {
        const place &p = places_[a], &q = places_[b], &r = places_[c];
        return (q.u - p.u) * (r.v - p.v) - (q.v - p.v) * (r.u - p.u);
    }
    std::size_t at(std::size_t i) const { return left_[i % left_.size()]; }

    /// Turns left everywhere, and goes round once: right, then left along u.
    bool is_convex() const {
        const std::size_t n = places_.size();
        int reversals = 0;
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (i + 1) % n, k = (i + 2) % n;
            if (turn(i, j, k) < 0)
                return false;
            reversals += (places_[j].u < places_[i].u) != (places_[k].u < places_[j].u);
        }
        return reversals <= 2;
    }

    bool is_ear(std::size_t i) const {
        const std::size_t a = at(i - 1), b = at(i), c = at(i + 1);
        if (turn(a, b, c) <= 0)
            return false;
        return std::ranges::none_of(left_, [&](std::size_t p) {
            return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 &&
                   turn(c, a, p) >= 0;
        });
    }

    template <class Emit> void cut(std::size_t ear, const Emit& emit) {
        emit_triangle({at(ear - 1), at(ear), at(ear + 1)}, emit);
        left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(ear % left_.size()));
    }

    template <class Emit>
    void emit_triangle(const std::array<std::size_t, 3>& corners, const Emit& emit) const {
        l3d_model_triangle triangle;
        for (std::size_t k = 0; k < 3; ++k) {
            triangle.corners[k] = face_[corners[k]];
            if ((corners[k] + 1) % face_.size() == corners[(k + 1) % 3])
                triangle.sides |= 1u << k;
        }
        emit(triangle);
    }

    std::span<const std::uint32_t> face_;
    std::vector<place> places_;
    std::vector<std::size_t> left_; ///< corners not yet cut off
};

} // namespace

l3d_polygon_model::l3d_polygon_model(l3d_polygon_mesh mesh, bool to_origin)
    : contents_(std::make_shared<const contents>(std::move(mesh), to_origin)) {}

l3d_polygon_model l3d_polygon_model::load(const std::string& file) {
    return l3d_polygon_model(l3d_mesh_of(l3d_load_model(file, file), file, l3d_usual_facets));
}

l3d_polygon_model::contents::contents(l3d_polygon_mesh of, bool to_origin) : mesh(std::move(of)) {
    assert(mesh.is_valid());
    if (to_origin && !mesh.vertices.empty()) {
        vector sum{0.0, 0.0, 0.0};
        for (const vector& v : mesh.vertices)
            sum += v;
        const vector mean = sum / static_cast<double>(mesh.vertices.size());
        for (vector& v : mesh.vertices)
            v -= mean;
    }
    if (!mesh.vertices.empty())
        least = most = mesh.vertices.front();
    for (const vector& v : mesh.vertices) {
        for (int i = 0; i < 3; ++i) {
            least[i] = std::min(least[i], v[i]);
            most[i] = std::max(most[i], v[i]);
        }
    }
    for (const vector& v : mesh.vertices)
        radius = std::max(radius, l3d_length(v - centre()));
    make_triangles();
    make_normals();
    make_materials();
}

/// Faces that look alike share a material. If all are plain, there are none.
void l3d_polygon_model::contents::make_materials() {
    using key = std::tuple<std::uint32_t, std::uint32_t, int>;
    std::map<key, std::uint32_t> places;
    materials.emplace_back();
    places[key(materials[0].color, materials[0].highlight, materials[0].sharpness)] = 0;
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const l3d_material look = mesh.look_of(f);
        const auto next = static_cast<std::uint32_t>(materials.size());
        const auto [place, is_new] =
            places.try_emplace({look.color, look.highlight, look.sharpness}, next);
        if (is_new)
            materials.push_back(look);
        if (place->second == 0 && materials_of_faces.empty())
            continue;
        materials_of_faces.resize(f);
        materials_of_faces.push_back(place->second);
    }
    materials_of_faces.resize(materials_of_faces.empty() ? 0 : mesh.faces());
    if (materials_of_faces.empty())
        materials.clear();
}

void l3d_polygon_model::contents::make_triangles() {
    triangles.reserve(mesh.corners.size() - 2 * mesh.faces());
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        const auto number = static_cast<std::uint32_t>(f);
        if (face.size() == 3)
            triangles.push_back({{face[0], face[1], face[2]}, number, 7});
        else
            flat_face(mesh, face).triangulate([&](l3d_model_triangle triangle) {
                triangle.face = number;
                triangles.push_back(triangle);
            });
    }
}

void l3d_polygon_model::contents::make_normals() {
    std::vector<vector> sums(mesh.vertices.size(), vector{0.0, 0.0, 0.0});
    face_normals.reserve(mesh.faces());
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        const vector area = area_vector(mesh, face);
        face_normals.push_back(unit(area));
        for (const std::uint32_t corner : face)
            sums[corner] += area;
    }
    vertex_normals.reserve(sums.size());
    for (const vector& v : mesh.vertex_normals.empty() ? sums : mesh.vertex_normals)
        vertex_normals.push_back(unit(v));
}

std::size_t l3d_polygon_model::bytes() const {
    return mesh().bytes() + triangles().size() * sizeof(l3d_model_triangle) +
           materials().size() * sizeof(l3d_material) +
           contents_->materials_of_faces.size() * sizeof(std::uint32_t) +
           (face_normals().size() + vertex_normals().size()) * sizeof(direction);
}
