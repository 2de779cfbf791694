// SPDX-License-Identifier: MIT
// l3d_model_file: the contents of a file of polygons, patches or curves, with readers that know a
// format by the contents, and writers. NURBS surfaces can keep their knots and control points.
#ifndef L3D_GEOM_FILES_MODEL_FILE_H
#define L3D_GEOM_FILES_MODEL_FILE_H

#include "base/public.h"
#include "geom/files/patch_file.h"
#include "geom/matrix.h"
#include "geom/nurbs_surface.h"
#include "geom/polygon_mesh.h"
#include "geom/subdivision.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// The formats that can be read. docs/FORMATS.md lists their features.
enum class L3D_PUBLIC l3d_model_format {
    asc,        ///< 3D Studio's text form
    obj,        ///< Wavefront: polygons, Bezier and B-spline surfaces, curves
    off,        ///< geomview's polygons, text or binary
    ply,        ///< Stanford's polygons, text or binary of either byte order
    videoscape, ///< Videoscape's polygons, 3DG1
    bpt,        ///< Bezier patches, each with its degrees
    bez,        ///< geomview's patches, BEZ and BBP, text or binary
    stl,        ///< triangles, text or binary
    gltf,       ///< glTF 2.0: JSON or its container, .glb
    grid,       ///< a grid of heights, in the text form of geographic programs
    step,       ///< STEP, ISO 10303-21, by a plug-in
    iges,       ///< Initial Graphics Exchange Specification, by a plug-in
};

/// A file of materials that a model file names.
struct L3D_PUBLIC l3d_material_file {
    std::string name;     ///< the file's path as the model names it, from the model's own folder
    std::size_t line = 0; ///< the model's line that names the file

    /// Whether the names are equal; lines make no difference.
    friend bool operator==(const l3d_material_file& a, const l3d_material_file& b) {
        return a.name == b.name;
    }
};

/// An axis-aligned rectangle in two dimensions, for the window and the viewport of an .obj file.
struct L3D_PUBLIC l3d_model_window {
    /// The least and the largest coordinates; x0 < x1 and y0 < y1.
    double x0 = 0, y0 = 0, x1 = 1, y1 = 1;

    friend bool operator==(const l3d_model_window&, const l3d_model_window&) = default;
};

/// A camera of a model file, in the file's coordinates.
struct L3D_PUBLIC l3d_model_camera {
    /// A place or a direction.
    using vector = l3d_vector<double, 3>;
    std::string name{};           ///< the camera's name in the file
    vector eye{0.0, 0.0, 1.0};    ///< where the picture is taken from
    vector target{0.0, 0.0, 0.0}; ///< the point that the camera looks at; not equal to eye
    vector up{0.0, 1.0, 0.0};     ///< the direction that points up in the picture
    double fov = 38;              ///< angle of view over the picture's width, in degrees

    friend bool operator==(const l3d_model_camera&, const l3d_model_camera&) = default;
};

/// A curve in space at which trimmed faces end (l3d_trim_curve::edge).
struct L3D_PUBLIC l3d_model_edge {
    l3d_nurbs_curve curve; ///< the edge itself
    double tolerance = 0;  ///< the distance that the file allows between the edge and its faces

    friend bool operator==(const l3d_model_edge&, const l3d_model_edge&) = default;
};

/// The distance between a patch and the surface that it approximates.
struct L3D_PUBLIC l3d_patch_error {
    double places = 0; ///< bound of the distance between points of equal parameters
    /// Whether the surface is a patch, too, and the control points of both differ by no more than
    /// `places`. If not, nothing is known about the normals' error.
    bool is_of_points = true;

    friend bool operator==(const l3d_patch_error&, const l3d_patch_error&) = default;
};

/// A shape of a model: the patches and curves from these indices on, up to where the next shape
/// begins.
struct L3D_PUBLIC l3d_model_shape {
    std::uint32_t first_patch = 0; ///< index in l3d_model_file::patches
    std::uint32_t first_curve = 0; ///< index in l3d_model_file::curves

    friend bool operator==(const l3d_model_shape&, const l3d_model_shape&) = default;
};

/// The material index of patches and curves that take the material of their shape's placement.
inline constexpr std::uint32_t l3d_material_of_place = 0xffffffff;

/// A shape at a place, such as one of the bolts of an assembly.
struct L3D_PUBLIC l3d_model_placement {
    std::string name;        ///< name of the part that stands at the place
    std::uint32_t shape = 0; ///< index in l3d_model_file::shapes
    /// The map from the shape's coordinates to the model's, which is affine.
    l3d_matrix<double> place = l3d_identity<double>();
    std::uint32_t material = 0; ///< the material that replaces l3d_material_of_place in the shape

    friend bool operator==(const l3d_model_placement&, const l3d_model_placement&) = default;
};

/// The contents of a model file: polygons, patches and curves, all in the coordinates of this file.
struct L3D_PUBLIC l3d_model_file {
    l3d_polygon_mesh mesh;                 ///< the polygons; without faces if there are none
    std::vector<l3d_patch_points> patches; ///< the surface patches, of any degrees
    std::vector<std::string> notes;        ///< "name:line: what was skipped"; some 20 at the most
    /// Optional, one per patch: the index of the patch's material in mesh.materials.
    std::vector<std::uint32_t> patch_materials{};
    std::vector<l3d_material_file> material_files{}; ///< files with looks of the mesh's materials
    std::vector<l3d_part_run> patch_parts{};         ///< optional, runs of patches with names
    /// The rectangle of x and y that two-dimensional programs show: `w` of .obj.
    std::optional<l3d_model_window> window{};
    /// The part of the picture that the window fills: `s` of .obj.
    /// Units: shares of the picture, from the left and from below.
    std::optional<l3d_model_window> viewport{};
    std::vector<l3d_model_camera> cameras{}; ///< cameras, which .asc has
    std::vector<l3d_nurbs_curve> curves{};   ///< lines and curves in space: `l` and `curv` of .obj
    /// Optional, one per curve: the index of the curve's material in mesh.materials.
    std::vector<std::uint32_t> curve_materials{};
    std::vector<l3d_model_edge> edges{}; ///< the edges that trims of patches follow
    l3d_cage_tags tags{};                ///< sharp edges and vertices for subdivision: `t` of .obj
    std::vector<l3d_patch_error> patch_errors{}; ///< optional: the error of each patch
    /// Optional, one per patch: the number of the patch's face in the file, from 1.
    std::vector<std::uint32_t> patch_faces{};
    /// Optional: groups of the patches and curves, in the order of these arrays. Then `placements`
    /// say where each group stands, and patch_parts is empty. l3d_flattened makes copies instead.
    std::vector<l3d_model_shape> shapes{};
    /// The places of the shapes, at least one for each. A shape is seen only at these places.
    std::vector<l3d_model_placement> placements{};

    friend bool operator==(const l3d_model_file&, const l3d_model_file&) = default;
};

/// The same model without shapes: each placement gets its own patches, curves and edges, as a part
/// with the placement's name. If shapes share an edge and are placed by equal matrices, their
/// copies share one copy of the edge. Otherwise each has its own.
L3D_PUBLIC l3d_model_file l3d_flattened(const l3d_model_file& model);

/// The patches, curves and edges of one shape, in the shape's own coordinates. `material` replaces
/// l3d_material_of_place. Expects: an index of shapes.
L3D_PUBLIC l3d_model_file l3d_shape_of(const l3d_model_file& model, std::size_t shape,
                                       std::uint32_t material);

/// A function that gives the bytes of another file that a model names, in the model's own folder.
/// Errors:  nothing, and the reason in `why`.
using l3d_other_files =
    std::function<std::optional<std::string>(const std::string& name, std::string& why)>;

/// The format of a text, by its first word or, for a binary .stl, by its size. Nothing for an
/// unknown format.
L3D_PUBLIC std::optional<l3d_model_format> l3d_model_format_of(std::string_view text);

/// Reads a model of any of the formats. docs/FORMATS.md lists the features that are read, skipped
/// with a note, or refused. A model whose numbers are in files of their own, as in glTF, needs
/// l3d_read_model_with.
///
/// Coordinates are finite and at most l3d_bpt_largest_coordinate in magnitude; the mesh is valid.
/// Errors:  nothing, and `why` = "name:line: what is wrong". For an error in a binary part of a
///          file, the line is the one where this part begins, and the message names the byte.
/// Cost:    time linear in the text; memory at most 80 bytes per byte of text, or 40 MB for glTF.
///          Counts in the text are checked before memory is taken for them.
L3D_PUBLIC std::optional<l3d_model_file> l3d_read_model(std::string_view text,
                                                        std::string_view name, std::string& why);

/// Reads a model as l3d_read_model does, and also the files that the model names: buffers and
/// pictures of glTF.
/// Errors:  as l3d_read_model.
L3D_PUBLIC std::optional<l3d_model_file> l3d_read_model_with(const l3d_other_files& files,
                                                             std::string_view text,
                                                             std::string_view name,
                                                             std::string& why);

/// A reader of one format.
/// Errors:  as l3d_read_model.
/// Cost:    as l3d_read_model.
using l3d_model_reader = std::optional<l3d_model_file>(std::string_view text, std::string_view name,
                                                       std::string& why);
L3D_PUBLIC l3d_model_reader l3d_read_asc, ///< reads .asc, 3D Studio's text form
    l3d_read_obj,                         ///< reads .obj, Wavefront's format
    l3d_read_off,                         ///< reads .off, geomview's polygons
    l3d_read_ply,                         ///< reads .ply, Stanford's polygons
    l3d_read_videoscape,                  ///< reads 3DG1, Videoscape's polygons
    l3d_read_bez,                         ///< reads BEZ and BBP, geomview's patches
    l3d_read_stl,                         ///< reads .stl, triangles
    l3d_read_grid,                        ///< reads a grid of heights as patches
    l3d_read_cad;                         ///< reads STEP and IGES, by the plug-in of l3d-cad

/// The reader of glTF 2.0.
/// Errors:  as l3d_read_model, but the message names a place in the document, such as
///          "accessors[3].count", and no line. If the text is not JSON, the message names line and
///          byte.
/// Cost:    as l3d_read_model; memory is counted for each byte of this text and of the other files.
L3D_PUBLIC std::optional<l3d_model_file> l3d_read_gltf(std::string_view text, std::string_view name,
                                                       std::string& why,
                                                       const l3d_other_files& files = {});

/// A material of a materials file: its name and look.
struct L3D_PUBLIC l3d_named_material {
    std::string name;  ///< the name that faces and patches use
    l3d_material look; ///< the material's colour, highlights and opacity
    /// The picture laid on surfaces of this material, as the file names it; none if the picture's
    /// name is empty.
    l3d_mesh_picture picture{};

    friend bool operator==(const l3d_named_material&, const l3d_named_material&) = default;
};

/// Reads the materials of an .mtl file: Kd, Ks, Ns, illum, d, Tr and map_Kd. Lines that cannot be
/// read are skipped, since no model should be lost for a colour. The first 20 skipped lines get a
/// note "name:line: what".
L3D_PUBLIC std::vector<l3d_named_material>
l3d_read_mtl(std::string_view text, std::string_view name, std::vector<std::string>& notes);

/// Gives a mesh's materials the looks of the entries with the same names. Among entries of one
/// name, the last counts. A material without an entry keeps its look, or gets a plain one.
L3D_PUBLIC void l3d_give_looks(l3d_polygon_mesh& mesh,
                               std::span<const l3d_named_material> materials);

/// Returns the text of an .off file. Reading the text gives the same vertices, faces, normals and
/// colours, bit for bit. Parts and materials are left out, and so are colours of vertices if faces
/// have colours.
/// Expects: a valid mesh.
L3D_PUBLIC std::string l3d_write_off(const l3d_polygon_mesh& mesh);

/// Returns the text of an .obj file. Reading the text gives the same model, bit for bit, except for
/// colours of faces, looks of materials, pictures, cameras and notes, which are left out.
///
/// Expects: a valid mesh with a material for every face if it has materials; patches of degrees 1
///          to l3d_bpt_largest_degree. Names have no ends of lines, and no blanks at their ends;
///          materials differ in name.
L3D_PUBLIC std::string l3d_write_obj(const l3d_model_file& model);

/// Reads the surfaces of an .obj file with their own knots and control points, for programs that
/// edit knots and points. l3d_read_obj gives Bezier patches instead: the pieces() of these
/// surfaces, in the same order.
/// Errors: as l3d_read_obj. A file without surfaces is no error.
/// Cost:   as l3d_read_obj, and the memory of the surfaces.
L3D_PUBLIC std::optional<std::vector<l3d_nurbs_surface>>
l3d_read_obj_surfaces(std::string_view text, std::string_view name, std::string& why);

/// Returns the text of an .obj file, from which l3d_read_obj_surfaces reads the same surfaces, bit
/// for bit.
L3D_PUBLIC std::string l3d_write_obj_surfaces(std::span<const l3d_nurbs_surface> surfaces);

#endif
