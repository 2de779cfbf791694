// SPDX-License-Identifier: MIT
// crease_normals: finds the normals of corners where faces meet at a visible edge.
#ifndef L3D_PIPELINE_POLYGONS_CREASE_NORMALS_P_H
#define L3D_PIPELINE_POLYGONS_CREASE_NORMALS_P_H

#include "geom/polygon_mesh.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace l3d_detail {

/// Finds normals for corners of faces at creases. There, one normal at the vertex does not suit all
/// faces around the vertex.
///
/// An edge is smooth if the normals of its two faces are at most the crease angle apart. Around a
/// vertex, faces that smooth edges connect share a normal. It is the mean of the faces' own
/// normals, weighted by area. If smooth edges connect all faces around a vertex, the vertex keeps
/// its one normal.
/// Cost: k log k for a vertex of k faces.
class crease_normals {
public:
    using vector = l3d_polygon_mesh::vector;
    using direction = l3d_vector<float, 3>;

    /// Finds the normals for a mesh. `areas` are the faces' area vectors. `of_faces` and
    /// `of_vertices` are the unit normals of faces and vertices. `crease_angle` is in degrees.
    crease_normals(const l3d_polygon_mesh& mesh, std::span<const vector> areas,
                   std::span<const direction> of_faces, std::span<const direction> of_vertices,
                   double crease_angle);

    /// Whether all corners have the normals of their vertices.
    bool empty() const { return normals_.empty(); }

    /// The normals that differ from those of vertices, as unit vectors.
    std::span<const direction> normals() const { return normals_; }

    /// The index in normals() for a face's corner at a vertex; `none` if the corner has the
    /// vertex's normal.
    std::uint32_t at(std::uint32_t vertex, std::uint32_t face) const;

    static constexpr std::uint32_t none = ~std::uint32_t{0};

private:
    /// A corner of a face: the face, and the face's vertices before and after the corner.
    struct corner {
        std::uint32_t face, before, after;
    };
    /// A face at a vertex, and the index in normals_ of the face's normal at this vertex.
    struct place {
        std::uint32_t vertex, face, normal;
        friend auto operator<=>(const place&, const place&) = default;
    };

    bool is_smooth(std::uint32_t face, std::uint32_t other) const;
    void divide(std::uint32_t vertex, std::span<const corner> around);

    std::span<const vector> areas_;
    std::span<const direction> of_faces_;
    float least_cosine_, least_of_mean_;
    std::vector<direction> normals_;
    /// All corners with normals other than their vertices', sorted for binary search.
    std::vector<place> places_;

    struct end {
        std::uint32_t vertex, corner;
        friend auto operator<=>(const end&, const end&) = default;
    };
    /// The edges around a vertex. Each is stored as the vertex at its other end. The memory is kept
    /// for the next vertex.
    std::vector<end> ends_;
    /// For each corner around a vertex, an earlier corner of the same group, or itself if it is the
    /// group's first one.
    std::vector<std::uint32_t> groups_;
    std::vector<vector> sums_;
    std::vector<std::uint32_t> numbers_;
};

} // namespace l3d_detail

#endif
