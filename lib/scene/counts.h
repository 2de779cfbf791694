// SPDX-License-Identifier: MIT
// Counts of a frame's shapes: those drawn, with error bounds, and those left out, by reason; the
// rules' switches.
#ifndef L3D_SCENE_COUNTS_H
#define L3D_SCENE_COUNTS_H

#include "base/public.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>

/// Counts of a frame's shapes by what became of the shapes. A shape is a patch or a triangle.
struct L3D_PUBLIC l3d_seen_counts {
    std::int64_t drawn = 0;     ///< the shapes that reached the picture
    std::int64_t offscreen = 0; ///< shapes left out: beyond one side of the window
    std::int64_t subpixel = 0;  ///< shapes left out: their box holds no pixel centre
    std::int64_t clipped = 0;   ///< shapes cut at the near plane, far plane or guard band

    /// Adds the counts of other shapes.
    void add(const l3d_seen_counts& other) {
        drawn += other.drawn;
        offscreen += other.offscreen;
        subpixel += other.subpixel;
        clipped += other.clipped;
    }
};

/// A patch of a scene, with the bound of the patch's error. It serves to report the least exact
/// patch of a frame.
struct L3D_PUBLIC l3d_coarse_patch {
    double bound_px = 0; ///< bound of the patch's error of places, in pixels
    /// The instance's index in the scene, and the patch's index in the instance's model.
    std::int64_t instance = 0, patch = 0;

    /// Orders patches by their bounds. Among patches with equal bounds, the first in the scene is
    /// the greatest.
    friend bool operator<(const l3d_coarse_patch& a, const l3d_coarse_patch& b) {
        return std::tie(a.bound_px, b.instance, b.patch) <
               std::tie(b.bound_px, a.instance, a.patch);
    }
};

/// Proven error bounds of a diced piece in depth, shade and normals. The bound of places in the
/// picture is kept elsewhere. A bound is infinite where nothing is proven.
struct L3D_PUBLIC l3d_surface_certificate {
    /// The largest distance of chords from the exact surface, along the surface's normal at the
    /// same parameters.
    /// Units: pixels at that depth.
    double depth = 0;
    /// The largest error of shade levels against the exact levels at the same parameters. Units:
    /// levels of 255.
    double shade = 0;
    /// The length of the difference between interpolated normals and the exact unit normals at the
    /// same parameters. This bound is for vertices that have normals instead of shade levels;
    /// `shade` is then 0.
    double normal = 0;
    /// The number of quads that `shade` does not cover, since their block may exceed the tolerance.
    /// A block exceeds the tolerance where normals turn faster than quads of six pixels can follow,
    /// or where a normal vanishes. The slits beside such a block count as one quad.
    std::int64_t unproven_quads = 0;
    /// A bit for each block that is seen and may have places without a normal. The bit's number is
    /// 4 * row + column, or 0 if the piece is one block.
    unsigned without_normals = 0;
    /// The error of depth in the blocks of `without_normals`. The distance of quads' corners from a
    /// plane is not part of it (l3d_most_off_plane).
    double depth_without_normals = 0;

    /// Adds the error of vertices to `depth`. In the blocks of `without_normals`, also adds the
    /// distance of quads' corners from a plane.
    void add_to_depth(double vertices, double off_plane) {
        depth = std::max(depth, depth_without_normals + off_plane) + vertices;
    }
};

/// Counts and error bounds of a frame's dicing. Patches are counted, too, that are left out because
/// their control net, or the net's box, proves that they are unseen. `clipped` counts grids, not
/// patches.
struct L3D_PUBLIC l3d_dice_counts : l3d_seen_counts {
    std::int64_t behind = 0; ///< patches left out: behind the near plane
    std::int64_t beyond = 0; ///< patches left out: beyond the far plane
    std::int64_t hidden = 0; ///< patches left out: hidden by earlier patches
    /// Patches left out: outside the part of the picture that was drawn again.
    std::int64_t unchanged = 0;
    std::int64_t backfacing = 0; ///< patches left out: only their back is turned to the eye
    /// Blocks of drawn patches left out: only their back is turned to the eye.
    std::int64_t back_blocks = 0;
    std::int64_t back_quads = 0; ///< quads of the blocks that back_blocks counts
    std::int64_t as_points = 0;  ///< patches drawn as a point each, without dicing
    std::int64_t pieces = 0;     ///< grids made; more than `drawn` if patches had to be cut
    std::int64_t in_lanes = 0;   ///< grids made by l3d_lane_dicer
    std::int64_t samples = 0;    ///< vertices evaluated
    std::int64_t failures = 0;   ///< pixels left out because an iteration did not converge
    /// The largest w of the near planes: the view's, or a farther one that cut more off a patch. 0
    /// stands for the view's near plane.
    double near_z = 0;
    double bound_px = 0;     ///< certified error of places in the picture, over all that was drawn
    std::int64_t coarse = 0; ///< patches drawn with a bound above the tolerance
    std::int64_t unfinished = 0; ///< coarse patches that a larger budget would make finer
    l3d_coarse_patch coarsest;   ///< the patch with the largest bound

    /// Certified distance between the drawn shapes and the exact surface, along the surface's
    /// normal at the same parameters.
    /// Units: pixels at that depth.
    double depth_bound_px = 0;

    /// The largest distance, in pixels, between an edge that may be seen and the model's faces that
    /// end at the edge (l3d_trim_curve::edge). This distance is measured, not proven. bound_px and
    /// depth_bound_px include it.
    double edges_px = 0;

    /// Certified distances between edges and the strips that close gaps beside them, in the picture
    /// and in depth. Errors of edges and of curved models add nothing to these distances. Units:
    /// pixels.
    double strips_px = 0, strips_depth_px = 0;

    /// Adds an error of `px` pixels to the bounds of all shapes but strips. The bounds of strips,
    /// strips_px and strips_depth_px, do not change.
    void add_off(double px) {
        bound_px = std::max(bound_px + px, strips_px);
        depth_bound_px = std::max(depth_bound_px + px, strips_depth_px);
    }

    /// Largest error of interpolated normals over quads and slits, against the exact unit normals
    /// at the same parameters. Only vertices that have normals count.
    /// l3d_surface_counts::normal_error holds the error that polygons' shapes add.
    double normal_off = 0;

    /// Largest error of shade levels against the exact surface at the same parameters. Units:
    /// levels of 255.
    double shade_bound = 0;
    /// Upper bound of the number of quads that shade_bound does not cover. A frame counts no quad
    /// twice.
    std::int64_t unproven_quads = 0;

    /// Adds the counts of other patches.
    void add(const l3d_dice_counts& other) {
        l3d_seen_counts::add(other);
        behind += other.behind;
        beyond += other.beyond;
        hidden += other.hidden;
        unchanged += other.unchanged;
        backfacing += other.backfacing;
        back_blocks += other.back_blocks;
        back_quads += other.back_quads;
        as_points += other.as_points;
        pieces += other.pieces;
        in_lanes += other.in_lanes;
        samples += other.samples;
        failures += other.failures;
        coarse += other.coarse;
        unfinished += other.unfinished;
        coarsest = std::max(coarsest, other.coarsest);
        near_z = std::max(near_z, other.near_z);
        bound_px = std::max(bound_px, other.bound_px);
        depth_bound_px = std::max(depth_bound_px, other.depth_bound_px);
        edges_px = std::max(edges_px, other.edges_px);
        strips_px = std::max(strips_px, other.strips_px);
        strips_depth_px = std::max(strips_depth_px, other.strips_depth_px);
        normal_off = std::max(normal_off, other.normal_off);
        shade_bound = std::max(shade_bound, other.shade_bound);
        unproven_quads += other.unproven_quads;
    }

    /// Adds the bounds of a piece of surface. `slit_depth` is the bound of depth in the slits along
    /// its sides.
    void add_surface(const l3d_surface_certificate& of, double slit_depth) {
        depth_bound_px = std::max({depth_bound_px, of.depth, slit_depth});
        normal_off = std::max(normal_off, of.normal);
        shade_bound = std::max(shade_bound, of.shade);
        unproven_quads += of.unproven_quads;
    }

    /// Adds an edge polyline of `points` points, and its certified error.
    void add_edge(std::size_t points, double bound) {
        samples += static_cast<std::int64_t>(points);
        bound_px = std::max(bound_px, bound);
    }
};

/// Switches that turn off rules by which patches or their parts are left out, to measure or judge a
/// rule. While a switch is true, its rule leaves nothing out.
struct L3D_PUBLIC l3d_culling_switches {
    /// Draws patches outside the picture.
    bool outside = false;
    /// Draws patches that cover no pixel's centre.
    bool centreless = false;
    /// Draws patches that are hidden by earlier ones.
    bool hidden = false;
    /// Draws patches and blocks that show only their back.
    bool backs = false;
    /// Dices patches that could be drawn as a point each.
    bool dicing = false;

    /// All switches are true, so that no rule leaves anything out.
    static constexpr l3d_culling_switches all() { return {true, true, true, true, true}; }

    friend bool operator==(const l3d_culling_switches&, const l3d_culling_switches&) = default;
};

#endif
