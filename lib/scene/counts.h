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

/// The counts that patches and triangles share.
struct L3D_PUBLIC l3d_seen_counts {
    std::int64_t drawn = 0;     ///< the shapes that reached the picture
    std::int64_t offscreen = 0; ///< left out: beyond one side of the window
    std::int64_t subpixel = 0;  ///< left out: its box holds no pixel centre
    std::int64_t clipped = 0;   ///< drawn shapes cut at the near plane, the far one or guard band

    /// Adds the counts of other shapes.
    void add(const l3d_seen_counts& other) {
        drawn += other.drawn;
        offscreen += other.offscreen;
        subpixel += other.subpixel;
        clipped += other.clipped;
    }
};

/// A patch of a scene, and its bound.
struct L3D_PUBLIC l3d_coarse_patch {
    double bound_px = 0; ///< the largest error of its places, in pixels
    /// The index of the instance in the scene, and of the patch in its model.
    std::int64_t instance = 0, patch = 0;

    /// Orders by bound; among equals the first in the scene is the greatest.
    friend bool operator<(const l3d_coarse_patch& a, const l3d_coarse_patch& b) {
        return std::tie(a.bound_px, b.instance, b.patch) <
               std::tie(b.bound_px, a.instance, a.patch);
    }
};

/// The proven bounds of a diced piece beside those of its points' places. Infinite where nothing is
/// proven.
struct L3D_PUBLIC l3d_surface_certificate {
    /// The distance of chords, along the exact normal at the same parameters. Units: pixels at that
    /// depth.
    double depth = 0;
    /// The distance of the level from the exact one at the same parameters. Units: levels of 255.
    double shade = 0;
    /// The error of interpolated normals against the exact unit normals at the same parameters, as
    /// a length. It is for vertices with normals instead of levels; then `shade` is 0.
    double normal = 0;
    /// Quads that `shade` does not cover, since their block may exceed the tolerance: its normals
    /// turn faster than quads of six pixels can follow, or one vanishes. Slits beside such a block
    /// count as one quad.
    std::int64_t unproven_quads = 0;
    /// Bit 4 * row + column, or bit 0, is set for a block that is seen and may have places without
    /// a normal.
    unsigned without_normals = 0;
    /// The error of depth in those blocks, without the corners' distance from a plane
    /// (l3d_most_off_plane).
    double depth_without_normals = 0;

    /// Adds the errors of vertices, and of corners of blocks without normals.
    void add_to_depth(double vertices, double off_plane) {
        depth = std::max(depth, depth_without_normals + off_plane) + vertices;
    }
};

/// The counts of a frame's dicing, and of the patches that were left out, as control nets or the
/// boxes around them prove. `clipped` counts grids.
struct L3D_PUBLIC l3d_dice_counts : l3d_seen_counts {
    std::int64_t behind = 0;      ///< patches left out: behind the near plane
    std::int64_t beyond = 0;      ///< patches left out: beyond the far plane
    std::int64_t hidden = 0;      ///< patches left out: hidden by earlier ones
    std::int64_t unchanged = 0;   ///< patches left out: beside the part that was drawn again
    std::int64_t backfacing = 0;  ///< patches left out: only their back is turned to the eye
    std::int64_t back_blocks = 0; ///< blocks left out of drawn patches, for the same reason
    std::int64_t back_quads = 0;  ///< quads of these blocks
    std::int64_t as_points = 0;   ///< patches drawn as a point each, without dicing
    std::int64_t pieces = 0;      ///< grids made; more than `drawn` if patches had to be cut
    std::int64_t in_lanes = 0;    ///< grids made by l3d_lane_dicer
    std::int64_t samples = 0;     ///< vertices evaluated
    std::int64_t failures = 0;    ///< pixels left out as an iteration did not converge
    double near_z = 0;            ///< nearest w drawn, if it is not the view's near
    double bound_px = 0;          ///< certified image error of all that was drawn
    std::int64_t coarse = 0;      ///< patches drawn with a bound above the tolerance
    std::int64_t unfinished = 0;  ///< coarse patches that a larger budget would make finer
    l3d_coarse_patch coarsest;    ///< the worst of those

    /// Certified distance of all that was drawn from the exact surface, along its normal at the
    /// same parameters. Units: pixels at that depth.
    double depth_bound_px = 0;

    /// Error of normals that are interpolated over quads and slits, against the exact unit normals
    /// at the same parameters, if vertices have normals. Polygons' shapes add to this, and are not
    /// included.
    double normal_off = 0;

    /// Error of greys against the exact surface at the same parameters. Units: levels.
    double shade_bound = 0;
    /// At most so many quads are outside the bound of shades. A frame counts none twice.
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
        normal_off = std::max(normal_off, other.normal_off);
        shade_bound = std::max(shade_bound, other.shade_bound);
        unproven_quads += other.unproven_quads;
    }

    /// Adds the bounds of a piece of surface, and of the slits along its sides.
    void add_surface(const l3d_surface_certificate& of, double slit_depth) {
        depth_bound_px = std::max({depth_bound_px, of.depth, slit_depth});
        normal_off = std::max(normal_off, of.normal);
        shade_bound = std::max(shade_bound, of.shade);
        unproven_quads += of.unproven_quads;
    }

    /// Adds an edge polyline of so many points, and its certified error.
    void add_edge(std::size_t points, double bound) {
        samples += static_cast<std::int64_t>(points);
        bound_px = std::max(bound_px, bound);
    }
};

/// Patches, and parts of them, that are drawn although a rule could leave them out, to measure or
/// judge a rule.
struct L3D_PUBLIC l3d_culling_switches {
    /// Those outside the picture.
    bool outside = false;
    /// Those that cover no pixel's centre.
    bool centreless = false;
    /// Those behind what is drawn.
    bool hidden = false;
    /// Those that show only their back.
    bool backs = false;
    /// Those that could be drawn as a point each, without dicing.
    bool dicing = false;

    /// All of them, as if there were no rule.
    static constexpr l3d_culling_switches all() { return {true, true, true, true, true}; }

    friend bool operator==(const l3d_culling_switches&, const l3d_culling_switches&) = default;
};

#endif
