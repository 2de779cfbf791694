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

/// Makes what draws points, lines and polygons, and what fills surfaces, both of one kind.
class L3D_PUBLIC l3d_rasterizer_factory {
public:
    l3d_rasterizer_factory() = default;
    l3d_rasterizer_factory(const l3d_rasterizer_factory&) = delete;
    l3d_rasterizer_factory& operator=(const l3d_rasterizer_factory&) = delete;
    virtual ~l3d_rasterizer_factory() = default;

    /// One line for --verbose on what draws; empty if that is the processors.
    /// Errors:  as create_2d.
    std::string describe() const { return do_describe(); }

    /// Makes what draws into these pixels; never null.
    /// Errors:  l3d_error(no_backend); a kind whose screen factory can serve throws none.
    std::unique_ptr<l3d_rasterizer_2d_imp> create_2d(l3d_pixels target) const {
        return do_create_2d(target);
    }

    /// Makes what fills surfaces; never null.
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

/// The kind of edges of polygons of one colour, and of lines.
enum class L3D_PUBLIC l3d_edges {
    hard,  ///< at whole pixels, as l3d_rasterizer_2d says
    smooth ///< as paths and smooth lines do, whatever call draws them
};

/// Serves every screen, since all of them have their pixels in memory.
class L3D_PUBLIC l3d_rasterizer_factory_sw final : public l3d_rasterizer_factory {
public:
    /// Makes rasterizers with these edges in two dimensions.
    explicit l3d_rasterizer_factory_sw(l3d_edges edges = l3d_edges::hard) : edges_(edges) {}

private:
    /// Errors:  none.
    std::unique_ptr<l3d_rasterizer_2d_imp> do_create_2d(l3d_pixels target) const override;

    /// Errors:  none.
    std::unique_ptr<l3d_surface_rasterizer> do_create_surface(l3d_workers& workers) const override;

    l3d_edges edges_;
};

/// Gives every rasterizer a GL context of its own; serves every screen, as GL's picture is copied
/// to the screen's pixels. A rasterizer belongs to the thread that made it.
class L3D_PUBLIC l3d_rasterizer_factory_mesa final : public l3d_rasterizer_factory {
public:
    /// Takes the GL of this library: auto, egl or osmesa; empty: what the environment variable
    /// L3D_MESA says. `auto` tries EGL first.
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
