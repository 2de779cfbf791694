// SPDX-License-Identifier: MIT
// l3d_polygon_model: a mesh, with everything that frames need computed once; made from patches or
// from a file.
#ifndef L3D_PIPELINE_POLYGONS_POLYGON_MODEL_H
#define L3D_PIPELINE_POLYGONS_POLYGON_MODEL_H

#include "base/public.h"
#include "geom/plane.h"
#include "geom/polygon_mesh.h"
#include "raster/textures/texture.h"
#include "scene/patch_model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

/// A triangle of a face.
struct L3D_PUBLIC l3d_model_triangle {
    std::array<std::uint32_t, 3> corners{}; ///< vertex indices, in the order of the face's corners
    std::uint32_t face = 0;                 ///< index of the face that it is part of
    /// Bit k: the side from corner k to the next is a side of the face, not a diagonal.
    std::uint32_t sides = 0;
};

/// Bounds that 32 triangles share, side by side in the list of a model's triangles.
///
/// Each triangle has its face's normal at most `spread` away from `axis`, and its first corner at
/// most `reach` away from `middle`. So one test may show that all are seen from the same side.
struct L3D_PUBLIC l3d_facing_block {
    static constexpr std::size_t triangles = 32; ///< the last block may have fewer

    l3d_vector<double, 3> axis{0.0, 0.0, 0.0};   ///< mean of the normals
    l3d_vector<double, 3> middle{0.0, 0.0, 0.0}; ///< mean of the first corners
    double spread = 0; ///< largest distance of a normal's tip from the axis' tip
    double reach = 0;  ///< largest distance of a corner from the middle
};

/// Faces whose normals differ by more have a crease where they meet. A prism of 12 or more sides is
/// meant as a round body, and looks smooth. Units: degrees.
inline constexpr double l3d_usual_crease_angle = 30;

/// A polygon mesh ready to be drawn: faces as triangles, normals of faces and vertices, its box.
///
/// Clipping ears cuts faces of more than three corners into triangles, in the coordinate plane that
/// they are most parallel to. That takes n log n time for n corners. Faces that cross themselves
/// become arbitrary triangles. A model never changes after it is made. Its copies share its
/// contents.
/// Lives:   the contents live as long as any copy does, such as the one in a pipeline.
/// Cost:    22 bytes for each triangle, 12 for each face's normal and 12 for each vertex's, beside
///          the mesh's own: 68 bytes per face of a closed mesh of triangles. A copy counts a
///          reference. A move is a copy, so no model is ever without contents.
class L3D_PUBLIC l3d_polygon_model {
public:
    /// A place in the model's space.
    using vector = l3d_vector<double, 3>;
    /// A direction in the model's space.
    using direction = l3d_vector<float, 3>;

    /// A model without polygons.
    l3d_polygon_model() : l3d_polygon_model(l3d_polygon_mesh()) {}
    /// Shares the contents.
    l3d_polygon_model(const l3d_polygon_model&) = default;
    /// Shares the contents of the other model, and lets go of its own.
    l3d_polygon_model& operator=(const l3d_polygon_model&) = default;
    ~l3d_polygon_model() = default;

    /// A model of this mesh. With `to_origin`, it is moved so that the mean of the vertices is the
    /// origin. If the mesh has no normals, faces look smooth where they meet if their normals are
    /// at most the crease angle apart. Faces of four corners that cross themselves become two
    /// triangles.
    /// Units:   degrees.
    /// Expects: mesh.is_valid(); coordinates of magnitude at most 1e12; an angle of 0 to 180.
    explicit l3d_polygon_model(l3d_polygon_mesh mesh, bool to_origin = false,
                               double crease_angle = l3d_usual_crease_angle);

    /// Loads the polygons of a file in any format of l3d_read_model. Patches become
    /// l3d_usual_facets by l3d_usual_facets quads each. Notes on skipped lines are left out.
    /// Errors: throws l3d_error(bad_input) with file, line and reason, also for a file that holds
    ///         neither polygons nor patches.
    static l3d_polygon_model load(const std::string& file);

    /// The given polygons. Faces of four corners that crossed themselves are two triangles, and all
    /// vertices are moved if `to_origin` asked for it.
    const l3d_polygon_mesh& mesh() const { return contents_->mesh; }
    /// The triangles of all faces that are shown, face after face.
    std::span<const l3d_model_triangle> triangles() const { return contents_->triangles; }

    /// Triangle i is in block i / l3d_facing_block::triangles.
    std::span<const l3d_facing_block> facing_blocks() const { return contents_->facing_blocks; }

    /// The unit normals of faces; zero for a face of no area. Seen from a normal's tip, the face's
    /// corners run counterclockwise.
    std::span<const direction> face_normals() const { return contents_->face_normals; }

    /// The unit normals of vertices. If the mesh has normals, they are these, turned to the side
    /// that most faces' normals point to. Else each is the mean of the faces around, weighted by
    /// area. A vertex without a face has 0. At creases, corner_normal() has others.
    std::span<const direction> vertex_normals() const { return contents_->vertex_normals; }

    /// The normal that a triangle is lit with at a corner. It is the vertex's, another one if the
    /// vertex is on a crease, or the opposite one where the mesh folds over.
    /// Expects: triangle < triangles().size(), corner < 3.
    const direction& corner_normal(std::size_t triangle, std::size_t corner) const {
        const std::uint32_t of = contents_->crease_corners.empty()
                                     ? no_crease
                                     : contents_->crease_corners[triangle][corner];
        return of == no_crease ? vertex_normals()[triangles()[triangle].corners[corner]]
                               : contents_->crease_normals[of];
    }

    /// Whether a vertex has more than one normal somewhere.
    bool has_creases() const { return !contents_->crease_corners.empty(); }

    /// The named parts of the faces.
    const l3d_parts& parts() const { return contents_->parts; }

    /// A model in which the faces of one part have another material.
    /// Expects: an index of parts().names().
    l3d_polygon_model part_painted(std::size_t part, const l3d_material& material) const;

    /// A model that shows some parts alone; faces without a part are left out. It keeps its mesh,
    /// and turns about the same centre; triangles() has only the shown ones.
    /// Expects: indices of parts().names().
    l3d_polygon_model only(std::span<const std::size_t> parts) const;

    /// A model that shows all but some parts. Expects: as only().
    l3d_polygon_model without(std::span<const std::size_t> parts) const;

    /// A model of the shown faces in front of a plane. Faces that the plane passes through are cut,
    /// so a body is open there. Pictures are left out. Normals are made anew with the usual crease
    /// angle, unless the mesh has its own. The model keeps its box, and turns about the same
    /// centre.
    /// Cost: as the constructor.
    l3d_polygon_model cut(const l3d_plane<double>& plane) const;

    /// The faces' materials (l3d_polygon_mesh::look_of), each once; none if all are plain and no
    /// vertex has a colour.
    std::span<const l3d_material> materials() const { return contents_->materials; }
    /// The index of a face's material in materials(); 0 if there are none.
    /// Expects: face < mesh().faces().
    std::uint32_t material_of(std::size_t face) const {
        return contents_->materials_of_faces.empty() ? 0 : contents_->materials_of_faces[face];
    }

    /// A model of the same faces, with pictures on all faces whose materials name one. `textures`
    /// has a texture for each of mesh().pictures. Where it is null or missing, faces have the
    /// colours of their materials.
    l3d_polygon_model textured(std::vector<std::shared_ptr<const l3d_texture>> textures) const;
    /// The pictures given to textured().
    std::span<const std::shared_ptr<const l3d_texture>> textures() const {
        return contents_->textures;
    }

    /// For each triangle, the colours or the picture that is blended over it. It is empty if no
    /// vertex has a colour and no material a texture.
    std::span<const l3d_painted_triangle> painted() const { return contents_->painted; }

    /// The corner of the model's box with the smallest x, y and z.
    const vector& least() const { return contents_->least; }
    /// The corner of the model's box with the largest x, y and z.
    const vector& most() const { return contents_->most; }

    /// The middle of the box.
    vector centre() const { return contents_->centre(); }
    /// The distance from centre() to the farthest vertex.
    double radius() const { return contents_->radius; }

    /// Bytes of memory in use, the mesh's own included.
    std::size_t bytes() const;

private:
    static constexpr std::uint32_t no_crease = ~std::uint32_t{0};

    struct contents {
        contents(l3d_polygon_mesh of, bool to_origin, double crease_angle);

        vector centre() const { return (least + most) * 0.5; }
        void measure();
        void make_triangles();
        void make_normals(double crease_angle);
        bool has_own_normal(std::size_t vertex) const;
        void set_crease(std::size_t triangle, std::size_t corner, std::uint32_t normal);
        void find_creases(std::span<const vector> areas, double crease_angle);
        void make_facing_blocks();
        void turn_normals_to_faces();
        void make_materials(std::span<const l3d_material> looks);
        void keep_triangles(const std::vector<bool>& of_faces);
        void make_painted();
        l3d_painted_triangle painted_triangle(const l3d_model_triangle& triangle) const;

        l3d_polygon_mesh mesh;
        l3d_parts parts;
        std::vector<l3d_model_triangle> triangles;
        std::vector<l3d_facing_block> facing_blocks;
        std::vector<direction> face_normals, vertex_normals;
        std::vector<direction> crease_normals;
        /// For each triangle's corners, places in crease_normals, or no_crease. Empty if there are
        /// none.
        std::vector<std::array<std::uint32_t, 3>> crease_corners;
        std::vector<l3d_material> materials;
        std::vector<std::uint32_t> materials_of_faces; ///< for each face, an index in materials
        std::vector<std::shared_ptr<const l3d_texture>> textures;
        std::vector<l3d_painted_triangle> painted;
        std::vector<bool> repainted; ///< faces whose vertices' colours do not count; or empty
        vector least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
        double radius = 0;
    };

    l3d_polygon_model shown(const std::vector<bool>& faces) const;

    std::shared_ptr<const contents> contents_;
};

/// The most pixels of a texture: as many as 8192 by 8192 have. With its smaller pictures it takes
/// 0.7 GB.
inline constexpr std::int64_t l3d_most_texture_pixels = std::int64_t{1} << 26;

/// Reads the textures of a mesh, for l3d_polygon_model::textured: one for each of its pictures. A
/// picture that no face shows is null, and so is one that cannot be read or is too large. For each
/// of the latter, `notes` get a line with file and reason. So no picture keeps a model from being
/// shown.
///
///     std::vector<std::string> notes;
///     const l3d_polygon_model plain(mesh);
///     const l3d_polygon_model model = plain.textured(l3d_read_textures(mesh, notes));
L3D_PUBLIC std::vector<std::shared_ptr<const l3d_texture>>
l3d_read_textures(const l3d_polygon_mesh& mesh, std::vector<std::string>& notes);

/// The texture of an image file, PNG or JPEG, that repeats. If it cannot be read or is too large,
/// it is null, and `notes` get a line with file and reason.
L3D_PUBLIC std::shared_ptr<const l3d_texture> l3d_read_texture(const std::string& file,
                                                               std::vector<std::string>& notes);

struct l3d_model_file;

/// The largest n that programs give to l3d_tessellated. It makes 2 n^2 triangles of each patch, two
/// million for the teapot.
inline constexpr int l3d_most_facets = 192;

/// The n that programs usually give to l3d_tessellated, to draw models as polygons.
inline constexpr int l3d_usual_facets = 8;

/// Patches as triangles.
struct L3D_PUBLIC l3d_patch_mesh {
    l3d_polygon_mesh mesh;              ///< the triangles of all patches
    std::vector<std::size_t> face_ends; ///< patch by patch, the number of faces up to its last
};

/// Turns each patch into n by n quads of two triangles, counterclockwise as seen from the side to
/// which dS/du x dS/dv points. Their vertices have the patch's normals, and the triangles its
/// material and its part.
///
/// Patches with a common boundary have the same points on it, since these depend on the boundary's
/// control points alone, in either direction. Two such points are one vertex, unless their normals
/// differ, as at a crease. Triangles whose corners coincide, as at the teapot's knob, are left out.
/// Expects: n >= 1.
/// Errors:  throws l3d_error(bad_input) for trimmed surfaces.
L3D_PUBLIC l3d_patch_mesh l3d_tessellated(const l3d_patch_model& model, int n);

/// The polygons of a file that was read, and its patches as n by n quads each.
/// Errors:  throws l3d_error(bad_input) for a file that holds neither polygons nor patches, and for
///          patches that are not bicubic.
/// Expects: n >= 1.
L3D_PUBLIC l3d_polygon_mesh l3d_mesh_of(const l3d_model_file& file, const std::string& name, int n);

#endif
