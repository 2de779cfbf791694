// SPDX-License-Identifier: MIT
// l3d_pipeline_2d: the common part of programs that draw with the 2D rasterizer.
#ifndef L3D_PIPELINE_PIPELINE_2D_H
#define L3D_PIPELINE_PIPELINE_2D_H

#include "base/public.h"
#include "pipeline/pipeline.h"
#include "raster/rasterizer_factory.h"

#include <memory>

/// A pipeline that draws on a screen with a 2D rasterizer. The keys q and Escape end the program.
/// Pictures take the screen's new size when it changes.
///
/// A subclass overrides `draw`, and the calls of l3d_pipeline that it answers. If the subclass has
/// keys of its own, it passes all other keys to l3d_pipeline_2d::key_event.
/// Lives: owns screen and rasterizer.
class L3D_PUBLIC l3d_pipeline_2d : public l3d_pipeline {
public:
    /// A pipeline that draws on this canvas. Errors: as l3d_rasterizer_factory::create_2d.
    explicit l3d_pipeline_2d(l3d_canvas canvas);

    /// The screen that shows the pictures.
    l3d_screen& screen() { return *screen_; }
    /// The letters of the canvas, for text in pictures. Lives: copies of a font share a store of
    /// drawn letters, so only one thread may use them all.
    const l3d_font& font() const { return font_; }
    /// The picture's width and height, in pixels.
    l3d_size size() { return screen_->pixels().size(); }

    void key_event(int key) override;

    /// Draws into the screen's new pixels from now on. A subclass that overrides this function
    /// calls it first.
    void resize_event(l3d_size size) override;

    void draw_event() final;

protected:
    /// The rasterizer that `draw` gets.
    l3d_rasterizer_2d& rasterizer() { return rasterizer_; }

private:
    /// Draws a picture on top of the last one. The pixels are clear after a resize; call
    /// `clear_buffer` to draw on a clear picture each time.
    virtual void draw(l3d_rasterizer_2d& rasterizer) = 0;

    std::unique_ptr<l3d_screen> screen_;
    l3d_font font_;
    std::unique_ptr<l3d_rasterizer_2d_imp> imp_;
    l3d_rasterizer_2d rasterizer_;
};

#endif
