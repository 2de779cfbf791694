// SPDX-License-Identifier: MIT
// l3d_canvas: what a pipeline draws on, and what draws.
#ifndef L3D_RASTER_CANVAS_H
#define L3D_RASTER_CANVAS_H

#include "base/public.h"
#include "raster/rasterizer_factory.h"
#include "tool_2d/screen.h"

#include <memory>

/// A screen and a factory of the rasterizers that draw on it. Every pipeline takes one first.
///
/// Expects: neither is null.
/// Lives:   owns the screen, shares the factory.
struct L3D_PUBLIC l3d_canvas {
    std::unique_ptr<l3d_screen> screen; ///< where pictures are shown; its pixels are drawn into
    std::shared_ptr<const l3d_rasterizer_factory> rasterizers; ///< makes what draws into them
    /// Whether lessons draw as the book does: hard edges, letters of dots, a black ground.
    bool is_classic = false;
};

/// Pixels in memory, drawn by the CPU: for programs without a window.
/// Expects: a width and height of at least 1.
L3D_PUBLIC l3d_canvas l3d_memory_canvas(l3d_size size);

#endif
