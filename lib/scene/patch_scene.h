// SPDX-License-Identifier: MIT
// l3d_patch_scene: the models that a pipeline draws, each with its placement; and what a place of
// the picture shows.
#ifndef L3D_SCENE_PATCH_SCENE_H
#define L3D_SCENE_PATCH_SCENE_H

#include "base/public.h"
#include "geom/material.h"
#include "geom/matrix.h"
#include "geom/plane.h"
#include "geom/vector.h"
#include "raster/textures/texture.h"
#include "scene/camera.h"
#include "scene/patch_model.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// A rectangular part of a patch, by its parameters.
struct L3D_PUBLIC l3d_parameter_range {
    double u0 = 0; ///< where u begins
    double u1 = 1; ///< where u ends
    double v0 = 0; ///< where v begins
    double v1 = 1; ///< where v ends

    /// One of the two halves along u, or along v.
    l3d_parameter_range half(bool along_u, bool second) const {
        l3d_parameter_range result = *this;
        if (along_u)
            (second ? result.u0 : result.u1) = (u0 + u1) / 2;
        else
            (second ? result.v0 : result.v1) = (v0 + v1) / 2;
        return result;
    }
};

/// A picture, and where it lies on patches.
///
///     std::vector<std::string> notes;
///     scene.lay(0, {.texture = l3d_read_texture("wood.png", notes)});
///
/// Shape: a place of a picture is (0, 0) in its upper left corner and (1, 1) in the lower right
///        one. Beyond the picture's borders, l3d_texture_wrap says what is seen. Corners of a patch
///        are those at parameters (u, v) of (0, 0), (1, 0), (0, 1) and (1, 1).
struct L3D_PUBLIC l3d_laid_picture {
    /// The places of a patch's corners in the picture. Between the corners, places are bilinear in
    /// u and v.
    using corners = std::array<std::array<double, 2>, 4>;
    /// The corners that lay the whole picture on a patch.
    static constexpr corners whole{{{0, 0}, {1, 0}, {0, 1}, {1, 1}}};

    /// The picture; null shows the colours of materials.
    std::shared_ptr<const l3d_texture> texture;
    /// The corners of each piece of the model, in order. If the list is empty, the whole picture
    /// lies on each piece.
    std::vector<corners> pieces{};

    friend bool operator==(const l3d_laid_picture&, const l3d_laid_picture&) = default;
};

/// A box that an affine map may have slanted: the points centre + r axes[0] + s axes[1] +
/// t axes[2] with r, s, t in [-1, 1].
struct L3D_PUBLIC l3d_slanted_box {
    l3d_vector<double, 3> centre{0.0, 0.0, 0.0}; ///< the middle, in world units
    /// Vectors from the middle to the middles of three sides that meet.
    std::array<l3d_vector<double, 3>, 3> axes{};
    double reach = 0; ///< l3d_patch_instance::reach() of points in the box; 0 if unknown
};

/// A list of boxes for SIMD code: each lane takes one box.
///
/// Shape: one array per coordinate, box i in element i. The arrays have room for a multiple of
///        `lanes`, with meaningless numbers behind the last box.
/// Cost:  13 doubles a box. add allocates only when there are more boxes than ever before.
class L3D_PUBLIC l3d_box_lanes {
public:
    static constexpr std::size_t lanes = 16; ///< the arrays have room for a multiple of this number

    /// The number of boxes.
    std::size_t count() const { return count_; }
    /// Forgets all boxes. Cost: keeps the memory.
    void clear() { count_ = 0; }

    /// Adds a box at the end.
    void add(const l3d_slanted_box& box) {
        if (count_ == centre_[0].size())
            grow();
        set(count_++, box);
    }

    /// Replaces a box. Expects: there is a box at that index.
    void set(std::size_t index, const l3d_slanted_box& box) {
        for (int i = 0; i < 3; ++i) {
            const auto at = static_cast<std::size_t>(i);
            centre_[at][index] = box.centre[i];
            for (std::size_t k = 0; k < 3; ++k)
                axes_[k][at][index] = box.axes[k][i];
        }
        reach_[index] = box.reach;
    }

    /// Coordinate i of the centres, from box `first` on.
    const double* centre(std::size_t i, std::size_t first) const { return &centre_[i][first]; }

    /// Coordinate i of the k-th axes, from box `first` on.
    const double* axis(std::size_t k, std::size_t i, std::size_t first) const {
        return &axes_[k][i][first];
    }

    /// The members l3d_slanted_box::reach, from box `first` on.
    const double* reach(std::size_t first) const { return &reach_[first]; }

private:
    void grow() {
        const std::size_t size = 2 * count_ + lanes;
        for (std::size_t i = 0; i < 3; ++i) {
            centre_[i].resize(size);
            for (auto& axis : axes_)
                axis[i].resize(size);
        }
        reach_.resize(size);
    }

    std::size_t count_ = 0;
    std::array<std::vector<double>, 3> centre_;
    std::array<std::array<std::vector<double>, 3>, 3> axes_;
    std::vector<double> reach_;
};

struct l3d_curved_error;
struct l3d_level_view;

/// A model at a place in the world.
///
/// Lives: shares the model.
class L3D_PUBLIC l3d_patch_instance {
public:
    /// Places this model. Expects: a placement without an l3d_patch_scene::complaint.
    l3d_patch_instance(const l3d_patch_model& model, const l3d_matrix<double>& placement);

    /// The model that stands here.
    const l3d_patch_model& model() const { return model_; }

    /// Puts the same model elsewhere. Expects: as the constructor.
    void place(const l3d_matrix<double>& placement);

    /// Puts another level of the instance's model in place of the model.
    /// Expects: a model that at_level() made of model().
    void take_level(const l3d_patch_model& level) { model_ = level; }

    /// Gives the whole instance one material. Without a material, the model's materials are seen.
    void paint(const std::optional<l3d_material>& material) { material_ = material; }
    /// The material of the whole instance, if it has one of its own.
    const std::optional<l3d_material>& material() const { return material_; }

    /// Lays a picture on the whole instance. The picture's light is multiplied by the material's
    /// light.
    void lay(const l3d_laid_picture& picture) { picture_ = picture; }
    /// The picture that lies on the instance.
    const l3d_laid_picture& picture() const { return picture_; }

    /// The share of the light from behind that the instance holds back: 1 if nothing is seen
    /// through it.
    double opacity() const { return opacity_; }
    /// Sets the opacity. Expects: 0 to 1.
    void set_opacity(double opacity) { opacity_ = opacity; }

    /// The matrix from the model's space to the world.
    const l3d_matrix<double>& placement() const { return placement_; }

    /// Whether the model's normals have other directions in the world than in the model. They do
    /// not if the model was only moved, or scaled by one positive number.
    bool turns_normals() const { return turns_normals_; }

    /// The matrix that takes the model's normals to the world: the cofactors of the placement,
    /// scaled so that the largest is 1. Cofactors turn normals correctly, since (A a) x (A b) =
    /// cof(A) (a x b).
    /// Shape:   the upper left three by three; the rest as in the identity.
    const l3d_matrix<double>& normal_matrix() const { return normal_matrix_; }

    /// The factor by which the placement multiplies all lengths; 0 if it multiplies lengths by
    /// different factors.
    double scale() const { return scale_; }
    /// Upper bound of the factor by which lengths grow: scale(), or else the Frobenius norm.
    double stretch() const;

    /// The model's box in the world, with its reach.
    l3d_slanted_box box() const;

    /// Bound of a sum of magnitudes. All terms that add up to a point's world coordinates are
    /// summed. Rounding errors are in proportion to this sum. The bound holds for points of the
    /// model with coordinates of magnitude at most `most`.
    double reach(const l3d_vector<double, 3>& most) const { return l3d_dot(terms_, most) + shift_; }

    /// The bound reach(most) for all points of the model.
    double reach() const;

    /// The sum of the magnitudes in each of the placement's first three columns. These columns are
    /// the factors of a point's x, y and z.
    const l3d_vector<double, 3>& terms() const { return terms_; }
    /// The sum of the magnitudes in the placement's last column, the translation.
    double shift() const { return shift_; }

private:
    l3d_patch_model model_;
    std::optional<l3d_material> material_;
    l3d_laid_picture picture_;
    l3d_matrix<double> placement_;
    l3d_matrix<double> normal_matrix_;
    l3d_vector<double, 3> terms_{0.0, 0.0, 0.0};
    double shift_ = 0;
    bool turns_normals_ = false;
    double scale_ = 1, opacity_ = 1;
};

/// Models of bicubic patches, placed in the world. Each model may stand at any number of places.
///
/// Patches of one instance meet without a gap where their control points do. Patches of two
/// instances meet without a gap only if, besides, both placements have the same numbers.
/// Lives: shares the models: a program may forget its own copies.
/// Cost: the test whether an instance is seen reads 104 bytes. An instance takes some 460 bytes
///       more.
class L3D_PUBLIC l3d_patch_scene {
public:
    /// A place in the world.
    using vector = l3d_vector<double, 3>;

    l3d_patch_scene() = default;

    /// A scene of one model, at its own place. Not explicit: a model is a scene.
    l3d_patch_scene(const l3d_patch_model& model) { add(model); }

    /// A scene of a file that was read. Each shape that stands at many places is one model, which
    /// its instances share. Shapes at transparent places are copied into one model, since only few
    /// instances may be transparent.
    /// Errors: as l3d_patch_model::from_file; also for a place that complaint() refuses.
    static std::optional<l3d_patch_scene> from_file(const l3d_model_file& file,
                                                    std::string_view name, std::string& why);

    /// Why the model cannot be placed like this; "" if it can. A placement is affine (its last row
    /// is 0, 0, 0, 1), has finite numbers, can be inverted, and leaves coordinates at most 1e12.
    static std::string complaint(const l3d_patch_model& model, const l3d_matrix<double>& placement);

    /// Adds an instance of the model with this placement.
    /// Errors: throws l3d_error with the text of complaint(), and adds nothing.
    void add(const l3d_patch_model& model,
             const l3d_matrix<double>& placement = l3d_identity<double>());

    /// Adds an instance for each opacity of the model's materials. If the scene has no room for so
    /// many transparent instances (most_transparent), opacities are rounded up to fewer ones.
    /// Errors: as add.
    void add_by_opacity(const l3d_patch_model& model,
                        const l3d_matrix<double>& placement = l3d_identity<double>());

    /// Moves an instance.
    ///
    /// Errors:  as add; the instance stays where it is. Throws std::out_of_range if there is no
    ///          instance of this index, as all functions below do that take one.
    /// Cost:    the box of the whole scene is found again when it is next asked for, by looking at
    ///          each instance.
    void place(std::size_t index, const l3d_matrix<double>& placement) {
        place(index, instances_.at(index).model(), placement);
    }
    /// Replaces the model and the placement of an instance.
    /// Errors, Cost: as place(index, placement).
    void place(std::size_t index, const l3d_patch_model& model,
               const l3d_matrix<double>& placement);

    /// Gives all of an instance one material. Without a material, the materials of the instance's
    /// model are seen again. The material stays when the instance is placed elsewhere, until
    /// another model takes its place.
    void paint(std::size_t index, const std::optional<l3d_material>& material);

    /// Lays a picture on the patches of an instance. An l3d_laid_picture without a texture takes
    /// the picture away. Shades that show light show the picture, and multiply its light by the
    /// material's light. The picture stays when the instance is placed elsewhere, until another
    /// model takes its place.
    /// Errors:  throws l3d_error unless there are corners for no piece, or for each of the model's.
    void lay(std::size_t index, const l3d_laid_picture& picture);
    /// Whether a picture lies on any instance.
    bool has_pictures() const;
    /// Whether the model of any instance is trimmed.
    bool has_trims() const;
    /// Whether the model of any instance has lines in space.
    bool has_curves() const;

    /// Makes an instance transparent. A pixel shows the share `opacity` of the instance's light and
    /// the share 1 - opacity of the light seen without the instance. The instance itself shows its
    /// nearest surface alone. The opacity lasts as long as a material of paint() would.
    /// Errors:  throws l3d_error if the opacity is not from 0 to 1, or for more than
    ///          most_transparent transparent instances; then nothing changes.
    /// Cost:    a frame draws everything in the instance's box twice; where the boxes of n
    ///          transparent instances overlap, 2^n times.
    void set_opacity(std::size_t index, double opacity);
    /// The largest number of transparent instances in a scene. Where that many instances overlap,
    /// 256 pictures are mixed.
    static constexpr std::size_t most_transparent = 8;
    /// The number of instances with an opacity below 1.
    std::size_t transparent_count() const { return transparent_count_; }

    /// A scene of some of the instances, opaque, in the order of the indices. The result's
    /// materials() are those of all instances, so that pictures of both scenes are lit alike.
    /// Expects: indices of instances().
    /// Lives: shares the models.
    l3d_patch_scene only(std::span<const std::size_t> indices) const;

    /// The materials of all instances; none if all are plain.
    ///
    /// Expects: at most l3d_surface_rasterizer::most_materials.
    /// Lives:   until the next change of the scene.
    /// Cost:    after a change of models or materials, time for each instance.
    std::span<const l3d_material> materials() const;
    /// The index of a patch's material in materials(); 0 if there are none.
    /// Expects: materials() was called since the last change of the scene.
    std::uint32_t material_of(std::size_t instance, std::size_t patch) const {
        if (materials_.empty())
            return 0;
        const l3d_patch_instance& of = instances_[instance];
        return first_materials_[instance] + (of.material() ? 0 : of.model().material_of(patch));
    }

    /// Chooses the level of each curved model that a picture needs (l3d_patch_model::at_level).
    /// Returns bounds of the errors of these levels, and of all other patches that approximate a
    /// surface. Pipelines call it before each frame. Levels depend on the view and on placements
    /// alone, and do not count as a change of the scene.
    l3d_curved_error choose_levels(const l3d_level_view& view);

    /// Whether any instance's patches approximate other surfaces.
    bool is_curved() const { return curved_count_ > 0; }

    /// Takes all instances away, and keeps their memory.
    void clear();

    /// Whether anything has changed since the last forget_changes().
    bool is_changed() const { return is_rebuilt_ || !moved_.empty(); }

    /// Whether instances were added or taken away since the last forget_changes(). If so, moved()
    /// does not tell all changes.
    bool is_rebuilt() const { return is_rebuilt_; }

    /// The instances that were changed since the last forget_changes(), each once: placed
    /// elsewhere, painted, given a picture or an opacity. Meaningless if is_rebuilt().
    std::span<const std::size_t> moved() const { return moved_; }
    /// The boxes that the instances of moved() had at the last forget_changes(), in the same order.
    const l3d_box_lanes& moved_from() const { return moved_from_; }

    /// Forgets all changes; a pipeline calls it after drawing the scene.
    void forget_changes();

    /// The instances with their placements, in the order in which they were added.
    std::span<const l3d_patch_instance> instances() const { return instances_; }

    /// The parts of all instances. The things in these parts are the pieces of each instance's
    /// model, one instance after another.
    l3d_parts parts() const;

    /// The middle of the boxes of all pieces, whatever levels are chosen; the origin if the scene
    /// is empty.
    vector pieces_middle() const;

    /// The number of patches of all instances together.
    std::int64_t patch_count() const { return patch_count_; }

    /// The least x, y and z of the boxes of all instances; the origin if the scene is empty.
    const vector& least() const { return extent().least; }
    /// The largest x, y and z of the boxes of all instances; the origin if the scene is empty.
    const vector& most() const { return extent().most; }

    /// The largest l3d_patch_instance::reach() of the instances. Rounding errors are in proportion
    /// to this bound, even where terms cancel and coordinates are small.
    double reach() const { return extent().reach; }

    /// The instances' boxes, in their order.
    const l3d_box_lanes& boxes() const { return boxes_; }

private:
    struct whole {
        vector least{0.0, 0.0, 0.0}, most{0.0, 0.0, 0.0};
        double reach = 0;
    };

    const whole& extent() const;
    void note_change(std::size_t index);
    void take_level(std::size_t index, const l3d_patch_model& finer);

    std::vector<l3d_patch_instance> instances_;
    std::int64_t patch_count_ = 0;
    std::size_t transparent_count_ = 0, curved_count_ = 0;
    l3d_box_lanes boxes_;
    mutable whole extent_; ///< box and reach of the first extent_count_ instances
    mutable std::size_t extent_count_ = 0;
    mutable std::vector<l3d_material> materials_;
    /// For each instance, the index in materials_ of the first of its model's materials.
    mutable std::vector<std::uint32_t> first_materials_;
    mutable bool knows_materials_ = true;
    bool is_rebuilt_ = true;
    std::vector<std::size_t> moved_;
    std::vector<bool> is_moved_; ///< whether each instance is in moved_
    l3d_box_lanes moved_from_;
};

/// The nearest point of a scene's patches on the ray through a place of the picture.
///
/// Each error is the largest distance from the exact value, rounding included. An error is infinite
/// where nothing is known, as for the curvature where the surface has no normal.
struct L3D_PUBLIC l3d_pick {
    /// The instance's index in the scene.
    std::size_t instance = 0;
    /// The patch's index in the instance's model.
    std::size_t patch = 0;
    /// The name of the part that the patch belongs to; empty if it belongs to none.
    std::string part{};
    /// The first parameter, from 0 to 1.
    double u = 0;
    /// The second parameter, from 0 to 1.
    double v = 0;
    /// The error of u.
    double u_error = 0;
    /// The error of v.
    double v_error = 0;

    /// The point in the world.
    l3d_camera::vector point{0.0, 0.0, 0.0};
    /// The point's error, in world units.
    double point_error = 0;
    /// The point's distance from the eye along the view axis, as exact as the point.
    double depth = 0;

    /// The unit normal in the world, on the side that is turned to the eye; zero if there is none.
    l3d_camera::vector normal{0.0, 0.0, 0.0};
    /// The length of the difference between the normal and the exact normal; if small, the angle in
    /// radians.
    double normal_error = 0;

    /// Gaussian curvature, in 1 / world units squared.
    double gaussian = 0;
    /// The error of gaussian, in its unit.
    double gaussian_error = 0;
    /// Mean curvature, in 1 / world units. It is positive where the surface bends towards the
    /// normal, as in a bowl that is seen from above.
    double mean = 0;
    /// The error of mean, in its unit.
    double mean_error = 0;

    /// True if it is proven that the ray meets the surface here. Otherwise rounding decides whether
    /// the ray meets it, since the ray passes near an outline or a place without a normal. The
    /// errors say how near.
    bool is_proven = false;

    /// All values, a line each: name, value and error. Patches count from 0.
    std::string text() const;

    /// One short line for display in a picture, with the patch, the parameters and the point.
    std::string line() const;
};

/// The view through which l3d_pick_at looks at a scene.
struct L3D_PUBLIC l3d_pick_view {
    l3d_camera camera;      ///< the camera; its near and far planes limit the depth of hits
    l3d_size size;          ///< size of the picture, in pixels
    bool one_sided = false; ///< whether backs of surfaces are not seen (l3d_afd_settings)
    /// Surfaces behind this plane of the world are not seen.
    std::optional<l3d_plane<double>> section{};
};

/// Finds the surface that is seen at (x, y) of a picture. Nothing if the ray meets no patch between
/// the near and the far plane, in front of the section.
///
/// Units:   pixels from the picture's left upper corner; a pixel's middle is at 1/2. Any place may
///          be asked for, also one outside the picture.
/// Expects: a valid camera; finite x and y.
/// Cost:    some 100 ns for each patch, and 20 us to 200 us for each patch that the ray is near.
/// Source:  subdivision, nearest part first, until Krawczyk's operator proves a part to hold one
///          point of the ray; docs/NUMERICS.md tells the errors.
L3D_PUBLIC std::optional<l3d_pick> l3d_pick_at(const l3d_patch_scene& scene,
                                               const l3d_pick_view& view, double x, double y);

#endif
