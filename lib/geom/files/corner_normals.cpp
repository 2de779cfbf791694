// SPDX-License-Identifier: MIT
// corner_normals: divides vertices, so that each has one normal.
#include "geom/files/corner_normals_p.h"

#include "base/number_hash_p.h"
#include "geom/files/model_reader_p.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace l3d_detail {

/// The faces around each vertex, and the area vectors of all faces.
struct corner_normals::faces_around {
    explicit faces_around(const l3d_polygon_mesh& mesh)
        : ends(mesh.vertices.size() + 1), faces(mesh.corners.size()) {
        for (const std::uint32_t vertex : mesh.corners)
            ++ends[vertex + 1];
        std::partial_sum(ends.begin(), ends.end(), ends.begin());
        std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
        for (std::uint32_t f = 0; f < mesh.faces(); ++f) {
            for (const std::uint32_t vertex : mesh.face(f))
                faces[next[vertex]++] = f;
            areas.push_back(mesh.area_vector(mesh.face(f)));
        }
    }

    static bool share(std::uint64_t groups, std::uint64_t others) {
        return groups == others || ((groups | others) < numbered && (groups & others) != 0);
    }

    /// The mean normal, weighted by area, of the faces around a vertex that are in one of `groups`.
    vector normal(std::uint32_t vertex, std::uint64_t groups,
                  const std::vector<std::uint64_t>& of_faces) const {
        vector sum(0);
        for (std::uint32_t i = ends[vertex]; i < ends[vertex + 1]; ++i)
            if (share(groups, of_faces[faces[i]]))
                sum += areas[faces[i]];
        return l3d_normalized(sum);
    }

    std::vector<std::uint32_t> ends, faces;
    std::vector<vector> areas;
};

bool corner_normals::give_to_last_corner(const l3d_polygon_mesh& mesh, std::uint32_t normal) {
    const bool says = has_direction(normals_[normal]);
    of_corners_.resize(mesh.corners.size() - 1, none);
    of_corners_.push_back(says ? normal : none);
    return says;
}

void corner_normals::give_to_last_face(const l3d_polygon_mesh& mesh, std::uint64_t groups) {
    of_faces_.resize(mesh.faces() - 1, unsaid);
    of_faces_.push_back(groups);
}

void corner_normals::finish(l3d_polygon_mesh& mesh) {
    if (!any() && (normals_.empty() || !mesh.corners.empty()))
        return;
    of_corners_.resize(mesh.corners.size(), none);
    of_faces_.resize(mesh.faces(), unsaid);
    divide_vertices(mesh);
    forget_odd_normals(mesh);
}

std::uint64_t corner_normals::said_by(std::size_t corner, std::size_t face) const {
    const std::uint64_t groups = of_faces_[face];
    if (of_corners_[corner] != none)
        return of_corners_[corner];
    if (groups == unsaid || groups >= numbered)
        return groups;
    return groups == 0 ? flat : groups | grouped;
}

/// Gives each vertex one normal: the first normal among the vertex's corners. Each further normal
/// gets a new vertex at the same place.
void corner_normals::divide_vertices(l3d_polygon_mesh& mesh) const {
    const bool has_groups = std::ranges::any_of(
        of_faces_, [](std::uint64_t groups) { return groups != 0 && groups != unsaid; });
    const faces_around around(has_groups ? mesh : l3d_polygon_mesh());
    const std::size_t vertices = mesh.vertices.size();
    std::vector<std::uint64_t> said(vertices, free);
    std::unordered_map<std::array<std::uint64_t, 2>, std::uint32_t, number_hash> others;
    mesh.vertex_normals.assign(vertices, vector(0));

    std::size_t corner = 0;
    for (std::size_t f = 0; f < mesh.faces(); ++f) {
        const vector area = mesh.area_vector(mesh.face(f));
        for (; corner < mesh.face_ends[f]; ++corner) {
            const std::uint32_t at = mesh.corners[corner];
            const std::uint64_t says = said_by(corner, f);
            std::uint32_t to = at;
            bool is_new = said[at] == free;
            if (is_new) {
                said[at] = says;
            } else if (says == flat || says != said[at]) { // two flat faces share no vertex
                to = l3d_polygon_mesh::index_of(mesh.vertices.size());
                is_new = says == flat;
                if (says != flat) {
                    const auto found = others.try_emplace({std::uint64_t{at}, says}, to);
                    to = found.first->second;
                    is_new = found.second;
                }
                if (is_new) {
                    mesh.vertices.push_back(mesh.vertices[at]);
                    mesh.vertex_normals.emplace_back(0);
                    if (!mesh.vertex_colors.empty())
                        mesh.vertex_colors.push_back(mesh.vertex_colors[at]);
                }
            }
            mesh.corners[corner] = to;
            if (is_new && says != unsaid)
                mesh.vertex_normals[to] = says == flat ? l3d_normalized(area)
                                          : says < none
                                              ? normals_[says]
                                              : around.normal(at, of_faces_[f], of_faces_);
        }
    }
    for (std::size_t v = 0; v < std::min(vertices, normals_.size()); ++v)
        if (said[v] == free)
            mesh.vertex_normals[v] = normals_[v];
}

} // namespace l3d_detail
