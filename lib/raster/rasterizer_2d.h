// SPDX-License-Identifier: MIT
// l3d_rasterizer_2d: points, lines and polygons; and the bridge to what draws them.
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

/// A corner of a polygon. Units: pixels; pixel (x, y) is sampled at the position (x, y), and is the
/// square from (x - 1/2, y - 1/2) to (x + 1/2, y + 1/2). So the whole picture lies between (-1/2,
/// -1/2) and (width - 1/2, height - 1/2): l3d_rasterizer_2d::draw_box and l3d_path::add_box take
/// whole pixels.
struct L3D_PUBLIC l3d_point_2d {
    /// From the left and from the top of the picture.
    double x = 0, y = 0;
};

/// A corner with a colour of its own, a pixel word.
struct L3D_PUBLIC l3d_colored_point_2d {
    /// From the left and from the top of the picture, in pixels.
    double x = 0, y = 0;
    l3d_color color = 0; ///< 0x00RRGGBB
};

/// A line between two pixels.
struct L3D_PUBLIC l3d_line_2d {
    /// Columns and rows of its two ends, both drawn.
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

/// How much of each pixel of a rectangle a shape covers, such as a letter.
///
/// Shape: rows of `width` values from 0 to 255, `pitch` values apart. 0 repeats a single row.
/// Lives: borrows the values.
struct L3D_PUBLIC l3d_coverage_2d {
    /// The first column and row, and the numbers of columns and rows, which are not negative.
    int left = 0, top = 0, width = 0, height = 0;
    const std::uint8_t* values = nullptr; ///< values of the first row
    std::ptrdiff_t pitch = 0;             ///< from one row to the next

    /// Row i of the shape. Expects: 0 <= i < height.
    std::span<const std::uint8_t> row(int i) const {
        return {values + i * pitch, static_cast<std::size_t>(width)};
    }
};

/// The closed outline of an area: its corners in order, the last one joined to the first.
using l3d_outline_2d = std::span<const l3d_point_2d>;

/// The fill rule: which points are inside of outlines that cross themselves or each other. It
/// counts how often the outlines wind around a point, clockwise less anticlockwise.
enum class L3D_PUBLIC l3d_winding {
    nonzero, ///< inside if this number is not zero
    even_odd ///< inside if it is odd
};

/// The numbers in which two colours are mixed.
enum class L3D_PUBLIC l3d_blending {
    coded, ///< those of pixel words: fast, and what most programs do
    /// Amounts of light, by the sRGB curve: as two colours mix for an eye that is too far away to
    /// tell them apart. Thin bright lines keep their light on a dark ground.
    linear
};

/// How the area inside of a path is filled.
struct L3D_PUBLIC l3d_fill {
    l3d_color color = 0x00ffffff; ///< 0x00RRGGBB
    /// Instead of the colour, colours that change from place to place. Null: the colour.
    /// Lives: borrowed while drawing.
    const l3d_gradient* gradient = nullptr;
    double alpha = 1;                          ///< from 0, nothing, to 1, opaque
    l3d_winding inside = l3d_winding::nonzero; ///< which of its points are inside
    /// Only what is inside of this path, too, is filled. Null: everything.
    /// Lives: borrowed while drawing.
    const l3d_path* clip = nullptr;
    l3d_winding clip_inside = l3d_winding::nonzero; ///< which points are inside of the clip path
    /// Only pixels in this box are drawn; by default, all of them.
    l3d_pixel_box box{0, 0, l3d_largest_side, l3d_largest_side};
    /// How the colour is mixed with the present one. Outputs that cannot read their own picture mix
    /// coded.
    l3d_blending blending = l3d_blending::coded;
};

/// The drawing operations that each kind of output implements. Programs hold the l3d_rasterizer_2d
/// in front of it.
class L3D_PUBLIC l3d_rasterizer_2d_imp {
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
    virtual void do_clear_buffer(l3d_color color) = 0;
    virtual void do_draw_point(int x, int y, l3d_color color) = 0;
    virtual void do_draw_lines(std::span<const l3d_line_2d> lines, l3d_color color) = 0;
    virtual void do_draw_line_antialiased(l3d_point_2d from, l3d_point_2d to, l3d_color color) = 0;
    virtual void do_draw_polygon_flatshaded(l3d_outline_2d corners, l3d_color color) = 0;
    virtual void do_draw_polygon_gouraudshaded(std::span<const l3d_colored_point_2d> corners) = 0;
    virtual void do_draw_outlines(std::span<const l3d_outline_2d> outlines, l3d_winding inside,
                                  l3d_color color) = 0;

    /// Unless a kind of output has a way of its own, a line is drawn as a batch of one.
    virtual void do_draw_line(int x0, int y0, int x1, int y1, l3d_color color);

    /// Unless a kind of output can mix colours, what is covered by half or more gets the colour.
    virtual void do_draw_coverage(const l3d_coverage_2d& shape, l3d_color color);

    /// Unless a kind of output has a way of its own, a path is drawn as coverage, run by run.
    virtual void do_draw_path(const l3d_path& path, const l3d_fill& fill);
    virtual void do_draw_image(const l3d_placed_image& image, const l3d_fill& fill);

    /// Unless a kind of output has a way of its own, curves are points, and meshes are
    /// Gouraud-shaded triangles.
    virtual void do_draw_curves(const l3d_path& path, l3d_color color);
    virtual void do_draw_mesh(std::span<const l3d_mesh_patch> patches);
};

/// Draws points, lines and polygons; says nothing about where the pixels are.
///
/// Positions of corners and of the ends of smooth lines are rounded to 1/256 pixel; all after that
/// is exact. A shape with a coordinate that is not a number is not drawn. Coordinates beyond +-2^30
/// pixels, infinite ones too, are moved to that. Nothing is drawn outside of the target, and inside
/// of it the same pixels in the same colours however much is outside.
/// Units:   whole coordinates name pixels, (0, 0) the top left one, y down; a colour is a pixel
///          word, 0x00RRGGBB.
/// Lives:   borrows the implementation, which must outlive it.
class L3D_PUBLIC l3d_rasterizer_2d {
public:
    /// A rasterizer in front of this implementation. Lives: borrows it.
    explicit l3d_rasterizer_2d(l3d_rasterizer_2d_imp& imp) : imp_(imp) {}

    /// Makes every pixel this word; without one, black.
    void clear_buffer(l3d_color color = 0) { imp_.do_clear_buffer(color); }

    /// Fills whole pixels: those of the box, and no part of others.
    void draw_box(const l3d_pixel_box& box, l3d_color color);

    /// Sets one pixel, if it lies in the picture.
    void draw_point(int x, int y, l3d_color color) { imp_.do_draw_point(x, y, color); }

    /// Draws a line, both ends included. Each step along the longer axis (x if both are equally
    /// long) lights the pixel nearest to the ideal line. If two are equally near, it lights the
    /// upper or left one. The same pixels in both directions; clipped, exactly those of them that
    /// are in the target.
    void draw_line(int x0, int y0, int x1, int y1, l3d_color color) {
        imp_.do_draw_line(x0, y0, x1, y1, color);
    }

    /// Draws many lines with one call across the bridge.
    void draw_lines(std::span<const l3d_line_2d> lines, l3d_color color) {
        imp_.do_draw_lines(lines, color);
    }

    /// Draws a smooth line in Wu's way. A square pen of one pixel is drawn along it. Each pixel
    /// gets as much of the colour as the pen covers of it, measured along each axis by itself.
    ///
    /// Let a be the coordinate along the longer axis, from a0 to a1, and b(a) the line's other one.
    /// Pixel (a, b) is covered by w v. w is the part of [a - 1/2, a + 1/2] that lies in [a0 - 1/2,
    /// a1 + 1/2]; v is max(0, 1 - |b - b(a)|). The product is rounded to a multiple of 1/255. The
    /// same pixels in both directions. A pixel word's highest byte stays what it was.
    /// Source:  Wu: An Efficient Antialiasing Technique (SIGGRAPH 1991); the ends are ours.
    void draw_line_antialiased(l3d_point_2d from, l3d_point_2d to, l3d_color color) {
        imp_.do_draw_line_antialiased(from, to, color);
    }

    /// Fills a polygon: the pixels (x, y) inside it, or on a left or top edge of it.
    ///
    /// Polygons that share an edge cover each pixel once. A point of a picture whose pixels are
    /// sampled at their centres (as surfaces are) is half a pixel less here in x and y.
    /// Expects: convex, either winding. Fewer than three corners or no area draws nothing.
    void draw_polygon_flatshaded(l3d_outline_2d corners, l3d_color color) {
        imp_.do_draw_polygon_flatshaded(corners, color);
    }

    /// Fills the same pixels as draw_polygon_flatshaded, in colours between those of the corners.
    ///
    /// Red, green and blue are linear on each of the triangles of corners 0, i and i + 1; what is
    /// stored is within 1/2 + 2^-12 of that. A highest byte of 0 is stored.
    /// Expects: convex, either winding.
    void draw_polygon_gouraudshaded(std::span<const l3d_colored_point_2d> corners) {
        imp_.do_draw_polygon_gouraudshaded(corners);
    }

    /// Fills what one outline of any form encloses; see draw_outlines.
    void draw_polygon_complex(l3d_outline_2d outline, l3d_winding inside, l3d_color color) {
        imp_.do_draw_outlines({&outline, 1}, inside, color);
    }

    /// Fills the area inside of outlines: concave, crossing, with holes. A pixel on an edge belongs
    /// to what is right of or below it, as with convex polygons, whose pixels are the same here.
    /// One coordinate that is not a number, and nothing is drawn.
    void draw_outlines(std::span<const l3d_outline_2d> outlines, l3d_winding inside,
                       l3d_color color) {
        imp_.do_draw_outlines(outlines, inside, color);
    }

    /// Moves each pixel's red, green and blue towards the colour's by coverage / 255, to the
    /// nearest. So text has smooth edges, and panels let the picture shine through.
    ///
    /// In a picture without background, what is covered becomes less transparent; with GL, it stays
    /// as transparent as it was.
    void draw_coverage(const l3d_coverage_2d& shape, l3d_color color) {
        imp_.do_draw_coverage(shape, color);
    }

    /// Fills the area inside of a path with smooth edges. Each pixel moves towards the colour by
    /// the share of its square that is covered, times alpha.
    ///
    /// Pixel (x, y) is the square from (x - 1/2, y - 1/2) to (x + 1/2, y + 1/2). Its share is exact
    /// where outlines cross or lie upon each other, too. Two things alone change it: curves are
    /// drawn within l3d_flat_enough, and the product is rounded to a multiple of 1/255. A path of
    /// lines is thus within 1/510, up to the rounding of doubles. Positions are not rounded to a
    /// lattice. Nothing is drawn if a coordinate is not a number, and beyond +-2^30 it is moved to
    /// that. In a picture without background, colours count by what they cover. In linear light,
    /// the rounded share moves the light of each channel, and the level nearest to it is stored:
    /// near black, a step of 1/255 in the share is up to 13 levels.
    /// Expects: alpha in [0, 1].
    /// Cost:    linear in the rows that edges reach and the pixels that are covered. Where n edges
    ///          share pixels and cross each other m times, n log n (n + m).
    void draw_path(const l3d_path& path, const l3d_fill& fill) { imp_.do_draw_path(path, fill); }

    /// Draws an image wherever it is placed, over what is there.
    ///
    /// The fill's alpha, clip, clip_inside, box and blending count. l3d_image_filter says which
    /// colour a pixel gets. The image's own edges and the clip path's are smooth as those of paths;
    /// with l3d_image_filter::nearest, only the clip path's are. Colours are mixed in double, and
    /// rounded once: within 1/2 + 10^-6 levels, where shares of 1/255 are exact. Nothing is drawn
    /// if the placement has no area, or a corner of the image is not within +-2^30 pixels.
    /// Expects: alpha in [0, 1].
    /// Cost:    as draw_path, and for each pixel as many pixels of the image as the filter takes.
    ///          An opaque image that is only moved by whole pixels is copied.
    void draw_image(const l3d_placed_image& image, const l3d_fill& fill = {}) {
        imp_.do_draw_image(image, fill);
    }

    /// Draws the lines and curves of a path one pixel wide, with hard edges.
    ///
    /// The pixels form runs that are eight-connected as far as they are in the picture. No sample
    /// of a pixel is farther from the curve than 1/2 + 2^-20 along either axis. No point of the
    /// curve is farther from such a sample than 3/2 along both. Pixels are drawn in the order of
    /// the curve, and those at the corner of a right angle are left out. The same pixels however
    /// much is outside.
    /// Cost:    some additions for each pixel, by adaptive forward differences.
    void draw_curves(const l3d_path& path, l3d_color color) { imp_.do_draw_curves(path, color); }

    /// Fills patches with colours between those of their corners, one after another.
    ///
    /// Where a patch lies upon itself, the PDF standard tells what is seen: the larger v, with one
    /// v the larger u. A pixel gets a colour that the patch has at most 1/16 pixel from its sample,
    /// within 1/2 + 1/32 levels, and corners are rounded to 1/256 pixel. (A kind of output that has
    /// only Gouraud-shaded triangles rounds their corners' colours as well.) Patches of one call
    /// that share a border leave no crack and no double hit there. Patches with coordinates that
    /// are not finite are left out.
    /// Cost:    a quarter of a patch, along u or v, is diced as finely as its worst place needs,
    ///          and so are its neighbours across common borders; a patch into 512 x 512 at most.
    ///          That keeps the 1/16 pixel for borders like quarters of circles up to a radius of
    ///          4 10^4 pixels. Beyond, places are off in proportion: 1.3 pixels for 10^6.
    void draw_mesh(std::span<const l3d_mesh_patch> patches) { imp_.do_draw_mesh(patches); }

    /// Completes the picture: afterwards, everything drawn so far is in the target's pixels. Call
    /// it before anybody else reads or writes the pixels. Later drawing goes on top of that.
    void finish() { imp_.do_finish(); }

private:
    l3d_rasterizer_2d_imp& imp_;
};

/// Cuts lines off at the sides of a box, in doubles; they are rounded when they are drawn.
/// Units:   pixels, y down.
/// Source:  Cohen, Sutherland; in Newman, Sproull: Principles of Interactive Computer Graphics.
struct L3D_PUBLIC l3d_clip_region {
    /// The box's corners, top left and bottom right; both belong to it.
    l3d_point_2d least{}, most{};

    /// The bits of outcode(), one for each side of the box.
    static constexpr unsigned left = 1, right = 2, below = 4, above = 8;

    /// The sides that a point is beyond, as a sum of bits; 0 if it is inside.
    unsigned outcode(l3d_point_2d p) const {
        return (p.x < least.x ? left : 0) | (p.x > most.x ? right : 0) |
               (p.y > most.y ? below : 0) | (p.y < least.y ? above : 0);
    }

    /// Moves the ends of a line to the sides. Returns false if no part of it is inside.
    /// Expects: finite numbers.
    bool clip(l3d_point_2d& from, l3d_point_2d& to) const;

    /// Draws a line's part inside, between the pixels nearest to its ends.
    void draw_line(l3d_rasterizer_2d& rasterizer, l3d_point_2d from, l3d_point_2d to,
                   l3d_color color) const;

    /// Draws the four sides.
    void draw_border(l3d_rasterizer_2d& rasterizer, l3d_color color) const;
};

#endif
