// SPDX-License-Identifier: MIT
// l3d_method_tessellation: a mesh of fixed density, made without knowledge of the view.
#ifndef L3D_COMPARE_METHOD_TESSELLATION_H
#define L3D_COMPARE_METHOD_TESSELLATION_H

#include "scene/culling/scene_culling.h"
#include "pipeline/polygons/polygon_frame.h"
#include "pipeline/polygons/polygon_model.h"
#include "compare/scene_memory.h"
#include "pipeline/surface_method.h"
#include "raster/rasterizer_factory.h"
#include "raster/parallel/workers.h"

#include <cstddef>
#include <memory>
#include <vector>

/// A certified bound of the image error of a patch as n by n quads of two triangles. Their corners
/// are exact points of the patch, placed in double and snapped. Units: pixels.
///
/// The triangles may be clipped. At the near plane, the w of a chord is that of the plane. The
/// surface's w at the same parameters is at least this w less the chord's error; the bound divides
/// by it. The bound is infinity if n is too small for that.
/// Shape:   the net in the view's units.
/// Expects: n >= 1.
double l3d_tessellation_bound(const l3d_image_patch& net, const l3d_dice_view& view, int n);

/// Draws each patch as n by n quads of two triangles, from l3d_tessellated. They are drawn like any
/// other polygons, through l3d_polygon_frame and a depth buffer.
///
/// The polygons are made once, and again when models or placements of the scene change. The time
/// for making them, and for placing them in each frame, counts as `dice`.
/// Lives: borrows the workers.
/// Cost:  2 n^2 triangles a patch, 200 bytes each.
class l3d_method_tessellation final : public l3d_surface_method {
public:
    /// Expects: n >= 1.
    l3d_method_tessellation(int n, const l3d_rasterizer_factory& rasterizers, l3d_workers& workers)
        : n_(n), workers_(workers), surface_(rasterizers.create_surface(workers)) {}

private:
    void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) override;
    std::string do_renderer() const override { return surface_->describe(); }
    const l3d_dice_counts& do_counts() const override { return counts_; }
    const l3d_surface_counts& do_surface_counts() const override { return surface_->counts(); }

    void count_patches(const l3d_method_frame& frame);

    int n_;
    l3d_workers& workers_;
    std::unique_ptr<l3d_surface_rasterizer> surface_;
    l3d_scene_memory made_of_;
    l3d_polygon_model model_;                ///< the whole scene, in the world
    std::vector<std::size_t> face_ends_;     ///< ends of the patches' faces in model_
    std::vector<std::size_t> first_patches_; ///< numbers of the instances' first patches
    l3d_polygon_frame polygons_;
    l3d_scene_culling culling_;
    l3d_dice_counts counts_;
};

#endif
