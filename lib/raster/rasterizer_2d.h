// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d: points, lines and polygons; and the interface to the code that draws them.
#ifndef L3D_RASTER_RASTERIZER_2D_H
#define L3D_RASTER_RASTERIZER_2D_H

#include "base/color.h"
#include "base/public.h"
#include "tool_2d/pixels.h"

#include <cstddef>
#include <cstdint>
#include <span>

class l3d_gradient;
class l3d_path;
struct l3d_mesh_patch;
struct l3d_placed_image;

/// A point of the plane, such as a corner of a polygon.
///
/// Pixel (x, y) is sampled at (x, y), and is the square from (x - 1/2, y - 1/2) to
/// (x + 1/2, y + 1/2). So the whole picture lies between (-1/2, -1/2) and
/// (width - 1/2, height - 1/2). For whole pixels there are l3d_rasterizer_2d::draw_box and
/// l3d_path::add_box.
struct L3D_PUBLIC l3d_point_2d {
    /// The corner's place, in pixels. (0, 0) is the centre of the top left pixel.
    double x = 0, y = 0;
};

/// A corner of a Gouraud-shaded polygon, with a colour of its own.
struct L3D_PUBLIC l3d_colored_point_2d {
    /// The corner's place, in pixels. (0, 0) is the centre of the top left pixel.
    double x = 0, y = 0;
    l3d_color color = 0; ///< the corner's colour, a pixel word 0x00RRGGBB
};

/// A line between two pixels.
struct L3D_PUBLIC l3d_line_2d {
    /// The columns and rows of both ends. The pixels at the ends are drawn, too.
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// The coverage of a shape, such as a letter: the covered share of each pixel of a rectangle around
/// the shape.
///
/// Shape: rows of `width` values from 0 to 255, `pitch` values apart. A pitch of 0 repeats a single
///        row.
/// Lives: borrows the values.
struct L3D_PUBLIC l3d_coverage_2d {
    /// The rectangle's first column and row, and its numbers of columns and rows, which are not
    /// negative.
    int left = 0, top = 0, width = 0, height = 0;
    const std::uint8_t* values = nullptr; ///< the values of the first row
    std::ptrdiff_t pitch = 0; ///< distance from one row of values to the next, in values

    /// Row i of the shape. Expects: 0 <= i < height.
    std::span<const std::uint8_t> row(int i) const {
        return {values + i * pitch, static_cast<std::size_t>(width)};
    }
};

/// The closed outline of an area: corners in order, the last one joined to the first.
using l3d_outline_2d = std::span<const l3d_point_2d>;

/// The fill rule: which points are inside of outlines that cross themselves or each other. The rule
/// depends on a point's winding number: how often the outlines wind around it, clockwise less
/// anticlockwise.
enum class L3D_PUBLIC l3d_winding {
    nonzero, ///< a point is inside if its winding number is not zero
    even_odd ///< a point is inside if its winding number is odd
};

/// The kind of numbers in which two colours are mixed.
enum class L3D_PUBLIC l3d_blending {
    coded, ///< the levels in pixel words as they are: fast, and usual in most programs
    /// Amounts of light, by the sRGB curve. So colours mix as for an eye too far away to tell them
    /// apart. Thin bright lines keep their light on a dark ground.
    linear
};

/// The way in which the area inside of a path is filled.
struct L3D_PUBLIC l3d_fill {
    l3d_color color = 0x00ffffff; ///< the colour, 0x00RRGGBB
    /// Colours that change from place to place, used instead of `color`. Null: `color` is used.
    /// Lives: borrowed while drawing.
    const l3d_gradient* gradient = nullptr;
    double alpha = 1;                          ///< opacity: from 0, invisible, to 1, opaque
    l3d_winding inside = l3d_winding::nonzero; ///< which points are inside of the path
    /// A path that limits the filling: only points inside of it are filled. Null: no limit.
    /// Lives: borrowed while drawing.
    const l3d_path* clip = nullptr;
    l3d_winding clip_inside = l3d_winding::nonzero; ///< which points are inside of the clip path
    /// Only pixels in this box are drawn. The default box holds all pixels.
    l3d_pixel_box box{0, 0, l3d_largest_side, l3d_largest_side};
    /// The way in which the colour is mixed with the picture's. Outputs that cannot read their own
    /// picture always mix as `coded` does.
    l3d_blending blending = l3d_blending::coded;
};

/// The drawing operations that each kind of output implements. Programs use l3d_rasterizer_2d,
/// which calls these operations.
class L3D_PUBLIC l3d_rasterizer_2d_imp {
public:
    l3d_rasterizer_2d_imp() = default;
    l3d_rasterizer_2d_imp(const l3d_rasterizer_2d_imp&) = delete;
    l3d_rasterizer_2d_imp& operator=(const l3d_rasterizer_2d_imp&) = delete;
    virtual ~l3d_rasterizer_2d_imp() = default;

    /// Sets the pixels that later calls draw into; call it after every resize. Unfinished drawing
    /// is lost.
    /// Lives: borrows the pixels until the next call.
    void set_target(l3d_pixels target) { do_set_target(target); }

private:
    friend class l3d_rasterizer_2d;

    virtual void do_set_target(l3d_pixels target) = 0;
    virtual void do_finish() {}
    virtual void do_clear_buffer(l3d_color color) = 0;
    virtual void do_draw_point(int x, int y, l3d_color color) = 0;
    virtual void do_draw_lines(std::span<const l3d_line_2d> lines, l3d_color color) = 0;
    virtual void do_draw_line_antialiased(l3d_point_2d from, l3d_point_2d to, l3d_color color) = 0;
    virtual void do_draw_polygon_flatshaded(l3d_outline_2d corners, l3d_color color) = 0;
    virtual void do_draw_polygon_gouraudshaded(std::span<const l3d_colored_point_2d> corners) = 0;
    virtual void do_draw_outlines(std::span<const l3d_outline_2d> outlines, l3d_winding inside,
                                  l3d_color color) = 0;

    /// Draws a line. By default, it is a batch of one line.
    virtual void do_draw_line(int x0, int y0, int x1, int y1, l3d_color color);

    /// Draws a shape. By default, pixels that are covered by half or more get the colour unmixed.
    virtual void do_draw_coverage(const l3d_coverage_2d& shape, l3d_color color);

    /// Draws a path. By default, it is drawn as coverage, run by run.
    virtual void do_draw_path(const l3d_path& path, const l3d_fill& fill);
    virtual void do_draw_image(const l3d_placed_image& image, const l3d_fill& fill);

    /// Draws curves. By default, curves are drawn as points, and do_draw_mesh draws meshes as
    /// Gouraud-shaded triangles.
    virtual void do_draw_curves(const l3d_path& path, l3d_color color);
    virtual void do_draw_mesh(std::span<const l3d_mesh_patch> patches);
};

/// Draws points, lines and polygons into any kind of output.
///
/// Positions of corners and of the ends of smooth lines are rounded to 1/256 pixel; everything
/// after that is exact. A shape with a coordinate that is not a number is not drawn. Coordinates
/// beyond +-2^30 pixels, infinite ones too, are clamped to this limit. Drawing is clipped to the
/// target, and clipping changes no pixel inside of it.
/// Units:   whole coordinates name pixels, (0, 0) the top left one, y down; a colour is a pixel
///          word, 0x00RRGGBB.
/// Lives:   borrows the implementation, which must outlive it.
class L3D_PUBLIC l3d_rasterizer_2d {
public:
    /// Makes a rasterizer that draws with this implementation. Lives: borrows it.
    explicit l3d_rasterizer_2d(l3d_rasterizer_2d_imp& imp) : imp_(imp) {}

    /// Sets every pixel to this colour, by default to black.
    void clear_buffer(l3d_color color = 0) { imp_.do_clear_buffer(color); }

    /// Fills the whole pixels of a box, and touches no others.
    void draw_box(const l3d_pixel_box& box, l3d_color color);

    /// Sets one pixel, if it lies in the picture.
    void draw_point(int x, int y, l3d_color color) { imp_.do_draw_point(x, y, color); }

    /// Draws a line, both ends included. Each step along the longer axis (x if both are equally
    /// long) lights the pixel nearest to the ideal line. If two pixels are equally near, it lights
    /// the upper or left one. Both directions of a line light the same pixels, and clipping only
    /// removes pixels outside of the target.
    void draw_line(int x0, int y0, int x1, int y1, l3d_color color) {
        imp_.do_draw_line(x0, y0, x1, y1, color);
    }

    /// Draws many lines in one call of the implementation, which costs less than a call for each.
    void draw_lines(std::span<const l3d_line_2d> lines, l3d_color color) {
        imp_.do_draw_lines(lines, color);
    }

    /// Draws a smooth line by Wu's method. A square pen of one pixel is drawn along the line. The
    /// share of a pixel that the pen covers, measured along each axis separately, is the share of
    /// the colour that the pixel gets.
    ///
    /// Let a be the coordinate along the longer axis, from a0 to a1, and b(a) the line's other
    /// coordinate. Pixel (a, b) is covered by w v, rounded to a multiple of 1/255. w is the length
    /// of the part of [a - 1/2, a + 1/2] within [a0 - 1/2, a1 + 1/2]; v is max(0, 1 - |b - b(a)|).
    /// Both directions of a line give the same pixels. A pixel word's highest byte stays.
    /// Source:  Wu: An Efficient Antialiasing Technique (SIGGRAPH 1991); w, at the ends, is our
    ///          addition.
    void draw_line_antialiased(l3d_point_2d from, l3d_point_2d to, l3d_color color) {
        imp_.do_draw_line_antialiased(from, to, color);
    }

    /// Fills a polygon: the pixels (x, y) whose sample is inside, or on a left or top edge.
    ///
    /// Polygons that share an edge cover each pixel once. Surfaces sample pixels at centres
    /// (x + 1/2, y + 1/2): subtract 1/2 from both coordinates of a surface's point to use it here.
    /// Expects: convex, either winding. Fewer than three corners or no area draws nothing.
    void draw_polygon_flatshaded(l3d_outline_2d corners, l3d_color color) {
        imp_.do_draw_polygon_flatshaded(corners, color);
    }

    /// Fills the same pixels as draw_polygon_flatshaded, with colours interpolated between the
    /// corners.
    ///
    /// Red, green and blue are linear on each triangle of corners 0, i and i + 1; the stored levels
    /// are within 1/2 + 2^-12 of the exact ones. The highest byte of each word becomes 0.
    /// Expects: convex, either winding.
    void draw_polygon_gouraudshaded(std::span<const l3d_colored_point_2d> corners) {
        imp_.do_draw_polygon_gouraudshaded(corners);
    }

    /// Fills the area inside of one outline of any form; see draw_outlines.
    void draw_polygon_complex(l3d_outline_2d outline, l3d_winding inside, l3d_color color) {
        imp_.do_draw_outlines({&outline, 1}, inside, color);
    }

    /// Fills the area inside of outlines, which may be concave, cross and have holes. A pixel on an
    /// edge belongs to the area right of or below it. So a convex polygon gets the same pixels as
    /// from draw_polygon_flatshaded. Nothing is drawn if any coordinate is not a number.
    void draw_outlines(std::span<const l3d_outline_2d> outlines, l3d_winding inside,
                       l3d_color color) {
        imp_.do_draw_outlines(outlines, inside, color);
    }

    /// Moves each pixel's red, green and blue towards the colour's by coverage / 255, rounded to
    /// the nearest level. Use it for text with smooth edges, and for panels that let the picture
    /// shine through.
    ///
    /// In a picture without background, covered pixels become less transparent; with GL, they stay
    /// as transparent as they were.
    void draw_coverage(const l3d_coverage_2d& shape, l3d_color color) {
        imp_.do_draw_coverage(shape, color);
    }

    /// Fills the area inside of a path with smooth edges. Each pixel moves towards the colour by
    /// its coverage, the share of its square that is inside, times alpha.
    ///
    /// Pixel (x, y) is the square from (x - 1/2, y - 1/2) to (x + 1/2, y + 1/2). Coverage is exact
    /// even where outlines cross or lie upon each other, with two exceptions. Curves are drawn
    /// within l3d_flat_enough, and coverage times alpha is rounded to a multiple of 1/255. So the
    /// coverage of a path of lines is within 1/510, up to the rounding of doubles. Positions are
    /// not rounded to a lattice. Nothing is drawn if a coordinate is not a number; coordinates
    /// beyond +-2^30 are clamped to this limit.
    ///
    /// In a picture without background, colours are weighted by their coverage. In linear light,
    /// the rounded coverage moves the light of each channel, and the level nearest to the result is
    /// stored. Near black, a step of 1/255 in coverage is then up to 13 levels.
    /// Expects: alpha in [0, 1].
    /// Cost:    linear in the rows that edges reach and the pixels that are covered. Where n edges
    ///          share pixels and cross each other m times, the cost is (n + m) log n.
    void draw_path(const l3d_path& path, const l3d_fill& fill) { imp_.do_draw_path(path, fill); }

    /// Draws a placed image over the picture.
    ///
    /// The fill's alpha, clip, clip_inside, box and blending are used. l3d_image_filter tells which
    /// colour a pixel gets. Edges of the image and of the clip path are as smooth as the edges of
    /// paths; with l3d_image_filter::nearest, the image's edges are hard. Colours are mixed in
    /// doubles and rounded once: within 1/2 + 10^-6 levels, where coverage is a multiple of 1/255.
    /// Nothing is drawn if the placement has no area, or a corner of the image is not within +-2^30
    /// pixels.
    /// Expects: alpha in [0, 1].
    /// Cost:    as draw_path, and for each pixel as many pixels of the image as the filter takes.
    ///          An opaque image that is only moved by whole pixels is copied.
    void draw_image(const l3d_placed_image& image, const l3d_fill& fill = {}) {
        imp_.do_draw_image(image, fill);
    }

    /// Draws the lines and curves of a path one pixel wide, with hard edges.
    ///
    /// Within the picture, the pixels form eight-connected runs. From each pixel's sample, some
    /// point of the curve is within 1/2 + 2^-20 in x and in y. From each point of the curve, the
    /// sample of some drawn pixel is within 3/2 in x and in y. Pixels are drawn in the order of the
    /// curve, and the pixel in the corner of a right angle is left out. Clipping changes no pixel
    /// inside of the picture.
    /// Cost:    some additions for each pixel, by adaptive forward differences.
    void draw_curves(const l3d_path& path, l3d_color color) { imp_.do_draw_curves(path, color); }

    /// Fills patches one after another, with colours interpolated between their corners.
    ///
    /// Where a patch folds over itself, the larger v is seen, and for equal v the larger u, as the
    /// PDF standard has it. Somewhere at most 1/16 pixel from a pixel's sample, the patch has the
    /// pixel's colour within 1/2 + 1/32 levels. Corners are rounded to 1/256 pixel. (Outputs that
    /// have only Gouraud-shaded triangles also round the colours of triangles' corners.)
    ///
    /// Patches of one call that share a border leave no crack and no double hit there. Patches with
    /// coordinates that are not finite are left out.
    /// Cost:    each quarter of a patch, along u or v, is diced as finely as its worst place needs.
    ///          Neighbours across a common border get the same steps along it. A patch has at most
    ///          512 x 512 quads. This number keeps the error within 1/16 pixel if borders are like
    ///          quarters of circles with radii up to 4 10^4 pixels. For larger radii, the error
    ///          grows in proportion: 1.3 pixels for a radius of 10^6.
    void draw_mesh(std::span<const l3d_mesh_patch> patches) { imp_.do_draw_mesh(patches); }

    /// Completes the picture: afterwards, the target's pixels hold everything drawn so far. Call
    /// finish() before anybody else reads or writes the pixels. Later drawing adds to this picture.
    void finish() { imp_.do_finish(); }

private:
    l3d_rasterizer_2d_imp& imp_;
};

/// Clips lines at the sides of a box, in doubles. Clipped ends are rounded only when they are
/// drawn.
/// Units:   pixels, y down.
/// Source:  Cohen, Sutherland; in Newman, Sproull: Principles of Interactive Computer Graphics.
struct L3D_PUBLIC l3d_clip_region {
    /// The box's corners, top left and bottom right; both corners belong to the box.
    l3d_point_2d least{}, most{};

    /// The bits of outcode() for the sides of the box.
    static constexpr unsigned left = 1, right = 2, below = 4, above = 8;

    /// The sides of the box that a point lies beyond, as a sum of bits; 0 if it is inside.
    unsigned outcode(l3d_point_2d p) const {
        return (p.x < least.x ? left : 0) | (p.x > most.x ? right : 0) |
               (p.y > most.y ? below : 0) | (p.y < least.y ? above : 0);
    }

    /// Moves the ends of a line to the sides of the box. Returns false if no part of the line is
    /// inside.
    /// Expects: finite numbers.
    bool clip(l3d_point_2d& from, l3d_point_2d& to) const;

    /// Draws the part of a line inside of the box, between the pixels nearest to the part's ends.
    void draw_line(l3d_rasterizer_2d& rasterizer, l3d_point_2d from, l3d_point_2d to,
                   l3d_color color) const;

    /// Draws the four sides of the box.
    void draw_border(l3d_rasterizer_2d& rasterizer, l3d_color color) const;
};

#endif
