// SPDX-License-Identifier: MIT
// l3d_tessellated: adds each point once, then the faces.
#include "pipeline/polygons/polygon_model.h"

#include "dice/normal_columns.h"
#include "geom/bezier_patch.h"
#include "geom/files/model_file.h"
#include "base/error.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <map>
#include <vector>

namespace {

using patch = l3d_patch_model::patch;
using point = l3d_polygon_mesh::vector;
using curve = l3d_bezier_curve<double, 3>;

std::array<double, 3> numbers(const point& p) {
    return {p[0], p[1], p[2]};
}

/// Whether a boundary curve is evaluated from its end to its beginning. So the patches on both
/// sides, which may count in opposite directions, get the same points.
bool runs_backwards(const curve& c) {
    for (std::size_t i = 0; i < 2; ++i) {
        const auto from = numbers(c.points[i]), to = numbers(c.points[3 - i]);
        if (from != to)
            return to < from;
    }
    return false;
}

/// The point at parameter i / n of a boundary curve.
point boundary_point(curve c, int i, int n) {
    if (runs_backwards(c)) {
        std::ranges::reverse(c.points);
        i = n - i;
    }
    return c.evaluate(static_cast<double>(i) / n);
}

point surface_point(const patch& p, int column, int row, int n) {
    if (row == 0 || row == n)
        return boundary_point(p.row(row == 0 ? 0 : 3), column, n);
    if (column == 0 || column == n)
        return boundary_point(p.column(column == 0 ? 0 : 3), row, n);
    return p.evaluate(static_cast<double>(column) / n, static_cast<double>(row) / n);
}

/// The unit normal at point (column, row) of a patch's grid of n by n quads, or zero if there is
/// none.
point normal_at(const l3d_normal_net& normals, int column, int row, int n) {
    const std::array<float, 3> unit = l3d_unit_normal(
        normals.evaluate(static_cast<double>(column) / n, static_cast<double>(row) / n));
    return {unit[0], unit[1], unit[2]};
}

/// Reverses the normals of vertices that point to the back of the facets around the vertex. This
/// happens where a patch folds within less than a facet, as the teapot does at the top of its knob.
void turn_to_faces(l3d_polygon_mesh& mesh) {
    std::vector<point> areas(mesh.vertices.size(), point{0.0, 0.0, 0.0});
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        const point& first = mesh.vertices[face[0]];
        const point area =
            l3d_cross(mesh.vertices[face[1]] - first, mesh.vertices[face[2]] - first);
        for (const std::uint32_t corner : face)
            areas[corner] += area;
    }
    for (std::size_t i = 0; i < areas.size(); ++i)
        if (l3d_dot(areas[i], mesh.vertex_normals[i]) < 0)
            mesh.vertex_normals[i] *= -1.0;
}

/// Adds vertices to a mesh. Vertices on boundaries are added once for all patches.
class vertex_store {
public:
    explicit vertex_store(l3d_polygon_mesh& mesh) : mesh_(mesh) {}

    std::uint32_t add(const point& at, const point& normal) {
        mesh_.vertices.push_back(at);
        mesh_.vertex_normals.push_back(normal);
        return static_cast<std::uint32_t>(mesh_.vertices.size() - 1);
    }

    /// The index of the vertex with this place and normal, which is added if it is missing. At a
    /// crease, several vertices have one place.
    std::uint32_t shared(const point& at, const point& normal) {
        // Two patches that join smoothly have normals that differ by roundings, and by the
        // inaccuracy of their control points. A thousandth of a radian is a quarter of a grey
        // level.
        constexpr double same = 1e-3;
        std::vector<std::uint32_t>& here = by_place_[numbers(at)];
        for (const std::uint32_t i : here)
            if (l3d_length(mesh_.vertex_normals[i] - normal) < same)
                return i;
        here.push_back(add(at, normal));
        return here.back();
    }

private:
    l3d_polygon_mesh& mesh_;
    std::map<std::array<double, 3>, std::vector<std::uint32_t>> by_place_;
};

} // namespace

l3d_patch_mesh l3d_tessellated(const l3d_patch_model& model, int n) {
    assert(n >= 1);
    if (model.has_trims())
        throw l3d_error(
            l3d_exit::bad_input,
            "trimmed surfaces: polygons stand for whole ones alone; pipeline afd draws them");
    l3d_patch_mesh result;
    l3d_polygon_mesh& mesh = result.mesh;
    vertex_store vertices(mesh);
    const auto side = static_cast<std::size_t>(n) + 1;
    std::vector<std::uint32_t> grid(side * side);
    const std::vector<l3d_part_run> runs = model.parts().runs();
    auto run = runs.begin();
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        const auto at = [&](std::uint32_t i) -> const point& { return mesh.vertices[i]; };
        if (at(a) != at(b) && at(b) != at(c) && at(c) != at(a))
            mesh.add_face({{a, b, c}});
    };
    for (std::size_t i = 0; i < model.patches().size(); ++i) {
        const patch& p = model.patches()[i];
        if (run != runs.end() && run->first == model.piece_of(i))
            mesh.parts.push_back({run++->name, static_cast<std::uint32_t>(mesh.faces())});
        for (int row = 0; row <= n; ++row)
            for (int column = 0; column <= n; ++column) {
                const bool inside = row > 0 && row < n && column > 0 && column < n;
                const point at = surface_point(p, column, row, n);
                const point normal = normal_at(model.normals(i), column, row, n);
                grid[static_cast<std::size_t>(row) * side + static_cast<std::size_t>(column)] =
                    inside ? vertices.add(at, normal) : vertices.shared(at, normal);
            }
        for (std::size_t row = 0; row + 1 < side; ++row)
            for (std::size_t column = 0; column + 1 < side; ++column) {
                const std::uint32_t* const at = &grid[row * side + column];
                add(at[0], at[1], at[side + 1]);
                add(at[0], at[side + 1], at[side]);
            }
        result.face_ends.push_back(mesh.faces());
        if (!model.materials().empty())
            mesh.face_materials.resize(mesh.faces(), model.material_of(i));
    }
    mesh.looks.assign(model.materials().begin(), model.materials().end());
    for (std::size_t i = 0; i < mesh.looks.size(); ++i)
        mesh.materials.push_back(std::to_string(i + 1));
    turn_to_faces(mesh);
    return result;
}

l3d_polygon_mesh l3d_mesh_of(const l3d_model_file& file, const std::string& name, int n) {
    const auto refuse = [](const std::string& why) { throw l3d_error(l3d_exit::bad_input, why); };
    l3d_polygon_mesh mesh = file.mesh;
    if (!file.patches.empty()) {
        std::string why;
        const auto patches = l3d_patch_model::from_file(file, name, why);
        if (!patches)
            refuse(why);
        mesh.append(l3d_tessellated(*patches, n).mesh);
    }
    if (mesh.faces() == 0)
        refuse(name + (file.patches.empty() ? ": no polygons and no patches"
                                            : ": no polygons, and patches without any area"));
    return mesh;
}
