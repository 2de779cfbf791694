// SPDX-License-Identifier: MIT
// l3d_frame_report and l3d_polygon_report: a frame's cost, error bounds, and skipped work.
#ifndef L3D_PIPELINE_FRAME_REPORT_H
#define L3D_PIPELINE_FRAME_REPORT_H

#include "base/public.h"
#include "raster/surface_rasterizer.h"
#include "scene/counts.h"
#include "tool_2d/pixels.h"

#include <cstdint>
#include <limits>
#include <string>

/// Times of the stages that are common to frames of patches and frames of polygons, by the
/// monotonic clock.
/// Units: milliseconds.
struct L3D_PUBLIC l3d_common_times {
    double raster = 0;  ///< clearing and filling the picture: coverage, depth, shading, lines
    double overlay = 0; ///< drawing control nets and text on top
    double total = 0;   ///< all stages of drawing together, without `show` and `write`
    double show = 0;    ///< bringing the picture to the screen; not part of total
    double write = 0;   ///< writing picture files; not part of total
};

/// The entries that the reports of patches' and of polygons' frames share.
struct L3D_PUBLIC l3d_common_report {
    int frame = 0;      ///< the frame's number, from 0; skipped frames count
    std::string method; ///< the name of the method that filled surfaces
    /// The OpenGL renderer that filled surfaces; empty if the library itself did.
    std::string renderer;
    std::string real;           ///< the number type of the library, l3d_real_name()
    std::string simd;           ///< vector instructions, as l3d_simd_target names them
    l3d_size size;              ///< size of the picture, in pixels
    int threads = 1;            ///< threads that drew
    l3d_surface_counts surface; ///< counts of work while surfaces were filled
    std::uint64_t hash = 0;     ///< l3d_hash of the picture
};

/// A picture's fingerprint, by which pictures can be compared. It is the 64-bit hash FNV-1a of the
/// pixel words, row by row from the top. The lowest byte of each word comes first.
/// Source: Fowler, Noll, Vo; constants from RFC 9923.
L3D_PUBLIC std::uint64_t l3d_hash(const l3d_pixels& pixels);

/// Times of the stages of a frame of patches. Units: milliseconds.
struct L3D_PUBLIC l3d_stage_times : l3d_common_times {
    double transform = 0; ///< finding the patches that may be seen, and sorting them front to back
    double dice = 0;      ///< control nets to the image, bounds, steps, and forward differences
    double outlines = 0;  ///< finding the pixels that outlines reach; not part of total
    double error_map = 0; ///< bounding the error of each pixel; not part of total
};

/// The report of one frame of patches.
struct L3D_PUBLIC l3d_frame_report : l3d_common_report {
    double tolerance_px = 0; ///< the permitted error of places in the picture, in pixels
    /// Distance of the near plane that was used. It is the camera's, or farther if rounding needs
    /// it.
    double near_z = 0;
    l3d_stage_times time_ms;  ///< times of the stages, in milliseconds
    std::int64_t patches = 0; ///< patches of all instances, seen or not
    l3d_dice_counts dice; ///< counts of seen patches and of steps, and the certified error bounds
    /// The number of pixels that keep their colour from the last frame, since nothing changed
    /// there.
    std::int64_t pixels_kept = 0;

    /// The part of the bounds of places and depth that comes from approximation. Surfaces that are
    /// not bicubic are drawn as patches that approximate them. Units: pixels.
    double curved_px = 0;

    /// The number of pixels that an outline may cross, so that it is not certain which surface they
    /// show. It is l3d_surface_counts::none_counted if the settings did not ask for outlines, or if
    /// only a part of the picture was drawn.
    std::int64_t outline_pixels = l3d_surface_counts::none_counted;

    /// The largest part of a pixel's square, from 0 to 1, that may show another surface, or
    /// background, than the exact picture does there. It includes errors of places, but not errors
    /// of sampling at pixels' centres. It is infinite if the settings did not ask for the map of
    /// errors, or if places or depth have no bound.
    double coverage_bound = std::numeric_limits<double>::infinity();
    /// The largest error of any colour channel in pixels that lie inside one surface. It is
    /// infinite if the settings did not ask for the map of errors. Units: levels of 0 to 255.
    double color_bound = std::numeric_limits<double>::infinity();

    /// One line of JSON, without the line's end.
    std::string json() const;

    /// Explains the work that the frame left out. Each reason has a line, with the test that proved
    /// that the work was not needed.
    std::string explanation() const;

private:
    std::string left_out_in_part() const;
};

/// The counts of a model's triangles in a frame: those drawn, and those left out by reason.
struct L3D_PUBLIC l3d_polygon_counts : l3d_seen_counts {
    std::int64_t back = 0; ///< triangles left out: seen from behind, or without area

    /// Adds the counts of `other` to this object's counts.
    void add(const l3d_polygon_counts& other) {
        l3d_seen_counts::add(other);
        back += other.back;
    }
};

/// Counts of the work of sorting a frame's triangles from back to front, in painting order.
struct L3D_PUBLIC l3d_painter_order_counts {
    std::int64_t triangles = 0; ///< triangles to be ordered
    std::int64_t pairs = 0; ///< pairs of triangles that were compared, since they may share pixels
    /// The number of sets of triangles that hide each other in a circle. Without cuts, such a set
    /// has no right painting order.
    std::int64_t knots = 0;
    std::int64_t knotted = 0; ///< triangles in the knots
    std::int64_t cuts = 0;    ///< triangles and pieces cut in two
};

/// Times of the stages of a frame of polygons. Units: milliseconds.
struct L3D_PUBLIC l3d_polygon_times : l3d_common_times {
    double place = 0; ///< projecting vertices, culling and clipping faces
    double order = 0; ///< sorting, comparing and cutting triangles; 0 with a depth buffer
};

/// The report of one frame of polygons.
struct L3D_PUBLIC l3d_polygon_report : l3d_common_report {
    l3d_polygon_times time_ms;   ///< times of the stages, in milliseconds
    std::int64_t faces = 0;      ///< faces of the model
    std::int64_t triangles = 0;  ///< triangles of the model's faces
    l3d_polygon_counts polygons; ///< triangles drawn, and left out by reason
    /// Counts of the work of ordering triangles; zeros with a depth buffer.
    l3d_painter_order_counts order;

    /// One line of JSON, without the line's end.
    std::string json() const;

    /// Explains the work that the frame left out. Each reason has a line, with the test that proved
    /// that the work was not needed.
    std::string explanation() const;
};

#endif
