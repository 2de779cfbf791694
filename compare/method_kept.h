// SPDX-License-Identifier: MIT
// l3d_method_kept: micropolygons that later frames find in buffers.
#ifndef L3D_COMPARE_METHOD_KEPT_H
#define L3D_COMPARE_METHOD_KEPT_H

#include "compare/method_patches.h"
#include "compare/scene_memory.h"
#include "geom/patch_part.h"
#include "dice/normal_columns.h"
#include "pipeline/surface_method.h"
#include "raster/parallel/workers.h"
#include "raster/rasterizer_factory.h"
#include "raster/surface_part.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

/// Micropolygon grids of one patch, which are kept from frame to frame: places in the model's
/// space, and normals.
class l3d_kept_micropolygons {
public:
    /// Sets the largest number of quads along a pixel. Expects: >= 1.
    explicit l3d_kept_micropolygons(int quads_a_pixel = 2) : quads_a_pixel_(quads_a_pixel) {}

    /// Puts the patch's quads into the image. It dices pieces without a grid, and pieces whose
    /// quads have grown beyond their size or shrunk below a quarter of it. Grids that the frame
    /// does not need are dropped.
    /// Expects: the same surface and normals each time; l3d_needs_no_clipping.
    void draw(const l3d_method_patch& patch, const l3d_dice_view& view, l3d_dice_counts& counts);

    /// Drops all grids.
    void clear() { grids_.clear(); }

    /// Adds the grids of the last draw to `parts`. Lives: until the next draw.
    void add_to(std::vector<const l3d_surface_part*>& parts) const;

    /// The memory that all grids take, in bytes.
    std::size_t bytes() const;

private:
    struct kept_grid {
        double u0, u1, v0, v1; ///< the part of the patch
        std::array<std::vector<float>, 3> place;
        l3d_surface_part part;
        bool is_used = true;

        int steps_u() const { return part.grid.columns - 1; }
        int steps_v() const { return part.grid.rows - 1; }
    };
    struct task {
        const l3d_method_patch& patch;
        const l3d_dice_view& view;
        l3d_dice_counts& counts;
        int cuts_left;
    };

    void visit(const l3d_patch_part& p, task& of);
    kept_grid* find(const l3d_patch_part& p) const;

    /// The first grid found that earlier frames have kept for a part of a piece. There is none, or
    /// it is narrower than the piece along u, or only shorter along v.
    enum class parts_kept { none, narrower, shorter };
    parts_kept parts_inside(const l3d_patch_part& p) const;
    void dice(kept_grid& grid, const l3d_method_patch& patch, int steps_u, int steps_v);
    static void project(kept_grid& grid, const task& of);

    int quads_a_pixel_;
    std::vector<std::unique_ptr<kept_grid>> grids_;
    l3d_normal_columns columns_;
};

/// Draws micropolygons that are diced once and then only transformed in each frame, until their
/// size no longer fits. A piece is diced a quarter finer than it must be, so that its image may
/// grow for a while.
///
/// A picture also depends on the frames before it, since kept grids may be finer than new ones.
/// Pieces meet without edge polylines, as in the paper, so there is no bound. If an instance moves,
/// its grids are diced anew. Grids of parts of a piece stay until one grid for the whole piece
/// would have at most half of a grid's size.
/// Cost:    23 ns a quad with filling in a frame that dices nothing; 63 ns by
///          l3d_micropolygon_dicer. Some 53 bytes a quad.
/// Source:  Cook, Carpenter, Catmull, The Reyes Image Rendering Architecture, SIGGRAPH 1987, with
///          buffers kept between frames.
class l3d_method_kept final : public l3d_surface_method {
public:
    /// Lives: borrows the workers.
    l3d_method_kept(int quads_a_pixel, const l3d_rasterizer_factory& rasterizers,
                    l3d_workers& workers);

    /// The memory that all grids take, in bytes.
    std::size_t bytes() const;

private:
    void do_draw(const l3d_method_frame& frame, l3d_stage_times& times) override;
    std::string do_renderer() const override { return surface_->describe(); }
    const l3d_dice_counts& do_counts() const override { return patches_.counts(); }
    const l3d_surface_counts& do_surface_counts() const override { return surface_->counts(); }

    int quads_a_pixel_;
    std::unique_ptr<l3d_surface_rasterizer> surface_;
    l3d_method_patches patches_;
    l3d_scene_memory diced_of_;
    /// The grids by instance and patch.
    std::vector<std::vector<l3d_kept_micropolygons>> kept_;
    std::vector<std::vector<char>> is_seen_;
    std::vector<const l3d_surface_part*> parts_;
};

#endif
