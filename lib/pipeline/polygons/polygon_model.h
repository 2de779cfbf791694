// SPDX-License-Identifier: MIT
// l3d_polygon_model: a mesh with what can be known of it before any frame.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_MODEL_H
#define L3D_PIPELINE_POLYGONS_POLYGON_MODEL_H

#include "base/public.h"
#include "geom/polygon_mesh.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// A triangle of a face.
struct L3D_PUBLIC l3d_model_triangle {
    std::array<std::uint32_t, 3> corners{}; ///< vertex indices, in the order of the face's
    std::uint32_t face = 0;
    /// Bit k: the side from corner k to the next is a side of the face, not a diagonal.
    std::uint32_t sides = 0;
};

/// A polygon mesh ready to be drawn: faces as triangles, normals of faces and vertices, its box.
///
/// Faces of more than three corners are cut into triangles by ears, in the plane they are most
/// parallel to; those that cross themselves become some triangles or other.
/// Cost:    memory per triangle 20 bytes and 12 for the face's normal, per vertex 12 for its
/// normal,
///          beside the mesh's own: 66 bytes per face of a closed mesh of triangles.
class L3D_PUBLIC l3d_polygon_model {
public:
    using vector = l3d_vector<double, 3>;
    using direction = l3d_vector<float, 3>;

    l3d_polygon_model() = default;

    /// With `to_origin`, all is moved so that the mean of the vertices is the origin.
    /// Expects: mesh.is_valid(); coordinates of magnitude at most 1e12.
    explicit l3d_polygon_model(l3d_polygon_mesh mesh, bool to_origin = false);

    const l3d_polygon_mesh& mesh() const { return mesh_; }
    std::span<const l3d_model_triangle> triangles() const { return triangles_; }

    /// Unit vectors, counterclockwise corners seen from their tips; zero for a face of no area.
    std::span<const direction> face_normals() const { return face_normals_; }

    /// The mesh's own if it has any, else the mean of the faces around, weighted by area. Unit
    /// vectors; zero where no face is.
    std::span<const direction> vertex_normals() const { return vertex_normals_; }

    const vector& least() const { return least_; }
    const vector& most() const { return most_; }

    /// The middle of the box, and how far the farthest vertex is from it.
    vector centre() const { return (least_ + most_) * 0.5; }
    double radius() const { return radius_; }

    /// Bytes of memory in use, the mesh's own included.
    std::size_t bytes() const;

private:
    void make_triangles();
    void make_normals();

    l3d_polygon_mesh mesh_;
    std::vector<l3d_model_triangle> triangles_;
    std::vector<direction> face_normals_, vertex_normals_;
    vector least_{0.0, 0.0, 0.0}, most_{0.0, 0.0, 0.0};
    double radius_ = 0;
};

#endif
