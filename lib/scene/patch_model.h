// SPDX-License-Identifier: MIT
// l3d_patch_model: patches, and all that is computed about them before any frame.
#ifndef L3D_SCENE_PATCH_MODEL_H
#define L3D_SCENE_PATCH_MODEL_H

#include "base/public.h"
#include "geom/bezier_patch.h"
#include "geom/material.h"
#include "geom/parts.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

class l3d_box_lanes;
class l3d_facing_cones;
class l3d_curved_pieces;
class l3d_normal_net;
class l3d_nurbs_surface;
class l3d_space_curve;
struct l3d_halved_side;
class l3d_surface_bends;
struct l3d_cell_wish;
struct l3d_model_edge;
struct l3d_model_file;
struct l3d_parameter_range;
struct l3d_patch_error;
struct l3d_shared_edge;
struct l3d_trim_region;
struct l3d_patch_points;

/// The largest magnitudes of a patch's coordinates, for the whole control net and for each edge.
/// Bounds of rounding errors are computed from these magnitudes.
///
/// Shape: edges in the order v = 0, v = 1, u = 0, u = 1.
struct L3D_PUBLIC l3d_patch_reach {
    /// Magnitudes of x, y and z among all 16 control points.
    l3d_vector<double, 3> whole{0.0, 0.0, 0.0};
    /// Magnitudes among the four control points of each edge.
    std::array<l3d_vector<double, 3>, 4> edges{};
};

/// An edge whose distance from its faces exceeds the file's tolerance.
struct L3D_PUBLIC l3d_loose_edge {
    std::size_t edge = 0; ///< index in l3d_patch_model::edges
    double off = 0;       ///< the largest distance from the faces that was found
    double tolerance = 0; ///< the distance from the faces that the file allows
    /// Where on the edge the largest distance was found.
    l3d_vector<double, 3> place{0.0, 0.0, 0.0};
    std::vector<std::size_t> pieces; ///< the pieces whose trims follow the edge
};

/// A set of bicubic patches, each with its exact normal net and its box. Coordinates are those of
/// the world, unless an l3d_patch_scene places the model elsewhere.
///
/// A curved model is made of pieces that are not all bicubic. Some pieces are rational, or of
/// degrees above 3. The patches of a curved model approximate its pieces within surface_error().
/// Where a picture needs finer patches, a pipeline draws a finer level of the model. Materials and
/// parts belong to pieces. In a model that is not curved, each patch is a piece.
///
/// A model never changes after it is made. Its copies share its contents.
/// Lives: the contents live as long as any copy does, such as the one in a scene. References and
///        spans that the accessors return live as long.
/// Cost:  a copy counts a reference. A move is a copy, so no model is ever without contents.
class L3D_PUBLIC l3d_patch_model {
public:
    /// One bicubic patch: 16 control points.
    using patch = l3d_bezier_patch<double, 3>;
    /// A place in the model's space.
    using vector = l3d_vector<double, 3>;

    /// A model without patches.
    l3d_patch_model();
    /// Shares the contents.
    l3d_patch_model(const l3d_patch_model&) = default;
    /// Shares the contents of the other model in place of its own contents.
    l3d_patch_model& operator=(const l3d_patch_model&) = default;
    ~l3d_patch_model() = default;

    /// A model of these patches, in white.
    /// Errors: throws l3d_error(bad_input) with the text of checked() for the name "model".
    explicit l3d_patch_model(std::vector<patch> patches);

    /// The teapot that the library contains, data/teapot.bpt, with its parts.
    static l3d_patch_model teapot();

    /// Loads the patches and curves of a file in any format of l3d_read_model, with the colours
    /// that the file gives them. Polygons and notes are left out.
    /// Errors: throws l3d_error(bad_input) with file, line and reason: also for a file without
    ///         patches, and for patches that from_patches refuses.
    static l3d_patch_model load(const std::string& file);

    /// A model of patches whose coordinates are checked.
    /// Errors: nothing, with "name: patch and point: what" in `why`, if a coordinate is NaN,
    ///         infinite or beyond 1e12.
    static std::optional<l3d_patch_model> checked(std::vector<patch> patches, std::string_view name,
                                                  std::string& why);

    /// Reads a .bpt text.
    /// Errors: nothing, with "name:line: what" in `why`.
    static std::optional<l3d_patch_model> from_bpt(std::string_view text, std::string_view name,
                                                   std::string& why);

    /// A model of patches as files have them, brought to degree 3 by 3. It is a curved model if a
    /// patch has weights that differ, or other degrees.
    /// Errors: nothing, with the patch in `why`, if its degrees are not from 1 to 15, or a weight
    /// is not from 1e-100 to 1e12. Nothing also for too few or too many points or weights, and for
    /// coordinates that checked() refuses.
    static std::optional<l3d_patch_model> from_patches(std::span<const l3d_patch_points> patches,
                                                       std::string_view name, std::string& why);
    /// A model of patches whose trims follow these edges.
    /// Errors: as the function without edges, and if a trim follows an edge that is not there.
    static std::optional<l3d_patch_model> from_patches(std::span<const l3d_patch_points> patches,
                                                       std::span<const l3d_model_edge> edges,
                                                       std::string_view name, std::string& why);

    /// A model of the patches and curves of a file that was read, with the colours that the file
    /// gives them. Shapes at many places become copies (l3d_flattened).
    /// Errors: as from_patches.
    static std::optional<l3d_patch_model> from_file(const l3d_model_file& file,
                                                    std::string_view name, std::string& why);

    /// The same patches, with the colours, parts, curves and errors that `file` gives them.
    /// Expects: a file of pieces() patches without placements.
    l3d_patch_model dressed(const l3d_model_file& file) const;

    /// A model of the pieces of NURBS surfaces, in their order. Surfaces meet without a gap where
    /// they have the same control points, weights and knots along a boundary. Surfaces also meet
    /// without a gap where curves of their trims follow the same edge of `edges`
    /// (l3d_trim_curve::edge).
    /// Errors: throws l3d_error(bad_input) as from_patches, and if a trim follows an edge that is
    ///         not there.
    static l3d_patch_model from_surfaces(std::span<const l3d_nurbs_surface> surfaces,
                                         std::span<const l3d_model_edge> edges = {});

    /// The number of pieces that the model is made of. It is the number of patches(), unless the
    /// model is curved.
    std::size_t pieces() const;
    /// The index of the piece that a patch belongs to. Expects: index < patches().size().
    std::size_t piece_of(std::size_t index) const;
    /// The part of its piece that a patch covers: the whole piece, unless the model is curved.
    /// Expects: as piece_of.
    l3d_parameter_range range_in_piece(std::size_t index) const;

    /// The number of a piece's face in the file, from 1; 0 if the file numbers none.
    /// Expects: piece < pieces().
    std::uint32_t face_of(std::size_t piece) const;

    /// A piece as a NURBS surface, each parameter from 0 to 1. Expects: piece < pieces().
    l3d_nurbs_surface surface(std::size_t piece) const;
    /// Each piece as a NURBS surface of its own.
    std::vector<l3d_nurbs_surface> surfaces() const;
    /// A model of the pieces of these surfaces, with the materials, parts and lines of this model.
    /// Errors: throws l3d_error(bad_input) as from_surfaces, or if there are fewer or more than
    ///         pieces().
    /// Cost:   as from_surfaces for patches that differ; bounds of equal patches are copied.
    l3d_patch_model reshaped(std::span<const l3d_nurbs_surface> surfaces) const;

    /// Whether the model's patches approximate pieces that are not bicubic.
    bool is_curved() const { return source_ != nullptr; }
    /// The same curved model with finer or coarser patches; a model that is not curved is the same
    /// at all levels. Levels say how fine the patches are: one level for the error of places,
    /// another for that of normals. Both levels run from 0, the coarsest, to most_level(). Models
    /// are made with level 0. Two levels more divide the error bound of places by 4, and that of
    /// normals by 8. This holds as long as no more than 2^17 patches are needed.
    /// Expects: 0 <= places, normals <= most_level().
    /// Cost:    some 20 us a patch when a level is first asked for. Its patches are kept as long as
    ///          any copy of the model lives.
    l3d_patch_model at_level(int places, int normals) const;
    /// The finest level of places and of normals; 0 if the model is not curved.
    int most_level() const;
    /// The bound of errors of places at a level; 0 if the model is not curved. The bound is known
    /// before the level's patches are made.
    /// Expects: as at_level.
    double error_at_level(int places, int normals) const;
    /// A bound of the number of a level's patches. The bound is known before the patches are made.
    /// Expects: as at_level.
    double patches_at_level(int places, int normals) const;
    /// The same curved model with only the patches that may be seen in the wish's region. Each
    /// patch is as fine as its depth asks for. Nothing if no patch may be seen in the region.
    /// Expects: a curved model, a wish with a region in its coordinates.
    /// Cost:    some 50 us a patch when a wish is new; patches of the last eight wishes are kept.
    std::optional<l3d_patch_model> seen(const l3d_cell_wish& wanted) const;
    /// The largest ratio of a patch's error to the error that the wish allowed it, in a model that
    /// seen() made.
    double share_of_wish() const;
    /// The bound of errors of unit normals that a level aims at; 0 if the model is not curved.
    /// Expects: as at_level.
    double normal_target(int level) const;

    /// A copy of the model whose pieces count as approximations of another surface. `errors` says
    /// how far each piece is off that surface. Error bounds of pictures include it.
    /// Expects: an error for each piece, finite and not negative. An empty list says that the
    ///          pieces are the surface itself.
    l3d_patch_model standing_for(std::span<const l3d_patch_error> errors) const;

    /// Whether the model's patches are the surface itself, not approximations of a surface.
    bool is_exact() const { return !is_curved() && !stated_; }

    /// Bound of the distance between the patches and the surface that they approximate, at the same
    /// parameters. The approximated surface is that of a curved model's pieces, or the surface of
    /// standing_for(). The bound is 0 for other models.
    double surface_error() const;
    /// The bound surface_error() for one patch. Expects: index < patches().size().
    double surface_error(std::size_t index) const;
    /// Bound of the difference between unit normals of the patches and of the surface that they
    /// approximate, at the same parameters. The bound is 0 for models without surface_error(). It
    /// is infinite if a normal vanishes inside of a patch of a curved model.
    double normal_error() const;
    /// Whether the bound normal_error() holds for a patch. The bound does not hold where nothing is
    /// known about the normals of the approximated surface.
    /// Expects: index < patches().size().
    bool has_normal_error(std::size_t index) const;

    /// The sides that meet two smaller patches, each along half of the side, in the order of
    /// patches. A half of the side has the control points of the smaller patch's side. Pictures
    /// draw a halved side as its two halves, so that no gap shows.
    std::span<const l3d_halved_side> halved_sides() const;
    /// A bit for each edge of a patch that is one of halved_sides(), in the order of
    /// l3d_patch_reach::edges.
    /// Expects: index < patches().size().
    unsigned halved_edges(std::size_t index) const;

    /// Whether any of the model's pieces is trimmed.
    bool has_trims() const;
    /// The part of a patch that its trims leave; null if they leave all of the patch.
    /// Expects: index < patches().size().
    const l3d_trim_region* trim(std::size_t index) const;
    /// The edges at which the model's trimmed pieces end.
    std::span<const l3d_shared_edge> edges() const;
    /// A text about edges that are off their faces by more than the file's own tolerance. It tells
    /// how many edges these are, and how far the worst edge is off. The text is "" if there are
    /// none. Pictures close the gaps at loose edges all the same.
    std::string edges_note() const;
    /// The edges that edges_note() counts, the worst one first.
    std::vector<l3d_loose_edge> loose_edges() const;
    /// Whether the trims of a patch follow edges. Expects: index < patches().size().
    bool follows_edges(std::size_t index) const;

    /// An address that copies of one model have in common at all levels. No other model that lives
    /// at the same time has this address.
    const void* source_identity() const;

    /// The least x, y and z of the pieces' control points: the same as least(), unless the model is
    /// curved.
    const vector& pieces_least() const;
    /// The largest x, y and z of the pieces' control points.
    const vector& pieces_most() const;

    /// The same patches with these materials: one for all of them, or one for each piece, in order.
    /// Errors:  throws l3d_error unless there are 1 or pieces() materials.
    /// Cost:    the patches and all that is known of them are shared.
    l3d_patch_model painted(std::span<const l3d_material> materials) const;
    /// The same patches, all of one material.
    l3d_patch_model painted(const l3d_material& material) const {
        return painted(std::span(&material, 1));
    }

    /// The same patches with these parts in place of their own.
    /// Expects: runs as l3d_parts takes them.
    l3d_patch_model with_parts(std::span<const l3d_part_run> runs) const;

    /// The named parts of the pieces.
    const l3d_parts& parts() const;

    /// The same patches, with another material for the patches of one part.
    /// Expects: an index of parts().names().
    l3d_patch_model part_painted(std::size_t part, const l3d_material& material) const;

    /// A model of the patches of some parts, with their materials. Patches without a part, and all
    /// lines, are left out.
    /// Expects: indices of parts().names().
    /// Cost:    bounds of the patches are computed again: some microseconds for each.
    l3d_patch_model only(std::span<const std::size_t> parts) const;

    /// A model without the patches of some parts; all lines stay. Expects, Cost: as only().
    l3d_patch_model without(std::span<const std::size_t> parts) const;

    /// The same patches with these lines in space in place of their own. Pipelines draw the lines
    /// where they draw the patches.
    l3d_patch_model with_curves(std::vector<l3d_space_curve> curves) const;

    /// The lines in space that belong to the model, in its own coordinates.
    std::span<const l3d_space_curve> curves() const;

    /// The different opacities of the pieces' materials, each once, in the order of the pieces.
    std::vector<float> opacities() const;
    /// A model of the patches whose materials have an opacity from `least` to `most`. Lines are
    /// opaque.
    /// Cost: as only().
    l3d_patch_model of_opacity(float least, float most) const;

    /// The different materials of the patches, each once; none if all are plain
    /// (l3d_material::is_plain).
    std::span<const l3d_material> materials() const;
    /// The index of a patch's material in materials(); 0 if there are none.
    /// Expects: index < patches().size().
    std::uint32_t material_of(std::size_t index) const;

    /// All patches, in the order in which they were given.
    std::span<const patch> patches() const;
    /// The exact normals of a patch, as a net of control vectors.
    /// Expects: index < patches().size().
    const l3d_normal_net& normals(std::size_t index) const;
    /// The cones that hold the normals of a patch and of its parts. Expects: as normals.
    const l3d_facing_cones& facing(std::size_t index) const;
    /// Bounds of how strongly a patch bends, from which its error bound is computed.
    /// Expects: as normals.
    /// Cost:    some 50 us at the first call for a patch, which any thread may make.
    const l3d_surface_bends& bends(std::size_t index) const;
    /// The largest magnitudes of a patch's coordinates. Expects: as normals.
    const l3d_patch_reach& reach(std::size_t index) const;

    /// 1 if the model is proven to be a closed body whose normals point outwards; -1 if the model
    /// is proven to be a closed body whose normals point inwards. 0 if the model is not proven to
    /// be closed (l3d_orientation_of).
    int orientation() const;

    /// The least x, y and z of all control points.
    const vector& least() const;
    /// The largest x, y and z of all control points.
    const vector& most() const;

    /// The axis-aligned boxes of the patches' control points, in the order of patches().
    const l3d_box_lanes& boxes() const;

    /// An address that copies of one model have in common, however they are painted. No other model
    /// that lives at the same time has this address, even one of equal patches. A level of a curved
    /// model with other patches counts as another model.
    const void* identity() const;
    /// An address that models with shared materials have in common; null if all materials are
    /// plain.
    const void* paint_identity() const;

private:
    class bends_on_demand;
    struct contents;
    std::shared_ptr<const contents> contents_;

    struct source;
    std::shared_ptr<const source> source_; ///< null unless the model is curved
    // These functions copy the bounds of patches that are equal to patches of `like`, which may be
    // null.
    l3d_patch_model(std::vector<patch> patches, const contents* like);
    l3d_patch_model(l3d_curved_pieces pieces, const source* like);
    /// Errors:  nothing, with the reason in `why`.
    static std::optional<l3d_patch_model> made_like(const l3d_patch_model* like,
                                                    std::span<const l3d_patch_points> patches,
                                                    std::span<const l3d_model_edge> edges,
                                                    std::string_view name, std::string& why);
    /// Errors:  as made_like.
    static std::optional<l3d_patch_model> curved(const l3d_patch_model* like,
                                                 std::span<const l3d_patch_points> patches,
                                                 std::span<const l3d_model_edge> edges,
                                                 std::string_view name, std::string& why);

    struct paint;
    l3d_patch_model chosen(const std::vector<bool>& is_chosen) const;
    std::vector<l3d_material> piece_materials() const;

    /// The pieces' face numbers; null if the file has none.
    std::shared_ptr<const std::vector<std::uint32_t>> faces_;
    struct stated;
    std::shared_ptr<const stated> stated_;   ///< null if no errors are stated
    std::shared_ptr<const paint> paint_;     ///< null if all materials are plain
    std::shared_ptr<const l3d_parts> parts_; ///< null without parts
    std::shared_ptr<const std::vector<l3d_space_curve>> curves_; ///< null without lines
};

#endif
