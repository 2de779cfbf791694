// SPDX-License-Identifier: MIT
// audit: writes the numbers of an audit as JSON, and shows its picture.
#include "audit.h"

#include <l3d/any_model.h>
#include <l3d/error.h>
#include <l3d/shade.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <variant>

namespace {

using vector = mesh_audit::vector;
using triangles = std::vector<l3d_surface_audit::triangle>;

l3d_polygon_model loaded(const std::string& file) {
    const l3d_any_model any = l3d_load_any_model(file);
    const auto* const mesh = std::get_if<l3d_polygon_model>(&any);
    if (!mesh)
        throw l3d_error(l3d_exit::bad_input,
                        file + ": it holds surfaces, and --audit wants a mesh");
    if (mesh->triangles().empty())
        throw l3d_error(l3d_exit::bad_input, file + ": it holds no triangles");
    return *mesh;
}

triangles triangles_of(const l3d_polygon_model& model) {
    triangles result;
    for (const l3d_model_triangle& t : model.triangles())
        result.push_back({model.mesh().vertices[t.corners[0]], model.mesh().vertices[t.corners[1]],
                          model.mesh().vertices[t.corners[2]]});
    return result;
}

/// A number with the digits that people read.
std::string short_text(double number) {
    std::array<char, 32> text{}; // six digits, a sign, a point and an exponent
    std::snprintf(text.data(), text.size(), "%.6g", number);
    return text.data();
}

std::string short_text(const vector& v) {
    return short_text(v[0]) + ", " + short_text(v[1]) + ", " + short_text(v[2]);
}

/// Cuts triangles in halves until no side is longer. `visit` gets each part.
template <class Visit>
void cut_small(const l3d_surface_audit::triangle& t, double longest, const Visit& visit) {
    std::size_t side = 0;
    std::array<double, 3> lengths{};
    for (std::size_t k = 0; k < 3; ++k) {
        lengths[k] = l3d_length(t[(k + 1) % 3] - t[k]);
        if (lengths[k] > lengths[side])
            side = k;
    }
    if (lengths[side] <= longest)
        return visit(t);
    const vector &a = t[side], &b = t[(side + 1) % 3], &c = t[(side + 2) % 3];
    const vector half = (a + b) * 0.5;
    cut_small({a, half, c}, longest, visit);
    cut_small({half, b, c}, longest, visit);
}

/// The longest side of the parts into which a picture cuts triangles. It is some pixels, but so
/// long that a processor measures all parts in seconds. CAD meshes have crowds of long thin
/// triangles.
double longest_part(const triangles& mesh, double size) {
    constexpr double pixels = 1.0 / 128;
    const double most_parts = 0x1p17 + static_cast<double>(mesh.size());
    for (double longest = pixels * size;; longest *= 2) {
        double parts = 0;
        for (const auto& [a, b, c] : mesh) {
            const double side = std::max({l3d_length(b - a), l3d_length(c - b), l3d_length(a - c)});
            const double area = l3d_length(l3d_cross(b - a, c - a));
            parts += std::max(1.0, side / longest) *
                     (side > 0 ? std::max(1.0, area / side / longest) : 1.0);
        }
        if (parts <= most_parts)
            return longest;
    }
}

void add_triangle(l3d_polygon_mesh& mesh, const l3d_surface_audit::triangle& t, l3d_color color) {
    const auto first = l3d_polygon_mesh::index_of(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), t.begin(), t.end());
    mesh.add_face(std::array{first, first + 1, first + 2});
    mesh.face_colors.push_back(color);
}

} // namespace

mesh_audit::mesh_audit(std::string surface_file, const l3d_patch_model& surface,
                       std::string mesh_file, double tolerance)
    : surface_file_(std::move(surface_file)), mesh_file_(std::move(mesh_file)),
      pieces_(surface.pieces()), mesh_(loaded(mesh_file_)),
      diagonal_(l3d_length(surface.pieces_most() - surface.pieces_least())),
      tolerance_(tolerance * diagonal_), surface_(surface, tolerance_) {
    using clock = std::chrono::steady_clock;
    const auto begin = clock::now();
    const triangles mesh = triangles_of(mesh_);
    found_ = surface_.compare(mesh);
    face_ = surface.face_of(found_.from_surface.index);
    seconds_ = std::chrono::duration<double>(clock::now() - begin).count();
    for (std::size_t i = 0; part_.empty() && i < surface.patches().size(); ++i)
        if (surface.piece_of(i) == found_.from_surface.index)
            part_ = surface.parts().name_of(i);
    // The view of the worst place: a triangle is seen from its outside, and a missing part from the
    // side away from the mesh's middle.
    const vector usual(1.0, 0.8, 1.4);
    vector out = worst().place - mesh_.centre();
    if (&worst() == &found_.from_mesh) {
        const auto& [a, b, c] = mesh[worst().index];
        out = l3d_cross(b - a, c - a);
    }
    const double length = l3d_length(out);
    sight_ =
        l3d_normalized(usual) * 0.5 + (length > 0 ? out * (1 / length) : vector(0.0, 0.0, 0.0));
}

const l3d_audited_way& mesh_audit::worst() const {
    return found_.from_mesh.least >= found_.from_surface.least ? found_.from_mesh
                                                               : found_.from_surface;
}

std::string mesh_audit::json() const {
    using json = nlohmann::ordered_json;
    const auto way = [](const l3d_audited_way& of, const char* what, std::size_t index) {
        return json{{"least", of.least},
                    {"most", of.most},
                    {"place", {of.place[0], of.place[1], of.place[2]}},
                    {what, index}};
    };
    const auto triangle = mesh_.triangles()[found_.from_mesh.index];
    json missing = way(found_.from_surface, "piece", found_.from_surface.index);
    if (face_ > 0)
        missing["face"] = face_;
    if (!part_.empty())
        missing["part"] = part_;
    json line{{"surface", surface_file_.empty() ? "teapot" : surface_file_},
              {"mesh", mesh_file_},
              {"pieces", pieces_},
              {"triangles", mesh_.triangles().size()},
              {"diagonal", diagonal_},
              {"tolerance", tolerance_},
              {"mesh_to_surface", way(found_.from_mesh, "face", triangle.face)},
              {"surface_to_mesh", missing},
              {"seconds", std::round(seconds_ * 1000) / 1000}};
    if (const std::string said = hint(); !said.empty())
        line["hint"] = said;
    return line.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::string mesh_audit::hint() const {
    const double times = l3d_length(mesh_.most() - mesh_.least()) / diagonal_;
    constexpr double near = 1.05, far = 2; // up to near, a unit fits; beyond far, sizes differ
    struct unit_guess {
        double times;
        const char* text;
    };
    for (const auto& [by, text] : {unit_guess{1000, "1000 times: millimetres in place of metres"},
                                   {0.001, "1/1000: metres in place of millimetres"},
                                   {25.4, "25.4 times: millimetres in place of inches"},
                                   {1 / 25.4, "1/25.4: inches in place of millimetres"}})
        if (times < by * near && times > by / near)
            return std::string("the mesh's size is that of the surface by about ") + text + "?";
    if (times > far || times < 1 / far)
        return "the mesh is " + short_text(times) + " times as large as the surface";
    return "";
}

l3d_color mesh_audit::color_of(double distance) const {
    const double most = std::max(found_.from_mesh.most, tolerance_);
    return l3d_inspection_color(l3d_shade::gaussian, 2 * distance / most - 1, 1);
}

l3d_polygon_model mesh_audit::picture() const {
    const double size = l3d_length(mesh_.most() - mesh_.least());
    const triangles all = triangles_of(mesh_);
    const double longest = longest_part(all, size);
    std::map<std::array<double, 3>, double> known;
    const auto distance = [&](const vector& p) {
        const auto [place, is_new] = known.try_emplace({p[0], p[1], p[2]}, 0.0);
        if (is_new)
            place->second = surface_.distance(p)[1];
        return place->second;
    };
    l3d_polygon_mesh result;
    for (const auto& triangle : all)
        cut_small(triangle, longest, [&](const l3d_surface_audit::triangle& t) {
            const double middle = surface_.distance((t[0] + t[1] + t[2]) * (1.0 / 3))[1];
            add_triangle(
                result, t,
                color_of(std::max({middle, distance(t[0]), distance(t[1]), distance(t[2])})));
        });
    // The mark is an octahedron, which peeps out on both sides.
    constexpr l3d_color magenta = 0x00ff00ff;
    const double radius = size / 100;
    const vector& at = worst().place;
    for (int i = 0; i < 8; ++i) {
        std::array<vector, 3> corners{at, at, at};
        for (int k = 0; k < 3; ++k)
            corners[static_cast<std::size_t>(k)][k] += (i >> k & 1) != 0 ? -radius : radius;
        if (i == 1 || i == 2 || i == 4 || i == 7) // so that normals point outwards
            std::swap(corners[1], corners[2]);
        add_triangle(result, corners, magenta);
    }
    return l3d_polygon_model(std::move(result));
}

l3d_panel mesh_audit::legend() const {
    l3d_panel panel;
    panel.add("distance from the mesh to the surface");
    panel.add_scale(l3d_inspection_colors(l3d_shade::gaussian, {}), "0",
                    short_text(std::max(found_.from_mesh.most, tolerance_)));
    const auto tell = [&](const char* what, const l3d_audited_way& of) {
        panel.add(std::string(what) + ": " + short_text(of.least) + " to " + short_text(of.most) +
                  " at " + short_text(of.place));
    };
    tell("mesh to surface", found_.from_mesh);
    tell("surface to mesh", found_.from_surface);
    panel.add("magenta: the worst place");
    return panel;
}
