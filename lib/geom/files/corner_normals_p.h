// SPDX-License-Identifier: MIT
// corner_normals: normals that a file gives to corners, or defines by smoothing groups.
#ifndef L3D_GEOM_FILES_CORNER_NORMALS_P_H
#define L3D_GEOM_FILES_CORNER_NORMALS_P_H

#include "geom/polygon_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace l3d_detail {

/// Makes normals of vertices from a file's data on corners and faces.
///
/// A mesh has one normal for each vertex. If the corners of a vertex have several normals, the
/// vertex becomes several vertices at one place. The first keeps its index, and the others come
/// behind the mesh's last vertex.
///
/// A corner has the normal that it names. Without a named normal, the smoothing groups of its face
/// decide. The normal is then the mean, weighted by area, of those faces around the vertex that
/// share a group with this face. A face in no group is flat. A face without an entry in the file
/// gets zero normals, so that creases are found by angles.
/// Cost:    linear, except for vertices at which faces of many groups meet. Such a vertex costs the
///          product of the numbers of its faces and groups.
class corner_normals {
public:
    using vector = l3d_polygon_mesh::vector;

    /// Adds a normal. Normals are numbered in the order of calls, from 0.
    void add(const vector& normal) { normals_.push_back(normal); }
    /// The number of normals so far.
    std::size_t count() const { return normals_.size(); }

    /// Gives the mesh's last corner the normal of this index. Returns false, and gives no normal,
    /// if the normal has no direction.
    bool give_to_last_corner(const l3d_polygon_mesh& mesh, std::uint32_t normal);

    /// Puts the last face of the mesh into smoothing groups: bit i of the lower 32 bits stands for
    /// group i + 1. `numbered` plus a number stands for the single group of this number instead.
    void give_to_last_face(const l3d_polygon_mesh& mesh, std::uint64_t groups);
    static constexpr std::uint64_t numbered = std::uint64_t{1} << 63;

    /// Whether any corner has a normal, or any face has groups.
    bool any() const { return !of_corners_.empty() || !of_faces_.empty(); }

    /// Gives the mesh its normals, once the whole file is read. Vertex i gets normal i if it has no
    /// face, unless the mesh has faces and no face names a normal or group.
    /// Errors: as l3d_polygon_mesh::index_of.
    void finish(l3d_polygon_mesh& mesh);

private:
    static constexpr std::uint32_t none = ~std::uint32_t{0};
    /// The entry of a face whose groups the file does not give.
    static constexpr std::uint64_t unsaid = ~std::uint64_t{0};

    // Values of said_by(): the index of a normal, less than `none`; groups as bits, with `grouped`;
    // the number of a group, with `numbered`; `unsaid`; or `flat`. `free` marks a vertex without a
    // corner.
    static constexpr std::uint64_t grouped = numbered >> 1, free = unsaid - 1, flat = unsaid - 2;

    struct faces_around;
    std::uint64_t said_by(std::size_t corner, std::size_t face) const;
    void divide_vertices(l3d_polygon_mesh& mesh) const;

    std::vector<vector> normals_;
    /// Per corner, its normal's index or `none`. Corners beyond the array's end have `none`.
    std::vector<std::uint32_t> of_corners_;
    std::vector<std::uint64_t> of_faces_; ///< per face, its groups; `unsaid` beyond the array's end
};

} // namespace l3d_detail

#endif
