// SPDX-License-Identifier: MIT
// l3d_pipeline_2d: the common part of programs that draw with the 2D rasterizer.
#ifndef L3D_PIPELINE_PIPELINE_2D_H
#define L3D_PIPELINE_PIPELINE_2D_H

#include "base/public.h"
#include "pipeline/pipeline.h"
#include "raster/rasterizer_factory.h"

#include <memory>

/// A pipeline that draws on a screen with a 2D rasterizer. The keys q and Escape end it, and it
/// follows changes of the screen's size.
///
/// A subclass overrides `draw`, and the calls of l3d_pipeline that it answers. If it has keys of
/// its own, it passes all others to l3d_pipeline_2d::key_event.
/// Lives: owns screen and rasterizer.
class L3D_PUBLIC l3d_pipeline_2d : public l3d_pipeline {
public:
    /// A pipeline that draws on this canvas. Errors: as l3d_rasterizer_factory::create_2d.
    explicit l3d_pipeline_2d(l3d_canvas canvas);

    /// The screen that shows the pictures.
    l3d_screen& screen() { return *screen_; }
    /// The canvas's letters. Lives: copies share the letters drawn so far, so all belong to one
    /// thread.
    const l3d_font& font() const { return font_; }
    /// The picture's width and height, in pixels.
    l3d_size size() { return screen_->pixels().size(); }

    void key_event(int key) override;

    /// Takes the new pixels; a subclass that overrides this calls it first.
    void resize_event(l3d_size size) override;

    void draw_event() final;

protected:
    /// The rasterizer that `draw` gets.
    l3d_rasterizer_2d& rasterizer() { return rasterizer_; }

private:
    /// Draws a picture. The last picture lies below it, unless `clear_buffer` or a resize cleared
    /// that.
    virtual void draw(l3d_rasterizer_2d& rasterizer) = 0;

    std::unique_ptr<l3d_screen> screen_;
    l3d_font font_;
    std::unique_ptr<l3d_rasterizer_2d_imp> imp_;
    l3d_rasterizer_2d rasterizer_;
};

#endif
