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

/// Rows for a program's caption: the keys of a world, and the mouse.
L3D_PUBLIC std::vector<l3d_caption_row> l3d_world_keys();

/// Shows a world, lets time pass in it, and flies through it by keys.
///
/// A world whose order is `by_depth` is filled by a surface rasterizer of the canvas's factory. It
/// has as many threads as the world's `surfaces` ask for when the first such frame is drawn. If the
/// user stops it, the world is frozen, and the camera can still fly.
class L3D_PUBLIC l3d_pipeline_world : public l3d_lesson {
public:
    /// Makes a world for pictures of a size.
    using maker = std::function<std::unique_ptr<l3d_world>(l3d_size)>;

    /// Shows this world on that canvas. The user cannot start it again. Errors: as l3d_pipeline_2d.
    /// Lives: borrows the world.
    l3d_pipeline_world(l3d_canvas canvas, l3d_world& world);

    /// Shows a world that `make` makes, now and whenever the user starts again. If the canvas is
    /// not classic, a world of the order far_first is drawn by depth instead. It then has smooth
    /// edges, on the dark ground of lessons.
    /// Errors: as l3d_pipeline_2d; exceptions of `make`.
    l3d_pipeline_world(l3d_canvas canvas, maker make);

    void key_event(int key) override;
    void resize_event(l3d_size size) override;
    bool skip_event() override { return true; }
    /// Whether the world is stopped and the camera stands still. A subclass with further motion
    /// overrides it.
    bool is_at_rest() const override { return world_->frozen && !world_->camera.moves(); }
    std::string message() const override;

protected:
    /// Draws on top of the world's picture, such as instruments. The status lines come after it. A
    /// subclass that overrides it need not call this one.
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

    maker make_;                     ///< none for a world that is borrowed
    std::unique_ptr<l3d_world> own_; ///< the world that make_ made
    l3d_world* world_;
    std::shared_ptr<const l3d_rasterizer_factory> rasterizers_;
    std::unique_ptr<l3d_workers> workers_;
    std::unique_ptr<l3d_surface_rasterizer> surfaces_; // after workers_, which it borrows
    l3d_size seen_size_;
    bool status_shown_ = false;
    std::size_t drawn_ = 0; ///< polygons in the last picture
    int frames_ = 0;        ///< frames since the frame rate was last computed
    double seconds_ = 0;
    double frame_rate_ = 0;
};

#endif
