// SPDX-License-Identifier: MIT
// How far drawn surfaces are from the exact ones, measured alike for ours and the peers'.
#ifndef L3D_TESTS_BENCH_SURFACE_ERROR_H
#define L3D_TESTS_BENCH_SURFACE_ERROR_H

#include "geom/step_bound.h"
#include "dice/camera.h"
#include "dice/dice_view.h"
#include "dice/diced_piece.h"
#include "dice/patch_model.h"

#include <span>

/// Image distances between drawn points inside the window and the exact points of the same
/// parameters. Units: pixels.
class surface_error {
public:
    surface_error(const l3d_camera& camera, l3d_size size);

    /// A triangle of exact points at (u, v) of each corner, as a peer draws it; sampled at edge
    /// middles and the centre.
    void add_triangle(const l3d_patch_model::patch& patch, const double (&u)[3],
                      const double (&v)[3]);

    /// A drawn homogeneous point, against the patch's at (u, v).
    void add_point(const l3d_patch_model::patch& patch, const l3d_image_point& drawn, double u,
                   double v);

    double largest() const { return largest_; }
    double mean() const { return count_ ? sum_ / static_cast<double>(count_) : 0; }

private:
    l3d_image_point exact(const l3d_patch_model::patch& patch, double u, double v) const;

    l3d_matrix<double> matrix_;
    l3d_image_box window_;
    double largest_ = 0, sum_ = 0;
    long count_ = 0;
};

/// Adds what a dicer made of a patch: quads as bilinear pieces, and triangles.
/// Expects: pieces that have kept their parameters.
void add_pieces(surface_error& error, const l3d_patch_model::patch& patch,
                std::span<const l3d_diced_piece> pieces, const l3d_dice_view& view);

#endif
