// SPDX-License-Identifier: MIT
// l3d_pipeline_world: a world to fly through by the keys of the book's programs.
#ifndef L3D_PIPELINE_WORLDS_PIPELINE_WORLD_H
#define L3D_PIPELINE_WORLDS_PIPELINE_WORLD_H

#include "base/public.h"
#include "pipeline/pipeline.h"
#include "pipeline/lesson.h"
#include "pipeline/worlds/world.h"
#include "raster/parallel/workers.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// Rows for a program's caption: the keys and the mouse of l3d_pipeline_world.
L3D_PUBLIC std::vector<l3d_caption_row> l3d_world_keys();

/// Shows a world and lets time pass in it; the user flies through the world by keys and mouse.
///
/// If the world's order is `by_depth`, a surface rasterizer of the canvas's factory fills the
/// polygons. The rasterizer has as many threads as the world's settings `surfaces` ask for when the
/// first frame is drawn by depth. If the user stops the world, it is frozen, and the camera can
/// still fly.
class L3D_PUBLIC l3d_pipeline_world : public l3d_lesson {
public:
    /// A function that makes a world for pictures of the given size.
    using maker = std::function<std::unique_ptr<l3d_world>(l3d_size)>;

    /// Shows this world on this canvas. The user cannot start the world again. Errors: as
    /// l3d_pipeline_2d.
    /// Lives: borrows the world.
    l3d_pipeline_world(l3d_canvas canvas, l3d_world& world);

    /// Shows a world that `make` makes: now, and anew whenever the user starts again. If the canvas
    /// is not classic, a world whose order is far_first is drawn by depth instead. Polygons then
    /// have smooth edges, on the dark ground of lessons.
    /// Errors: as l3d_pipeline_2d; exceptions of `make`.
    l3d_pipeline_world(l3d_canvas canvas, maker make);

    void key_event(int key) override;
    void resize_event(l3d_size size) override;
    bool skip_event() override { return true; }
    /// Whether the world is stopped and the camera stands still. A subclass in which further things
    /// move overrides this function.
    bool is_at_rest() const override { return world_->frozen && !world_->camera.moves(); }
    std::string message() const override;

protected:
    /// Draws on top of the world's picture, such as instruments. The lines of status are drawn
    /// afterwards. A subclass that overrides this function need not call it.
    virtual void draw_overlay(l3d_rasterizer_2d& /*rasterizer*/) {}

private:
    l3d_pipeline_world(std::shared_ptr<const l3d_rasterizer_factory> rasterizers,
                       l3d_canvas&& canvas, l3d_world* world, maker make);

    bool turn_key(int key);
    bool thrust_key(int key);
    bool look_key(int key);
    void draw_lesson(l3d_rasterizer_2d& rasterizer) override;
    void advance(double seconds) override;
    void restart() override;
    void drag(int x, int y, int right, int down) override;
    void roll(int notches) override;
    void make_world();
    void draw_status(l3d_rasterizer_2d& rasterizer);
    std::vector<std::string> status() const;

    maker make_;                     ///< makes the world; empty if the world is borrowed
    std::unique_ptr<l3d_world> own_; ///< the world that make_ made
    l3d_world* world_;
    std::shared_ptr<const l3d_rasterizer_factory> rasterizers_;
    std::unique_ptr<l3d_workers> workers_;
    std::unique_ptr<l3d_surface_rasterizer> surfaces_; // after workers_, which it borrows
    l3d_size seen_size_;
    bool status_shown_ = false;
    std::size_t drawn_ = 0; ///< number of polygons in the last picture
    int frames_ = 0;        ///< number of frames since the frame rate was last computed
    double seconds_ = 0;
    double frame_rate_ = 0;
};

#endif
