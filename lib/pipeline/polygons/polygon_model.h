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

/// A triangle of a face of a model. Faces with more than three corners are cut into triangles.
struct L3D_PUBLIC l3d_model_triangle {
    std::array<std::uint32_t, 3> corners{}; ///< vertex indices, in the order of the face's corners
    std::uint32_t face = 0;                 ///< index of the face that the triangle is part of
    /// Bit k is set if the side from corner k to the next corner is a side of the face, not a
    /// diagonal.
    std::uint32_t sides = 0;
};

/// Bounds of the normals and places of 32 triangles in a row of a model's list of triangles.
///
/// The normal of each triangle's face is at most `spread` away from `axis`, and each triangle's
/// first corner is at most `reach` away from `middle`. So one test may show that the eye sees all
/// 32 triangles from the same side.
struct L3D_PUBLIC l3d_facing_block {
    /// Triangles in a block; the last block may have fewer.
    static constexpr std::size_t triangles = 32;

    l3d_vector<double, 3> axis{0.0, 0.0, 0.0};   ///< mean of the triangles' normals
    l3d_vector<double, 3> middle{0.0, 0.0, 0.0}; ///< mean of the triangles' first corners
    double spread = 0; ///< largest length of the difference of a normal from `axis`
    double reach = 0;  ///< largest distance of a first corner from `middle`
};

/// The usual crease angle. Two faces whose normals differ by more have a crease where they meet.
/// With this angle, a prism of 12 or more sides looks like a round body. Units: degrees.
inline constexpr double l3d_usual_crease_angle = 30;

/// A polygon mesh with all that drawing needs, computed once: faces as triangles, normals of faces
/// and vertices, and the box around the mesh.
///
/// Faces of more than three corners are cut into triangles by clipping ears, in the coordinate
/// plane that the face is most parallel to. This takes n log n time for n corners. Faces that cross
/// themselves become arbitrary triangles. A model never changes after it is made. Copies of a model
/// share its contents.
/// Lives:   the contents live as long as any copy of the model, such as the one in a pipeline.
/// Cost:    22 bytes for each triangle, and 12 for each normal of a face or vertex, beside the
///          mesh. A closed mesh of triangles takes 68 bytes per face, model and mesh together. A
///          copy only counts a reference. A move is a copy, so no model is ever without contents.
class L3D_PUBLIC l3d_polygon_model {
public:
    /// A place in the model's space.
    using vector = l3d_vector<double, 3>;
    /// A direction in the model's space.
    using direction = l3d_vector<float, 3>;

    /// A model without polygons.
    l3d_polygon_model() : l3d_polygon_model(l3d_polygon_mesh()) {}
    /// Makes a copy that shares the contents.
    l3d_polygon_model(const l3d_polygon_model&) = default;
    /// Takes part in the contents of another model, and drops this model's own contents.
    l3d_polygon_model& operator=(const l3d_polygon_model&) = default;
    ~l3d_polygon_model() = default;

    /// Makes a model of this mesh. With `to_origin`, the mesh is moved so that the mean of its
    /// vertices is the origin. If the mesh has no normals, faces look smooth where they meet if
    /// their normals are at most the crease angle apart. Faces of four corners that cross
    /// themselves become two triangles.
    /// Units:   `crease_angle`: degrees.
    /// Expects: mesh.is_valid(); coordinates of magnitude at most 1e12; an angle of 0 to 180.
    explicit l3d_polygon_model(l3d_polygon_mesh mesh, bool to_origin = false,
                               double crease_angle = l3d_usual_crease_angle);

    /// Loads the polygons of a file in any format of l3d_read_model. Patches become
    /// l3d_usual_facets by l3d_usual_facets quads each. Notes on skipped lines are left out.
    /// Errors: throws l3d_error(bad_input) with file, line and reason, also for a file that holds
    ///         neither polygons nor patches.
    static l3d_polygon_model load(const std::string& file);

    /// The mesh that the model was made of, with two changes. Faces of four corners that crossed
    /// themselves are two triangles, and all vertices are moved if `to_origin` was true.
    const l3d_polygon_mesh& mesh() const { return contents_->mesh; }
    /// The triangles of all faces that the model shows (only(), without()), face after face.
    std::span<const l3d_model_triangle> triangles() const { return contents_->triangles; }

    /// The bounds of the triangles' normals, for culling. Triangle i is in block i /
    /// l3d_facing_block::triangles.
    std::span<const l3d_facing_block> facing_blocks() const { return contents_->facing_blocks; }

    /// The unit normal of each face; zero for a face without area. A face's corners run
    /// counterclockwise as seen from the side that its normal points to.
    std::span<const direction> face_normals() const { return contents_->face_normals; }

    /// The unit normal of each vertex. A normal that the mesh gives is kept, but all these normals
    /// are reversed if most of them point away from their faces' fronts. If the mesh gives no
    /// normal for a vertex, the vertex's normal is the mean of the normals of the faces around it,
    /// weighted by area. A vertex without a face has the normal 0. At creases, corner_normal() has
    /// other normals.
    std::span<const direction> vertex_normals() const { return contents_->vertex_normals; }

    /// The normal that a triangle is lit with at a corner. It is the vertex's normal. At a crease
    /// it may be another normal, and where the mesh folds over, the opposite of the vertex's
    /// normal.
    /// Expects: triangle < triangles().size(), corner < 3.
    const direction& corner_normal(std::size_t triangle, std::size_t corner) const {
        const std::uint32_t of = contents_->crease_corners.empty()
                                     ? no_crease
                                     : contents_->crease_corners[triangle][corner];
        return of == no_crease ? vertex_normals()[triangles()[triangle].corners[corner]]
                               : contents_->crease_normals[of];
    }

    /// Whether any vertex has different normals in different triangles.
    bool has_creases() const { return !contents_->crease_corners.empty(); }

    /// The named parts that the faces belong to.
    const l3d_parts& parts() const { return contents_->parts; }

    /// Makes a model in which the faces of one part have another material.
    /// Expects: an index of parts().names().
    l3d_polygon_model part_painted(std::size_t part, const l3d_material& material) const;

    /// Makes a model that shows these parts alone; faces without a part are left out. The new model
    /// has the same mesh and centre(), but its triangles() are only those of the parts.
    /// Expects: indices of parts().names().
    l3d_polygon_model only(std::span<const std::size_t> parts) const;

    /// Makes a model that shows all faces but those of these parts. Expects: as only().
    l3d_polygon_model without(std::span<const std::size_t> parts) const;

    /// Makes a model of the shown faces in front of a plane. Faces that cross the plane are cut at
    /// the plane, and bodies stay open. Pictures are left out. Normals are made anew with the usual
    /// crease angle, unless the mesh has its own. The new model keeps the box and centre() of this
    /// model.
    /// Cost: as the constructor.
    l3d_polygon_model cut(const l3d_plane<double>& plane) const;

    /// The faces' materials (l3d_polygon_mesh::look_of), each once. Empty if all faces are plain
    /// and no vertex has a colour.
    std::span<const l3d_material> materials() const { return contents_->materials; }
    /// The index in materials() of a face's material; 0 if materials() is empty.
    /// Expects: face < mesh().faces().
    std::uint32_t material_of(std::size_t face) const {
        return contents_->materials_of_faces.empty() ? 0 : contents_->materials_of_faces[face];
    }

    /// Makes a model of the same faces, with pictures on all faces whose materials name a picture.
    /// `textures` has a texture for each of mesh().pictures. If a texture is null or missing, its
    /// faces have the colours of their materials.
    l3d_polygon_model textured(std::vector<std::shared_ptr<const l3d_texture>> textures) const;
    /// The textures that were given to textured().
    std::span<const std::shared_ptr<const l3d_texture>> textures() const {
        return contents_->textures;
    }

    /// For each triangle, the colours of its corners, or the picture that is blended over the
    /// triangle. The list is empty if no vertex has a colour and no material has a texture.
    std::span<const l3d_painted_triangle> painted() const { return contents_->painted; }

    /// The corner of the model's box with the smallest x, y and z.
    const vector& least() const { return contents_->least; }
    /// The corner of the model's box with the largest x, y and z.
    const vector& most() const { return contents_->most; }

    /// The middle of the model's box.
    vector centre() const { return contents_->centre(); }
    /// The distance from centre() to the farthest vertex.
    double radius() const { return contents_->radius; }

    /// Bytes of memory in use, with those of the mesh.
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
        /// For each triangle's corners, indices in crease_normals, or no_crease. Empty if no corner
        /// has a normal of its own.
        std::vector<std::array<std::uint32_t, 3>> crease_corners;
        std::vector<l3d_material> materials;
        std::vector<std::uint32_t> materials_of_faces; ///< for each face, an index in materials
        std::vector<std::shared_ptr<const l3d_texture>> textures;
        std::vector<l3d_painted_triangle> painted;
        /// For each face, whether the colours of its vertices are ignored (part_painted). Empty if
        /// no face ignores colours.
        std::vector<bool> repainted;
        vector least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
        double radius = 0;
    };

    l3d_polygon_model shown(const std::vector<bool>& faces) const;

    std::shared_ptr<const contents> contents_;
};

/// The most pixels of a texture: 8192 by 8192 pixels, or as many in another shape. Such a texture
/// takes 0.7 GB.
inline constexpr std::int64_t l3d_most_texture_pixels = std::int64_t{1} << 26;

/// Reads the textures of a mesh, for l3d_polygon_model::textured: one for each of the mesh's
/// pictures. The texture is null for a picture that no face shows, that cannot be read, or that is
/// too large. For each picture that cannot be read or is too large, `notes` get a line with file
/// and reason. So a bad picture does not keep a model from being shown.
///
///     std::vector<std::string> notes;
///     const l3d_polygon_model plain(mesh);
///     const l3d_polygon_model model = plain.textured(l3d_read_textures(mesh, notes));
L3D_PUBLIC std::vector<std::shared_ptr<const l3d_texture>>
l3d_read_textures(const l3d_polygon_mesh& mesh, std::vector<std::string>& notes);

/// Reads a texture that repeats from an image file, PNG or JPEG. If the file cannot be read or is
/// too large, the result is null, and `notes` get a line with file and reason.
L3D_PUBLIC std::shared_ptr<const l3d_texture> l3d_read_texture(const std::string& file,
                                                               std::vector<std::string>& notes);

struct l3d_model_file;

/// The largest n that programs give to l3d_tessellated. A patch becomes 2 n^2 triangles then, and
/// the teapot two million.
inline constexpr int l3d_most_facets = 192;

/// The n that programs usually give to l3d_tessellated, to draw models as polygons.
inline constexpr int l3d_usual_facets = 8;

/// Patches as triangles, as l3d_tessellated makes them.
struct L3D_PUBLIC l3d_patch_mesh {
    l3d_polygon_mesh mesh; ///< the triangles of all patches
    /// For each patch, the number of faces of this patch and of all patches before it.
    std::vector<std::size_t> face_ends;
};

/// Turns each patch into n by n quads of two triangles. Triangles are counterclockwise as seen from
/// the side to which dS/du x dS/dv points. The vertices have the patch's normals, and the triangles
/// have the patch's material and part.
///
/// Patches with a common boundary have the same points on the boundary, since these points depend
/// on the boundary's control points alone, in either direction. Points of two patches at the same
/// place are one vertex, unless their normals differ, as at a crease. Triangles whose corners
/// coincide, as at the teapot's knob, are left out.
/// Expects: n >= 1.
/// Errors:  throws l3d_error(bad_input) for trimmed surfaces.
L3D_PUBLIC l3d_patch_mesh l3d_tessellated(const l3d_patch_model& model, int n);

/// The mesh of a model file that was read: the file's polygons, and its patches as n by n quads
/// each. `name` is the file's name for messages.
/// Errors:  throws l3d_error(bad_input) for a file that holds neither polygons nor patches, and for
///          patches that are not bicubic.
/// Expects: n >= 1.
L3D_PUBLIC l3d_polygon_mesh l3d_mesh_of(const l3d_model_file& file, const std::string& name, int n);

#endif
