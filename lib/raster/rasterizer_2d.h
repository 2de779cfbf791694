// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d: points, lines and flat polygons; and the bridge to what draws them.
#ifndef L3D_RASTER_RASTERIZER_2D_H
#define L3D_RASTER_RASTERIZER_2D_H

#include "tool_2d/pixels.h"

#include <cstdint>
#include <span>

/// A corner of a polygon. Units: pixels; pixel (x, y) is sampled at the position (x, y).
struct l3d_point_2d {
    double x = 0, y = 0;
};

/// A line between two pixels.
struct l3d_line_2d {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// What a kind of output must do to draw; programs hold the l3d_rasterizer_2d in front of it.
class l3d_rasterizer_2d_imp {
public:
    l3d_rasterizer_2d_imp() = default;
    l3d_rasterizer_2d_imp(const l3d_rasterizer_2d_imp&) = delete;
    l3d_rasterizer_2d_imp& operator=(const l3d_rasterizer_2d_imp&) = delete;
    virtual ~l3d_rasterizer_2d_imp() = default;

    /// Draws into these pixels from now on; call it after every resize. Drawing that was not
    /// finished is lost.
    /// Lives: borrows the pixels until the next call.
    void set_target(l3d_pixels target) { do_set_target(target); }

private:
    friend class l3d_rasterizer_2d;

    virtual void do_set_target(l3d_pixels target) = 0;
    virtual void do_finish() {}
    virtual void do_clear_buffer() = 0;
    virtual void do_draw_point(int x, int y, std::uint32_t color) = 0;
    virtual void do_draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) = 0;
    virtual void do_draw_polygon_flatshaded(std::span<const l3d_point_2d> corners,
                                            std::uint32_t color) = 0;
};

/// Draws points, lines and flat polygons; says nothing about where the pixels are.
///
/// Units:   whole coordinates name pixels, (0, 0) the top left one, y down; a colour is a pixel
///          word, 0x00RRGGBB. All is clipped to the target; no coordinate is a fault.
/// Lives:   borrows the implementation, which must outlive it.
class l3d_rasterizer_2d {
public:
    explicit l3d_rasterizer_2d(l3d_rasterizer_2d_imp& imp) : imp_(imp) {}

    /// Makes every pixel 0, black.
    void clear_buffer() { imp_.do_clear_buffer(); }

    void draw_point(int x, int y, std::uint32_t color) { imp_.do_draw_point(x, y, color); }

    /// Draws a line, both ends included: for each step along the longer axis (x if both are equally
    /// long) the pixel nearest to the ideal line; of two equally near, the upper or left one.
    /// The same pixels in both directions; clipped, exactly those of them that are in the target.
    void draw_line(int x0, int y0, int x1, int y1, std::uint32_t color) {
        const l3d_line_2d line{x0, y0, x1, y1};
        imp_.do_draw_lines({&line, 1}, color);
    }

    /// Draws many lines with one call across the bridge.
    void draw_lines(std::span<const l3d_line_2d> lines, std::uint32_t color) {
        imp_.do_draw_lines(lines, color);
    }

    /// Fills a polygon: the pixels (x, y) inside it, or on a left or top edge of it.
    ///
    /// Corners are rounded to 1/256 pixel; the rule is then exact, so polygons that share an edge
    /// cover each pixel once. A point of a picture whose pixels are sampled at their centres (as
    /// surfaces are) is half a pixel less here in x and y.
    /// Expects: convex, either winding. Fewer than three corners or no area draws nothing, and so
    ///          does a corner that is not a number or further than 2^20 pixels from the first
    ///          pixel.
    void draw_polygon_flatshaded(std::span<const l3d_point_2d> corners, std::uint32_t color) {
        imp_.do_draw_polygon_flatshaded(corners, color);
    }

    /// What was drawn so far is in the target's pixels afterwards. Call it before anybody else
    /// reads or writes them; what others wrote is drawn upon by what is drawn next.
    void finish() { imp_.do_finish(); }

private:
    l3d_rasterizer_2d_imp& imp_;
};

#endif
