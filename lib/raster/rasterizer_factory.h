// SPDX-License-Identifier: MIT
// l3d_rasterizer_factory: makes the rasterizers of one kind: on the processors, or by OpenGL;
// l3d_canvas has them draw.
#ifndef L3D_RASTER_RASTERIZER_FACTORY_H
#define L3D_RASTER_RASTERIZER_FACTORY_H

#include "base/public.h"
#include "raster/rasterizer_2d.h"
#include "raster/surface_rasterizer.h"
#include "raster/parallel/workers.h"
#include "raster/text/font.h"
#include "tool_2d/screen.h"
#include "tool_2d/screen_memory.h"

#include <memory>
#include <string>
#include <utility>

/// Makes rasterizers of one kind: for points, lines and polygons in two dimensions, and for
/// surfaces.
class L3D_PUBLIC l3d_rasterizer_factory {
public:
    l3d_rasterizer_factory() = default;
    l3d_rasterizer_factory(const l3d_rasterizer_factory&) = delete;
    l3d_rasterizer_factory& operator=(const l3d_rasterizer_factory&) = delete;
    virtual ~l3d_rasterizer_factory() = default;

    /// Describes in one line, for --verbose, the library that draws, such as GL; empty if l3d
    /// itself draws.
    /// Errors:  as create_2d.
    std::string describe() const { return do_describe(); }

    /// Makes a rasterizer that draws points, lines and polygons into these pixels; never null.
    /// Errors:  l3d_error(no_backend); none from a factory that uses only the processors.
    std::unique_ptr<l3d_rasterizer_2d_imp> create_2d(l3d_pixels target) const {
        return do_create_2d(target);
    }

    /// Makes a rasterizer that fills surfaces; never null.
    /// Errors:  as create_2d.
    /// Lives:   borrows the workers.
    std::unique_ptr<l3d_surface_rasterizer> create_surface(l3d_workers& workers) const {
        return do_create_surface(workers);
    }

private:
    virtual std::string do_describe() const { return {}; }
    virtual std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const = 0;
    virtual std::unique_ptr<l3d_surface_rasterizer>
    do_create_surface(l3d_workers& workers) const = 0;
};

/// Whether lines and polygons of one colour get hard or smooth edges.
enum class L3D_PUBLIC l3d_edges {
    hard,  ///< each pixel is coloured wholly or not at all, as l3d_rasterizer_2d says
    smooth ///< as draw_path and draw_line_antialiased draw them, whichever function is called
};

/// Makes rasterizers that draw by the CPU into pixels in memory. They serve every screen, as every
/// screen has pixels in memory.
class L3D_PUBLIC l3d_rasterizer_factory_sw final : public l3d_rasterizer_factory {
public:
    /// Makes a factory whose two-dimensional rasterizers draw these edges.
    explicit l3d_rasterizer_factory_sw(l3d_edges edges = l3d_edges::hard) : edges_(edges) {}

private:
    /// Errors:  none.
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override;

    /// Errors:  none.
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers& workers) const override;

    l3d_edges edges_;
};

/// Makes rasterizers that use GL, each with a GL context of its own. They serve every screen, as
/// GL's picture is copied to the screen's pixels. A rasterizer belongs to the thread that made it.
class L3D_PUBLIC l3d_rasterizer_factory_mesa final : public l3d_rasterizer_factory {
public:
    /// Takes the name of the GL library: auto, egl or osmesa. An empty name takes the name in the
    /// environment variable L3D_MESA. `auto` tries EGL first.
    explicit l3d_rasterizer_factory_mesa(std::string library = {}) : library_(std::move(library)) {}

private:
    /// Errors:  l3d_error(no_backend) with the reasons, if there is no software GL.
    std::string do_describe() const override;

    /// Errors:  l3d_error(no_backend) with the reasons, if there is no software GL.
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override;

    /// Errors:  l3d_error(no_backend) with the reasons, if there is no software GL.
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers& workers) const override;

    std::string library_;
};

/// A screen and a factory of the rasterizers that draw on it. A canvas is the first argument of
/// every pipeline.
///
/// Expects: neither is null.
/// Lives:   owns the screen, shares the factory.
struct L3D_PUBLIC l3d_canvas {
    std::unique_ptr<l3d_screen> screen; ///< shows the pictures; rasterizers draw into its pixels
    /// Makes rasterizers for the screen's pixels.
    std::shared_ptr<const l3d_rasterizer_factory> rasterizers;
    l3d_font font{}; ///< the letters of panels and status lines
    /// Whether lessons look as in the book that they come from: with hard edges, letters made of
    /// dots and a black ground.
    bool is_classic = false;
};

/// Makes a canvas of pixels in memory, drawn by the CPU: for programs without a window. Text has
/// the letters of this machine, l3d_font::of_system. Replace the font to get the same picture on
/// every machine.
/// Expects: a width and height of at least 1.
L3D_PUBLIC l3d_canvas l3d_memory_canvas(l3d_size size);

/// Makes a canvas of the caller's memory, such as an image that a toolkit shows. Pictures are drawn
/// directly into this memory.
/// Expects: as l3d_screen_memory.
L3D_PUBLIC l3d_canvas l3d_memory_canvas(const l3d_pixels& words);

/// Makes a canvas of the caller's memory in another layout. The memory holds the picture after
/// `screen().show()`.
/// Expects: as l3d_screen_memory.
L3D_PUBLIC l3d_canvas l3d_memory_canvas(const l3d_packed_pixels& packed);

#endif
