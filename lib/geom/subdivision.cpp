// SPDX-License-Identifier: MIT
// l3d_subdivide: checks the cage, calls the plug-in, and gives patches the looks of their faces.
#include "geom/subdivision.h"

#include "base/counted_p.h"
#include "base/formatted_p.h"
#include "base/printable_p.h"
#include "geom/files/model_file.h"
#include "geom/files/subdivision_plugin_p.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <utility>

namespace {

using vector = l3d_polygon_mesh::vector;

/// An edge's two vertices, the smaller one first.
using edge = std::pair<std::uint32_t, std::uint32_t>;

edge edge_between(std::uint32_t a, std::uint32_t b) {
    return std::minmax(a, b);
}

/// The faces at an edge. The first face walks from the edge's smaller vertex to the larger one.
struct sides_of_edge {
    static constexpr std::uint32_t nothing = 0xffffffff;
    std::uint32_t faces[2] = {nothing, nothing};
};

/// The edges of a mesh. Each edge has at most two faces, which walk along it in opposite
/// directions.
class cage_edges {
public:
    explicit cage_edges(const l3d_polygon_mesh& mesh) : mesh_(mesh) {}

    /// The error message for a mesh that is not a cage; "" if it is a cage. The message counts
    /// faces and vertices from 1.
    std::string complaint() {
        for (std::size_t i = 0; i < mesh_.faces(); ++i) {
            const std::string what = add(static_cast<std::uint32_t>(i));
            if (!what.empty())
                return what;
        }
        return complaint_of_fans();
    }

    const std::map<edge, sides_of_edge>& all() const { return edges_; }

private:
    static std::string number(std::size_t index) { return std::to_string(index + 1); }

    std::string add(std::uint32_t index) {
        const auto face = mesh_.face(index);
        for (std::size_t k = 0; k < face.size(); ++k) {
            const std::uint32_t from = face[k], to = face[(k + 1) % face.size()];
            if (std::ranges::count(face, from) > 1)
                return "polygon " + number(index) + " has vertex " + number(from) + " twice";
            sides_of_edge& sides = edges_[edge_between(from, to)];
            std::uint32_t& side = sides.faces[from < to ? 0 : 1];
            if (side == sides_of_edge::nothing) {
                side = index;
                continue;
            }
            const std::string between =
                "the edge of vertices " + number(from) + " and " + number(to);
            if (sides.faces[from < to ? 1 : 0] != sides_of_edge::nothing)
                return "polygon " + number(index) + " is the third at " + between;
            return "polygons " + number(side) + " and " + number(index) +
                   " turn opposite ways at " + between;
        }
        return "";
    }

    /// The error message for a vertex whose faces make more than one fan, so that edges at the
    /// vertex do not join all of these faces.
    std::string complaint_of_fans() const {
        // A fan has as many edges as faces, or one edge more if it is open.
        std::vector<std::uint32_t> faces(mesh_.vertices.size());
        for (const std::uint32_t corner : mesh_.corners)
            ++faces[corner];
        std::vector<bool> is_seen(mesh_.vertices.size(), false);
        for (std::size_t i = 0; i < mesh_.faces(); ++i)
            for (const std::uint32_t vertex : mesh_.face(i))
                if (!is_seen[vertex]) {
                    is_seen[vertex] = true;
                    if (fan_size(static_cast<std::uint32_t>(i), vertex) < faces[vertex])
                        return "polygons meet in vertex " + number(vertex) +
                               " alone, and have no edge in common there";
                }
        return "";
    }

    /// The number of faces in the fan around `vertex` that holds face `first`.
    std::uint32_t fan_size(std::uint32_t first, std::uint32_t vertex) const {
        std::uint32_t size = 1;
        for (const bool forwards : {true, false}) {
            for (std::uint32_t face = first;; ++size) {
                face = beyond(face, vertex, forwards);
                if (face == first)
                    return size;
                if (face == sides_of_edge::nothing)
                    break;
            }
        }
        return size;
    }

    /// The face on the other side of an edge at `vertex`. If `leaves`, face `index` walks along the
    /// edge away from the vertex, else towards the vertex. `nothing` if the edge is a boundary.
    std::uint32_t beyond(std::uint32_t index, std::uint32_t vertex, bool leaves) const {
        const auto face = mesh_.face(index);
        const auto at = static_cast<std::size_t>(std::ranges::find(face, vertex) - face.begin());
        const std::uint32_t other = face[(at + (leaves ? 1 : face.size() - 1)) % face.size()];
        const sides_of_edge& sides = edges_.at(edge_between(vertex, other));
        return sides.faces[0] == index ? sides.faces[1] : sides.faces[0];
    }

    const l3d_polygon_mesh& mesh_;
    std::map<edge, sides_of_edge> edges_;
};

/// The creases of the model's tags, and edges where the normals of two faces differ by more than
/// `angle` degrees. `unknown` counts tags that name no edge.
struct cage_creases {
    std::vector<std::uint32_t> vertices;
    std::vector<float> sharpness;

    void add(const edge& of, float sharp) {
        vertices.push_back(of.first);
        vertices.push_back(of.second);
        sharpness.push_back(sharp);
    }

    cage_creases(const l3d_model_file& model, const cage_edges& edges, double angle,
                 std::size_t& unknown) {
        std::map<edge, float> all;
        for (const auto& crease : model.tags.creases) {
            const edge at = edge_between(crease.from, crease.to);
            if (edges.all().contains(at))
                all[at] = crease.sharpness;
            else
                ++unknown;
        }
        const double least = std::cos(angle * std::numbers::pi / 180);
        for (const auto& [at, sides] : edges.all()) {
            if (angle >= 180 || sides.faces[0] == sides_of_edge::nothing ||
                sides.faces[1] == sides_of_edge::nothing)
                continue;
            const vector a = model.mesh.area_vector(model.mesh.face(sides.faces[0]));
            const vector b = model.mesh.area_vector(model.mesh.face(sides.faces[1]));
            if (l3d_dot(a, b) < least * l3d_length(a) * l3d_length(b))
                all[at] = 10; // never smoothed
        }
        for (const auto& [at, sharp] : all)
            add(at, sharp);
    }
};

/// Collects the plug-in's patches.
struct receiver {
    l3d_model_file& model;
    std::vector<std::uint32_t> faces; ///< the face of each patch
    std::string complaint{};

    static void take(void* to, std::uint32_t face, const double* points, double error,
                     std::uint32_t is_cap) {
        receiver& self = *static_cast<receiver*>(to);
        l3d_patch_points& patch = self.model.patches.emplace_back(
            l3d_patch_points{.degree_u = 3, .degree_v = 3, .points = {}});
        for (int k = 0; k < 16; ++k, points += 3)
            patch.points.push_back({points[0], points[1], points[2]});
        self.model.patch_errors.push_back({error, is_cap == 0});
        self.faces.push_back(face);
    }
    static void fail(void* to, const char* why) { static_cast<receiver*>(to)->complaint = why; }
};

/// Gives patches the looks and parts of their faces. Each pair of a material and a face's colour
/// makes a look.
void hand_on(const std::vector<std::uint32_t>& faces, std::size_t first, l3d_model_file& model) {
    l3d_polygon_mesh& mesh = model.mesh;
    const std::size_t materials = mesh.materials.size();
    if (!mesh.face_materials.empty() || !mesh.face_colors.empty())
        model.patch_materials.resize(first, 0);
    if (!mesh.face_colors.empty())
        mesh.looks.resize(materials);
    std::map<std::pair<std::uint32_t, l3d_color>, std::uint32_t> colored;
    for (const std::uint32_t face : faces) {
        const std::uint32_t material = mesh.face_materials.empty() ? 0 : mesh.face_materials[face];
        if (mesh.face_colors.empty()) {
            if (!mesh.face_materials.empty())
                model.patch_materials.push_back(material);
            continue;
        }
        const auto [at, is_new] = colored.try_emplace(
            {material, mesh.face_colors[face]}, static_cast<std::uint32_t>(mesh.looks.size()));
        if (is_new) {
            mesh.materials.push_back(materials == 0 ? "" : mesh.materials[material]);
            mesh.looks.push_back(mesh.look_of(face));
        }
        model.patch_materials.push_back(at->second);
    }
    const l3d_parts parts(mesh.parts, mesh.faces());
    for (std::size_t i = 0; i < faces.size() && !mesh.parts.empty(); ++i)
        if (i == 0 || parts.name_of(faces[i]) != parts.name_of(faces[i - 1]))
            model.patch_parts.push_back(
                {std::string(parts.name_of(faces[i])), static_cast<std::uint32_t>(first + i)});
}

/// The length of the diagonal of the box around all vertices that faces use.
double size_of(const l3d_polygon_mesh& mesh) {
    vector least = mesh.vertices[mesh.corners.front()], most = least;
    for (const std::uint32_t corner : mesh.corners)
        for (int k = 0; k < 3; ++k) {
            least[k] = std::min(least[k], mesh.vertices[corner][k]);
            most[k] = std::max(most[k], mesh.vertices[corner][k]);
        }
    return l3d_length(most - least);
}

/// Arrays of a cage that the plug-in needs in another form than the model has them.
struct cage_arrays {
    std::vector<double> places;
    std::vector<std::uint32_t> corner_vertices;
    std::vector<float> corner_sharpness;

    explicit cage_arrays(const l3d_model_file& model) {
        for (const vector& v : model.mesh.vertices)
            places.insert(places.end(), {v[0], v[1], v[2]});
        for (const auto& corner : model.tags.corners) {
            corner_vertices.push_back(corner.vertex);
            corner_sharpness.push_back(corner.sharpness);
        }
    }

    /// The cage for the plug-in. Lives: borrows the arrays, the model and the creases.
    l3d_detail::subdivision_cage cage(const l3d_model_file& model, const cage_creases& creases,
                                      const l3d_subdivision& how, double wanted_error) const {
        const l3d_polygon_mesh& mesh = model.mesh;
        const bool keeps_corners = how.boundary == l3d_cage_boundary::as_tagged
                                       ? model.tags.keeps_corners.value_or(true)
                                       : how.boundary == l3d_cage_boundary::corners;
        constexpr std::uint64_t most_patches = std::uint64_t{1} << 17; // some 300 MB when drawn
        return {.vertices = l3d_polygon_mesh::index_of(mesh.vertices.size()),
                .places = places.data(),
                .faces = l3d_polygon_mesh::index_of(mesh.faces()),
                .face_ends = mesh.face_ends.data(),
                .corners = mesh.corners.data(),
                .creases = l3d_polygon_mesh::index_of(creases.sharpness.size()),
                .crease_vertices = creases.vertices.data(),
                .crease_sharpness = creases.sharpness.data(),
                .points = l3d_polygon_mesh::index_of(corner_sharpness.size()),
                .point_vertices = corner_vertices.data(),
                .point_sharpness = corner_sharpness.data(),
                .holes = l3d_polygon_mesh::index_of(model.tags.holes.size()),
                .hole_faces = model.tags.holes.data(),
                .keeps_corners = keeps_corners ? 1U : 0U,
                .wanted_error = wanted_error,
                .most_patches = most_patches};
    }
};

/// Tells how exact the patches are. `size` is the model's size, and `asked` the wanted error as a
/// share of the model's size.
std::string exactness_of(const l3d_detail::subdivision_outcome& reached, double size,
                         double asked) {
    if (reached.caps == 0)
        return "all exact";
    std::string result = l3d_detail::formatted(
        "of which %u are not exact; after %u levels all are within %.2g of "
        "the limit surface, %.2g of the model's size",
        reached.caps, reached.levels, reached.error, size > 0 ? reached.error / size : 0.0);
    if (reached.error > asked * size)
        result += l3d_detail::formatted(", where %.2g was asked for", asked);
    return result;
}

} // namespace

bool l3d_subdivide(l3d_model_file& model, const l3d_subdivision& how, std::string_view name,
                   std::string& why) {
    const std::string whose = l3d_detail::printable(name) + ": ";
    const l3d_polygon_mesh& mesh = model.mesh;
    const auto fail = [&](const std::string& what) {
        why = whose + what;
        return false;
    };
    if (mesh.faces() == 0)
        return fail("holds no polygons to subdivide");
    cage_edges edges(mesh);
    const std::string fault = edges.complaint();
    if (!fault.empty())
        return fail(fault + ": a cage for subdivision has two polygons at an edge at most, which "
                            "turn the same way");
    std::string reason;
    const auto* const plugin = static_cast<const l3d_detail::subdivision_plugin*>(
        l3d_detail::load_plugin("subdivision", l3d_detail::subdivision_plugin_version,
                                sizeof(l3d_detail::subdivision_plugin), reason));
    if (!plugin)
        return fail("to subdivide polygons, " + reason);

    std::size_t unknown = 0;
    const cage_creases creases(model, edges, how.crease_angle, unknown);
    const double size = size_of(mesh);
    const cage_arrays arrays(model);
    const l3d_detail::subdivision_cage cage = arrays.cage(model, creases, how, how.error * size);
    l3d_model_file made = model;
    made.patch_errors.resize(made.patches.size());
    receiver to{made, {}};
    const l3d_detail::subdivision_sink sink{&to, receiver::take, receiver::fail};
    l3d_detail::subdivision_outcome reached{};
    if (!plugin->subdivide(&cage, &sink, &reached))
        return fail("cannot be subdivided: " + to.complaint);

    hand_on(to.faces, model.patches.size(), made);
    if (unknown > 0)
        made.notes.push_back(whose + l3d_detail::counted(unknown, "creases") +
                             " of tags are no edges of polygons, and are skipped");
    if (!mesh.vertex_colors.empty())
        made.notes.push_back(whose + "colours of vertices are skipped: patches have one colour");
    made.notes.push_back(whose + "subdivided: " + l3d_detail::counted(to.faces.size(), "patches") +
                         ", " + exactness_of(reached, size, how.error));
    l3d_polygon_mesh rest;
    rest.materials = std::move(made.mesh.materials);
    rest.looks = std::move(made.mesh.looks);
    rest.pictures = std::move(made.mesh.pictures);
    made.mesh = std::move(rest);
    made.tags = {};
    model = std::move(made);
    return true;
}
