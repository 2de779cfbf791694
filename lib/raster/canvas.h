// SPDX-License-Identifier: MIT
// l3d_canvas: a pipeline's screen, rasterizers and font.
#ifndef L3D_RASTER_CANVAS_H
#define L3D_RASTER_CANVAS_H

#include "base/public.h"
#include "raster/rasterizer_factory.h"
#include "raster/text/font.h"
#include "tool_2d/screen.h"
#include "tool_2d/screen_memory.h"

#include <memory>

/// A screen and a factory of the rasterizers that draw on it. Every pipeline takes one first.
///
/// Expects: neither is null.
/// Lives:   owns the screen, shares the factory.
struct L3D_PUBLIC l3d_canvas {
    std::unique_ptr<l3d_screen> screen; ///< shows the pictures; its pixels are drawn into
    std::shared_ptr<const l3d_rasterizer_factory> rasterizers; ///< for its pixels
    l3d_font font{}; ///< the letters of panels and status lines
    /// Whether lessons draw as the book does: hard edges, letters of dots, a black ground.
    bool is_classic = false;
};

/// Pixels in memory, drawn by the CPU: for programs without a window. Text has the letters of this
/// machine, l3d_font::of_system; for the same picture on every machine, replace the font.
/// Expects: a width and height of at least 1.
L3D_PUBLIC l3d_canvas l3d_memory_canvas(l3d_size size);

/// The same for memory of one's own, such as an image that a toolkit shows: pictures are drawn
/// right into these words.
/// Expects: as l3d_screen_memory.
L3D_PUBLIC l3d_canvas l3d_memory_canvas(const l3d_pixels& words);

/// The same for pixels of another layout. They hold the picture after `screen().show()`.
/// Expects: as l3d_screen_memory.
L3D_PUBLIC l3d_canvas l3d_memory_canvas(const l3d_packed_pixels& packed);

#endif
