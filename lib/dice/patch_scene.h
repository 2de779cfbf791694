// SPDX-License-Identifier: MIT
// l3d_patch_scene: what a pipeline draws: models, and where each of them stands.
#ifndef L3D_DICE_PATCH_SCENE_H
#define L3D_DICE_PATCH_SCENE_H

#include "geom/matrix.h"
#include "dice/box_lanes.h"
#include "dice/patch_model.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// A model at a place in the world.
///
/// Lives: borrows the model.
class l3d_patch_instance {
public:
    /// Expects: as l3d_patch_scene::add.
    l3d_patch_instance(const l3d_patch_model& model, const l3d_matrix<double>& placement);

    const l3d_patch_model& model() const { return *model_; }

    /// From the model's space to the world.
    const l3d_matrix<double>& placement() const { return placement_; }

    /// Whether the model's normals have other directions in the world: not if it was only moved,
    /// or scaled by one positive number.
    bool turns_normals() const { return turns_normals_; }

    /// From the model's normals to the world's: the cofactors of the placement, since
    /// (A a) x (A b) = cof(A) (a x b). Their common scale is such that the largest is 1.
    /// Shape:   the upper left three by three; the rest as in the identity.
    const l3d_matrix<double>& normal_matrix() const { return normal_matrix_; }

    /// The model's box in the world.
    l3d_slanted_box box() const;

private:
    const l3d_patch_model* model_;
    l3d_matrix<double> placement_;
    l3d_matrix<double> normal_matrix_;
    bool turns_normals_ = false;
};

/// Models of bicubic patches, each standing anywhere any number of times.
///
/// Patches of one instance meet without a gap where their control points do. Between instances
/// that holds only where their placements are the same numbers.
/// Lives: borrows the models.
/// Cost:  96 bytes an instance to find out whether it is seen, 300 more if it is.
class l3d_patch_scene {
public:
    using vector = l3d_vector<double, 3>;

    l3d_patch_scene() = default;

    /// One instance, where the model is. Not explicit: a model is a scene.
    l3d_patch_scene(const l3d_patch_model& model) { add(model); }

    /// Expects: an affine placement (last row 0, 0, 0, 1) of finite numbers that can be inverted,
    ///          and that leaves coordinates at most 1e12.
    void add(const l3d_patch_model& model,
             const l3d_matrix<double>& placement = l3d_identity<double>());

    /// Takes all instances away, and keeps their memory.
    void clear();

    std::span<const l3d_patch_instance> instances() const { return instances_; }

    /// Of all instances together.
    std::int64_t patch_count() const { return patch_count_; }

    /// The box of everything; two points at the origin if there is nothing.
    const vector& least() const { return least_; }
    const vector& most() const { return most_; }

    /// Bound of the terms that a world point's coordinates are summed up from, in all: their
    /// roundings are in proportion to this, however small the coordinates become.
    double reach() const { return reach_; }

    /// The instances' boxes, in their order.
    const l3d_box_lanes& boxes() const { return boxes_; }

private:
    std::vector<l3d_patch_instance> instances_;
    std::int64_t patch_count_ = 0;
    vector least_{0.0, 0.0, 0.0}, most_{0.0, 0.0, 0.0};
    double reach_ = 0;
    l3d_box_lanes boxes_;
};

#endif
