// SPDX-License-Identifier: MIT
// l3d_cut_mesh: clips each face, computes each cut edge once, and closes loops of cut edges by
// caps.
#include "geom/polygon_mesh.h"

#include "geom/polygon_3d.h"

#include "geom/color_between_p.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace {

using index = std::uint32_t;
using edge = std::pair<index, index>;
using point = l3d_point<double>;

constexpr index nowhere = 0xffffffff;

/// Cuts one mesh. Before compact(), indices are those of the given mesh, and new vertices follow
/// the mesh's own vertices.
class cutter {
public:
    cutter(const l3d_polygon_mesh& mesh, const l3d_plane<double>& plane)
        : mesh_(mesh), plane_(plane) {
        for (const auto& v : mesh.vertices) {
            points_.push_back(point(v));
            sides_.push_back(plane.side_of_point(points_.back()));
        }
        kept_.materials = mesh.materials;
    }

    l3d_polygon_mesh run(l3d_cut_end end) {
        std::size_t part = 0;
        for (std::size_t i = 0; i < mesh_.faces(); ++i) {
            for (; part < mesh_.parts.size() && mesh_.parts[part].first == i; ++part)
                kept_.parts.push_back({mesh_.parts[part].name, static_cast<index>(kept_.faces())});
            cut_face(i);
        }
        if (end == l3d_cut_end::capped)
            close_loops();
        compact();
        return std::move(kept_);
    }

private:
    bool on_plane(index i) const { return std::abs(sides_[i]) <= l3d_plane_thickness; }

    void cut_face(std::size_t i) {
        const auto side = [this](index v) { return sides_[v]; };
        const auto cut = [this](index front, index behind) { return crossing(front, behind); };
        if (!l3d_clip_to_plane(mesh_.face(i), l3d_plane_thickness, side, cut, corners_)) {
            if (!bounds_front(i))
                return;
            corners_.assign(mesh_.face(i).begin(), mesh_.face(i).end());
        }
        add(corners_, i);
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            const index from = corners_[k], to = corners_[(k + 1) % corners_.size()];
            if (on_plane(from) && on_plane(to))
                add_rim(from, to, i);
        }
    }

    /// Whether a face on the plane bounds the part in front: the face's normal then points behind
    /// the plane, out of that part.
    bool bounds_front(std::size_t i) const {
        const auto face = mesh_.face(i);
        if (!std::all_of(face.begin(), face.end(), [this](index v) { return on_plane(v); }))
            return false;
        const auto own = l3d_polygon_3d<double>{points_, face}.plane();
        return own && l3d_dot(own->normal, plane_.normal) < 0;
    }

    /// The new vertex where an edge crosses the plane. Faces that share the edge share the vertex.
    index crossing(index front, index behind) {
        const auto [found, is_new] =
            crossings_.try_emplace({front, behind}, static_cast<index>(points_.size()));
        if (is_new) {
            const double f = sides_[front], b = sides_[behind];
            points_.push_back(l3d_between(points_[front], points_[behind], f, b));
            sides_.push_back(0);
            if (!mesh_.vertex_normals.empty()) {
                const auto& n = mesh_.vertex_normals;
                normals_.push_back(n[front] + (n[behind] - n[front]) * (f / (f - b)));
            }
            if (!mesh_.vertex_colors.empty())
                colors_.push_back(l3d_detail::color_between(
                    mesh_.vertex_colors[front], mesh_.vertex_colors[behind], f / (f - b)));
        }
        return found->second;
    }

    void add(std::span<const index> corners, std::size_t like) {
        kept_.add_face(corners);
        if (!mesh_.face_colors.empty())
            kept_.face_colors.push_back(mesh_.face_colors[like]);
        if (!mesh_.face_materials.empty())
            kept_.face_materials.push_back(mesh_.face_materials[like]);
    }

    /// Adds an edge on the plane, along which a cap meets the face. Two faces that meet on the
    /// plane need no cap, so their edges cancel.
    void add_rim(index from, index to, std::size_t face) {
        if (rim_.erase({from, to}) == 0)
            rim_.insert({{to, from}, face});
    }

    void close_loops() {
        while (!rim_.empty()) {
            const auto [first, face] = *rim_.begin();
            std::vector<index> loop;
            index at = first.first;
            for (auto next = rim_.begin(); next != rim_.end() && next->first.first == at;
                 next = rim_.lower_bound({at, 0})) {
                loop.push_back(at);
                at = next->first.second;
                rim_.erase(next);
            }
            if (loop.size() >= 3 && at == loop.front())
                add(loop, face);
        }
    }

    /// Leaves out vertices that no face uses, and renumbers the corners.
    void compact() {
        std::vector<index> places(points_.size(), nowhere);
        for (const index corner : kept_.corners)
            places[corner] = 0;
        for (index i = 0; i < places.size(); ++i) {
            if (places[i] == nowhere)
                continue;
            places[i] = static_cast<index>(kept_.vertices.size());
            kept_.vertices.push_back(points_[i].from_origin);
            const std::size_t old = mesh_.vertices.size();
            if (!mesh_.vertex_normals.empty())
                kept_.vertex_normals.push_back(i < old ? mesh_.vertex_normals[i]
                                                       : normals_[i - old]);
            if (!mesh_.vertex_colors.empty())
                kept_.vertex_colors.push_back(i < old ? mesh_.vertex_colors[i] : colors_[i - old]);
        }
        for (index& corner : kept_.corners)
            corner = places[corner];
    }

    const l3d_polygon_mesh& mesh_;
    const l3d_plane<double>& plane_;
    l3d_polygon_mesh kept_;
    std::vector<point> points_;
    std::vector<double> sides_;
    std::vector<l3d_polygon_mesh::vector> normals_; ///< normals of new vertices
    std::vector<std::uint32_t> colors_;             ///< colours of new vertices
    std::vector<index> corners_;
    std::map<edge, index> crossings_; ///< by the ends of the cut edge, the end in front first
    std::map<edge, std::size_t> rim_; ///< edges of caps, each with the face beside it
};

} // namespace

l3d_polygon_mesh l3d_cut_mesh(const l3d_polygon_mesh& mesh, const l3d_plane<double>& plane,
                              l3d_cut_end end) {
    return cutter(mesh, plane).run(end);
}

void l3d_turn_left_handed(l3d_polygon_mesh& mesh, l3d_model_up up) {
    for (auto* vectors : {&mesh.vertices, &mesh.vertex_normals})
        for (auto& v : *vectors)
            if (up == l3d_model_up::z)
                std::swap(v[1], v[2]);
            else
                v[2] = -v[2];
    index begin = 0;
    for (const index end : mesh.face_ends) {
        std::reverse(mesh.corners.begin() + begin, mesh.corners.begin() + end);
        if (!mesh.picture_places.empty())
            std::reverse(mesh.picture_places.begin() + begin, mesh.picture_places.begin() + end);
        begin = end;
    }
}

double l3d_area(const l3d_polygon_mesh& mesh) {
    std::vector<point> points;
    for (const auto& v : mesh.vertices)
        points.push_back(point(v));
    double sum = 0;
    for (std::size_t i = 0; i < mesh.faces(); ++i)
        sum += l3d_polygon_3d<double>{points, mesh.face(i)}.area();
    return sum;
}
