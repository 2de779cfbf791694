// SPDX-License-Identifier: MIT
// l3d_polygon_mesh: vertices and faces, as files of polygons hold them; cutting them by a plane.
#ifndef L3D_GEOM_POLYGON_MESH_H
#define L3D_GEOM_POLYGON_MESH_H

#include "base/color.h"
#include "base/public.h"
#include "geom/material.h"
#include "geom/parts.h"
#include "geom/plane.h"
#include "geom/vector.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

/// A picture that a material names, to be laid on faces.
struct L3D_PUBLIC l3d_mesh_picture {
    std::string name;    ///< the file's path, or the picture's place in the model's file
    std::string bytes{}; ///< contents, if the picture lies in the model's file
    /// Whether the picture repeats beyond 0 to 1 in u; else its border is continued.
    bool repeats_u = true;
    bool repeats_v = true;  ///< whether the picture repeats beyond 0 to 1 in v
    bool mirrors_u = false; ///< whether every second repetition in u is mirrored
    bool mirrors_v = false; ///< whether every second repetition in v is mirrored

    friend bool operator==(const l3d_mesh_picture&, const l3d_mesh_picture&) = default;
};

/// A mesh of polygons: vertices, and faces that name them by index, with colours, materials and
/// parts.
///
/// The arrays are flat, since a million vectors of three indices would cost more for their headers
/// and allocations than for their contents.
/// Shape:   the normal of a face, (p1 - p0) x (p2 - p0), points outwards in both kinds of axes. So
///          its corners, seen from outside, run counterclockwise in right-handed axes and clockwise
///          in left-handed ones. l3d_turn_left_handed changes right-handed axes to left-handed
///          ones. Optional arrays are empty or have the stated size.
/// Cost:    a face of n corners takes 4 n + 4 bytes, 4 more for a colour and 4 for a material; a
///          vertex takes 24. A closed mesh of triangles has half as many vertices as faces: 28
///          bytes per face.
struct L3D_PUBLIC l3d_polygon_mesh {
    /// A place, or the direction of a normal.
    using vector = l3d_vector<double, 3>;

    /// A place in a picture: u to the right and v down, (0, 0) its top left corner and (1, 1) the
    /// bottom right one.
    using picture_place = std::array<float, 2>;

    std::vector<vector> vertices;       ///< places in the model's own coordinates
    std::vector<std::uint32_t> corners; ///< vertex indices, face after face
    /// Per face, the index behind its last corner in `corners`.
    std::vector<std::uint32_t> face_ends;

    /// Normals: optional, one per vertex, of any length. A normal of zero stands for one that is
    /// computed from the faces around the vertex.
    std::vector<vector> vertex_normals;
    /// Colours of vertices: optional, one per vertex, 0x00RRGGBB. Their light is blended over
    /// faces.
    std::vector<l3d_color> vertex_colors;
    /// Optional, one per corner: the place in the picture of the face's material that the corner
    /// shows.
    std::vector<picture_place> picture_places;
    std::vector<l3d_mesh_picture> pictures;    ///< pictures that l3d_material::picture names
    std::vector<l3d_color> face_colors;        ///< optional, one per face, 0x00RRGGBB
    std::vector<std::uint32_t> face_materials; ///< optional, one per face, index into `materials`
    std::vector<std::string> materials;        ///< names of the materials
    std::vector<l3d_material> looks;           ///< optional: the look of each entry of `materials`
    /// Named runs of faces: optional, in the order of their first faces.
    std::vector<l3d_part_run> parts;

    /// The number of faces.
    std::size_t faces() const { return face_ends.size(); }

    /// The vertex indices of a face. Expects: face < faces().
    std::span<const std::uint32_t> face(std::size_t face) const {
        assert(face < faces());
        const std::size_t begin = face == 0 ? 0 : face_ends[face - 1];
        return {corners.data() + begin, face_ends[face] - begin};
    }

    /// Adds a face with these vertex indices at its corners; its colour and material are not set.
    /// Errors: as end_face.
    void add_face(std::span<const std::uint32_t> of) {
        corners.insert(corners.end(), of.begin(), of.end());
        end_face();
    }

    /// Makes a face of the corners that were added to `corners` since the last face.
    /// Errors: as index_of.
    void end_face() { face_ends.push_back(index_of(corners.size())); }

    /// Returns a number of corners or vertices in the 32 bits in which the arrays hold it.
    /// Errors: std::length_error if it is larger.
    static std::uint32_t index_of(std::size_t number);

    /// Twice the area of a face, times its unit normal. Any corner may be concave. Places are taken
    /// relative to the first corner, since far from the origin the products would cancel.
    /// Expects: three corners or more.
    /// Source: Newell's sum over the sides.
    vector area_vector(std::span<const std::uint32_t> face) const;

    /// Splits each face of four corners into two triangles if two of its sides cross, as in a bow
    /// tie. The triangles meet in a new vertex at the crossing, and face the same way as each
    /// other.
    /// Errors: as index_of.
    void uncross_faces();

    /// Adds the vertices and faces of another mesh. If only one mesh has vertex normals, those of
    /// the other are zero. Faces keep their colours, materials and parts. Where only some faces
    /// have a colour or material, others get white or a material without a name.
    /// Errors: as index_of; the mesh is then unchanged.
    void append(const l3d_polygon_mesh& more);

    /// The look of a face: that of its material, or a plain one. Its colour is multiplied by the
    /// face's colour, if there is one.
    /// Expects: face < faces().
    l3d_material look_of(std::size_t face) const;

    /// Whether every index names something, every face has three corners or more, and every
    /// optional array has its size. Coordinates and places in pictures must be finite.
    bool is_valid() const;

    /// Bytes of memory in use by the arrays, names left out.
    std::size_t bytes() const;

    friend bool operator==(const l3d_polygon_mesh&, const l3d_polygon_mesh&) = default;

private:
    void append_parts(const l3d_polygon_mesh& more);
    void append_materials(const l3d_polygon_mesh& more);
};

/// The treatment of the hole where a mesh was cut.
enum class L3D_PUBLIC l3d_cut_end {
    open,   ///< the cut is left as it is: one can look in
    capped, ///< a face closes each loop of cut edges
};

/// Returns the part of a mesh in front of a plane, as a new mesh.
///
/// Faces that meet at a cut edge share the new vertex on this edge. Vertices that no face uses are
/// left out. Faces keep their colour, material and named part; looks and pictures are dropped. A
/// cap takes colour and material from one of the cut faces around it. The function returns the
/// other half of the mesh for plane.flipped().
/// Shape:   vertices and faces keep their order; new vertices follow. Caps come last, in the last
///          run of parts.
/// Expects: mesh.is_valid(); convex faces. Caps are right for a closed mesh whose cut has no loop
///          inside another.
/// Cost:    memory for one entry per cut edge.
L3D_PUBLIC l3d_polygon_mesh l3d_cut_mesh(const l3d_polygon_mesh& mesh,
                                         const l3d_plane<double>& plane,
                                         l3d_cut_end end = l3d_cut_end::open);

/// The direction that is upwards in a model.
enum class L3D_PUBLIC l3d_model_up {
    y, ///< as in most files
    z, ///< as in 3D Studio's and Videoscape's
};

/// Turns a mesh from right-handed axes into left-handed ones with y up, so that it is not mirrored.
/// y and z change places; if y is up already, z is negated instead. The corners of each face are
/// reversed, so that its outside stays the outside.
L3D_PUBLIC void l3d_turn_left_handed(l3d_polygon_mesh& mesh, l3d_model_up up = l3d_model_up::z);

/// The sum of the areas of all faces. Expects: mesh.is_valid(). Units: world units squared.
L3D_PUBLIC double l3d_area(const l3d_polygon_mesh& mesh);

#endif
