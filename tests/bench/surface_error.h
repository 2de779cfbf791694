// SPDX-License-Identifier: MIT
// How far drawn surfaces are from the exact ones, measured alike for ours and the peers'.
#ifndef L3D_TESTS_BENCH_SURFACE_ERROR_H
#define L3D_TESTS_BENCH_SURFACE_ERROR_H

#include "geom/step_bound.h"
#include "pipeline/camera.h"
#include "pipeline/dice_sink.h"
#include "pipeline/dice_view.h"
#include "pipeline/patch_model.h"

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

/// Measures what a dicer makes of one patch at a time: quads as bilinear pieces, and triangles.
class measuring_sink final : public l3d_dice_sink {
public:
    measuring_sink(surface_error& error, const l3d_dice_view& view) : error_(error), view_(view) {}
    void set_patch(const l3d_patch_model::patch& patch) { patch_ = &patch; }

private:
    void do_grid(const l3d_dice_grid& grid) override;
    void do_triangles(std::span<const l3d_dice_vertex> corners, double bound) override;
    l3d_image_point placed(const l3d_micro_vertex& vertex) const;

    surface_error& error_;
    const l3d_dice_view& view_;
    const l3d_patch_model::patch* patch_ = nullptr;
};

#endif
