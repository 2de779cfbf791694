// SPDX-License-Identifier: MIT
// Pictures of solids against the same solids in closed form, pixel by pixel.
#ifndef L3D_TESTS_PIPELINE_SOLID_JUDGE_H
#define L3D_TESTS_PIPELINE_SOLID_JUDGE_H

#include "random_views.h"
#include "solids.h"

#include "pipeline/pipeline_afd.h"

#include <random>

/// How pictures of fronts alone differ from the exact body. A gap between fronts shows the
/// background, and not the body's inside.
struct solid_verdict {
    long pixels = 0;    ///< all
    long drawn = 0;     ///< that show the body
    long on_edges = 0;  ///< that an edge of the model goes through where it is seen
    long undecided = 0; ///< that the exact outline passes within the bound: they may show either
    // Errors; none may be.
    long uncovered = 0; ///< background, though the body covers all around within the bound
    long beyond = 0;    ///< the body, though nothing is within the bound
    long off = 0;       ///< farther from the body's surface than the bound of depth
    long behind = 0;    ///< another part of the surface than any that is seen within the bound
    // Shares of bounds.
    double worst_outline = 0; ///< how far the outline is off at most, by the bound of places
    double worst_depth = 0;   ///< how far a drawn point is off the surface, by the bound of depth
    double most_bound = 0;    ///< the largest bound without what edges are off, by the tolerance
    double most_depth_bound = 0; ///< likewise for depths
    double most_edges = 0;       ///< the most that edges are off, by the tolerance

    long errors() const { return uncovered + beyond + off + behind; }
};

/// A camera before a place of a solid's surface or, if `is_near_edge`, of an edge that it sees. At
/// zoom 1 all of the solid fills the picture.
l3d_camera view_of(const solid& of, double zoom, bool is_near_edge, std::mt19937& random);

/// Judges a frame with depth, drawn with one_sided. Each pixel is judged.
void judge_solid(const solid& of, const camera_rays& rays, const l3d_pipeline_afd& pipeline,
                 solid_verdict& sum);

#endif
