// SPDX-License-Identifier: MIT
// l3d_method_voxels: a scene in a cubic frame buffer, looked into by rays.
#ifndef L3D_COMPARE_METHOD_VOXELS_H
#define L3D_COMPARE_METHOD_VOXELS_H

#include "compare/scene_memory.h"
#include "pipeline/surface_method.h"
#include "compare/cells/cubic_frame_buffer.h"
#include "compare/plotters/point_canvas.h"
#include "raster/parallel/workers.h"
#include "geom/normal_net.h"

#include <cstddef>
#include <vector>

/// Fills a cube of cells around the scene by forward differences in l3d_real, with points half a
/// cell apart. Then it sends a ray through every pixel. The filled cells depend on the scene alone.
/// They are kept until the scene changes. Filling counts as `dice` in the first frame.
///
/// A pixel gets the depth of the middle of the first filled cell on its ray. The error is up to a
/// cell's diagonal as seen there. Rays may slip between filled cells, since the points are half a
/// cell apart; so there is no bound.
/// Expects: models do not change while the method lives.
/// Lives:   borrows the workers.
class l3d_method_voxels final : public l3d_surface_method {
public:
    /// Expects: as l3d_cubic_frame_buffer::reset.
    l3d_method_voxels(int resolution, l3d_workers& workers)
        : workers_(workers), resolution_(resolution),
          canvases_(static_cast<std::size_t>(workers.count())) {}

    /// The cells of the last frame's scene.
    const l3d_cubic_frame_buffer& cube() const { return cube_; }

    /// Converts a place in the world to cells.
    l3d_patch_model::vector in_cells(const l3d_patch_model::vector& at) const {
        return (at - corner_) * cells_per_unit_;
    }

private:
    void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) override;
    const l3d_dice_counts& do_counts() const override { return counts_; }
    const l3d_surface_counts& do_surface_counts() const override { return surface_counts_; }

    void fill(const l3d_patch_scene& scene);
    void fill(const l3d_patch_model::patch& in_cells, const l3d_normal_net& normals);
    void look_along(int row, const l3d_method_frame& frame, const l3d_patch_model::vector& eye,
                    l3d_point_canvas& canvas) const;

    l3d_workers& workers_;
    int resolution_;
    l3d_cubic_frame_buffer cube_;
    l3d_patch_model::vector corner_{0.0, 0.0, 0.0}; ///< corner of the cube, in the world
    double cells_per_unit_ = 1;
    l3d_scene_memory filled_with_;
    std::vector<l3d_point_canvas> canvases_;
    l3d_dice_counts counts_;
    l3d_surface_counts surface_counts_;
};

#endif
