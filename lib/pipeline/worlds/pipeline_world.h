// SPDX-License-Identifier: MIT
// l3d_pipeline_world: a world one can fly through: the keys of the book's programs.
#ifndef L3D_PIPELINE_WORLDS_PIPELINE_WORLD_H
#define L3D_PIPELINE_WORLDS_PIPELINE_WORLD_H

#include "base/public.h"
#include "pipeline/caption.h"
#include "pipeline/pipeline_2d.h"
#include "pipeline/worlds/world.h"
#include "raster/parallel/workers.h"

#include <cstddef>
#include <memory>
#include <vector>

/// The keys, for a program's caption.
L3D_PUBLIC std::vector<l3d_caption_row> l3d_world_keys();

/// Keys, time and pictures of a world.
///
/// A world whose order is `by_depth` is filled by a surface rasterizer of the canvas's factory,
/// with as many threads as the world's `surfaces` ask for when the first such frame is drawn.
/// Lives:   borrows the world.
class L3D_PUBLIC l3d_pipeline_world : public l3d_pipeline_2d {
public:
    /// Shows this world on that canvas. Errors: as l3d_pipeline_2d.
    l3d_pipeline_world(l3d_canvas canvas, l3d_world& world);

    void any_event(const l3d_event& event) override;
    void key_event(int key) override;
    void resize_event(l3d_size size) override;
    void update_event(double seconds) override;
    bool skip_event() override { return true; }
    /// Whether the world is stopped and the camera stands still. A subclass in which more moves
    /// overrides it.
    bool is_at_rest() const override { return world_.frozen && !world_.camera.moves(); }
    bool needs_redraw() const override { return is_stale_; }

protected:
    /// Draws what lies over the picture of the world, such as instruments. The status lines come
    /// after it. A subclass that overrides it need not call this one.
    virtual void draw_overlay(l3d_rasterizer_2d& /*rasterizer*/) {}

private:
    l3d_pipeline_world(std::shared_ptr<const l3d_rasterizer_factory> rasterizers,
                       l3d_canvas&& canvas, l3d_world& world);

    bool turn_key(int key);
    bool thrust_key(int key);
    bool look_key(int key);
    void draw(l3d_rasterizer_2d& rasterizer) override;
    void draw_status(l3d_rasterizer_2d& rasterizer, std::size_t drawn);

    l3d_world& world_;
    std::shared_ptr<const l3d_rasterizer_factory> rasterizers_;
    std::unique_ptr<l3d_workers> workers_;
    std::unique_ptr<l3d_surface_rasterizer> surfaces_; // after workers_, which it borrows
    l3d_size seen_size_;
    bool status_shown_ = false;
    bool is_stale_ = true; ///< the picture may be another one than that which was drawn
    int frames_ = 0;       ///< since the frame rate was last computed
    double seconds_ = 0;
    double frame_rate_ = 0;
};

#endif
