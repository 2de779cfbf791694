// SPDX-License-Identifier: MIT
// l3d_lesson: the common part of the book's programs.
#ifndef L3D_PIPELINE_LESSON_H
#define L3D_PIPELINE_LESSON_H

#include "base/public.h"
#include "pipeline/pipeline.h"
#include "pipeline/pipeline_2d.h"
#include "raster/background.h"

#include <cstdint>
#include <string>
#include <vector>

/// Rows for a program's caption: the keys of every lesson, and a row for dragging with the mouse.
/// `dragging` describes the effect of a drag.
L3D_PUBLIC std::vector<l3d_caption_row> l3d_lesson_keys(const std::string& dragging);

/// A pipeline of a world in which time passes: the common part of the book's lessons. The user can
/// stop time, start the lesson again, and drag the world with the mouse.
///
/// Pictures have a dark ground, or a black one if the canvas is classic. A subclass draws on top of
/// the last picture, or calls clear() first.
/// Lives: owns screen and rasterizer.
class L3D_PUBLIC l3d_lesson : public l3d_pipeline_2d {
public:
    /// A lesson on this canvas. Errors: as l3d_pipeline_2d.
    explicit l3d_lesson(l3d_canvas canvas);

    void any_event(const l3d_event& event) override;
    void key_event(int key) override;
    void pointer_event(const l3d_event& event) override;
    void resize_event(l3d_size size) override;
    void update_event(double seconds) override;
    bool is_at_rest() const override { return stopped_; }
    bool needs_redraw() const override { return is_stale_; }
    std::string message() const override;

protected:
    /// Whether pictures look like those of the book: hard edges, letters of dots, a black ground.
    bool is_classic() const { return is_classic_; }

    /// The background where nothing is drawn. Before a call of set_ground it is dark, or black if
    /// pictures are classic.
    const l3d_background& ground() const { return ground_; }
    /// Changes the ground that clear() draws from now on. The last picture keeps its ground until
    /// clear() is called.
    void set_ground(const l3d_background& ground) { ground_ = ground; }
    /// Covers the whole picture with the ground.
    void clear(l3d_rasterizer_2d& rasterizer);

    /// Stops the lesson, or lets it go on.
    void set_stopped(bool stopped) { stopped_ = stopped; }
    /// Whether the lesson is stopped.
    bool is_stopped() const { return stopped_; }

private:
    /// Draws the next picture on top of the last one. The first picture after a start, the key r or
    /// a resize lies on the bare ground.
    virtual void draw_lesson(l3d_rasterizer_2d& rasterizer) = 0;
    /// Lets time pass in the lesson's world. Called once per frame, unless the lesson is stopped.
    /// Units: seconds.
    virtual void advance(double seconds) = 0;
    /// Puts the lesson's world back to its beginning. Called at the key r.
    virtual void restart() = 0;
    /// Called when the pointer moves while the first mouse button is held. It is also called when
    /// the user presses this button, then with a motion of 0. The pointer is at (x, y) and has
    /// moved by (right, down).
    /// Units: pixels.
    virtual void drag(int x, int y, int right, int down);
    /// Called when the mouse wheel turns. `notches` are positive if the wheel turns away from the
    /// user.
    virtual void roll(int notches);

    l3d_lesson(bool is_classic, l3d_canvas&& canvas);

    void draw(l3d_rasterizer_2d& rasterizer) final;

    bool is_classic_;
    l3d_background ground_;
    bool stopped_ = false;
    bool is_stale_ = true; ///< whether the next picture may differ from the last picture
    bool is_bare_ = true;  ///< whether there is no last picture to draw on
    bool is_held_ = false; ///< whether the first mouse button is held
    int x_ = 0, y_ = 0;    ///< the pointer's last place
};

#endif
