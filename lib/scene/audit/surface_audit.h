// SPDX-License-Identifier: MIT
// l3d_surface_audit: bounds of the distances between a mesh and the exact surface.
#ifndef L3D_SCENE_AUDIT_SURFACE_AUDIT_H
#define L3D_SCENE_AUDIT_SURFACE_AUDIT_H

#include "base/public.h"
#include "geom/vector.h"
#include "scene/patch_model.h"

#include <array>
#include <cstddef>
#include <memory>
#include <span>

/// The largest distance from the places of a mesh to a surface, or from the places of a surface to
/// a mesh. It has proven bounds, and an example of a place that is about as far away.
struct L3D_PUBLIC l3d_audited_way {
    double least = 0; ///< lower bound of the distance at `place`, and so of the largest distance
    double most = 0;  ///< upper bound of the distance at all places
    /// The example: a place whose distance is at least `least`. It is on the mesh, or on the
    /// surface up to the error of its patches.
    l3d_vector<double, 3> place{0.0, 0.0, 0.0};
    /// The triangle of the mesh that holds the place, or the piece of the surface by its number in
    /// l3d_patch_model::pieces.
    std::size_t index = 0;
};

/// The distances between a mesh and a surface, each from all places of one to the nearest place of
/// the other. The larger one is Hausdorff's distance.
struct L3D_PUBLIC l3d_mesh_audit {
    /// The largest distance from a place of the mesh to the surface. This distance is large if the
    /// mesh has too much.
    l3d_audited_way from_mesh;
    /// The largest distance from a place of the surface to the mesh. This distance is large if the
    /// mesh lacks a part.
    l3d_audited_way from_surface;
};

/// Measures distances between meshes and the trimmed pieces of a model. Each distance gets bounds
/// from below and from above.
///
/// Distances have no sign. So mesh and surface may be open, and may turn either side outwards.
/// Lives: as long as it is needed; it shares the model's contents.
/// Units: all lengths are in the model's unit.
class L3D_PUBLIC l3d_surface_audit {
public:
    /// A place in the model's space.
    using vector = l3d_vector<double, 3>;
    /// The corners of a triangle.
    using triangle = std::array<vector, 3>;

    /// The tolerance that programs usually ask for, as a share of the diagonal of the model's box.
    static constexpr double usual_tolerance = 1e-4;

    /// Prepares a model for measurements. `tolerance` is the wanted difference between upper and
    /// lower bounds.
    /// Expects: a model with patches; a tolerance > 0.
    /// Cost:    the patches of the model at a level whose error is a quarter of the tolerance, and
    ///          some 300 bytes for each triangle of their trims.
    l3d_surface_audit(const l3d_patch_model& model, double tolerance);
    /// Takes the contents of `other`.
    l3d_surface_audit(l3d_surface_audit&& other) noexcept;
    ~l3d_surface_audit();

    /// Bounds of the distance from a place to the surface. Shape: the lower bound, the upper bound.
    std::array<double, 2> distance(const vector& from) const;

    /// Measures the distances between a mesh of triangles and the surface, in both directions.
    ///
    /// The bounds are always valid. They are farther apart than the tolerance if the model's finest
    /// level is too coarse, or if the search runs out of cuts (least_cuts).
    /// Expects: at least one triangle; finite coordinates of magnitude at most 1e12.
    /// Cost:    some 10 us for each triangle and each cell of the surface. Triangles and cells
    ///          whose distance is nearly the largest are cut, which takes up to a millisecond for
    ///          each cut.
    /// Source:  branch and bound; NUMERICS derives the bounds.
    l3d_mesh_audit compare(std::span<const triangle> mesh) const;

    /// The number of cuts of triangles and cells that the search in each direction may always use.
    /// If the mesh and the surface together have more triangles and cells, the limit is their
    /// number.
    static constexpr std::size_t least_cuts = std::size_t{1} << 13;

private:
    struct contents;
    std::unique_ptr<contents> contents_;
};

#endif
