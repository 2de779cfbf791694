// SPDX-License-Identifier: MIT
// l3d_surface_rasterizer: fills micro-quads and triangles with depth and shading.
#ifndef L3D_RASTER_SURFACE_RASTERIZER_H
#define L3D_RASTER_SURFACE_RASTERIZER_H

#include "raster/depth_buffer.h"
#include "raster/micro_grid.h"
#include "tool_2d/pixels.h"

#include <array>
#include <cstdint>
#include <span>

/// How a surface's pixels get their colour.
enum class l3d_shade {
    lambert, ///< per-pixel unit normal; grey level round(255 (0.1 + 0.9 max(0, n.l)))
    gouraud, ///< the same grey level per vertex, interpolated
    flat,    ///< one grey level per quad, from the mean of its normals
    normals, ///< red, green, blue = round(255 (n + 1) / 2)
    error,   ///< one colour per draw call, from `error_color`
};

/// What stays the same for a frame.
struct l3d_shading {
    l3d_shade mode = l3d_shade::lambert;
    std::array<float, 3> light{0, 0, 1}; ///< unit vector towards the light, world space

    /// From the eye through the picture's top left corner, and what a pixel to the right and one
    /// down add to that. World space, any length.
    std::array<float, 3> ray{0, 0, -1}, ray_right{}, ray_down{};
};

/// What one frame cost.
struct l3d_surface_counts {
    std::int64_t quads = 0;   ///< micro-quads and triangles handed in
    std::int64_t samples = 0; ///< pixel centres tested against the depth buffer
    std::int64_t written = 0; ///< of those, nearer than what was there
};

/// Fills surfaces into a picture and a depth buffer of the same size.
///
/// A pixel belongs to a polygon if its centre (x + 1/2, y + 1/2) is inside, or on a left or top
/// edge; vertices are exact 1/256 pixel integers and the rule is evaluated exactly, so polygons
/// that share an edge cover each pixel once: no gap, no double hit. Surfaces are two-sided:
/// normals are turned to the eye.
/// The nearer (larger inv_w) sample wins; of equals, the first.
class l3d_surface_rasterizer {
public:
    l3d_surface_rasterizer() = default;
    l3d_surface_rasterizer(const l3d_surface_rasterizer&) = delete;
    l3d_surface_rasterizer& operator=(const l3d_surface_rasterizer&) = delete;
    virtual ~l3d_surface_rasterizer() = default;

    /// Starts a frame. Expects: target and depth of equal size; both outlive the frame.
    void begin(l3d_pixels target, l3d_depth_buffer& depth, const l3d_shading& shading) {
        do_begin(target, depth, shading);
    }

    /// Colour of everything drawn from now on in mode `error`. Units: a pixel word.
    void set_error_color(std::uint32_t color) { do_set_error_color(color); }

    /// Fills the (rows - 1) x (columns - 1) quads of a grid. Convex quads are covered as such,
    /// folded ones as four triangles around their projective centre.
    void draw_grid(const l3d_micro_grid& grid) { do_draw_grid(grid); }

    /// Fills one triangle.
    void draw_triangle(const l3d_micro_vertex& a, const l3d_micro_vertex& b,
                       const l3d_micro_vertex& c) {
        do_draw_triangle(a, b, c);
    }

    /// What was drawn so far is in the target's pixels and depth afterwards. Call it before anybody
    /// else reads or writes them.
    void finish() { do_finish(); }

    /// What has been drawn between begin and the last finish.
    const l3d_surface_counts& counts() const { return do_counts(); }

private:
    virtual void do_begin(l3d_pixels, l3d_depth_buffer&, const l3d_shading&) = 0;
    virtual void do_set_error_color(std::uint32_t color) = 0;
    virtual void do_draw_grid(const l3d_micro_grid&) = 0;
    virtual void do_draw_triangle(const l3d_micro_vertex&, const l3d_micro_vertex&,
                                  const l3d_micro_vertex&) = 0;
    virtual void do_finish() {}
    virtual const l3d_surface_counts& do_counts() const = 0;
};

#endif
