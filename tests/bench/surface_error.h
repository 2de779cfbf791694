// SPDX-License-Identifier: MIT
// How far drawn surfaces are from the exact ones, measured alike for ours and the peers'.
#ifndef L3D_TESTS_BENCH_SURFACE_ERROR_H
#define L3D_TESTS_BENCH_SURFACE_ERROR_H

#include "geom/step_bound.h"
#include "scene/camera.h"
#include "scene/dice_view.h"
#include "dice/diced_piece.h"
#include "scene/patch_model.h"

#include <algorithm>
#include <span>

/// Triangles and quads, ours and the peers', are sampled at the lattice of their fourths.
constexpr int error_lattice = 4;

/// Calls sample(p, q, r), the weights of a triangle's corners, for its lattice without corners.
template <class Sample> void for_triangle_lattice(Sample sample) {
    for (int i = 0; i <= error_lattice; ++i)
        for (int j = 0; i + j <= error_lattice; ++j) {
            const double p = i / double{error_lattice}, q = j / double{error_lattice};
            if (const double r = 1 - p - q; std::max({p, q, r}) < 1)
                sample(p, q, r);
        }
}

/// Image distances between drawn points inside the window and the exact points of the same
/// parameters. Units: pixels.
class surface_error {
public:
    surface_error(const l3d_camera& camera, l3d_size size);

    /// A drawn homogeneous point, against the patch's at (u, v).
    void add_point(const l3d_patch_model::patch& patch, const l3d_image_point& drawn, double u,
                   double v);

    double largest() const { return largest_; }

private:
    l3d_matrix<double> matrix_;
    l3d_image_box window_;
    double largest_ = 0;
};

/// Adds what a dicer made of a patch, snapped to subpixels: quads as bilinear pieces, and
/// triangles. Expects: pieces that have kept their parameters.
void add_pieces(surface_error& error, const l3d_patch_model::patch& patch,
                std::span<const l3d_diced_piece> pieces, const l3d_dice_view& view);

#endif
