// SPDX-License-Identifier: MIT
// crease_normals: groups the faces around a vertex by smooth edges.
#include "pipeline/polygons/crease_normals_p.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace l3d_detail {

namespace {

float cosine(double degrees) {
    return static_cast<float>(std::cos(degrees * std::numbers::pi / 180));
}

/// The margin of tests for normals that are rounded to float: the normals of coplanar faces differ
/// by some ulps.
constexpr float rounding = 1e-6F;

/// The corner that stands for the group of `corner`: the group's first corner.
std::uint32_t first_of(std::vector<std::uint32_t>& groups, std::uint32_t corner) {
    while (groups[corner] != corner)
        corner = groups[corner] = groups[groups[corner]];
    return corner;
}

} // namespace

crease_normals::crease_normals(const l3d_polygon_mesh& mesh, std::span<const vector> areas,
                               std::span<const direction> of_faces,
                               std::span<const direction> of_vertices, double crease_angle)
    : areas_(areas), of_faces_(of_faces), least_cosine_(cosine(crease_angle) - rounding),
      least_of_mean_(cosine(crease_angle / 2) + rounding) {
    std::vector<std::uint32_t> ends(mesh.vertices.size() + 1, 0);
    for (const std::uint32_t vertex : mesh.corners)
        ++ends[vertex + 1];
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    std::vector<corner> corners(mesh.corners.size());
    std::vector<std::uint32_t> next(ends.begin(), ends.end() - 1);
    for (std::uint32_t f = 0; f < mesh.faces(); ++f) {
        const auto face = mesh.face(f);
        std::uint32_t before = face.back();
        for (std::size_t i = 0; i < face.size(); before = face[i++])
            corners[next[face[i]]++] = {f, before, face[(i + 1) % face.size()]};
    }
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        // A normal that the file gives is kept.
        if (!mesh.vertex_normals.empty() && mesh.vertex_normals[v] != vector{0.0, 0.0, 0.0})
            continue;
        const std::span<const corner> around(corners.data() + ends[v], ends[v + 1] - ends[v]);
        // If all faces are within half the crease angle of their mean, any two are within the whole
        // angle.
        const bool is_flat = std::ranges::all_of(around, [&](const corner& c) {
            return l3d_dot(of_faces_[c.face], of_vertices[v]) >= least_of_mean_;
        });
        if (!is_flat)
            divide(v, around);
    }
}

/// Whether the edge between two faces is smooth. It is always smooth beside a face without area,
/// which has no normal that could differ.
bool crease_normals::is_smooth(std::uint32_t face, std::uint32_t other) const {
    const direction &a = of_faces_[face], &b = of_faces_[other];
    return l3d_dot(a, b) >= least_cosine_ || l3d_dot(a, a) == 0 || l3d_dot(b, b) == 0;
}

void crease_normals::divide(std::uint32_t vertex, std::span<const corner> around) {
    ends_.clear();
    groups_.resize(around.size());
    std::iota(groups_.begin(), groups_.end(), 0U);
    for (std::uint32_t i = 0; i < around.size(); ++i) {
        ends_.push_back({around[i].before, i});
        ends_.push_back({around[i].after, i});
    }
    std::ranges::sort(ends_);
    for (std::size_t i = 1; i < ends_.size(); ++i) {
        const end &a = ends_[i - 1], &b = ends_[i];
        if (a.vertex == b.vertex && is_smooth(around[a.corner].face, around[b.corner].face)) {
            const std::uint32_t one = first_of(groups_, a.corner),
                                two = first_of(groups_, b.corner);
            groups_[std::max(one, two)] = std::min(one, two);
        }
    }
    bool is_one = true;
    for (std::uint32_t i = 0; i < around.size(); ++i)
        is_one = first_of(groups_, i) == 0 && is_one;
    if (is_one)
        return;
    // Adds up all groups first, since a group's normal is made of its complete sum.
    sums_.assign(around.size(), vector{0.0, 0.0, 0.0});
    numbers_.assign(around.size(), none);
    for (std::uint32_t i = 0; i < around.size(); ++i)
        sums_[first_of(groups_, i)] += areas_[around[i].face];
    const std::size_t begin = places_.size();
    for (std::uint32_t i = 0; i < around.size(); ++i) {
        const std::uint32_t first = first_of(groups_, i);
        if (numbers_[first] == none) {
            numbers_[first] = static_cast<std::uint32_t>(normals_.size());
            normals_.push_back(l3d_converted<float>(l3d_normalized(sums_[first])));
        }
        places_.push_back({vertex, around[i].face, numbers_[first]});
    }
    // Vertices come in order, but the faces of a vertex do not.
    std::sort(places_.begin() + static_cast<std::ptrdiff_t>(begin), places_.end());
}

std::uint32_t crease_normals::at(std::uint32_t vertex, std::uint32_t face) const {
    const auto found = std::ranges::lower_bound(places_, place{vertex, face, 0});
    return found != places_.end() && found->vertex == vertex && found->face == face ? found->normal
                                                                                    : none;
}

} // namespace l3d_detail
