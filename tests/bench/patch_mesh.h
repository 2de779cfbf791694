// SPDX-License-Identifier: MIT
// Triangle meshes of a patch whose neighbours' meshes meet theirs without a gap.
#ifndef L3D_TESTS_BENCH_PATCH_MESH_H
#define L3D_TESTS_BENCH_PATCH_MESH_H

#include "bench/seen_patch.h"
#include "bench/surface_error.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

/// Triangles that tile the parameter square of one patch, all turned alike.
struct patch_mesh {
    using triangle = std::array<std::uint32_t, 3>;
    std::vector<mesh_corner> corners;
    std::vector<triangle> triangles;

    /// Calls sample(drawn image point, u, v) for the lattice of a triangle.
    template <class Sample> void each_sample(const triangle& t, Sample sample) const {
        const mesh_corner &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
        for_triangle_lattice([&](double p, double q, double r) {
            sample(a.image * p + b.image * q + c.image * r, a.u * p + b.u * q + c.u * r,
                   a.v * p + b.v * q + c.v * r);
        });
    }

    /// The largest error of a triangle's samples, and of all triangles'.
    double error(const triangle& t, const seen_patch& patch) const;
    double error(const seen_patch& patch) const;
    /// Takes away what is not seen or has two corners in one place.
    void keep_visible(const seen_patch& patch);
};

/// The boundary curves of a model's patches, each cut into pieces that its two patches share.
///
/// The points of a boundary are a function of its control points and the number of pieces alone,
/// whichever way it runs, so both patches have the same bits.
class shared_edges {
public:
    enum side { low_v, high_v, low_u, high_u };

    /// Each cut as its own error needs. Units: tolerance in pixels.
    shared_edges(const l3d_patch_model& model, const seen_world& world, double tolerance);

    /// A side that is collapsed into a point: its neighbours meet it however it is cut.
    bool collapsed(std::size_t patch, side s) const { return at(patch, s).collapsed; }
    int pieces(std::size_t patch, side s) const { return at(patch, s).pieces; }
    void refine(std::size_t patch, side s);

    /// In order of rising u or v. Expects: not collapsed.
    std::vector<mesh_corner> points(std::size_t patch, side s) const;

private:
    struct edge {
        l3d_bezier_curve<double, 3> canonical;
        seen_patch::growth growth;
        bool collapsed;
        int pieces;
    };
    struct use {
        std::size_t edge;
        bool backwards;
    };
    const edge& at(std::size_t patch, side s) const { return edges_[uses_[patch][s].edge]; }

    const seen_world& world_;
    std::vector<edge> edges_;
    std::vector<std::array<use, 4>> uses_;
};

/// Grids of nu by nv steps inside a patch, tied to its boundary by a ring of triangles. A quad is
/// cut along the better one of its diagonals.
class grid_maker {
public:
    grid_maker(const seen_patch& patch, std::size_t index);

    /// Steps for an error of `scale` times `tolerance`, half of it along each direction; at
    /// least 2.
    void set_steps(double tolerance, double scale);
    patch_mesh grid(const shared_edges& edges) const;

    /// Refines the edges, or lowers `scale`, where the grid errs by more than `tolerance`.
    /// False if it does nowhere.
    bool improve(shared_edges& edges, double tolerance, double& scale) const;

private:
    const seen_patch& patch_;
    std::size_t index_;
    seen_patch::growth along_u_, along_v_;
    int nu_ = 2, nv_ = 2;
};

#endif
